//! Residuals of rigid cables in joint space: modelled minus recorded lengths at the measured poses (eq. 4.8).
//!
//! Every parameter belongs to one cable, so that the cables' squares fall into blocks, which are minimised apart, eight samples side by side.

pub(crate) mod blocks;
mod descent;
pub(crate) mod further;
mod further_columns;
pub(crate) mod normal_equations;
pub(crate) mod pose_lanes;
mod recordings;
mod reweighting;
mod rows;
mod weighing;
pub(crate) mod weights;

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use super::Given;
use super::rows::GroupRows;
use super::rows::RowBlock;
use super::rows::{Layout, Rows};
use super::{Outliers, Remarks, Residual, Weighing};
use crate::fit::InputError;
use crate::fit::answer::Estimate;
use crate::fit::warnings;
use crate::identifiability::Analysis;
use crate::minimize::dense::DenseEquations;
use crate::minimize::descent::End;
use crate::minimize::unknowns::{Pace, Unknowns};
use crate::norms::Norms;
use blocks::Block;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::{LANES, TriangularFactor};
use pose_lanes::PoseLanes;
pub(crate) use rows::LengthRows;
use weights::{Weights, length_weights};

/// Lengths of a rigid model with weights from the accuracies of lengths and poses.
pub(crate) struct LengthResidual<'a> {
    /// The model before the fit.
    model: Model,
    samples: &'a Samples,
    parameters: &'a [Parameter],
    rows: LengthRows,
    weights: Weights,
    /// Those to come back to.
    kept: Option<Weights>,
    /// Rounds of reweighting under a robust loss.
    rounds: u32,
}

impl<'a> LengthResidual<'a> {
    /// With the weights at the model's parameters.
    pub(crate) fn new(given: &Given<'a, '_>) -> Result<Self, InputError> {
        let poses = PoseLanes::new(given.samples);
        let weights = length_weights(given.model, given.samples, &poses)?;
        let Given { model, samples, parameters, .. } = *given;
        let rows = LengthRows::new(model, samples, parameters, poses, &weights);
        Ok(Self { model: model.clone(), samples, parameters, rows, weights, kept: None, rounds: 0 })
    }
}

impl Residual for LengthResidual<'_> {
    fn model(&self) -> &Model {
        &self.model
    }

    fn scales(&self) -> Option<Vec<f64>> {
        let of_block =
            |block: &Block| block.parameters.iter().map(|parameter| block.scale(parameter.kind)).collect::<Vec<f64>>();
        Some(self.rows.blocks.iter().flat_map(of_block).collect())
    }

    fn layout(&self) -> Layout {
        Layout::of(self.rows.samples, self.rows.blocks.len())
    }

    fn write(&mut self, values: &[f64], rows: &mut Rows) -> bool {
        self.rows.write(values, rows)
    }

    fn is_absolute(&self) -> bool {
        self.weights.absolute
    }

    fn outliers(&self) -> Option<Outliers> {
        Some(Outliers::Own)
    }

    fn blocks(&self, _: usize) -> Vec<Range<usize>> {
        self.rows.ranges().collect()
    }

    fn normal(&mut self, block: usize, values: &[f64], equations: &mut DenseEquations) -> bool {
        descent::write(&self.rows.blocks[block], &self.rows.poses, values, equations);
        true
    }

    fn descend(&mut self, block: usize, from: &[f64], own: &Unknowns<'_>, pace: &Pace) -> Option<End> {
        Some(descent::run(&self.rows.blocks[block], &self.rows.poses, own, from, pace))
    }

    fn squares(&mut self, values: &[f64], _: &Unknowns<'_>, _: bool) -> Option<Vec<f64>> {
        Some(self.squares_at(values))
    }

    fn weighing(&mut self) -> Option<&mut dyn Weighing> {
        Some(self)
    }

    fn groups(&mut self, _: &Model, values: &[f64]) -> Option<Result<Vec<GroupRows>, InputError>> {
        let samples = self.rows.samples;
        let of_block = |(cable, range): (usize, Range<usize>)| {
            let block = &self.rows.blocks[cable];
            let (residuals, columns) = block.rows(&self.rows.poses, &block.at(&values[range.clone()]), samples);
            let weighted = DMatrix::from_fn(samples, columns.len(), |row, column| columns[column][row]);
            let mut plain = TriangularFactor::new(columns.len());
            for (row, weight) in weighted.row_iter().zip(block.weights()) {
                plain.push(row.iter().map(|entry| entry / *weight));
            }
            GroupRows {
                parameters: range,
                cables: cable..cable + 1,
                count: samples,
                plain,
                conventions: 0,
                weighted: TriangularFactor::of(&weighted),
                weighted_rows: weighted,
                series: vec![residuals],
            }
        };
        Some(Ok(self.rows.ranges().enumerate().map(of_block).collect()))
    }

    fn row_weights(&self) -> Option<Vec<Vec<f64>>> {
        let of_block = |cable: usize| self.weights.of_cable(cable)[..self.rows.samples].to_vec();
        Some((0..self.rows.blocks.len()).map(of_block).collect())
    }

    fn pose_rows(&mut self, model: &Model, values: &[f64], norms: &Norms) -> Option<Result<Vec<RowBlock>, InputError>> {
        let roots: Vec<f64> = (0..self.rows.samples).map(|sample| norms.weight(sample).sqrt()).collect();
        let cables = self.rows.ranges().enumerate();
        Some(Ok(cables.map(|(cable, range)| self.pose_rows_of(model, cable, range, values, &roots)).collect()))
    }

    fn remarks(&self, _: &Model, estimates: &[Estimate], noise: f64, _: &mut Analysis) -> Remarks {
        let of_noise = warnings::of_length_noise(self.weights.absolute, noise, estimates.len());
        Remarks { of_noise: of_noise.into_iter().collect(), ..Remarks::default() }
    }
}

