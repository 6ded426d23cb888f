//! Reachable workspaces in words.

use super::{AtBounds, Differential, ReachableAnswer};
use crate::number_format::significant;

use crate::answers::Answer;
use crate::number_format::cell;
use crate::table::Table;

/// Meaning of the sizes, if any is cut.
fn cut_words(at_bounds: AtBounds) -> Option<String> {
    let (list, ends) = match at_bounds.names().as_slice() {
        [] => return None,
        [one] => (format!("the {one} workspace"), "reaches"),
        [rest @ .., last] => (format!("the {} and the {last} workspace", rest.join(", the ")), "reach"),
    };
    let them = if ends == "reaches" { "it" } else { "them" };
    let share = match at_bounds.physical && !at_bounds.reachable {
        true => "; the shares are those of the part inside",
        false => "",
    };
    Some(format!("{list} {ends} the faces of the box, so that more of {them} may lie outside{share}: see --bounds\n"))
}

impl Answer for ReachableAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let Self { control, machine, found, unit, .. } = self;
        let mut text = format!("{control} drives {machine}\n");
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}\n"));
        }
        let mut table = Table::new(["workspace", unit, "of the physical one"]);
        let percent = |size: Option<f64>| {
            let share = size.zip(found.physical.filter(|whole| *whole > 0.0)).map(|(size, whole)| 100.0 * size / whole);
            share.map_or_else(String::new, |share| format!("{share:.1} %"))
        };
        let mut row = |name: String, size: Option<f64>| {
            table.row(vec![name, cell(size, 3), percent(size)]);
        };
        row("physical: the machine is wrench-feasible".to_owned(), found.physical);
        row("model: the control model is".to_owned(), found.model);
        row("reachable, by commanded poses".to_owned(), found.reached);
        if let Some(map) = &found.compensation {
            row("the same without the map".to_owned(), map.without);
        }
        row("reachable, by emerging poses".to_owned(), found.emerging);
        if let Some(linear) = found.linear {
            row("reachable, as one linear step tells".to_owned(), Some(linear));
        }
        for (most, size) in &found.by_accuracy {
            row(format!("reachable to {} mm", significant(1e3 * most, 3)), Some(*size));
        }
        text.push_str(&format!("\n{}", table.text(width)));
        if found.linear.is_some_and(f64::is_nan) {
            text.push_str("\nwhat one linear step reaches is not star-shaped: --method grid counts it\n");
        }
        if let Some(remark) = &self.remark {
            text.push_str(&format!("\n{remark}\n"));
        }
        if let Some(bound) = self.error_bound {
            text.push_str(&format!(
                "\nthe reachable one is known to ± {bound:.3} {unit} ({} points, {})\n",
                self.points, self.method
            ));
        }
        if let Some(Differential {
            parameter, unit: of, change, size_rate, first_order_size, recomputed_size, ..
        }) = &found.differential
        {
            let anew = recomputed_size.map_or_else(|| "has no hull".to_owned(), |size| format!("is {size:.3} {unit}"));
            let of = if *of == "1" { String::new() } else { format!(" {of}") };
            text.push_str(&format!(
                "\nwith {parameter} changed by {change}{of} it is {first_order_size:.3} {unit} to first order ({size_rate:.3} {unit} per{}), found \
                 anew it {anew}\n",
                if of.is_empty() { " 1".to_owned() } else { of.clone() }
            ));
        }
        if let Some(parts) = found.parts.as_ref().filter(|parts| parts.len() > 1) {
            let small: f64 = parts[1..].iter().map(|part| part.0).sum();
            text.push_str(&format!(
                "it has {} parts that do not touch; the largest has {:.3} {unit}, the others together {small:.3} {unit}\n",
                parts.len(),
                parts[0].0
            ));
        }
        text.push_str(&cut_words(found.at_bounds).unwrap_or_default());
        text
    }
}
