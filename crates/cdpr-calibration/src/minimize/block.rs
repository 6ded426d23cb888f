//! Descent in one block of parameters.

use super::cost::Cost;
use super::dense::DenseEquations;
use super::descent::{End, descend};
use super::unknowns::{Pace, Shape, Unknowns};
use crate::residual::Residual;

/// Searches for better places of what is eliminated from the rows, at most.
const SEARCHES: u32 = 10;

/// Descends in a block by a cost of the norms, and on from better places of what is eliminated.
pub(super) fn descend_in(
    residual: &mut dyn Residual,
    block: usize,
    own: &Unknowns<'_>,
    from: &[f64],
    pace: &Pace,
) -> End {
    residual.restart();
    if let Some(end) = residual.descend(block, from, own, pace) {
        return end;
    }
    let (around, rules) = (own.around(pace.shape == Shape::Square), own.rules(pace));
    let mut cost = Cost { residual, block, unknowns: own, shape: pace.shape, rows: None };
    let mut end = descend(&mut cost, &around, from, DenseEquations::new(from.len()), &rules);
    for _ in 0..SEARCHES {
        if !end.cost.is_finite() || !cost.residual.seek_again(&end.values) {
            break;
        }
        let next = descend(&mut cost, &around, &end.values, DenseEquations::new(from.len()), &rules);
        let trail = end.trail.then(next.trail);
        end = End { iterations: end.iterations + next.iterations, trail, ..next };
    }
    end
}
