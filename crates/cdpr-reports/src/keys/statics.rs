//! Tensions, displacements, maps and elements of a robot at a pose.

use cdpr_calibration::ErrorBlocks;
use cdpr_calibration::compensation::Judged;
use cdpr_model::compensation::{Beyond, Extent};
use cdpr_model::tension::quadratic::Certificate;
use cdpr_study::effects::{Displacement, DisplacementMethod};
use serde::Serialize;

use super::adapters::tables;
use super::{BeyondKeys, ErrorBlockKeys, Word};

/// Direction in which the load asks for more than the cables can give.
#[derive(Serialize)]
#[serde(remote = "Certificate")]
pub(crate) struct InfeasibilityKeys {
    direction: Vec<f64>,
    weights: Vec<f64>,
    #[serde(rename = "required_N")]
    required: f64,
    #[serde(rename = "reachable_N")]
    reachable: f64,
}

/// Displacement of the platform and change of the tensions.
#[derive(Serialize)]
#[serde(remote = "Displacement")]
pub(crate) struct DisplacementKeys {
    #[serde(rename = "translation_m")]
    translation: f64,
    #[serde(rename = "rotation_rad")]
    rotation: f64,
    #[serde(rename = "tension_change_N")]
    tension: Option<f64>,
    #[serde(rename = "slack_cables")]
    slack: usize,
    #[serde(with = "Word")]
    method: DisplacementMethod,
}

/// Range of the samples of a map along one coordinate, in its `unit`.
#[derive(Serialize)]
#[serde(remote = "Extent")]
pub(crate) struct ExtentKeys {
    axis: &'static str,
    unit: &'static str,
    ends: [f64; 2],
    margin: f64,
}

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

tables!(
    InfeasibilityKeys: Certificate,
    DisplacementKeys: Displacement,
    ExtentKeys: Extent,
);
