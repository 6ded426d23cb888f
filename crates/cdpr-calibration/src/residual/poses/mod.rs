//! Vectors in Cartesian space: predicted minus measured poses, of elastic models with predicted minus recorded tensions (eq. 4.1, 4.31).
//!
//! Predicted is the answer of the forward problem to the recorded lengths, and its derivative follows from the implicit function theorem. At
//! rest W(x, p) = 0, W the wrench of load and cables at fixed controlled lengths, so that δx = K_wx⁻¹ ∂W/∂p δp (eq. 4.33). Forward kinematics is
//! the same with cables as springs of 1 N/m whose tensions are the residuals of the lengths: that gives eq. 4.4 with the sign of `maths.md`,
//! the curvature of the lengths included.

mod squares;

use nalgebra::{Matrix3, Matrix6, Vector6};

use super::Given;
use super::metric::{Metric, by_turn, position_sigma};
use super::rows::{Layout, Missing, Rows};
use super::{Outliers, Residual};
use crate::fit::InputError;
use crate::minimize::dense::DenseEquations;
use crate::minimize::unknowns::Unknowns;
use crate::recorded::Recorded;
use cdpr_model::cable::CableState;
use cdpr_model::equilibrium::{ForwardBatch, ForwardSettings, Solutions, State, Status};
use cdpr_model::geometry::{Pose, PoseBatch, Twist, Wrench};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, ParameterKind};
use cdpr_model::scalar::LaneTable;
use cdpr_model::statics::{Load, cable_state_at_outlet, unit_spring_state};
use squares::PoseSquares;

/// Distance between parameter values within which norms of samples count as the same (m).
const NEARBY: f64 = 1e-6;

/// Errors of predicted poses, in the units of a metric: n a sample, with the m of the tensions n + m.
pub(super) struct PoseResidual<'a> {
    model: Model,
    samples: &'a Samples,
    parameters: &'a [Parameter],
    metric: Metric,
    is_stated: bool,
    /// Measured poses, once a forward problem is solved: where every search begins, whatever was predicted before.
    guesses: PoseBatch,
    lengths: LaneTable,
    solutions: Solutions,
    settings: ForwardSettings,
    /// Sample without a prediction, where one had none.
    unpredicted: Option<usize>,
    /// Samples that are left out, since they have none where the fit begins.
    left_out: Vec<bool>,
    /// Last parameters that have vectors, with these: searches begin and end where one was.
    written: Option<(Vec<f64>, Rows)>,
    /// The same squares in a shorter way, where predictions are plain.
    squares: Option<Box<PoseSquares>>,
}

impl<'a> PoseResidual<'a> {
    pub(super) fn new(given: &Given<'a, '_>) -> Result<Self, InputError> {
        let Given { model, samples, parameters, .. } = *given;
        let metric = Metric::of(model, samples, given.settings.rotation_length)?;
        let mut settings = ForwardSettings::default();
        // the measured pose is near: a residual is the model's, not a wrong minimum's
        settings.least_squares.suspicious_residual = settings.least_squares.plausible_residual;
        let squares = PoseSquares::of(model, samples, parameters, &metric, settings.least_squares.plausible_residual)
            .map(Box::new);
        Ok(Self {
            model: model.clone(),
            samples,
            parameters,
            metric,
            is_stated: is_stated(given),
            guesses: PoseBatch::default(),
            lengths: LaneTable::new(model.cable_count()),
            solutions: Solutions::default(),
            settings,
            unpredicted: None,
            left_out: vec![false; samples.len()],
            written: None,
            squares,
        })
    }

    /// Predicts all poses; `None` if one has no prediction.
    fn predict(&mut self, model: &Model, state: &mut State) -> Option<()> {
        if self.guesses.is_empty() {
            self.guesses = self.samples.poses.iter().collect();
            self.lengths.resize(self.samples.len());
        }
        let mut controlled = vec![0.0; model.cable_count()];
        for sample in 0..self.samples.len() {
            let recorded = Recorded::of(self.samples, sample);
            for (cable, length) in controlled.iter_mut().enumerate() {
                *length = model.controlled_length(cable, recorded.length(model, cable));
            }
            self.lengths.write(sample, &controlled);
        }
        let problems = ForwardBatch { lengths: &self.lengths, guesses: &self.guesses, load: None, only_taut: false };
        model.forward_batch(&self.settings, &problems, state, &mut self.solutions).ok()?;
        let is_missing =
            |sample: &usize| self.solutions.status(*sample) != Status::Converged && !self.left_out[*sample];
        self.unpredicted = (0..self.samples.len()).find(is_missing);
        self.unpredicted.is_none().then_some(())
    }
}

