//! An SVG picture, element by element; colours come from the page's style by class.

use std::fmt::Write;

use super::super::table::escape;

/// Where a text stands relative to its point.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    /// Begins there.
    Start,
    /// Is centred there.
    Middle,
    /// Ends there.
    End,
}

/// A picture under construction; coordinates in pixels from the upper left corner.
pub(super) struct Drawing {
    body: String,
    width: f64,
    height: f64,
    /// What it shows, for those who cannot see it.
    label: String,
}

impl Drawing {
    /// An empty picture.
    pub(super) fn new(width: f64, height: f64, label: &str) -> Self {
        Self { body: String::new(), width, height, label: label.to_owned() }
    }

    /// A straight line.
    pub(super) fn line(&mut self, class: &str, from: (f64, f64), to: (f64, f64)) {
        let (x1, y1, x2, y2) = (coordinate(from.0), coordinate(from.1), coordinate(to.0), coordinate(to.1));
        self.push(format_args!(r#"<line class="{class}" x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}"/>"#));
    }

    /// A disc with the text that appears when the pointer rests on it.
    pub(super) fn circle(&mut self, class: &str, centre: (f64, f64), radius: f64, title: &str) {
        let (x, y, r) = (coordinate(centre.0), coordinate(centre.1), coordinate(radius));
        let title = if title.is_empty() { String::new() } else { format!("<title>{}</title>", escape(title)) };
        self.push(format_args!(r#"<circle class="{class}" cx="{x}" cy="{y}" r="{r}">{title}</circle>"#));
    }

    /// Many discs of one colour.
    pub(super) fn discs(&mut self, fill: &str, centres: &[(f64, f64)], radius: f64) {
        let r = coordinate(radius);
        let mut group = String::new();
        for centre in centres {
            let (x, y) = (coordinate(centre.0), coordinate(centre.1));
            group.push_str(&format!(r#"<circle cx="{x}" cy="{y}" r="{r}"/>"#));
        }
        self.push(format_args!(r#"<g class="disc" fill="{fill}">{group}</g>"#));
    }

    /// A rectangle from its upper left corner.
    pub(super) fn rectangle(&mut self, class: &str, corner: (f64, f64), size: (f64, f64), fill: Option<&str>) {
        let (x, y, width, height) =
            (coordinate(corner.0), coordinate(corner.1), coordinate(size.0.max(0.0)), coordinate(size.1.max(0.0)));
        let fill = fill.map_or(String::new(), |fill| format!(r#" fill="{fill}""#));
        self.push(format_args!(r#"<rect class="{class}" x="{x}" y="{y}" width="{width}" height="{height}"{fill}/>"#));
    }

    /// Straight lines through points, closed or not.
    pub(super) fn polyline(&mut self, class: &str, points: &[(f64, f64)], closed: bool) {
        let mut path = String::new();
        for (index, point) in points.iter().enumerate() {
            let command = if index == 0 { 'M' } else { 'L' };
            path.push_str(&format!("{command}{} {}", coordinate(point.0), coordinate(point.1)));
        }
        if closed {
            path.push('Z');
        }
        self.push(format_args!(r#"<path class="{class}" d="{path}"/>"#));
    }

    /// A text.
    pub(super) fn text(&mut self, class: &str, anchor: Anchor, at: (f64, f64), text: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let (x, y, text) = (coordinate(at.0), coordinate(at.1), escape(text));
        self.push(format_args!(r#"<text class="{class}" text-anchor="{anchor}" x="{x}" y="{y}">{text}</text>"#));
    }

    /// A text turned to run upwards, centred on a point.
    pub(super) fn upright_text(&mut self, at: (f64, f64), text: &str) {
        let (x, y, text) = (coordinate(at.0), coordinate(at.1), escape(text));
        self.push(format_args!(
            r#"<text class="label" text-anchor="middle" transform="translate({x} {y}) rotate(-90)">{text}</text>"#
        ));
    }

    fn push(&mut self, element: std::fmt::Arguments<'_>) {
        // writing to a string cannot fail
        let _ = writeln!(self.body, "{element}");
    }

    /// The element.
    pub(super) fn finish(self) -> String {
        let Self { body, width, height, label } = self;
        let label = escape(&label);
        format!(
            "<svg role=\"img\" aria-label=\"{label}\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\">\n{body}</svg>"
        )
    }
}

/// A tenth of a pixel is as exact as the eye.
fn coordinate(value: f64) -> String {
    let text = format!("{value:.1}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}
