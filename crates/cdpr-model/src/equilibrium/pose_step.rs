//! Steps of poses, for one or eight poses side by side, and sums over cables in the order common to both.

use crate::geometry::{POSE_ROWS, Pose};
use crate::model::Model;
use crate::scalar::{LANES, Lanes, Line, Real, Select};

/// Longest turn of a step (rad), and its longest shift relative to the mean cable length: for longer steps the linear
/// model says little about the pose reached.
const LONGEST: f64 = 0.5;

/// Lengths to which steps are compared.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measure<T> {
    /// Number of translations, which come before the rotations.
    pub(super) translations: usize,
    /// Mean cable length (m).
    pub(super) mean_length: T,
    /// Length that corresponds to one radian (m).
    pub(super) platform_radius: T,
}

impl<T: Select> Measure<T> {
    /// Shortens a step that is too long; returns its size, rotations times the platform radius (m).
    #[inline(always)]
    pub(super) fn shorten<const N: usize>(&self, amounts: &mut [T; N]) -> T {
        let l = self.mean_length;
        let (mut shift_squared, mut turn_squared) = (l.constant(0.0), l.constant(0.0));
        for k in 0..N {
            let square = amounts[k] * amounts[k];
            let sum = if k < self.translations { &mut shift_squared } else { &mut turn_squared };
            *sum = *sum + square;
        }
        let largest_squared = turn_squared.max(shift_squared / (self.mean_length * self.mean_length));
        let size = (shift_squared + self.platform_radius * self.platform_radius * turn_squared).sqrt();
        let is_long = l.constant(LONGEST * LONGEST).is_less(largest_squared);
        if !l.any(is_long) {
            return size;
        }
        let fraction = (l.constant(LONGEST) / largest_squared.sqrt()).select(is_long, l.constant(1.0));
        for amount in amounts {
            *amount = *amount * fraction;
        }
        size * fraction
    }
}

/// Twist of a step in the model's degrees of freedom.
#[inline]
pub(super) fn twist_of<const N: usize>(model: &Model, amounts: &[f64; N]) -> [f64; 6] {
    let mut twist = [0.0; 6];
    if N == 6 {
        twist.copy_from_slice(amounts);
        return twist;
    }
    for (direction, amount) in model.twist_basis().iter().zip(amounts) {
        for k in 0..6 {
            twist[k] += direction[k] * amount;
        }
    }
    twist
}

/// Pose (position, quaternion x, y, z, w) after a twist; the rotation (1, ω/2) normalised equals exp(ω) to third order
/// and needs no sine.
#[inline(always)]
pub fn turned<T: Real>(pose: [T; POSE_ROWS], twist: &[T; 6]) -> [T; POSE_ROWS] {
    let half = twist[0].constant(0.5);
    let (x, y, z) = (half * twist[3], half * twist[4], half * twist[5]);
    let [r_x, r_y, r_z, i, j, k, w] = pose;
    let [i, j, k, w] =
        [i + x * w + y * k - z * j, j - x * k + y * w + z * i, k + x * j - y * i + z * w, w - x * i - y * j - z * k];
    let norm = ((i * i + k * k) + (j * j + w * w)).sqrt();
    [r_x + twist[0], r_y + twist[1], r_z + twist[2], i / norm, j / norm, k / norm, w / norm]
}

/// [`turned`] for one pose.
#[inline]
pub(super) fn displaced<const N: usize>(model: &Model, pose: &Pose, amounts: &[f64; N]) -> Pose {
    Pose::from_numbers(turned(pose.numbers(), &twist_of(model, amounts)))
}

/// [`turned`] for eight poses.
#[inline(always)]
pub(super) fn displaced_lines<L: Lanes>(lanes: L, pose: &[Line; POSE_ROWS], twist: &[L; 6]) -> [Line; POSE_ROWS] {
    let mut numbers = [lanes; POSE_ROWS];
    for row in 0..POSE_ROWS {
        numbers[row] = lanes.load(&pose[row].0);
    }
    let numbers = turned(numbers, twist);
    let mut trial = *pose;
    for row in 0..POSE_ROWS {
        numbers[row].store(&mut trial[row].0);
    }
    trial
}

/// Replaces the accepted numbers by those of the trial in some lanes.
#[inline(always)]
pub(super) fn accept_lines<L: Lanes>(lanes: L, mask: L::Mask, accepted: &mut [Line], trial: &[Line]) {
    for (accepted, trial) in accepted.iter_mut().zip(trial) {
        lanes.load(&trial.0).select(mask, lanes.load(&accepted.0)).store(&mut accepted.0);
    }
}

/// Mean of the cable lengths of each lane (m).
#[inline(always)]
pub(super) fn mean_length<L: Lanes>(lanes: L, lengths: &[Line]) -> L {
    let mut sum = lanes.constant(0.0);
    for line in lengths {
        sum = sum + lanes.load(&line.0);
    }
    sum / lanes.constant(lengths.len() as f64)
}

/// Σ over cables of a · b, in the order of [`Lanes::sum`].
#[inline(always)]
pub(super) fn product<L: Lanes>(a: &[L; LANES], b: &[L; LANES]) -> L {
    ((a[0] * b[0] + a[4] * b[4]) + (a[1] * b[1] + a[5] * b[5]))
        + ((a[2] * b[2] + a[6] * b[6]) + (a[3] * b[3] + a[7] * b[7]))
}

/// Sum over cables in the order of [`Lanes::sum`].
#[inline(always)]
pub(super) fn sum<L: Lanes>(a: [L; LANES]) -> L {
    ((a[0] + a[4]) + (a[1] + a[5])) + ((a[2] + a[6]) + (a[3] + a[7]))
}
