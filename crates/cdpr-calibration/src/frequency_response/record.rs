//! Records of what drives a machine and what it answers.

/// Input and output of a machine over time: plain series, from a file, a log or a simulation.
///
/// Both may have any unit and any mean; the response has the output's unit per unit of the input.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// Times (s), rising by equal steps.
    pub times: Vec<f64>,
    /// Commanded input, as the torque of a motor (N·m), at each time; taken as free of noise.
    pub input: Vec<f64>,
    /// Measured output, as the tension of a cable (N), at each time.
    pub output: Vec<f64>,
}
