//! Whether poses fit a robot only in other frames than its own.

use super::poses::Frames;
use super::search::{End, find};
use super::start;
use crate::fit::Settings;
use crate::fit::checks::checked_parameters;
use crate::loss::Loss;
use crate::norms::median;
use crate::problem::Problem;
use crate::progress::unobserved;
use crate::residual::length_errors::length_errors;
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, FreeParameters, Model, RecordingParameter};
use cdpr_model::robot::{ParameterKind, Robot};

/// Misfits below this share of the diagonal of the anchors' box are no question of the tracker's frame: wrong anchors make as large ones.
const IGNORED_OF_TRACKER: f64 = 4e-3;
/// The same of the marker, whose motion wrong anchors do not resemble.
const IGNORED_OF_MARKER: f64 = 1e-3;
/// Frames are needed when they leave at most this share of the misfit, and no more than this share of the diagonal: mirrored poses leave more.
const EXPLAINED: f64 = 0.25;
const LEFT_SHARE: f64 = 5e-3;
/// One frame is enough when it leaves no more than this many times what both leave.
const ENOUGH: f64 = 1.05;
/// Fewest samples that tell.
const FEWEST: usize = 12;
/// A small part of what is ignored is near enough.
const ROUGHLY: End = End { steps: 10, size: 1e-5 };

/// Frames that poses need to fit a robot, with the reason in words; `None` if they fit as they are, or in no other frame either.
///
/// Misfits are those of point outlets with offsets and scales of the recorded lengths fitted, the typical one of all samples.
pub(crate) fn frames_that_fit(
    robot: &Robot,
    samples: &Samples,
    hold: &FreeParameters,
) -> Option<(Vec<RecordingParameter>, String)> {
    if samples.len() < FEWEST {
        return None;
    }
    let model = Model::new(robot.clone(), Composition::STANDARD).ok()?;
    let samples = &*model.with_lengths(samples).ok()?;
    let as_written = misfit(&model, samples)?;
    if !(as_written > IGNORED_OF_MARKER * robot.anchor_diagonal()) {
        return None;
    }
    let may_be_tracker = as_written > IGNORED_OF_TRACKER * robot.anchor_diagonal();
    let mut sets: Vec<Vec<RecordingParameter>> = vec![RecordingParameter::FRAMES.to_vec()];
    sets.extend(RecordingParameter::FRAMES.map(|frame| vec![frame]));
    let may_be_free = |set: &Vec<RecordingParameter>| {
        set.iter().all(|frame| {
            let is_possible = match frame {
                RecordingParameter::MarkerFrame => robot.motion_pattern.has_rotation(),
                _ => may_be_tracker,
            };
            is_possible && !hold.names_recording(*frame)
        })
    };
    let left: Vec<(f64, Vec<RecordingParameter>)> = sets
        .into_iter()
        .filter(may_be_free)
        .filter_map(|set| Some((misfit(&model, &in_frames(&model, samples, &set)?.apply(samples))?, set)))
        .collect();
    let least = left.iter().map(|(misfit, _)| *misfit).fold(f64::INFINITY, f64::min);
    if !(least <= EXPLAINED * as_written && least <= LEFT_SHARE * robot.anchor_diagonal()) {
        return None;
    }
    let (misfit, set) = left.iter().filter(|(misfit, _)| *misfit <= ENOUGH * least).min_by_key(|(_, set)| set.len())?;
    let names: Vec<String> = set.iter().map(|frame| format!("`{}`", frame.name())).collect();
    let words = format!(
        "frames: the poses fit the robot only with {} (typical misfit of a length {:.1} mm as written, {:.1} mm then, offsets and scales of \
         the cables left aside)",
        names.join(" and "),
        1e3 * as_written,
        1e3 * misfit
    );
    Some((set.clone(), words))
}

fn leaving_winches() -> (FreeParameters, Settings) {
    let free = FreeParameters::of(&[ParameterKind::LengthOffset, ParameterKind::LengthScale]);
    (free, Settings { loss: Loss::Huber, ..Settings::default() })
}

fn in_frames(model: &Model, samples: &Samples, freed: &[RecordingParameter]) -> Option<Frames> {
    let (free, settings) = leaving_winches();
    let start = start::start(model, samples, freed).ok()?;
    find(model, samples, &free, freed, start, &ROUGHLY, &settings).ok().map(|found| found.frames)
}

/// Median of the samples' residuals (root of the mean square over the cables, m).
fn misfit(model: &Model, samples: &Samples) -> Option<f64> {
    let (free, settings) = leaving_winches();
    let parameters = checked_parameters(model, samples, &free, &settings).ok()?;
    let mut problem = Problem::new(model, samples, &parameters, &settings).ok()?;
    let optimum = problem.minimize(&unobserved).ok()?;
    let fitted = problem.model_at(&optimum.end.values).ok()?;
    let root = |sample: usize| {
        let residuals = length_errors(&fitted, samples, sample);
        (residuals.iter().map(|residual| residual * residual).sum::<f64>() / residuals.len() as f64).sqrt()
    };
    let middle = median(&mut (0..samples.len()).map(root).collect::<Vec<f64>>());
    middle.is_finite().then_some(middle)
}
