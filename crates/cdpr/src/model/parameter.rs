//! Parameters that identification may free: their names, where they live in the robot, and the `--free` language.

use std::fmt;
use std::str::FromStr;

use serde::{Serialize, Serializer};
use thiserror::Error;

use super::{Model, StretchEffect};
use crate::geometry::Wrench;
use crate::robot::{Cable, ExternalWrench, Robot};

/// A kind of parameter: one group per cable, but for the wrench, which the platform has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum ParameterKind {
    /// Frame anchor a (world, m); entry point D of a pulley.
    FrameAnchor,
    /// Platform anchor b (platform frame, m).
    PlatformAnchor,
    /// q_recorded = length_scale · q_θ + length_offset (m).
    LengthOffset,
    /// See [`ParameterKind::LengthOffset`]; without unit.
    LengthScale,
    /// Pulley radius r_p (m).
    PulleyRadius,
    /// Radius of the winch's drum to the cable's centre line (m); data of motor angles tell it.
    DrumRadius,
    /// Controlled length at the drum's start angle (m); data of motor angles tell it. It shifts lengths as the length offset
    /// does: one of the two is free, never both.
    StartLength,
    /// Specific compliance 1/EA (1/N): its inverse, the stiffness, runs away where data say little (see the book).
    Compliance,
    /// Strained length between winch and outlet q_h (m).
    HiddenLength,
    /// f_recorded = tension_scale · f + tension_offset; without unit.
    TensionScale,
    /// See [`ParameterKind::TensionScale`] (N).
    TensionOffset,
    /// The constant external wrench in world axes, weight included (N, N·m).
    Wrench,
}

impl ParameterKind {
    /// Every kind, in the order of a parameter vector.
    pub const ALL: [Self; 12] = [
        Self::FrameAnchor,
        Self::PlatformAnchor,
        Self::LengthOffset,
        Self::LengthScale,
        Self::PulleyRadius,
        Self::DrumRadius,
        Self::StartLength,
        Self::Compliance,
        Self::HiddenLength,
        Self::TensionScale,
        Self::TensionOffset,
        Self::Wrench,
    ];

    /// The name used by `--free` and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::FrameAnchor => "frame-anchor",
            Self::PlatformAnchor => "platform-anchor",
            Self::LengthOffset => "length-offset",
            Self::LengthScale => "length-scale",
            Self::PulleyRadius => "pulley-radius",
            Self::DrumRadius => "drum-radius",
            Self::StartLength => "start-length",
            Self::Compliance => "compliance",
            Self::HiddenLength => "hidden-length",
            Self::TensionScale => "tension-scale",
            Self::TensionOffset => "tension-offset",
            Self::Wrench => "wrench",
        }
    }

    /// Unit of the value, empty for a ratio; a wrench is in N, its moments in N·m.
    pub fn unit(self) -> &'static str {
        match self {
            Self::LengthScale | Self::TensionScale => "",
            Self::Compliance => "1/N",
            Self::TensionOffset | Self::Wrench => "N",
            _ => "m",
        }
    }

    /// True for what only a model with elastic cables and recorded tensions can tell.
    pub fn needs_elasticity(self) -> bool {
        matches!(self, Self::Compliance | Self::HiddenLength | Self::TensionScale | Self::TensionOffset | Self::Wrench)
    }

    /// True for what only recorded motor angles can tell.
    pub fn needs_motor_angles(self) -> bool {
        matches!(self, Self::DrumRadius | Self::StartLength)
    }

    /// True for the anchors, which have a component along each axis of the pattern.
    pub fn is_anchor(self) -> bool {
        matches!(self, Self::FrameAnchor | Self::PlatformAnchor)
    }
}

impl FromStr for ParameterKind {
    type Err = ParameterError;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        if let Some(kind) = Self::ALL.into_iter().find(|kind| kind.name() == name) {
            return Ok(kind);
        }
        Err(ParameterError::UnknownName { name: name.to_owned() })
    }
}

impl fmt::Display for ParameterKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// One number that can be identified.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Parameter {
    /// Cable it belongs to, from 0; 0 for the wrench, which belongs to none.
    pub cable: usize,
    /// What it is.
    pub kind: ParameterKind,
    /// Component of an anchor along the pattern's axes, or of the wrench along its degrees of freedom, from 0; 0 for the
    /// rest.
    pub axis: usize,
}

impl Parameter {
    /// Name for people and files, e.g. `frame-anchor[1].x`.
    pub fn name(&self, robot: &Robot) -> String {
        let cable = self.cable + 1;
        match self.kind {
            ParameterKind::Wrench => {
                let translations = robot.motion_pattern.translations();
                match self.axis.checked_sub(translations) {
                    None => format!("wrench.force_{}", axis_name(robot, self.axis)),
                    Some(_) if robot.motion_pattern.is_planar() => "wrench.moment".to_owned(),
                    Some(axis) => format!("wrench.moment_{}", axis_name(robot, axis)),
                }
            }
            kind if kind.is_anchor() => format!("{kind}[{cable}].{}", axis_name(robot, self.axis)),
            kind => format!("{kind}[{cable}]"),
        }
    }

