//! The files varied by a sweep.

use serde::{Deserialize, Serialize};

/// The files varied by a sweep, as TOML text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Subjects {
    /// The study.
    pub study: String,
    /// The robot of the control model.
    pub control: String,
    /// The robot of the machine.
    pub machine: String,
    /// The robot with which the winches were set; `None` if the study names none.
    pub offset_robot: Option<String>,
}
