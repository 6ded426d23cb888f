//! Partly measured poses in the frames of a tracker: the free components of the frames, and their start values.

use crate::fit::{InputError, Settings, check_recording, start_by_positions};
use cdpr_model::measurement::InternalSamples;
use cdpr_model::model::{FreeParameters, Model, RecordingParameter};
use cdpr_model::robot::{Component, Parameter, ParameterKind, TrackedFrames};

/// Parts of poses that a record has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Measured {
    positions: bool,
    orientations: bool,
}

impl Measured {
    fn of(model: &Model, internal: &InternalSamples) -> Self {
        let translations = model.robot().motion_pattern.translations();
        let any = |is_own: &dyn Fn(usize) -> bool| {
            internal.known.iter().any(|known| known.iter().enumerate().any(|(place, known)| *known && is_own(place)))
        };
        Self { positions: any(&|place| place < translations), orientations: any(&|place| place >= translations) }
    }

    /// True where it depends on a component of a frame: origins show in positions, the turn of the tracker's world in both.
    fn shows(self, kind: ParameterKind, component: &Component) -> bool {
        match component {
            Component::Shift(_) => self.positions,
            Component::Turn(_) => self.orientations || self.positions && kind == ParameterKind::TrackerFrame,
        }
    }
}

/// Returns the frames that are free and not held; an error if the record has no component of a pose.
pub(super) fn freed_frames(
    model: &Model,
    internal: &InternalSamples,
    free: &FreeParameters,
    settings: &Settings,
) -> Result<Vec<RecordingParameter>, InputError> {
    let is_free = |frame: &RecordingParameter| free.names_recording(*frame) && !settings.hold.names_recording(*frame);
    let freed: Vec<RecordingParameter> = RecordingParameter::FRAMES.into_iter().filter(is_free).collect();
    check_recording(&free.without_recording(&RecordingParameter::FRAMES), settings)?;
    let (Some(first), measured) = (freed.first(), Measured::of(model, internal)) else { return Ok(freed) };
    if !(measured.positions || measured.orientations) {
        return Err(InputError::FramesOfNothing { name: first.name() });
    }
    if freed.contains(&RecordingParameter::MarkerFrame) && !model.robot().motion_pattern.has_rotation() {
        return Err(InputError::MarkerOfPoint);
    }
    Ok(freed)
}

/// The model with frames that searches begin from: in closed form by positions and the poses that lengths give, where these are enough of them.
pub(super) fn with_frames(
    model: &Model,
    internal: &InternalSamples,
    freed: &[RecordingParameter],
) -> Result<Model, InputError> {
    if freed.is_empty() {
        return Ok(model.clone());
    }
    let samples = model.with_lengths(&internal.samples).map_err(InputError::Winch)?;
    let frames = match Measured::of(model, internal).positions && !internal.are_changes {
        true => start_by_positions(model, &samples, freed),
        false => Ok(TrackedFrames::default()),
    };
    let frames = match frames {
        Err(InputError::NoFrames { .. }) => TrackedFrames::default(),
        frames => frames?,
    };
    let mut robot = model.robot().clone();
    robot.tracked = Some(frames);
    Ok(Model::new(robot, model.composition())?)
}

/// Components of free frames that the record shows.
pub(super) fn frame_parameters(
    model: &Model,
    internal: &InternalSamples,
    freed: &[RecordingParameter],
) -> Vec<Parameter> {
    let (robot, measured) = (model.robot(), Measured::of(model, internal));
    let kind = |frame: &RecordingParameter| match frame {
        RecordingParameter::MarkerFrame => ParameterKind::MarkerFrame,
        _ => ParameterKind::TrackerFrame,
    };
    let components = |kind: ParameterKind| {
        let is_shown = move |axis: &usize| robot.frame_component(*axis).is_some_and(|own| measured.shows(kind, &own));
        (0..kind.components(robot)).filter(is_shown).map(move |axis| Parameter { cable: 0, kind, axis })
    };
    freed.iter().map(kind).flat_map(components).collect()
}
