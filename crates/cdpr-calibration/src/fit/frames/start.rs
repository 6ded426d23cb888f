//! Frames to start from, in closed form: poses that the recorded lengths give, against those that the tracker gives.

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::poses::Frames;
use crate::fit::InputError;
use crate::norms::median;
use cdpr_model::equilibrium::forward_kinematics::{self, Solver};
use cdpr_model::geometry::nearest_rotation;
use cdpr_model::geometry::{Pose, inverse, product};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, Model, RecordingParameter, SpanEffect, StretchEffect};
use cdpr_model::robot::{Frame, TrackedFrames};

/// Most poses that a start is made from, and the fewest.
const MOST: usize = 100;
const FEWEST: usize = 6;
/// Rounds of one frame by the other.
const ROUNDS: usize = 100;
/// Poses farther than this many medians from where they belong are left aside.
const FAR: f64 = 5.0;

/// A measured pose with that of the platform by its cables.
type Pair = (Pose, Pose);

/// The free frames that bring the measured poses nearest to those that the model has at the recorded lengths.
pub(super) fn start(model: &Model, samples: &Samples, freed: &[RecordingParameter]) -> Result<Frames, InputError> {
    found(model, samples, freed, true)
}

/// The same by measured positions alone, whose orientations mean nothing: the marker's axes are those of the platform.
pub(crate) fn start_by_positions(
    model: &Model,
    samples: &Samples,
    freed: &[RecordingParameter],
) -> Result<TrackedFrames, InputError> {
    let frames = found(model, samples, freed, false)?;
    let marker = Frame { position: frames.marker.position, ..Frame::default() };
    Ok(TrackedFrames { tracker: Frame::of(&frames.tracker), marker })
}

fn found(
    model: &Model,
    samples: &Samples,
    freed: &[RecordingParameter],
    has_orientations: bool,
) -> Result<Frames, InputError> {
    if freed.contains(&RecordingParameter::MarkerFrame) && !model.robot().motion_pattern.has_rotation() {
        return Err(InputError::MarkerOfPoint);
    }
    let mut pairs = pairs(model, samples)?;
    let mut frames = Frames::identity(model);
    for _ in 0..2 {
        if pairs.len() < FEWEST {
            return Err(InputError::NoFrames { poses: pairs.len(), needed: FEWEST });
        }
        frames = aligned(model, &pairs, freed, has_orientations);
        // of a position alone the platform's orientation is that of its cables
        let distance = |(measured, given): &Pair| {
            let seen = frames.tracker.transform(&measured.position);
            (seen - if frames.turns { given.transform(&frames.marker.position) } else { given.position }).norm()
        };
        let limit = FAR * median(&mut pairs.iter().map(distance).collect::<Vec<f64>>());
        pairs.retain(|pair| distance(pair) <= limit.max(f64::MIN_POSITIVE));
    }
    Ok(frames)
}

/// Forward kinematics of straight, rigid cables for samples spread over the recording.
fn pairs(model: &Model, samples: &Samples) -> Result<Vec<Pair>, InputError> {
    let straight = Composition { stretch: StretchEffect::Rigid, span: SpanEffect::Straight, ..model.composition() };
    let rigid = Model::new(model.robot().clone(), straight)?;
    let settings = forward_kinematics::Settings::default();
    let Ok(mut solver) = Solver::new(&rigid, &settings) else { return Ok(Vec::new()) };
    let home = model.robot().home_or_middle();
    let count = samples.len().min(MOST);
    let mut pairs = Vec::with_capacity(count);
    let mut before: Option<Pose> = None;
    for k in 0..count {
        let sample = k * samples.len() / count;
        let recorded = samples.lengths_of(sample).iter().enumerate();
        let lengths: Vec<f64> = recorded.map(|(cable, length)| rigid.controlled_length(cable, *length)).collect();
        let mut best: Option<(f64, Pose)> = None;
        for guess in before.into_iter().chain([home]) {
            let Ok(found) = solver.solve(&lengths, &guess) else { continue };
            let is_better = best.as_ref().is_none_or(|(rms, _)| found.residual_rms < *rms);
            if found.status == forward_kinematics::Status::Converged && is_better {
                best = Some((found.residual_rms, found.pose));
            }
        }
        before = best.as_ref().map(|(_, pose)| *pose).or(before);
        pairs.extend(best.map(|(_, pose)| (samples.poses[sample], pose)));
    }
    Ok(pairs)
}

/// Each frame by the other in turn, in closed form.
fn aligned(model: &Model, pairs: &[Pair], freed: &[RecordingParameter], has_orientations: bool) -> Frames {
    let [frees_tracker, frees_marker] = RecordingParameter::FRAMES.map(|frame| freed.contains(&frame));
    let robot = model.robot();
    let normal = robot.motion_pattern.is_planar().then(|| robot.plane.normal());
    let mut frames = Frames::identity(model);
    for round in 0..ROUNDS {
        let before = frames;
        if frees_tracker {
            // until something is known of the marker its orientation says nothing
            let by_rotation = has_orientations && frames.turns && (round > 0 || !frees_marker);
            frames.tracker = tracker(pairs, &frames, by_rotation, normal);
        }
        if frees_marker {
            frames.marker = marker(pairs, &frames);
            if !has_orientations {
                frames.marker.rotation = UnitQuaternion::identity();
            }
        }
        if !(frees_tracker && frees_marker) || frames == before {
            break;
        }
    }
    frames
}

/// The pose of the tracker's world that is best for a marker at its place (Umeyama 1991, without scale); orientations count as points at the
/// distance of the poses from their middle.
fn tracker(pairs: &[Pair], frames: &Frames, by_rotation: bool, normal: Option<Vector3<f64>>) -> Pose {
    let given: Vec<Pose> = pairs
        .iter()
        .map(|(_, platform)| if frames.turns { product(platform, &frames.marker) } else { *platform })
        .collect();
    let count = pairs.len() as f64;
    let middle = |poses: &mut dyn Iterator<Item = Vector3<f64>>| poses.sum::<Vector3<f64>>() / count;
    let to = middle(&mut given.iter().map(|pose| pose.position));
    let from = middle(&mut pairs.iter().map(|(measured, _)| measured.position));
    let mut moment = Matrix3::zeros();
    for ((measured, _), given) in pairs.iter().zip(&given) {
        moment += (given.position - to) * (measured.position - from).transpose();
    }
    if by_rotation {
        let size = moment.norm() / count;
        for ((measured, _), given) in pairs.iter().zip(&given) {
            moment += size * given.rotation_matrix() * measured.rotation_matrix().transpose();
        }
    }
    let rotation = nearest_rotation(moment, normal);
    Pose { position: to - rotation * from, rotation }
}

/// The pose of the marker on the platform in the mean.
fn marker(pairs: &[Pair], frames: &Frames) -> Pose {
    let (mut position, mut sum) = (Vector3::zeros(), Matrix3::zeros());
    for (measured, platform) in pairs {
        let on_platform = product(&inverse(platform), &product(&frames.tracker, measured));
        position += on_platform.position / pairs.len() as f64;
        sum += on_platform.rotation_matrix();
    }
    Pose { position, rotation: nearest_rotation(sum, None) }
}
