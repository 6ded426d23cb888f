//! The dynamics as functions: mass matrix, bias, forward and inverse dynamics in the motion pattern's degrees of
//! freedom.

use nalgebra::{DMatrix, DVector};

use super::momentum::Inertia;
use super::plant::Plant;
use super::state::PlantState;
use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::model::Model;

impl Inertia {
    /// Bias n(x, v, ω) in M(x) \[v̇; ω̇\] + n = wrench, about the platform origin (world axes; N, N·m):
    /// \[m ω × (ω × s) + D_lin v; ω × J ω + m s × (ω × (ω × s)) + D_rot ω\].
    pub fn bias(&self, pose: &Pose, twist: &Twist) -> Wrench {
        let omega = twist.fixed_rows::<3>(3).into_owned();
        let center = self.center(pose);
        let force = omega.cross(&omega.cross(&center)) * self.body.mass;
        let turned = pose.rotation * (self.body.inertia * (pose.rotation.inverse() * omega));
        let moment = omega.cross(&turned) + center.cross(&force);
        Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z) - self.drag(twist)
    }

    /// Mass matrix in the n degrees of freedom of a model, Bᵀ M B.
    pub fn mass_matrix_in_pattern(&self, model: &Model, pose: &Pose) -> DMatrix<f64> {
        let (basis, matrix) = (model.twist_basis(), self.mass_matrix(pose));
        DMatrix::from_fn(basis.len(), basis.len(), |row, column| basis[row].dot(&(matrix * basis[column])))
    }

    /// Acceleration \[v̇; ω̇\] of the platform origin under the total wrench of cables and load (world axes, moment
    /// about the platform origin; N, N·m), restricted to the degrees of freedom of the motion pattern.
    pub fn acceleration(&self, model: &Model, pose: &Pose, twist: &Twist, wrench: &Wrench) -> Twist {
        let basis = model.twist_basis();
        let rest = wrench - self.bias(pose, twist);
        let right = DVector::from_fn(basis.len(), |row, _| basis[row].dot(&rest));
        let solved = self.mass_matrix_in_pattern(model, pose).cholesky().map(|factors| factors.solve(&right));
        let rates = solved.unwrap_or_else(|| DVector::repeat(basis.len(), f64::NAN));
        basis.iter().zip(&rates).map(|(twist, rate)| twist * *rate).sum()
    }

    /// Wrench that gives the platform an acceleration (world axes, moment about the platform origin; N, N·m): the
    /// inverse of [`Inertia::acceleration`]. Components in directions in which the pattern does not move are reactions.
    pub fn wrench_of_acceleration(&self, pose: &Pose, twist: &Twist, acceleration: &Twist) -> Wrench {
        self.mass_matrix(pose) * acceleration + self.bias(pose, twist)
    }
}

impl Plant {
    /// Acceleration \[v̇; ω̇\] of the platform origin (world axes; m/s², rad/s²) in a state with observed lengths and
    /// tensions, under a further wrench (world axes, moment about the platform origin; N, N·m).
    pub fn acceleration(&self, state: &PlantState, further: &Wrench) -> Twist {
        let twist = state.twist();
        let cables = match self.dissipates {
            true => state.pulls.wrench(&twist, |cable| state.cables[cable].controlled_length_rate),
            false => state.pulls.wrench_at_rest(),
        };
        let wrench = cables + state.load(self) + further;
        state.inertia.acceleration(&self.model, &state.pose, &twist, &wrench)
    }
}
