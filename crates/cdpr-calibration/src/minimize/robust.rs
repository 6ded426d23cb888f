//! The optimum of residuals under a robust loss: one weight a sample.

use super::cost::descend_in;
use super::descent::End;
use super::unknowns::{Pace, Shape, Unknowns};
use crate::fit::InputError;
use crate::loss::{Loss, RobustLoss, Tail};
use crate::norms::{Extent, Norms, RESCALINGS, SAME_SCALE};
use crate::residual::rows::Rows;
use crate::residual::{Outliers, Residual};

/// The end under the loss of the settings, from an optimum of least squares, with the norms of its rows.
pub(super) fn under_loss(
    residual: &mut dyn Residual,
    unknowns: &Unknowns<'_>,
    squares: End,
) -> Result<(End, Norms), InputError> {
    let nothing_weighs = unknowns.len() == 0 && residual.weighing().is_some();
    let Some(outliers) = residual.outliers().filter(|_| !nothing_weighs) else {
        return Ok((squares, Norms::default()));
    };
    let norms = norms(residual, unknowns, &squares, None)?;
    let (loss, is_witnessed) = (unknowns.settings.loss, outliers == Outliers::Witnessed);
    let tail = norms.to_ask(loss, squares.converged()).filter(|_| outliers != Outliers::Counted);
    let Some(tail) = tail.filter(|_| !is_witnessed || loss != Loss::Auto || norms.any_beyond(1.0)) else {
        return Ok((squares, norms));
    };
    residual.weighing().into_iter().for_each(|weighing| weighing.keep());
    let (end, found) = minimise(residual, unknowns, tail, squares.clone(), norms.clone())?;
    let found = if is_witnessed { found.with_witness(norms.clone()) } else { found };
    let is_answer = found.answer(loss);
    if let Some(weighing) = residual.weighing() {
        weighing.finish();
        if !is_answer {
            weighing.come_back();
        }
    }
    Ok(if is_answer { (end, found) } else { (squares, norms) })
}

/// The least loss at a scale that agrees with its residuals.
fn minimise(
    residual: &mut dyn Residual,
    unknowns: &Unknowns<'_>,
    tail: Tail,
    mut end: End,
    mut norms: Norms,
) -> Result<(End, Norms), InputError> {
    let mut scale = norms.deviation;
    // a prior needs the scale of the noise
    let is_scaled = !norms.is_absolute() && unknowns.has_priors();
    for _ in 0..RESCALINGS {
        if let Some(weighing) = residual.weighing().filter(|_| is_scaled) {
            weighing.scale_noise(scale);
            scale = 1.0;
        }
        let loss = tail.at(norms.dimension(), scale);
        let agrees = follow(residual, unknowns, loss, &mut end)?;
        norms = self::norms(residual, unknowns, &end, Some(loss))?;
        let is_same = (norms.deviation / scale - 1.0).abs() < SAME_SCALE;
        if (agrees && is_same) || !norms.are_finite() {
            break;
        }
        scale = norms.deviation;
    }
    Ok((end, norms))
}

/// Descends under a loss of fixed scale; false where the weights have changed with its end.
fn follow(
    residual: &mut dyn Residual,
    unknowns: &Unknowns<'_>,
    loss: RobustLoss,
    end: &mut End,
) -> Result<bool, InputError> {
    if let Some(weighing) = residual.weighing() {
        return weighing.follow(loss, end, unknowns);
    }
    let pace = Pace { shape: Shape::Robust(loss), least_gain: residual.least_gain(1), patience: None };
    let near = descend_in(residual, 0, unknowns, &end.values, &pace);
    let trail = std::mem::take(&mut end.trail).then(near.trail);
    *end = End { iterations: end.iterations + near.iterations, trail, ..near };
    Ok(true)
}

/// Norms of the samples' rows at the end of a descent.
fn norms(
    residual: &mut dyn Residual,
    unknowns: &Unknowns<'_>,
    end: &End,
    loss: Option<RobustLoss>,
) -> Result<Norms, InputError> {
    let squares = match residual.squares(&end.values, unknowns, loss.is_some()) {
        Some(squares) => squares,
        None => {
            let mut rows = Rows::new(residual.layout(), end.values.len());
            residual.write(&end.values, &mut rows).then_some(()).ok_or(InputError::NotFinite)?;
            rows.squares()
        }
    };
    let extent =
        Extent { rows: residual.informative_rows(), parameters: unknowns.len(), absolute: residual.is_absolute() };
    Ok(Norms::new(squares, loss, extent))
}
