//! Points of linearisation of the rows: the poses and tensions that the model and the measurements agree on best.
//!
//! Derivatives at the measured values are themselves noisy, and their noise is that of the residuals: taken there, they pull
//! parameters towards wrong values however many samples there are. So poses and tensions are corrected along with the
//! parameters, z = z_M − D Nᵀ Σ⁻¹ (r + N (z_M − z)), the adjustment of observations known from geodesy (Gauss–Helmert model)
//! and orthogonal distance regression.

use super::measurement_noise::{invert, solve};
use super::noise::{Noise, Sigmas};
use super::normal::{NormalEquations, whiten};
use super::rows::{RowModel, SampleRows};
use crate::loss::RobustLoss;
use crate::recorded::Recorded;
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::scalar::LANES;
use cdpr_model::scalar::cholesky::LowerTriangle;

/// Points of linearisation with the weights there.
#[derive(Clone, Debug)]
pub(super) struct Linearization {
    /// Rows of one sample.
    count: usize,
    /// Rows of all samples that say something.
    informative_rows: usize,
    /// Corrected poses.
    poses: Vec<Pose>,
    /// Corrected recorded tensions, sample by sample (N).
    tensions: Vec<f64>,
    /// N (z_M − z) of every row.
    shifts: Vec<f64>,
    /// Lower Cholesky factors of Σ, row-major with inverted diagonals, sample by sample.
    factors: Vec<f64>,
    /// Σ⁻¹, row-major with rows rounded up to whole lanes, sample by sample.
    weights: Vec<f64>,
}

/// Point at which the rows of a sample are linearized.
pub(super) struct Place<'a> {
    /// Corrected pose and tensions (N).
    pub(super) pose: &'a Pose,
    pub(super) tensions: &'a [f64],
    /// Factor of the covariance of the rows.
    pub(super) factor: &'a [f64],
    /// N (z_M − z) of each row.
    pub(super) shifts: &'a [f64],
}

impl Linearization {
    /// At the measured values, with the weights at a model's parameters; `None` when a covariance is not positive definite,
    /// which only numbers that are not finite can make it.
    pub(super) fn measured(model: &RowModel<'_>, samples: &Samples, tensions: &[f64], sigmas: &Sigmas) -> Option<Self> {
        let count = model.model.dof() + model.model.cable_count();
        let mut linearization = Self {
            count,
            informative_rows: 0,
            poses: samples.poses.clone(),
            tensions: tensions.to_vec(),
            shifts: vec![0.0; samples.len() * count],
            factors: vec![0.0; samples.len() * count * count],
            weights: vec![0.0; samples.len() * count * count.next_multiple_of(LANES)],
        };
        let m = model.model.cable_count();
        let mut noise = Noise::new(model.model);
        let (mut triangle, mut columns) = (LowerTriangle::new(count), Vec::new());
        let mut scratch = vec![0.0; count * count.next_multiple_of(LANES)];
        let weights = linearization.weights.chunks_mut(count * count.next_multiple_of(LANES));
        for ((sample, factor), weight) in linearization.factors.chunks_mut(count * count).enumerate().zip(weights) {
            model.noise(&samples.poses[sample], &tensions[sample * m..][..m], sigmas, &mut noise);
            linearization.informative_rows += noise.informative_rows();
            noise.factor(&mut triangle, &mut columns, factor)?;
            invert(factor, count, &mut scratch, weight);
        }
        Some(linearization)
    }

    /// At the measured values, with a weight of its own for each row of a sample.
    pub(super) fn weighted(model: &Model, samples: &Samples, tensions: &[f64], weights: &[f64]) -> Self {
        let (count, padded) = (weights.len(), weights.len().next_multiple_of(LANES));
        let (mut factor, mut square) = (vec![0.0; count * count], vec![0.0; count * padded]);
        for (row, weight) in weights.iter().enumerate() {
            (factor[row * (count + 1)], square[row * (padded + 1)]) = (*weight, weight * weight);
        }
        debug_assert_eq!(count, model.dof() + model.cable_count());
        Self {
            count,
            informative_rows: samples.len() * count,
            poses: samples.poses.clone(),
            tensions: tensions.to_vec(),
            shifts: vec![0.0; samples.len() * count],
            factors: factor.repeat(samples.len()),
            weights: square.repeat(samples.len()),
        }
    }

