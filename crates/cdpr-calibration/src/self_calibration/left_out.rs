//! Samples that no pose explains: sought by what their poses and the parameters leave of their residuals, and left out of the fit.

use super::evaluation::at_agreed_poses;
use super::far::Far;
use super::found::{as_found, modelled_length, read_by};
use super::{SelfCalibration, calibrate_once};
use crate::fit::{InputError, Settings};
use crate::loss::Loss;
use crate::norms::OUTLIER_DEVIATIONS;
use crate::outliers::Outlier;
use crate::progress::Progress;
use crate::verdict::Doubt;
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::measurement::{InternalSamples, three_digits};
use cdpr_model::model::{FreeParameters, Model};

/// Times that samples are sought where those found before are left out: a large one hides others.
const PASSES: usize = 3;
/// Share of samples that are no accidents any more.
const MANY: f64 = 0.1;
/// Identifies parameters of a model from what a machine's own sensors recorded at unknown poses; samples that no pose explains are left out with the loss `auto`.
/// `progress` is called after each start.
pub fn self_calibrate(
    model: &Model,
    internal: &InternalSamples,
    free: &FreeParameters,
    settings: &Settings,
    progress: &Progress<'_>,
) -> Result<SelfCalibration, InputError> {
    calibrate(model, internal, free, settings, true, progress)
}

/// The same, with bands of predicted poses or without.
pub(super) fn calibrate(
    model: &Model,
    internal: &InternalSamples,
    free: &FreeParameters,
    settings: &Settings,
    has_band: bool,
    progress: &Progress<'_>,
) -> Result<SelfCalibration, InputError> {
    let mut found = calibrate_once(model, internal, free, settings, has_band, progress)?;
    let count = internal.samples.len();
    let mut kept: Vec<usize> = (0..count).collect();
    let mut left_out: Vec<Far> = Vec::new();
    for _ in 0..PASSES {
        let far: Vec<Far> = found.far.iter().map(|far| Far { sample: kept[far.sample], ..*far }).collect();
        let is_far = |sample: &usize| far.iter().any(|far| far.sample == *sample);
        let all = left_out.len() + far.len();
        if far.is_empty() || settings.loss != Loss::Auto || all as f64 > MANY * count as f64 {
            found.doubts.extend(far.iter().map(|far| doubt(internal, far, false)));
            break;
        }
        let without: Vec<usize> = kept.iter().copied().filter(|sample| !is_far(sample)).collect();
        let Ok(next) = calibrate_once(model, &internal.subset(&without), free, settings, has_band, progress) else {
            found.doubts.extend(far.iter().map(|far| doubt(internal, far, false)));
            break;
        };
        (found, kept) = (next, without);
        left_out.extend(far);
    }
    if !left_out.is_empty() {
        left_out.sort_by_key(|far| far.sample);
        found.tell_left_out(internal, &kept, &left_out)?;
    }
    Ok(found)
}

impl SelfCalibration {
    /// Gives samples that were left out the poses where they agree best, and names them.
    fn tell_left_out(
        &mut self,
        internal: &InternalSamples,
        kept: &[usize],
        left_out: &[Far],
    ) -> Result<(), InputError> {
        let model = &self.fit.model;
        let all = InternalSamples { are_changes: self.counts_changes, ..internal.clone() };
        let places: Vec<usize> = left_out.iter().map(|far| far.sample).collect();
        let others = at_agreed_poses(model, &read_by(model, self.counts_changes, &internal.subset(&places))?)?;
        let mut poses = internal.samples.poses.clone();
        kept.iter().zip(&self.samples.poses).for_each(|(place, pose)| poses[*place] = *pose);
        places.iter().zip(&others.poses).for_each(|(place, pose)| poses[*place] = *pose);
        let mut samples = as_found(model, &all, &poses)?;
        samples.motor_angles = samples.motor_angles.filter(|_| !self.counts_changes);
        let m = model.cable_count();
        let residual = |far: &Far| {
            let apart = |cable: usize| {
                let length = modelled_length(model, cable, &poses[far.sample]);
                (length - samples.lengths[far.sample * m + cable]).powi(2)
            };
            (0..m).map(apart).sum::<f64>().sqrt()
        };
        let outlier = |far: &Far| Outlier {
            sample: far.sample + 1,
            line: line(internal, far.sample),
            residual_m: residual(far),
            weight: 0.0,
            reason: format!(
                "{} robust standard deviations at the pose that fits it best",
                three_digits(far.deviations)
            ),
        };
        self.fit.outliers = left_out.iter().map(outlier).collect();
        self.doubts.extend(left_out.iter().map(|far| doubt(internal, far, true)));
        self.samples = samples;
        Ok(())
    }
}

/// Line of a sample in its file.
fn line(internal: &InternalSamples, sample: usize) -> Option<usize> {
    internal.samples.lines.as_ref().and_then(|lines| lines.get(sample).copied())
}

fn doubt(internal: &InternalSamples, far: &Far, is_left_out: bool) -> Doubt {
    let line = line(internal, far.sample);
    let place = line.map_or_else(|| format!("sample {}", far.sample + 1), |line| format!("line {line}"));
    let treated = if is_left_out { "it is left out of the fit" } else { "the fit counts it fully" };
    let text = format!(
        "outlier: the sensors of {place} agree at no pose, by {} robust standard deviations ({OUTLIER_DEVIATIONS:.0} are allowed); {treated}",
        three_digits(far.deviations)
    );
    let finding = Finding::new(FindingKind::Outlier, Severity::Caution, text).of_size(far.deviations, "");
    Doubt::from(Finding { line, ..finding })
}
