//! Errors that can decide between candidates.

use std::fmt;

use serde::Deserialize;

use crate::evaluation::{ErrorBlocks, Evaluation};
use cdpr_model::measurement::decimals;
use cdpr_model::reading::keywords;

/// Which error decides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SelectionCriterion {
    /// Mean position error (m, eq. 3.4).
    #[default]
    Position,
    /// Mean rotation error (rad).
    Rotation,
    /// Mean over samples of the mean length error of the cables (m).
    Length,
    /// Mean over samples of the 2-norm of the tension errors (N); only models that know tensions have it.
    Tension,
}

keywords!(SelectionCriterion: Position = "position", Rotation = "rotation", Length = "length", Tension = "tension");

impl fmt::Display for SelectionCriterion {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Position => "mean position error",
            Self::Rotation => "mean rotation error",
            Self::Length => "mean cable-length error",
            Self::Tension => "mean tension error (2-norm over cables)",
        })
    }
}

impl SelectionCriterion {
    /// Unit for people.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Rotation => "°",
            Self::Position | Self::Length => "mm",
            Self::Tension => "N",
        }
    }

    /// Name of the error figure that [`Requirement`](super::Requirement) limits, without its unit.
    pub fn metric(self) -> &'static str {
        match self {
            Self::Position => "position_mean",
            Self::Rotation => "rotation_mean",
            Self::Length => "length_mean_abs",
            Self::Tension => "tension_mean_norm",
        }
    }

    /// A value (SI) in the unit for people.
    pub fn in_unit(self, value: f64) -> f64 {
        match self {
            Self::Rotation => value.to_degrees(),
            Self::Position | Self::Length => 1e3 * value,
            Self::Tension => value,
        }
    }

    /// The criterion out of error blocks (SI); NaN for a model that has none.
    pub fn of_blocks(self, blocks: &ErrorBlocks) -> f64 {
        match self {
            Self::Position => blocks.position_error_m.mean,
            Self::Rotation => blocks.rotation_error_rad.mean,
            Self::Length => blocks.length_error_m.mean_abs,
            Self::Tension => blocks.tension_error.map_or(f64::NAN, |error| error.mean_norm),
        }
    }

    /// Quantity that a model predicts for a sample that has this error.
    pub(super) fn quantity(self) -> &'static str {
        match self {
            Self::Position | Self::Rotation => "pose",
            Self::Length => "length of every cable",
            Self::Tension => "tension of every cable",
        }
    }

    /// A value for people, with three significant digits: mm, degrees or N; "no value" where it is none.
    pub(crate) fn format(self, value: f64) -> String {
        let shown = self.in_unit(value);
        self.to_decimals(value, decimals(2.0, shown))
    }

    /// A value to the digits that its standard error (SI) allows: two of the error; three significant ones where it is not known.
    pub(crate) fn format_within(self, value: f64, standard_error: f64) -> String {
        let error = self.in_unit(standard_error);
        match error.is_finite() && error > 0.0 {
            true => self.to_decimals(value, decimals(1.0, error)),
            false => self.format(value),
        }
    }

    /// The same with the standard error behind it.
    pub fn format_with_error(self, value: f64, standard_error: f64) -> String {
        let error = self.in_unit(standard_error);
        let text = self.format_within(value, standard_error);
        match value.is_finite() && error.is_finite() && error > 0.0 {
            true => format!(
                "{} ± {}",
                text.trim_end_matches(self.mark()),
                self.format_within(standard_error, standard_error)
            ),
            false => text,
        }
    }

    fn to_decimals(self, value: f64, decimals: usize) -> String {
        match self.in_unit(value) {
            value if value.is_nan() => "no value".to_owned(),
            value => format!("{value:.decimals$}{}", self.mark()),
        }
    }

    /// The unit as it stands behind a number.
    fn mark(self) -> &'static str {
        match self {
            Self::Rotation => "°",
            Self::Position | Self::Length => " mm",
            Self::Tension => " N",
        }
    }

    /// The error of each sample.
    pub(crate) fn of(self, evaluation: &Evaluation) -> Vec<f64> {
        match self {
            Self::Position => evaluation.position.clone(),
            Self::Rotation => evaluation.rotation.clone(),
            Self::Length => {
                let mean = |errors: &[f64]| errors.iter().map(|x| x.abs()).sum::<f64>() / errors.len() as f64;
                evaluation.length.chunks(evaluation.cable_count.max(1)).map(mean).collect()
            }
            Self::Tension => (0..evaluation.len()).map(|sample| evaluation.tension_norm_of(sample)).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::SelectionCriterion::{Position, Rotation, Tension};

    #[test]
    fn a_value_has_no_finer_digits_than_its_standard_error() {
        assert_eq!(Position.format_with_error(0.002_117, 0.000_198), "2.12 ± 0.20 mm");
        assert_eq!(Position.format_with_error(0.507_892, 0.040_796), "508 ± 41 mm");
        assert_eq!(Position.format_within(0.002_312, 0.000_195), "2.31 mm");
        assert_eq!(Rotation.format_with_error(0.1_f64.to_radians(), 0.012_f64.to_radians()), "0.100 ± 0.012°");
        assert_eq!(Position.format_with_error(0.002_117, f64::NAN), "2.12 mm");
        assert_eq!((Tension.format(1234.5), Position.format(f64::NAN)), ("1234 N".to_owned(), "no value".to_owned()));
    }
}
