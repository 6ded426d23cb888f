//! Other units in which a file may be written.

use std::f64::consts::PI;

use nalgebra::Vector3;

use crate::geometry::{MotionPattern, Pose};
use crate::measurement::columns::Quantity;
use crate::measurement::comparison::Data;
use crate::measurement::position_columns;
use crate::robot::Robot;

/// Unit of length.
#[derive(Clone, Copy)]
struct Unit {
    name: &'static str,
    /// Ending of columns in it; empty where none is read.
    symbol: &'static str,
    metres: f64,
}

/// Units of lengths that are tried: name, symbol in columns (empty if none is read), and metres.
const UNITS: [Unit; 5] = [
    Unit { name: "metres", symbol: "m", metres: 1.0 },
    Unit { name: "millimetres", symbol: "mm", metres: 1e-3 },
    Unit { name: "centimetres", symbol: "", metres: 1e-2 },
    Unit { name: "inches", symbol: "", metres: 0.0254 },
    Unit { name: "feet", symbol: "", metres: 0.3048 },
];
/// Tried of positions alone, that nobody measures in: positions divided by 1000 once more.
const KILOMETRES: Unit = Unit { name: "kilometres", symbol: "", metres: 1e3 };
/// Size beyond which a robot's anchors are in millimetres rather than its data in metres (m).
const LARGEST_ROBOT: f64 = 200.0;

/// Another reading of the file.
pub(super) struct Alternative {
    /// Quantity of a column that is wrong.
    pub(super) quantity: Quantity,
    /// The reading in words.
    pub(super) words: String,
    /// Advice for the user.
    pub(super) help: String,
    /// Numbers that are read otherwise.
    part: Part,
    /// Factor on them.
    factor: f64,
    /// True if the third axis is mirrored besides.
    is_mirrored: bool,
}

/// Numbers of a file.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Positions,
    Lengths,
    Both,
    Axis(usize),
    Cable(usize),
    Angles,
}

/// All alternatives for a robot's data; `factor` is that from a column's unit to SI.
pub(super) fn alternatives(robot: &Robot, has_angles: bool, factor: &dyn Fn(Quantity) -> f64) -> Vec<Alternative> {
    let axes = robot.motion_pattern.translations();
    let mut all = Vec::new();
    let groups = [Part::Positions, Part::Lengths, Part::Both].into_iter();
    let single = (0..axes).map(Part::Axis).chain((0..robot.cable_count()).map(Part::Cable));
    for part in groups.chain(single) {
        let quantity = part.quantity();
        let own = factor(quantity);
        // positions and lengths in two units have no common one
        if part == Part::Both && own != factor(Quantity::Position(0)) {
            continue;
        }
        let further = (part == Part::Positions).then_some(KILOMETRES);
        for unit in UNITS.into_iter().chain(further).filter(|unit| unit.metres != own) {
            let is_of_robot =
                part == Part::Both && unit.metres / own > 100.0 && robot.anchor_diagonal() > LARGEST_ROBOT;
            if !is_of_robot {
                all.push(in_unit(robot, part, unit, own, false));
            }
            if part == Part::Positions && !robot.motion_pattern.is_planar() {
                all.push(in_unit(robot, part, unit, own, true));
            }
        }
    }
    if factor(Quantity::Position(0)) == 1.0 || robot.anchor_diagonal() > LARGEST_ROBOT {
        all.push(Alternative {
            quantity: Quantity::Length(0),
            part: Part::Both,
            factor: 1e3,
            is_mirrored: false,
            words: "the anchors of the robot file look like millimetres: positions and cable lengths fit them 1000 times larger".to_owned(),
            help: "divide the anchors of the robot file by 1000: its keys end in _m".to_owned(),
        });
    }
    all.extend(has_angles.then(|| in_degrees(robot)).flatten());
    all
}

