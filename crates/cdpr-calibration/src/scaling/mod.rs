//! Condition of the Jacobian: scales of kinds of parameters, weights of kinds of rows, and what makes it large (eq. 4.42, Figs. 4.5, 4.12).

mod design;
mod influences;
mod least;
mod question;
#[cfg(test)]
mod tests;

use super::fit::{InputError, RowWeights, Settings};
use super::identifiability::with_unit_columns;
use super::plain_rows::PlainRows;
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, Model};
use cdpr_model::robot::ParameterKind;
pub use influences::Influence;
pub use question::{KindScale, scaled_kind};
use question::{Question, of_matrix};

/// Condition of the Jacobian of a model on data.
#[derive(Clone, Debug, PartialEq)]
pub struct Conditioning {
    /// Weights of the rows.
    pub row_weights: RowWeights,
    /// Free parameters and the rank of their Jacobian.
    pub parameter_count: usize,
    /// Rank.
    pub rank: usize,
    /// κ in SI units.
    pub condition: f64,
    /// κ with columns of length one.
    pub condition_unit_columns: f64,
    /// Kinds, each alone.
    pub kinds: Vec<KindCondition>,
    /// Scales, as given or found.
    pub scales: Vec<KindScale>,
    /// κ under these scales.
    pub condition_scaled: f64,
    /// Factors of κ in SI units.
    pub influences: Vec<Influence>,
}

/// Condition of one kind of parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct KindCondition {
    /// The kind.
    pub kind: ParameterKind,
    /// Its parameters.
    pub parameter_count: usize,
    /// κ of their columns alone.
    pub condition: f64,
}

/// κ over scales of two kinds.
#[derive(Clone, Debug, PartialEq)]
pub struct ConditionMap {
    /// The kinds.
    pub kinds: [ParameterKind; 2],
    /// Scales of both and κ, the first running fastest.
    pub points: Vec<([f64; 2], f64)>,
}

/// Steps of a map in decades and their number to each side of the scales that make columns as long as the others.
const DECADES: f64 = 0.25;
const STEPS: i32 = 12;

/// Condition of the free parameters' Jacobian at a model and what was measured, with scales as given; those of the least condition where none are.
pub fn conditioning(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &Settings,
    scales: &[KindScale],
) -> Result<Conditioning, InputError> {
    let question = Question::new(model, samples, free, settings)?;
    let matrix = PlainRows::of(model, &question.samples, &question.parameters, question.weights)?.jacobian;
    let kinds = question.kinds();
    let scales = match scales.is_empty() {
        true => least::scales(&matrix, &question.parameters, &kinds),
        false => scales.to_vec(),
    };
    let (rank, condition) = of_matrix(&matrix);
    let alone = |&kind: &ParameterKind| {
        let own = question.columns(&matrix, &[kind]);
        KindCondition { kind, parameter_count: own.ncols(), condition: of_matrix(&own).1 }
    };
    Ok(Conditioning {
        row_weights: question.weights,
        parameter_count: question.parameters.len(),
        rank,
        condition,
        condition_unit_columns: of_matrix(&with_unit_columns(matrix.clone())).1,
        kinds: kinds.iter().map(alone).collect(),
        condition_scaled: of_matrix(&question.scaled(&matrix, &scales)).1,
        influences: influences::of(&question, &matrix)?,
        scales,
    })
}

/// κ over the scales of two kinds, three decades to each side of those that make their columns as long as the others; further scales as given.
pub fn condition_map(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &Settings,
    scales: &[KindScale],
    kinds: [ParameterKind; 2],
) -> Result<ConditionMap, InputError> {
    let question = Question::new(model, samples, free, settings)?;
    let matrix = PlainRows::of(model, &question.samples, &question.parameters, question.weights)?.jacobian;
    let others: Vec<KindScale> = scales.iter().copied().filter(|scale| !kinds.contains(&scale.kind)).collect();
    let rest = question.scaled(&matrix, &others);
    let Some(centres) = question.centres(&rest, kinds) else {
        let names = kinds.map(ParameterKind::name);
        return Err(InputError::ScaledTwice { names: format!("{} and {}", names[0], names[1]) });
    };
    let factor = |centre: f64, step: i32| centre * 10_f64.powf(DECADES * f64::from(step));
    let mut points = Vec::new();
    for second in -STEPS..=STEPS {
        for first in -STEPS..=STEPS {
            let at = [factor(centres[0], first), factor(centres[1], second)];
            let pair = [0, 1].map(|k| KindScale { kind: kinds[k], factor: at[k] });
            points.push((at, of_matrix(&question.scaled(&rest, &pair)).1));
        }
    }
    Ok(ConditionMap { kinds, points })
}
