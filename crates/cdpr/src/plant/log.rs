//! The log of a run as CSV: one row per record, in the columns of measurement files.

use std::fmt::Write;

use super::plant::Plant;
use super::state::State;
use crate::geometry::MotionPattern;
use crate::model::Model;

/// Columns of a log: `t_s`, the pose as measurement files state it, tensions and recorded lengths, then the twist.
#[derive(Clone, Debug, PartialEq)]
pub struct LogFormat {
    names: Vec<String>,
}

impl LogFormat {
    /// The columns of a model's robot.
    pub fn new(model: &Model) -> Self {
        let (robot, cables) = (model.robot(), 1..=model.cable_count());
        let pattern = robot.motion_pattern;
        let axes = if pattern.is_planar() { robot.plane.axes() } else { "xyz".to_owned() };
        let along =
            |stem: &str, unit: &str| axes.chars().map(|axis| format!("{stem}{axis}_{unit}")).collect::<Vec<_>>();
        let turns = |planar: &str, spatial: [&str; 4]| match pattern {
            MotionPattern::Planar => vec![planar.to_owned()],
            MotionPattern::Spatial => {
                spatial.iter().filter(|name| !name.is_empty()).map(|name| (*name).to_owned()).collect()
            }
            _ => Vec::new(),
        };
        let mut names = vec!["t_s".to_owned()];
        names.extend(along("", "m"));
        names.extend(turns("angle_rad", ["qx", "qy", "qz", "qw"]));
        names.extend(cables.clone().map(|cable| format!("tension_N_{cable}")));
        names.extend(cables.map(|cable| format!("cable_length_m_{cable}")));
        names.extend(along("v", "m_s"));
        names.extend(turns("omega_rad_s", ["wx_rad_s", "wy_rad_s", "wz_rad_s", ""]));
        Self { names }
    }

    /// Names of the columns.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The first line.
    pub fn header(&self) -> String {
        self.names.join(",") + "\n"
    }

    /// Adds the row of a state; numbers in the shortest form that reads back to the same bits.
    pub fn write_row(&self, plant: &Plant, state: &State, text: &mut String) {
        let (model, twist) = (plant.model(), state.twist());
        let robot = model.robot();
        let mut number = |value: f64| {
            // writing into a String cannot fail; + 0.0: the sign of zero says nothing
            let _ = write!(text, "{},", value + 0.0);
        };
        number(state.time);
        let pattern = robot.motion_pattern;
        match pattern {
            MotionPattern::Spatial => {
                state.pose.position.iter().chain(state.pose.rotation.coords.iter()).for_each(|&value| number(value));
            }
            _ => pattern.pose_to_components(robot.plane, &state.pose).into_iter().for_each(&mut number),
        }
        state.cables.iter().for_each(|cable| number(cable.tension));
        for (index, cable) in state.cables.iter().enumerate() {
            number(model.recorded_length(index, cable.controlled_length));
        }
        model.twist_basis().iter().for_each(|basis| number(basis.dot(&twist)));
        text.pop();
        text.push('\n');
    }
}
