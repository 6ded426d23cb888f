//! Structure, parameters, samples and scaling: four factors whose product is the condition (Fig. 4.5).

use nalgebra::DMatrix;

use super::design;
use super::question::{Question, of_matrix};
use crate::fit::InputError;
use crate::identifiability::with_unit_columns;
use crate::plain_rows::PlainRows;
use cdpr_model::robot::ParameterKind;

/// One factor of the condition.
#[derive(Clone, Debug, PartialEq)]
pub struct Influence {
    /// `structure`, `parameters`, `samples` or `scaling`.
    pub name: &'static str,
    /// The factor; infinite where it makes the rank deficient.
    pub factor: f64,
    /// Words with numbers.
    pub words: String,
}

/// Largest condition that is written in full.
const LARGE: f64 = 1e5;

fn number(value: f64) -> String {
    match value {
        infinite if !infinite.is_finite() => "∞".to_owned(),
        large if large >= LARGE => format!("{large:.1e}"),
        small => format!("{small:.2}"),
    }
}

/// Factors in the order in which the condition of the first kind of parameters at the best samples becomes that in SI units on the data.
pub(super) fn of(question: &Question<'_>, matrix: &DMatrix<f64>) -> Result<Vec<Influence>, InputError> {
    let kinds = question.kinds();
    let corners = design::corners(question.model, &question.samples);
    let corners = corners.filter(|corners| corners.len() * question.model.cable_count() >= question.parameters.len());
    let designed = match &corners {
        Some(corners) => PlainRows::of(question.model, corners, &question.parameters, question.weights)?.jacobian,
        None => matrix.clone(),
    };
    let unit = |matrix: &DMatrix<f64>, kinds: &[ParameterKind]| {
        of_matrix(&with_unit_columns(question.columns(matrix, kinds))).1
    };
    let mut all = structure(question, &designed, &kinds, corners.is_some());
    let (of_design, of_data) = (unit(&designed, &kinds), unit(matrix, &kinds));
    if let Some(corners) = corners {
        let words = format!(
            "κ {} on the data, {} on {} samples at corners and middle of their box, columns of one length{}",
            number(of_data),
            number(of_design),
            corners.len(),
            if of_data < of_design { ": the data are better" } else { "" }
        );
        all.push(Influence { name: "samples", factor: of_data / of_design, words });
    }
    let unscaled = of_matrix(matrix).1;
    let words = format!("κ {} in SI units, {} with columns of one length", number(unscaled), number(of_data));
    all.push(Influence { name: "scaling", factor: unscaled / of_data, words });
    Ok(all)
}

fn structure(
    question: &Question<'_>,
    designed: &DMatrix<f64>,
    kinds: &[ParameterKind],
    has_corners: bool,
) -> Vec<Influence> {
    let of = |count: usize| of_matrix(&with_unit_columns(question.columns(designed, &kinds[..count])));
    let Some(first) = kinds.first() else { return Vec::new() };
    let (rank, alone) = of(1);
    let place = if has_corners { "corners and middle of the data's box" } else { "the data" };
    let words = format!("{first} alone at {place}, columns of one length: κ {}, rank {rank}", number(alone));
    let mut all = vec![Influence { name: "structure", factor: alone, words }];
    let conditions: Vec<(usize, f64)> = (1..=kinds.len()).map(of).collect();
    let step = |k: usize| format!("{} {}", kinds[k], number(conditions[k].1 / conditions[k - 1].1));
    let steps: Vec<String> = (1..kinds.len()).map(step).collect();
    let factor = conditions[kinds.len() - 1].1 / alone;
    let words = match steps.is_empty() {
        true => "one kind only".to_owned(),
        false => format!(
            "κ {} and rank {} with all kinds; factors as they are added: {}",
            number(conditions[kinds.len() - 1].1),
            conditions[kinds.len() - 1].0,
            steps.join(", ")
        ),
    };
    all.push(Influence { name: "parameters", factor, words });
    all
}
