//! Parameters and frames together, and samples in the frame of the robot.

use super::need::frames_that_fit;
use super::search::{AT_OPTIMUM, find};
use super::{start, uncertainty};
use crate::clock;
use crate::fit::{Fit, InputError, Settings, Status, shifts};
use crate::stopping::{StoppedBy, StoppingRule};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, Model, RecordingParameter};
use cdpr_model::robot::Robot;

/// Rounds of frames and clock at most, and the change of the clock that is none (s).
const CLOCK_ROUNDS: u32 = 12;
const SAME_CLOCK: f64 = 1e-6;

/// The frames that are free and not held.
pub(in crate::fit) fn freed(free: &FreeParameters, hold: &FreeParameters) -> Vec<RecordingParameter> {
    let is_free = |frame: &RecordingParameter| free.names_recording(*frame) && !hold.names_recording(*frame);
    RecordingParameter::FRAMES.into_iter().filter(is_free).collect()
}

/// Fit of parameters in given frames.
type Plain<'a> = &'a dyn Fn(&Samples, &FreeParameters) -> Result<Fit, InputError>;

/// Fits the free parameters together with the frames; `plain` fits in given ones.
pub(in crate::fit) fn fit(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &Settings,
    plain: Plain<'_>,
) -> Result<Fit, InputError> {
    let freed = freed(free, &settings.hold);
    let free = free.without_recording(&RecordingParameter::FRAMES);
    let start = start::start(model, samples, &freed)?;
    let mut found = find(model, samples, &free, &freed, start, &AT_OPTIMUM, settings)?;
    let mut fit = plain(&found.frames.apply(samples), &free)?;
    let mut before = f64::INFINITY;
    for _ in 0..CLOCK_ROUNDS {
        // frames of poses that were late are those of the motion's mean
        let Some(clock) = fit.clock_offset.filter(|clock| (clock.seconds - before).abs() > SAME_CLOCK) else { break };
        before = clock.seconds;
        let on_one_clock = fit.as_fitted(samples);
        found = find(model, &on_one_clock, &free, &freed, found.frames, &AT_OPTIMUM, settings)?;
        fit = plain(&found.frames.apply(samples), &free)?;
    }
    uncertainty::complete(&mut fit, &found, &freed, settings);
    if !found.converged && fit.status == Status::Converged {
        fit.status = Status::NotConverged;
        let steps = AT_OPTIMUM.steps as f64;
        fit.stopped_by = StoppedBy { rule: StoppingRule::IterationLimit, value: steps, limit: steps };
        fit.reason =
            format!("frames of tracker and marker did not settle in {} steps; {}", AT_OPTIMUM.steps, fit.reason);
    }
    Ok(fit)
}

impl Fit {
    /// Samples with the poses of the platform in the frame of the robot, where this fit freed frames.
    pub fn in_robot_frame(&self, samples: &Samples) -> Samples {
        self.frames.as_ref().map_or_else(|| samples.clone(), |found| found.frames.apply(samples))
    }

    /// Samples as this fit takes them: [`Fit::in_robot_frame`], at the times of the winches where it freed the offset of the clocks, with lengths as at the
    /// end of the record where it freed their changes.
    pub fn as_fitted(&self, samples: &Samples) -> Samples {
        let mut samples = self.in_robot_frame(samples);
        if let Some(clock) = self.clock_offset {
            samples = clock::synchronised(&samples, clock.seconds);
        }
        match (self.shifts.as_slice(), self.model.with_lengths(&samples)) {
            ([], _) | (_, Err(_)) => samples,
            (shifts, Ok(with_lengths)) => shifts::undone(&with_lengths, shifts),
        }
    }
}

/// A warning where poses fit the robot as given only in other frames and this fit freed none: anchors that are free follow the tracker's world.
pub fn frame_warning(given: &Robot, fit: &Fit, samples: &Samples, settings: &Settings) -> Option<String> {
    if fit.frames.is_some() {
        return None;
    }
    let (frames, words) = frames_that_fit(given, samples, &settings.hold)?;
    let names: Vec<&str> = frames.into_iter().map(RecordingParameter::name).collect();
    Some(format!("{words}: let `{}` be free as well, or mend the poses", names.join(",")))
}
