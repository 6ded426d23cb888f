//! Cables and facets at a pose, and what is judged of a cell.

use nalgebra::{SVector, Vector3};

use super::demand::Demand;
use crate::Point;
use cdpr_model::cable::CablePath;
use cdpr_model::geometry::Wrench;

/// Rows of the structure matrix, those of moments divided by their lengths; rows that a robot does not have are zero.
pub(super) type Rows = SVector<f64, 6>;

/// Half-space of the available wrench set, with the room that it leaves the load.
pub(super) struct Face {
    /// Unit normal, rows of moments divided by their lengths.
    pub(super) scaled: Rows,
    /// The normal in world axes.
    pub(super) normal: Wrench,
    /// Room d − n · w₀ (N); below zero where the load lies outside.
    pub(super) room: f64,
    /// Bit i: cable i is at its largest tension everywhere on it.
    pub(super) at_largest: u64,
    /// Bit i: cable i is at its least tension everywhere on it.
    pub(super) at_least: u64,
}

impl Face {
    /// Largest amount of a quantity that it allows; infinite for one that it does not limit.
    pub(super) fn allows(&self, demand: &Demand) -> f64 {
        let support = demand.support(&self.normal);
        if support > 0.0 { self.room / support } else { f64::INFINITY }
    }
}

/// A cell, and the quantities that need bounds in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) center: Point,
    /// Half sides (m).
    pub(super) half: Point,
    /// Bit i: the quantity with the index i needs a bound.
    pub(super) bounded: u32,
}

impl Place {
    /// A pose.
    pub(super) fn pose(center: Point) -> Self {
        Self { center, half: [0.0; 3], bounded: 0 }
    }
}

/// Values at the centre of a cell, and lower bounds within it.
#[derive(Clone, Debug)]
pub(super) struct Judged {
    /// Value of each quantity at the centre.
    pub(super) values: Vec<f64>,
    /// Lower bound of each quantity in the cell; −∞ where the load may not be held, and without a bound.
    pub(super) at_least: Vec<f64>,
}

/// Path of a cable, and its moment arm (world, m).
pub(super) struct Course {
    pub(super) path: CablePath<f64>,
    pub(super) arm: Vector3<f64>,
}
