//! Lengths of rigid cables with the weights of an optimum, cable by cable.

use super::{InputError, Settings, descent, optimum};
use crate::blocks::Block;
use crate::pose_lanes::PoseLanes;
use crate::progress::unobserved;
use crate::quadratic::{HalfSquares, Quadratic};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// All cables at their optimum, which no longer changes their weights.
pub(crate) struct FrozenLengths<'a> {
    optimum: optimum::Optimum,
    settings: &'a Settings,
}

/// One of them.
pub(crate) struct FrozenCable<'a> {
    block: &'a Block,
    poses: &'a PoseLanes,
    settings: &'a Settings,
    start: Vec<f64>,
    change: Vec<f64>,
}

impl<'a> FrozenLengths<'a> {
    pub(crate) fn find(
        model: &Model,
        samples: &Samples,
        parameters: &[Parameter],
        settings: &'a Settings,
    ) -> Result<Self, InputError> {
        let (optimum, _) = optimum::find(model, samples, parameters, settings, &unobserved)?;
        Ok(Self { optimum, settings })
    }

    /// The cables with free parameters.
    pub(crate) fn cables(&self) -> impl Iterator<Item = FrozenCable<'_>> {
        let with_parameters = self.optimum.blocks.iter().filter(|block| !block.parameters.is_empty());
        with_parameters.map(|block| FrozenCable {
            block,
            poses: &self.optimum.poses,
            settings: self.settings,
            start: block.values(&block.start).collect(),
            change: vec![0.0; block.parameters.len()],
        })
    }
}

impl FrozenCable<'_> {
    pub(crate) fn parameters(&self) -> &[Parameter] {
        &self.block.parameters
    }

    /// Metres that one unit of each parameter is worth.
    pub(crate) fn scales(&self) -> Vec<f64> {
        self.block.parameters.iter().map(|parameter| self.block.scale(parameter.kind)).collect()
    }
}

impl HalfSquares for FrozenCable<'_> {
    fn write(&mut self, values: &[f64], to: &mut Quadratic) -> bool {
        let change = self.change.iter_mut().zip(values.iter().zip(&self.start));
        change.for_each(|(change, (value, start))| *change = value - start);
        descent::write(self.block, self.poses, self.settings, &self.change, to);
        to.value.is_finite()
    }
}
