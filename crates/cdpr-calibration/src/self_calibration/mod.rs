//! Calibration by sensors inside the machine, at poses that nobody measured: lengths or their changes, tensions, swivel angles, inclinometers.
//!
//! Every pose takes the place where its measurements agree best and leaves as many equations for the parameters as there are more of them than unknowns (sec. 4.1). What
//! moves or mirrors the robot as a whole changes none: such gauge motions are found, named, and fixed by parameters that stay at the file's values.

mod accuracies;
mod cells;
mod comparison;
mod course;
mod distances;
mod equations;
mod evaluation;
mod far;
mod found;
mod gauge;
mod held;
mod internal;
mod left_out;
mod partial_poses;
mod predicted_band;
mod question;
mod sensor_fit;
mod unseen;
mod validation;
mod way_around;
mod written;

use super::course::CourseStep;
use super::fit::{Fit, InputError, Settings, report};
use super::minimize::minimize;
use super::minimize::unknowns::Unknowns;
use super::plausibility::{Distrust, beyond_length_accuracy};
use super::problem::model_at;
use super::residual::Poseless;
use super::unit_scale::joint_scales;
use super::verdict::Doubt;
use crate::progress::Progress;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{InternalSamples, Samples};
use cdpr_model::model::{FreeParameters, Model};
use cdpr_model::robot::Parameter;
pub use comparison::Comparison;
pub use evaluation::evaluate_lengths;
use far::Far;
use found::as_found;
use gauge::Gauge;
pub use gauge::GaugeFixing;
use internal::InternalResidual;
pub use left_out::self_calibrate;
use predicted_band::At;
pub use predicted_band::PredictedBand;
use question::Question;
pub use sensor_fit::SensorFit;
pub use validation::cross_validate_without_poses;
pub(super) use validation::{Calibrated, Calibrations};
use written::{Written, rows_at};

/// A robot calibrated without measured poses.
#[must_use = "check the status of the fit before using the parameters"]
#[derive(Clone, Debug)]
pub struct SelfCalibration {
    /// The fit; parameters that the gauge holds are none of its own.
    pub fit: Fit,
    /// The samples with the poses at which their measurements agree best, lengths counted from nothing.
    pub samples: Samples,
    /// Σ of the squared length residuals (m²).
    pub cost_m2: f64,
    /// Their root mean square (m).
    pub length_rms_m: f64,
    /// Residuals of each sensor.
    pub sensors: Vec<SensorFit>,
    /// Equations that the poses leave for the parameters.
    pub equations: usize,
    /// Free parameters, those that the gauge holds included.
    pub parameter_count: usize,
    /// Motions of everything that the data leave free, and parameters that fix them.
    pub gauge: GaugeFixing,
    /// True where lengths count from those at the world's origin; false for lengths, and for changes that offsets make lengths.
    pub counts_changes: bool,
    /// Course of the fit where it was kept ([`Settings::keeps_course`]); residuals are those at the poses of each step.
    pub course: Vec<CourseStep>,
    /// Bands of predicted poses; `None` if they were not asked for, or poses do not follow the parameters.
    pub band: Option<PredictedBand>,
    /// Doubts about single samples.
    pub doubts: Vec<Doubt>,
    /// Samples that no pose explains.
    far: Vec<Far>,
}

/// A calibration by all samples, with bands of predicted poses or without; `progress` is called after each start.
fn calibrate_once(
    model: &Model,
    internal: &InternalSamples,
    free: &FreeParameters,
    settings: &Settings,
    has_band: bool,
    progress: &Progress<'_>,
) -> Result<SelfCalibration, InputError> {
    let mut question = Question::of(model, internal, free, settings)?;
    let equations = question.count_equations();
    let start = question.rows(&question.model, &question.parameters, None)?;
    let lengths = start.lengths(&question.sensing);
    let gauge = Gauge::of(&question.model, &question.parameters, &start.rows, &lengths);
    let kept = question.fix(&gauge)?;
    let parameters = question.parameters.len() - gauge.held.len();
    if parameters > equations + question.prior_count(&kept) {
        return Err(InputError::TooFewEquations { parameters, equations, samples: internal.samples.len() });
    }
    question.agree_on_accuracies(&kept, &start.poses)?;
    let Question { model: start_model, internal: data, .. } = &question;
    let mut residual = question.start(start_model, &kept, Some(&start.poses))?;
    let unknowns = question.unknowns(start_model, &kept, settings, &residual.poses())?;
    let mut optimum = minimize(&mut residual, &unknowns, None, progress)?;
    if !optimum.end.converged()
        && let Some(from) = question.way_around(&gauge, &start.poses)?
    {
        optimum = minimize(&mut residual, &unknowns, Some(&from), progress)?;
    }
    let calibrated = model_at(&residual, &unknowns, &optimum.end.values)?;
    rows_at(&mut residual, &calibrated, &kept)?;
    let unsettled = residual.unsettled();
    let end = question.rows(&calibrated, &question.parameters, Some(&residual.poses()))?;
    let sensors = question.sensor_fits(&end);
    let sigma = question.sensing.length_sigma();
    let cost_m2 = end.lengths(&question.sensing).norm_squared() * sigma * sigma;
    let mut found = as_found(&calibrated, data, &end.poses)?;
    let mut fit = report(&mut residual, &unknowns, optimum, &found, Vec::new())?;
    let course = question.course(&mut residual, &fit, &unknowns)?;
    // angles from a common start are those of no start length
    found.motor_angles = found.motor_angles.filter(|_| !data.are_changes);
    let band =
        has_band.then(|| question.band((&calibrated, &kept), &gauge, &end.poses, fit.analysis.inflation)).flatten();
    if unsettled > 0 {
        fit.tell_unsettled(unsettled);
    }
    fit.tell_nominal_values(model);
    fit.warnings.extend(sensor_fit::warnings(&sensors));
    fit.warnings.extend(cells::warning(&fit, settings));
    fit.warnings.extend(question.unused_tensions());
    if let Some(words) = gauge.scale_warning() {
        fit.warnings.insert(0, words);
    }
    Ok(SelfCalibration {
        cost_m2,
        length_rms_m: (cost_m2 / internal.samples.lengths.len() as f64).sqrt(),
        sensors,
        equations,
        parameter_count: question.parameters.len(),
        gauge: gauge.told(model, &question.parameters, data, settings.gauge),
        course,
        band,
        far: question.far(&end),
        doubts: Vec::new(),
        counts_changes: data.are_changes,
        samples: found,
        fit,
    })
}