impl Residual for PoseResidual<'_> {
    fn model(&self) -> &Model {
        &self.model
    }

    fn layout(&self) -> Layout {
        Layout::of(self.samples.len(), self.size())
    }

    fn is_absolute(&self) -> bool {
        self.is_stated
    }

    fn unit(&self) -> Option<f64> {
        (!self.model.needs_tensions()).then(|| position_sigma(self.samples))
    }

    fn outliers(&self) -> Option<Outliers> {
        Some(Outliers::Witnessed)
    }

    fn restart(&mut self) {
        if let Some(squares) = &mut self.squares {
            squares.forget();
        }
    }

    fn normal(&mut self, _: usize, values: &[f64], equations: &mut DenseEquations) -> bool {
        self.squares.as_mut().is_some_and(|squares| squares.write(values, equations))
    }

    fn squares(&mut self, values: &[f64], unknowns: &Unknowns<'_>, is_exact: bool) -> Option<Vec<f64>> {
        let (at, squares) = self.squares.as_ref().filter(|_| !is_exact)?.of_samples()?;
        let is_there = |((at, to), scale): ((&f64, &f64), &f64)| ((at - to) * scale).abs() <= NEARBY;
        at.iter().zip(values).zip(unknowns.scale.iter()).all(is_there).then_some(squares)
    }

    fn write(&mut self, values: &[f64], rows: &mut Rows) -> bool {
        if let Some((_, written)) = self.written.as_ref().filter(|(at, _)| at == values) {
            rows.clone_from(written);
            return true;
        }
        let is_written = self.try_write(values, rows).is_some() && rows.is_finite();
        match &mut self.written {
            _ if !is_written => {}
            Some((at, written)) => {
                at.copy_from_slice(values);
                written.clone_from(rows);
            }
            none => *none = Some((values.to_vec(), rows.clone())),
        }
        is_written
    }

    fn unpredicted(&self) -> Option<(usize, String)> {
        let sample = self.unpredicted?;
        Some((sample, self.reason(sample)))
    }

    fn leave_out_missing(&mut self, values: &[f64]) -> Vec<Missing> {
        let Some(model) = self.model.with_parameters(self.parameters, values) else { return Vec::new() };
        if self.predict(&model, &mut State::at_home(&model)).is_some() {
            return Vec::new();
        }
        let is_missing = |sample: &usize| self.solutions.status(*sample) != Status::Converged;
        let missing: Vec<Missing> = (0..self.samples.len())
            .filter(is_missing)
            .map(|sample| Missing { sample, reason: self.reason(sample) })
            .collect();
        missing.iter().for_each(|missing| self.left_out[missing.sample] = true);
        missing
    }

    fn informative_rows(&self) -> usize {
        let left_out = self.left_out.iter().filter(|left_out| **left_out).count();
        self.layout().free_rows() - self.size() * left_out
    }
}

/// True where the accuracies are stated that weigh the errors of poses.
fn is_stated(given: &Given<'_, '_>) -> bool {
    let Given { model, samples, settings, .. } = given;
    let is_stated = |sigma: Option<f64>| sigma.is_some_and(|sigma| sigma > 0.0);
    let turns = !model.needs_tensions() && model.robot().motion_pattern.has_rotation();
    // rotations count beside positions by a length that is none of their accuracies
    let has_length = settings.rotation_length.is_some() || !is_stated(samples.sigmas.rotation);
    !(turns && has_length) && is_stated(samples.sigmas.position)
}

