//! Course of a fit: parameters, residuals and condition at every step (Figs. 4.13–4.15, 6.7, 6.20).

use nalgebra::DMatrix;

use super::evaluation::evaluate_fitted;
use super::fit::{Fit, InputError, Settings};
use super::identifiability::{rank_and_condition, singular_values, with_unit_columns};
use super::objective::Objective;
use super::plain_rows::{PlainRows, RowKind};
use super::unit_scale::joint_scales;
use cdpr_model::measurement::Samples;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::TriangularFactor;
use cdpr_model::solve::minimizer;

/// A step of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct CourseStep {
    /// Values of the free parameters after the step, in their order (SI).
    pub values: Vec<f64>,
    /// Largest change of a parameter by the step in metres of cable, the measure of the step rule; `None` at the start.
    pub step_m: Option<f64>,
    /// Root mean square of the length rows (m).
    pub length_rms_m: f64,
    /// The same of the force rows (N); `None` of rigid models.
    pub force_rms: Option<f64>,
    /// The same of the moment rows (N·m); `None` of rigid models and where nothing turns.
    pub moment_rms: Option<f64>,
    /// Root mean square of the predicted position error (m), where predicted poses are made small.
    pub position_rms_m: Option<f64>,
    /// Rank of the rows' Jacobian.
    pub rank: usize,
    /// κ of the rows' Jacobian in SI units (eq. 4.23), rows by their weights.
    pub condition: f64,
    /// κ with columns of length one.
    pub condition_scaled: f64,
}

/// Rows at the values of a step.
pub(crate) struct StepRows {
    /// By the parameters, with weights.
    pub(crate) jacobian: DMatrix<f64>,
    /// Root mean squares of the residuals by their kinds, as [`CourseStep`] has them.
    pub(crate) length_rms_m: f64,
    pub(crate) force_rms: Option<f64>,
    pub(crate) moment_rms: Option<f64>,
    pub(crate) position_rms_m: Option<f64>,
}

/// Steps of a fit that kept its way, each by the rows `at` its values; `scales` are metres of one unit of each parameter.
pub(crate) fn steps(
    fit: &Fit,
    scales: &[f64],
    mut at: impl FnMut(&[f64]) -> Result<StepRows, InputError>,
) -> Result<Vec<CourseStep>, InputError> {
    let mut places = fit.trail.places().to_vec();
    if places.is_empty() || fit.parameters.is_empty() {
        return Ok(Vec::new());
    }
    // the last step is taken without asking what it helped
    places.push(fit.parameters.iter().map(|estimate| estimate.value).collect());
    places.dedup();
    let mut steps: Vec<CourseStep> = Vec::with_capacity(places.len());
    for values in places {
        let StepRows { jacobian, length_rms_m, force_rms, moment_rms, position_rms_m } = at(&values)?;
        let changes = steps.last().map(|before| values.iter().zip(&before.values).map(|(now, before)| now - before));
        let step_m = changes.map(|changes| minimizer::size(&changes.collect::<Vec<f64>>(), scales));
        let count = jacobian.nrows();
        let factor = TriangularFactor::of(&jacobian).into_matrix();
        let (rank, condition) = rank_and_condition(&singular_values(factor.clone()), count);
        let (_, condition_scaled) = rank_and_condition(&singular_values(with_unit_columns(factor)), count);
        steps.push(CourseStep {
            values,
            step_m,
            length_rms_m,
            force_rms,
            moment_rms,
            position_rms_m,
            rank,
            condition,
            condition_scaled,
        });
    }
    Ok(steps)
}

/// Course of a fit that kept it, from the start to the optimum; empty of one that did not ([`Settings::keeps_course`]) or had nothing to find.
///
/// `samples` and settings are those of the fit. Outliers of a robust loss are left out of the residuals. Cables that are identified apart step side by
/// side, of several starts each has the way from its best one.
pub fn course(samples: &Samples, fit: &Fit, settings: &Settings) -> Result<Vec<CourseStep>, InputError> {
    let samples = fit.as_fitted(samples).subset(&fit.trusted_samples(samples.len()));
    let parameters: Vec<Parameter> = fit.parameters.iter().map(|estimate| estimate.parameter).collect();
    let tensions = samples.tensions.as_deref().unwrap_or_default();
    let scales = joint_scales(&fit.model, &parameters, &samples.lengths, tensions);
    steps(fit, &scales, |values| {
        let model = fit.model.with_parameters(&parameters, values).ok_or(InputError::NotFinite)?;
        let samples = &*model.with_lengths(&samples)?;
        let rows = PlainRows::of(&model, samples, &parameters, settings.row_weights.unwrap_or_default())?;
        let predicts = settings.objective != Objective::Length;
        let errors = if predicts { evaluate_fitted(&model, samples).ok() } else { None };
        Ok(StepRows {
            length_rms_m: rows.rms(RowKind::Length).unwrap_or(f64::NAN),
            force_rms: rows.rms(RowKind::Force),
            moment_rms: rows.rms(RowKind::Moment),
            position_rms_m: errors.map(|errors| errors.blocks().position_error_m.rms),
            jacobian: rows.jacobian,
        })
    })
}
