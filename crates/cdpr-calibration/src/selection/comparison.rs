//! Criterion of every candidate on the validation samples that all compared candidates answer.

use super::settings::Settings;
use super::{HeldOut, JudgedCandidate, Judgement, SelectionCriterion};
use crate::bootstrap;
use crate::evaluation::Evaluation;
use crate::loss::Loss;
use crate::outliers::unexplained;
use crate::paired::{Difference, platform_radius};
use cdpr_model::robot::Robot;

/// Share of the validation samples that a candidate must answer: the mean of the rest alone would flatter it.
const LEAST_ANSWERED: f64 = 0.95;

/// The error of a sample by which candidates are compared.
#[derive(Clone, Copy)]
pub(super) enum Compared {
    /// Error of the criterion alone.
    Criterion(SelectionCriterion),
    /// √(‖Δr‖² + (L Δθ)²), L the root mean square distance of the platform anchors from their origin (m).
    Pose(f64),
}

impl Compared {
    /// The whole pose where a robot turns and the criterion does not decide alone.
    pub(super) fn of(robot: &Robot, settings: &Settings) -> Self {
        let is_of_poses = settings.criterion == SelectionCriterion::Position && !settings.decides_alone;
        match is_of_poses && robot.motion_pattern.has_rotation() {
            true => Self::Pose(platform_radius(robot)),
            false => Self::Criterion(settings.criterion),
        }
    }

    /// Unit of the errors.
    fn unit(self) -> &'static str {
        match self {
            Self::Criterion(SelectionCriterion::Rotation) => "rad",
            Self::Criterion(SelectionCriterion::Tension) => "N",
            Self::Criterion(_) | Self::Pose(_) => "m",
        }
    }

    /// The error of each sample.
    pub(super) fn errors(self, evaluation: &Evaluation) -> Vec<f64> {
        match self {
            Self::Criterion(criterion) => criterion.of(evaluation),
            Self::Pose(radius) => {
                let of = |(distance, angle): (&f64, &f64)| distance.hypot(radius * angle);
                evaluation.position.iter().zip(&evaluation.rotation).map(of).collect()
            }
        }
    }
}

/// How the errors of samples are compared.
pub(super) struct Comparing<'a> {
    pub(super) settings: &'a Settings,
    pub(super) compared: Compared,
    /// A number for every sample of the data, the same for repeated poses.
    pub(super) groups: &'a [usize],
}

/// Writes criterion, standard error and difference to the best of every candidate, and why the others cannot be compared.
///
/// A sample that one of the compared candidates leaves without an answer counts for none of them, so that all means are
/// over the same samples.
pub(super) fn compare(candidates: &mut [JudgedCandidate], comparing: &Comparing<'_>) {
    let settings = comparing.settings;
    let Settings { criterion, seed, .. } = *settings;
    let mut judgements: Vec<&mut Judgement> =
        candidates.iter_mut().filter_map(|candidate| candidate.outcome.as_mut().ok()).collect();
    let series: Vec<Vec<f64>> = judgements.iter().map(|judgement| criterion.of(&judgement.validation_errors)).collect();
    for (judgement, series) in judgements.iter_mut().zip(&series) {
        judgement.disqualified = too_few(judgement, series, criterion);
    }
    let compared = || judgements.iter().zip(&series).filter(|(judgement, _)| judgement.disqualified.is_none());
    let rows: Vec<&[f64]> = compared().map(|(_, series)| series.as_slice()).collect();
    let (set_aside, common) = common_samples(&rows, settings);
    for (judgement, series) in judgements.iter_mut().zip(&series) {
        judgement.set_aside.clone_from(&set_aside);
        judgement.take_figures(&settings.requirements);
        if judgement.disqualified.is_some() {
            continue;
        }
        let HeldOut { criterion, standard_error, samples } = held_out(series, &common, seed);
        (judgement.criterion, judgement.standard_error) = (criterion, standard_error);
        judgement.compared_samples = samples;
    }
    write_differences(&mut judgements, &common, comparing);
    compare_regions(&mut judgements, settings);
}

