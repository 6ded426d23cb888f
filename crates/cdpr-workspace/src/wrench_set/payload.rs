//! Required wrenches of a payload: a range of masses in a box of accelerations.

use nalgebra::{Matrix3, Vector3};
use thiserror::Error;

use super::required::{Parallelotope, RequiredSet};
use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;

/// Payload of the cables: masses, and the accelerations that the cables must be able to give them.
///
/// For a mass m with the acceleration a of its centre of mass and the angular acceleration α the cables feel the
/// external wrench \[m (g − a); R c × m (g − a) − R I Rᵀ α\] (Newton and Euler at rest: no velocity, so no gyroscopic
/// moment). It is linear in m, a and α, so a range of masses in boxes of accelerations makes the convex hull of two
/// parallelotopes.
#[derive(Clone, Debug, PartialEq)]
pub struct Payload {
    /// Least and largest mass m (kg), all that the cables carry: platform and load.
    pub mass: [f64; 2],
    /// Centre of mass c (platform frame, m).
    pub center_of_mass: Vector3<f64>,
    /// Inertia I about the centre of mass at the largest mass (platform axes, kg·m²), proportional to the mass.
    pub inertia: Matrix3<f64>,
    /// Gravity g (world, m/s²).
    pub gravity: Vector3<f64>,
    /// Largest acceleration of the centre of mass along each world axis (m/s²); zero for static feasibility.
    pub acceleration: Vector3<f64>,
    /// Largest angular acceleration about each world axis (rad/s²).
    pub angular_acceleration: Vector3<f64>,
    /// Further constant wrench (world axes, moment about the platform origin; N, N·m).
    pub constant: Wrench,
}

/// A payload that is incomplete or invalid.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PayloadError {
    /// A key that the payload needs is missing.
    #[error("the payload of \"{robot}\" is unknown: its file lacks {key}; add it{hint}")]
    MissingKey {
        /// Name of the robot.
        robot: String,
        /// The key with its table.
        key: &'static str,
        /// Alternative input, in words.
        hint: &'static str,
    },
    /// Masses that are not a range.
    #[error("the payload's masses {least} kg to {largest} kg are no range: 0 ≤ least ≤ largest, both finite")]
    Mass {
        /// Least mass (kg).
        least: f64,
        /// Largest mass (kg).
        largest: f64,
    },
    /// A largest acceleration below zero, or not finite.
    #[error("the largest {what} along an axis is {value}; it is a finite number of 0 or more ({unit})")]
    Acceleration {
        /// Name of the acceleration.
        what: &'static str,
        /// Value given, in `unit`.
        value: f64,
        /// Unit of the value.
        unit: &'static str,
    },
}

impl Payload {
    /// The platform of a robot's file, at rest, with this range of masses or else the file's mass (kg).
    ///
    /// Centre of mass and inertia are required as far as the platform turns, the inertia only for angular
    /// accelerations. The accelerations (m/s², rad/s²) apply along and about every axis of the pattern.
    pub(crate) fn of(
        robot: &Robot,
        mass: Option<[f64; 2]>,
        acceleration: f64,
        angular_acceleration: f64,
    ) -> Result<Self, PayloadError> {
        let missing = |key, hint| PayloadError::MissingKey { robot: robot.name.clone(), key, hint };
        let turns = robot.motion_pattern.has_rotation();
        let stated = robot.platform.mass.map(|mass| [mass; 2]);
        let mass = mass.or(stated).ok_or_else(|| missing("`mass_kg` in [platform]", ", or give a range of masses"))?;
        let gravity = robot.gravity.ok_or_else(|| missing("`gravity_m_s2`", ""))?;
        let center_of_mass = match robot.platform.center_of_mass {
            Some(center) => center,
            None if turns => return Err(missing("`center_of_mass_m` in [platform]", "")),
            None => Vector3::zeros(),
        };
        let inertia = match robot.platform.inertia {
            Some(inertia) => inertia,
            None if turns && angular_acceleration != 0.0 => {
                return Err(missing("`inertia_about_center_of_mass_kg_m2` in [platform]", ""));
            }
            None => Matrix3::zeros(),
        };
        let external = robot.external_wrench.as_ref().filter(|external| !external.includes_gravity);
        let payload = Self {
            mass,
            center_of_mass,
            inertia,
            gravity,
            acceleration: Vector3::repeat(acceleration),
            angular_acceleration: Vector3::repeat(angular_acceleration),
            constant: external.map_or_else(Wrench::zeros, |external| external.wrench),
        };
        payload.check()?;
        Ok(payload)
    }

