//! Logs reduced to samples at rest: the rows of one pose become one sample, their mean.

use std::f64::consts::PI;
use std::fmt;

use nalgebra::{Quaternion, UnitQuaternion, Vector3, Vector4};

use crate::geometry::Pose;
use crate::robot::Robot;

use super::digits::three_digits;
use super::holds::{HELD, LONGEST_PAUSE, Log, typical_interval};
use super::{DataError, Samples, SensorSigmas};

/// Fraction of the diagonal within which a moving platform counts as quasi-static: the mean of an arc lies off it by
/// 1e-5 of its radius.
const WINDOW_SHARE: f64 = 0.01;
/// Least number of held poses for which the other rows of a log count as motion between them.
const FEWEST_HELD: usize = 2;

/// Outcome of the reduction of a log to samples at rest.
#[derive(Clone, Debug)]
pub struct StaticSamples {
    /// One sample per pose: the means of its rows, with line and set of the first row and the mean time.
    pub samples: Samples,
    /// True if poses were held; otherwise the platform moved, and each sample is the mean over a short distance.
    pub is_held: bool,
    /// Number of averaged rows, and of rows between held poses, which are left out.
    pub rows: (usize, usize),
    /// Scatter of single rows about the means of their samples, per axis; `None` for a quantity without scatter.
    pub scatter: SensorSigmas,
    /// True if the scatter is used as accuracy, since none was stated. It is the scatter of a row, not of a mean:
    /// errors that prevent poses from being repeated do not average out while a pose is held.
    pub takes_scatter: bool,
}

impl fmt::Display for StaticSamples {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (count, (averaged, left_out)) = (self.samples.len(), self.rows);
        if !self.is_held {
            return write!(
                formatter,
                "fewer than {FEWEST_HELD} poses are held for {HELD} s: the motion is cut into {count} quasi-static samples, means of {averaged} rows"
            );
        }
        write!(formatter, "{count} poses are held, each the mean of {:.0} rows", averaged as f64 / count as f64)?;
        write!(formatter, "; {left_out} rows of the ways between are left out; a row scatters about its pose by")?;
        let SensorSigmas { position, rotation, length, tension, .. } = self.scatter;
        let known =
            [(position, 1e3, "mm"), (rotation, 1e3, "mrad"), (length, 1e3, "mm of length"), (tension, 1.0, "N")];
        let parts = known
            .iter()
            .filter_map(|(value, factor, unit)| Some(format!(" {} {unit}", three_digits((*value)? * factor))));
        write!(formatter, "{}", parts.collect::<Vec<_>>().join(","))?;
        if self.takes_scatter {
            write!(formatter, ", taken for the accuracy of the sensors since none is stated")
        } else {
            Ok(())
        }
    }
}

impl Samples {
    /// The samples of a log over time: poses held for a second or more, each the mean of its rows. If fewer than two
    /// are held, the motion is cut into pieces within a hundredth of the robot's size.
    pub fn at_rest(&self, robot: &Robot) -> Result<StaticSamples, DataError> {
        let Some(time) = self.time.as_ref().filter(|_| !self.is_empty()) else { return Err(DataError::NoTimes) };
        let diagonal = robot.anchor_diagonal();
        let cutter = Cutter { samples: self, time, pause: LONGEST_PAUSE * typical_interval(time) };
        let held: Vec<(usize, usize)> =
            Log::new(self, time, diagonal).holds().into_iter().map(|rows| (rows.start, rows.end)).collect();
        let is_held = held.len() >= FEWEST_HELD;
        let pieces = if is_held { held } else { cutter.pieces(WINDOW_SHARE * diagonal, HELD) };
        let averaged: usize = pieces.iter().map(|(start, end)| end - start).sum();
        let mut samples = self.averaged(&pieces);
        let scatter = self.scatter(&samples, &pieces, robot);
        let is_whole = scatter.position.is_some() && scatter.length.is_some();
        let takes_scatter = is_held && is_whole && self.sigmas == SensorSigmas::default();
        if takes_scatter {
            samples.sigmas = scatter;
        }
        Ok(StaticSamples { samples, is_held, rows: (averaged, self.len() - averaged), scatter, takes_scatter })
    }

    /// One sample per range of rows.
    fn averaged(&self, pieces: &[(usize, usize)]) -> Self {
        let m = self.cable_count;
        let mean = |data: &[f64], width: usize| -> Vec<f64> {
            let of_piece = |&(start, end): &(usize, usize)| {
                (0..width)
                    .map(move |k| (start..end).map(|row| data[row * width + k]).sum::<f64>() / (end - start) as f64)
            };
            pieces.iter().flat_map(of_piece).collect()
        };
        let starts: Vec<usize> = pieces.iter().map(|(start, _)| *start).collect();
        Self {
            poses: pieces.iter().map(|&(start, end)| mean_pose(&self.poses[start..end])).collect(),
            lengths: mean(&self.lengths, m),
            motor_angles: self.motor_angles.as_deref().map(|angles| mean(angles, m)),
            tensions: self.tensions.as_deref().map(|tensions| mean(tensions, m)),
            time: self.time.as_deref().map(|time| mean(time, 1)),
            angles: self
                .angles
                .as_deref()
                .map(|angles| pieces.iter().map(|&(a, b)| mean_angles(&angles[a..b])).collect()),
            ..self.subset(&starts)
        }
    }