    /// Unit of the value, empty for a ratio.
    pub fn unit(&self, robot: &Robot) -> &'static str {
        let is_moment = self.kind == ParameterKind::Wrench && self.axis >= robot.motion_pattern.translations();
        if is_moment { "N·m" } else { self.kind.unit() }
    }

    /// Its value in a model's robot: what the file says, else the neutral value (scale 1, offset 0).
    pub fn value(&self, model: &Model) -> f64 {
        let cable = &model.robot().cables[self.cable];
        match self.kind {
            ParameterKind::FrameAnchor => model.axes()[self.axis].dot(&cable.frame_anchor),
            ParameterKind::PlatformAnchor => model.axes()[self.axis].dot(&cable.platform_anchor),
            ParameterKind::LengthOffset => cable.length_offset.unwrap_or(0.0),
            ParameterKind::LengthScale => cable.length_scale.unwrap_or(1.0),
            ParameterKind::PulleyRadius => cable.pulley_radius.unwrap_or(0.0),
            ParameterKind::DrumRadius => cable.drum_radius.unwrap_or(0.0),
            ParameterKind::StartLength => cable.drum_start_length.unwrap_or(0.0),
            ParameterKind::Compliance => specific_compliance(cable),
            ParameterKind::HiddenLength => cable.hidden_length.unwrap_or(0.0),
            ParameterKind::TensionScale => cable.tension_scale.unwrap_or(1.0),
            ParameterKind::TensionOffset => cable.tension_offset.unwrap_or(0.0),
            ParameterKind::Wrench => {
                let wrench = model.robot().external_wrench.as_ref().map_or_else(Wrench::zeros, |w| w.wrench);
                model.twist_basis()[self.axis].dot(&wrench)
            }
        }
    }

    /// Its value where the robot states one; `None` where [`Parameter::value`] is a neutral value.
    pub fn stated(&self, model: &Model) -> Option<f64> {
        let cable = &model.robot().cables[self.cable];
        let stated = match self.kind {
            ParameterKind::FrameAnchor | ParameterKind::PlatformAnchor => true,
            ParameterKind::LengthOffset => cable.length_offset.is_some(),
            ParameterKind::LengthScale => cable.length_scale.is_some(),
            ParameterKind::PulleyRadius => cable.pulley_radius.is_some(),
            ParameterKind::DrumRadius => cable.drum_radius.is_some(),
            ParameterKind::StartLength => cable.drum_start_length.is_some(),
            ParameterKind::Compliance => cable.axial_compliance.is_some() || cable.axial_stiffness.is_some(),
            ParameterKind::HiddenLength => cable.hidden_length.is_some(),
            ParameterKind::TensionScale => cable.tension_scale.is_some(),
            ParameterKind::TensionOffset => cable.tension_offset.is_some(),
            // a wrench without the weight is not the constant wrench that identification means
            ParameterKind::Wrench => {
                model.robot().external_wrench.as_ref().is_some_and(|wrench| wrench.includes_gravity)
            }
        };
        stated.then(|| self.value(model))
    }

    /// Writes a value into a robot with the axes of `model`.
    pub fn assign(&self, model: &Model, robot: &mut Robot, value: f64) {
        let cable = &mut robot.cables[self.cable];
        match self.kind {
            ParameterKind::FrameAnchor => {
                let axis = model.axes()[self.axis];
                cable.frame_anchor += axis * (value - axis.dot(&cable.frame_anchor));
            }
            ParameterKind::PlatformAnchor => {
                let axis = model.axes()[self.axis];
                cable.platform_anchor += axis * (value - axis.dot(&cable.platform_anchor));
            }
            ParameterKind::LengthOffset => cable.length_offset = Some(value),
            ParameterKind::LengthScale => cable.length_scale = Some(value),
            ParameterKind::PulleyRadius => cable.pulley_radius = Some(value),
            ParameterKind::DrumRadius => cable.drum_radius = Some(value),
            ParameterKind::StartLength => cable.drum_start_length = Some(value),
            ParameterKind::Compliance => (cable.axial_compliance, cable.axial_stiffness) = (Some(value), None),
            ParameterKind::HiddenLength => cable.hidden_length = Some(value),
            ParameterKind::TensionScale => cable.tension_scale = Some(value),
            ParameterKind::TensionOffset => cable.tension_offset = Some(value),
            ParameterKind::Wrench => {
                let direction = model.twist_basis()[self.axis];
                let external = robot.external_wrench.get_or_insert_with(|| ExternalWrench {
                    wrench: Wrench::zeros(),
                    includes_gravity: true,
                    note: Some("identified".to_owned()),
                });
                external.wrench += direction * (value - direction.dot(&external.wrench));
                external.includes_gravity = true;
            }
        }
    }

    /// Values it may take: radii, compliances and hidden lengths not below 0, scales and radii of drums positive.
    pub fn bounds(&self) -> (f64, f64) {
        match self.kind {
            ParameterKind::PulleyRadius | ParameterKind::Compliance | ParameterKind::HiddenLength => {
                (0.0, f64::INFINITY)
            }
            ParameterKind::LengthScale | ParameterKind::TensionScale | ParameterKind::DrumRadius => {
                (1e-3, f64::INFINITY)
            }
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        }
    }
}

