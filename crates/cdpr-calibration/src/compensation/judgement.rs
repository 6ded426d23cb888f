//! A map made of samples, and judged on samples that it was not made of.

use nalgebra::DMatrix;

use super::compensation_error::CompensationError;
use super::judged::Judged;
use crate::evaluation::{Evaluation, EvaluationError, evaluate_corrected, evaluate_fitted};
use crate::standard_error;
use cdpr_model::compensation::{Beyond, Compensation, MapError};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Fold, Samples, Split};
use cdpr_model::model::Model;

/// Least number of samples that a map is made of.
const LEAST: usize = 10;

/// Most samples of a map; of more, so many are taken evenly.
const MOST: usize = 400;

/// Parts that are held out in turn.
const PARTS: usize = 5;

/// A map with what it is worth.
#[must_use = "a map that does not help is not to be used"]
#[derive(Clone, Debug)]
pub struct Compensated {
    /// Map of all samples.
    pub map: Compensation,
    /// Errors on samples held out.
    pub judged: Judged,
    /// True where it is worth using by every rule.
    pub helps: bool,
    /// Verdict in words, and the rules by which it is given.
    pub reason: String,
}

/// Makes a map of what a model leaves of samples, and judges it on parts held out in turn: contiguous ones where samples have times, random ones elsewhere.
pub fn compensate(
    model: &Model,
    samples: &Samples,
    split: Option<Split>,
    seed: u64,
) -> Result<Compensated, CompensationError> {
    let samples = &*model.with_lengths(samples)?;
    let alone = evaluate_fitted(model, samples)?;
    let known = alone.blocks().length_samples;
    if known < LEAST {
        return Err(CompensationError::TooFewSamples { samples: known, least: LEAST });
    }
    let map = map_of(model, samples, &alone)?;
    let usual = if samples.time.is_some() { Split::Blocks(PARTS) } else { Split::KFold(PARTS) };
    let folds = split.unwrap_or(usual).folds(samples, seed)?;
    let judged = judge(model, (samples, &alone), &folds, seed)?;
    let (helps, reason) = judged.verdict();
    Ok(Compensated { map, judged, helps, reason })
}

/// The map of a model's errors on samples; `errors` are those of the model alone.
fn map_of(model: &Model, samples: &Samples, errors: &Evaluation) -> Result<Compensation, MapError> {
    let cables = model.cable_count();
    let of_sample = |sample: &usize| &errors.length[sample * cables..][..cables];
    let known = |sample: &usize| of_sample(sample).iter().all(|error| error.is_finite());
    let all: Vec<usize> = (0..samples.len()).filter(known).collect();
    let taken = all.len().min(MOST);
    let used: Vec<usize> = (0..taken).map(|place| all[place * all.len() / taken]).collect();
    let poses: Vec<Pose> = used.iter().map(|&sample| samples.poses[sample]).collect();
    let corrections = DMatrix::from_fn(used.len(), cables, |row, cable| -errors.length[used[row] * cables + cable]);
    Compensation::through(model, &poses, &corrections)
}

fn judge(
    model: &Model,
    (samples, alone): (&Samples, &Evaluation),
    folds: &[Fold],
    seed: u64,
) -> Result<Judged, CompensationError> {
    let (mut without, mut with) = (Evaluation::default(), Evaluation::default());
    let mut beyond = Beyond::default();
    for fold in folds {
        let map = map_of(model, &samples.subset(&fold.train), &alone.subset(&fold.train))?;
        without.extend(&alone.subset(&fold.validation));
        let (own, beyond_own) = evaluate_compensated(model, &samples.subset(&fold.validation), &map)?;
        with.extend(&own);
        beyond = beyond.and(beyond_own);
    }
    let cables = model.cable_count().max(1);
    let squares = |errors: &Evaluation| -> Vec<f64> {
        errors.length.chunks(cables).map(|own| own.iter().map(|x| x * x).sum::<f64>() / cables as f64).collect()
    };
    let gains: Vec<f64> = squares(&without)
        .iter()
        .zip(squares(&with))
        .map(|(without, with)| without - with)
        .filter(|gain| gain.is_finite())
        .collect();
    Ok(Judged {
        samples: without.len(),
        beyond,
        without: without.blocks(),
        with: with.blocks(),
        gain_m2: gains.iter().sum::<f64>() / gains.len().max(1) as f64,
        gain_standard_error_m2: standard_error(&gains, seed),
    })
}

/// Errors of a model with a map on samples, and the samples at which the map fades or is zero.
pub fn evaluate_compensated(
    model: &Model,
    samples: &Samples,
    map: &Compensation,
) -> Result<(Evaluation, Beyond), EvaluationError> {
    let evaluation = evaluate_corrected(model, samples, map)?;
    Ok((evaluation, Beyond::of(samples.poses.iter().map(|pose| map.at(pose).fraction))))
}