    /// Pooled standard deviations of rows about their sample's mean.
    fn scatter(&self, means: &Self, pieces: &[(usize, usize)], robot: &Robot) -> SensorSigmas {
        let freedom: usize = pieces.iter().map(|(start, end)| end - start - 1).sum();
        let rows =
            || pieces.iter().enumerate().flat_map(|(sample, &(start, end))| (start..end).map(move |row| (sample, row)));
        let pooled = |squares: f64, axes: usize| {
            let variance = squares / (freedom * axes).max(1) as f64;
            (freedom > 0 && axes > 0 && variance > 0.0).then(|| variance.sqrt())
        };
        let pattern = robot.motion_pattern;
        let turns = pattern.dof() - pattern.translations();
        let apart = |(sample, row): (usize, usize)| means.poses[sample].displacement_to(&self.poses[row]);
        let part = |from: usize| rows().map(|at| apart(at).fixed_rows::<3>(from).norm_squared()).sum::<f64>();
        let m = self.cable_count;
        let of_cables = |mean: &[f64], all: &[f64]| {
            let square = |(sample, row): (usize, usize)| {
                (0..m).map(|k| (all[row * m + k] - mean[sample * m + k]).powi(2)).sum::<f64>()
            };
            pooled(rows().map(square).sum(), m)
        };
        SensorSigmas {
            position: pooled(part(0), pattern.translations()),
            rotation: pooled(part(3), turns),
            length: of_cables(&means.lengths, &self.lengths),
            tension: means
                .tensions
                .as_deref()
                .zip(self.tensions.as_deref())
                .and_then(|(mean, all)| of_cables(mean, all)),
            swivel: None,
            length_scale: None,
            balance_force: None,
            balance_moment: None,
        }
    }
}

/// Means of angles that may jump by full turns (rad).
fn mean_angles(rows: &[[f64; 3]]) -> [f64; 3] {
    let first = rows.first().copied().unwrap_or_default();
    let turned = |from: f64, to: f64| (to - from + PI).rem_euclid(2.0 * PI) - PI;
    std::array::from_fn(|k| {
        let sum: f64 = rows.iter().map(|angles| turned(first[k], angles[k])).sum();
        first[k] + sum / rows.len().max(1) as f64
    })
}

/// A log that is cut into pieces.
struct Cutter<'a> {
    samples: &'a Samples,
    time: &'a [f64],
    /// Intervals longer than this end a piece (s).
    pause: f64,
}

impl Cutter<'_> {
    /// Ranges of rows within a distance of their first one (m) and within a duration (s).
    fn pieces(&self, distance: f64, longest: f64) -> Vec<(usize, usize)> {
        let (mut pieces, mut start) = (Vec::new(), 0);
        for row in 1..=self.samples.len() {
            let goes_on = row < self.samples.len()
                && (0.0..=self.pause).contains(&(self.time[row] - self.time[row - 1]))
                && self.time[row] - self.time[start] <= longest
                && self.is_near(start, row, distance);
            if !goes_on {
                pieces.push((start, row));
                start = row;
            }
        }
        pieces
    }

    /// True if lengths and position of two rows differ by no more than a distance (m); only the position if motor
    /// angles were recorded.
    fn is_near(&self, first: usize, second: usize, distance: f64) -> bool {
        let [a, b] = [first, second].map(|row| self.samples.poses[row].position);
        let [q, r] = [first, second].map(|row| self.samples.lengths_of(row));
        (a - b).norm() <= distance && q.iter().zip(r).all(|(q, r)| !((q - r).abs() > distance))
    }
}

/// Mean of poses that are close to each other.
fn mean_pose(poses: &[Pose]) -> Pose {
    let count = poses.len() as f64;
    let position = poses.iter().map(|pose| pose.position).sum::<Vector3<f64>>() / count;
    let first = poses[0].rotation.coords;
    // q and −q are the same orientation
    let signed = poses.iter().map(|pose| pose.rotation.coords * pose.rotation.coords.dot(&first).signum());
    let rotation = UnitQuaternion::new_normalize(Quaternion::from(signed.sum::<Vector4<f64>>()));
    Pose { position, rotation: if poses.len() == 1 { poses[0].rotation } else { rotation } }
}