/// A part in a unit instead of its own one.
fn in_unit(robot: &Robot, part: Part, unit: Unit, own: f64, is_mirrored: bool) -> Alternative {
    let Unit { name, symbol, metres } = unit;
    let factor = metres / own;
    // 0.3048 / 0.001 is not 304.8 to the last bit
    let times = (1e6 * factor).round() / 1e6;
    let written = if own == 1.0 { "m" } else { "mm" };
    let positions = |unit: &str| position_columns(robot, unit);
    let (what, columns) = match part {
        Part::Positions => ("the positions look like".to_owned(), positions(symbol).join(", ")),
        Part::Lengths => ("the cable lengths look like".to_owned(), format!("cable_length_{symbol}_1 …")),
        Part::Axis(axis) => {
            (format!("the column {} alone looks like", positions(written)[axis]), positions(symbol)[axis].clone())
        }
        Part::Cable(cable) => (
            format!("the column cable_length_{written}_{} alone looks like", cable + 1),
            format!("cable_length_{symbol}_{}", cable + 1),
        ),
        _ => (
            "positions and cable lengths look like".to_owned(),
            format!("{} and cable_length_{symbol}_1 …", positions(symbol).join(", ")),
        ),
    };
    let fits = match part {
        Part::Positions | Part::Axis(_) => "the cable lengths fit",
        Part::Lengths | Part::Cable(_) => "the poses fit",
        _ => "the robot fits",
    };
    let mirrored = if is_mirrored { " with z mirrored" } else { "" };
    let words = format!("{what} {name}{mirrored}: {fits} them times {times}{mirrored}");
    let help = match symbol {
        "" if metres == 1e-2 && own == 1.0 => "divide them by 100; m and mm are read".to_owned(),
        "" => format!("multiply them by {times}; m and mm are read"),
        _ => format!("name the columns {columns}, and they are converted"),
    };
    Alternative { quantity: part.quantity(), words, help, part, factor, is_mirrored }
}

/// Angles in degrees; `None` for a robot without angles.
fn in_degrees(robot: &Robot) -> Option<Alternative> {
    let (quantity, columns) = match robot.motion_pattern {
        MotionPattern::Planar => (Quantity::Angle, "column angle_deg, and it is converted"),
        MotionPattern::Spatial => (Quantity::Euler(0), "columns rx_deg, ry_deg, rz_deg, and they are converted"),
        _ => return None,
    };
    Some(Alternative {
        quantity,
        words: "the angles look like degrees: only so they fit the cable lengths".to_owned(),
        help: format!("name the {columns}"),
        part: Part::Angles,
        factor: PI / 180.0,
        is_mirrored: false,
    })
}

impl Part {
    /// The quantity of its first column.
    fn quantity(self) -> Quantity {
        match self {
            Self::Axis(axis) => Quantity::Position(axis),
            Self::Lengths | Self::Both => Quantity::Length(0),
            Self::Cable(cable) => Quantity::Length(cable),
            Self::Positions | Self::Angles => Quantity::Position(0),
        }
    }
}

impl Alternative {
    /// Data read so.
    pub(super) fn read<'a>(&self, data: &Data<'a>) -> Data<'a> {
        let (robot, factor) = (data.robot, self.factor);
        let pattern = robot.motion_pattern;
        let mut read = data.clone();
        let axes = match (self.part, pattern.is_planar()) {
            (Part::Axis(axis), true) => [robot.plane.first_axis(), robot.plane.second_axis()].get(axis).copied(),
            (Part::Axis(axis), false) => Some(Vector3::ith(axis, 1.0)),
            _ => None,
        };
        let position = |p: &Vector3<f64>| match (self.part, axes) {
            (Part::Positions | Part::Both, _) => p * factor,
            (_, Some(axis)) => p + axis * (axis.dot(p) * (factor - 1.0)),
            _ => *p,
        };
        read.poses.iter_mut().for_each(|pose| pose.position = position(&pose.position));
        if self.is_mirrored {
            read.poses.iter_mut().for_each(mirror);
        }
        for (cable, recorded) in read.recorded.iter_mut().enumerate() {
            if matches!(self.part, Part::Lengths | Part::Both) || self.part == Part::Cable(cable) {
                recorded.iter_mut().for_each(|length| *length *= factor);
            }
        }
        if self.part == Part::Angles {
            for (pose, angles) in read.poses.iter_mut().zip(&data.angles) {
                let mut components = pattern.pose_to_components(robot.plane, pose);
                let turns = components[pattern.translations()..].iter_mut();
                turns.zip(angles).for_each(|(component, angle)| *component = angle * factor);
                *pose = pattern.pose(robot.plane, &components).unwrap_or(*pose);
            }
        }
        read
    }
}

/// Mirrors the third axis of positions and orientations.
fn mirror(pose: &mut Pose) {
    pose.position.z = -pose.position.z;
    let q = pose.rotation.coords;
    pose.rotation = nalgebra::UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(q[3], -q[0], -q[1], q[2]));
}
