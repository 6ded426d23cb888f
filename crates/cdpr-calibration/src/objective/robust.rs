//! The optimum of residual vectors under a robust loss: one weight a sample.

use super::cost::Shape;
use super::fit::Search;
use super::vectors::{Outliers, Stacked, Vectors};
use crate::fit::InputError;
use crate::joint_descent::End;
use crate::loss::{Loss, RobustLoss, Tail};
use crate::norms::{Extent, Norms, RESCALINGS, SAME_SCALE};

/// Move of parameters that no outlier is told apart by (m).
const NEARBY: f64 = 1e-6;

impl Search<'_> {
    /// The end under the loss of the settings, from an optimum of least squares, with the norms of its vectors.
    pub(super) fn under_loss(
        &self,
        vectors: &mut impl Vectors,
        squares: End,
        absolute: bool,
    ) -> Result<(End, Norms), InputError> {
        let Some(outliers) = vectors.outliers() else { return Ok((squares, Norms::default())) };
        let norms = match self.norms_nearby(vectors, &squares, absolute) {
            Some(norms) => norms,
            None => norms(vectors, &squares, None, absolute)?,
        };
        let is_witnessed = outliers == Outliers::Witnessed;
        let tail = norms.to_ask(self.settings.loss, squares.converged());
        let Some(tail) = tail.filter(|_| !is_witnessed || self.settings.loss != Loss::Auto || norms.any_beyond(1.0))
        else {
            return Ok((squares, norms));
        };
        let (end, found) = self.minimise(vectors, tail, (squares.clone(), norms.clone()))?;
        let found = if is_witnessed { found.with_witness(norms.clone()) } else { found };
        Ok(if found.answer(self.settings.loss) { (end, found) } else { (squares, norms) })
    }

    /// Norms where the squares were written last, if that is where the end is.
    fn norms_nearby(&self, vectors: &impl Vectors, end: &End, absolute: bool) -> Option<Norms> {
        let (at, squares) = vectors.squares()?;
        let is_there = |((at, to), scale): ((&f64, &f64), &f64)| ((at - to) * scale).abs() <= NEARBY;
        let is_near = at.iter().zip(&end.values).zip(self.scale).all(is_there);
        let extent = Extent { rows: squares.len() * vectors.size(), parameters: end.values.len(), absolute };
        is_near.then(|| Norms::new(squares, None, extent))
    }

    /// The least loss at a scale that agrees with its residuals.
    fn minimise(
        &self,
        vectors: &mut impl Vectors,
        tail: Tail,
        (mut end, mut norms): (End, Norms),
    ) -> Result<(End, Norms), InputError> {
        let mut scale = norms.deviation;
        for _ in 0..RESCALINGS {
            let loss = tail.at(norms.dimension(), scale);
            let near = self.descend_under(Shape::Robust(loss), vectors, &end.values, None);
            end = End { iterations: end.iterations + near.iterations, trail: end.trail.then(near.trail), ..near };
            norms = self::norms(vectors, &end, Some(loss), norms.is_absolute())?;
            if (norms.deviation / scale - 1.0).abs() < SAME_SCALE || !norms.are_finite() {
                break;
            }
            scale = norms.deviation;
        }
        Ok((end, norms))
    }
}

/// Norms of the samples' vectors at the end of a descent.
fn norms(vectors: &mut impl Vectors, end: &End, loss: Option<RobustLoss>, absolute: bool) -> Result<Norms, InputError> {
    let mut stacked = Stacked::new(vectors, end.values.len());
    if !vectors.write(&end.values, &mut stacked) {
        return Err(InputError::NotFinite);
    }
    let extent = Extent { rows: stacked.free_rows(), parameters: end.values.len(), absolute };
    Ok(Norms::new((0..stacked.samples()).map(|sample| stacked.square(sample)).collect(), loss, extent))
}
