//! Records of a winch at constant speeds.

/// Speed and torque of a motor that lifts and lowers a load, row by row.
///
/// With times the rows are samples, in which stretches of constant speed are looked for; without them each row is the mean of such
/// a stretch, unless many rows follow each other at the same speed as samples do.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// Line of each row in its file, or its number.
    pub lines: Vec<usize>,
    /// Speeds of the motor, lifting positive (rad/s).
    pub speeds: Vec<f64>,
    /// Torques of the motor, against the load positive (N·m).
    pub torques: Vec<f64>,
    /// Torques of the hanging load, m g r (N·m).
    pub loads: Option<Vec<f64>>,
    /// Times (s); where they jump back another run begins.
    pub times: Option<Vec<f64>>,
    /// Positions of the motor, lifting positive (rad); they judge the speeds.
    pub positions: Option<Vec<f64>>,
    /// Numbers of runs; where the number changes another run begins.
    pub runs: Option<Vec<f64>>,
    /// Masses that hang (kg), or any other number of loads whose torques are not given: rows with the same number have the same load.
    pub masses: Option<Vec<f64>>,
}

impl Record {
    /// A table of plateaus: a row is the mean speed (rad/s) and torque (N·m) of one; `loads` are those of the rows (N·m).
    pub fn of_plateaus(speeds: Vec<f64>, torques: Vec<f64>, loads: Option<Vec<f64>>) -> Self {
        Self { lines: (1..=speeds.len()).collect(), speeds, torques, loads, ..Self::default() }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.speeds.len()
    }

    /// True without a row.
    pub fn is_empty(&self) -> bool {
        self.speeds.is_empty()
    }
}
