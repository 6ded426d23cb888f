//! Names of parameters that may be free, and errors about lists of them, with what was meant.

use thiserror::Error;

use super::ShiftCourse;
use crate::robot::ParameterKind;

/// Parameter of a recording, not of its robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RecordingParameter {
    /// Offset of the clocks of winches and tracker (s).
    ClockOffset,
    /// Pose of the tracker's world in the robot's frame.
    TrackerFrame,
    /// Pose of the tracked marker on the platform.
    MarkerFrame,
}

impl RecordingParameter {
    /// All parameters of a recording.
    pub const ALL: [Self; 3] = [Self::ClockOffset, Self::TrackerFrame, Self::MarkerFrame];
    /// Parameters that turn measured poses into poses of the platform.
    pub const FRAMES: [Self; 2] = [Self::TrackerFrame, Self::MarkerFrame];

    /// Name in lists of parameters.
    pub fn name(self) -> &'static str {
        match self {
            Self::ClockOffset => "clock-offset",
            Self::TrackerFrame => "tracker-frame",
            Self::MarkerFrame => "marker-frame",
        }
    }
}

/// Names of all parameters that may be free.
pub(super) fn known_names() -> impl Iterator<Item = &'static str> {
    let of_recording = RecordingParameter::ALL.into_iter().map(RecordingParameter::name);
    let of_record = of_recording.chain(ShiftCourse::NAMES);
    of_record.chain(ParameterKind::IDENTIFIED.into_iter().map(ParameterKind::name))
}

/// A list of parameters that cannot be read or does not fit the model.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ParameterError {
    /// An unknown name.
    #[error("`{name}` is not a parameter; known are {}{}", known_names().collect::<Vec<_>>().join(", "), suggestion(.name))]
    UnknownName {
        /// The word found.
        name: String,
    },
    /// Text around the brackets that cannot be read.
    #[error(
        "cannot read `{item}`: write NAME or NAME[1,3], separated by commas, cables counted from 1; `length-offset@52` is a step from line 52 on"
    )]
    Syntax {
        /// The item.
        item: String,
    },
    /// A cable the robot does not have.
    #[error("`{kind}[{cable}]`: the robot has cables 1 to {cable_count}")]
    NoSuchCable {
        /// Name of the parameter.
        kind: ParameterKind,
        /// The number given, from 1.
        cable: usize,
        /// Number of cables.
        cable_count: usize,
    },
    /// A parameter of an effect that the model does not have.
    #[error("`{kind}` is free, but the model is `{model}`; choose a model with the effect `{effect}`")]
    NotInModel {
        /// The parameter.
        kind: ParameterKind,
        /// The model's composition.
        model: String,
        /// The effect to which it belongs.
        effect: &'static str,
    },
    /// Two parameters with the same effect on the recorded lengths of a cable.
    #[error(
        "`start-length[{cable}]` and `length-offset[{cable}]` are both free, but they shift the recorded lengths of cable {cable} alike, \
         so that no data tell them apart: free one of them"
    )]
    StartLengthTwice {
        /// Number of the cable, from 1.
        cable: usize,
    },
    /// A cable whose law has no specific compliance.
    #[error(
        "`{kind}[{cable}]` is free, but cable {cable} has a constant spring (`spring_constant_N_per_m`), which has no {kind}; state `axial_stiffness_EA_N` instead, or restrict the list to other cables"
    )]
    ConstantSpring {
        /// The parameter.
        kind: ParameterKind,
        /// Number of the cable, from 1.
        cable: usize,
    },
    /// The axis of a guided drum, which has no effect on lengths.
    #[error(
        "`drum-axis[{cable}]` is free, but the guide of cable {cable} travels with the contact point (`drum_guided`), so that no length tells \
         where the drum's axis points: restrict the list to other cables, or leave `drum-axis` out"
    )]
    GuidedDrum {
        /// Number of the cable, from 1.
        cable: usize,
    },
    /// A parameter of the load with cables in brackets.
    #[error("`{kind}` belongs to the platform, not to single cables: write it without brackets")]
    LoadOfCable {
        /// The parameter.
        kind: ParameterKind,
    },
    /// A parameter of the load that moves nothing.
    #[error("`{kind}` is free, but {reason}")]
    NoEffect {
        /// The parameter.
        kind: ParameterKind,
        /// Why, and what to do.
        reason: &'static str,
    },
}

/// Names that a word probably meant, as the end of a sentence: those that hold it, or the closest.
fn suggestion(name: &str) -> String {
    let stem = name.strip_suffix('s').unwrap_or(name);
    let holding: Vec<String> = known_names()
        .filter(|known| stem.len() > 3 && known.contains(stem))
        .map(|known| format!("`{known}`"))
        .collect();
    if !holding.is_empty() {
        return format!("; did you mean {}?", holding.join(" or "));
    }
    let close = |known: &&str| strsim::jaro_winkler(known, name);
    match known_names().max_by(|a, b| close(a).total_cmp(&close(b))) {
        Some(known) if close(&known) > 0.75 => format!("; did you mean `{known}`?"),
        _ => String::new(),
    }
}
