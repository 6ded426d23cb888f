//! A drawing, element by element.

use std::fmt::Write;

use super::figure::Figure;
use super::markup::{coordinate, escape};

/// Height of a line of a title or legend (pixels).
pub(super) const LINE: f64 = 18.0;
/// Width of a bold letter, on average (pixels).
const LETTER: f64 = 7.2;

/// How wide the longest line of a title is (pixels).
pub(super) fn title_width(lines: &[String]) -> f64 {
    lines.iter().map(|line| LETTER * line.chars().count() as f64).fold(0.0, f64::max)
}

/// Anchor of a text relative to its point.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    /// Begins there.
    Start,
    /// Is centred there.
    Middle,
    /// Ends there.
    End,
}

impl Anchor {
    fn word(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Middle => "middle",
            Self::End => "end",
        }
    }
}

/// Corner, and width and height.
pub(super) type Rectangle = ((f64, f64), (f64, f64));

/// A picture under construction; coordinates in pixels from the upper left corner.
pub(super) struct Drawing {
    body: String,
    width: f64,
    height: f64,
    /// Description for those who cannot see it.
    label: String,
    /// Looks that only this kind of picture has.
    own_style: &'static str,
    /// Attributes for the script of a page.
    attributes: String,
}

impl Drawing {
    /// An empty picture.
    pub(super) fn new(width: f64, height: f64, label: &str) -> Self {
        Self { body: String::new(), width, height, label: label.to_owned(), own_style: "", attributes: String::new() }
    }

    /// The same with looks of its own (CSS) beside those of all pictures.
    pub(super) fn with_style(self, own_style: &'static str) -> Self {
        Self { own_style, ..self }
    }

    /// The same with a number or numbers for the script of a page.
    pub(super) fn with_attribute(mut self, name: &str, value: &str) -> Self {
        self.attributes.push_str(&format!(r#" data-{name}="{}""#, escape(value)));
        self
    }

    /// Many rectangles of one colour: corner, width and height.
    pub(super) fn rectangles(&mut self, class: &str, fill: &str, all: &[Rectangle]) {
        let path = all.iter().map(|&((x, y), (width, height))| {
            let (x, y, width, height) = (coordinate(x), coordinate(y), coordinate(width), coordinate(height));
            format!("M{x} {y}h{width}v{height}h-{width}z")
        });
        let path: String = path.collect();
        self.push(format_args!(r#"<path class="{class}" fill="{fill}" d="{path}"/>"#));
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
        let (x, y, text, anchor) = (coordinate(at.0), coordinate(at.1), escape(text), anchor.word());
        self.push(format_args!(r#"<text class="{class}" text-anchor="{anchor}" x="{x}" y="{y}">{text}</text>"#));
    }

    /// Lines of text from the upper edge down, the first one in bold.
    pub(super) fn title(&mut self, left: f64, lines: &[String]) {
        for (line, text) in lines.iter().enumerate() {
            let class = if line == 0 { "panel" } else { "tick" };
            self.text(class, Anchor::Start, (left, 16.0 + LINE * line as f64), text);
        }
    }

    /// A text turned to run upwards, centred on a point.
    pub(super) fn upright_text(&mut self, at: (f64, f64), text: &str) {
        let (x, y, text) = (coordinate(at.0), coordinate(at.1), escape(text));
        self.push(format_args!(
            r#"<text class="label" text-anchor="middle" transform="translate({x} {y}) rotate(-90)">{text}</text>"#
        ));
    }

    /// A text of a size (pixels).
    pub(super) fn small_text(&mut self, anchor: Anchor, at: (f64, f64), size: f64, text: &str) {
        let (x, y, size, text, anchor) =
            (coordinate(at.0), coordinate(at.1), coordinate(size), escape(text), anchor.word());
        self.push(format_args!(
            r#"<text style="font-size:{size}px" text-anchor="{anchor}" x="{x}" y="{y}">{text}</text>"#
        ));
    }

    /// The same, running upwards to a point.
    pub(super) fn small_upright_text(&mut self, at: (f64, f64), size: f64, text: &str) {
        let (x, y, size, text) = (coordinate(at.0), coordinate(at.1), coordinate(size), escape(text));
        self.push(format_args!(
            r#"<text style="font-size:{size}px" text-anchor="end" transform="translate({x} {y}) rotate(-90)">{text}</text>"#
        ));
    }

    fn push(&mut self, element: std::fmt::Arguments<'_>) {
        // writing to a string cannot fail
        let _ = writeln!(self.body, "{element}");
    }

    /// The figure.
    pub(super) fn finish(self) -> Figure {
        let Self { body, width, height, label, own_style, attributes } = self;
        Figure { body, width, height, label, own_style, attributes }
    }
}
