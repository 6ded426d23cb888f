//! Angle that an encoder at a pulley's swivel measures, with its derivatives.

use std::f64::consts::{PI, TAU};

use nalgebra::{Matrix3, Vector3};

use cdpr_model::cable::outlet::pulley::swivel_angle;
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, ParameterKind};

/// Part of gravity across a swivel axis that still tells a direction.
const LEAST_PART: f64 = 1e-6;

/// Swivel angle s of one cable's pulley, right-handed about the swivel axis z_A from gravity's part across it.
pub(crate) struct Swivel {
    /// s as recorded, with the zero of its encoder (rad).
    pub(super) angle: f64,
    /// z_A × x_A over the distance of the platform anchor from the axis: ∂s by the platform anchor (world, 1/m).
    by_anchor: Vector3<f64>,
    /// ∂s by the swivel axis itself, of motions across it.
    by_axis: Vector3<f64>,
    /// R b (world, m).
    arm: Vector3<f64>,
    rotation: Matrix3<f64>,
}

impl Swivel {
    /// True where a cable (0-based) has a swivel axis, and gravity a part across it.
    pub(crate) fn has_zero(model: &Model, cable: usize) -> bool {
        let robot = model.robot();
        let axis = robot.cables[cable].swivel_axis();
        axis.zip(robot.gravity).is_some_and(|(axis, gravity)| axis.cross(&gravity).norm() > LEAST_PART * gravity.norm())
    }

    /// Recorded angle of a cable (0-based) at a pose (rad); `None` as [`Swivel::of`].
    pub(crate) fn angle_at(model: &Model, cable: usize, pose: &Pose) -> Option<f64> {
        Self::of(model, cable, pose).map(|swivel| swivel.angle)
    }

    /// Angle of a cable (0-based) at a pose; `None` without swivel axis and gravity, and where one of them or the platform anchor lies along the axis.
    pub(super) fn of(model: &Model, cable: usize, pose: &Pose) -> Option<Self> {
        let (robot, rotation) = (model.robot(), pose.rotation_matrix());
        let own = &robot.cables[cable];
        let (axis, gravity) = (*own.swivel_axis()?, robot.gravity?);
        let arm = rotation * own.platform_anchor;
        let anchor = pose.position + arm;
        let angle = swivel_angle(own.frame_anchor.into(), axis.into(), gravity.into(), anchor.into())?;
        // d and gravity across the axis, with their sizes along it
        let across = |vector: Vector3<f64>| vector - axis * axis.dot(&vector);
        let lateral = |vector: Vector3<f64>| axis.cross(&vector) / vector.norm_squared();
        let d = anchor - own.frame_anchor;
        let (by_anchor, by_gravity) = (lateral(across(d)), lateral(across(gravity)));
        // a tilt of the axis moves what lies along it across
        let by_axis = by_gravity * axis.dot(&gravity) - by_anchor * axis.dot(&d);
        let angle = angle + own.swivel_offset.unwrap_or(0.0);
        Some(Self { angle, by_anchor, by_axis, arm, rotation })
    }

    /// Modelled minus recorded angle, in (−π, π] (rad).
    pub(super) fn minus(&self, recorded: f64) -> f64 {
        PI - (PI - (self.angle - recorded)).rem_euclid(TAU)
    }

    pub(super) fn by_twist(&self, twist: &Twist) -> f64 {
        let turned = twist.fixed_rows::<3>(3).cross(&self.arm);
        self.by_anchor.dot(&(twist.fixed_rows::<3>(0) + turned))
    }

    /// Derivative by a parameter of its own cable.
    pub(super) fn by_parameter(&self, model: &Model, parameter: &Parameter) -> f64 {
        match parameter.kind {
            ParameterKind::FrameAnchor => -self.by_anchor.dot(&model.axes()[parameter.axis]),
            ParameterKind::PlatformAnchor => self.by_anchor.dot(&(self.rotation * model.axes()[parameter.axis])),
            ParameterKind::SwivelAxis => parameter
                .turned_axis(model.robot())
                .map_or(0.0, |(axis, about)| self.by_axis.dot(&axis.by_turn_about(&about))),
            ParameterKind::SwivelOffset => 1.0,
            _ => 0.0,
        }
    }
}
