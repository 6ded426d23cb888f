//! Cables with the parameters of their lengths, and numbers of eight samples.

use crate::residual::lengths::blocks::{Block, LENGTH_SLOTS};
use crate::residual::lengths::pose_lanes::CableValues;
use cdpr_model::geometry::POSE_ROWS;
use cdpr_model::scalar::Line;

/// Seven numbers of eight poses.
pub(super) type PoseLines = [Line; POSE_ROWS];

/// Derivatives of the residuals of eight samples by one parameter.
pub(super) type Column = [Line; 6];

/// Most cables.
pub(super) const MOST_CABLES: usize = 8;

/// A cable with the parameters of its lengths.
pub(super) struct Cable {
    start: Vec<f64>,
    /// Places of the parameters in a row of derivatives.
    pub(super) places: Vec<usize>,
    pub(super) values: CableValues,
    /// The length scale's inverse.
    pub(super) per_scale: f64,
    block: Block,
}

impl Cable {
    /// `None` if the kernel does not know a parameter.
    pub(super) fn of(block: Block) -> Option<Self> {
        let places = block.places_of_lengths()?.to_vec();
        let start = block.values(&block.start).collect();
        Some(Self { start, places, values: block.start, per_scale: 1.0 / block.start.scale, block })
    }

    pub(super) fn move_to(&mut self, values: &[f64]) {
        let mut change = [0.0; LENGTH_SLOTS];
        for (change, (to, from)) in change.iter_mut().zip(values.iter().zip(&self.start)) {
            *change = to - from;
        }
        self.values = self.block.moved(&self.block.start, &change);
        self.per_scale = 1.0 / self.values.scale;
    }

    /// Recorded lengths, padded (m).
    pub(super) fn recorded(&self) -> &[f64] {
        self.block.recorded()
    }
}
