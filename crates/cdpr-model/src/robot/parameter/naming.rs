//! Names of parameters: writes and reads them, both as names for users and as keys of robot files.

use super::{Owner, Parameter, ParameterKind, Robot};

/// Beginning of a name: a word and the cables in brackets after it, counted from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Head<'t> {
    /// The word before the brackets.
    pub(crate) word: &'t str,
    /// Cables in the brackets; `None` without brackets or with `[*]`.
    pub(crate) cables: Option<Vec<usize>>,
    /// Text after the brackets.
    pub(crate) rest: &'t str,
}

impl<'t> Head<'t> {
    /// The word at the beginning of a text, up to a bracket, a point or a comma, and the remaining text.
    pub(crate) fn word(text: &'t str) -> (&'t str, &'t str) {
        let end = text.find(['[', ',', '.']).unwrap_or(text.len());
        (text[..end].trim(), &text[end..])
    }

    /// Reads a word and its brackets; `None` if the brackets contain neither numbers from 1, as in `[1,3]`, nor `*`.
    pub(crate) fn read(text: &'t str) -> Option<Self> {
        let (word, rest) = Self::word(text);
        let Some(inside) = rest.strip_prefix('[') else { return Some(Self { word, cables: None, rest }) };
        let (numbers, rest) = inside.split_once(']')?;
        let number = |number: &str| number.trim().parse::<usize>().ok()?.checked_sub(1);
        let cables = match numbers {
            "*" => None,
            _ => Some(numbers.split(',').map(number).collect::<Option<Vec<usize>>>()?),
        };
        Some(Self { word, cables, rest })
    }
}

/// Name of a pattern axis in the world: x, y or z.
pub fn axis_name(robot: &Robot, axis: usize) -> String {
    axis_letter(robot, axis).map(String::from).unwrap_or_default()
}

fn axis_letter(robot: &Robot, axis: usize) -> Option<char> {
    match robot.motion_pattern.is_planar() {
        true => robot.plane.axes().chars().nth(axis),
        false => ['x', 'y', 'z'].get(axis).copied(),
    }
}

impl Parameter {
    /// Name for users and results, e.g. `frame-anchor[1].x`, `compliance[3]`, `wrench.force_z` or `mass`.
    pub fn name(&self, robot: &Robot) -> String {
        let mut name = String::with_capacity(32);
        name.push_str(self.kind.name());
        if self.kind.owner() == Owner::Cable {
            name.extend(["[", &(self.cable + 1).to_string(), "]"]);
        }
        self.push_component(robot, &mut name);
        name
    }

    /// Key in the robot file, e.g. `cable[1].frame_anchor_m[1]` or `platform.mass_kg`; `None` for the wrench, which has
    /// two keys, and for turns of axes.
    pub fn key(&self, robot: &Robot) -> Option<String> {
        let table = match self.kind.owner() {
            _ if self.kind.key().is_empty() => return None,
            Owner::Cable => format!("cable[{}].", self.cable + 1),
            Owner::Platform => "platform.".to_owned(),
            Owner::ExternalWrench => "external_wrench.".to_owned(),
            Owner::Robot | Owner::Recording => String::new(),
        };
        Some(format!("{table}{}{}", self.kind.key(), self.entry(robot)))
    }

