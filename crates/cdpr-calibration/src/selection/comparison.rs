//! Criterion of every candidate on the validation samples that all compared candidates answer.

use super::settings::Settings;
use super::{HeldOut, JudgedCandidate, Judgement, SelectionCriterion};
use crate::bootstrap;
use crate::loss::Loss;
use crate::outliers::unexplained;

/// Share of the validation samples that a candidate must answer: the mean of the rest alone would flatter it.
const LEAST_ANSWERED: f64 = 0.95;

/// Writes criterion and standard error of every candidate, and why the others cannot be compared.
///
/// A sample that one of the compared candidates leaves without an answer counts for none of them, so that all means are
/// over the same samples.
pub(super) fn compare(candidates: &mut [JudgedCandidate], settings: &Settings) {
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
    compare_regions(&mut judgements, settings);
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
