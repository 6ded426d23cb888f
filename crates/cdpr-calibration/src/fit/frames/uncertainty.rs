//! Deviations of frames and parameters together, in the gauge of least change.

use nalgebra::{DMatrix, DVector, Vector3};

use super::directions::{Direction, is_anchor};
use super::elimination::least_change;
use super::estimate::{FrameEstimate, Gauge, RecordingFrames};
use super::poses::Frames;
use super::search::Found;
use crate::fit::{Fit, Settings};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::RecordingParameter;
use cdpr_model::robot::Parameter;

/// Adds the frames to a fit in them, and their uncertainty to that of its parameters.
pub(super) fn complete(fit: &mut Fit, found: &Found, freed: &[RecordingParameter], settings: &Settings) {
    let parameters: Vec<Parameter> = fit.parameters.iter().map(|estimate| estimate.parameter).collect();
    let joint = Joint::of(fit, found, &parameters);
    joint.write(fit, found);
    weak(fit, found, settings.weak_direction_limit);
    let estimate = |frame: RecordingParameter, pose: &Pose, motion: &dyn Fn(&Direction) -> Twist| {
        freed.contains(&frame).then(|| joint.estimate(found, frame, pose, motion))
    };
    let Frames { tracker, marker, .. } = found.frames;
    let of_tracker = |direction: &Direction| {
        let arm = tracker.position - found.directions.middle;
        moved_about(&direction.motion, &arm)
    };
    // the marker moves against the platform as the platform does not
    let of_marker = |direction: &Direction| moved_about(&-direction.motion, &marker.position);
    fit.frames = Some(RecordingFrames {
        frames: found.frames,
        tracker: estimate(RecordingParameter::TrackerFrame, &tracker, &of_tracker),
        marker: estimate(RecordingParameter::MarkerFrame, &marker, &of_marker),
        gauge: gauge(found),
    });
}

/// Motion of a point at an arm from where a twist is given.
fn moved_about(twist: &Twist, arm: &Vector3<f64>) -> Twist {
    let turn = Vector3::from(twist.fixed_rows::<3>(3));
    let shift = twist.fixed_rows::<3>(0) + turn.cross(arm);
    Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z)
}

/// Directions that no row resists, in words.
fn gauge(found: &Found) -> Gauge {
    let free = &found.eliminated.free;
    let rows = |turning: bool| {
        let list = &found.directions.list;
        let is_of = |k: &usize| (list[*k].motion.fixed_rows::<3>(3).norm() > 0.0) == turning;
        free.select_rows(&(0..free.nrows()).filter(is_of).collect::<Vec<usize>>())
    };
    let rank = |matrix: DMatrix<f64>| if matrix.is_empty() { 0 } else { matrix.rank(1e-6) };
    let (directions, turning) = (free.ncols(), rank(rows(true)));
    let mut words = Vec::new();
    words.extend((directions > turning).then_some("translation"));
    words.extend((turning > 0).then_some("rotation"));
    Gauge { kind: "least-change", free: words, directions }
}

/// Names the directions of frames that the data hardly tell.
fn weak(fit: &mut Fit, found: &Found, limit: f64) {
    let noise = fit.analysis.inflation;
    for (k, deviation) in found.eliminated.deviations.iter().enumerate() {
        let deviation = noise * deviation;
        if deviation <= limit {
            continue;
        }
        let fraction = |frame: RecordingParameter| {
            let of_frame = |place: &usize| found.directions.list[*place].frame == frame;
            let places = (0..found.directions.list.len()).filter(of_frame);
            places.map(|place| found.eliminated.told[(place, k)].powi(2)).sum::<f64>()
        };
        let names = RecordingParameter::FRAMES.into_iter().filter(|frame| fraction(*frame) > 0.1);
        let names: Vec<&str> = names.map(RecordingParameter::name).collect();
        let analysis = &mut fit.analysis;
        analysis.weak_directions.push(format!(
            "{} (± {deviation:.2} m, rotations times their arm): turn the platform more while measuring",
            names.join(" with ")
        ));
        analysis.weak_direction_count += 1;
        analysis.weak_deviation = analysis.weak_deviation.max(deviation);
    }
}

