//! Frames of tracker and marker that fit poses to lengths best.

use nalgebra::{DMatrix, DVector, UnitQuaternion, Vector3};

use super::forward::{Frames, platform_poses, starts};
use super::{Data, Fit};
use crate::geometry::{MotionPattern, Pose, Twist};

/// Steps allowed, and the relative decrease of the squares that ends the search.
const STEPS: usize = 30;
const DECREASE_END: f64 = 1e-6;
/// Damping at the start, and the one with which a search gives up.
const DAMPING: (f64, f64) = (1e-3, 1e6);

/// Frames that are sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Sought {
    /// The marker's alone.
    Marker,
    /// Both.
    Both,
}

/// Data with the poses to which lengths lead.
pub(crate) struct Framed<'d, 'a> {
    data: &'d Data<'a>,
    platform: Vec<(usize, Pose)>,
}

impl<'d, 'a> Framed<'d, 'a> {
    /// Data with the poses to which lengths lead, where these are enough for it.
    pub(crate) fn of(data: &'d Data<'a>) -> Self {
        Self { data, platform: platform_poses(data) }
    }

    /// Misfit of these poses with the frames of tracker and marker that fit best (m).
    pub(crate) fn misfit(&self, poses: &[Pose]) -> f64 {
        let mut all = starts(self.data, poses, &self.platform);
        all.push(Frames::none());
        let cost = |frames: &Frames| self.data.misfit(&frames.platform_poses(poses));
        let mut all: Vec<(f64, Frames)> = all.into_iter().map(|frames| (cost(&frames), frames)).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        // the best start, and the second unless the first leads to the floor
        let least = all.first().map_or(f64::INFINITY, |(least, _)| *least);
        let mut best = least;
        for (cost, frames) in all.into_iter().take(2) {
            if best < 0.2 * least || !cost.is_finite() {
                break;
            }
            best = best.min(fitted(self.data, poses, Sought::Both, frames).0);
        }
        best
    }
}

/// Misfit (m) and frames that fit poses best, from the identity.
pub(crate) fn marker_of(data: &Data<'_>) -> (f64, Frames) {
    fitted(data, &data.poses, Sought::Marker, Frames::none())
}

/// Misfit (m) and frames by damped Gauss–Newton steps from a start, with offset and scale of each cable left aside.
fn fitted(data: &Data<'_>, poses: &[Pose], sought: Sought, start: Frames) -> (f64, Frames) {
    let robot = data.robot;
    let turns = robot.motion_pattern.has_rotation();
    // without rotation the marker's place is one with the tracker's
    let marker =
        if turns || sought == Sought::Marker { robot.motion_pattern.twist_basis(robot.plane) } else { Vec::new() };
    let whole = if robot.motion_pattern.is_planar() { MotionPattern::Planar } else { MotionPattern::Spatial };
    let tracker = if sought == Sought::Both { whole.twist_basis(robot.plane) } else { Vec::new() };
    let (mut frames, mut damping) = (start, DAMPING.0);
    let mut misfit = data.misfit(&frames.platform_poses(poses));
    let mut equations = normal_equations(data, poses, &frames, &tracker, &marker);
    for _ in 0..STEPS {
        let (normal, gradient, centre) = &equations;
        let floor = 1e-12 * normal.trace().max(f64::MIN_POSITIVE);
        let mut damped = normal.clone();
        (0..damped.nrows()).for_each(|k| damped[(k, k)] += damping * normal[(k, k)] + floor);
        let Some(factor) = damped.cholesky() else { break };
        let step = factor.solve(gradient);
        let moved = frames.moved(&step, &tracker, &marker, centre);
        let found = data.misfit(&moved.platform_poses(poses));
        if found < misfit {
            let is_end = misfit - found < DECREASE_END * misfit;
            (frames, misfit, damping) = (moved, found, (0.1 * damping).max(1e-9));
            if is_end {
                break;
            }
            equations = normal_equations(data, poses, &frames, &tracker, &marker);
        } else {
            damping *= 10.0;
            if !(damping < DAMPING.1) {
                break;
            }
        }
    }
    (misfit, frames)
}

impl Frames {
    /// The frames after a step: the tracker's about a centre, the marker's in its own frame.
    fn moved(&self, step: &DVector<f64>, tracker: &[Twist], marker: &[Twist], centre: &Vector3<f64>) -> Self {
        let along = |basis: &[Twist], from: usize| -> Twist {
            basis.iter().enumerate().map(|(k, unit)| unit * step[from + k]).sum()
        };
        let (outer, inner) = (along(tracker, 0), along(marker, tracker.len()));
        let turn = UnitQuaternion::new(outer.fixed_rows::<3>(3).into_owned());
        Self {
            tracker: Pose {
                position: centre + turn * (self.tracker.position - centre) + outer.fixed_rows::<3>(0),
                rotation: turn * self.tracker.rotation,
            },
            marker: Pose {
                position: self.marker.position + inner.fixed_rows::<3>(0),
                rotation: self.marker.rotation * UnitQuaternion::new(inner.fixed_rows::<3>(3).into_owned()),
            },
        }
    }
}

/// Normal matrix, gradient, and the centre about which the tracker's frame turns.
fn normal_equations(
    data: &Data<'_>,
    poses: &[Pose],
    frames: &Frames,
    tracker: &[Twist],
    marker: &[Twist],
) -> (DMatrix<f64>, DVector<f64>, Vector3<f64>) {
    let (rows, count) = (poses.len(), tracker.len() + marker.len());
    let platform = frames.platform_poses(poses);
    let centre = platform.iter().map(|pose| pose.position).sum::<Vector3<f64>>() / rows.max(1) as f64;
    let (mut normal, mut gradient) = (DMatrix::zeros(count, count), DVector::zeros(count));
    let split = |unit: &Twist| -> (Vector3<f64>, Vector3<f64>) {
        (unit.fixed_rows::<3>(0).into(), unit.fixed_rows::<3>(3).into())
    };
    for (cable, recorded) in data.recorded.iter().enumerate() {
        let anchors = &data.robot.cables[cable];
        let modelled = data.lengths(cable, &platform);
        let fit = Fit::of(&modelled, recorded);
        let residuals = DVector::from_fn(rows, |row, _| fit.residual(modelled[row], recorded[row]));
        let mut jacobian = DMatrix::zeros(rows, count);
        for (row, pose) in platform.iter().enumerate() {
            let anchor = pose.transform(&anchors.platform_anchor);
            let u = (anchor - anchors.frame_anchor) / modelled[row].max(f64::MIN_POSITIVE);
            for (k, unit) in tracker.iter().enumerate() {
                let (shift, turn) = split(unit);
                jacobian[(row, k)] = fit.scale * u.dot(&(shift + turn.cross(&(anchor - centre))));
            }
            let outer = frames.tracker.rotation * poses[row].rotation;
            for (k, unit) in marker.iter().enumerate() {
                let (shift, turn) = split(unit);
                let moved = outer * shift + pose.rotation * turn.cross(&anchors.platform_anchor);
                jacobian[(row, tracker.len() + k)] = fit.scale * u.dot(&moved);
            }
        }
        let line = DVector::from_fn(rows, |row, _| modelled[row] - fit.means[0]);
        let square = line.norm_squared();
        for mut column in jacobian.column_iter_mut() {
            let mean = column.mean();
            column.add_scalar_mut(-mean);
            if fit.is_free {
                let along = line.dot(&column) / square;
                column.axpy(-along, &line, 1.0);
            }
        }
        normal += jacobian.tr_mul(&jacobian);
        gradient += jacobian.tr_mul(&residuals);
    }
    (normal, gradient, centre)
}
