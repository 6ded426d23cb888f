//! The `--free` language: the parameters that identification may change.

mod plain_words;
#[cfg(test)]
mod tests;

use std::fmt;
use std::str::FromStr;

use super::length_shifts::FreeShift;
use super::parameter_names::known_names;
use super::{
    Composition, LengthShift, Model, ParameterError, RecordingParameter, ShiftCourse, SpanEffect, StretchEffect,
};
use crate::robot::{Head, Parameter, ParameterKind};

/// Selection of parameters, free or held: kinds, each for all cables or for some.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FreeParameters {
    /// Kind and 0-based cables; `None` means every cable.
    selections: Vec<(ParameterKind, Option<Vec<usize>>)>,
    /// True for those of [`RecordingParameter::ALL`] that are free.
    recording: [bool; RecordingParameter::ALL.len()],
    /// Free changes of recorded lengths inside a record.
    shifts: Vec<FreeShift>,
}

/// The kind with this name, if identification may free it; otherwise an error.
pub fn identified_kind(name: &str) -> Result<ParameterKind, ParameterError> {
    let kind = ParameterKind::IDENTIFIED.into_iter().find(|kind| kind.name() == name);
    kind.ok_or_else(|| ParameterError::UnknownName { name: name.to_owned() })
}

/// Name of the effect that a composition lacks for parameters of this kind; `None` if it lacks none.
pub fn missing_effect(kind: ParameterKind, composition: Composition) -> Option<&'static str> {
    match kind {
        ParameterKind::PulleyRadius | ParameterKind::SwivelAxis if !composition.pulley => Some("pulley"),
        kind if kind.needs_motor_angles() && !kind.is_of_ideal_winch() && !composition.drum => Some("drum"),
        ParameterKind::Compliance if composition.stretch != StretchEffect::Linear => Some("elastic"),
        ParameterKind::HiddenLength if !composition.is_elastic() => Some("elastic"),
        ParameterKind::LinearDensity if composition.span == SpanEffect::Straight => Some("catenary"),
        ParameterKind::Stretch(number) if composition.stretch != number.law().effect => Some(number.law().word),
        kind if kind.needs_elasticity() && !composition.needs_tensions() => Some("elastic"),
        _ => None,
    }
}

