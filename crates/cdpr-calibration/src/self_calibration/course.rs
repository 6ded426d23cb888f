//! Course of a calibration without poses: every step with the poses that its parameters lead to.

use super::internal::InternalResidual;
use super::question::Question;
use super::written::{Written, rows_at};
use crate::course::{CourseStep, StepRows, steps};
use crate::fit::{Fit, InputError};
use crate::minimize::unknowns::Unknowns;
use crate::residual::Poseless;

impl Question<'_> {
    /// Steps of a fit that kept them, from the start to the optimum, by the rows that poses leave.
    pub(super) fn course(
        &self,
        residual: &mut InternalResidual<'_>,
        fit: &Fit,
        unknowns: &Unknowns<'_>,
    ) -> Result<Vec<CourseStep>, InputError> {
        steps(fit, &unknowns.scale, |values| {
            let parameters = unknowns.parameters;
            let model = self.model.with_parameters(parameters, values).ok_or(InputError::NotFinite)?;
            let rows = rows_at(residual, &model, parameters)?;
            let written = Written { rows, poses: residual.poses(), leverages: Vec::new() };
            let squares = written.lengths(&self.sensing).norm_squared() / self.internal.samples.lengths.len() as f64;
            Ok(StepRows {
                jacobian: written.rows.jacobian,
                length_rms_m: self.sensing.length_sigma() * squares.sqrt(),
                force_rms: None,
                moment_rms: None,
                position_rms_m: None,
            })
        })
    }
}
