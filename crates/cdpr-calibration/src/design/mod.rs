//! Planned measurements: the poses that tell most of the free parameters (sec. 4.3; C23), before anything is measured.
//!
//! Everything is asked of the information M = Σ JᵀΣ⁻¹J of the rows that identification would have at the poses, with what is known already: measured
//! poses and priors. Nothing of it depends on what will be recorded, only on the model as it is.

mod candidates;
mod comparison;
mod criterion;
mod exchange;
mod factorial;
mod information;
mod order;
mod plan_error;
mod prediction;
mod records;
mod settings;
#[cfg(test)]
mod tests;

use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{FreeParameters, Model, RecordingParameter, ShiftCourse};
use cdpr_model::robot::Parameter;

pub use candidates::Candidates;
pub use comparison::{CurvePoint, GridComparison};
pub use criterion::DesignCriterion;
pub use plan_error::PlanError;
pub use prediction::{ParameterPrediction, PosePrediction, Predicted};
pub use settings::PlanSettings;

use comparison::{against_grid, curve};
use information::Information;

/// Poses that tell most, with what they tell.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Candidates chosen, from 0, in the order of a short path.
    pub chosen: Vec<usize>,
    /// Number of free parameters.
    pub parameter_count: usize,
    /// Rank of the Jacobian at the chosen poses and those measured already.
    pub rank: usize,
    /// log det M; `None` where the poses do not determine all parameters.
    pub log_det: Option<f64>,
    /// κ of the Jacobian in SI units; `None` below full rank.
    pub condition: Option<f64>,
    /// Smallest singular value of the Jacobian; 0 below full rank.
    pub sigma_min: f64,
    /// tr M⁻¹.
    pub trace_inverse: Option<f64>,
    /// Mean variance of all lengths over the candidates, u M⁻¹ uᵀ (m² where accuracies are stated).
    pub i_value: Option<f64>,
    /// Sets from which exchanges started, and the share of them that led to the plan's value.
    pub starts: u32,
    /// Fraction of the starts that ended there.
    pub fraction: f64,
    /// log det over the number of poses.
    pub curve: Vec<CurvePoint>,
    /// The plain grid of as many poses.
    pub grid: GridComparison,
    /// All candidates together: nothing tells more.
    pub all_log_det: Option<f64>,
}

/// Chooses poses among candidates; `given` has poses (and tensions) that are measured already. Rows have the accuracies of the candidates' sensors,
/// unit weights where none is stated.
pub fn plan(
    model: &Model,
    candidates: &Candidates,
    given: Option<&Samples>,
    free: &FreeParameters,
    settings: &PlanSettings,
) -> Result<Plan, PlanError> {
    let (samples, count) = (&candidates.samples, settings.count);
    let most = samples.len();
    if count == 0 {
        return Err(PlanError::NoCount);
    }
    if count > most && !settings.repeats {
        return Err(PlanError::TooMany { count, candidates: most });
    }
    if !settings.fit.priors.is_empty() && samples.sigmas == SensorSigmas::default() {
        return Err(PlanError::PriorsWithoutAccuracies);
    }
    let parameters = plannable(model, free, &settings.fit.hold)?;
    let information = Information::of(model, samples, given, &parameters, &settings.fit)?;
    let found = exchange::search(&information, samples, settings);
    let summary = information.summary(&found.chosen);
    let grid = factorial::design(samples, count);
    Ok(Plan {
        parameter_count: parameters.len(),
        rank: summary.rank,
        log_det: summary.log_det,
        condition: summary.condition.is_finite().then_some(summary.condition),
        sigma_min: summary.sigma_min,
        trace_inverse: summary.trace_inverse,
        i_value: summary.i_value,
        starts: found.starts,
        fraction: found.fraction,
        curve: curve(&information, samples, settings, summary.log_det),
        grid: against_grid(&information, &grid, summary.log_det),
        all_log_det: information.summary(&(0..most).collect::<Vec<_>>()).log_det,
        chosen: order::along_a_path(model, samples, found.chosen),
    })
}

/// Free parameters that poses can tell of.
fn plannable(model: &Model, free: &FreeParameters, hold: &FreeParameters) -> Result<Vec<Parameter>, PlanError> {
    let of_recording = RecordingParameter::ALL.into_iter().find(|parameter| free.names_recording(*parameter));
    let of_lengths = || free.first_length_shift(hold).map(ShiftCourse::known_name);
    if let Some(name) = of_recording.map(RecordingParameter::name).or_else(of_lengths) {
        let on = "clock and frame of the sensors, not on the robot: leave it out of the plan, every set of poses spread over the workspace tells of it";
        return Err(PlanError::Unplannable { name, on });
    }
    let parameters = free.parameters(model, hold)?;
    if let Some(kind) = parameters.iter().map(|parameter| parameter.kind).find(|kind| kind.needs_motor_angles()) {
        return Err(PlanError::Unplannable {
            name: kind.name(),
            on: "recorded motor angles: plan for `length-scale` and `length-offset` instead",
        });
    }
    if parameters.is_empty() { Err(PlanError::NothingFree) } else { Ok(parameters) }
}
