//! Least squares of wrenches and lengths with weights of their own in place of accuracies (w_ρ of sec. 4.5).

use crate::progress::Progress;
use nalgebra::{DMatrix, DVector};

use super::adjust::Adjust;
use super::balance::checked_start;
use super::descent::Problem;
use super::linearization::Linearization;
use super::measurement_noise::sigmas;
use super::optimum::{self, Optimum, checked_tensions, search};
use super::rows::{RowModel, SampleRows};
use crate::fit::{InputError, RowWeights, Settings};
use crate::loss::Loss;
use crate::recorded::Recorded;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::reading::Keyword;
use cdpr_model::robot::Parameter;
use cdpr_model::statics::Load;

/// Share of the cost that the next step may still promise at the end.
const FINAL_PROMISE: f64 = 1e-14;

/// Finds the optimum of an elastic model, by row weights where they are given; `progress` is called after each start.
pub(crate) fn find(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
    progress: &Progress<'_>,
) -> Result<Optimum, InputError> {
    let Some(weights) = settings.row_weights else {
        return optimum::find(model, samples, parameters, settings, progress);
    };
    if !matches!(settings.loss, Loss::Auto | Loss::Squared) {
        return Err(InputError::RowWeightCost { words: format!("the loss `{}`", settings.loss.name()) });
    }
    let tensions = checked_tensions(model, samples)?;
    let start_model = checked_start(model, samples, parameters)?;
    let problem = Problem::new(&start_model, samples, &tensions, parameters, settings);
    let linearization = Linearization::weighted(&start_model, samples, &tensions, &of_rows(&start_model, weights));
    let (found, starts) = search(&problem, &linearization, progress)?;
    let mut end = problem.descend(&found.values, &linearization, FINAL_PROMISE);
    end.iterations += found.iterations;
    end.trail = found.trail.joined(end.trail);
    let mean = tensions.iter().sum::<f64>() / tensions.len() as f64;
    let norms =
        Adjust { problem: &problem, sigmas: sigmas(samples, mean).0, noise: 1.0 }.norms(&end, &linearization, false)?;
    let misfit = problem.misfit(&end, &linearization);
    let calibrated = problem.model_at(&end.values).ok_or(InputError::NotFinite)?;
    Ok(Optimum {
        calibrated,
        linearization,
        absolute: false,
        noise: 1.0,
        misfit,
        norms,
        end,
        starts,
        tensions,
        start_model,
    })
}

/// Weights of the rows of a sample, wrenches first.
fn of_rows(model: &Model, weights: RowWeights) -> Vec<f64> {
    let (n, m) = (model.dof(), model.cable_count());
    (0..n + m).map(|row| if row < n { weights.wrench } else { weights.length }).collect()
}

/// Rows at what was measured, with their weights, and their Jacobian.
pub(crate) fn weighted_rows(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    weights: RowWeights,
) -> Result<(DVector<f64>, DMatrix<f64>), InputError> {
    let tensions = samples.tensions.as_deref().ok_or(InputError::NoTensions)?;
    let row_model = RowModel::new(model, Load::of(model.robot())?, parameters);
    let mut rows = SampleRows::new(model, parameters.len());
    let (of_rows, m) = (of_rows(model, weights), model.cable_count());
    let mut jacobian = DMatrix::zeros(samples.len() * rows.count, parameters.len());
    let mut residuals = DVector::zeros(jacobian.nrows());
    for (sample, pose) in samples.poses.iter().enumerate() {
        row_model.write(pose, &tensions[sample * m..][..m], Recorded::of(samples, sample), &mut rows);
        for row in 0..rows.count {
            residuals[sample * rows.count + row] = of_rows[row] * rows.residual(row);
            for column in 0..parameters.len() {
                jacobian[(sample * rows.count + row, column)] = of_rows[row] * rows.entries[row * rows.stride + column];
            }
        }
    }
    Ok((residuals, jacobian))
}

/// Jacobian of all samples' rows, whitened by the sensors' accuracies, at what was measured.
pub(crate) fn whitened_rows(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
) -> Result<DMatrix<f64>, InputError> {
    let tensions = checked_tensions(model, samples)?;
    let row_model = RowModel::new(model, Load::of(model.robot())?, parameters);
    let mean = tensions.iter().sum::<f64>() / tensions.len() as f64;
    let found = Linearization::measured(&row_model, samples, &tensions, &sigmas(samples, mean).0);
    let linearization = found.ok_or(InputError::NotFinite)?;
    let mut rows = SampleRows::new(model, parameters.len());
    let mut jacobian = DMatrix::zeros(samples.len() * rows.count, parameters.len());
    for sample in 0..samples.len() {
        linearization.write(&row_model, samples, sample, &mut rows);
        linearization.whiten(sample, &mut rows);
        for (row, derivatives) in rows.derivatives().enumerate() {
            jacobian.row_mut(sample * rows.count + row).copy_from_slice(derivatives);
        }
    }
    Ok(jacobian)
}
