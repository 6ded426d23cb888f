//! Friction of a drum and of the pulley over which its cable runs.
//!
//! A turning drum has the torque sign(φ̇) (T_c + (T_s − T_c) exp(−(φ̇/φ̇_s)²)) + d φ̇ (Coulomb, Stribeck, viscous), and
//! its cable the tension f exp(∓μ β) if it is paid out or reeled in (Euler and Eytelwein, β the wrap angle). Sticking
//! is a state: a drum at rest is held while its torque lies between the torques at which it would begin to turn.

use cdpr_model::robot::Cable;

/// Friction of one winch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Friction {
    /// T_c: dry friction of a turning drum (N·m).
    pub(super) coulomb: f64,
    /// T_s: dry friction of a drum at rest (N·m).
    pub(super) standing: f64,
    /// φ̇_s: Stribeck speed (rad/s).
    pub(super) stribeck: f64,
    /// d: torque per speed (N·m·s/rad).
    pub(super) viscous: f64,
    /// μ: friction coefficient of the pulley.
    pub(super) pulley: f64,
}

impl Friction {
    /// Friction in the robot file; zero where the file has none, and for pulleys if the model has none.
    pub(super) fn of(cable: &Cable, has_pulley: bool) -> Self {
        let coulomb = cable.winch.coulomb_friction.unwrap_or(0.0);
        Self {
            coulomb,
            standing: cable.winch.static_friction.unwrap_or(coulomb),
            stribeck: cable.winch.stribeck_speed.unwrap_or(1.0),
            viscous: cable.winch.viscous_friction.unwrap_or(0.0),
            pulley: if has_pulley { cable.pulley_friction.unwrap_or(0.0) } else { 0.0 },
        }
    }

    /// True if the force jumps with the direction.
    pub(super) fn is_dry(&self) -> bool {
        self.standing > 0.0 || self.pulley > 0.0
    }

    /// True if the torque in one direction is linear in the speed.
    pub(super) fn is_linear(&self) -> bool {
        self.standing <= self.coulomb
    }

    /// Friction torque of a drum at a speed (rad/s), against this direction (N·m).
    #[inline]
    pub(super) fn torque(&self, speed: f64, direction: f64) -> f64 {
        let dry = match self.standing > self.coulomb {
            true => self.coulomb + (self.standing - self.coulomb) * (-(speed / self.stribeck).powi(2)).exp(),
            false => self.coulomb,
        };
        self.viscous * speed + dry * direction.signum()
    }

    /// Ratio of the tension at the drum to that at the outlet, for a cable with a wrap angle (rad) that is paid out
    /// (positive direction) or reeled in.
    #[inline]
    pub(super) fn passed_on(&self, wrap: f64, direction: f64) -> f64 {
        if self.pulley == 0.0 { 1.0 } else { (-self.pulley * wrap * direction.signum()).exp() }
    }

    /// Steepest fall of the torque with speed (N·m·s/rad), at φ̇_s/√2: (T_s − T_c) √(2/e)/φ̇_s.
    pub(super) fn steepest_fall(&self) -> f64 {
        (self.standing - self.coulomb) * (2.0 / std::f64::consts::E).sqrt() / self.stribeck
    }
}
