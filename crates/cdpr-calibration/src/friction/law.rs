//! The law of a winch's torque, its parameters, and its derivatives by them.

use super::plateaus::Plateau;

/// Torques that differ by less than this share of the largest do not differ.
pub(super) const ROUND_OFF: f64 = 1e-9;

/// Parts of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Law {
    /// Number of loads; each has a torque of its own, unless `is_scaled`.
    pub(super) loads: usize,
    /// The load torque is a·(given torque) + b.
    pub(super) is_scaled: bool,
    /// Coulomb friction grows with the load torque.
    pub(super) by_load: bool,
    /// Friction falls from standing to sliding.
    pub(super) stribeck: bool,
    /// Friction by speed differs between lifting and lowering.
    pub(super) by_direction: bool,
}

/// A load: its number, and its given torque (N·m; 0 if none is given).
#[derive(Clone, Copy, Debug)]
pub(super) struct Hung {
    pub(super) group: usize,
    pub(super) given: f64,
}

impl Law {
    /// Parameters of the loads.
    pub(super) fn load_count(&self) -> usize {
        if self.is_scaled { 2 } else { self.loads }
    }

    /// Place of the Coulomb friction.
    pub(super) fn coulomb(&self) -> usize {
        self.load_count()
    }

    /// Place of the friction by speed.
    pub(super) fn viscous(&self) -> usize {
        self.coulomb() + 1
    }

    /// Place of the growth of Coulomb friction with the load.
    pub(super) fn growth(&self) -> Option<usize> {
        self.by_load.then_some(self.coulomb() + 2)
    }

    /// Place of the excess of standing friction; the logarithm of the Stribeck speed stands behind it.
    pub(super) fn excess(&self) -> Option<usize> {
        self.stribeck.then_some(self.coulomb() + 2 + usize::from(self.by_load))
    }

    /// Place of half the difference of friction by speed between lifting and lowering.
    pub(super) fn difference(&self) -> Option<usize> {
        self.by_direction.then(|| self.count() - 1)
    }

    /// Number of parameters.
    pub(super) fn count(&self) -> usize {
        let optional = usize::from(self.by_load) + 2 * usize::from(self.stribeck) + usize::from(self.by_direction);
        self.coulomb() + 2 + optional
    }

    /// Load torque of a load (N·m), and its derivatives by the parameters.
    pub(super) fn load(&self, hung: Hung, parameters: &[f64], gradient: &mut [f64]) -> f64 {
        if self.is_scaled {
            gradient[0] = hung.given;
            gradient[1] = 1.0;
            return parameters[0] * hung.given + parameters[1];
        }
        gradient[hung.group] = 1.0;
        parameters[hung.group]
    }

    /// Friction torque in the direction of motion (N·m) at a speed, and its derivatives, at a load.
    pub(super) fn friction(&self, hung: Hung, speed: f64, parameters: &[f64], gradient: &mut [f64]) -> f64 {
        let (coulomb, viscous) = (self.coulomb(), self.viscous());
        let mut torque = parameters[coulomb] + parameters[viscous] * speed.abs();
        gradient[coulomb] = 1.0;
        gradient[viscous] = speed.abs();
        if let Some(growth) = self.growth() {
            // by the torque that is given, or by the fitted one, which is a parameter itself
            let load = if self.is_scaled { hung.given } else { parameters[hung.group] };
            torque += parameters[growth] * load;
            gradient[growth] = load;
            if !self.is_scaled {
                gradient[hung.group] = parameters[growth];
            }
        }
        if let Some(excess) = self.excess() {
            let ratio = (speed / parameters[excess + 1].exp()).powi(2);
            let share = (-ratio).exp();
            torque += parameters[excess] * share;
            gradient[excess] = share;
            gradient[excess + 1] = parameters[excess] * share * 2.0 * ratio;
        }
        if let Some(difference) = self.difference() {
            torque += parameters[difference] * speed;
            gradient[difference] = speed;
        }
        torque
    }

    /// Torque of the motor at a plateau (N·m), and its derivatives.
    pub(super) fn torque(&self, plateau: &Plateau, parameters: &[f64], gradient: &mut [f64]) -> f64 {
        let hung = Hung { group: plateau.group, given: plateau.load.unwrap_or(0.0) };
        let (mut by_load, mut by_friction) = (vec![0.0; self.count()], vec![0.0; self.count()]);
        let load = self.load(hung, parameters, &mut by_load);
        let friction = self.friction(hung, plateau.speed, parameters, &mut by_friction);
        let sign = plateau.speed.signum();
        for ((out, load), friction) in gradient.iter_mut().zip(by_load).zip(by_friction) {
            *out = load + sign * friction;
        }
        load + sign * friction
    }
}
