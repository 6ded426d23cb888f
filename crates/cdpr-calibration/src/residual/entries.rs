//! The objectives of an identification at measured poses: one entry each.

use super::Given;
use super::Residual;
use super::balance::BalanceResidual;
use super::balance::start::checked_start;
use super::both::UnknownPoses;
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
    /// The residuals in words.
    words: &'static str,
    /// True where rotations count beside positions by a length.
    counts_rotations: bool,
    make: Make,
}

/// All objectives.
const ENTRIES: &[Entry] = &[
    Entry { objective: Objective::Length, words: "the length residuals", counts_rotations: false, make: lengths },
    Entry {
        objective: Objective::Pose,
        words: "the errors of predicted poses",
        counts_rotations: true,
        make: |given| poses(given, |own| Ok(Box::new(PoseResidual::new(own)?))),
    },
    Entry {
        objective: Objective::PoseInTask,
        words: "the errors of predicted poses, a tenth as much away from the task",
        counts_rotations: true,
        make: |given| poses(given, |own| Ok(Box::new(PoseInTask::new(own)?))),
    },
    Entry {
        objective: Objective::Both,
        words: "lengths and poses in their accuracies, the poses unknown",
        counts_rotations: false,
        make: |given| Ok(Box::new(UnknownPoses::new(given)?)),
    },
];

fn entry(objective: Objective) -> &'static Entry {
    ENTRIES.iter().find(|entry| entry.objective == objective).unwrap_or(&ENTRIES[0])
}

/// Residuals of the objective of the settings.
pub(crate) fn residual<'a>(given: &Given<'a, '_>) -> Result<Box<dyn Residual + 'a>, InputError> {
    (entry(given.settings.objective).make)(given)
}

impl Objective {
    /// The residuals in words.
    pub fn residuals(self) -> &'static str {
        entry(self).words
    }

    /// True where rotations count beside positions by a length ([`Settings::rotation_length`]).
    pub fn counts_rotations(self) -> bool {
        entry(self).counts_rotations
    }

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

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_model::reading::Keyword;

    #[test]
    fn every_objective_has_one_entry() {
        for objective in Objective::ALL {
            let count = ENTRIES.iter().filter(|entry| entry.objective == *objective).count();
            assert_eq!(count, 1, "{objective:?}");
        }
    }
}
