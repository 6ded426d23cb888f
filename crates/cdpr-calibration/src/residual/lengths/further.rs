//! Parameters of a cable beyond those of the kernels: pitch, start angle and build-up of its drum, turns of the axes of drum and pulley.
//!
//! Few fits free them. Their values and columns stand behind those of the kernels, which know nothing of them.

use nalgebra::Vector3;

use cdpr_model::cable::outlet::Outlet;
use cdpr_model::model::Model;
use cdpr_model::robot::{Axis, Cable, Parameter, ParameterKind};
use cdpr_model::scalar::cross;

/// Number of these parameters.
pub(crate) const FURTHER: usize = 7;

/// Their places.
pub(crate) const PITCH: usize = 0;
pub(crate) const START_ANGLE: usize = 1;
pub(crate) const DRUM_TURN: usize = 2;
pub(crate) const SWIVEL_TURN: usize = 4;
pub(crate) const BUILD_UP: usize = 6;

/// Place of a parameter; `None` for one of the kernels.
pub(crate) fn further_place(parameter: &Parameter) -> Option<usize> {
    match parameter.kind {
        ParameterKind::DrumPitch => Some(PITCH),
        ParameterKind::StartAngle => Some(START_ANGLE),
        ParameterKind::DrumAxis => Some(DRUM_TURN + parameter.axis),
        ParameterKind::SpoolBuildUp => Some(BUILD_UP),
        ParameterKind::SwivelAxis => Some(SWIVEL_TURN + parameter.axis),
        _ => None,
    }
}

/// Values of a cable (0-based) in a model.
pub(crate) fn further_values(model: &Model, cable: usize) -> [f64; FURTHER] {
    let robot = model.robot();
    let winch = &robot.cables[cable].winch;
    let has_axis = |kind: ParameterKind| match kind {
        ParameterKind::SwivelAxis => robot.cables[cable].pulley_swivel_axis().is_some(),
        _ => winch.axis.is_some(),
    };
    let turn = |kind: ParameterKind, axis| match has_axis(kind) && axis < kind.components(robot) {
        true => Parameter { cable, kind, axis }.value(robot),
        false => 0.0,
    };
    [
        winch.pitch().unwrap_or(0.0),
        winch.start_angle.unwrap_or(0.0),
        turn(ParameterKind::DrumAxis, 0),
        turn(ParameterKind::DrumAxis, 1),
        turn(ParameterKind::SwivelAxis, 0),
        turn(ParameterKind::SwivelAxis, 1),
        winch.build_up.unwrap_or(0.0),
    ]
}

/// An axis with the directions about which a robot turns it.
#[derive(Clone, Debug)]
pub(crate) struct Turned {
    axis: Axis,
    about: Vec<Vector3<f64>>,
}

impl Turned {
    /// The axis of a cable (0-based) that turns of a kind belong to; `None` where the robot has none.
    pub(crate) fn of(model: &Model, cable: usize, kind: ParameterKind) -> Option<Self> {
        let robot = model.robot();
        let turned = |axis| Parameter { cable, kind, axis }.turned_axis(robot);
        let all: Vec<(Axis, Vector3<f64>)> = (0..kind.components(robot)).map_while(turned).collect();
        let axis = all.first()?.0;
        Some(Self { axis, about: all.into_iter().map(|(_, about)| about).collect() })
    }

    /// The axis after other turns (rad).
    fn at(&self, turns: &[f64]) -> Axis {
        let mut axis = self.axis;
        self.about.iter().zip(turns).for_each(|(about, &turn)| axis.set_turn_about(about, turn));
        axis
    }

    /// Change of the axis by one of its turns, after these turns (rad).
    pub(crate) fn by_turn(&self, turns: &[f64], index: usize) -> Vector3<f64> {
        self.at(turns).by_turn_about(&self.about[index])
    }

    /// The same as a rotation vector.
    pub(crate) fn rotation_by_turn(&self, turns: &[f64], index: usize) -> Vector3<f64> {
        self.at(turns).rotation_by_turn_about(&self.about[index])
    }
}

/// Gives the drum of a cable these values.
pub(crate) fn set_drum(cable: &mut Cable, values: &[f64; FURTHER], axis: Option<&Turned>) {
    cable.winch.set_pitch(values[PITCH]);
    cable.winch.start_angle = Some(values[START_ANGLE]);
    cable.winch.build_up = Some(values[BUILD_UP]);
    if let Some(turned) = axis {
        cable.winch.axis = Some(turned.at(&values[DRUM_TURN..SWIVEL_TURN]));
    }
}

/// Axes of a cable, as far as a turn of them is free.
pub(crate) struct Turns {
    pub(crate) drum: Option<Turned>,
    pub(crate) swivel: Option<Turned>,
}

impl Turns {
    pub(crate) fn of(model: &Model, cable: usize, parameters: &[Parameter]) -> Self {
        let turned = |kind| {
            let is_free = parameters.iter().any(|parameter| parameter.kind == kind);
            is_free.then(|| Turned::of(model, cable, kind)).flatten()
        };
        Self { drum: turned(ParameterKind::DrumAxis), swivel: turned(ParameterKind::SwivelAxis) }
    }

    /// Turns the pulley as the values say.
    #[inline]
    pub(crate) fn turn_pulley(&self, outlet: &mut Outlet<f64>, values: &[f64; FURTHER]) {
        let Some(swivel) = &self.swivel else { return };
        let turned = swivel.at(&values[SWIVEL_TURN..BUILD_UP]);
        match outlet {
            Outlet::Point { .. } => {}
            Outlet::Swivel { swivel_axis, .. } => *swivel_axis = (*turned).into(),
            Outlet::Sided { swivel_axis, side, .. } => {
                // the side turns with the axis about their common normal
                let across = cross(*swivel_axis, *side);
                *swivel_axis = (*turned).into();
                *side = cross(across, *swivel_axis);
            }
        }
    }
}