/// Covariance of parameters and frames.
struct Joint {
    /// Parameters first, then the directions of the frames.
    covariance: DMatrix<f64>,
    count: usize,
}

impl Joint {
    /// In the gauge of least change (free-network adjustment, Baarda 1973): what the free directions would move is taken out of every error.
    fn of(fit: &Fit, found: &Found, parameters: &[Parameter]) -> Self {
        let eliminated = &found.eliminated;
        let (count, frames) = (parameters.len(), found.directions.list.len());
        let nothing = || DMatrix::zeros(count + frames, count + frames);
        let mut covariance = eliminated.covariance(&found.fitted, fit.analysis.inflation).unwrap_or_else(nothing);
        let together = |along: &DMatrix<f64>| {
            let mut stacked = (&eliminated.following * along).resize_vertically(count + frames, 0.0);
            stacked.rows_mut(count, frames).copy_from(along);
            stacked
        };
        if eliminated.free.ncols() > 0 {
            let (moved, anchors) = (together(&eliminated.free), eliminated.anchors_by_free(parameters));
            let mut projection: DMatrix<f64> = DMatrix::identity(count + frames, count + frames);
            for k in 0..count {
                let mut unit = DVector::zeros(count);
                unit[k] = f64::from(u8::from(is_anchor(&parameters[k])));
                let taken = &moved * least_change(&anchors, &unit);
                let mut column = projection.column_mut(k);
                column += taken;
            }
            covariance = &projection * covariance * projection.transpose();
        }
        Self { covariance, count }
    }

    /// Writes deviations and correlations of the parameters.
    fn write(&self, fit: &mut Fit, found: &Found) {
        let deviation = |k: usize| self.covariance[(k, k)].max(0.0).sqrt();
        let is_known: Vec<bool> = fit.parameters.iter().map(|estimate| estimate.sigma.is_some()).collect();
        for (k, estimate) in fit.parameters.iter_mut().enumerate().filter(|(k, _)| found.eliminated.moves(*k)) {
            estimate.sigma = estimate.sigma.map(|_| deviation(k));
        }
        let coefficient = |i: usize, j: usize| match is_known[i] && is_known[j] {
            true => self.covariance[(i, j)] / (deviation(i) * deviation(j)),
            false => f64::NAN,
        };
        let rows = (0..self.count).map(|i| (0..=i).map(|j| coefficient(i, j)).collect()).collect();
        fit.analysis.set_correlations(rows, &|k| fit.parameters[k].name.clone());
    }

    fn estimate(
        &self,
        found: &Found,
        frame: RecordingParameter,
        pose: &Pose,
        motion: &dyn Fn(&Direction) -> Twist,
    ) -> FrameEstimate {
        let list = &found.directions.list;
        let places: Vec<usize> = (0..list.len()).filter(|place| list[*place].frame == frame).collect();
        let mut by_directions = DMatrix::zeros(6, places.len());
        for (column, &place) in places.iter().enumerate() {
            by_directions.column_mut(column).copy_from(&motion(&list[place]));
        }
        let rows: Vec<usize> = places.iter().map(|place| self.count + place).collect();
        let own = self.covariance.select_rows(&rows).select_columns(&rows);
        let covariance = &by_directions * own * by_directions.transpose();
        let deviations = |first: usize| [0, 1, 2].map(|k| covariance[(first + k, first + k)].max(0.0).sqrt());
        let coordinates = &pose.rotation.coords;
        FrameEstimate {
            position_m: pose.position.into(),
            rotation_rad: pose.xyz_angles(),
            quaternion_xyzw: [coordinates.x, coordinates.y, coordinates.z, coordinates.w],
            sigma_position_m: deviations(0),
            sigma_rotation_rad: deviations(3),
        }
    }
}
