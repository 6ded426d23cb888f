//! Numbers of a saved result, and files of figures made of them.

use cdpr_calibration::selection::SelectionCriterion;
use serde::Deserialize;
use serde_json::Value;

/// Letters of the world's axes.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// A drawing or a table of a result, or the reason why there is none.
pub struct FigureFile {
    /// Name of the file.
    pub name: &'static str,
    /// Its text.
    pub content: Option<String>,
    /// Reason why there is none, in words.
    pub why_not: &'static str,
}

/// Numbers of a result that figures show.
pub struct SavedResult {
    pub(super) criterion: SelectionCriterion,
    /// The candidates, from simple to complex; empty for an identification.
    pub(super) candidates: Vec<CandidateData>,
    /// Name of the robot.
    pub robot: Option<String>,
    pub(super) recommended: Option<String>,
    /// Name of the candidate that all other figures are about.
    pub shown: Option<String>,
    pub(super) rank: usize,
    pub(super) parameters: Vec<ParameterData>,
    pub(super) singular_values: Vec<f64>,
    pub(super) convergence: Vec<f64>,
    /// Names and rows of the matrix.
    pub(super) correlations: Option<(Vec<String>, Vec<Vec<f64>>)>,
    pub(super) samples: Vec<SampleData>,
    /// Axes of positions, as indices of world coordinates: of a planar robot those of its plane.
    pub(super) axes: Vec<usize>,
    /// Names of the cables, as figures show them.
    pub(super) cables: Vec<String>,
}

/// One candidate of `result.json`.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct CandidateData {
    pub(super) name: String,
    pub(super) model: String,
    pub(super) free: String,
    pub(super) parameter_count: Option<usize>,
    #[serde(default)]
    pub(super) train: Value,
    pub(super) criterion: Option<f64>,
    pub(super) standard_error: Option<f64>,
    pub(super) compared: Option<ComparedData>,
    pub(super) rank: Option<usize>,
    pub(super) condition: Option<f64>,
    pub(super) failure: Option<String>,
}

/// Error by which a candidate is compared with the best (SI).
#[derive(Clone, Debug, Deserialize)]
pub(super) struct ComparedData {
    pub(super) by: String,
    pub(super) mean: Option<f64>,
    pub(super) difference: Option<f64>,
    pub(super) difference_standard_error: Option<f64>,
    pub(super) as_good_within: Option<f64>,
    pub(super) as_good_as_best: bool,
}

/// One identified parameter.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct ParameterData {
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) start: Option<f64>,
    pub(super) value: Option<f64>,
    pub(super) sigma: Option<f64>,
    pub(super) prior_sigma: Option<f64>,
    pub(super) at_bound: bool,
}

/// Errors at one validation sample (SI); NaN where they are not known.
pub(super) struct SampleData {
    /// Number in the data, from 1.
    pub(super) sample: usize,
    /// Measured position (world, m); 0 along an axis that a planar robot does not have.
    pub(super) position: [f64; 3],
    pub(super) position_error: f64,
    pub(super) position_vector: [f64; 3],
    pub(super) rotation_error: f64,
    /// Modelled minus recorded, per cable (m).
    pub(super) lengths: Vec<f64>,
}