/// Writes the differences of the compared candidates to the best of those whose fit converged, on the samples that all of them answer.
fn write_differences(judgements: &mut [&mut Judgement], common: &[usize], comparing: &Comparing<'_>) {
    let mut compared: Vec<&mut &mut Judgement> =
        judgements.iter_mut().filter(|judgement| judgement.disqualified.is_none()).collect();
    let of_common = |judgement: &Judgement| -> Vec<f64> {
        let errors = comparing.compared.errors(&judgement.validation_errors);
        common.iter().map(|&sample| errors[sample]).collect()
    };
    let series: Vec<Vec<f64>> = compared.iter().map(|judgement| of_common(judgement)).collect();
    for (judgement, series) in compared.iter_mut().zip(&series) {
        judgement.compared_mean = series.iter().sum::<f64>() / series.len() as f64;
    }
    let finite = compared.iter().enumerate().filter(|(_, own)| own.has_converged() && own.compared_mean.is_finite());
    let best = finite.min_by(|a, b| a.1.compared_mean.total_cmp(&b.1.compared_mean)).map(|(place, _)| place);
    let Some(best) = best else { return };
    let group = |&place: &usize| comparing.groups.get(compared[best].validation_samples[place]).copied();
    let groups: Vec<usize> = common.iter().map(|place| group(place).unwrap_or(*place)).collect();
    for (judgement, own) in compared.iter_mut().zip(&series) {
        judgement.compared_unit = comparing.compared.unit();
        judgement.is_compared_by_pose = matches!(comparing.compared, Compared::Pose(_));
        judgement.difference = Some(Difference::to_best(&series[best], own, &groups, comparing.settings.seed));
    }
}

/// Criterion on the regions left out besides, for the candidates that are compared.
fn compare_regions(judgements: &mut [&mut Judgement], settings: &Settings) {
    let mut compared: Vec<(&mut &mut Judgement, Vec<f64>)> = judgements
        .iter_mut()
        .filter(|judgement| judgement.disqualified.is_none())
        .filter_map(|judgement| {
            let series = settings.criterion.of(judgement.region_errors.as_ref()?);
            Some((judgement, series))
        })
        .collect();
    let rows: Vec<&[f64]> = compared.iter().map(|(_, series)| series.as_slice()).collect();
    let (_, common) = common_samples(&rows, settings);
    for (judgement, series) in &mut compared {
        judgement.regions = Some(held_out(series, &common, settings.seed));
    }
}

fn held_out(series: &[f64], common: &[usize], seed: u64) -> HeldOut {
    let values: Vec<f64> = common.iter().map(|&sample| series[sample]).collect();
    let samples = values.len();
    let criterion = values.iter().sum::<f64>() / samples as f64;
    HeldOut { criterion, standard_error: bootstrap::standard_error(&values, seed), samples }
}

/// Samples that no candidate explains, and the others that all of them answer.
fn common_samples(series: &[&[f64]], settings: &Settings) -> (Vec<usize>, Vec<usize>) {
    let samples = series.first().map_or(0, |series| series.len());
    let least = (0..samples).map(|sample| series.iter().map(|series| series[sample]).fold(f64::NAN, f64::min));
    let set_aside = if settings.fit.loss == Loss::Squared { Vec::new() } else { unexplained(least) };
    let is_common = |sample: &usize| series.iter().all(|series| series[*sample].is_finite());
    let is_kept = |sample: &usize| set_aside.binary_search(sample).is_err();
    let common = (0..samples).filter(is_common).filter(is_kept).collect();
    (set_aside, common)
}

/// The reason against a candidate that answers too few samples.
fn too_few(judgement: &Judgement, series: &[f64], criterion: SelectionCriterion) -> Option<String> {
    let answered = series.iter().filter(|value| value.is_finite()).count();
    if answered > 0 && answered as f64 >= LEAST_ANSWERED * series.len() as f64 {
        return None;
    }
    let quantity = criterion.quantity();
    let mut text = format!("it predicts a {quantity} for {answered} of {} validation samples", series.len());
    if let Some((row, reason)) = judgement.validation_errors.not_converged.first() {
        let sample = judgement.validation_samples.get(*row).unwrap_or(row) + 1;
        text.push_str(&format!(" (sample {sample}: {reason})"));
    }
    Some(text)
}
