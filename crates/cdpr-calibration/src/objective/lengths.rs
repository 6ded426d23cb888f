//! Vectors in joint space: modelled minus recorded lengths of all cables of a sample (eq. 4.8).

use super::vectors::{Stacked, Vectors};
use crate::blocks::Block;
use crate::pose_lanes::PoseLanes;
use crate::weights::Weights;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Length residuals of a kinematic model in standard deviations, m a sample.
pub(super) struct LengthVectors {
    poses: PoseLanes,
    samples: usize,
    /// With their parameters, which are ordered by cable.
    blocks: Vec<Block>,
}

impl LengthVectors {
    pub(super) fn new(model: &Model, samples: &Samples, parameters: &[Parameter], sigma: f64) -> Self {
        let poses = PoseLanes::new(samples);
        let weights = Weights::even(sigma, model.cable_count(), samples.len(), &poses);
        let block = |cable| {
            let own = parameters.iter().filter(|parameter| parameter.cable == cable).copied().collect();
            Block::new(model, cable, own, samples, &weights)
        };
        Self { samples: samples.len(), blocks: (0..model.cable_count()).map(block).collect(), poses }
    }

    /// Takes lengths at other poses than the measured ones, one of each sample.
    pub(super) fn move_to(&mut self, poses: &[Pose]) {
        self.poses = PoseLanes::of(poses);
    }
}

impl Vectors for LengthVectors {
    fn size(&self) -> usize {
        self.blocks.len()
    }

    fn samples(&self) -> usize {
        self.samples
    }

    fn write(&mut self, values: &[f64], stacked: &mut Stacked) -> bool {
        let cables = self.blocks.len();
        stacked.jacobian.fill(0.0);
        let mut first = 0;
        for (cable, block) in self.blocks.iter().enumerate() {
            let own = &values[first..first + block.parameters.len()];
            let change: Vec<f64> = own.iter().zip(block.values(&block.start)).map(|(to, from)| to - from).collect();
            let at = block.moved(&block.start, &change);
            let (residuals, columns) = block.rows(&self.poses, &at, self.samples);
            for (sample, residual) in residuals.iter().enumerate() {
                stacked.residuals[sample * cables + cable] = *residual;
            }
            for (column, entries) in (first..).zip(&columns) {
                let mut target = stacked.jacobian.column_mut(column);
                entries.iter().enumerate().for_each(|(sample, entry)| target[sample * cables + cable] = *entry);
            }
            first += columns.len();
        }
        stacked.is_finite()
    }
}
