//! Vectors of lengths and poses together, each in its accuracy: measured poses are unknowns, of which every sample takes the best.
//!
//! r = [ρ/σ_q; M e] at the pose x that makes ‖r‖² least, ρ the length residuals there and e its distance from the measured pose (total least squares).
//! The poses are eliminated by variable projection: the derivative is that of Kaufman (1975), J_p without what J_x explains. It gives the exact gradient, since
//! nothing of r is along J_x at the best pose, and leaves second derivatives times residuals out, as every Gauss–Newton step does.

use nalgebra::{DMatrix, DVector};

use super::Given;
use super::lengths::LengthRows;
use super::metric::{Metric, by_turn};
use super::rows::{Layout, Rows};
use super::{Outliers, Residual};
use crate::fit::InputError;
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::statics::unit_spring_state;

/// Most Gauss–Newton steps of a pose; each gains some four digits.
const STEPS: u32 = 30;
/// Step at which a pose is found, in standard deviations, relative to a larger norm of its residuals.
const FOUND: f64 = 1e-10;

/// Residuals of lengths and of poses at the best poses, m + n a sample.
pub(super) struct UnknownPoses<'a> {
    model: Model,
    samples: &'a Samples,
    parameters: &'a [Parameter],
    metric: Metric,
    /// 1/σ_q (1/m).
    per_length: f64,
    lengths: LengthRows,
    /// Length rows at the poses.
    at: Rows,
}

impl<'a> UnknownPoses<'a> {
    pub(super) fn new(given: &Given<'a, '_>) -> Result<Self, InputError> {
        let Given { model, samples, parameters, settings } = *given;
        if model.needs_tensions() {
            return Err(InputError::UnknownPosesOfElastic);
        }
        let known = |sigma: Option<f64>| sigma.filter(|sigma| *sigma > 0.0);
        let (Some(sigma), Some(_)) = (known(samples.sigmas.length), known(samples.sigmas.position)) else {
            return Err(InputError::NoAccuracies);
        };
        let metric = Metric::of(model, samples, settings.rotation_length)?;
        let lengths = LengthRows::even(model, samples, parameters, sigma);
        let at = Rows::new(Layout::of(samples.len(), model.cable_count()), parameters.len());
        Ok(Self { model: model.clone(), samples, parameters, metric, per_length: 1.0 / sigma, lengths, at })
    }

    fn try_write(&mut self, values: &[f64], rows: &mut Rows) -> Option<()> {
        let model = self.model.with_parameters(self.parameters, values)?;
        let mut poses = self.samples.poses.clone();
        let mut is_found = false;
        for _ in 0..STEPS {
            self.lengths.move_to(&poses);
            self.lengths.write(values, &mut self.at).then_some(())?;
            if is_found {
                break;
            }
            let mut largest = 0.0_f64;
            for (sample, pose) in poses.iter_mut().enumerate() {
                let (step, size) = self.step(&model, sample, pose)?;
                *pose = pose.displaced(&step);
                largest = largest.max(size);
            }
            is_found = largest <= FOUND;
        }
        is_found.then_some(())?;
        for (sample, pose) in poses.iter().enumerate() {
            self.write_sample(&model, sample, pose, rows)?;
        }
        Some(())
    }

    /// Step to a better pose, and its size beside the residuals.
    fn step(&self, model: &Model, sample: usize, pose: &Pose) -> Option<(Twist, f64)> {
        let by_pose = self.by_pose(model, sample, pose)?;
        let residuals = self.residuals(sample, pose);
        let qr = by_pose.clone().qr();
        let right = -(qr.q().transpose() * &residuals);
        let amounts = qr.r().solve_upper_triangular(&right)?;
        let twist = model.twist_basis().iter().zip(amounts.iter()).map(|(twist, amount)| twist * *amount).sum();
        Some((twist, (by_pose * amounts).norm() / residuals.norm().max(1.0)))
    }

    fn residuals(&self, sample: usize, pose: &Pose) -> DVector<f64> {
        let (m, basis) = (self.model.cable_count(), self.model.twist_basis());
        let error = self.samples.poses[sample].displacement_to(pose);
        let of_lengths = self.at.residuals.rows(sample * m, m);
        let of_pose = basis.iter().map(|twist| self.metric.along(twist) * twist.dot(&error));
        DVector::from_iterator(m + basis.len(), of_lengths.iter().copied().chain(of_pose))
    }

    /// J_x: derivatives by the shifts and turns of the pattern.
    fn by_pose(&self, model: &Model, sample: usize, pose: &Pose) -> Option<DMatrix<f64>> {
        let (m, basis) = (model.cable_count(), model.twist_basis());
        let mut entries = DMatrix::zeros(m + basis.len(), basis.len());
        for cable in 0..m {
            let state = unit_spring_state(model, pose, cable, |_| 0.0).ok()?;
            for (column, twist) in basis.iter().enumerate() {
                entries[(cable, column)] = self.per_length * state.recorded_length_by_twist(twist);
            }
        }
        let by_turn = by_turn(&self.samples.poses[sample].displacement_to(pose));
        for (column, moved) in basis.iter().enumerate() {
            let mut moved = *moved;
            let turned = by_turn * moved.fixed_rows::<3>(3);
            moved.fixed_rows_mut::<3>(3).copy_from(&turned);
            for (row, twist) in basis.iter().enumerate() {
                entries[(m + row, column)] = self.metric.along(twist) * twist.dot(&moved);
            }
        }
        Some(entries)
    }

    fn write_sample(&self, model: &Model, sample: usize, pose: &Pose, rows: &mut Rows) -> Option<()> {
        let (m, size, count) = (model.cable_count(), self.size(), self.parameters.len());
        let explained = self.by_pose(model, sample, pose)?.qr().q();
        let mut own = DMatrix::zeros(size, count);
        own.rows_mut(0, m).copy_from(&self.at.jacobian.rows(sample * m, m));
        let left = &own - &explained * explained.tr_mul(&own);
        rows.jacobian.rows_mut(sample * size, size).copy_from(&left);
        rows.residuals.rows_mut(sample * size, size).copy_from(&self.residuals(sample, pose));
        Some(())
    }
}

impl UnknownPoses<'_> {
    fn size(&self) -> usize {
        self.model.cable_count() + self.model.dof()
    }
}

impl Residual for UnknownPoses<'_> {
    fn model(&self) -> &Model {
        &self.model
    }

    fn layout(&self) -> Layout {
        Layout::of(self.samples.len(), self.size()).eliminating(self.model.dof() * self.samples.len())
    }

    fn write(&mut self, values: &[f64], rows: &mut Rows) -> bool {
        self.try_write(values, rows).is_some() && rows.is_finite()
    }

    fn is_absolute(&self) -> bool {
        true
    }

    fn outliers(&self) -> Option<Outliers> {
        Some(Outliers::Own)
    }
}
