//! Rows of an elastic model at its optimum, by the motion of the platform besides its parameters.

use nalgebra::{DMatrix, DVector};

use super::BalanceResidual;
use super::linearization::Place;
use super::noise::{Noise, UNITS};
use super::normal::whiten;
use super::rows::{RowModel, SampleRows};
use crate::fit::InputError;
use crate::norms::Norms;
use crate::residual::rows::{RowBlock, Wrenches};
use cdpr_model::geometry::Wrench;
use cdpr_model::model::Model;
use cdpr_model::statics::Load;

impl BalanceResidual<'_> {
    /// All rows in one block, whitened, those of outliers by their weight.
    pub(super) fn all_pose_rows(&self, model: &Model, norms: &Norms) -> Result<RowBlock, InputError> {
        let Self { samples, parameters, at, .. } = self;
        let m = samples.cable_count;
        let load = Load::of(model.robot())?;
        let row_model = RowModel::new(model, load, parameters);
        let (n, count) = (model.dof(), model.dof() + m);
        let mut rows = SampleRows::new(model, parameters.len());
        // by the pose, then by a wrench
        let mut poses = SampleRows::new(model, 2 * n);
        let mut noise = Noise::new(model);
        let mut block = RowBlock {
            parameters: (0..parameters.len()).collect(),
            by_parameters: DMatrix::zeros(samples.len() * count, parameters.len()),
            by_pose: DMatrix::zeros(samples.len() * count, n),
            residuals: DVector::zeros(samples.len() * count),
            rows_of_sample: count,
            poses: Vec::with_capacity(samples.len()),
            wrenches: None,
        };
        let mut wrenches = Wrenches {
            residuals: Vec::with_capacity(samples.len()),
            whitened: DMatrix::zeros(samples.len() * count, n),
        };
        for sample in 0..samples.len() {
            let root = norms.weight(sample).sqrt();
            at.write(&row_model, samples, sample, &mut rows);
            let Place { pose, tensions, factor, shifts } = at.place(sample, m);
            let along = model.twist_basis().iter().enumerate();
            wrenches.residuals.push(along.map(|(row, unit)| unit * (rows.residual(row) - shifts[row])).sum::<Wrench>());
            block.poses.push(*pose);
            whiten(factor, &mut rows);
            rows.scale(root);
            row_model.noise(pose, tensions, &UNITS, &mut noise);
            poses.entries.fill(0.0);
            for (row, by_pose) in noise.by_pose.iter().enumerate() {
                let entries = &mut poses.entries[row * poses.stride..][..2 * n];
                entries[..n].copy_from_slice(&by_pose[..n]);
                entries[n..].iter_mut().skip(row).take(1).for_each(|entry| *entry = 1.0);
            }
            whiten(factor, &mut poses);
            poses.scale(root);
            for row in 0..count {
                let place = sample * count + row;
                (0..parameters.len())
                    .for_each(|k| block.by_parameters[(place, k)] = rows.entries[row * rows.stride + k]);
                let entries = &poses.entries[row * poses.stride..][..2 * n];
                (0..n).for_each(|k| {
                    (block.by_pose[(place, k)], wrenches.whitened[(place, k)]) = (entries[k], entries[n + k])
                });
                block.residuals[place] = rows.residual(row);
            }
        }
        Ok(RowBlock { wrenches: Some(wrenches), ..block })
    }
}