/// 1/EA as the file states it (1/N); 0 where it states neither stiffness nor compliance.
pub(crate) fn specific_compliance(cable: &Cable) -> f64 {
    cable.axial_compliance.or_else(|| cable.axial_stiffness.map(|stiffness| 1.0 / stiffness)).unwrap_or(0.0)
}

/// Name of a pattern axis in the world: x, y or z.
pub(crate) fn axis_name(robot: &Robot, axis: usize) -> String {
    let names = if robot.motion_pattern.is_planar() { robot.plane.axes() } else { "xyz".to_owned() };
    names.chars().nth(axis).map(String::from).unwrap_or_default()
}

/// What `--free` or `--hold` names: kinds of parameters, each for all cables or for some.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FreeParameters {
    /// Kind and 0-based cables; `None` means every cable.
    selections: Vec<(ParameterKind, Option<Vec<usize>>)>,
}

/// A list of parameters that cannot be understood or does not fit the model.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ParameterError {
    /// Not a parameter.
    #[error("`{name}` is not a parameter; known are frame-anchor, platform-anchor, length-offset, length-scale, pulley-radius, drum-radius, start-length, compliance, hidden-length, wrench, tension-scale, tension-offset{}", suggestion(.name))]
    UnknownName {
        /// The word found.
        name: String,
    },
    /// Text around the brackets that makes no sense.
    #[error("cannot read `{item}`: write NAME or NAME[1,3], separated by commas, cables counted from 1")]
    Syntax {
        /// The item.
        item: String,
    },
    /// A cable the robot does not have.
    #[error("`{kind}[{cable}]`: the robot has cables 1 to {cable_count}")]
    NoSuchCable {
        /// Name of the parameter.
        kind: ParameterKind,
        /// The number asked for, from 1.
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
        /// The effect it belongs to.
        effect: &'static str,
    },
    /// Two parameters that shift the recorded lengths of a cable alike.
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
        "`{kind}[{cable}]` is free, but cable {cable} has a constant spring (`spring_constant_N_per_m`), which has no {kind}; state          `axial_stiffness_EA_N` instead, or restrict the list to other cables"
    )]
    ConstantSpring {
        /// The parameter.
        kind: ParameterKind,
        /// Number of the cable, from 1.
        cable: usize,
    },
    /// The wrench belongs to no cable.
    #[error("`wrench` belongs to the platform, not to single cables: write it without brackets")]
    WrenchOfCable,
}

fn suggestion(name: &str) -> String {
    let close = |kind: &ParameterKind| strsim::jaro_winkler(kind.name(), name);
    match ParameterKind::ALL.into_iter().max_by(|a, b| close(a).total_cmp(&close(b))) {
        Some(kind) if close(&kind) > 0.75 => format!("; did you mean `{kind}`?"),
        _ => String::new(),
    }
}

impl FreeParameters {
    /// These kinds for every cable.
    pub fn of(kinds: &[ParameterKind]) -> Self {
        Self { selections: kinds.iter().map(|&kind| (kind, None)).collect() }
    }

    /// True when nothing is free.
    pub fn is_empty(&self) -> bool {
        self.selections.is_empty()
    }

    fn contains(&self, kind: ParameterKind, cable: usize) -> bool {
        let covers = |cables: &Option<Vec<usize>>| cables.as_ref().is_none_or(|list| list.contains(&cable));
        self.selections.iter().any(|(other, cables)| *other == kind && covers(cables))
    }

    /// Start length and length offset are never both free.
    fn check_start_lengths(parameters: &[Parameter]) -> Result<(), ParameterError> {
        let is_free =
            |cable, kind| parameters.iter().any(|parameter| parameter.cable == cable && parameter.kind == kind);
        let mut cables = parameters.iter().map(|parameter| parameter.cable);
        let is_twice =
            |cable: &usize| is_free(*cable, ParameterKind::StartLength) && is_free(*cable, ParameterKind::LengthOffset);
        cables.find(is_twice).map_or(Ok(()), |cable| Err(ParameterError::StartLengthTwice { cable: cable + 1 }))
    }

