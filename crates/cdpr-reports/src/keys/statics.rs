//! Tensions, displacements, maps and elements of a robot at a pose.

use cdpr_calibration::ErrorBlocks;
use cdpr_calibration::compensation::Judged;
use cdpr_model::compensation::{Beyond, Extent};
use cdpr_model::reading::Keyword;
use cdpr_model::tension::quadratic::Certificate;
use cdpr_study::effects::Displacement;
use serde::Serialize;

use super::adapters::keys;
use super::{BeyondKeys, ErrorBlockKeys};

/// Errors without a map and with maps of the other samples.
#[derive(Serialize)]
#[serde(remote = "Judged")]
pub(crate) struct JudgedMapKeys {
    samples: usize,
    #[serde(flatten, with = "BeyondKeys")]
    beyond: Beyond,
    #[serde(with = "ErrorBlockKeys")]
    without: ErrorBlocks,
    #[serde(with = "ErrorBlockKeys")]
    with: ErrorBlocks,
    gain_m2: f64,
    gain_standard_error_m2: f64,
}

keys! {
    /// Direction in which the load asks for more than the cables can give.
    InfeasibilityKeys of Certificate { direction, weights, required = "required_N", reachable = "reachable_N" }
    /// Displacement of the platform and change of the tensions.
    DisplacementKeys of Displacement {
        translation = "translation_m", rotation = "rotation_rad", tension = "tension_change_N",
        slack = "slack_cables", method.name(),
    }
    /// Range of the samples of a map along one coordinate, in its `unit`.
    ExtentKeys of Extent { axis, unit, ends, margin }
}
