//! Rows of an elastic model at what was measured, whitened there, for costs other than the sum of squares.

use super::linearization::Linearization;
use super::measurement_noise::sigmas;
use super::optimum::{check_paths, checked_tensions, with_constant_wrench};
use super::rows::{RowModel, SampleRows};
use crate::fit::InputError;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::statics::Load;

/// Measured poses and tensions with the covariance of their rows at a model's start values.
pub(crate) struct Balance {
    linearization: Linearization,
}

impl Balance {
    pub(crate) fn new(model: &Model, samples: &Samples, parameters: &[Parameter]) -> Result<Self, InputError> {
        let tensions = checked_tensions(model, samples)?;
        let (sigmas, _) = sigmas(samples, tensions.iter().sum::<f64>() / tensions.len() as f64);
        let rows = RowModel::new(model, Load::of(model.robot())?, parameters);
        let linearization = Linearization::measured(&rows, samples, &tensions, &sigmas).ok_or(InputError::NotFinite)?;
        Ok(Self { linearization })
    }

    /// Hands every entry over with its row and its column, none for residuals; `None` if the load is unknown.
    pub(crate) fn write(
        &self,
        model: &Model,
        samples: &Samples,
        parameters: &[Parameter],
        mut entry: impl FnMut(usize, Option<usize>, f64),
    ) -> Option<()> {
        let row_model = RowModel::new(model, Load::of(model.robot()).ok()?, parameters);
        let mut rows = SampleRows::new(model, parameters.len());
        for sample in 0..samples.len() {
            self.linearization.write_whitened(&row_model, samples, sample, &mut rows);
            for row in 0..rows.count {
                let place = sample * rows.count + row;
                entry(place, None, rows.residual(row));
                (0..parameters.len()).for_each(|k| entry(place, Some(k), rows.entries[row * rows.stride + k]));
            }
        }
        Some(())
    }
}

/// An elastic model with a load that a free wrench can stand for, where its cables can be as they were recorded.
pub(crate) fn checked_start(model: &Model, samples: &Samples, parameters: &[Parameter]) -> Result<Model, InputError> {
    let tensions = checked_tensions(model, samples)?;
    let start = with_constant_wrench(model, samples, &tensions, parameters)?;
    check_paths(&start, samples, &tensions)?;
    Ok(start)
}
