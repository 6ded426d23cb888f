//! Scales of colours that the colour-blind can read, the same as those of pages in daylight (`viewer/src/style.css`).

/// Colours from small to large: light to dark.
const STEPS: [&str; 6] = ["#d3e3f0", "#8fc0dd", "#4a98c4", "#2a6ca3", "#4b3f8f", "#3a0f4f"];

/// Number of colours.
pub(super) const COUNT: usize = STEPS.len();

/// Colours from −1 to 1: orange over nearly white to blue.
const DIVERGING: [&str; 9] =
    ["#8c3100", "#c2702f", "#e3ae7d", "#f4ddc8", "#f1f3f5", "#cfe2f1", "#8dbadc", "#3f86bd", "#00477d"];

/// Values between the colours of the diverging scale.
const LIMITS: [f64; 8] = [-0.95, -0.7, -0.4, -0.1, 0.1, 0.4, 0.7, 0.95];

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
            let name = if place < 4 { format!("n{}", 4 - place) } else { (place - 4).to_string() };
            assert_eq!(colour(&format!("diverging-{name}")), *own);
        }
        let chart = std::fs::read_to_string(viewer.join("charts/correlation.ts")).unwrap();
        let limits = LIMITS.map(|limit| limit.to_string()).join(", ");
        assert!(chart.contains(&format!("const LIMITS = [{limits}];")), "{limits}");
    }

    #[test]
    fn larger_values_have_later_colours() {
        assert_eq!([0.0, 0.99, 1.0, 5.9, 6.0, 7.0].map(|value| step_of(value, 6.0)), [0, 0, 1, 5, 5, 5]);
        assert_eq!([-1.0, 0.0, 1.0].map(diverging), ["#8c3100", "#f1f3f5", "#00477d"]);
    }
}
