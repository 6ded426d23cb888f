//! Rows of an elastic model at its optimum, by the motion of the platform besides its parameters.

use nalgebra::{DMatrix, DVector};

use super::linearization::Place;
use super::noise::{Noise, Sigmas};
use super::normal::whiten;
use super::optimum::Optimum;
use super::rows::{RowModel, SampleRows};
use crate::fit::{InputError, RowBlock, Wrenches};
use cdpr_model::geometry::Wrench;
use cdpr_model::measurement::Samples;
use cdpr_model::robot::Parameter;
use cdpr_model::statics::Load;

/// Derivatives by poses themselves instead of by their standard deviations.
pub(crate) const UNITS: Sigmas = Sigmas { position: 1.0, rotation: 1.0, length: 1.0, tension: 1.0 };

/// All rows in one block, whitened, those of outliers by their weight.
pub(crate) fn pose_rows(
    optimum: &Optimum,
    samples: &Samples,
    parameters: &[Parameter],
) -> Result<RowBlock, InputError> {
    let (model, m) = (&optimum.calibrated, samples.cable_count);
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
    let mut wrenches =
        Wrenches { residuals: Vec::with_capacity(samples.len()), whitened: DMatrix::zeros(samples.len() * count, n) };
    for sample in 0..samples.len() {
        let root = optimum.norms.weight(sample).sqrt();
        optimum.linearization.write(&row_model, samples, sample, &mut rows);
        let Place { pose, tensions, factor, shifts } = optimum.linearization.place(sample, m);
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
            (0..parameters.len()).for_each(|k| block.by_parameters[(place, k)] = rows.entries[row * rows.stride + k]);
            let entries = &poses.entries[row * poses.stride..][..2 * n];
            (0..n).for_each(|k| {
                (block.by_pose[(place, k)], wrenches.whitened[(place, k)]) = (entries[k], entries[n + k])
            });
            block.residuals[place] = rows.residual(row);
        }
    }
    Ok(RowBlock { wrenches: Some(wrenches), ..block })
}
