//! Squares of the errors of predicted poses with half their derivatives, eight samples side by side.
//!
//! [`PoseResidual`](super::PoseResidual) solves every forward problem anew from the measured poses. Here predictions follow the parameters: to first order
//! by their derivatives, then by a Newton step and a chord with the same matrix, after which only rounding is left of a step of the fit. What is not plain is
//! left to the vectors: other degrees of freedom than six, other numbers of cables than seven and eight, large errors, singular poses.

mod cable;
mod eight;
mod error;
mod products;
#[cfg(test)]
mod tests;

use nalgebra::{DMatrix, DVector};

use cable::{Cable, Column, MOST_CABLES, PoseLines};
use eight::Eight;
use products::Products;

use crate::minimize::dense::DenseEquations;
use crate::residual::lengths::blocks::Block;
use crate::residual::metric::Metric;
use cdpr_model::geometry::POSE_ROWS;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::{Kernel, LANES, Lanes, Line, dispatch};

/// Share of the mean length that predicted poses may move, rms, before J is written and JᵀJ summed anew. The optimum is where Jᵀr vanishes, which is exact
/// everywhere; what JᵀJ lacks, times the square of the condition, is what is left of a step.
const SAME: f64 = 3e-5;

/// Samples of a rigid model of six degrees of freedom whose predictions follow the parameters.
pub(super) struct PoseSquares {
    cables: Vec<Cable>,
    /// Measured poses; the last group is filled with copies of the last one.
    measured: Vec<PoseLines>,
    /// ‖r‖² of the samples at the values that were asked for last.
    norms: Vec<Line>,
    /// Samples in the last group.
    in_last: usize,
    /// Units of the six errors: standard deviations.
    units: [f64; 6],
    /// Share of the mean length that residuals of lengths may have.
    plausible: f64,
    /// Predicted poses at the values that were asked for last.
    predicted: Vec<PoseLines>,
    /// Derivatives where JᵀJ was summed last, parameter by parameter of a group.
    derivatives: Vec<Line>,
    /// Those values; `None` if predictions begin at the measured poses.
    values: Option<Vec<f64>>,
    /// Values at which JᵀJ was summed last, with it.
    summed_at: Option<(Vec<f64>, DMatrix<f64>)>,
    mean_length: f64,
    products: Products,
}

impl PoseSquares {
    /// `None` if predictions are not plain.
    pub(super) fn of(
        model: &Model,
        samples: &Samples,
        parameters: &[Parameter],
        metric: &Metric,
        plausible: f64,
    ) -> Option<Self> {
        let is_plain = !model.needs_tensions() && model.dof() == 6 && (7..=MOST_CABLES).contains(&model.cable_count());
        if !is_plain || samples.is_empty() || samples.motor_angles.is_some() {
            return None;
        }
        let cable = |cable| {
            let own = parameters.iter().filter(|parameter| parameter.cable == cable).copied().collect();
            Cable::of(Block::unweighted(model, cable, own, samples))
        };
        let cables = (0..model.cable_count()).map(cable).collect::<Option<Vec<Cable>>>()?;
        let groups = samples.len().div_ceil(LANES);
        let mut measured = vec![[Line::default(); POSE_ROWS]; groups];
        for place in 0..groups * LANES {
            let pose = &samples.poses[place.min(samples.len() - 1)];
            for (line, number) in measured[place / LANES].iter_mut().zip(pose.numbers()) {
                line.0[place % LANES] = number;
            }
        }
        let units = std::array::from_fn(|row| metric.along(&model.twist_basis()[row]));
        let products = Products::new(parameters.len());
        Some(Self {
            cables,
            predicted: measured.clone(),
            measured,
            norms: vec![Line::default(); groups],
            in_last: (samples.len() - 1) % LANES + 1,
            units,
            plausible,
            derivatives: vec![Line::default(); groups * products.columns() * 6],
            values: None,
            summed_at: None,
            mean_length: samples.lengths.iter().sum::<f64>() / samples.lengths.len() as f64,
            products,
        })
    }

    /// Predictions begin at the measured poses again.
    pub(super) fn forget(&mut self) {
        (self.values, self.summed_at) = (None, None);
    }

    /// Number of samples.
    fn count(&self) -> usize {
        (self.measured.len() - 1) * LANES + self.in_last
    }

    /// ‖r‖² of every sample, with the values at which the squares were written last.
    pub(super) fn of_samples(&self) -> Option<(&[f64], Vec<f64>)> {
        let norms = self.norms.iter().flat_map(|line| line.0).take(self.count()).collect();
        self.values.as_ref().map(|values| (values.as_slice(), norms))
    }

    /// Writes Σ‖r‖² with half its derivatives; false where the vectors must be asked.
    pub(super) fn write(&mut self, values: &[f64], equations: &mut DenseEquations) -> bool {
        let change = self.prepare(values);
        let with_hessian = !self.is_summed_near(values);
        let is_plain = dispatch(Write { squares: self, change: &change, with_hessian });
        self.conclude(values, (is_plain, with_hessian), equations)
    }

    fn conclude(
        &mut self,
        values: &[f64],
        (is_plain, with_hessian): (bool, bool),
        equations: &mut DenseEquations,
    ) -> bool {
        if !is_plain {
            self.forget();
            return false;
        }
        self.values = Some(values.to_vec());
        self.products.write(equations, with_hessian);
        match self.summed_at.as_ref().filter(|_| !with_hessian) {
            Some((_, hessian)) => equations.hessian.copy_from(hessian),
            None => self.summed_at = Some((values.to_vec(), equations.hessian.clone())),
        }
        equations.cost.is_finite()
    }