impl PoseResidual<'_> {
    /// Rows of one sample.
    fn size(&self) -> usize {
        self.model.dof() + if self.metric.tension.is_some() { self.model.cable_count() } else { 0 }
    }

    /// The reason for which a sample has no prediction where was predicted last.
    fn reason(&self, sample: usize) -> String {
        let mut lengths = vec![0.0; self.model.cable_count()];
        self.lengths.read(sample, &mut lengths);
        let (mut state, near) = (State::at_home(&self.model), &self.samples.poses[sample]);
        match self.model.forward_with(&self.settings, &lengths, None, Some(near), &mut state) {
            Err(error) => error.to_string(),
            Ok(solution) => solution.reason.clone().unwrap_or_else(|| "the forward problem has no solution".to_owned()),
        }
    }

    fn try_write(&mut self, values: &[f64], rows: &mut Rows) -> Option<()> {
        let model = &self.model.with_parameters(self.parameters, values)?;
        let load = if model.needs_tensions() { Some(Load::of(model.robot()).ok()?) } else { None };
        self.predict(model, &mut State::at_home(model))?;
        let mut rest = Rest::new(model);
        for sample in 0..self.samples.len() {
            if self.left_out[sample] {
                rows.leave_out(sample);
                continue;
            }
            let pose = self.solutions.pose(sample);
            let recorded = Recorded::of(self.samples, sample);
            let tension = |cable: usize| match load {
                Some(_) => self.solutions.tension(cable, sample),
                None => f64::NAN,
            };
            rest.settle(&pose, load.as_ref(), &recorded, tension)?;
            self.write_sample(sample, &rest, &recorded, rows);
        }
        Some(())
    }

    fn write_sample(&self, sample: usize, rest: &Rest<'_>, recorded: &Recorded<'_>, rows: &mut Rows) {
        let (n, first) = (self.model.dof(), sample * self.size());
        let error = self.samples.poses[sample].displacement_to(&rest.pose);
        let (mut by_wrench, basis) = (rest.basis * rest.by_wrench, self.model.twist_basis());
        let turned = by_turn(&error) * by_wrench.fixed_rows::<3>(3);
        by_wrench.fixed_rows_mut::<3>(3).copy_from(&turned);
        by_wrench = rest.basis.tr_mul(&by_wrench);
        for (row, twist) in basis.iter().enumerate() {
            let unit = self.metric.along(twist);
            rows.residuals[first + row] = unit * twist.dot(&error);
            by_wrench.row_mut(row).scale_mut(unit);
        }
        if let Some(weight) = self.metric.tension {
            for (cable, measured) in recorded.tensions().iter().enumerate() {
                let predicted = rest.model.recorded_tension(cable, rest.cables[cable].state.outlet_tension);
                rows.residuals[first + n + cable] = weight * (predicted - measured);
            }
        }
        for (column, parameter) in self.parameters.iter().enumerate() {
            let push = rest.by_parameter(parameter, recorded);
            let change = by_wrench * push.wrench;
            rows.jacobian.view_mut((first, column), (n, 1)).copy_from(&change.rows(0, n));
            if let Some(weight) = self.metric.tension {
                for cable in 0..self.model.cable_count() {
                    let change = rest.recorded_tension_change(cable, parameter, &push);
                    rows.jacobian[(first + n + cable, column)] = weight * change;
                }
            }
        }
    }
}

/// A cable of a robot at rest.
struct RestCable {
    state: CableState,
    /// Whether its tension stays zero.
    is_slack: bool,
    /// Change of wrench (world) and recorded length with the tension at a fixed pose.
    by_tension: (Wrench, f64),
    /// Change of the tension with a wrench on the platform at fixed controlled lengths (per N, per N·m).
    tension_by_wrench: Vector6<f64>,
}

/// A robot at rest with given controlled lengths.
struct Rest<'a> {
    model: &'a Model,
    /// Directions of the pattern as columns, zeros behind them.
    basis: Matrix6<f64>,
    pose: Pose,
    rotation: Matrix3<f64>,
    /// The load that the cables balance there; `None` where they only keep their lengths.
    load: Option<Load>,
    cables: Vec<RestCable>,
    /// K_wx⁻¹: change of the pose, in the directions of the pattern, with a wrench (world); zeros behind them.
    by_wrench: Matrix6<f64>,
}

/// Effect of one unit of a parameter on a robot that is held.
struct Push {
    /// Wrench on the platform (world).
    wrench: Wrench,
    /// Change of the tension of the parameter's cable (N).
    own_tension: f64,
}

