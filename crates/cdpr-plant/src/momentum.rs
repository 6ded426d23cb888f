//! The platform as a free rigid body: momentum, twist, and its motion without forces.

use nalgebra::{Matrix3, Matrix6, Quaternion, UnitQuaternion, Vector3};

use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::model::Model;
use cdpr_model::robot::Body;

/// Largest turn of one piece of a drift (rad): the error of a piece, of fifth order, stays below rounding.
const PIECE: f64 = 5e-3;

/// Largest turn within a step (rad): beyond it the forces of a step belong to unrelated orientations.
pub(super) const LARGEST_TURN: f64 = 1.0;

/// Momentum of a platform: linear, and angular about its centre of mass (world axes; kg·m/s, kg·m²/s). Without forces
/// both keep their bits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Momentum {
    /// p = m v_c.
    pub(super) linear: Vector3<f64>,
    /// L = R I_c Rᵀ ω.
    pub(super) angular: Vector3<f64>,
}

/// Inertia of a body, with the directions in which its motion pattern moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia {
    /// Mass properties.
    pub body: Body,
    /// I_c⁻¹ about the directions about which the pattern turns, 0 about others (platform axes).
    inverse_inertia: Matrix3<f64>,
    /// D_lin (N·s/m) and D_rot (N·m·s/rad).
    damping: [f64; 2],
    /// Projection onto the directions in which the pattern moves (world).
    translations: Matrix3<f64>,
    /// Projection onto the directions about which it turns (world).
    rotations: Matrix3<f64>,
}

impl Inertia {
    /// The body on a model's motion pattern.
    pub fn new(model: &Model, body: Body) -> Self {
        let (mut translations, mut rotations) = (Matrix3::zeros(), Matrix3::zeros());
        for twist in model.twist_basis() {
            let (v, omega) = (twist.fixed_rows::<3>(0), twist.fixed_rows::<3>(3));
            translations += v * v.transpose();
            rotations += omega * omega.transpose();
        }
        let robot = model.robot();
        let inverse_inertia = match (robot.motion_pattern.has_rotation(), robot.motion_pattern.is_planar()) {
            (false, _) => Matrix3::zeros(),
            (true, true) => {
                let normal = robot.plane.normal();
                normal * normal.transpose() / normal.dot(&(body.inertia * normal))
            }
            (true, false) => body.inertia.try_inverse().unwrap_or_else(|| Matrix3::repeat(f64::NAN)),
        };
        let damping = [robot.platform.damping, robot.platform.rotational_damping].map(|d| d.unwrap_or(0.0));
        Self { body, inverse_inertia, damping, translations, rotations }
    }

    /// Damping wrench for a twist of the platform origin, −\[D_lin v; D_rot ω\] (world axes).
    #[inline]
    pub(super) fn drag(&self, twist: &Twist) -> Wrench {
        let [along, about] = self.damping;
        Wrench::from_fn(|row, _| if row < 3 { -along * twist[row] } else { -about * twist[row] })
    }

    /// True if the platform itself is damped.
    pub(super) fn is_damped(&self) -> bool {
        self.damping != [0.0; 2]
    }

    /// s = R c, from the platform origin to the centre of mass (world, m).
    pub(super) fn center(&self, pose: &Pose) -> Vector3<f64> {
        pose.rotation * self.body.center_of_mass
    }

    /// Angular velocity ω (world, rad/s).
    #[inline]
    pub(super) fn angular_velocity(&self, rotation: &UnitQuaternion<f64>, angular: &Vector3<f64>) -> Vector3<f64> {
        rotation * (self.inverse_inertia * (rotation.inverse() * angular))
    }

    /// R I_c⁻¹ Rᵀ, 0 about directions about which the pattern does not turn (world axes).
    #[inline]
    pub(super) fn inverse_inertia_at(&self, pose: &Pose) -> Matrix3<f64> {
        let rotation = pose.rotation_matrix();
        rotation * self.inverse_inertia * rotation.transpose()
    }

    /// Twist \[v; ω\] of the platform origin (world axes).
    #[inline]
    pub(super) fn twist(&self, pose: &Pose, momentum: &Momentum) -> Twist {
        let omega = self.angular_velocity(&pose.rotation, &momentum.angular);
        let v = momentum.linear / self.body.mass - omega.cross(&self.center(pose));
        Twist::new(v.x, v.y, v.z, omega.x, omega.y, omega.z)
    }

    /// Momentum of a twist, projected onto the motion pattern.
    pub(super) fn momentum(&self, pose: &Pose, twist: &Twist) -> Momentum {
        let omega = self.rotations * twist.fixed_rows::<3>(3);
        let v = self.translations * (twist.fixed_rows::<3>(0) + omega.cross(&self.center(pose)));
        let turned = pose.rotation * (self.body.inertia * (pose.rotation.inverse() * omega));
        Momentum { linear: v * self.body.mass, angular: self.rotations * turned }
    }

