//! The files that a sweep varies.

use serde::{Deserialize, Serialize};

/// The files that a sweep varies, as TOML text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Subjects {
    /// The study.
    pub study: String,
    /// The robot of the control model.
    pub control: String,
    /// The robot of the machine.
    pub machine: String,
    /// The robot with which the winches were set, where the study names one.
    pub offset_robot: Option<String>,
}