impl SelfCalibration {
    /// Reasons not to trust the calibration: length residuals far beyond the accuracy that is stated for them, by what poses and parameters leave to judge by.
    pub fn distrust(&self) -> Distrust {
        let of_lengths = self.sensors.iter().find(|fit| fit.sensor == sensor_fit::LENGTH);
        let left = self.equations.saturating_sub(self.fit.analysis.rank);
        let deviation = match of_lengths {
            Some(fit) => fit.deviation(),
            None if left > 0 => (self.cost_m2 / left as f64).sqrt(),
            None => f64::NAN,
        };
        let mut reasons: Vec<Doubt> = beyond_length_accuracy(deviation, &self.samples.sigmas).into_iter().collect();
        reasons.extend(self.doubts.iter().cloned());
        reasons.extend(self.band.iter().flat_map(|band| band.findings.iter().cloned().map(Doubt::from)));
        Distrust { reasons }
    }
}

impl Question<'_> {
    /// Bands of predicted poses at an optimum.
    fn band(
        &self,
        (model, kept): (&Model, &[Parameter]),
        gauge: &Gauge,
        poses: &[Pose],
        inflation: f64,
    ) -> Option<PredictedBand> {
        At { question: self, model, kept, gauge, poses, inflation }.predicted_band()
    }

    /// Bands of the poses that the model predicts as it is.
    fn band_as_given(&self, poses: &[Pose]) -> Option<PredictedBand> {
        let here = self.rows(&self.model, &[], Some(poses)).ok()?;
        let gauge = Gauge::of(&self.model, &[], &here.rows, &here.lengths(&self.sensing));
        let left = self.count_equations().max(1) as f64;
        let noise = (here.rows.residuals.norm_squared() / left).sqrt();
        let least = if self.are_stated() { 1.0 } else { 0.0 };
        let inflation = if noise.is_finite() { noise.max(least) } else { 1.0 };
        self.band((&self.model, &[]), &gauge, &here.poses, inflation)
    }

    /// Rows at a model's values, poses searched from some that were found before.
    fn rows(&self, model: &Model, parameters: &[Parameter], near: Option<&[Pose]>) -> Result<Written, InputError> {
        let mut residual = self.sensing.residual(model, &self.internal, parameters, &self.equations);
        near.into_iter().for_each(|poses| residual.begin_at(poses));
        let rows = rows_at(&mut residual, model, parameters)?;
        Ok(Written { rows, poses: residual.poses(), leverages: residual.leverages() })
    }

    /// Residuals of some of the parameters, written at their start.
    fn start<'a>(
        &'a self,
        model: &Model,
        parameters: &'a [Parameter],
        near: Option<&[Pose]>,
    ) -> Result<InternalResidual<'a>, InputError> {
        let mut residual = self.sensing.residual(model, &self.internal, parameters, &self.equations);
        near.into_iter().for_each(|poses| residual.begin_at(poses));
        rows_at(&mut residual, model, parameters)?;
        Ok(residual)
    }

    /// Unknowns of some of the parameters from a model's values, where poses were found.
    fn unknowns<'b>(
        &self,
        model: &Model,
        parameters: &'b [Parameter],
        settings: &'b Settings,
        poses: &[Pose],
    ) -> Result<Unknowns<'b>, InputError> {
        let lengths = as_found(&self.model, &self.internal, poses)?.lengths;
        Ok(Unknowns {
            parameters,
            start: parameters.iter().map(|parameter| parameter.value(model.robot())).collect(),
            scale: joint_scales(&self.model, parameters, &lengths, self.tensions()).into(),
            settings,
            mean_tension: self.mean_tension(),
        })
    }
}
