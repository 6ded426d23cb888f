//! Scales of colours that the colour-blind can read, the same as those of pages in daylight (`viewer/src/style.css`).

/// Colours from small to large: light to dark.
const STEPS: [&str; 6] = ["#d3e3f0", "#8fc0dd", "#4a98c4", "#2a6ca3", "#4b3f8f", "#3a0f4f"];

/// Number of colours.
pub(super) const COUNT: usize = STEPS.len();

/// Colours from −1 to 1: orange over nearly white to blue.
pub(super) const DIVERGING: [&str; 9] =
    ["#8c3100", "#c2702f", "#e3ae7d", "#f4ddc8", "#f1f3f5", "#cfe2f1", "#8dbadc", "#3f86bd", "#00477d"];

/// Values between the colours of the diverging scale.
const LIMITS: [f64; 8] = [-0.95, -0.7, -0.4, -0.1, 0.1, 0.4, 0.7, 0.95];

/// Colours of lines and letters, and their names in pages.
const INKS: [(&str, &str); 8] = [
    ("#1b1f24", "ink"),
    ("#57606a", "muted"),
    ("#d0d7de", "line"),
    ("#ffffff", "paper"),
    ("#005a9c", "accent"),
    ("#e3f0fb", "accent-shade"),
    ("#a83c00", "bad"),
    ("#8c8c8c", "muted"),
];

/// Colours of cables, in turn.
pub(super) const CABLES: [&str; 8] =
    ["#2f7fc1", "#e08a1e", "#2a9d6f", "#b8478f", "#8a6d1f", "#5fb6d9", "#7a5cc7", "#c9503c"];

/// Name of a place in the diverging scale, from 0, as pages call it.
fn diverging_name(place: usize) -> String {
    if place < 4 { format!("diverging-n{}", 4 - place) } else { format!("diverging-{}", place - 4) }
}

/// True of a correlation of the darkest colours.
pub(super) fn is_strong(value: f64) -> bool {
    value.abs() >= LIMITS[LIMITS.len() - 1]
}

/// The text of a drawing or a style with the variables of a page in place of colours.
pub(super) fn of_page(text: &str) -> String {
    let steps = STEPS.iter().enumerate().map(|(step, colour)| (*colour, format!("step-{}", step + 1)));
    let diverging = DIVERGING.iter().enumerate().map(|(place, colour)| (*colour, diverging_name(place)));
    let inks = INKS.iter().map(|(colour, name)| (*colour, (*name).to_owned()));
    let cables = CABLES.iter().enumerate().map(|(cable, colour)| (*colour, format!("cable-{}", cable + 1)));
    let all = inks.chain(steps).chain(diverging).chain(cables);
    all.fold(text.to_owned(), |text, (colour, name)| text.replace(colour, &format!("var(--{name})")))
}

/// Colour of a share of the whole, from 0 to 1, between those of the steps, as `#rrggbb`.
pub fn at(share: f64) -> String {
    let place = share.clamp(0.0, 1.0) * (COUNT - 1) as f64;
    let below = (place as usize).min(COUNT - 2);
    let channel =
        |colour: &str, which: usize| u8::from_str_radix(&colour[1 + 2 * which..3 + 2 * which], 16).unwrap_or(0);
    let mixed = |which: usize| {
        let [from, to] = [STEPS[below], STEPS[below + 1]].map(|colour| f64::from(channel(colour, which)));
        (from + (place - below as f64) * (to - from)).round() as u8
    };
    format!("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2))
}

/// Colour of a step as `#rrggbb`.
pub(super) fn of_step(step: usize) -> &'static str {
    STEPS[step.min(COUNT - 1)]
}

/// Step of a value between 0 and `top`.
pub(super) fn step_of(value: f64, top: f64) -> usize {
    ((value / top * COUNT as f64) as usize).min(COUNT - 1)
}

/// Colour of a value from −1 to 1 as `#rrggbb`.
pub(super) fn diverging(value: f64) -> &'static str {
    DIVERGING[LIMITS.iter().filter(|limit| value >= **limit).count()]
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    /// Small errors are light and large ones dark, negative correlations orange and positive ones blue, on paper as on the screen.
    #[test]
    fn figures_have_the_colours_of_pages_in_daylight() {
        let viewer = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../viewer/src");
        let style = std::fs::read_to_string(viewer.join("style.css")).unwrap();
        let colour = |name: &str| style.split_once(&format!("--{name}: ")).unwrap().1.split_once(';').unwrap().0;
        for (step, own) in STEPS.iter().enumerate() {
            assert_eq!(colour(&format!("step-{}", step + 1)), *own);
        }
        for (place, own) in DIVERGING.iter().enumerate() {
            assert_eq!(colour(&diverging_name(place)), *own);
        }
        for (cable, own) in CABLES.iter().enumerate() {
            assert_eq!(colour(&format!("cable-{}", cable + 1)), *own);
        }
        for (own, name) in &INKS[..7] {
            assert_eq!(colour(name), *own);
        }
    }

    #[test]
    fn colours_between_steps_are_mixed_and_those_of_steps_are_their_own() {
        let shares = [0.0, 0.2, 0.4, 0.6, 0.8, 1.0];
        assert_eq!(shares.map(at), STEPS.map(str::to_owned));
        assert_eq!(at(0.1), "#b1d2e7", "half way from #d3e3f0 to #8fc0dd");
    }

    #[test]
    fn larger_values_have_later_colours() {
        assert_eq!([0.0, 0.99, 1.0, 5.9, 6.0, 7.0].map(|value| step_of(value, 6.0)), [0, 0, 1, 5, 5, 5]);
        assert_eq!([-1.0, 0.0, 1.0].map(diverging), ["#8c3100", "#f1f3f5", "#00477d"]);
    }
}