    /// Parameters with this name or key of robot files; `[*]` or a name without brackets means every cable. `None` if
    /// there is no such name, cable or component.
    pub fn named(text: &str, robot: &Robot) -> Option<Vec<Self>> {
        let head = Head::read(text)?;
        let (kind, component, by_key) = match ParameterKind::ALL.into_iter().find(|kind| kind.name() == head.word) {
            Some(kind) => (kind, head.rest, false),
            None => {
                let (kind, component) = kind_of_key(text, &head)?;
                (kind, component, true)
            }
        };
        let cables = match (kind.owner(), head.cables) {
            (Owner::Cable, None) => (0..robot.cable_count()).collect(),
            (Owner::Cable, Some(cables)) => cables,
            // brackets after a key of the robot itself are its component
            (Owner::Robot, _) if by_key => vec![0],
            (_, None) => vec![0],
            (_, Some(_)) => return None,
        };
        let axes = (0..kind.components(robot)).map(|axis| Self { cable: 0, kind, axis });
        let spelled = |axis: &Self| if by_key { axis.entry(robot) } else { axis.component_name(robot) };
        let axis = axes.into_iter().find(|axis| spelled(axis) == component)?.axis;
        let is_there = cables.iter().all(|&cable| cable < robot.cable_count());
        is_there.then(|| cables.into_iter().map(|cable| Self { cable, kind, axis }).collect())
    }

    /// Component in the name for users, with its separator; empty if there is only one.
    fn component_name(&self, robot: &Robot) -> String {
        let mut name = String::new();
        self.push_component(robot, &mut name);
        name
    }

    fn push_component(&self, robot: &Robot, name: &mut String) {
        let is_planar = robot.motion_pattern.is_planar();
        let (word, letter) = match self.kind {
            ParameterKind::Wrench => match self.axis.checked_sub(robot.motion_pattern.translations()) {
                None => (".force_", axis_letter(robot, self.axis)),
                Some(_) if is_planar => (".moment", None),
                Some(axis) => (".moment_", axis_letter(robot, axis)),
            },
            kind if kind.is_of_recording() => match self.axis.checked_sub(robot.motion_pattern.translations()) {
                None => (".", axis_letter(robot, self.axis)),
                Some(_) if is_planar => (".turn", None),
                Some(axis) => (".turn_", ['x', 'y', 'z'].get(axis).copied()),
            },
            ParameterKind::Moment if is_planar => ("", None),
            kind if kind.is_turn() && kind.components(robot) > 1 => (".turn_", ['1', '2'].get(self.axis).copied()),
            kind if kind.is_vector() => (".", axis_letter(robot, self.axis)),
            _ => ("", None),
        };
        name.push_str(word);
        name.extend(letter);
    }

    /// Entry in the list of the robot file, from 1; empty if the key has one number.
    fn entry(&self, robot: &Robot) -> String {
        let is_number = self.kind == ParameterKind::Moment && robot.motion_pattern.is_planar();
        if self.kind.is_vector() && !is_number { format!("[{}]", self.axis + 1) } else { String::new() }
    }
}

/// Kind with its key after a table of robot files, and the text after the key.
fn kind_of_key<'t>(text: &'t str, head: &Head<'t>) -> Option<(ParameterKind, &'t str)> {
    let (owner, inside) = match head.word {
        "cable" if text.starts_with("cable[") => (Owner::Cable, head.rest.strip_prefix('.')?),
        "platform" => (Owner::Platform, head.rest.strip_prefix('.')?),
        "external_wrench" => (Owner::ExternalWrench, head.rest.strip_prefix('.')?),
        _ => (Owner::Robot, text),
    };
    let (key, component) = Head::word(inside);
    let is_meant = |kind: &ParameterKind| kind.owner() == owner && kind.key() == key && !key.is_empty();
    Some((ParameterKind::ALL.into_iter().find(is_meant)?, component))
}

impl ParameterKind {
    /// True for a kind with a component along each axis.
    fn is_vector(self) -> bool {
        matches!(self, Self::Force | Self::Moment | Self::CenterOfMass | Self::Gravity) || self.is_anchor()
    }
}

impl Robot {
    /// All parameters of a robot with its pattern and number of cables, stated or not.
    pub fn parameters(&self) -> impl Iterator<Item = Parameter> {
        ParameterKind::ALL.into_iter().flat_map(move |kind| {
            let cables = if kind.owner() == Owner::Cable { self.cable_count() } else { 1 };
            let components = kind.components(self);
            (0..cables).flat_map(move |cable| (0..components).map(move |axis| Parameter { cable, kind, axis }))
        })
    }
}
