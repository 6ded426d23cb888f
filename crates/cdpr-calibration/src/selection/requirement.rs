//! Limits on validation errors that a recommended model must keep.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use crate::evaluation::ErrorBlocks;
use cdpr_model::control::PoseErrorStatistics;

/// An upper limit on one error figure, e.g. `position_mean_m=0.005`.
#[derive(Clone, Debug, PartialEq)]
pub struct Requirement {
    /// Place of the figure in [`METRICS`].
    metric: usize,
    /// Largest value allowed, in the figure's unit.
    limit: f64,
}

/// A figure by name.
type Metric = (&'static str, fn(&ErrorBlocks) -> f64);

/// Every figure that can be limited.
const METRICS: [Metric; 18] = [
    ("position_mean_m", |e| e.position_error_m.mean),
    ("position_rms_m", |e| e.position_error_m.rms),
    ("position_median_m", |e| e.position_error_m.median),
    ("position_p95_m", |e| e.position_error_m.p95),
    ("position_max_m", |e| e.position_error_m.max),
    ("rotation_mean_rad", |e| rotation(e).mean),
    ("rotation_rms_rad", |e| rotation(e).rms),
    ("rotation_median_rad", |e| rotation(e).median),
    ("rotation_p95_rad", |e| rotation(e).p95),
    ("rotation_max_rad", |e| rotation(e).max),
    ("length_mean_abs_m", |e| e.length_error_m.mean_abs),
    ("length_rms_m", |e| e.length_error_m.rms),
    ("length_p95_m", |e| e.length_error_m.p95),
    ("length_max_m", |e| e.length_error_m.max),
    ("tension_mean_norm_N", |e| e.tension_error.map_or(f64::NAN, |t| t.mean_norm)),
    ("tension_mean_abs_N", |e| e.tension_error.map_or(f64::NAN, |t| t.mean_abs)),
    ("tension_rms_N", |e| e.tension_error.map_or(f64::NAN, |t| t.rms)),
    ("tension_max_N", |e| e.tension_error.map_or(f64::NAN, |t| t.max)),
];

fn rotation(errors: &ErrorBlocks) -> &PoseErrorStatistics {
    &errors.rotation_error_rad
}

impl fmt::Display for Requirement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", METRICS[self.metric].0, self.limit)
    }
}

/// How a candidate stands to a limit.
#[derive(Clone, Debug, PartialEq)]
pub struct RequirementOutcome {
    /// Name of the figure.
    pub metric: &'static str,
    /// Largest value allowed.
    pub limit: f64,
    /// The candidate's value on validation data; NaN without any.
    pub value: f64,
    /// True when the value keeps the limit and every validation sample has part in it.
    pub met: bool,
    /// Validation samples.
    pub samples: usize,
    /// Those of them that have part in the value.
    pub samples_with_value: usize,
}

impl fmt::Display for RequirementOutcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { metric, limit, value, samples, samples_with_value, .. } = self;
        match value.is_finite() {
            true => write!(f, "{metric} = {value:.6} (limit {limit})")?,
            false => write!(f, "{metric} has no value (limit {limit})")?,
        }
        match samples_with_value < samples {
            true => write!(f, ", {samples_with_value} of {samples} samples have an answer"),
            false => Ok(()),
        }
    }
}

/// A requirement that cannot be understood.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RequirementError {
    /// Not NAME=LIMIT.
    #[error("cannot read the requirement `{text}`: write NAME=LIMIT with a limit above 0, e.g. position_mean_m=0.005")]
    Syntax {
        /// The text.
        text: String,
    },
    /// Not a figure.
    #[error("`{name}` is not an error figure; known are {}", known())]
    UnknownMetric {
        /// The name.
        name: String,
    },
}

fn known() -> String {
    METRICS.map(|(name, _)| name).join(", ")
}

impl FromStr for Requirement {
    type Err = RequirementError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let syntax = || RequirementError::Syntax { text: text.to_owned() };
        let (name, limit) = text.split_once('=').ok_or_else(syntax)?;
        let limit: f64 = limit.trim().parse().map_err(|_| syntax())?;
        if !(limit > 0.0 && limit.is_finite()) {
            return Err(syntax());
        }
        let name = name.trim();
        let found = METRICS.iter().position(|(known, _)| *known == name);
        let metric = found.ok_or_else(|| RequirementError::UnknownMetric { name: name.to_owned() })?;
        Ok(Self { metric, limit })
    }
}

impl Requirement {
    /// Names of the figures that can be limited.
    pub fn figures() -> impl Iterator<Item = &'static str> {
        METRICS.iter().map(|(name, _)| *name)
    }

    /// Compares a candidate's validation errors with the limit. Samples without an answer break it: nothing tells that they
    /// would keep it.
    pub(super) fn judge(&self, errors: &ErrorBlocks) -> RequirementOutcome {
        let (metric, read) = METRICS[self.metric];
        let value = read(errors);
        let samples = errors.samples;
        let samples_with_value = if metric.starts_with("length") { errors.length_samples } else { errors.answered };
        let met = value <= self.limit && samples_with_value == samples;
        RequirementOutcome { metric, limit: self.limit, value, met, samples, samples_with_value }
    }
}
