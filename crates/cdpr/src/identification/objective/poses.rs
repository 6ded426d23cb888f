//! Vectors in Cartesian space: predicted minus measured poses, of elastic models with predicted minus recorded tensions (eq. 4.1, 4.31).
//!
//! Predicted is the answer of the forward problem to the recorded lengths, and its derivative follows from the implicit function theorem. At
//! rest W(x, p) = 0, W the wrench of load and cables at fixed controlled lengths, so that δx = K_wx⁻¹ ∂W/∂p δp (eq. 4.33). Forward kinematics is
//! the same with cables as springs of 1 N/m whose tensions are the residuals of the lengths: that gives eq. 4.4 with the sign of `maths.md`,
//! the curvature of the lengths included.

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use super::metric::Metric;
use super::vectors::{Stacked, Vectors};
use crate::cable::CableState;
use crate::equilibrium::{ForwardSettings, Solutions, State, Status};
use crate::geometry::{Pose, PoseBatch, Twist};
use crate::identification::recorded::Recorded;
use crate::measurement::Samples;
use crate::model::Model;
use crate::robot::{Parameter, ParameterKind};
use crate::scalar::LaneTable;
use crate::statics::{Load, cable_state_at_outlet, unit_spring_state};

/// Errors of predicted poses, in the units of a metric: n a sample, with the m of the tensions n + m.
pub(super) struct PoseVectors<'a> {
    model: &'a Model,
    samples: &'a Samples,
    parameters: &'a [Parameter],
    metric: Metric,
    /// Measured poses: where every search begins, whatever was predicted before.
    guesses: PoseBatch,
    lengths: LaneTable,
    solutions: Solutions,
    settings: ForwardSettings,
    /// Sample without a prediction, where one had none.
    unpredicted: Option<usize>,
}

impl<'a> PoseVectors<'a> {
    pub(super) fn new(model: &'a Model, samples: &'a Samples, parameters: &'a [Parameter], metric: Metric) -> Self {
        let mut settings = ForwardSettings::default();
        // the measured pose is near: a residual is the model's, not a wrong minimum's
        settings.least_squares.suspicious_residual = settings.least_squares.plausible_residual;
        let mut lengths = LaneTable::new(model.cable_count());
        lengths.resize(samples.len());
        Self {
            model,
            samples,
            parameters,
            metric,
            guesses: samples.poses.iter().collect(),
            lengths,
            solutions: Solutions::default(),
            settings,
            unpredicted: None,
        }
    }

    /// Sample without a prediction (from 0) at the last parameters, with the reason.
    pub(super) fn unpredicted(&self) -> Option<(usize, String)> {
        let sample = self.unpredicted?;
        let mut lengths = vec![0.0; self.model.cable_count()];
        self.lengths.read(sample, &mut lengths);
        let (mut state, near) = (State::at_home(self.model), &self.samples.poses[sample]);
        let found = self.model.forward_with(&self.settings, &lengths, None, Some(near), &mut state);
        let reason = match found {
            Err(error) => error.to_string(),
            Ok(solution) => solution.reason.clone().unwrap_or_else(|| "the forward problem has no solution".to_owned()),
        };
        Some((sample, reason))
    }

    /// Predicts all poses; nothing where one has no prediction.
    fn predict(&mut self, model: &Model, state: &mut State) -> Option<()> {
        let mut controlled = vec![0.0; model.cable_count()];
        for sample in 0..self.samples.len() {
            let recorded = Recorded::of(self.samples, sample);
            for (cable, length) in controlled.iter_mut().enumerate() {
                *length = model.controlled_length(cable, recorded.length(model, cable));
            }
            self.lengths.write(sample, &controlled);
        }
        model.forward_batch((&self.settings, false), &self.lengths, &self.guesses, state, &mut self.solutions).ok()?;
        self.unpredicted = (0..self.samples.len()).find(|&sample| self.solutions.status(sample) != Status::Converged);
        self.unpredicted.is_none().then_some(())
    }
}

