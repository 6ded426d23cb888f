//! Frames of a recording: the tracker's world in the frame of the robot, and the tracked marker on the platform.
//!
//! A tracker tells the pose M of a marker in its own world; the platform is at T = X M Y⁻¹, X the pose of that world in the robot's frame
//! and Y that of the marker on the platform. Both are found together with the parameters of the model: for frames at hand the
//! parameters are at their optimum, and Gauss–Newton steps of the frames account for how that optimum follows them (variable projection).
//! Directions that no row resists, since the anchors follow, are fixed by the least change of the file's anchors.

mod elimination;
mod need;
mod rows;
mod start;
mod uncertainty;

#[cfg(test)]
mod tests;

use nalgebra::{DMatrix, DVector, UnitQuaternion, Vector3};

use super::{Estimate, Fit, InputError, Settings, Status, checked_parameters, fit_observed};
use crate::geometry::{Pose, Twist, Wrench};
use crate::measurement::Samples;
use crate::model::{FreeParameters, Model, RecordingParameter};
use crate::robot::Parameter;
use crate::scalar::decomposition::svd;
use elimination::Eliminated;
pub(in crate::identification) use need::frames_that_fit;
use rows::Fitted;
pub(in crate::identification) use rows::{RowBlock, Wrenches};
pub use uncertainty::{FrameEstimate, Gauge, RecordingFrames};

/// End of a search.
struct End {
    /// Most steps.
    steps: usize,
    /// The step that ends it (m per metre of extent, rotations times the extent of the poses).
    size: f64,
}

const AT_OPTIMUM: End = End { steps: 40, size: 1e-9 };
/// Steps that are mixed, below this share of the extent, and the least singular value of their changes that counts.
const MOST_MIXED: usize = 4;
const MIXED_BELOW: f64 = 0.05;
const MIXED_REGULAR: f64 = 1e-6;
/// Least rotation of all poses that tells where the marker is (rad).
const LEAST_EXTENT: f64 = 1e-3;

/// Poses between the tracker's numbers and the robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::identification) struct Frames {
    /// The tracker's world in the frame of the robot.
    tracker: Pose,
    /// The marker on the platform.
    marker: Pose,
    /// False for point platforms, whose measured orientation means nothing.
    turns: bool,
}

impl Frames {
    fn identity(model: &Model) -> Self {
        let turns = model.robot().motion_pattern.has_rotation();
        Self { tracker: Pose::identity(), marker: Pose::identity(), turns }
    }

    /// Pose of the platform in the robot's frame.
    fn platform(&self, measured: &Pose) -> Pose {
        match self.turns {
            true => product(&product(&self.tracker, measured), &inverse(&self.marker)),
            false => Pose { position: self.tracker.transform(&measured.position), rotation: measured.rotation },
        }
    }

    /// The samples with the poses of the platform in the robot's frame.
    pub(in crate::identification) fn apply(&self, samples: &Samples) -> Samples {
        Samples { poses: samples.poses.iter().map(|pose| self.platform(pose)).collect(), ..samples.clone() }
    }
}

/// a b: the pose that is `second` in the frame at `first`.
fn product(first: &Pose, second: &Pose) -> Pose {
    Pose { position: first.transform(&second.position), rotation: first.rotation * second.rotation }
}

fn inverse(pose: &Pose) -> Pose {
    let rotation = pose.rotation.inverse();
    Pose { position: -(rotation * pose.position), rotation }
}

/// A direction in which a frame may move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Direction {
    /// Tracker or marker.
    frame: RecordingParameter,
    /// Motion by one metre: rotations are those whose arm is the extent. Of the tracker about the middle of all poses (robot's axes), of
    /// the marker that of the platform against it (platform's axes).
    motion: Twist,
}

/// Directions of the free frames, with the middle of all poses.
struct Directions {
    list: Vec<Direction>,
    middle: Vector3<f64>,
    /// Distance of the poses from their middle (root of the mean square, m).
    extent: f64,
}