    /// Corrects poses and tensions for a model's parameters, and weighs there.
    pub(super) fn correct(
        &mut self,
        model: &RowModel<'_>,
        samples: &Samples,
        tensions: &[f64],
        sigmas: &Sigmas,
    ) -> Option<()> {
        let (count, m) = (self.count, model.model.cable_count());
        let basis = model.model.twist_basis();
        let mut noise = Noise::new(model.model);
        let (mut triangle, mut columns) = (LowerTriangle::new(count), Vec::new());
        let (mut residual, mut shift) = (vec![0.0; count], ([0.0; 6], vec![0.0; m]));
        let mut scratch = vec![0.0; count * count.next_multiple_of(LANES)];
        self.informative_rows = 0;
        for sample in 0..samples.len() {
            let factor = &mut self.factors[sample * count * count..][..count * count];
            let corrected = &mut self.tensions[sample * m..][..m];
            let recorded = Recorded::of(samples, sample);
            model.noise_at(&self.poses[sample], corrected, sigmas, &mut noise, Some((recorded, &mut residual)));
            self.informative_rows += noise.informative_rows();
            noise.factor(&mut triangle, &mut columns, factor)?;
            let size = scratch.len();
            invert(factor, count, &mut scratch, &mut self.weights[sample * size..][..size]);
            // r + N (z_M − z), with the displacement in standard deviations
            let towards = self.poses[sample].displacement_to(&samples.poses[sample]);
            let per_sigma = |along: f64, sigma: f64| if sigma > 0.0 { along / sigma } else { 0.0 };
            for (k, twist) in basis.iter().enumerate() {
                shift.0[k] = per_sigma(twist.dot(&towards), sigmas.along(twist));
            }
            for cable in 0..m {
                shift.1[cable] = per_sigma(tensions[sample * m + cable] - corrected[cable], sigmas.tension);
            }
            noise.forth(&shift.0, &shift.1, &mut residual);
            solve(factor, &mut residual);
            // z_M − z = D Nᵀ Σ⁻¹ (r + N (z_M − z))
            noise.back(&residual, &mut shift.0, &mut shift.1);
            let mut back = Twist::zeros();
            basis.iter().zip(shift.0).for_each(|(twist, amount)| back -= twist * (amount * sigmas.along(twist)));
            self.poses[sample] = samples.poses[sample].displaced(&back);
            for cable in 0..m {
                corrected[cable] = tensions[sample * m + cable] - sigmas.tension * shift.1[cable];
            }
            let shifts = &mut self.shifts[sample * count..][..count];
            shifts.fill(0.0);
            noise.forth(&shift.0, &shift.1, shifts);
        }
        Some(())
    }

    /// Writes the rows of a sample.
    pub(super) fn write(&self, model: &RowModel<'_>, samples: &Samples, sample: usize, rows: &mut SampleRows) {
        let m = model.model.cable_count();
        let tensions = &self.tensions[sample * m..][..m];
        model.write(&self.poses[sample], tensions, Recorded::of(samples, sample), rows);
        for (row, shift) in self.shifts[sample * self.count..][..self.count].iter().enumerate() {
            rows.add_to_residual(row, *shift);
        }
    }

    /// Writes the rows of a sample, whitened.
    pub(super) fn write_whitened(&self, model: &RowModel<'_>, samples: &Samples, sample: usize, rows: &mut SampleRows) {
        self.write(model, samples, sample, rows);
        self.whiten(sample, rows);
    }

    /// Whitens the rows of a sample.
    pub(super) fn whiten(&self, sample: usize, rows: &mut SampleRows) {
        whiten(self.factor(sample), rows);
    }

    /// Adds all samples to normal equations, under a robust loss with the weights of this place.
    pub(super) fn add_to(
        &self,
        model: &RowModel<'_>,
        samples: &Samples,
        loss: Option<RobustLoss>,
        rows: &mut SampleRows,
        equations: &mut NormalEquations,
    ) {
        let size = self.count * self.count.next_multiple_of(LANES);
        for (sample, weight) in self.weights.chunks(size).enumerate() {
            self.write(model, samples, sample, rows);
            if let Some(loss) = loss {
                let square = rows.square(weight);
                let fraction = loss.weight(square);
                rows.scale(fraction.sqrt());
                equations.add_to_cost(loss.cost(square) - fraction * square);
            }
            equations.add(weight, rows);
        }
    }

    /// Squared norms rᵀ Σ⁻¹ r of all samples.
    pub(super) fn squares(&self, model: &RowModel<'_>, samples: &Samples) -> Vec<f64> {
        let size = self.count * self.count.next_multiple_of(LANES);
        let mut rows = SampleRows::new(model.model, 0);
        let bare = RowModel::new(model.model, model.load, &[]);
        let square = |(sample, weight): (usize, &[f64])| {
            self.write(&bare, samples, sample, &mut rows);
            rows.square(weight)
        };
        self.weights.chunks(size).enumerate().map(square).collect()
    }

    /// Place of a sample of so many cables.
    pub(super) fn place(&self, sample: usize, cables: usize) -> Place<'_> {
        Place {
            pose: &self.poses[sample],
            tensions: &self.tensions[sample * cables..][..cables],
            factor: self.factor(sample),
            shifts: &self.shifts[sample * self.count..][..self.count],
        }
    }

    /// Standard deviations of the rows of a sample, each given those before it.
    pub(super) fn deviations(&self, sample: usize) -> impl Iterator<Item = f64> {
        self.factor(sample).iter().step_by(self.count + 1).map(|inverse| 1.0 / inverse)
    }

    fn factor(&self, sample: usize) -> &[f64] {
        let size = self.count * self.count;
        &self.factors[sample * size..][..size]
    }

    /// Rows of all samples that say something: all but the length rows of slack cables.
    pub(super) fn informative_rows(&self) -> usize {
        self.informative_rows
    }

    /// The same for covariances multiplied by the square of `scale`.
    pub(super) fn scale_weights(&mut self, scale: f64) {
        if scale == 1.0 {
            return;
        }
        self.weights.iter_mut().for_each(|weight| *weight /= scale * scale);
        for factor in self.factors.chunks_mut(self.count * self.count) {
            for row in 0..self.count {
                for column in 0..row {
                    factor[row * self.count + column] *= scale;
                }
                factor[row * self.count + row] /= scale;
            }
        }
    }

    /// Largest relative change of a row's own weight.
    pub(super) fn distance_to(&self, other: &Self) -> f64 {
        let size = self.count * self.count;
        let diagonal = |index: &usize| (index % size).is_multiple_of(self.count + 1);
        (0..self.factors.len())
            .filter(diagonal)
            .map(|index| (other.factors[index] / self.factors[index] - 1.0).abs())
            .fold(0.0, f64::max)
    }
}