impl FreeParameters {
    /// Names of all parameters that may be free.
    pub fn known_names() -> impl Iterator<Item = &'static str> {
        known_names()
    }

    /// A selection of these kinds for every cable.
    pub fn of(kinds: &[ParameterKind]) -> Self {
        Self { selections: kinds.iter().map(|&kind| (kind, None)).collect(), ..Self::default() }
    }

    /// True if nothing is free.
    pub fn is_empty(&self) -> bool {
        self.selections.is_empty() && self.recorded().count() == 0 && self.shifts.is_empty()
    }

    /// True if no parameter of the robot is free.
    pub fn leaves_robot(&self) -> bool {
        self.selections.is_empty()
    }

    /// True if this parameter of the recording is free.
    pub fn names_recording(&self, parameter: RecordingParameter) -> bool {
        self.recorded().any(|free| free == parameter)
    }

    /// Free quantities of the recording.
    fn recorded(&self) -> impl Iterator<Item = RecordingParameter> {
        RecordingParameter::ALL
            .into_iter()
            .zip(self.recording)
            .filter_map(|(parameter, is_free)| is_free.then_some(parameter))
    }

    /// The selection without these parameters of the recording.
    pub fn without_recording(&self, parameters: &[RecordingParameter]) -> Self {
        let is_free = |own: RecordingParameter| self.names_recording(own) && !parameters.contains(&own);
        Self { recording: RecordingParameter::ALL.map(is_free), ..self.clone() }
    }

    /// The selection with these parameters of the recording.
    pub fn with_recording(&self, parameters: &[RecordingParameter]) -> Self {
        let is_free = |own: RecordingParameter| self.names_recording(own) || parameters.contains(&own);
        Self { recording: RecordingParameter::ALL.map(is_free), ..self.clone() }
    }

    /// Changes of recorded lengths that are free and not held, of a robot with so many cables, ordered by course and cable.
    pub fn length_shifts(&self, hold: &Self, cable_count: usize) -> Result<Vec<LengthShift>, ParameterError> {
        let all = self.shifts.iter().flat_map(|free| {
            let cables = free.cables.clone().unwrap_or_else(|| (0..cable_count).collect());
            cables.into_iter().map(|cable| LengthShift { cable, course: free.course })
        });
        let is_held = |shift: &LengthShift| hold.shifts.iter().any(|held| held.contains(*shift));
        let mut shifts: Vec<LengthShift> = Vec::new();
        for shift in all.filter(|shift| !is_held(shift)) {
            if shift.cable >= cable_count {
                let (kind, cable) = (ParameterKind::LengthOffset, shift.cable + 1);
                return Err(ParameterError::NoSuchCable { kind, cable, cable_count });
            }
            if !shifts.contains(&shift) {
                shifts.push(shift);
            }
        }
        Ok(shifts)
    }

    /// Course of the first change of recorded lengths that is free and not held as a whole.
    pub fn first_length_shift(&self, hold: &Self) -> Option<ShiftCourse> {
        self.shifts.iter().find(|free| !hold.shifts.contains(free)).map(|free| free.course)
    }

    /// The selection without changes of recorded lengths inside a record.
    pub fn without_length_shifts(&self) -> Self {
        Self { shifts: Vec::new(), ..self.clone() }
    }

    /// True if this kind is free for a cable (0-based).
    pub fn contains(&self, kind: ParameterKind, cable: usize) -> bool {
        let covers = |cables: &Option<Vec<usize>>| cables.as_ref().is_none_or(|list| list.contains(&cable));
        self.selections.iter().any(|(other, cables)| *other == kind && covers(cables))
    }

    /// Checks that start length and length offset of a cable are not both free.
    fn check_start_lengths(parameters: &[Parameter]) -> Result<(), ParameterError> {
        let is_free =
            |cable, kind| parameters.iter().any(|parameter| parameter.cable == cable && parameter.kind == kind);
        let of_start = parameters.iter().filter(|parameter| parameter.kind == ParameterKind::StartLength);
        let mut cables = of_start.map(|parameter| parameter.cable);
        cables
            .find(|&cable| is_free(cable, ParameterKind::LengthOffset))
            .map_or(Ok(()), |cable| Err(ParameterError::StartLengthTwice { cable: cable + 1 }))
    }

    /// The single parameters of a model that are free and not held, ordered by cable, kind and axis.
    pub fn parameters(&self, model: &Model, hold: &Self) -> Result<Vec<Parameter>, ParameterError> {
        self.parameters_with(model, hold, model.needs_tensions())
    }

    /// The same, with parameters of tensions if recorded tensions are explained; those of rigid cables may be, by their
    /// equilibrium.
    pub fn parameters_with(
        &self,
        model: &Model,
        hold: &Self,
        explains_tensions: bool,
    ) -> Result<Vec<Parameter>, ParameterError> {
        self.check(model, explains_tensions)?;
        hold.check_cables(model)?;
        let mut parameters = Vec::new();
        for cable in 0..model.cable_count() {
            for kind in ParameterKind::IDENTIFIED.into_iter().filter(|kind| !kind.is_of_load()) {
                if self.contains(kind, cable) && !hold.contains(kind, cable) {
                    parameters.extend(Parameter::identified(kind, model.robot(), cable));
                }
            }
        }
        let of_load = ParameterKind::IDENTIFIED.into_iter().filter(|kind| kind.is_of_load());
        for kind in of_load.filter(|&kind| self.contains(kind, 0) && !hold.contains(kind, 0)) {
            parameters.extend(Parameter::identified(kind, model.robot(), 0));
        }
        Self::check_start_lengths(&parameters)?;
        Self::check_load(&parameters, model)?;
        Ok(parameters)
    }

    /// Checks that free numbers of the weight have an effect of their own.
    fn check_load(parameters: &[Parameter], model: &Model) -> Result<(), ParameterError> {
        let is_weight = |kind: ParameterKind| matches!(kind, ParameterKind::Mass | ParameterKind::CenterOfMass);
        let Some(kind) = parameters.iter().map(|parameter| parameter.kind).find(|&kind| is_weight(kind)) else {
            return Ok(());
        };
        let robot = model.robot();
        let is_whole = robot.external_wrench.as_ref().is_some_and(|external| external.includes_gravity);
        let reason = match kind {
            _ if parameters.iter().any(|parameter| parameter.kind == ParameterKind::Wrench) => {
                "`wrench` is free, too, and includes the weight: free one of them"
            }
            _ if is_whole => {
                "the file's `[external_wrench]` includes the weight (`includes_gravity`): free `wrench` instead"
            }
            ParameterKind::CenterOfMass if !robot.motion_pattern.has_rotation() => {
                "the platform does not turn, so that no moment acts on it: leave it out"
            }
            _ => return Ok(()),
        };
        Err(ParameterError::NoEffect { kind, reason })
    }

    /// True if this kind is free for some cable.
    pub fn names(&self, kind: ParameterKind) -> bool {
        self.selections.iter().any(|(other, _)| *other == kind)
    }

    fn check(&self, model: &Model, explains_tensions: bool) -> Result<(), ParameterError> {
        self.check_cables(model)?;
        let composition = model.composition();
        for &(kind, _) in &self.selections {
            let is_of_sensor = matches!(kind, ParameterKind::TensionScale | ParameterKind::TensionOffset);
            if (is_of_sensor || kind.is_of_load()) && explains_tensions {
                continue;
            }
            if let Some(effect) = missing_effect(kind, composition) {
                return Err(ParameterError::NotInModel { kind, model: composition.to_string(), effect });
            }
        }
        let is_guided = |cable: &usize| model.robot().cables[*cable].winch.guided == Some(true);
        let mut turned = (0..model.cable_count()).filter(|&cable| self.contains(ParameterKind::DrumAxis, cable));
        if let Some(cable) = turned.find(is_guided) {
            return Err(ParameterError::GuidedDrum { cable: cable + 1 });
        }
        for kind in [ParameterKind::Compliance, ParameterKind::HiddenLength] {
            let is_spring = |cable: &usize| model.robot().cables[*cable].spring_constant().is_some();
            if let Some(cable) = (0..model.cable_count()).find(|cable| self.contains(kind, *cable) && is_spring(cable))
            {
                return Err(ParameterError::ConstantSpring { kind, cable: cable + 1 });
            }
        }
        Ok(())
    }

    fn check_cables(&self, model: &Model) -> Result<(), ParameterError> {
        let cable_count = model.cable_count();
        for (kind, cables) in &self.selections {
            if kind.is_of_load() && cables.is_some() {
                return Err(ParameterError::LoadOfCable { kind: *kind });
            }
            if let Some(&cable) = cables.iter().flatten().find(|&&cable| cable >= cable_count) {
                return Err(ParameterError::NoSuchCable { kind: *kind, cable: cable + 1, cable_count });
            }
        }
        Ok(())
    }
}

