//! The platform as a rigid body: mass, centre of mass and inertia.

use nalgebra::{Matrix3, Matrix6, Vector3};
use thiserror::Error;

use super::Robot;

/// Mass properties of a platform. A platform that does not rotate has no inertia, and its centre of mass has no effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// m (kg).
    pub mass: f64,
    /// c (platform frame, m).
    pub center_of_mass: Vector3<f64>,
    /// I_c about the centre of mass (platform axes, kg·m²).
    pub inertia: Matrix3<f64>,
}

/// A robot file that lacks mass properties.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("the motion of \"{robot}\" needs {key}: its file {fault}; add the key, in kg, m and kg·m²")]
pub struct BodyError {
    /// Name of the robot.
    pub robot: String,
    /// The key, with its table.
    pub key: &'static str,
    /// Error in the file, as the end of a sentence that begins "its file".
    pub fault: &'static str,
}

impl Body {
    /// Body of a robot's platform: mass above zero, and, if the pattern rotates, centre of mass and positive inertia.
    pub fn of(robot: &Robot) -> Result<Self, BodyError> {
        let refuse = |key, fault| BodyError { robot: robot.name.clone(), key, fault };
        let key = "`mass_kg` in [platform]";
        let mass = robot.platform.mass.ok_or_else(|| refuse(key, "lacks it"))?;
        if !(mass > 0.0) {
            return Err(refuse(key, "states none above zero"));
        }
        let point = Self { mass, center_of_mass: Vector3::zeros(), inertia: Matrix3::zeros() };
        if !robot.motion_pattern.has_rotation() {
            return Ok(point);
        }
        let key = "`center_of_mass_m` in [platform]";
        let center_of_mass = robot.platform.center_of_mass.ok_or_else(|| refuse(key, "lacks it"))?;
        let key = "`inertia_about_center_of_mass_kg_m2` in [platform]";
        let inertia = robot.platform.inertia.ok_or_else(|| refuse(key, "lacks it"))?;
        let is_positive = match robot.motion_pattern.is_planar() {
            true => robot.plane.normal().dot(&(inertia * robot.plane.normal())) > 0.0,
            false => inertia.cholesky().is_some(),
        };
        match is_positive {
            true => Ok(Self { mass, center_of_mass, inertia }),
            false => Err(refuse(key, "states none above zero")),
        }
    }

    /// True for an inertia that looks like a placeholder: equal about every axis about which the pattern rotates, and a
    /// power of ten (kg·m²).
    pub fn has_placeholder_inertia(&self, robot: &Robot) -> bool {
        let about = match robot.motion_pattern.has_rotation() {
            false => return false,
            true if robot.motion_pattern.is_planar() => {
                robot.plane.normal().dot(&(self.inertia * robot.plane.normal()))
            }
            true if self.inertia == Matrix3::identity() * self.inertia[(0, 0)] => self.inertia[(0, 0)],
            true => return false,
        };
        let exponent = about.log10();
        // rounding of the logarithm
        (exponent - exponent.round()).abs() < 1e-12
    }

    /// Mass matrix about the platform origin, \[m I, −m \[c\]×; m \[c\]×, I_c − m \[c\]×\[c\]×\] in platform axes (kg, kg·m, kg·m²).
    pub fn mass_matrix(&self) -> Matrix6<f64> {
        let mut matrix = Matrix6::identity() * self.mass;
        let moment_arm = self.center_of_mass.cross_matrix();
        matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&(-moment_arm * self.mass));
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&(moment_arm * self.mass));
        let inertia = self.inertia - moment_arm * moment_arm * self.mass;
        matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&inertia);
        matrix
    }

    /// The body with a point mass (kg, negative if removed) fixed at a point (platform frame, m); `None` if no mass
    /// remains.
    #[must_use]
    pub fn with_point_mass(&self, added: f64, place: &Vector3<f64>) -> Option<Self> {
        let mass = self.mass + added;
        if !(mass > 0.0 && mass.is_finite()) {
            return None;
        }
        let center_of_mass = (self.center_of_mass * self.mass + place * added) / mass;
        // parallel axes: −m [d]×[d]× of either part about the new centre
        let about = |part: f64, from: &Vector3<f64>| {
            let arm = (from - center_of_mass).cross_matrix();
            -arm * arm * part
        };
        let inertia = self.inertia + about(self.mass, &self.center_of_mass) + about(added, place);
        Some(Self { mass, center_of_mass, inertia })
    }
}
