//! A map made of samples, and judged on samples that it was not made of.

use nalgebra::DMatrix;
use serde::Serialize;

use super::compensation_error::CompensationError;
use crate::compensation::{Compensation, MapError};
use crate::geometry::Pose;
use crate::identification::evaluation::{
    ErrorBlocks, Evaluation, EvaluationError, evaluate_corrected, evaluate_fitted,
};
use crate::identification::standard_error;
use crate::measurement::{Fold, Samples, Split};
use crate::model::Model;

/// Least number of samples that a map is made of.
const LEAST: usize = 10;

/// Most samples of a map; of more, so many are taken evenly.
const MOST: usize = 400;

/// Parts that are held out in turn.
const PARTS: usize = 5;

/// Gain of the mean square length error in standard errors that is no chance.
const SURE: f64 = 2.0;

/// Root mean square length error with the map, as a share of that without, that is worth a map.
const WORTH: f64 = 0.95;

/// Errors on samples held out in turn, without the map and with maps of the others.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Judged {
    /// Samples.
    pub samples: usize,
    /// Samples beyond the others, where their map says nothing and the model stands alone.
    pub outside: usize,
    /// Errors of the model alone.
    pub without: ErrorBlocks,
    /// Errors with the map.
    pub with: ErrorBlocks,
    /// Fall of the mean square length error (m²).
    pub gain_m2: f64,
    /// Its standard error (m²).
    pub gain_standard_error_m2: f64,
}

/// A map with what it is worth.
#[must_use = "a map that does not help is not to be used"]
#[derive(Clone, Debug)]
pub struct Compensated {
    /// Map of all samples.
    pub map: Compensation,
    /// Errors on samples held out.
    pub judged: Judged,
    /// Reason in words to leave the map out; nothing where it helps.
    pub reason: Option<String>,
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
    Ok(Compensated { reason: refusal(&judged), map, judged })
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
    let mut outside = 0;
    for fold in folds {
        let map = map_of(model, &samples.subset(&fold.train), &alone.subset(&fold.train))?;
        without.extend(&alone.subset(&fold.validation));
        let (own, beyond) = evaluate_compensated(model, &samples.subset(&fold.validation), &map)?;
        with.extend(&own);
        outside += beyond.len();
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
        outside,
        without: without.blocks(),
        with: with.blocks(),
        gain_m2: gains.iter().sum::<f64>() / gains.len().max(1) as f64,
        gain_standard_error_m2: standard_error(&gains, seed),
    })
}

/// Reason to leave the map out.
fn refusal(judged: &Judged) -> Option<String> {
    let Judged { without, with, gain_m2, gain_standard_error_m2, .. } = judged;
    let (before, after) = (1e3 * without.length_error_m.rms, 1e3 * with.length_error_m.rms);
    // no gain is sure that is not a number
    if !(*gain_m2 > SURE * gain_standard_error_m2 && after < WORTH * before) {
        return Some(format!(
            "on samples held out the map does not help: length errors are {after:.3} mm rms with it and {before:.3} mm without, so that what the model leaves \
             is noise, or changes too fast over the workspace for these samples"
        ));
    }
    let (before, after) = (1e3 * without.position_error_m.mean, 1e3 * with.position_error_m.mean);
    (after > before).then(|| {
        format!("on samples held out lengths are better with the map, but poses are not: {after:.3} mm with it, {before:.3} mm without")
    })
}

/// Errors of a model with a map on samples, and the samples beyond it, at which the model stands alone.
pub fn evaluate_compensated(
    model: &Model,
    samples: &Samples,
    map: &Compensation,
) -> Result<(Evaluation, Vec<usize>), EvaluationError> {
    let evaluation = evaluate_corrected(model, samples, map)?;
    let outside = (0..samples.len()).filter(|&sample| map.at(&samples.poses[sample]).is_err()).collect();
    Ok((evaluation, outside))
}
