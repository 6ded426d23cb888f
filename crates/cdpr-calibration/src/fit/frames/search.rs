//! Search for the frames at whose optimum the parameters fit best.

use nalgebra::{DMatrix, DVector};

use super::directions::Directions;
use super::elimination::Eliminated;
use super::poses::Frames;
use super::rows::Fitted;
use crate::fit::checks::checked_parameters;
use crate::fit::{InputError, Settings};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, Model, RecordingParameter};
use cdpr_model::scalar::decomposition::svd;

/// End of a search.
pub(super) struct End {
    /// Most steps.
    pub(super) steps: usize,
    /// The step that ends it (m, rotations times the extent of the poses), for an extent of at most 1 m; in proportion for larger ones.
    pub(super) size: f64,
}

pub(super) const AT_OPTIMUM: End = End { steps: 40, size: 1e-9 };
/// Steps that are mixed, below this share of the extent, and the least singular value of their changes that counts.
const MOST_MIXED: usize = 4;
const MIXED_BELOW: f64 = 0.05;
const MIXED_REGULAR: f64 = 1e-6;

/// Frames with the parameters at their optimum.
pub(super) struct Found {
    pub(super) frames: Frames,
    pub(super) directions: Directions,
    pub(super) fitted: Fitted,
    pub(super) eliminated: Eliminated,
    pub(super) converged: bool,
}

/// Moves the frames to their optimum.
pub(super) fn find(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    freed: &[RecordingParameter],
    start: Frames,
    end: &End,
    settings: &Settings,
) -> Result<Found, InputError> {
    let settings = &Settings { starts: 1, ..settings.clone() };
    let free = &free.without_recording(&RecordingParameter::ALL);
    let parameters = checked_parameters(model, samples, free, settings)?;
    let mut frames = start;
    let directions = Directions::of(model, freed, &frames.apply(samples).poses);
    let mut mixed = Mixed::default();
    let mut steps = 0;
    loop {
        steps += 1;
        let fitted = Fitted::of(model, &frames.apply(samples), &parameters, settings)?;
        let eliminated = Eliminated::of(&fitted, &parameters, &directions).ok_or(InputError::NotFinite)?;
        let step = eliminated.step(&fitted, &parameters, directions.extent);
        let size = step.amax();
        let converged = size < end.size * directions.extent.max(1.0);
        if converged || steps == end.steps {
            return Ok(Found { frames, directions, fitted, eliminated, converged });
        }
        frames = directions.moved(&frames, mixed.next(step, MIXED_BELOW * directions.extent).as_slice());
    }
}

/// Steps mixed with those before them (Anderson acceleration): Gauss–Newton steps leave out how weights and points of linearization move, so that
/// alone they gain only half a digit each.
#[derive(Default)]
struct Mixed {
    /// Steps that were asked for and those that were taken.
    asked: Vec<DVector<f64>>,
    taken: Vec<DVector<f64>>,
}

impl Mixed {
    /// The step to take where this one is asked for; mixed only with steps below a size.
    fn next(&mut self, asked: DVector<f64>, below: f64) -> DVector<f64> {
        if asked.amax() > below {
            *self = Self::default();
            return asked;
        }
        let mut step = asked.clone();
        if let Some(before) = self.asked.len().checked_sub(1) {
            let columns = |change: &dyn Fn(usize) -> DVector<f64>| {
                DMatrix::from_columns(&(0..=before).map(change).collect::<Vec<_>>())
            };
            let next = |k: usize| self.asked.get(k + 1).unwrap_or(&asked);
            let changes = columns(&|k| next(k) - &self.asked[k]);
            if let Some(Ok(fractions)) =
                svd(changes.clone(), true, true).map(|svd| svd.solve(&asked, MIXED_REGULAR * svd.singular_values.max()))
            {
                step -= (columns(&|k| self.taken[k].clone()) + changes) * fractions;
            }
        }
        if self.asked.len() == MOST_MIXED {
            self.asked.remove(0);
            self.taken.remove(0);
        }
        self.asked.push(asked);
        self.taken.push(step.clone());
        step
    }
}
