//! Load on the platform besides the cables: constant wrench and weight, w of Aᵀ f + w = 0 (N, N·m; world axes).

use nalgebra::{DVector, Matrix3, Matrix6, Vector3};
use thiserror::Error;

use crate::geometry::{Pose, Wrench};
use crate::model::Model;
use crate::robot::{Parameter, ParameterKind, Robot};

/// The external load: a constant wrench in world axes, and a weight whose moment turns with the platform.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    constant: Wrench,
    /// m g (world, N).
    weight: Vector3<f64>,
    /// Centre of mass c (platform frame, m).
    center_of_mass: Vector3<f64>,
}

/// A robot file that does not state the load on the platform.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("the load on the platform of \"{robot}\" is unknown: its file lacks {key}; add it, or give the wrench")]
pub struct LoadError {
    /// Name of the robot.
    pub robot: String,
    /// The key that is missing, with its table.
    pub key: &'static str,
}

impl Load {
    /// A load with only a constant wrench (world axes, moment about the platform origin; N, N·m).
    pub fn constant(wrench: Wrench) -> Self {
        Self { constant: wrench, weight: Vector3::zeros(), center_of_mass: Vector3::zeros() }
    }

    /// The load that a robot's file states: its external wrench, and its weight unless that wrench includes it.
    ///
    /// Mass and centre of mass may be missing if they have no effect: both without gravity and for a planar robot with
    /// a horizontal plane, the centre of mass for a platform that does not turn.
    pub fn of(robot: &Robot) -> Result<Self, LoadError> {
        let missing = |key| LoadError { robot: robot.name.clone(), key };
        let constant = robot.external_wrench.as_ref().map_or_else(Wrench::zeros, |external| external.wrench);
        if robot.external_wrench.as_ref().is_some_and(|external| external.includes_gravity) {
            return Ok(Self::constant(constant));
        }
        let gravity = robot.gravity.ok_or_else(|| missing("`gravity_m_s2`"))?;
        let basis = robot.motion_pattern.twist_basis(robot.plane);
        let translations = robot.motion_pattern.translations();
        let matters = basis[..translations].iter().any(|twist| twist.fixed_rows::<3>(0).dot(&gravity) != 0.0);
        if !matters {
            return Ok(Self::constant(constant));
        }
        let mass = robot.platform.mass.ok_or_else(|| missing("`mass_kg` in [platform]"))?;
        let center_of_mass = match (robot.platform.center_of_mass, basis.len() > translations) {
            (Some(center), _) => center,
            (None, false) => Vector3::zeros(),
            (None, true) => return Err(missing("`center_of_mass_m` in [platform]")),
        };
        Ok(Self { constant, weight: gravity * mass, center_of_mass })
    }

    /// The wrench at a pose (world axes, moment about the platform origin; N, N·m): w_ext + m \[g; (R c) × g\].
    pub fn wrench(&self, pose: &Pose) -> Wrench {
        let moment = (pose.rotation * self.center_of_mass).cross(&self.weight);
        let mut wrench = self.constant;
        for k in 0..3 {
            wrench[k] += self.weight[k];
            wrench[3 + k] += moment[k];
        }
        wrench
    }

    /// ∂w/∂\[δr; δφ\] at a pose: only the weight's moment changes, by m \[g\]× \[R c\]× δφ.
    pub fn gradient(&self, pose: &Pose) -> Matrix6<f64> {
        let moment_arm = pose.rotation * self.center_of_mass;
        let moment: Matrix3<f64> = self.weight.cross_matrix() * moment_arm.cross_matrix();
        let mut gradient = Matrix6::zeros();
        gradient.fixed_view_mut::<3, 3>(3, 3).copy_from(&moment);
        gradient
    }

