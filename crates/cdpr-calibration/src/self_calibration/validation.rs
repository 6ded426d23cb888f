//! Calibrations without poses, judged on samples that they were not made with.

use super::evaluation::{at_agreed_poses, predict_sensors};
use super::found::read_by;
use super::left_out::calibrate;
use super::question::Question;
use super::{PredictedBand, SelfCalibration};
use crate::evaluation::Evaluation;
use crate::fit::{Fit, InputError, Settings, fit};
use crate::progress::unobserved;
use crate::progress::{Progress, report};
use crate::verdict::Doubt;
use cdpr_model::measurement::{Fold, InternalSamples, Samples};
use cdpr_model::model::{FreeParameters, Model};

/// Calibrations of one model from parts of the same samples.
pub(crate) struct Calibrations<'a> {
    pub(crate) model: &'a Model,
    pub(crate) internal: &'a InternalSamples,
    pub(crate) free: &'a FreeParameters,
    pub(crate) settings: &'a Settings,
}

/// A calibrated robot, with the meaning that its calibration gave recorded lengths.
pub(crate) struct Calibrated {
    pub(crate) fit: Fit,
    /// Bands of predicted poses, where they were asked for.
    pub(crate) band: Option<PredictedBand>,
    /// Doubts about single samples.
    pub(crate) doubts: Vec<Doubt>,
    /// True where lengths count from those at the world's origin.
    are_changes: bool,
}

impl Calibrated {
    /// Errors of what it predicts.
    pub(crate) fn predict(&self, internal: &InternalSamples) -> Result<Evaluation, InputError> {
        predict_sensors(&self.fit.model, &self.read(internal)?)
    }

    /// Samples with the poses where they agree best.
    pub(crate) fn samples(&self, internal: &InternalSamples) -> Result<Samples, InputError> {
        at_agreed_poses(&self.fit.model, &self.read(internal)?)
    }

    fn read(&self, internal: &InternalSamples) -> Result<InternalSamples, InputError> {
        read_by(&self.fit.model, self.are_changes, internal)
    }
}

impl SelfCalibration {
    /// Errors of what the calibrated robot predicts of samples that it was not calibrated with: residuals of their sensors at the poses that they tell
    /// themselves, scaled for what poses take up of them, so that noise of σ gives errors of σ.
    pub fn predict(&self, internal: &InternalSamples) -> Result<Evaluation, InputError> {
        predict_sensors(&self.fit.model, &read_by(&self.fit.model, self.counts_changes, internal)?)
    }

    fn into_calibrated(self) -> Calibrated {
        Calibrated { fit: self.fit, band: self.band, doubts: self.doubts, are_changes: self.counts_changes }
    }
}

impl Calibrations<'_> {
    /// A calibration from some of the samples; `progress` is called after each start. Without free parameters the model is as given.
    pub(crate) fn from(&self, part: &[usize], progress: &Progress<'_>) -> Result<Calibrated, InputError> {
        self.calibrated(part, false, progress)
    }

    /// The same with bands of predicted poses.
    pub(crate) fn with_band(&self, part: &[usize], progress: &Progress<'_>) -> Result<Calibrated, InputError> {
        self.calibrated(part, true, progress)
    }

    fn calibrated(&self, part: &[usize], has_band: bool, progress: &Progress<'_>) -> Result<Calibrated, InputError> {
        let Self { model, free, settings, .. } = *self;
        let internal = self.internal.subset(part);
        if !free.is_empty() {
            return Ok(calibrate(model, &internal, free, settings, has_band, progress)?.into_calibrated());
        }
        let samples = at_agreed_poses(model, &internal)?;
        let fit = fit(model, &samples, free, settings)?;
        let band =
            has_band.then(|| Question::as_given(model, &internal, settings).band_as_given(&samples.poses)).flatten();
        report(progress)?;
        Ok(Calibrated { fit, band, doubts: Vec::new(), are_changes: internal.are_changes })
    }
}

/// Errors on the samples that each fold holds out, of models calibrated with the others and of the model as given where it has any; with one fold, of
/// the calibration that is handed over.
pub fn cross_validate_without_poses(
    model: &Model,
    internal: &InternalSamples,
    free: &FreeParameters,
    settings: &Settings,
    folds: &[Fold],
    reported: &SelfCalibration,
) -> Result<(Evaluation, Option<Evaluation>), InputError> {
    let calibrations = Calibrations { model, internal, free, settings };
    let (mut after, mut before) = (Evaluation::default(), Some(Evaluation::default()));
    for fold in folds {
        let held = internal.subset(&fold.validation);
        let errors = match folds.len() {
            1 => reported.predict(&held)?,
            _ => calibrations.from(&fold.train, &unobserved)?.predict(&held)?,
        };
        after.extend(&errors);
        let given = predict_sensors(model, &held);
        before = before.zip(given.ok()).map(|(mut all, own)| {
            all.extend(&own);
            all
        });
    }
    Ok((after, before))
}