impl Directions {
    fn of(model: &Model, freed: &[RecordingParameter], poses: &[Pose]) -> Self {
        let (robot, count) = (model.robot(), poses.len() as f64);
        let middle = poses.iter().map(|pose| pose.position).sum::<Vector3<f64>>() / count;
        let spread = poses.iter().map(|pose| (pose.position - middle).norm_squared()).sum::<f64>() / count;
        let extent = spread.sqrt().max(LEAST_EXTENT);
        let turning = |normal: Vector3<f64>| Twist::new(0.0, 0.0, 0.0, normal.x, normal.y, normal.z);
        let turns = match robot.motion_pattern.is_planar() {
            true => vec![turning(robot.plane.normal())],
            false => (0..3).map(|axis| turning(Vector3::ith(axis, 1.0))).collect(),
        };
        let shifts = model.axes().iter().map(|axis| Twist::new(axis.x, axis.y, axis.z, 0.0, 0.0, 0.0));
        let motions: Vec<Twist> = shifts.chain(turns).collect();
        let of_frame = |&frame: &RecordingParameter| {
            let arm = if frame == RecordingParameter::TrackerFrame { extent } else { model.platform_radius() };
            motions.iter().map(move |motion| {
                let is_turn = motion.fixed_rows::<3>(3).norm() > 0.0;
                Direction { frame, motion: if is_turn { motion / arm } else { *motion } }
            })
        };
        let is_free = |frame: &&RecordingParameter| freed.contains(frame);
        let list = RecordingParameter::FRAMES.iter().filter(is_free).flat_map(of_frame).collect();
        Self { list, middle, extent }
    }

    /// Motion of the platform at a pose by one metre of each direction (world).
    fn motions(&self, pose: &Pose) -> impl Iterator<Item = Twist> {
        self.list.iter().map(|direction| {
            let (shift, turn) = (direction.motion.fixed_rows::<3>(0), direction.motion.fixed_rows::<3>(3));
            let (shift, turn) = match direction.frame {
                RecordingParameter::TrackerFrame => (shift + turn.cross(&(pose.position - self.middle)), turn.into()),
                _ => (pose.rotation * shift, pose.rotation * turn),
            };
            Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z)
        })
    }

    /// Change of a wrench's numbers by one metre of each direction that is none of the wrench: its axes turn with the tracker's world, its point moves
    /// with the platform's origin along the marker's directions.
    fn changes_of_axes(&self, pose: &Pose, wrench: &Wrench) -> impl Iterator<Item = Wrench> {
        let (force, moment) = (Vector3::from(wrench.fixed_rows::<3>(0)), Vector3::from(wrench.fixed_rows::<3>(3)));
        self.list.iter().map(move |direction| {
            let (shift, turn) =
                (direction.motion.fixed_rows::<3>(0), Vector3::from(direction.motion.fixed_rows::<3>(3)));
            let (force, moment) = match direction.frame {
                RecordingParameter::TrackerFrame => (turn.cross(&force), turn.cross(&moment)),
                _ => (Vector3::zeros(), -(pose.rotation * shift).cross(&force)),
            };
            Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
        })
    }

    /// Total motion of tracker and of the platform against the marker.
    fn total(&self, step: &[f64], frame: RecordingParameter) -> Twist {
        let of_frame = self.list.iter().zip(step).filter(|(direction, _)| direction.frame == frame);
        of_frame.map(|(direction, amount)| direction.motion * *amount).sum()
    }

    /// The frames after a step.
    fn moved(&self, frames: &Frames, step: &[f64]) -> Frames {
        let parts = |twist: Twist| {
            let turn = UnitQuaternion::new(twist.fixed_rows::<3>(3).into_owned());
            (Vector3::from(twist.fixed_rows::<3>(0)), turn)
        };
        let (shift, turn) = parts(self.total(step, RecordingParameter::TrackerFrame));
        let tracker = Pose {
            position: self.middle + shift + turn * (frames.tracker.position - self.middle),
            rotation: turn * frames.tracker.rotation,
        };
        let (shift, turn) = parts(self.total(step, RecordingParameter::MarkerFrame));
        let marker = product(&inverse(&Pose { position: shift, rotation: turn }), &frames.marker);
        Frames { tracker, marker, ..*frames }
    }
}

