//! Equations of an elastostatic search.

use super::settings::Settings;
use super::springs::Springs;
use crate::model::Model;
use crate::scalar::{Real, constants, cross, dot};
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

    /// Adds forces, weight and constant moment to a residual wrench and the lower triangle of its stiffness, for one
    /// pose or for poses in lanes. Weight acts at R c and turns with the platform; returns R c (m).
    #[inline(always)]
    pub(super) fn add_to<T: Real>(
        &self,
        residual: &mut [T; 6],
        stiffness: &mut [[T; 6]; 6],
        rotation: &[[T; 3]; 3],
    ) -> [T; 3] {
        let l = rotation[0][0];
        let center = constants(l, self.center_of_mass);
        let c = [dot(rotation[0], center), dot(rotation[1], center), dot(rotation[2], center)];
        let g = constants(l, self.weight);
        let moment = cross(c, g);
        for k in 0..3 {
            residual[k] = residual[k] + (l.constant(self.constant[k]) + g[k]);
            residual[3 + k] = residual[3 + k] + (l.constant(self.constant[3 + k]) + moment[k]);
        }
        // symmetric part of ∂w/∂ω = c gᵀ − (g · c) I
        let product = dot(g, c);
        for i in 0..3 {
            for j in 0..=i {
                let half = l.constant(0.5) * (c[i] * g[j] + c[j] * g[i]);
                stiffness[3 + i][3 + j] = stiffness[3 + i][3 + j] - half;
            }
            stiffness[3 + i][3 + i] = stiffness[3 + i][3 + i] + product;
        }
        c
    }
}

/// Square of a wrench, moments divided by the platform radius (N²).
#[inline(always)]
pub(super) fn squared<T: Real, const N: usize>(wrench: &[T; N], translations: usize, platform_radius: f64) -> T {
    let by_radius = wrench[0].constant(1.0 / platform_radius);
    let mut sum = wrench[0].constant(0.0);
    for k in 0..N {
        let entry = if k < translations { wrench[k] } else { wrench[k] * by_radius };
        sum = sum + entry * entry;
    }
    sum
}

/// A model with controlled lengths and a load.
#[derive(Clone, Copy, Debug)]
pub(super) struct Problem<'a> {
    pub(super) model: &'a Model,
    pub(super) settings: &'a Settings,
    pub(super) load: LoadParts,
    pub(super) full_load: &'a Load,
    /// True if a constant moment makes the stiffness unsymmetric.
    pub(super) has_moment: bool,
    pub(super) springs: &'a [Springs],
    /// Least stretch with a tension (m): 0 for cables, −∞ for bars.
    pub(super) floor: f64,
    /// Sum of the cables' stiffness (N/m): the unit of damping.
    pub(super) stiffness_scale: f64,
    pub(super) mean_length: f64,
    pub(super) platform_radius: f64,
    /// True if equilibria with slack cables do not count.
    pub(super) only_taut: bool,
}