    /// Change of the wrench at a pose per unit of a parameter of the load (world axes, moment about the platform origin); zero for parameters of cables.
    pub fn by_parameter(&self, robot: &Robot, parameter: &Parameter, pose: &Pose) -> Wrench {
        let weight_at = |weight: Vector3<f64>, place: Vector3<f64>| {
            let moment = (pose.rotation * place).cross(&weight);
            Wrench::new(weight.x, weight.y, weight.z, moment.x, moment.y, moment.z)
        };
        let basis = robot.motion_pattern.twist_basis(robot.plane);
        let is_weighed = robot.external_wrench.as_ref().is_none_or(|external| !external.includes_gravity);
        match parameter.kind {
            ParameterKind::Mass if is_weighed => {
                weight_at(robot.gravity.unwrap_or_else(Vector3::zeros), self.center_of_mass)
            }
            ParameterKind::CenterOfMass => {
                let axis = basis[parameter.axis].fixed_rows::<3>(0).into_owned();
                weight_at(self.weight, axis) - weight_at(self.weight, Vector3::zeros())
            }
            ParameterKind::Wrench => basis[parameter.axis],
            _ => Wrench::zeros(),
        }
    }

    /// Norm of the constant force plus norm of the weight (N).
    pub fn force(&self) -> f64 {
        self.constant.fixed_rows::<3>(0).norm() + self.weight.norm()
    }

    /// The same load with the weight of another mass (kg) at the same centre.
    pub fn with_mass(self, robot: &Robot, mass: f64) -> Self {
        Self { weight: robot.gravity.unwrap_or_else(Vector3::zeros) * mass, ..self }
    }

    /// The constant part (world axes, moment about the platform origin; N, N·m).
    pub fn constant_part(&self) -> &Wrench {
        &self.constant
    }

    /// The weight m g (world, N) and the centre of mass c at which it acts (platform frame, m).
    pub fn weight(&self) -> (&Vector3<f64>, &Vector3<f64>) {
        (&self.weight, &self.center_of_mass)
    }

    /// The wrench in the degrees of freedom of a model, the n rows of its structure matrix.
    pub fn in_pattern(&self, model: &Model, pose: &Pose) -> DVector<f64> {
        let mut rows = DVector::zeros(model.dof());
        self.write_in_pattern(model, pose, rows.as_mut_slice());
        rows
    }

    /// Writes [`Load::in_pattern`] to memory of the caller, as many of the n rows as it has.
    pub(crate) fn write_in_pattern(&self, model: &Model, pose: &Pose, rows: &mut [f64]) {
        let wrench = self.wrench(pose);
        rows.iter_mut().zip(model.twist_basis()).for_each(|(row, twist)| *row = twist.dot(&wrench));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Twist;

    fn offset_weight() -> Load {
        let center_of_mass = Vector3::new(0.1, -0.2, 0.3);
        Load { weight: Vector3::new(0.0, 0.5, -9.81) * 20.0, center_of_mass, constant: Wrench::repeat(3.0) }
    }

    fn turned() -> Pose {
        Pose::from_xyz_angles(Vector3::new(0.1, -0.2, 0.4), [0.2, -0.3, 0.4])
    }

    #[test]
    fn the_gradient_is_that_of_the_wrench() {
        let (load, pose) = (offset_weight(), turned());
        let h = 1e-6; // central difference: truncation ~ h², rounding ~ 200 N · ε/h
        for axis in 0..6 {
            let step = Twist::ith(axis, h);
            let slope = (load.wrench(&pose.displaced(&step)) - load.wrench(&pose.displaced(&-step))) / (2.0 * h);
            assert!((slope - load.gradient(&pose).column(axis)).amax() < 1e-7, "axis {axis}");
        }
    }

    #[test]
    fn what_the_file_lacks_is_named() {
        let mut robot = Robot::builtin("cogiro").expect("built in");
        assert!(Load::of(&robot).is_ok());
        robot.platform.center_of_mass = None;
        assert_eq!(Load::of(&robot).unwrap_err().key, "`center_of_mass_m` in [platform]");
        robot.platform.mass = None;
        assert_eq!(Load::of(&robot).unwrap_err().key, "`mass_kg` in [platform]");
        robot.gravity = Some(Vector3::zeros());
        assert_eq!(Load::of(&robot), Ok(Load::constant(Wrench::zeros())));
    }
}
