//! Looks of the figures of a page.

use super::figure::STYLE;
use super::{colour, correlations, penalty_path, timeline, tracking};

/// Looks of figures in pages, whose colours are variables of the page (CSS).
pub fn page_style() -> String {
    let rules = STYLE
        .lines()
        .chain(correlations::STYLE.lines())
        .chain(tracking::STYLE.lines())
        .chain(penalty_path::STYLE.lines())
        .chain(timeline::STYLE.lines())
        .map(|rule| colour::of_page(&format!(".figure {rule}\n")));
    // curves in tones that pages do not have stand in none
    rules.filter(|rule| !(rule.contains(".tone-") && rule.contains('#'))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A page in dark colours would show a colour of its own as it is on white paper.
    #[test]
    fn no_colour_of_a_figure_is_left_in_a_page() {
        let style = page_style();
        assert!(!style.contains('#'), "{style}");
        assert!(style.lines().all(|rule| rule.starts_with(".figure ") && rule.ends_with('}')), "a rule in a line");
        let names = ["a", "b"].map(str::to_owned);
        let figure = super::super::correlations(&names, &[vec![1.0], vec![f64::NAN, 1.0]]).unwrap();
        assert!(!figure.inline().contains("=\"#"), "{}", figure.inline());
        assert!(figure.file().contains("fill=\"#00477d\"") && figure.inline().contains("fill=\"var(--diverging-4)\""));
    }
}
