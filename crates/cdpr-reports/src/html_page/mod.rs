//! Frame that all pages have in common: one HTML file with style, data and program in it; nothing comes from the
//! network.
//!
//! Program and style are made from `viewer/` and committed in `html_page/generated`.

mod kind;
mod nodes;
mod picture;
#[cfg(test)]
pub(crate) mod reading;
#[cfg(test)]
mod stamp;
mod text;

use minijinja::{Environment, Error, UndefinedBehavior, Value, context};
use serde::Serialize;
use thiserror::Error as ThisError;

pub(crate) use kind::PageKind;
pub(crate) use nodes::{Nodes, nodes};
pub(crate) use picture::{PosePicture, RobotPicture, quaternion, vector};
pub(crate) use text::{breakable, plain, prose};

const FRAME: &str = include_str!("frame.html");
/// Warnings, and the command that makes the page again: `warnings`, `command` and, where there is one, `seed`.
const CLOSING: &str = include_str!("closing.html");
/// At the top: where the warnings are.
const WARNED: &str = include_str!("warned.html");
const STYLE: &str = include_str!("generated/viewer.css");
const SCRIPT: &str = include_str!("generated/viewer.js");
const NOTICES: &str = include_str!("generated/notices.txt");

/// A page that could not be put together.
#[derive(Debug, ThisError)]
#[error(transparent)]
pub struct PageError(#[from] Error);

/// A page.
pub(crate) struct Page<'a> {
    /// Kind of the page.
    pub(crate) kind: PageKind,
    /// Title of the window.
    pub(crate) title: &'a str,
    /// Class of the body; empty for none.
    pub(crate) class: &'a str,
    /// Template of what stands between head and footer; `closing` and `warned` are known to it where `values` has `warnings`.
    pub(crate) template: &'static str,
    /// The template's values; `title` and `version` are known to it besides.
    pub(crate) values: Value,
    /// The block that the program draws from, JSON of [`data_block`]; `None` for a page that comes drawn.
    pub(crate) data: Option<String>,
    /// Version of the program.
    pub(crate) version: &'a str,
}

impl Page<'_> {
    /// Text of the file.
    pub(crate) fn render(self) -> Result<String, PageError> {
        Ok(self.put_together()?)
    }

    fn put_together(self) -> Result<String, Error> {
        let mut environment = Environment::new();
        environment.set_undefined_behavior(UndefinedBehavior::Strict);
        environment.add_template("body.html", self.template)?;
        environment.add_template("frame.html", FRAME)?;
        environment.add_template("closing.html", CLOSING)?;
        environment.add_template("warned.html", WARNED)?;
        let (title, version) = (plain(self.title), plain(self.version));
        let own = context! { title, version };
        let known = context! { ..self.values, ..own.clone() };
        let part = |name: &str| -> Result<Value, Error> {
            Ok(Value::from_safe_string(environment.get_template(name)?.render(&known)?))
        };
        // a page that tells its warnings itself has no list at its end
        let closing = match known.get_attr("warnings")?.is_undefined() {
            true => context! {},
            false => context! { closing => part("closing.html")?, warned => part("warned.html")? },
        };
        let body = environment.get_template("body.html")?.render(context! { ..closing, ..known.clone() })?;
        environment.get_template("frame.html")?.render(context! {
            style => Value::from_safe_string(format!("{STYLE}{}", crate::figures::page_style())),
            script => Value::from_safe_string(SCRIPT.to_owned()),
            notices => NOTICES,
            data => self.data.map(Value::from_safe_string),
            kind => self.kind.name(),
            body => Value::from_safe_string(body),
            class => self.class,
            ..own
        })
    }
}

/// Data block of a page as text that may stand inside a `script` element.
pub(crate) fn data_block(data: &impl Serialize) -> String {
    inside_script(&plain(&serde_json::to_string(data).expect("strings and numbers only")))
}

/// The same JSON without the characters that could end the element or start markup.
fn inside_script(json: &str) -> String {
    json.replace('<', "\\u003c")
        .replace('>', "\\u003e")
        .replace('&', "\\u0026")
        .replace('\u{2028}', "\\u2028")
        .replace('\u{2029}', "\\u2029")
}

/// The number with so many significant digits: more would only make the page longer. NaN where it is not finite.
pub(crate) fn digits(value: f64, count: usize) -> f64 {
    if !value.is_finite() {
        return f64::NAN;
    }
    format!("{value:.*e}", count - 1).parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_inside_the_script_element_cannot_end_it_and_stays_the_same_text() {
        let name = "</script><!-- & \u{2028}";
        let text = inside_script(&serde_json::to_string(name).unwrap());
        assert!(!text.contains('<') && !text.contains('>') && !text.contains('\u{2028}'));
        assert_eq!(serde_json::from_str::<String>(&text).unwrap(), name);
    }

    #[test]
    fn numbers_keep_the_digits_that_charts_can_show() {
        assert_eq!([digits(0.001_234_567, 4), digits(-12.345_678, 6), digits(0.0, 4)], [0.001235, -12.3457, 0.0]);
        assert!(digits(f64::INFINITY, 4).is_nan(), "JSON has no infinity");
    }
}
