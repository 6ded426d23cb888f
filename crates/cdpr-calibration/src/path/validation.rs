//! Errors along a path on samples that its fits had not seen, and the penalty that they choose.

use super::course::{Place, Question};
use crate::bootstrap;
use crate::evaluation::evaluate_fitted;
use crate::fit::InputError;
use crate::paired::{as_good_as_best, repeated_poses};
use crate::point_robot::{as_point, without_rotation};
use cdpr_model::measurement::{Fold, Samples};
use cdpr_model::model::Model;

/// Places that answer this share of the samples that the best one answers are rated, on the samples that all of them answer.
const RATED: f64 = 0.9;

/// Mean errors at all penalties with that of the best, its standard error and the choice.
pub(super) struct Validated {
    /// Not a number where a penalty has no error.
    pub(super) errors: Vec<f64>,
    pub(super) standard_errors: Vec<f64>,
    pub(super) best: usize,
    pub(super) chosen: usize,
}

/// Follows the path on every training part, with penalties in proportion to its samples, and judges each place by what was held out; `None`
/// where no place predicts a sample.
pub(super) fn validated(
    question: &Question<'_>,
    samples: &Samples,
    folds: &[Fold],
    followed: usize,
    places: &[Place],
) -> Result<Option<Validated>, InputError> {
    let mut series = vec![Vec::new(); places.len()];
    for fold in folds {
        let fraction = fold.train.len() as f64 / followed as f64;
        let lambdas: Vec<f64> = places.iter().map(|place| place.lambda * fraction).collect();
        let of_fold = match folds.len() {
            1 => places.to_vec(),
            _ => question.follow(&samples.subset(&fold.train), Some(&lambdas))?,
        };
        let held = samples.subset(&fold.validation);
        for (errors, place) in series.iter_mut().zip(&of_fold) {
            errors.extend(errors_at(question, &held, place));
        }
    }
    let answered = |errors: &[f64]| errors.iter().filter(|error| error.is_finite()).count() as f64;
    let most = series.iter().map(|errors| answered(errors)).fold(0.0, f64::max);
    let is_rated: Vec<bool> = series.iter().map(|errors| most > 0.0 && answered(errors) >= RATED * most).collect();
    let rated = || series.iter().zip(&is_rated).filter(|(_, is_rated)| **is_rated).map(|(errors, _)| errors);
    let count = rated().map(Vec::len).min().unwrap_or(0);
    let common: Vec<usize> = (0..count).filter(|&sample| rated().all(|errors| errors[sample].is_finite())).collect();
    if common.is_empty() {
        return Ok(None);
    }
    let of_common = |(errors, is_rated): (&Vec<f64>, &bool)| match is_rated {
        true => common.iter().map(|&sample| errors[sample]).collect::<Vec<f64>>(),
        false => Vec::new(),
    };
    let series: Vec<Vec<f64>> = series.iter().zip(&is_rated).map(of_common).collect();
    let errors: Vec<f64> = series.iter().map(|errors| errors.iter().sum::<f64>() / errors.len() as f64).collect();
    let seed = question.settings.seed;
    let standard_errors: Vec<f64> = series.iter().map(|errors| bootstrap::standard_error(errors, seed)).collect();
    let poses = repeated_poses(question.model.robot(), samples);
    let held: Vec<usize> = folds.iter().flat_map(|fold| fold.validation.iter().copied()).collect();
    let groups: Vec<usize> = common.iter().map(|&place| poses[held[place]]).collect();
    let Some((best, as_good)) = as_good_as_best(&series, &groups, seed) else { return Ok(None) };
    // penalties fall along the path: the first place that is as good is the simplest
    let chosen = as_good.iter().position(|as_good| *as_good).unwrap_or(best);
    Ok(Some(Validated { errors, standard_errors, best, chosen }))
}

/// Errors of all samples held out, of a model without platform anchors as those of a point.
fn errors_at(question: &Question<'_>, held: &Samples, place: &Place) -> Vec<f64> {
    let errors = |model: Model| match as_point(&model) {
        Some(point) => evaluate_fitted(&point, &without_rotation(held)).ok(),
        None => evaluate_fitted(&model, held).ok(),
    };
    let model = question.model.with_parameters(question.parameters, &place.values);
    model.and_then(errors).map_or_else(|| vec![f64::NAN; held.len()], |errors| question.path.criterion.of(&errors))
}