impl fmt::Display for FreeParameters {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (kind, cables)) in self.selections.iter().enumerate() {
            let comma = if index > 0 { "," } else { "" };
            write!(f, "{comma}{kind}")?;
            if let Some(cables) = cables {
                let numbers: Vec<String> = cables.iter().map(|cable| (cable + 1).to_string()).collect();
                write!(f, "[{}]", numbers.join(","))?;
            }
        }
        for (index, parameter) in self.recorded().enumerate() {
            let comma = if index > 0 || !self.selections.is_empty() { "," } else { "" };
            write!(f, "{comma}{}", parameter.name())?;
        }
        for (index, shift) in self.shifts.iter().enumerate() {
            let is_first = index == 0 && self.selections.is_empty() && self.recorded().count() == 0;
            write!(f, "{}{shift}", if is_first { "" } else { "," })?;
        }
        Ok(())
    }
}

impl FromStr for FreeParameters {
    type Err = ParameterError;

    /// Reads a text like `frame-anchor[1,3],length-offset`; empty text frees nothing.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (mut selections, mut recording, mut shifts) = (Vec::new(), Vec::new(), Vec::new());
        let mut rest = text.trim();
        while !rest.is_empty() {
            let end = rest.find([',', '[', '@']).unwrap_or(rest.len());
            let word = rest[..end].trim();
            if let Some(parameter) = RecordingParameter::ALL.into_iter().find(|parameter| parameter.name() == word) {
                recording.push(parameter);
                rest = &rest[end..];
            } else if let Some((shift, after)) = shift(rest, end) {
                shifts.push(shift);
                rest = after;
            } else if rest[end..].starts_with('@') {
                return Err(ParameterError::Syntax { item: rest.to_owned() });
            } else {
                let kind = identified_kind(word)?;
                let syntax = || ParameterError::Syntax { item: format!("{kind}{}", &rest[end..]) };
                let head = Head::read(rest).ok_or_else(syntax)?;
                let cables = head.cables;
                rest = head.rest.trim_start();
                selections.push((kind, cables));
            }
            rest = match rest.strip_prefix(',') {
                Some(after) if !after.trim().is_empty() => after.trim_start(),
                Some(_) => return Err(ParameterError::Syntax { item: text.to_owned() }),
                None if rest.is_empty() => rest,
                None => return Err(ParameterError::Syntax { item: rest.to_owned() }),
            };
        }
        Ok(Self { selections, shifts, ..Self::default() }.with_recording(&recording))
    }
}

/// A change of recorded lengths at the beginning of a text, whose first word ends at a byte, with the rest; `None` where there is none.
fn shift(text: &str, end: usize) -> Option<(FreeShift, &str)> {
    let head = if text[end..].starts_with('[') { Head::read(text) } else { None };
    let (cables, after) = head.map_or((None, &text[end..]), |head| (head.cables, head.rest));
    let (course, rest) = ShiftCourse::read(text[..end].trim(), after)?;
    Some((FreeShift { course, cables }, rest.trim_start()))
}
