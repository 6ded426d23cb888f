//! The objectives of an identification at measured poses: one entry each.

use super::Residual;
use super::balance::BalanceResidual;
use super::balance::start::checked_start;
use super::both::UnknownPoses;
use super::given::Given;
use super::lengths::{EvenLengths, LengthResidual};
use super::pose_in_task::PoseInTask;
use super::poses::PoseResidual;
use crate::fit::{ASSUMED_NOISE, InputError, RowWeights, Settings};
use crate::objective::{Minimize, Objective};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;

/// Makes the residuals of an objective, or refuses them.
type Make = for<'a> fn(&Given<'a, '_>) -> Result<Box<dyn Residual + 'a>, InputError>;

/// Residuals of an objective.
struct Entry {
    objective: Objective,
    make: Make,
}

/// All objectives.
const ENTRIES: &[Entry] = &[
    Entry { objective: Objective::Length, make: lengths },
    Entry { objective: Objective::Pose, make: |given| poses(given, |own| Ok(Box::new(PoseResidual::new(own)?))) },
    Entry { objective: Objective::PoseInTask, make: |given| poses(given, |own| Ok(Box::new(PoseInTask::new(own)?))) },
    Entry { objective: Objective::Both, make: |given| Ok(Box::new(UnknownPoses::new(given)?)) },
];

/// Residuals of the objective of the settings.
pub(crate) fn residual<'a>(given: &Given<'a, '_>) -> Result<Box<dyn Residual + 'a>, InputError> {
    let own = ENTRIES.iter().find(|entry| entry.objective == given.settings.objective);
    (own.unwrap_or(&ENTRIES[0]).make)(given)
}

impl Objective {
    /// True where it has residuals for a model and samples; `both` is for rigid models with stated accuracies of lengths and positions.
    pub fn has_residuals(self, model: &Model, samples: &Samples, settings: &Settings) -> bool {
        let settings = Settings { objective: self, ..settings.clone() };
        residual(&Given { model, samples, parameters: &[], settings: &settings }).is_ok()
    }
}

/// Lengths, of elastic models with wrenches; squares have weights that agree with their optimum.
fn lengths<'a>(given: &Given<'a, '_>) -> Result<Box<dyn Residual + 'a>, InputError> {
    let Given { model, samples, settings, .. } = *given;
    match (model.needs_tensions(), settings.minimize) {
        (false, Minimize::Squares) => Ok(Box::new(LengthResidual::new(given)?)),
        (false, _) => {
            let stated = samples.sigmas.length.filter(|sigma| *sigma > 0.0);
            Ok(Box::new(EvenLengths::new(given, stated.unwrap_or(ASSUMED_NOISE), stated.is_some())))
        }
        (true, Minimize::Squares) => with_start(given, |given| Ok(Box::new(BalanceResidual::new(given)?))),
        (true, _) => with_start(given, |given| Ok(Box::new(BalanceResidual::measured(given)?))),
    }
}

/// Noise that lengths and wrenches are whitened by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum RowNoise {
    /// The stated accuracies of all that is measured.
    Stated,
    /// A weight for each kind of row.
    Even(RowWeights),
}

/// Rows of lengths, of elastic models with wrenches, at what was measured; their load must be known.
pub(crate) fn length_rows<'a>(given: &Given<'a, '_>, noise: RowNoise) -> Result<Box<dyn Residual + 'a>, InputError> {
    Ok(match (given.model.needs_tensions(), noise) {
        (false, RowNoise::Stated) => Box::new(LengthResidual::new(given)?),
        (false, RowNoise::Even(weights)) => Box::new(EvenLengths::new(given, weights.length.recip(), false)),
        (true, RowNoise::Stated) => Box::new(BalanceResidual::measured(given)?),
        (true, RowNoise::Even(weights)) => Box::new(BalanceResidual::by_rows(given, weights)?),
    })
}

/// Predicted poses, of elastic models with tensions.
fn poses<'a>(
    given: &Given<'a, '_>,
    make: impl FnOnce(&Given<'a, '_>) -> Result<Box<dyn Residual + 'a>, InputError>,
) -> Result<Box<dyn Residual + 'a>, InputError> {
    if given.model.needs_tensions() && given.samples.tensions.is_none() {
        return Err(InputError::PosesWithoutTensions);
    }
    with_start(given, make)
}

/// Residuals of a model with the load that its parameters need.
fn with_start<'a>(
    given: &Given<'a, '_>,
    make: impl FnOnce(&Given<'a, '_>) -> Result<Box<dyn Residual + 'a>, InputError>,
) -> Result<Box<dyn Residual + 'a>, InputError> {
    let start = checked_start(given.model, given.samples, given.parameters)?;
    make(&Given { model: &start, ..*given })
}
