//! Equations of an elastostatic search.

use super::settings::Settings;
use super::springs::Springs;
use crate::model::Model;
use crate::statics::Load;

/// The load in plain arrays, for the kernel.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoadParts {
    pub(super) constant: [f64; 6],
    pub(super) weight: [f64; 3],
    pub(super) center_of_mass: [f64; 3],
}

impl LoadParts {
    pub(super) fn of(load: &Load) -> Self {
        let (weight, center_of_mass) = load.weight();
        Self {
            constant: (*load.constant_part()).into(),
            weight: (*weight).into(),
            center_of_mass: (*center_of_mass).into(),
        }
    }
}

/// A model with lengths to obey and a load to carry.
#[derive(Clone, Copy, Debug)]
pub(super) struct Problem<'a> {
    pub(super) model: &'a Model,
    pub(super) settings: &'a Settings,
    pub(super) load: LoadParts,
    pub(super) full_load: &'a Load,
    /// A constant moment makes the stiffness unsymmetric.
    pub(super) has_moment: bool,
    pub(super) springs: &'a [Springs],
    /// Least stretch with a force (m): 0 for cables, −∞ for bars.
    pub(super) floor: f64,
    /// Sum of the cables' stiffness (N/m): the unit of damping.
    pub(super) stiffness_scale: f64,
    pub(super) mean_length: f64,
    pub(super) platform_radius: f64,
    /// An equilibrium with slack cables is none.
    pub(super) only_taut: bool,
}
