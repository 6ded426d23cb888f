//! Jacobian that is asked about, and scales of its columns.

use std::borrow::Cow;
use std::str::FromStr;

use nalgebra::DMatrix;

use crate::fit::{InputError, RowWeights, Settings, checked_parameters};
use crate::identifiability::{rank_and_condition, singular_values};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, Model, identified_kind};
use cdpr_model::robot::{Parameter, ParameterKind};
use cdpr_model::scalar::TriangularFactor;

/// Scale of a kind of parameters: the unit in which they are counted, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KindScale {
    /// The kind; axial stiffness stands for compliance, counted by k_F = 1/compliance.
    pub kind: ParameterKind,
    /// Its unit.
    pub factor: f64,
}

impl FromStr for KindScale {
    type Err = InputError;

    /// Reads `wrench=1e3`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let syntax = || InputError::ScaleSyntax { text: text.to_owned() };
        let (name, value) = text.split_once('=').ok_or_else(syntax)?;
        let factor: f64 = value.trim().parse().map_err(|_| syntax())?;
        if !(factor > 0.0 && factor.is_finite()) {
            return Err(syntax());
        }
        Ok(Self { kind: scaled_kind(name)?, factor })
    }
}

/// Kind that a scale can be of.
pub fn scaled_kind(name: &str) -> Result<ParameterKind, InputError> {
    match name.trim() {
        stiffness if stiffness == ParameterKind::AxialStiffness.name() => Ok(ParameterKind::AxialStiffness),
        other => Ok(identified_kind(other)?),
    }
}

/// Rank and κ.
pub(super) fn of_matrix(matrix: &DMatrix<f64>) -> (usize, f64) {
    rank_and_condition(&singular_values(TriangularFactor::of(matrix).into_matrix()), matrix.nrows())
}

/// Jacobian that is asked about.
pub(super) struct Question<'a> {
    pub(super) model: &'a Model,
    pub(super) samples: Cow<'a, Samples>,
    pub(super) parameters: Vec<Parameter>,
    pub(super) weights: RowWeights,
}

impl<'a> Question<'a> {
    pub(super) fn new(
        model: &'a Model,
        samples: &'a Samples,
        free: &FreeParameters,
        settings: &Settings,
    ) -> Result<Self, InputError> {
        let parameters = checked_parameters(model, samples, free, settings)?;
        let weights = settings.row_weights.unwrap_or_default();
        Ok(Self { model, samples: model.with_lengths(samples)?, parameters, weights })
    }

    /// Kinds of the parameters, each once.
    pub(super) fn kinds(&self) -> Vec<ParameterKind> {
        let mut kinds = Vec::new();
        for parameter in &self.parameters {
            if !kinds.contains(&parameter.kind) {
                kinds.push(parameter.kind);
            }
        }
        kinds
    }

    pub(super) fn columns(&self, matrix: &DMatrix<f64>, kinds: &[ParameterKind]) -> DMatrix<f64> {
        let own = (0..self.parameters.len()).filter(|&k| kinds.contains(&self.parameters[k].kind));
        matrix.select_columns(&own.collect::<Vec<usize>>())
    }

    /// Factor of a column by one unit of a kind's scale: δ(1/k_F) = −δk_F/k_F².
    fn factor(&self, parameter: &Parameter, scale: &KindScale) -> Option<f64> {
        match (scale.kind, parameter.kind) {
            (ParameterKind::AxialStiffness, ParameterKind::Compliance) => {
                Some(scale.factor * parameter.value(self.model.robot()).powi(2))
            }
            (kind, own) => (kind == own).then_some(scale.factor),
        }
    }

    pub(super) fn scaled(&self, matrix: &DMatrix<f64>, scales: &[KindScale]) -> DMatrix<f64> {
        let mut scaled = matrix.clone();
        for (mut column, parameter) in scaled.column_iter_mut().zip(&self.parameters) {
            let factor = scales.iter().find_map(|scale| self.factor(parameter, scale));
            column *= factor.unwrap_or(1.0);
        }
        scaled
    }

    /// Scales of two kinds at which the root mean square of their columns' lengths is that of the others; `None` where one is not free.
    pub(super) fn centres(&self, matrix: &DMatrix<f64>, kinds: [ParameterKind; 2]) -> Option<[f64; 2]> {
        let length = |is_own: &dyn Fn(&Parameter) -> bool, unit: Option<KindScale>| {
            let own = (0..self.parameters.len()).filter(|&k| is_own(&self.parameters[k]));
            let squares: Vec<f64> = own
                .map(|k| {
                    let factor = unit.and_then(|unit| self.factor(&self.parameters[k], &unit)).unwrap_or(1.0);
                    matrix.column(k).norm_squared() * factor * factor
                })
                .collect();
            let mean = squares.iter().sum::<f64>() / squares.len() as f64;
            (mean > 0.0).then(|| mean.sqrt())
        };
        let units = kinds.map(|kind| KindScale { kind, factor: 1.0 });
        let is_of = |parameter: &Parameter, k: usize| self.factor(parameter, &units[k]).is_some();
        let others = length(&|parameter| !is_of(parameter, 0) && !is_of(parameter, 1), None).unwrap_or(1.0);
        let one = |k: usize| length(&|parameter| is_of(parameter, k), Some(units[k])).map(|own| others / own);
        Some([one(0)?, one(1)?])
    }
}