    /// Checks masses and accelerations.
    pub(crate) fn check(&self) -> Result<(), PayloadError> {
        let [least, largest] = self.mass;
        if !(0.0 <= least && least <= largest && largest.is_finite()) {
            return Err(PayloadError::Mass { least, largest });
        }
        for (what, unit, list) in [
            ("acceleration", "m/s²", &self.acceleration),
            ("angular acceleration", "rad/s²", &self.angular_acceleration),
        ] {
            if let Some(&value) = list.iter().find(|value| !(**value >= 0.0 && value.is_finite())) {
                return Err(PayloadError::Acceleration { what, value, unit });
            }
        }
        Ok(())
    }

    /// The external wrenches at a pose, in the rows of a model's structure matrix.
    ///
    /// Accelerations across the plane of a planar robot, and turns that a pattern does not have, have no effect.
    pub(crate) fn required(&self, model: &Model, pose: &Pose) -> RequiredSet {
        let [least, largest] = self.mass;
        match least == largest {
            true => RequiredSet::Parallelotopes(vec![self.at(largest, model, pose)]),
            false => RequiredSet::Parallelotopes(vec![self.at(least, model, pose), self.at(largest, model, pose)]),
        }
    }

    fn at(&self, mass: f64, model: &Model, pose: &Pose) -> Parallelotope {
        let moment_arm = pose.rotation * self.center_of_mass;
        let rotation = pose.rotation_matrix();
        // a massless payload has no inertia either
        let fraction = if self.mass[1] > 0.0 { mass / self.mass[1] } else { 0.0 };
        let inertia = rotation * self.inertia * rotation.transpose() * fraction;
        let rows = |force: Vector3<f64>, moment: Vector3<f64>| -> Vec<f64> {
            let wrench = Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
            model.twist_basis().iter().map(|twist| twist.dot(&wrench)).collect()
        };
        let of_force = |force: Vector3<f64>| rows(force, moment_arm.cross(&force));
        let mut center = of_force(self.gravity * mass);
        for (row, twist) in center.iter_mut().zip(model.twist_basis()) {
            *row += twist.dot(&self.constant);
        }
        let linear = (0..3).map(|axis| of_force(Vector3::ith(axis, -mass * self.acceleration[axis])));
        let turning = (0..3).map(|axis| {
            let alpha = Vector3::ith(axis, self.angular_acceleration[axis]);
            rows(Vector3::zeros(), -(inertia * alpha))
        });
        let edges = linear.chain(turning).filter(|edge| edge.iter().any(|&row| row != 0.0)).collect();
        Parallelotope { center, edges }
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use cdpr_model::model::Composition;

    /// A mass on a point platform, computed by hand: weight, weight with an acceleration, and half the mass.
    #[test]
    fn a_payload_asks_for_what_newton_says() {
        let robot = Robot::builtin("planar-example").unwrap();
        let model = Model::new(robot.clone(), Composition::STANDARD).unwrap();
        let mut payload = Payload {
            gravity: Vector3::new(0.0, 0.0, -10.0),
            ..Payload::of(&with_gravity(robot), Some([50.0, 100.0]), 2.0, 0.0).unwrap()
        };
        payload.gravity = model.robot().plane.second_axis() * -10.0;
        payload.constant = Wrench::zeros();
        let required = payload.required(&model, &Pose::identity());
        // down: 100 kg · (10 + 2) m/s², up: −50 · (10 − 2), across: 100 · 2
        for (normal, reach) in [([0.0, -1.0], 1200.0), ([0.0, 1.0], -400.0), ([1.0, 0.0], 200.0)] {
            assert!((required.support(&normal) - reach).abs() < 1e-9, "{normal:?}");
        }
        payload.acceleration = Vector3::zeros();
        assert!((payload.required(&model, &Pose::identity()).support(&[0.0, -1.0]) - 1000.0).abs() < 1e-9);
    }

    /// Newton and Euler about the platform origin: the wrench of the weight minus the change of momentum, computed by
    /// hand.
    #[test]
    fn a_payload_with_inertia_asks_for_newton_and_euler_at_every_corner() {
        let robot = Robot::builtin("cogiro").unwrap();
        let model = Model::new(robot.clone(), Composition::STANDARD).unwrap();
        let mut payload = Payload::of(&with_gravity(robot), Some([100.0, 100.0]), 14.0, 0.0).unwrap();
        payload.center_of_mass = Vector3::new(0.1, -0.2, 0.3);
        payload.inertia = Matrix3::new(4.0, 0.1, 0.2, 0.1, 5.0, -0.3, 0.2, -0.3, 6.0);
        payload.angular_acceleration = Vector3::new(1.0, 2.0, 3.0);
        let pose = Pose::from_xyz_angles(Vector3::new(1.0, 2.0, 3.0), [0.3, -0.5, 0.7]);
        let required = payload.required(&model, &pose);
        let mut rng = ChaCha8Rng::seed_from_u64(66);
        for _ in 0..100 {
            let normal: Vec<f64> = (0..6).map(|_| rng.random_range(-1.0..1.0)).collect();
            let mut most = f64::NEG_INFINITY;
            for corner in 0..64_u32 {
                let sign = |bit: u32| if corner & (1 << bit) != 0 { 1.0 } else { -1.0 };
                let a = Vector3::from_fn(|k, _| 14.0 * sign(k as u32));
                let alpha = Vector3::from_fn(|k, _| payload.angular_acceleration[k] * sign(3 + k as u32));
                let force = (payload.gravity - a) * 100.0;
                let local = pose.rotation.inverse() * alpha;
                let moment =
                    (pose.rotation * payload.center_of_mass).cross(&force) - pose.rotation * (payload.inertia * local);
                let row = |k: usize| if k < 3 { force[k] } else { moment[k - 3] } + payload.constant[k];
                most = most.max((0..6).map(|k| normal[k] * row(k)).sum());
            }
            assert!((required.support(&normal) - most).abs() < 1e-8 * most.abs().max(1e3));
            let furthest = required.furthest(&normal);
            assert!((furthest.iter().zip(&normal).map(|(w, n)| w * n).sum::<f64>() - most).abs() < 1e-8 * 1e4);
        }
    }

    fn with_gravity(mut robot: Robot) -> Robot {
        robot.gravity = Some(Vector3::new(0.0, 0.0, -9.81));
        robot
    }

    #[test]
    fn a_payload_names_what_the_file_lacks() {
        let mut robot = with_gravity(Robot::builtin("cogiro").unwrap());
        robot.platform.inertia = None;
        assert!(Payload::of(&robot, Some([1.0, 2.0]), 1.0, 0.0).is_ok());
        let words = |robot: &Robot, mass, a| Payload::of(robot, mass, a, 1.0).unwrap_err().to_string();
        assert!(words(&robot, None, 1.0).contains("inertia_about_center_of_mass_kg_m2"));
        assert!(Payload::of(&robot, Some([2.0, 1.0]), 1.0, 0.0).unwrap_err().to_string().contains("2 kg to 1 kg"));
        assert!(Payload::of(&robot, None, -1.0, 0.0).unwrap_err().to_string().contains("acceleration"));
        robot.platform.center_of_mass = None;
        assert!(words(&robot, None, 1.0).contains("center_of_mass_m"));
        robot.gravity = None;
        assert!(words(&robot, None, 1.0).contains("gravity_m_s2"));
        robot.platform.mass = None;
        assert!(words(&robot, None, 1.0).contains("mass_kg"));
    }
}
