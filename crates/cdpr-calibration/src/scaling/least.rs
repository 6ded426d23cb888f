//! Scales of the least condition.

use nalgebra::DMatrix;

use super::question::KindScale;
use crate::identifiability::singular_values;
use cdpr_model::robot::{Parameter, ParameterKind};
use cdpr_model::scalar::TriangularFactor;

/// Decades of the first step, and of the last.
const STEPS: (f64, f64) = (0.5, 1e-3);

/// Scales of kinds, the first one 1, that no change of a single one improves: from columns of one length on average, kind after kind by steps that
/// become shorter.
pub(super) fn scales(matrix: &DMatrix<f64>, parameters: &[Parameter], kinds: &[ParameterKind]) -> Vec<KindScale> {
    if kinds.is_empty() {
        return Vec::new();
    }
    // the condition is that of the triangular factor
    let factor = TriangularFactor::of(matrix).into_matrix();
    let of_kind = |kind: ParameterKind| (0..parameters.len()).filter(move |&k| parameters[k].kind == kind);
    let length = |kind: ParameterKind| {
        let squares: Vec<f64> = of_kind(kind).map(|k| matrix.column(k).norm_squared()).collect();
        (squares.iter().sum::<f64>() / squares.len() as f64).sqrt().max(f64::MIN_POSITIVE)
    };
    let mut decades: Vec<f64> = kinds.iter().map(|&kind| (length(kinds[0]) / length(kind)).log10()).collect();
    let condition = |decades: &[f64]| {
        let mut scaled = factor.clone();
        for (k, mut column) in scaled.column_iter_mut().enumerate() {
            let place = kinds.iter().position(|&kind| kind == parameters[k].kind).unwrap_or(0);
            column *= 10_f64.powf(decades[place]);
        }
        let values = singular_values(scaled);
        let largest = values.iter().copied().fold(0.0, f64::max);
        largest / values.iter().copied().fold(f64::INFINITY, f64::min)
    };
    let (mut least, mut step) = (condition(&decades), STEPS.0);
    while step >= STEPS.1 && least.is_finite() {
        let mut is_better = false;
        for place in 1..kinds.len() {
            for side in [-step, step] {
                let mut other = decades.clone();
                other[place] += side;
                let found = condition(&other);
                if found < least * (1.0 - 1e-9) {
                    (least, decades, is_better) = (found, other, true);
                }
            }
        }
        if !is_better {
            step *= 0.5;
        }
    }
    kinds.iter().zip(decades).map(|(&kind, decade)| KindScale { kind, factor: 10_f64.powf(decade) }).collect()
}
