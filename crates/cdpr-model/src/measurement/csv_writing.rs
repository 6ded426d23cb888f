//! Writer of measurement CSV files.

use std::fmt::Write;

use super::{Samples, pose_columns, pose_numbers};
use crate::robot::Robot;

impl Samples {
    /// The samples as a measurement CSV; numbers in the shortest form that reads back to the same bits.
    pub fn to_csv(&self, robot: &Robot) -> String {
        let mut names = pose_columns(robot);
        let recorded = if self.motor_angles.is_some() { "motor_angle_rad" } else { "cable_length_m" };
        names.extend((1..=self.cable_count).map(|cable| format!("{recorded}_{cable}")));
        if self.tensions.is_some() {
            names.extend((1..=self.cable_count).map(|cable| format!("tension_N_{cable}")));
        }
        names.extend(self.set.is_some().then(|| "set".to_owned()));
        names.extend(self.time.is_some().then(|| "t_s".to_owned()));
        let mut text = names.join(",");
        text.push('\n');
        for sample in 0..self.len() {
            text.push_str(&self.row(robot, sample).join(","));
            text.push('\n');
        }
        text
    }

    fn row(&self, robot: &Robot, sample: usize) -> Vec<String> {
        let number = |value: f64| {
            let mut text = String::new();
            let _ = write!(text, "{value}"); // writing into a String cannot fail
            text
        };
        let mut fields: Vec<String> = pose_numbers(robot, &self.poses[sample]).into_iter().map(number).collect();
        let of_cables = |values: &[f64]| values[sample * self.cable_count..][..self.cable_count].to_vec();
        fields.extend(of_cables(self.motor_angles.as_ref().unwrap_or(&self.lengths)).into_iter().map(number));
        fields.extend(self.tensions.iter().flat_map(|tensions| of_cables(tensions)).map(number));
        fields.extend(self.set.iter().map(|set| set[sample].clone()));
        fields.extend(self.time.iter().map(|time| number(time[sample])));
        fields
    }
}