impl<'a> Rest<'a> {
    /// Nowhere yet.
    fn new(model: &'a Model) -> Self {
        let basis = Matrix6::from_fn(|row, k| model.twist_basis().get(k).map_or(0.0, |twist| twist[row]));
        let cables = Vec::with_capacity(model.cable_count());
        let (rotation, by_wrench) = (Matrix3::identity(), Matrix6::zeros());
        Self { model, basis, pose: Pose::identity(), rotation, load: None, cables, by_wrench }
    }

    /// Comes to rest at a pose with what was recorded there; `None` if it cannot.
    fn settle(
        &mut self,
        pose: &Pose,
        load: Option<&Load>,
        recorded: &Recorded<'_>,
        tension: impl Fn(usize) -> f64,
    ) -> Option<()> {
        let model = self.model;
        let mut by_pose = load.map_or_else(Matrix6::zeros, |load| load.gradient(pose));
        self.cables.clear();
        for cable in 0..model.cable_count() {
            let controlled = || model.controlled_length(cable, recorded.length(model, cable));
            let state = match load {
                Some(_) => cable_state_at_outlet(model, pose, cable, tension(cable)).ok()?,
                None => unit_spring_state(model, pose, cable, |length| length - controlled()).ok()?,
            };
            let is_slack = load.is_some() && model.law(cable).may_be_slack(tension(cable), 0.0);
            let by_tension = state.by_given_tension(1.0);
            if !is_slack {
                // at fixed controlled length the tension follows the pose
                let row = state.controlled_length_by_pose() * (-state.recording.length_scale / by_tension.1);
                by_pose += state.wrench_by_pose() + by_tension.0 * row.transpose();
            }
            self.cables.push(RestCable { state, is_slack, by_tension, tension_by_wrench: Vector6::zeros() });
        }
        let n = model.dof();
        let mut stiffness = -self.basis.tr_mul(&(by_pose * self.basis));
        (n..6).for_each(|k| stiffness[(k, k)] = 1.0);
        self.by_wrench = stiffness.try_inverse()? * self.basis.transpose();
        (self.pose, self.rotation, self.load) = (*pose, pose.rotation_matrix(), load.copied());
        if load.is_some() {
            self.settle_tensions();
        }
        Some(())
    }

    fn settle_tensions(&mut self) {
        let basis = self.model.twist_basis();
        for cable in self.cables.iter_mut().filter(|cable| !cable.is_slack) {
            let along = |twist: &Twist| -cable.state.recorded_length_by_twist(twist) / cable.by_tension.1;
            let by_pose = Vector6::from_fn(|k, _| basis.get(k).map_or(0.0, along));
            cable.tension_by_wrench = self.by_wrench.tr_mul(&by_pose);
        }
    }

    fn by_parameter(&self, parameter: &Parameter, recorded: &Recorded<'_>) -> Push {
        let none = Push { wrench: Wrench::zeros(), own_tension: 0.0 };
        match parameter.kind {
            kind if kind.is_of_load() => {
                let by_load = |load: &Load| load.by_parameter(self.model.robot(), parameter, &self.pose);
                Push { wrench: self.load.as_ref().map_or_else(Wrench::zeros, by_load), ..none }
            }
            // what is recorded of the tensions moves nothing
            ParameterKind::TensionScale | ParameterKind::TensionOffset => none,
            _ if self.cables[parameter.cable].is_slack => none,
            _ => {
                let RestCable { state, by_tension, .. } = &self.cables[parameter.cable];
                let (wrench, length) = self.model.by_parameter(parameter.cable, state, parameter, &self.rotation);
                let own_tension = (recorded.change(self.model, parameter) - length) / by_tension.1;
                Push { wrench: wrench + by_tension.0 * own_tension, own_tension }
            }
        }
    }

    /// Change of the tension that is recorded of a cable (N).
    fn recorded_tension_change(&self, cable: usize, parameter: &Parameter, push: &Push) -> f64 {
        let is_own = parameter.cable == cable;
        let RestCable { state, tension_by_wrench, .. } = &self.cables[cable];
        match parameter.kind {
            ParameterKind::TensionScale if is_own => return state.outlet_tension,
            ParameterKind::TensionOffset if is_own => return 1.0,
            _ => {}
        }
        let own = if is_own { push.own_tension } else { 0.0 };
        state.recording.tension_scale * (own + tension_by_wrench.dot(&push.wrench))
    }
}
