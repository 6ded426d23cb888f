//! A record of measurements, and the CSV that a logger makes of it.

use crate::pose::{Pose, quaternion, roll_pitch_yaw, transposed};
use crate::robots::RobotName;

/// One sample.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// Time (s).
    pub(crate) time: f64,
    /// The pose as measured.
    pub(crate) pose: Pose,
    /// The lengths as recorded (m).
    pub(crate) lengths: Vec<f64>,
    /// The tensions as recorded (N); empty without sensors of tension.
    pub(crate) tensions: Vec<f64>,
    /// Word of the column `set`.
    pub(crate) set: Option<&'static str>,
}

/// How orientations are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Turns {
    /// Quaternion as the columns say it.
    Quaternion,
    /// The scalar stands in the column `qx`.
    ScalarFirst,
    /// World to platform.
    Inverted,
    /// Angles of R = Rz Ry Rx in the columns of R = Rx Ry Rz.
    RollPitchYaw,
}

/// How rows become text.
#[derive(Clone, Debug)]
pub(crate) struct Style {
    /// Ending of the columns of positions.
    pub(crate) position_unit: &'static str,
    /// Factors of the positions, by axis.
    pub(crate) position_factors: [f64; 3],
    pub(crate) turns: Turns,
    pub(crate) with_poses: bool,
    /// Number of the first cable.
    pub(crate) first_cable: usize,
    pub(crate) tension_factor: f64,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            position_unit: "m",
            position_factors: [1.0; 3],
            turns: Turns::Quaternion,
            with_poses: true,
            first_cable: 1,
            tension_factor: 1.0,
        }
    }
}

/// Rows of one file.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    pub(crate) robot: RobotName,
    pub(crate) rows: Vec<Row>,
    pub(crate) style: Style,
}

impl Record {
    /// Line of the file that a row stands in.
    pub(crate) fn line(row: usize) -> usize {
        row + 2
    }

    pub(crate) fn csv(&self) -> String {
        let mut text = self.header().join(",") + "\n";
        for row in &self.rows {
            let numbers = self.numbers(row).into_iter().map(|number| format!("{number:.9}"));
            let words = row.set.map(str::to_owned);
            text += &(numbers.chain(words).collect::<Vec<_>>().join(",") + "\n");
        }
        text
    }

    fn has_turns(&self) -> bool {
        self.robot.freedom().turns && self.style.with_poses
    }

    fn header(&self) -> Vec<String> {
        let mut names = vec!["t_s".to_owned()];
        let unit = self.style.position_unit;
        if self.style.with_poses {
            names.extend(self.robot.freedom().axes.iter().map(|&axis| format!("{}_{unit}", ["x", "y", "z"][axis])));
        }
        if self.has_turns() {
            let turns: &[&str] = match self.style.turns {
                Turns::RollPitchYaw => &["rx_rad", "ry_rad", "rz_rad"],
                _ => &["qx", "qy", "qz", "qw"],
            };
            names.extend(turns.iter().map(|&name| name.to_owned()));
        }
        let (first, row) = (self.style.first_cable, self.rows.first());
        let counted = |name: &str, count: usize| -> Vec<String> {
            (first..first + count).map(|cable| format!("{name}_{cable}")).collect()
        };
        names.extend(counted("cable_length_m", row.map_or(0, |row| row.lengths.len())));
        names.extend(counted("tension_N", row.map_or(0, |row| row.tensions.len())));
        names.extend(row.and_then(|row| row.set).map(|_| "set".to_owned()));
        names
    }

    fn numbers(&self, row: &Row) -> Vec<f64> {
        let style = &self.style;
        let mut numbers = vec![row.time];
        if style.with_poses {
            let axes = self.robot.freedom().axes;
            numbers.extend(axes.iter().map(|&axis| row.pose.position[axis] * style.position_factors[axis]));
        }
        if self.has_turns() {
            let rotation = &row.pose.rotation;
            let [x, y, z, w] = quaternion(rotation);
            match style.turns {
                Turns::Quaternion => numbers.extend([x, y, z, w]),
                Turns::ScalarFirst => numbers.extend([w, x, y, z]),
                Turns::Inverted => numbers.extend(quaternion(&transposed(rotation))),
                Turns::RollPitchYaw => numbers.extend(roll_pitch_yaw(rotation)),
            }
        }
        numbers.extend(&row.lengths);
        numbers.extend(row.tensions.iter().map(|tension| tension * style.tension_factor));
        numbers
    }
}
