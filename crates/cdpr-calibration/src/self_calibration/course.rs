//! Course of a calibration without poses: every step with the poses that its parameters lead to.

use super::internal::InternalResidual;
use super::question::Question;
use super::written::{Written, rows_at};
use crate::course::CourseStep;
use crate::fit::{Fit, InputError};
use crate::identifiability::{rank_and_condition, singular_values, with_unit_columns};
use crate::minimize::unknowns::Unknowns;
use crate::residual::Poseless;
use cdpr_model::scalar::TriangularFactor;
use cdpr_model::solve::minimizer;

impl Question<'_> {
    /// Steps of a fit that kept them, from the start to the optimum, by the rows that poses leave.
    pub(super) fn course(
        &self,
        residual: &mut InternalResidual<'_>,
        fit: &Fit,
        unknowns: &Unknowns<'_>,
    ) -> Result<Vec<CourseStep>, InputError> {
        let parameters = unknowns.parameters;
        let mut places = fit.trail.places().to_vec();
        if places.is_empty() || parameters.is_empty() {
            return Ok(Vec::new());
        }
        // the last step is taken without asking what it helped
        places.push(fit.parameters.iter().map(|estimate| estimate.value).collect());
        places.dedup();
        let mut steps: Vec<CourseStep> = Vec::with_capacity(places.len());
        for values in places {
            let model = self.model.with_parameters(parameters, &values).ok_or(InputError::NotFinite)?;
            let rows = rows_at(residual, &model, parameters)?;
            let count = rows.jacobian.nrows();
            let factor = TriangularFactor::of(&rows.jacobian).into_matrix();
            let (rank, condition) = rank_and_condition(&singular_values(factor.clone()), count);
            let (_, condition_scaled) = rank_and_condition(&singular_values(with_unit_columns(factor)), count);
            let written = Written { rows, poses: residual.poses(), leverages: Vec::new() };
            let squares = written.lengths(&self.sensing).norm_squared() / self.internal.samples.lengths.len() as f64;
            let step = |before: &CourseStep| {
                let changes: Vec<f64> = values.iter().zip(&before.values).map(|(now, before)| now - before).collect();
                minimizer::size(&changes, &unknowns.scale)
            };
            steps.push(CourseStep {
                step_m: steps.last().map(step),
                length_rms_m: self.sensing.length_sigma() * squares.sqrt(),
                force_rms: None,
                moment_rms: None,
                position_rms_m: None,
                rank,
                condition,
                condition_scaled,
                values,
            });
        }
        Ok(steps)
    }
}
