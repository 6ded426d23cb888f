//! Errors that a publication prints of its own machine.

use serde::Deserialize;

/// The stages of the chain in their order.
pub(crate) const STAGES: [&str; 13] = [
    "reference",
    "identified",
    "driven",
    "identified-again",
    "constant-orientation",
    "reduced-nominal",
    "reduced-identified",
    "elastostatic-nominal",
    "elastostatic-identified",
    "force-control-nominal",
    "force-control",
    "force-control-edges",
    "kinematic-edges",
];

/// Mean errors that a publication prints of a stage of `cdpr chain`; the answer shows them beside its own.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct PublishedStage {
    /// Stage of the chain: `reference`, `identified`, `driven`, `identified-again`, `constant-orientation`,
    /// `reduced-nominal`, `reduced-identified`, `elastostatic-nominal`, `elastostatic-identified`,
    /// `force-control-nominal`, `force-control`, `force-control-edges` or `kinematic-edges`.
    pub stage: String,
    /// Mean position error (m).
    pub position_mean_m: Option<f64>,
    /// Mean rotation error (rad).
    pub rotation_mean_rad: Option<f64>,
    /// Mean magnitude of the length errors (m).
    pub length_mean_abs_m: Option<f64>,
    /// Mean over poses of the 2-norm of the tension errors (N).
    pub tension_mean_norm_N: Option<f64>,
}

impl PublishedStage {
    /// Its errors by their keys.
    pub(super) fn errors(&self) -> [(&'static str, Option<f64>); 4] {
        [
            ("position_mean_m", self.position_mean_m),
            ("rotation_mean_rad", self.rotation_mean_rad),
            ("length_mean_abs_m", self.length_mean_abs_m),
            ("tension_mean_norm_N", self.tension_mean_norm_N),
        ]
    }
}
