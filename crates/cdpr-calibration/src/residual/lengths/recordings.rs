//! Lengths recorded as motor angles, where identification changes the drums that tell them.

use super::further::{Turned, set_drum};
use super::pose_lanes::CableValues;
use cdpr_model::cable::winch::{DrumLength, Winch};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::{Cable, CableWinch, Parameter, ParameterKind};
use cdpr_model::scalar::LANES;

/// The recorded angles of one cable and the drum they belong to.
pub(crate) struct Recorder {
    /// The cable as the start values have it.
    cable: Cable,
    /// Motor angles, padded (rad).
    angles: Vec<f64>,
    /// Axis of the drum.
    axis: Option<Turned>,
    /// True where the model has no drums.
    is_ideal: bool,
}

/// Recorded lengths at some values of the parameters, with derivatives; padded.
pub(crate) struct Recordings {
    /// (m)
    pub(crate) lengths: Vec<f64>,
    /// By the drum's radius.
    pub(crate) by_radius: Vec<f64>,
    /// By the frame anchor, where the drum's cable runs to it (world).
    pub(crate) by_anchor: [Vec<f64>; 3],
    /// All derivatives by the drum.
    pub(crate) all: Vec<DrumLength>,
}

impl Recorder {
    /// `None` where lengths are recorded, or none of the parameters changes the drum or the place of its first pulley.
    pub(crate) fn of(model: &Model, cable: usize, parameters: &[Parameter], samples: &Samples) -> Option<Self> {
        let (data, is_ideal) = (&model.robot().cables[cable], !model.composition().drum);
        let changes = |parameter: &Parameter| match parameter.kind {
            ParameterKind::FrameAnchor if is_ideal => false,
            ParameterKind::FrameAnchor => data.winch.first_pulley.is_none() && data.winch.guided != Some(true),
            kind => kind.needs_motor_angles(),
        };
        let angles = samples.motor_angles.as_ref()?;
        if !parameters.iter().any(changes) {
            return None;
        }
        let mut angles: Vec<f64> = angles.iter().skip(cable).step_by(samples.cable_count).copied().collect();
        angles.resize(angles.len().next_multiple_of(LANES), angles.last().copied().unwrap_or(0.0));
        let axis = Turned::of(model, cable, ParameterKind::DrumAxis);
        Some(Self { cable: data.clone(), angles, axis, is_ideal })
    }

    /// Lengths at the recorded angles; not numbers where the values make no drum, or the groove ends.
    pub(crate) fn at(&self, values: &CableValues) -> Recordings {
        let mut cable = Cable {
            frame_anchor: (*values.outlet.frame_anchor()).into(),
            winch: CableWinch {
                radius: Some(values.drum_radius),
                start_length: Some(values.start_length),
                ..self.cable.winch
            },
            ..self.cable.clone()
        };
        set_drum(&mut cable, &values.further, self.axis.as_ref());
        let winch = if self.is_ideal { Winch::ideal(&cable) } else { Winch::of(&cable) };
        let winch = winch.and_then(Result::ok);
        let length = |winch: &Winch, angle: f64| winch.drum.gradient(angle / winch.gear_ratio).ok();
        let all: Vec<DrumLength> = self
            .angles
            .iter()
            .map(|&angle| winch.as_ref().and_then(|winch| length(winch, angle)).unwrap_or(DrumLength::NAN))
            .collect();
        let follows_anchor = self.cable.winch.first_pulley.is_none();
        let by_anchor =
            |axis: usize| all.iter().map(|length| if follows_anchor { length.by_pulley[axis] } else { 0.0 }).collect();
        Recordings {
            lengths: all.iter().map(|length| length.value).collect(),
            by_radius: all.iter().map(|length| length.by_radius).collect(),
            by_anchor: [by_anchor(0), by_anchor(1), by_anchor(2)],
            all,
        }
    }
}
