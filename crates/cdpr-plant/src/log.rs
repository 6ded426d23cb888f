//! The log of a run as CSV: one row per record, in the columns of measurement files.

use std::fmt::Write;

use super::plant::{Plant, Winches};
use super::state::PlantState;
use cdpr_model::geometry::MotionPattern;
use cdpr_model::measurement::{pose_columns, pose_numbers, position_columns};

/// Columns of a log: `t_s`, the pose as in measurement files, tensions and recorded lengths, then the twist; of drums whether they stand
/// (`stuck_k`, 1 or 0: held by friction, a brake or a stop) and the torque of [`Plant::friction_torque`] (`friction_torque_Nm_k`).
#[derive(Clone, Debug, PartialEq)]
pub struct LogFormat {
    names: Vec<String>,
}

impl LogFormat {
    /// The columns for a machine.
    pub fn new(plant: &Plant) -> Self {
        let (robot, cables) = (plant.model().robot(), 1..=plant.model().cable_count());
        let mut names = vec!["t_s".to_owned()];
        names.extend(pose_columns(robot));
        names.extend(cables.clone().map(|cable| format!("tension_N_{cable}")));
        names.extend(cables.clone().map(|cable| format!("cable_length_m_{cable}")));
        names.extend(position_columns(robot, "m_s").into_iter().map(|name| format!("v{name}")));
        let turns: &[&str] = match robot.motion_pattern {
            MotionPattern::Planar => &["omega_rad_s"],
            MotionPattern::Spatial => &["wx_rad_s", "wy_rad_s", "wz_rad_s"],
            _ => &[],
        };
        names.extend(turns.iter().map(|name| (*name).to_owned()));
        if plant.winches() == Winches::Drums {
            names.extend(cables.clone().map(|cable| format!("stuck_{cable}")));
            names.extend(cables.map(|cable| format!("friction_torque_Nm_{cable}")));
        }
        Self { names }
    }

    /// Count of numbers in a row.
    pub(super) fn column_count(&self) -> usize {
        self.names.len()
    }

    /// The header line.
    pub fn header(&self) -> String {
        self.names.join(",") + "\n"
    }

    /// Adds the row of a state; numbers in the shortest form that reads back to the same bits.
    pub fn write_row(&self, plant: &Plant, state: &PlantState, text: &mut String) {
        let (model, twist) = (plant.model(), state.twist());
        let robot = model.robot();
        let mut number = |value: f64| {
            // writing into a String cannot fail; + 0.0 turns −0 into 0
            let _ = write!(text, "{},", value + 0.0);
        };
        number(state.time);
        pose_numbers(robot, &state.pose).into_iter().for_each(&mut number);
        state.cables.iter().for_each(|cable| number(cable.tension));
        for (index, cable) in state.cables.iter().enumerate() {
            number(model.recorded_length(index, cable.controlled_length));
        }
        model.twist_basis().iter().for_each(|basis| number(basis.dot(&twist)));
        if plant.winches() == Winches::Drums {
            state.cables.iter().for_each(|cable| number(f64::from(u8::from(cable.is_stuck))));
            (0..state.cables.len()).filter_map(|drum| plant.friction_torque(state, drum)).for_each(number);
        }
        text.pop();
        text.push('\n');
    }
}
