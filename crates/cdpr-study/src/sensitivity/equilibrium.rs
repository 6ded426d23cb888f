//! A machine at rest, linearized: derivatives of pose and tensions by the lengths sent and by deviations.
//!
//! At rest Aᵀ(x, p) f + w(x, p) = 0 and s q_θ(x, f, p) + o = q_sent for every taut cable, s and o the machine's encoder
//! scale and offset. By the implicit function theorem
//!
//! \[∂W/∂x, ∂W/∂f; ∂q/∂x, ∂q/∂f\] \[dx̂; df̂\] = \[−∂W/∂p; dq_sent − ∂q/∂p\] dp.
//!
//! Eliminating df̂ gives K_wx dx̂ = … (eq. 2.74), but with the rows of tensions it also works for cables that do not
//! stretch. A slack cable keeps f = 0. A rigid machine goes to the least-squares pose, the equilibrium of springs of 1
//! N/m without load whose tensions are the residuals.

use nalgebra::{DMatrix, DVector};

use super::cause::ParameterDeviation;
use cdpr_model::cable::CableState;
use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::model::Model;
use cdpr_model::robot::ParameterKind;
use cdpr_model::statics::{Load, StaticsError, cable_state_at_outlet, unit_spring_state};

/// A machine at an emerging state.
pub(super) struct Equilibrium<'a> {
    model: &'a Model,
    pose: Pose,
    cables: Vec<CableState>,
    is_slack: Vec<bool>,
    /// Inverse of the matrix above, with tensions in units of `scale` newtons and wrench rows divided by it, so that
    /// all entries are in metres.
    inverse: DMatrix<f64>,
    /// Newtons per metre.
    scale: f64,
    /// True if a load acts; rigid machines have springs in place of cables and no load.
    has_load: bool,
}

/// Change of a machine's pose and tensions.
pub(super) struct Answer {
    /// Displacement in the pattern's degrees of freedom (m, rad).
    pub(super) pose: DVector<f64>,
    /// Change of the tensions (N).
    pub(super) tensions: DVector<f64>,
}

impl<'a> Equilibrium<'a> {
    /// An elastic machine at rest with these outlet tensions (N); `None` if its stiffness is singular.
    pub(super) fn elastic(
        model: &'a Model,
        pose: &Pose,
        tensions: &[f64],
        load: &Load,
    ) -> Result<Option<Self>, StaticsError> {
        let cables: Vec<CableState> = tensions
            .iter()
            .enumerate()
            .map(|(cable, &tension)| cable_state_at_outlet(model, pose, cable, tension))
            .collect::<Result<_, _>>()?;
        let is_slack = |(cable, &tension): (usize, &f64)| model.law(cable).may_be_slack(tension, 0.0);
        let is_slack: Vec<bool> = tensions.iter().enumerate().map(is_slack).collect();
        Ok(Self::of(model, pose, cables, is_slack, Some(load)))
    }

    /// A rigid machine at its least-squares pose for these controlled lengths (m); `None` if they do not determine it.
    pub(super) fn rigid(model: &'a Model, pose: &Pose, lengths: &[f64]) -> Result<Option<Self>, StaticsError> {
        let geometric = model.cable_lengths(pose)?;
        let residuals = geometric.iter().zip(lengths).map(|(q, length)| q - length);
        let cables: Vec<CableState> = residuals
            .enumerate()
            .map(|(cable, residual)| unit_spring_state(model, pose, cable, |_| residual))
            .collect::<Result<_, _>>()?;
        let is_slack = vec![false; cables.len()];
        Ok(Self::of(model, pose, cables, is_slack, None))
    }

