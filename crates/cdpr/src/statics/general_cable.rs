//! What one cable whose law has no closed form pulls and how long it is, with the derivatives by pose, tension and parameters.

use nalgebra::{Matrix3, Matrix6, Vector3};

use super::error::StaticsError;
use super::holding::{Held, held};
use crate::cable::law::{Hold, Known, LawChange, LawParameter, outlet_change};
use crate::geometry::{Pose, Twist, Wrench};
use crate::model::{Model, Parameter, ParameterKind};

/// A cable at rest at a pose with a tension.
pub(crate) struct GeneralCable<'a> {
    model: &'a Model,
    cable: usize,
    held: Held,
    /// p_B (world, m).
    anchor: [f64; 3],
    tension_scale: f64,
    length_scale: f64,
    /// Tension (N).
    pub(crate) tension: f64,
}

impl<'a> GeneralCable<'a> {
    /// With a tension where the robot measures it (N).
    pub(crate) fn at(model: &'a Model, cable: usize, pose: &Pose, tension: f64) -> Result<Self, StaticsError> {
        Ok(Self::of(model, cable, pose, held(model, pose, cable, tension)?, tension))
    }

    /// With a tension at the outlet (N), as forward problems give it; what is called tension is this one then.
    pub(crate) fn at_outlet(model: &'a Model, cable: usize, pose: &Pose, tension: f64) -> Result<Self, StaticsError> {
        let hold = model.hold(cable, pose, Known::OutletTension(tension));
        let (hold, lever) = hold.map_err(|reason| StaticsError::Hold { cable: cable + 1, reason })?;
        Ok(Self::of(model, cable, pose, Held { hold, lever, is_known_at_platform: false }, tension))
    }

    fn of(model: &'a Model, cable: usize, pose: &Pose, held: Held, tension: f64) -> Self {
        let data = &model.robot().cables[cable];
        let (tension_scale, length_scale) = (data.tension_scale.unwrap_or(1.0), data.length_scale.unwrap_or(1.0));
        let anchor = (pose.position + held.lever).into();
        Self { model, cable, held, anchor, tension_scale, length_scale, tension }
    }

    fn hold(&self) -> &Hold {
        &self.held.hold
    }

    /// q_θ (m).
    pub(crate) fn controlled_length(&self) -> f64 {
        self.hold().controlled_length
    }

    /// Wrench on the platform.
    pub(crate) fn wrench(&self) -> Wrench {
        self.held.wrench()
    }

    /// Change of wrench and recorded length by the recorded tension.
    pub(crate) fn by_recorded_tension(&self) -> (Wrench, f64) {
        self.by_tension(1.0 / self.tension_scale)
    }

    /// Change of wrench and recorded length with a change of the tension where it is measured.
    pub(crate) fn by_tension(&self, change: f64) -> (Wrench, f64) {
        let hold = self.hold();
        let at_outlet = match self.held.is_known_at_platform {
            true => 1.0 / crate::scalar::dot(hold.direction, hold.by_tension),
            false => 1.0,
        };
        let length = self.length_scale * hold.controlled_length_by_tension * at_outlet * change;
        (self.held.wrench_by_tension() * change, length)
    }

    /// A change at fixed outlet tension, brought to fixed tension where it is measured: pull and recorded length.
    fn measured(&self, change: LawChange) -> (Vector3<f64>, f64) {
        let hold = self.hold();
        let more = if self.held.is_known_at_platform { outlet_change(hold, change.pull) } else { 0.0 };
        let pull = Vector3::from(change.pull) + Vector3::from(hold.by_tension) * more;
        (pull, self.length_scale * (change.controlled_length + hold.controlled_length_by_tension * more))
    }

    /// Change with the platform anchor along a direction (world), as [`Self::measured`].
    fn by_anchor(&self, direction: &Vector3<f64>) -> (Vector3<f64>, f64) {
        let hold = self.hold();
        let tangent = Matrix3::from_fn(|row, column| {
            hold.tangent[row][column] + hold.by_controlled_length[row] * hold.controlled_length_by_anchor[column]
        });
        let length = Vector3::from(hold.controlled_length_by_anchor).dot(direction);
        self.measured(LawChange { pull: (tangent * direction).into(), controlled_length: length })
    }

    /// Change of the recorded length along a twist of the platform.
    pub(crate) fn length_by_twist(&self, twist: &Twist) -> f64 {
        let (v, turn) = (twist.fixed_rows::<3>(0), Vector3::new(twist[3], twist[4], twist[5]));
        self.by_anchor(&(v + turn.cross(&self.held.lever))).1
    }

    /// Change of the wrench by \[δr; δφ\].
    pub(crate) fn wrench_by_pose(&self) -> Matrix6<f64> {
        let lever = self.held.lever;
        let pull = Vector3::from(self.hold().pull);
        let mut matrix = Matrix6::zeros();
        for k in 0..6 {
            let turn = if k < 3 { Vector3::zeros() } else { Vector3::ith(k - 3, 1.0).cross(&lever) };
            let shift = if k < 3 { Vector3::ith(k, 1.0) } else { turn };
            let change = self.by_anchor(&shift).0;
            matrix.set_column(k, &stacked(change, turn.cross(&pull) + lever.cross(&change)));
        }
        matrix
    }

    /// Change of the wrench (world) and of the length row by one of the cable's parameters.
    pub(crate) fn by(&self, parameter: &Parameter, rotation: &Matrix3<f64>) -> (Wrench, f64) {
        let lever = self.held.lever;
        let law = |kind: LawParameter| {
            let change = self.model.law(self.cable).by_parameter(self.hold(), self.anchor, kind);
            let (pull, length) = self.measured(change);
            (stacked(pull, lever.cross(&pull)), length)
        };
        match parameter.kind {
            ParameterKind::FrameAnchor => {
                // moving the frame anchor is moving the platform anchor the other way
                let (pull, length) = self.by_anchor(&-self.model.axes()[parameter.axis]);
                (stacked(pull, lever.cross(&pull)), length)
            }
            ParameterKind::PlatformAnchor => {
                let axis = rotation * self.model.axes()[parameter.axis];
                let (pull, length) = self.by_anchor(&axis);
                (stacked(pull, axis.cross(&Vector3::from(self.hold().pull)) + lever.cross(&pull)), length)
            }
            ParameterKind::PulleyRadius => law(LawParameter::PulleyRadius),
            ParameterKind::Compliance => law(LawParameter::Compliance),
            ParameterKind::HiddenLength => law(LawParameter::HiddenLength),
            ParameterKind::LengthOffset => (Wrench::zeros(), 1.0),
            ParameterKind::LengthScale => (Wrench::zeros(), self.controlled_length()),
            ParameterKind::TensionScale => self.by_tension(-self.tension / self.tension_scale),
            ParameterKind::TensionOffset => self.by_tension(-1.0 / self.tension_scale),
            _ => (Wrench::zeros(), 0.0),
        }
    }
}

fn stacked(force: Vector3<f64>, moment: Vector3<f64>) -> Wrench {
    Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
}
