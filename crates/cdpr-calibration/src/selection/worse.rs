//! Errors that grew from one model to another, beside those that fell.

use super::SelectionCriterion;
use crate::evaluation::ErrorBlocks;

/// Share by which an error has to grow to be told.
const GROWTH: f64 = 0.1;

/// Errors below this are rounding (m, rad, N).
const ROUNDING: f64 = 1e-9;

/// An error figure for people: its name, the criterion that has its unit, and where it stands.
type Figure = (&'static str, SelectionCriterion, fn(&ErrorBlocks) -> f64);

const FIGURES: [Figure; 8] = [
    ("mean position error", SelectionCriterion::Position, |errors| errors.position_error_m.mean),
    ("largest position error", SelectionCriterion::Position, |errors| errors.position_error_m.max),
    ("mean rotation error", SelectionCriterion::Rotation, |errors| errors.rotation_error_rad.mean),
    ("largest rotation error", SelectionCriterion::Rotation, |errors| errors.rotation_error_rad.max),
    ("mean cable-length error", SelectionCriterion::Length, |errors| errors.length_error_m.mean_abs),
    ("largest cable-length error", SelectionCriterion::Length, |errors| errors.length_error_m.max),
    ("mean tension error (2-norm over cables)", SelectionCriterion::Tension, |errors| {
        errors.tension_error.map_or(f64::NAN, |error| error.mean_norm)
    }),
    ("largest tension error", SelectionCriterion::Tension, |errors| {
        errors.tension_error.map_or(f64::NAN, |error| error.max)
    }),
];

/// Errors on validation data that are more than a tenth larger than before, in words: "largest rotation error 17.6°, 6.8° before".
pub(super) fn worse(before: &ErrorBlocks, after: &ErrorBlocks) -> Vec<String> {
    let grown = FIGURES.iter().filter_map(|(name, kind, read)| {
        let (before, after) = (read(before), read(after));
        let is_worse = after > (1.0 + GROWTH) * before && after > ROUNDING;
        is_worse.then(|| format!("{name} {}, {} before", kind.format(after), kind.format(before)))
    });
    grown.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::Evaluation;

    #[test]
    fn an_error_that_grew_by_more_than_a_tenth_is_told_with_both_values() {
        let errors = |rotation: [f64; 2]| {
            let position = vec![0.01, 0.02];
            let evaluation = Evaluation { position, rotation: rotation.to_vec(), ..Evaluation::default() };
            evaluation.blocks()
        };
        let degrees = |degrees: f64| degrees.to_radians();
        let before = errors([degrees(1.0), degrees(6.8)]);
        let told = worse(&before, &errors([degrees(0.1), degrees(7.6)]));
        assert_eq!(told, ["largest rotation error 7.60°, 6.80° before"]);
        assert_eq!(worse(&before, &errors([degrees(1.05), degrees(7.4)])), Vec::<String>::new());
    }
}
