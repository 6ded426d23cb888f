//! Modelled minus recorded lengths of all cables at given poses, cable by cable.

use std::ops::Range;

use super::blocks::Block;
use super::pose_lanes::PoseLanes;
use super::weights::Weights;
use crate::residual::rows::Rows;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Length residuals of a kinematic model in standard deviations, m a sample.
pub(crate) struct LengthRows {
    pub(super) poses: PoseLanes,
    pub(super) samples: usize,
    /// With their parameters, which are ordered by cable.
    pub(super) blocks: Vec<Block>,
}

impl LengthRows {
    /// Rows with the same standard deviation (m).
    pub(crate) fn even(model: &Model, samples: &Samples, parameters: &[Parameter], sigma: f64) -> Self {
        let poses = PoseLanes::new(samples);
        let weights = Weights::even(sigma, model.cable_count(), samples.len(), &poses);
        Self::new(model, samples, parameters, poses, &weights)
    }

    pub(super) fn new(
        model: &Model,
        samples: &Samples,
        parameters: &[Parameter],
        poses: PoseLanes,
        weights: &Weights,
    ) -> Self {
        let block = |cable| {
            let own = parameters.iter().filter(|parameter| parameter.cable == cable).copied().collect();
            Block::new(model, cable, own, samples, weights)
        };
        Self { samples: samples.len(), blocks: (0..model.cable_count()).map(block).collect(), poses }
    }

    /// Number of samples.
    pub(crate) fn samples(&self) -> usize {
        self.samples
    }

    /// Takes lengths at other poses than the measured ones, one of each sample.
    pub(crate) fn move_to(&mut self, poses: &[Pose]) {
        self.poses = PoseLanes::of(poses);
    }

    /// Places of the cables' parameters.
    pub(super) fn ranges(&self) -> impl Iterator<Item = Range<usize>> {
        self.blocks.iter().scan(0, |first, block| {
            let range = *first..*first + block.parameters.len();
            *first = range.end;
            Some(range)
        })
    }

    /// Writes residuals and derivatives at parameter values; false where one is not finite.
    pub(crate) fn write(&self, values: &[f64], rows: &mut Rows) -> bool {
        let cables = self.blocks.len();
        rows.jacobian.fill(0.0);
        for (cable, (block, range)) in self.blocks.iter().zip(self.ranges()).enumerate() {
            let at = block.at(&values[range.clone()]);
            let (residuals, columns) = block.rows(&self.poses, &at, self.samples);
            for (sample, residual) in residuals.iter().enumerate() {
                rows.residuals[sample * cables + cable] = *residual;
            }
            for (column, entries) in range.zip(&columns) {
                let mut target = rows.jacobian.column_mut(column);
                entries.iter().enumerate().for_each(|(sample, entry)| target[sample * cables + cable] = *entry);
            }
        }
        rows.is_finite()
    }
}