impl Vectors for PoseVectors<'_> {
    fn size(&self) -> usize {
        self.model.dof() + if self.metric.tension.is_some() { self.model.cable_count() } else { 0 }
    }

    fn samples(&self) -> usize {
        self.samples.len()
    }

    fn write(&mut self, values: &[f64], stacked: &mut Stacked) -> bool {
        self.try_write(values, stacked).is_some() && stacked.is_finite()
    }
}

impl PoseVectors<'_> {
    fn try_write(&mut self, values: &[f64], stacked: &mut Stacked) -> Option<()> {
        let model = &self.model.with_parameters(self.parameters, values)?;
        let load = if model.needs_tensions() { Some(Load::of(model.robot()).ok()?) } else { None };
        self.predict(model, &mut State::at_home(model))?;
        for sample in 0..self.samples.len() {
            let pose = self.solutions.pose(sample);
            let recorded = Recorded::of(self.samples, sample);
            let tension = |cable: usize| match load {
                Some(_) => self.solutions.tension(cable, sample),
                None => f64::NAN,
            };
            let rest = Rest::of(model, &pose, load.as_ref(), &recorded, tension)?;
            self.write_sample(sample, &rest, &recorded, stacked);
        }
        Some(())
    }

    fn write_sample(&self, sample: usize, rest: &Rest<'_>, recorded: &Recorded<'_>, stacked: &mut Stacked) {
        let (n, first) = (self.model.dof(), sample * self.size());
        let error = self.samples.poses[sample].displacement_to(&rest.pose);
        let (by_turn, basis) = (by_turn(&error), self.model.twist_basis());
        for (row, twist) in basis.iter().enumerate() {
            stacked.residuals[first + row] = self.metric.along(twist) * twist.dot(&error);
        }
        if let Some(weight) = self.metric.tension {
            for (cable, measured) in recorded.tensions().iter().enumerate() {
                let predicted = rest.model.recorded_tension(cable, rest.states[cable].outlet_tension);
                stacked.residuals[first + n + cable] = weight * (predicted - measured);
            }
        }
        for (column, parameter) in self.parameters.iter().enumerate() {
            let answer = rest.by_parameter(parameter, recorded);
            let mut moved = answer.twist;
            let turned = by_turn * moved.fixed_rows::<3>(3);
            moved.fixed_rows_mut::<3>(3).copy_from(&turned);
            for (row, twist) in basis.iter().enumerate() {
                stacked.jacobian[(first + row, column)] = self.metric.along(twist) * twist.dot(&moved);
            }
            if let Some(weight) = self.metric.tension {
                for cable in 0..self.model.cable_count() {
                    let change = rest.recorded_tension_change(cable, parameter, &answer);
                    stacked.jacobian[(first + n + cable, column)] = weight * change;
                }
            }
        }
    }
}

/// Change of the rotation vector of an error with a turn of the predicted pose (world): the inverse of the left Jacobian of SO(3).
pub(super) fn by_turn(error: &Twist) -> Matrix3<f64> {
    let vector: Vector3<f64> = error.fixed_rows::<3>(3).into_owned();
    let (angle, cross) = (vector.norm(), vector.cross_matrix());
    let second = match angle < 1e-4 {
        true => 1.0 / 12.0 + angle * angle / 720.0,
        false => 1.0 / (angle * angle) - 0.5 / (angle * (0.5 * angle).tan()),
    };
    Matrix3::identity() - 0.5 * cross + second * cross * cross
}

/// A robot at rest with given controlled lengths.
struct Rest<'a> {
    model: &'a Model,
    pose: Pose,
    rotation: Matrix3<f64>,
    states: Vec<CableState>,
    /// Cables whose tension stays zero.
    is_slack: Vec<bool>,
    /// K_wx⁻¹ in the degrees of freedom of the pattern, ones on the diagonal behind them.
    compliance: Matrix6<f64>,
    /// Change of each tension with the pose at fixed controlled length, in those degrees of freedom (N/m, N).
    tension_by_pose: Vec<Vector6<f64>>,
}

/// Change of a robot at rest with one unit of a parameter.
struct Answer {
    /// Of the pose, in the degrees of freedom of the pattern.
    pose: Vector6<f64>,
    /// The same as a twist (world).
    twist: Twist,
    /// Change of the tension of the parameter's cable at a fixed pose (N).
    own_tension: f64,
}