/// Frames with the parameters at their optimum.
struct Found {
    frames: Frames,
    directions: Directions,
    fitted: Fitted,
    eliminated: Eliminated,
    converged: bool,
}

/// The frames that are free and not held.
pub(super) fn freed(free: &FreeParameters, hold: &FreeParameters) -> Vec<RecordingParameter> {
    let is_free = |frame: &RecordingParameter| free.names_recording(*frame) && !hold.names_recording(*frame);
    RecordingParameter::FRAMES.into_iter().filter(is_free).collect()
}

/// Fits the free parameters together with the frames.
pub(super) fn fit(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &Settings,
    progress: &dyn Fn(),
) -> Result<Fit, InputError> {
    let freed = freed(free, &settings.hold);
    let free = free.without_recording(&RecordingParameter::FRAMES);
    let start = start::start(model, samples, &freed)?;
    let mut found = find(model, samples, (&free, &freed), start, &AT_OPTIMUM, settings)?;
    let mut fit = fit_observed(model, &found.frames.apply(samples), &free, settings, progress)?;
    if fit.clock_offset.is_some() {
        // frames of poses that were late are those of the motion's mean
        let on_one_clock = fit.as_fitted(samples);
        found = find(model, &on_one_clock, (&free, &freed), found.frames, &AT_OPTIMUM, settings)?;
        fit = fit_observed(model, &found.frames.apply(samples), &free, settings, &|| ())?;
    }
    uncertainty::complete(&mut fit, &found, &freed, settings);
    if !found.converged && fit.status == Status::Converged {
        fit.status = Status::NotConverged;
        fit.reason =
            format!("frames of tracker and marker did not settle in {} steps; {}", AT_OPTIMUM.steps, fit.reason);
    }
    Ok(fit)
}

/// Moves the frames to their optimum.
fn find(
    model: &Model,
    samples: &Samples,
    (free, freed): (&FreeParameters, &[RecordingParameter]),
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
    for steps in 1.. {
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
    unreachable!("the loop ends at its limit of steps")
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
            if let Some(Ok(shares)) =
                svd(changes.clone(), true, true).map(|svd| svd.solve(&asked, MIXED_REGULAR * svd.singular_values.max()))
            {
                step -= (columns(&|k| self.taken[k].clone()) + changes) * shares;
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

/// Estimates that stand for an anchor.
fn is_anchor(parameter: &Parameter) -> bool {
    use crate::robot::ParameterKind::{FrameAnchor, PlatformAnchor};
    matches!(parameter.kind, FrameAnchor | PlatformAnchor)
}

impl Fit {
    /// Samples with the poses of the platform in the frame of the robot, where this fit freed frames.
    pub fn in_robot_frame(&self, samples: &Samples) -> Samples {
        self.frames.as_ref().map_or_else(|| samples.clone(), |found| found.frames.apply(samples))
    }

    /// Samples as this fit takes them: [`Fit::in_robot_frame`], at the times of the winches where it freed the offset of the clocks.
    pub fn as_fitted(&self, samples: &Samples) -> Samples {
        let samples = self.in_robot_frame(samples);
        self.clock_offset.map_or_else(|| samples.clone(), |clock| super::clock::synchronised(&samples, clock.seconds))
    }
}

/// A warning where poses fit the robot only in other frames and this fit freed none.
pub fn frame_warning(fit: &Fit, samples: &Samples, settings: &Settings) -> Option<String> {
    let freed = fit.frames.as_ref().map(|_| ());
    let (frames, words) =
        freed.map_or_else(|| frames_that_fit(fit.model.robot(), samples, &settings.hold), |()| None)?;
    let names: Vec<&str> = frames.into_iter().map(RecordingParameter::name).collect();
    Some(format!("{words}: add `{}` to --free, or mend the poses", names.join(",")))
}
