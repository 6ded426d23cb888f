//! Assumptions and stop rules of a fit.

use std::str::FromStr;

use super::input_error::InputError;
use crate::gauge_convention::GaugeConvention;
use crate::loss::Loss;
use crate::objective::{Minimize, Objective};
use cdpr_model::model::{FreeParameters, identified_kind};
use cdpr_model::robot::ParameterKind;
use cdpr_model::solve::Minimizer;

/// Noise assumed for a length when no sensor accuracy is known, until the residuals tell (m).
pub(crate) const ASSUMED_NOISE: f64 = 1e-3;

/// Share of the mean tension assumed as the force sensors' noise where none is stated.
pub(crate) const ASSUMED_TENSION_SHARE: f64 = 0.01;

/// Assumptions and stop rules of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Parameters that stay at their value although `free` names them.
    pub hold: FreeParameters,
    /// Ridges towards the start value.
    pub priors: Vec<Prior>,
    /// Weights of the rows of an elastic model in place of accuracies; measured poses and tensions count as exact then.
    pub row_weights: Option<RowWeights>,
    /// Residuals that are made small.
    pub objective: Objective,
    /// Cost of all samples' residuals.
    pub minimize: Minimize,
    /// Length by which rotations count beside positions in [`Objective::Pose`] (m); `None`: σ_r/σ_Φ where both are stated, else the root mean
    /// square of the platform anchors' distances.
    pub rotation_length: Option<f64>,
    /// Box of the task, where poses count fully in [`Objective::PoseInTask`].
    pub task: Option<TaskBox>,
    /// How samples count whose residuals are larger than noise.
    pub loss: Loss,
    /// Stop once the parameters are this near to the optimum, judged by the last steps (m; scales times the mean length).
    pub tolerance: f64,
    /// Way to the optimum.
    pub minimizer: Minimizer,
    /// Steps allowed for each cable.
    pub max_iterations: u32,
    /// A direction in parameter space with a larger standard deviation is reported as weak (m).
    pub weak_direction_limit: f64,
    /// Starts: the file's values and points of a scrambled Sobol sequence around them; [`Starts::ranges`](crate::Starts) says how far.
    pub starts: u32,
    /// Seed of the other starts.
    pub seed: u64,
    /// Convention that fixes motions of everything that data without poses leave free.
    pub gauge: GaugeConvention,
    /// Keep the way to the optimum, for [`course`](crate::course).
    pub keeps_course: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            hold: FreeParameters::default(),
            priors: Vec::new(),
            row_weights: None,
            objective: Objective::default(),
            minimize: Minimize::default(),
            rotation_length: None,
            task: None,
            loss: Loss::default(),
            tolerance: 1e-10,
            minimizer: Minimizer::default(),
            max_iterations: 200,
            weak_direction_limit: 0.1,
            starts: 1,
            seed: 0,
            gauge: GaugeConvention::default(),
            keeps_course: false,
        }
    }
}

/// Box of positions that a task needs (world, m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaskBox {
    /// Lower corner.
    pub min: [f64; 3],
    /// Upper corner.
    pub max: [f64; 3],
}

impl Settings {
    /// True where anything but squares of lengths is minimised.
    pub(crate) fn is_other_objective(&self) -> bool {
        (self.objective, self.minimize) != (Objective::Length, Minimize::Squares)
    }
}

/// Weights of the rows of lengths and wrenches (w_ρ of sec. 4.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowWeights {
    /// Of wrenches: forces (1/N) and moments (1/(N·m)).
    pub wrench: f64,
    /// Of lengths (1/m).
    pub length: f64,
}

impl Default for RowWeights {
    fn default() -> Self {
        Self { wrench: 1.0, length: 1.0 }
    }
}

impl RowWeights {
    /// Names of the rows, as they are written.
    pub const NAMES: [&'static str; 2] = ["length", "wrench"];
}

impl FromStr for RowWeights {
    type Err = InputError;

    /// Reads `length=1e4,wrench=1`; 1 where one is not named.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let syntax = || InputError::RowWeightSyntax { text: text.to_owned() };
        let mut weights = Self::default();
        for item in text.split(',') {
            let (name, value) = item.split_once('=').ok_or_else(syntax)?;
            let value: f64 = value.trim().parse().map_err(|_| syntax())?;
            let [length, wrench] = Self::NAMES;
            let own = match name.trim() {
                name if name == length => &mut weights.length,
                name if name == wrench => &mut weights.wrench,
                _ => return Err(syntax()),
            };
            if !(value > 0.0 && value.is_finite()) {
                return Err(syntax());
            }
            *own = value;
        }
        Ok(weights)
    }
}

/// A ridge: parameters of this kind are normally distributed around their start values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prior {
    /// The kind of parameter.
    pub kind: ParameterKind,
    /// Standard deviation, in the parameter's unit.
    pub sigma: f64,
}

impl FromStr for Prior {
    type Err = InputError;

    /// Reads `platform-anchor=0.02`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let syntax = || InputError::PriorSyntax { text: text.to_owned() };
        let (name, value) = text.split_once('=').ok_or_else(syntax)?;
        let sigma: f64 = value.trim().parse().map_err(|_| syntax())?;
        if !(sigma > 0.0 && sigma.is_finite()) {
            return Err(syntax());
        }
        Ok(Self { kind: identified_kind(name.trim())?, sigma })
    }
}

/// Standard deviation of a prior on a kind of parameters.
pub(crate) fn prior_sigma(settings: &Settings, kind: ParameterKind) -> Option<f64> {
    settings.priors.iter().rev().find(|prior| prior.kind == kind).map(|prior| prior.sigma)
}