impl LengthResidual<'_> {
    /// Squared norm of each sample's residuals.
    fn squares_at(&self, values: &[f64]) -> Vec<f64> {
        let mut squares = vec![0.0; self.rows.samples.next_multiple_of(LANES)];
        for (block, range) in self.rows.blocks.iter().zip(self.rows.ranges()) {
            block.add_squares(&self.rows.poses, &block.at(&values[range]), &self.weights, &mut squares);
        }
        squares.truncate(self.rows.samples);
        squares
    }

    /// Rows of a cable by its parameters and by the motion of the platform, each times the root of its sample's weight.
    fn pose_rows_of(
        &self,
        model: &Model,
        cable: usize,
        range: Range<usize>,
        values: &[f64],
        roots: &[f64],
    ) -> RowBlock {
        let (block, basis, samples) = (&self.rows.blocks[cable], model.twist_basis(), self.rows.samples);
        let (mut residuals, columns) = block.rows(&self.rows.poses, &block.at(&values[range.clone()]), samples);
        residuals.iter_mut().zip(roots).for_each(|(residual, root)| *residual *= root);
        let scale = model.recorded_length(cable, 1.0) - model.recorded_length(cable, 0.0);
        let mut by_pose = DMatrix::zeros(samples, basis.len());
        for (sample, pose) in self.samples.poses.iter().enumerate() {
            let (path, arm) = model.path_or_nan(cable, pose);
            let direction = nalgebra::Vector3::from(path.direction);
            let moment = arm.cross(&direction);
            let weight = -roots[sample] * block.weights()[sample] * scale;
            for (k, twist) in basis.iter().enumerate() {
                let along = direction.dot(&twist.fixed_rows::<3>(0)) + moment.dot(&twist.fixed_rows::<3>(3));
                by_pose[(sample, k)] = weight * along;
            }
        }
        RowBlock {
            parameters: range.collect(),
            by_parameters: DMatrix::from_fn(samples, columns.len(), |row, k| roots[row] * columns[k][row]),
            by_pose,
            residuals: DVector::from_vec(residuals),
            rows_of_sample: 1,
            poses: self.samples.poses.clone(),
            wrenches: None,
        }
    }
}

/// Lengths of a rigid model with one weight that no parameter changes.
pub(crate) struct EvenLengths {
    model: Model,
    rows: LengthRows,
    sigma: f64,
    is_stated: bool,
}

impl EvenLengths {
    /// With a standard deviation, stated or assumed (m).
    pub(crate) fn new(given: &Given<'_, '_>, sigma: f64, is_stated: bool) -> Self {
        let rows = LengthRows::even(given.model, given.samples, given.parameters, sigma);
        Self { model: given.model.clone(), rows, sigma, is_stated }
    }
}

impl Residual for EvenLengths {
    fn model(&self) -> &Model {
        &self.model
    }

    fn layout(&self) -> Layout {
        Layout::of(self.rows.samples, self.rows.blocks.len())
    }

    fn write(&mut self, values: &[f64], rows: &mut Rows) -> bool {
        self.rows.write(values, rows)
    }

    fn is_absolute(&self) -> bool {
        self.is_stated
    }

    fn unit(&self) -> Option<f64> {
        Some(self.sigma)
    }

    fn outliers(&self) -> Option<Outliers> {
        Some(Outliers::Own)
    }
}
