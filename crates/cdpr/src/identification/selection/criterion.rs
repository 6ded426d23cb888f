//! Errors that can decide between candidates.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::identification::evaluation::{ErrorBlocks, Evaluation};

/// Which error decides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
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

    /// A value for people: mm, degrees or N; "no value" where it is none.
    pub fn format(self, value: f64) -> String {
        let value = self.in_unit(value);
        if value.is_nan() {
            return "no value".to_owned();
        }
        match self {
            Self::Rotation => format!("{value:.4}°"),
            Self::Position | Self::Length => format!("{value:.3} mm"),
            Self::Tension => format!("{value:.1} N"),
        }
    }

    /// The error of each sample.
    pub(super) fn of(self, evaluation: &Evaluation) -> Vec<f64> {
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