    /// Rate of the momentum under a wrench about the platform origin (world axes; N, N·m).
    #[inline]
    pub(super) fn rate(&self, center: &Vector3<f64>, wrench: &Wrench) -> Momentum {
        let force: Vector3<f64> = wrench.fixed_rows::<3>(0).into();
        let moment: Vector3<f64> = wrench.fixed_rows::<3>(3).into();
        Momentum { linear: self.translations * force, angular: self.rotations * (moment - center.cross(&force)) }
    }

    /// Mass matrix M(x) about the platform origin in world axes, 6 × 6.
    pub(super) fn mass_matrix(&self, pose: &Pose) -> Matrix6<f64> {
        let rotation = pose.rotation_matrix();
        let mut turn = Matrix6::zeros();
        turn.fixed_view_mut::<3, 3>(0, 0).copy_from(&rotation);
        turn.fixed_view_mut::<3, 3>(3, 3).copy_from(&rotation);
        turn * self.body.mass_matrix() * turn.transpose()
    }

    /// Pose after a time without forces (s): the centre of mass moves straight, the angular momentum is constant. The
    /// error is the turn (rad) if it is above [`LARGEST_TURN`].
    #[inline]
    pub(super) fn drift(&self, pose: &Pose, momentum: &Momentum, time: f64) -> Result<Pose, f64> {
        let from = pose.position + self.center(pose) + momentum.linear * (time / self.body.mass);
        let rotation = self.turned(&pose.rotation, &momentum.angular, time)?;
        Ok(Pose { position: from - rotation * self.body.center_of_mass, rotation })
    }

    /// Orientation of a free body after a time (s); the error is the turn (rad) if it is above [`LARGEST_TURN`].
    #[inline]
    fn turned(
        &self,
        rotation: &UnitQuaternion<f64>,
        angular: &Vector3<f64>,
        time: f64,
    ) -> Result<UnitQuaternion<f64>, f64> {
        if *angular == Vector3::zeros() {
            return Ok(*rotation);
        }
        let body = rotation.inverse() * angular;
        let omega = self.inverse_inertia * body;
        let turn = omega.norm() * time.abs();
        let pieces = (turn / PIECE).ceil();
        if pieces <= 1.0 {
            return Ok(turned_by(rotation, &self.rotation_vector(&body, &omega, time)));
        }
        if turn > LARGEST_TURN {
            return Err(turn);
        }
        let mut turned = *rotation;
        for _ in 0..pieces as u32 {
            let body = turned.inverse() * angular;
            let theta = self.rotation_vector(&body, &(self.inverse_inertia * body), time / pieces);
            turned = turned_by(&turned, &theta);
        }
        Ok(turned)
    }

    /// θ of R exp(θ) after a time: the solution of θ′ = Ω + ½ θ × Ω + ¹⁄₁₂ θ × (θ × Ω) with Λ′ = Λ × Ω, Λ = I Ω
    /// (platform axes), by its series θ = t Ω + ½ t² Ω′ + t³ (Ω″/6 + Ω × Ω′/12) + t⁴ (Ω‴ + Ω × Ω″)/24 + O(t⁵).
    #[inline]
    fn rotation_vector(&self, body: &Vector3<f64>, omega: &Vector3<f64>, time: f64) -> Vector3<f64> {
        let of = |momentum: &Vector3<f64>| self.inverse_inertia * momentum;
        let body_1 = body.cross(omega);
        let omega_1 = of(&body_1);
        let body_2 = body_1.cross(omega) + body.cross(&omega_1);
        let omega_2 = of(&body_2);
        let omega_3 = of(&(body_2.cross(omega) + body_1.cross(&omega_1) * 2.0 + body.cross(&omega_2)));
        let third = omega_2 / 6.0 + omega.cross(&omega_1) / 12.0;
        let fourth = (omega_3 + omega.cross(&omega_2)) / 24.0;
        (omega + (omega_1 * 0.5 + (third + fourth * time) * time) * time) * time
    }
}

/// R exp(θ) for a rotation vector of at most one piece (platform axes, rad); the series give its sine and cosine to
/// rounding.
#[inline]
fn turned_by(rotation: &UnitQuaternion<f64>, theta: &Vector3<f64>) -> UnitQuaternion<f64> {
    let square = theta.norm_squared() / 4.0;
    let cosine = 1.0 - square * (0.5 - square * (1.0 / 24.0 - square / 720.0));
    let sine = 0.5 * (1.0 - square * (1.0 / 6.0 - square * (1.0 / 120.0 - square / 5040.0)));
    let turned = rotation.quaternion() * Quaternion::from_parts(cosine, theta * sine);
    // one Newton step towards the norm 1, which only rounding has changed
    UnitQuaternion::new_unchecked(turned * (1.5 - 0.5 * turned.norm_squared()))
}
