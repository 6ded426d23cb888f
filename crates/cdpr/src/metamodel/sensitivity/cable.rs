//! One cable of any law at rest, with its derivatives.

use nalgebra::{Matrix3, Matrix6};

use crate::cable::elasticity::Elasticity;
use crate::geometry::{Pose, Twist, Wrench};
use crate::model::{Model, Parameter};
use crate::statics::{GeneralCable, StaticsError, StraightCable};

/// A cable at a pose with a tension: what it pulls and which recorded length it has.
pub(super) enum CableState<'a> {
    /// Straight, of linear law; with its model for the axes.
    Straight(Box<StraightCable>, &'a Model),
    /// Any other.
    General(Box<GeneralCable<'a>>),
}

/// A spring of 1 N/m: least squares of lengths are the equilibrium of such springs, which may push (eq. 2.81).
const UNIT_SPRING: Elasticity<f64> = Elasticity { by_length: 0.0, by_controlled_length: 0.0, constant: 1.0 };

impl<'a> CableState<'a> {
    /// With a tension at the outlet (N).
    pub(super) fn at(model: &'a Model, cable: usize, pose: &Pose, tension: f64) -> Result<Self, StaticsError> {
        if !model.composition().has_closed_form() {
            return Ok(Self::General(Box::new(GeneralCable::at_outlet(model, cable, pose, tension)?)));
        }
        Self::straight(model, cable, pose, tension)
    }

    /// With a tension where the robot measures it (N).
    pub(super) fn at_measured(model: &'a Model, cable: usize, pose: &Pose, tension: f64) -> Result<Self, StaticsError> {
        if !model.composition().has_closed_form() {
            return Ok(Self::General(Box::new(GeneralCable::at(model, cable, pose, tension)?)));
        }
        Self::straight(model, cable, pose, tension)
    }

    /// The straight cable between the same ends as a spring of 1 N/m with this tension, of any sign (N).
    pub(super) fn unit_spring(model: &'a Model, cable: usize, pose: &Pose, tension: f64) -> Result<Self, StaticsError> {
        model.course(cable, pose)?;
        let state = StraightCable::at(model, cable, pose.position.into(), &pose.rotation_rows(), tension);
        Ok(Self::Straight(Box::new(state.with_law(&UNIT_SPRING)), model))
    }

    fn straight(model: &'a Model, cable: usize, pose: &Pose, tension: f64) -> Result<Self, StaticsError> {
        model.course(cable, pose)?;
        let state = StraightCable::at(model, cable, pose.position.into(), &pose.rotation_rows(), tension);
        Ok(Self::Straight(Box::new(state), model))
    }

    /// What it pulls (world).
    pub(super) fn wrench(&self) -> Wrench {
        match self {
            Self::Straight(cable, _) => cable.column() * cable.tension,
            Self::General(cable) => cable.wrench(),
        }
    }

    /// ∂(wrench)/∂\[δr; δφ\] at fixed tension.
    pub(super) fn wrench_by_pose(&self) -> Matrix6<f64> {
        match self {
            Self::Straight(cable, _) => cable.column_by_pose() * cable.tension,
            Self::General(cable) => cable.wrench_by_pose(),
        }
    }

    /// Change of wrench and recorded length per newton of tension.
    pub(super) fn by_tension(&self) -> (Wrench, f64) {
        match self {
            Self::Straight(cable, _) => cable.by_tension(1.0),
            Self::General(cable) => cable.by_tension(1.0),
        }
    }

    /// Change of the recorded length along a twist, at fixed tension.
    pub(super) fn length_by_twist(&self, twist: &Twist) -> f64 {
        match self {
            Self::Straight(cable, _) => -cable.length_scale * cable.controlled.by_length * twist.dot(&cable.column()),
            Self::General(cable) => cable.length_by_twist(twist),
        }
    }

    /// Change of wrench and recorded length by a parameter of the cable, at fixed tension.
    pub(super) fn by(&self, parameter: &Parameter, rotation: &Matrix3<f64>) -> (Wrench, f64) {
        match self {
            Self::Straight(cable, model) => cable.by(parameter, model, rotation),
            Self::General(cable) => cable.by(parameter, rotation),
        }
    }
}