    /// The single parameters of a model that are free and not held, ordered by cable, kind and axis.
    pub fn parameters(&self, model: &Model, hold: &Self) -> Result<Vec<Parameter>, ParameterError> {
        self.check(model)?;
        hold.check_cables(model)?;
        let mut parameters = Vec::new();
        for cable in 0..model.cable_count() {
            for kind in ParameterKind::ALL.into_iter().filter(|&kind| kind != ParameterKind::Wrench) {
                if self.contains(kind, cable) && !hold.contains(kind, cable) {
                    let count = if kind.is_anchor() { model.axes().len() } else { 1 };
                    parameters.extend((0..count).map(|axis| Parameter { cable, kind, axis }));
                }
            }
        }
        let kind = ParameterKind::Wrench;
        if self.contains(kind, 0) && !hold.contains(kind, 0) {
            parameters.extend((0..model.dof()).map(|axis| Parameter { cable: 0, kind, axis }));
        }
        Self::check_start_lengths(&parameters)?;
        Ok(parameters)
    }

    /// True when this kind is free for some cable.
    pub fn names(&self, kind: ParameterKind) -> bool {
        self.selections.iter().any(|(other, _)| *other == kind)
    }

    fn check(&self, model: &Model) -> Result<(), ParameterError> {
        self.check_cables(model)?;
        let composition = model.composition();
        for &(kind, _) in &self.selections {
            let effect = match kind {
                ParameterKind::PulleyRadius if !composition.pulley => "pulley",
                kind if kind.needs_motor_angles() && !composition.drum => "drum",
                ParameterKind::Compliance if composition.stretch != StretchEffect::Linear => "elastic",
                ParameterKind::HiddenLength if !composition.is_elastic() => "elastic",
                kind if kind.needs_elasticity() && !composition.depends_on_tension() => "elastic",
                _ => continue,
            };
            return Err(ParameterError::NotInModel { kind, model: composition.to_string(), effect });
        }
        for kind in [ParameterKind::Compliance, ParameterKind::HiddenLength] {
            let is_spring = |cable: &usize| model.robot().cables[*cable].spring_constant.is_some();
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
            if *kind == ParameterKind::Wrench && cables.is_some() {
                return Err(ParameterError::WrenchOfCable);
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
        Ok(())
    }
}

impl Serialize for FreeParameters {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl FromStr for FreeParameters {
    type Err = ParameterError;

    /// Reads `frame-anchor[1,3],length-offset`; empty text frees nothing.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut selections = Vec::new();
        let mut rest = text.trim();
        while !rest.is_empty() {
            let end = rest.find([',', '[']).unwrap_or(rest.len());
            let kind: ParameterKind = rest[..end].trim().parse()?;
            let mut cables = None;
            rest = &rest[end..];
            if let Some(inside) = rest.strip_prefix('[') {
                let syntax = || ParameterError::Syntax { item: format!("{kind}{rest}") };
                let close = inside.find(']').ok_or_else(syntax)?;
                let numbers = inside[..close].split(',').map(|number| match number.trim().parse::<usize>() {
                    Ok(cable) if cable > 0 => Ok(cable - 1),
                    _ => Err(syntax()),
                });
                cables = Some(numbers.collect::<Result<Vec<_>, _>>()?);
                rest = inside[close + 1..].trim_start();
            }
            selections.push((kind, cables));
            rest = match rest.strip_prefix(',') {
                Some(after) if !after.trim().is_empty() => after.trim_start(),
                Some(_) => return Err(ParameterError::Syntax { item: text.to_owned() }),
                None if rest.is_empty() => rest,
                None => return Err(ParameterError::Syntax { item: rest.to_owned() }),
            };
        }
        Ok(Self { selections })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_free_language_survives_the_round_trip() {
        for text in [
            "",
            "frame-anchor",
            "frame-anchor[1,3],length-offset",
            "length-scale,pulley-radius[8]",
            "compliance,wrench",
        ] {
            let free: FreeParameters = text.parse().unwrap();
            assert_eq!(free.to_string(), text);
        }
    }

    #[test]
    fn what_is_not_the_language_is_refused() {
        for text in [
            "frame",
            "frame-anchor[",
            "frame-anchor[0]",
            "frame-anchor[a]",
            "frame-anchor]",
            "length-offset,",
            "frame-anchor[1]x",
            "complience",
            ",",
            "frame-anchor[-1]",
            "frame-anchor[99999999999999999999999]",
        ] {
            assert!(text.parse::<FreeParameters>().is_err(), "{text}");
        }
    }
}