impl<'a> Rest<'a> {
    fn of(
        model: &'a Model,
        pose: &Pose,
        load: Option<&Load>,
        recorded: &Recorded<'_>,
        tension: impl Fn(usize) -> f64,
    ) -> Option<Self> {
        let state = |cable: usize| match load {
            Some(_) => cable_state_at_outlet(model, pose, cable, tension(cable)).ok(),
            None => {
                let controlled = model.controlled_length(cable, recorded.length(model, cable));
                let (path, _) = model.path(cable, pose).ok()?;
                unit_spring_state(model, pose, cable, path.length - controlled).ok()
            }
        };
        let states: Vec<CableState> = (0..model.cable_count()).map(state).collect::<Option<_>>()?;
        let slack = |cable: usize| load.is_some() && model.law(cable).may_be_slack(tension(cable), 0.0);
        let is_slack: Vec<bool> = (0..states.len()).map(slack).collect();
        let basis = model.twist_basis();
        let mut by_pose = load.map_or_else(Matrix6::zeros, |load| load.gradient(pose));
        let mut tension_by_pose = vec![Vector6::zeros(); states.len()];
        for (cable, state) in states.iter().enumerate().filter(|(cable, _)| !is_slack[*cable]) {
            // at fixed controlled length the tension follows the pose
            let (by_tension, length_by_tension) = state.by_given_tension(1.0);
            let along = |twist: &Twist| -state.recorded_length_by_twist(twist) / length_by_tension;
            tension_by_pose[cable] = Vector6::from_fn(|k, _| basis.get(k).map_or(0.0, along));
            let row = state.controlled_length_by_pose() * (-state.recording.length_scale / length_by_tension);
            by_pose += state.wrench_by_pose() + by_tension * row.transpose();
        }
        let in_pattern = Matrix6::from_fn(|row, column| match (basis.get(row), basis.get(column)) {
            (Some(row), Some(column)) => -row.dot(&(by_pose * column)),
            _ => f64::from(u8::from(row == column)),
        });
        Some(Self {
            model,
            pose: *pose,
            rotation: pose.rotation_matrix(),
            tension_by_pose,
            compliance: in_pattern.try_inverse()?,
            states,
            is_slack,
        })
    }

    fn by_parameter(&self, parameter: &Parameter, recorded: &Recorded<'_>) -> Answer {
        let basis = self.model.twist_basis();
        let none = Answer { pose: Vector6::zeros(), twist: Twist::zeros(), own_tension: 0.0 };
        let (wrench, own_tension) = match parameter.kind {
            ParameterKind::Wrench => (basis[parameter.axis], 0.0),
            // what is recorded of the tensions moves nothing
            ParameterKind::TensionScale | ParameterKind::TensionOffset => return none,
            _ if self.is_slack[parameter.cable] => return none,
            _ => {
                let state = &self.states[parameter.cable];
                let (wrench, length) = self.model.by_parameter((parameter.cable, state), parameter, &self.rotation);
                let (by_tension, length_by_tension) = state.by_given_tension(1.0);
                let tension = (recorded.change(self.model, parameter) - length) / length_by_tension;
                (wrench + by_tension * tension, tension)
            }
        };
        let pushed = Vector6::from_fn(|k, _| basis.get(k).map_or(0.0, |twist| twist.dot(&wrench)));
        let pose = self.compliance * pushed;
        Answer { pose, twist: basis.iter().zip(pose.iter()).map(|(twist, amount)| twist * *amount).sum(), own_tension }
    }

    /// Change of the tension that is recorded of a cable (N).
    fn recorded_tension_change(&self, cable: usize, parameter: &Parameter, answer: &Answer) -> f64 {
        let is_own = parameter.cable == cable;
        let recording = &self.states[cable].recording;
        match parameter.kind {
            ParameterKind::TensionScale if is_own => return self.states[cable].outlet_tension,
            ParameterKind::TensionOffset if is_own => return 1.0,
            _ => {}
        }
        let own = if is_own && parameter.kind != ParameterKind::Wrench { answer.own_tension } else { 0.0 };
        recording.tension_scale * (own + self.tension_by_pose[cable].dot(&answer.pose))
    }
}
