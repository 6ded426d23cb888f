//! Parameters that identification may free: their names, where they live in the robot, and the `--free` language.

use std::fmt;
use std::str::FromStr;

use serde::{Serialize, Serializer};
use thiserror::Error;

use super::Model;
use crate::robot::Robot;

/// A kind of parameter, one group per cable.
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
}

/// Names of the contract that belong to effects of later versions.
const LATER_NAMES: [&str; 5] = ["compliance", "hidden-length", "wrench", "tension-scale", "tension-offset"];

impl ParameterKind {
    /// Every kind, in the order of a parameter vector.
    pub const ALL: [Self; 5] =
        [Self::FrameAnchor, Self::PlatformAnchor, Self::LengthOffset, Self::LengthScale, Self::PulleyRadius];

    /// The name used by `--free` and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::FrameAnchor => "frame-anchor",
            Self::PlatformAnchor => "platform-anchor",
            Self::LengthOffset => "length-offset",
            Self::LengthScale => "length-scale",
            Self::PulleyRadius => "pulley-radius",
        }
    }

    /// Unit of the value, empty for a ratio.
    pub fn unit(self) -> &'static str {
        if self == Self::LengthScale { "" } else { "m" }
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
        if LATER_NAMES.contains(&name) {
            return Err(ParameterError::NotYet { name: name.to_owned() });
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
    /// Cable it belongs to, from 0.
    pub cable: usize,
    /// What it is.
    pub kind: ParameterKind,
    /// Component of an anchor along the pattern's axes, from 0; 0 for the rest.
    pub axis: usize,
}

impl Parameter {
    /// Name for people and files, e.g. `frame-anchor[1].x`.
    pub fn name(&self, robot: &Robot) -> String {
        let cable = self.cable + 1;
        match self.kind.is_anchor() {
            true => format!("{}[{cable}].{}", self.kind, axis_name(robot, self.axis)),
            false => format!("{}[{cable}]", self.kind),
        }
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
        }
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
        }
    }

    /// Values it may take: radii not below 0, scales positive.
    pub fn bounds(&self) -> (f64, f64) {
        match self.kind {
            ParameterKind::PulleyRadius => (0.0, f64::INFINITY),
            ParameterKind::LengthScale => (1e-3, f64::INFINITY),
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        }
    }
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
    #[error("`{name}` is not a parameter; known are frame-anchor, platform-anchor, length-offset, length-scale, pulley-radius{}", suggestion(.name))]
    UnknownName {
        /// The word found.
        name: String,
    },
    /// A parameter of the contract that this version does not have.
    #[error("`{name}` needs tensions or elasticity, which are not part of this version")]
    NotYet {
        /// The parameter asked for.
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
    #[error("`pulley-radius` is free, but the model is `{model}`; choose the model `pulley`")]
    NotInModel {
        /// The model's composition.
        model: String,
    },
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

    /// The single parameters of a model that are free and not held, ordered by cable, kind and axis.
    pub fn parameters(&self, model: &Model, hold: &Self) -> Result<Vec<Parameter>, ParameterError> {
        self.check(model)?;
        hold.check_cables(model)?;
        let mut parameters = Vec::new();
        for cable in 0..model.cable_count() {
            for kind in ParameterKind::ALL {
                if self.contains(kind, cable) && !hold.contains(kind, cable) {
                    let count = if kind.is_anchor() { model.axes().len() } else { 1 };
                    parameters.extend((0..count).map(|axis| Parameter { cable, kind, axis }));
                }
            }
        }
        Ok(parameters)
    }

    fn check(&self, model: &Model) -> Result<(), ParameterError> {
        self.check_cables(model)?;
        let radius_is_free = self.selections.iter().any(|(kind, _)| *kind == ParameterKind::PulleyRadius);
        if radius_is_free && !model.composition().pulley {
            return Err(ParameterError::NotInModel { model: model.composition().to_string() });
        }
        Ok(())
    }

    fn check_cables(&self, model: &Model) -> Result<(), ParameterError> {
        let cable_count = model.cable_count();
        for (kind, cables) in &self.selections {
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
        for text in ["", "frame-anchor", "frame-anchor[1,3],length-offset", "length-scale,pulley-radius[8]"] {
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
            "compliance",
            ",",
            "frame-anchor[-1]",
            "frame-anchor[99999999999999999999999]",
        ] {
            assert!(text.parse::<FreeParameters>().is_err(), "{text}");
        }
    }
}
