//! Rows at the values of a model, and the shares that unknowns take of them.

use nalgebra::DVector;

use super::internal::Sensing;
use crate::fit::InputError;
use crate::residual::Residual;
use crate::residual::rows::Rows;
use crate::residual::sensors::Sensor;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::decomposition::svd;

/// Singular value, beside the largest, of a direction that the rows do not tell.
const UNDETERMINED: f64 = 1e-10;

/// Rows at the values of a model, with the poses they were found at.
pub(super) struct Written {
    pub(super) rows: Rows,
    pub(super) poses: Vec<Pose>,
    /// Share of each row's residual that its own pose takes up; empty where only lengths are rows.
    pub(super) leverages: Vec<f64>,
}

impl Written {
    /// Residuals of lengths, zeros at all other rows.
    pub(super) fn lengths(&self, sensing: &Sensing) -> DVector<f64> {
        let mut lengths = DVector::zeros(self.rows.residuals.len());
        let m = match sensing {
            Sensing::Lengths(_) => self.rows.size(),
            Sensing::All(layout, _) => layout.places(Sensor::Length, 1).count(),
        };
        let size = self.rows.size();
        for row in (0..self.poses.len()).flat_map(|sample| (0..m).map(move |row| sample * size + row)) {
            lengths[row] = self.rows.residuals[row];
        }
        lengths
    }

    /// Shares of the rows' residuals that poses and parameters take up.
    pub(super) fn all_leverages(&self) -> Vec<f64> {
        self.added_to(self.leverages.clone())
    }

    /// Shares of the rows' residuals that the parameters take up.
    pub(super) fn by_parameters(&self) -> Vec<f64> {
        self.added_to(vec![0.0; self.rows.residuals.len()])
    }

    /// Shares of the rows with those that the parameters take up.
    fn added_to(&self, mut all: Vec<f64>) -> Vec<f64> {
        let Some(found) = svd(self.rows.jacobian.clone(), true, false) else { return all };
        let largest = found.singular_values.amax();
        let directions = found.u.iter().flat_map(|u| u.column_iter()).zip(found.singular_values.iter());
        for (direction, _) in directions.filter(|(_, value)| **value > UNDETERMINED * largest) {
            all.iter_mut().zip(direction.iter()).for_each(|(leverage, entry)| *leverage += entry * entry);
        }
        all
    }
}

/// Rows at the values of a model.
pub(super) fn rows_at(
    residual: &mut dyn Residual,
    model: &Model,
    parameters: &[Parameter],
) -> Result<Rows, InputError> {
    let values: Vec<f64> = parameters.iter().map(|parameter| parameter.value(model.robot())).collect();
    let mut rows = Rows::new(residual.layout(), parameters.len());
    residual.write(&values, &mut rows).then_some(rows).ok_or(InputError::NoPoses)
}
