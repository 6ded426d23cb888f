//! A finished figure: as a file of its own, and as a part of a page.

use super::colour;
use super::markup::{coordinate, escape};

/// Width of the text of a page of A4 (mm).
const PAGE_WIDTH: f64 = 180.0;

/// A pixel on paper: letters of 12 pixels are 7 points high.
const MILLIMETRES_PER_PIXEL: f64 = 0.21;

/// A figure in a narrow window is no narrower than this: it scrolls (pixels).
const LEAST_WIDTH: f64 = 540.0;

/// Looks of all figures; a rule stands in one line.
pub(super) const STYLE: &str = include_str!("figures.css");

/// One drawing. Its file and its part of a page have the same shapes, texts and places, and differ in colours by the page alone, which is light
/// or dark.
#[derive(Clone, Debug)]
pub struct Figure {
    pub(super) body: String,
    pub(super) width: f64,
    pub(super) height: f64,
    /// Contents in words, for those who cannot see it.
    pub(super) label: String,
    /// Looks that only this kind of figure has.
    pub(super) own_style: &'static str,
    /// Attributes for the script of a page, in front of each a space.
    pub(super) attributes: String,
}

impl Figure {
    /// An SVG file that stands alone, black on white, sized for a page of A4.
    pub fn file(&self) -> String {
        let Self { body, width, height, own_style, .. } = self;
        let label = escape(&self.label);
        // as wide as the text of a page of A4 unless that would blow it up
        let millimetres = (width * MILLIMETRES_PER_PIXEL).min(PAGE_WIDTH);
        let (wide, tall) = (coordinate(millimetres), coordinate(millimetres * height / width));
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" \
             viewBox=\"0 0 {width} {height}\" width=\"{wide}mm\" height=\"{tall}mm\">\n<title>{label}</title>\n\
             <style>\n{STYLE}{own_style}</style>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{body}</svg>\n"
        )
    }

    /// An element of a page whose style has [`super::page_style`]; at most as wide as the drawing, and never too narrow to read.
    pub fn inline(&self) -> String {
        let Self { width, height, attributes, .. } = self;
        let (label, body) = (escape(&self.label), colour::of_page(&self.body));
        let least = width.min(LEAST_WIDTH);
        format!(
            "<svg class=\"figure\" role=\"img\" aria-label=\"{label}\" viewBox=\"0 0 {width} {height}\" \
             style=\"min-width:{least}px;max-width:{width}px\"{attributes}>\n{body}</svg>"
        )
    }
}
