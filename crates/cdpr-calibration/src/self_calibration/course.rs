//! Course of a calibration without poses: every step with the poses that its parameters lead to.

use super::question::Question;
use super::vectors::PoseVectors;
use super::written::{Written, stacked};
use crate::course::CourseStep;
use crate::fit::{Fit, InputError};
use crate::identifiability::{rank_and_condition, singular_values, with_unit_columns};
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::TriangularFactor;
use cdpr_model::solve::minimizer;

impl Question<'_> {
    /// Steps of a fit that kept them, from the start to the optimum, by the rows that poses leave; `scales` are metres of one unit of each parameter.
    pub(super) fn course(
        &self,
        vectors: &mut PoseVectors<'_>,
        fit: &Fit,
        parameters: &[Parameter],
        scales: &[f64],
    ) -> Result<Vec<CourseStep>, InputError> {
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
            let stacked = stacked(vectors, &model, parameters)?;
            let rows = stacked.jacobian.nrows();
            let factor = TriangularFactor::of(&stacked.jacobian).into_matrix();
            let (rank, condition) = rank_and_condition(&singular_values(factor.clone()), rows);
            let (_, condition_scaled) = rank_and_condition(&singular_values(with_unit_columns(factor)), rows);
            let written = Written { stacked, poses: vectors.poses(), leverages: Vec::new() };
            let squares = written.lengths(&self.sensing).norm_squared() / self.internal.samples.lengths.len() as f64;
            let step = |before: &CourseStep| {
                let changes: Vec<f64> = values.iter().zip(&before.values).map(|(now, before)| now - before).collect();
                minimizer::size(&changes, scales)
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