    /// True where JᵀJ was summed at values that predict the same poses but for [`SAME`], rms: it only tells the way to the optimum, which Jᵀr decides.
    fn is_summed_near(&self, values: &[f64]) -> bool {
        let Some((at, hessian)) = &self.summed_at else { return false };
        let samples = self.count() as f64;
        let most = SAME * self.mean_length * self.units[0];
        let change = DVector::from_iterator(at.len(), values.iter().zip(at).map(|(to, from)| to - from));
        change.dot(&(hessian * &change)) <= samples * most * most
    }

    /// Takes the cables to parameter values: the change of these since the predictions; empty if they are the measured poses.
    fn prepare(&mut self, values: &[f64]) -> Vec<f64> {
        let mut rest = values;
        for cable in &mut self.cables {
            let (own, others) = rest.split_at(cable.places.len());
            cable.move_to(own);
            rest = others;
        }
        match self.values.take() {
            Some(mut last) => {
                last.iter_mut().zip(values).for_each(|(last, value)| *last = value - *last);
                last
            }
            None => {
                self.predicted.copy_from_slice(&self.measured);
                Vec::new()
            }
        }
    }
}

/// All samples at parameter values that changed; whether all of them are plain.
struct Write<'a> {
    squares: &'a mut PoseSquares,
    /// Change of the parameters since the predictions; empty where these are the measured poses.
    change: &'a [f64],
    with_hessian: bool,
}

impl Kernel for Write<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> bool {
        let Self { squares, change, with_hessian } = self;
        squares.products.clear(with_hessian);
        let columns = squares.products.columns();
        let groups = squares.measured.len();
        let (all_derivatives, _) = squares.derivatives.as_chunks_mut::<6>();
        let mut eight = Eight::new(l);
        for group in 0..groups {
            let count = if group + 1 == groups { squares.in_last } else { LANES };
            let derivatives = &mut all_derivatives[group * columns..][..columns];
            eight.load(&squares.predicted[group]);
            if !change.is_empty() {
                eight.follow(derivatives, change, &squares.units, count);
            }
            if !eight.settle(&squares.cables, group, squares.plausible) {
                return false;
            }
            eight.store(&mut squares.predicted[group]);
            let measured = (&squares.measured[group], &squares.units, count);
            let Some(rows) = Rows::of(l, &eight, measured) else { return false };
            squares.products.add(l, &rows.residuals);
            rows.square().store(&mut squares.norms[group].0);
            rows.add_to_gradient(l, &eight, &squares.cables, &mut squares.products);
            if with_hessian {
                rows.write(&eight, &squares.cables, derivatives);
                squares.products.add_to_hessian(l, derivatives);
            }
        }
        true
    }
}

/// Residuals of eight samples with their changes by the pose.
struct Rows<L> {
    residuals: [L; 6],
    weights: [L; 6],
    by_turn: [[L; 3]; 3],
}

impl<L: Lanes> Rows<L> {
    /// `None` if an error is too large.
    #[inline(always)]
    fn of(l: L, eight: &Eight<L>, (measured, units, count): (&PoseLines, &[f64; 6], usize)) -> Option<Self> {
        let mut of_group = [[0.0; LANES]; 6];
        for (lines, unit) in of_group.iter_mut().zip(units) {
            lines[..count].fill(*unit);
        }
        let error = error::Error::of(l, measured, &eight.pose)?;
        let (mut weights, mut residuals) = ([l; 6], [l; 6]);
        for row in 0..6 {
            weights[row] = l.load(&of_group[row]);
            residuals[row] = weights[row] * error.vector[row];
        }
        Some(Self { residuals, weights, by_turn: error.by_turn() })
    }

    /// ‖r‖².
    #[inline(always)]
    fn square(&self) -> L {
        let mut square = self.residuals[0] * self.residuals[0];
        for row in 1..6 {
            square = square + self.residuals[row] * self.residuals[row];
        }
        square
    }

    /// Adds Jᵀr: one wrench for all residuals, whatever the number of parameters.
    #[inline(always)]
    fn add_to_gradient(&self, l: L, eight: &Eight<L>, cables: &[Cable], products: &mut Products) {
        let mut weighted = [l; 6];
        for row in 0..6 {
            weighted[row] = self.weights[row] * self.residuals[row];
        }
        let by_wrench = [eight.half_squares_by_wrench(&self.by_turn, &weighted)];
        let mut first = 0;
        for (place, cable) in cables.iter().enumerate() {
            eight.by_parameters(place, &by_wrench, cable, |parameter, _, change| {
                products.add_to_gradient(l, first + parameter, change);
            });
            first += cable.places.len();
        }
    }

    /// Writes J, parameter by parameter.
    #[inline(always)]
    fn write(&self, eight: &Eight<L>, cables: &[Cable], derivatives: &mut [Column]) {
        let by_wrench = eight.by_wrench(&self.by_turn, &self.weights);
        let mut rest = derivatives;
        for (place, cable) in cables.iter().enumerate() {
            let (own, others) = rest.split_at_mut(cable.places.len());
            eight.by_parameters(place, &by_wrench, cable, |parameter, row, change| {
                change.store(&mut own[parameter][row].0);
            });
            rest = others;
        }
    }
}