    fn of(
        model: &'a Model,
        pose: &Pose,
        cables: Vec<CableState>,
        is_slack: Vec<bool>,
        load: Option<&Load>,
    ) -> Option<Self> {
        let (basis, n) = (model.twist_basis(), model.dof());
        let size = n + cables.len();
        let slope = |cable: &CableState| cable.by_given_tension(1.0).1.abs();
        let softest = cables.iter().map(slope).fold(0.0, f64::max);
        // without elastic cables the unit is arbitrary
        let scale = if softest > 0.0 { 1.0 / softest } else { 1.0 };
        let mut matrix = DMatrix::zeros(size, size);
        let mut by_pose = load.map_or_else(Default::default, |load| load.gradient(pose));
        for (index, cable) in cables.iter().enumerate() {
            let (wrench, length) = cable.by_given_tension(1.0);
            by_pose += cable.wrench_by_pose();
            if is_slack[index] {
                matrix[(n + index, n + index)] = 1.0;
                continue;
            }
            for (row, twist) in basis.iter().enumerate() {
                matrix[(row, n + index)] = twist.dot(&wrench);
                matrix[(n + index, row)] = cable.recorded_length_by_twist(twist);
            }
            matrix[(n + index, n + index)] = length * scale;
        }
        for (column, direction) in basis.iter().enumerate() {
            let change = by_pose * direction;
            basis.iter().enumerate().for_each(|(row, twist)| matrix[(row, column)] = twist.dot(&change) / scale);
        }
        let inverse = matrix.try_inverse().filter(|inverse| inverse.iter().all(|entry| entry.is_finite()))?;
        Some(Self { model, pose: *pose, cables, is_slack, inverse, scale, has_load: load.is_some() })
    }

    /// Change of pose and tensions by a change of the lengths sent, in the units of the machine's encoders (m).
    pub(super) fn by_sent(&self, sent: &DVector<f64>) -> Answer {
        self.answer(&self.right_side(sent, None))
    }

    /// Change of pose and tensions by one unit of a deviation of this machine, together with a change of the lengths
    /// sent (m).
    pub(super) fn by_cause(&self, cause: &ParameterDeviation, sent: &DVector<f64>) -> Answer {
        self.answer(&self.right_side(sent, Some(cause)))
    }

    fn right_side(&self, sent: &DVector<f64>, cause: Option<&ParameterDeviation>) -> DVector<f64> {
        let n = self.model.dof();
        let mut right = DVector::zeros(n + self.cables.len());
        right.rows_mut(n, self.cables.len()).copy_from(sent);
        if let Some(cause) = cause {
            let (wrench, length) = self.deviation(cause);
            for (row, twist) in self.model.twist_basis().iter().enumerate() {
                right[row] -= twist.dot(&wrench) / self.scale;
            }
            right[n + cause.cable] -= length;
        }
        let slack = (0..self.cables.len()).filter(|&cable| self.is_slack[cable]);
        slack.for_each(|cable| right[n + cable] = 0.0);
        right
    }

    /// Change of the wrench at a fixed state, and of the length of the cause's cable, per unit of a cause.
    fn deviation(&self, cause: &ParameterDeviation) -> (Wrench, f64) {
        if let Some((parameter, change)) = cause.cable_parameter(self.model) {
            let (cable, rotation) = (cause.cable, self.pose.rotation_matrix());
            let (wrench, length) = self.model.by_parameter(cable, &self.cables[cable], &parameter, &rotation);
            return (wrench * change, length * change);
        }
        match self.has_load {
            true => (load_change(cause, self.model, &self.pose), 0.0),
            false => (Wrench::zeros(), 0.0),
        }
    }

    fn answer(&self, right: &DVector<f64>) -> Answer {
        let n = self.model.dof();
        let change = &self.inverse * right;
        let tensions = change.rows(n, self.cables.len()) * self.scale;
        Answer { pose: change.rows(0, n).into_owned(), tensions }
    }
}

/// Change of the load by one unit of a deviation (world; N, N·m).
pub(super) fn load_change(cause: &ParameterDeviation, model: &Model, pose: &Pose) -> Wrench {
    let robot = model.robot();
    let gravity = robot.gravity.unwrap_or_default();
    let at = |moment_arm: nalgebra::Vector3<f64>, force: nalgebra::Vector3<f64>| {
        let moment = (pose.rotation * moment_arm).cross(&force);
        Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
    };
    let Some(parameter) = cause.parameter() else { return Wrench::zeros() };
    match parameter.kind {
        ParameterKind::Force | ParameterKind::Moment => model.twist_basis()[parameter.degree_of_freedom(robot)],
        ParameterKind::Mass => at(robot.platform.center_of_mass.unwrap_or_default(), gravity),
        ParameterKind::CenterOfMass => {
            let weight = gravity * robot.platform.mass.unwrap_or(0.0);
            let mut wrench = at(model.axes()[cause.axis], weight);
            wrench.fixed_rows_mut::<3>(0).fill(0.0);
            wrench
        }
        _ => Wrench::zeros(),
    }
}
