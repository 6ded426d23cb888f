//! Least squares of a few unknowns: Gauss-Newton steps with damping, derivatives by differences.

use crate::pose::Pose;

/// Unknowns of a pose: axes of its position, and whether it turns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Freedom {
    pub(crate) axes: &'static [usize],
    pub(crate) turns: bool,
}

impl Freedom {
    fn count(self) -> usize {
        self.axes.len() + if self.turns { 3 } else { 0 }
    }

    /// A pose after a step of all unknowns.
    fn stepped(self, pose: &Pose, step: &[f64]) -> Pose {
        let (mut translation, mut rotation) = ([0.0; 3], [0.0; 3]);
        self.axes.iter().zip(step).for_each(|(&axis, by)| translation[axis] = *by);
        rotation.iter_mut().zip(&step[self.axes.len()..]).for_each(|(angle, by)| *angle = *by);
        pose.moved(translation, rotation)
    }
}

/// The pose near a guess with the least squares of residuals; the best one found where they do not settle.
pub(crate) fn nearest(freedom: Freedom, guess: &Pose, residuals: impl Fn(&Pose) -> Vec<f64>) -> Pose {
    let (mut pose, count) = (*guess, freedom.count());
    let cost = |pose: &Pose| residuals(pose).iter().map(|residual| residual * residual).sum::<f64>();
    let (mut least, mut damping) = (cost(&pose), 1e-9);
    for _ in 0..200 {
        let current = residuals(&pose);
        let slopes: Vec<Vec<f64>> = (0..count).map(|unknown| slope(freedom, &pose, unknown, &residuals)).collect();
        let inner = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut normal: Vec<Vec<f64>> = slopes.iter().map(|a| slopes.iter().map(|b| inner(a, b)).collect()).collect();
        let right: Vec<f64> = slopes.iter().map(|a| -inner(a, &current)).collect();
        let scale = (0..count).map(|unknown| normal[unknown][unknown]).fold(0.0, f64::max);
        (0..count).for_each(|unknown| normal[unknown][unknown] += damping * scale);
        let Some(step) = solved(normal, right) else { return pose };
        let trial = freedom.stepped(&pose, &step);
        let trial_cost = cost(&trial);
        if trial_cost <= least {
            (pose, least, damping) = (trial, trial_cost, (damping * 0.1).max(1e-12));
            if inner(&step, &step).sqrt() < 1e-10 {
                break;
            }
        } else {
            damping = (damping * 10.0).max(1e-9);
            if damping > 1e6 {
                break;
            }
        }
    }
    pose
}

/// Central difference of all residuals by one unknown.
fn slope(freedom: Freedom, pose: &Pose, unknown: usize, residuals: impl Fn(&Pose) -> Vec<f64>) -> Vec<f64> {
    let width = 1e-6;
    let mut step = vec![0.0; freedom.count()];
    step[unknown] = width;
    let ahead = residuals(&freedom.stepped(pose, &step));
    step[unknown] = -width;
    let behind = residuals(&freedom.stepped(pose, &step));
    ahead.iter().zip(&behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * width)).collect()
}

/// Elimination with the largest pivot of the column; `None` for singular equations.
pub(crate) fn solved(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let count = right.len();
    for column in 0..count {
        let pivot = (column..count).max_by(|&a, &b| matrix[a][column].abs().total_cmp(&matrix[b][column].abs()))?;
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        let head = matrix[column].clone();
        // zero, or no number
        if !(head[column].abs() > 1e-300) {
            return None;
        }
        for row in column + 1..count {
            let factor = matrix[row][column] / head[column];
            matrix[row].iter_mut().zip(&head).for_each(|(number, of_head)| *number -= factor * of_head);
            right[row] -= factor * right[column];
        }
    }
    for row in (0..count).rev() {
        let known: f64 = (row + 1..count).map(|column| matrix[row][column] * right[column]).sum();
        right[row] = (right[row] - known) / matrix[row][row];
    }
    Some(right)
}
