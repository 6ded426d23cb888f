//! How the errors of what is measured reach the rows of a sample.

use crate::geometry::Twist;
use crate::model::Model;

/// Derivatives of one sample's rows by what is measured, scaled to standard deviations.
#[derive(Clone, Debug)]
pub(super) struct Noise {
    /// Each row by the directions of the pattern.
    pub(super) by_pose: Vec<[f64; 6]>,
    /// For each cable the n wrench rows and its length row by its tension.
    pub(super) by_tension: Vec<[f64; 7]>,
    /// Standard deviation of each length row by the recorded length itself.
    pub(super) length: Vec<f64>,
}

impl Noise {
    pub(super) fn new(model: &Model) -> Self {
        let (m, n) = (model.cable_count(), model.dof());
        Self { by_pose: vec![[0.0; 6]; n + m], by_tension: vec![[0.0; 7]; m], length: vec![0.0; m] }
    }

    /// Number of rows that say something: all but the length rows of slack cables.
    pub(super) fn informative_rows(&self) -> usize {
        self.by_pose.len() - self.length.iter().filter(|&&sigma| sigma >= SLACK_SIGMA).count()
    }

    /// Writes N diag(σ²) Nᵀ, lower triangle, to a row-major matrix.
    pub(super) fn covariance(&self, covariance: &mut [f64]) {
        let (count, m) = (self.by_pose.len(), self.length.len());
        let n = count - m;
        for i in 0..count {
            for j in 0..=i {
                let products = (0..6).map(|k| self.by_pose[i][k] * self.by_pose[j][k]);
                covariance[i * count + j] = products.sum::<f64>();
            }
        }
        for (cable, by_tension) in self.by_tension.iter().enumerate() {
            for i in 0..n {
                for j in 0..=i {
                    covariance[i * count + j] += by_tension[i] * by_tension[j];
                }
            }
            let length_row = &mut covariance[(n + cable) * count..][..count];
            (0..n).for_each(|j| length_row[j] += by_tension[n] * by_tension[j]);
            length_row[n + cable] += by_tension[n] * by_tension[n] + self.length[cable] * self.length[cable];
        }
    }

    /// Nᵀ y in standard deviations: along the directions of the pose, then per cable.
    pub(super) fn back(&self, y: &[f64], pose: &mut [f64; 6], tensions: &mut [f64]) {
        let n = self.by_pose.len() - self.length.len();
        *pose = std::array::from_fn(|k| self.by_pose.iter().zip(y).map(|(row, y)| row[k] * y).sum());
        for (cable, by_tension) in self.by_tension.iter().enumerate() {
            tensions[cable] = (0..n).map(|k| by_tension[k] * y[k]).sum::<f64>() + by_tension[n] * y[n + cable];
        }
    }

    /// N z for displacements in standard deviations, added to `rows`.
    pub(super) fn forth(&self, pose: &[f64; 6], tensions: &[f64], rows: &mut [f64]) {
        let n = self.by_pose.len() - self.length.len();
        for (row, by_pose) in rows.iter_mut().zip(&self.by_pose) {
            *row += (0..6).map(|k| by_pose[k] * pose[k]).sum::<f64>();
        }
        for (cable, by_tension) in self.by_tension.iter().enumerate() {
            (0..n).for_each(|k| rows[k] += by_tension[k] * tensions[cable]);
            rows[n + cable] += by_tension[n] * tensions[cable];
        }
    }
}

/// Standard deviation of a length row that says nothing (m).
pub(super) const SLACK_SIGMA: f64 = 1e3;

/// Standard deviations of everything measured, as the weights use them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sigmas {
    /// Per axis (m).
    pub(super) position: f64,
    /// Per axis (rad).
    pub(super) rotation: f64,
    /// (m)
    pub(super) length: f64,
    /// (N)
    pub(super) tension: f64,
}

impl Sigmas {
    /// Of the direction of a motion pattern: a turn or a shift.
    pub(super) fn along(&self, twist: &Twist) -> f64 {
        if twist.fixed_rows::<3>(3).norm_squared() > 0.0 { self.rotation } else { self.position }
    }
}
