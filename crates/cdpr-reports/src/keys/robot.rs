//! Robots and their files.

use cdpr_model::robot::caspr::{Finding, Loss};
use serde::Serialize;

use super::Word;
use super::adapters::tables;

/// Element of another program's model that the robot lacks wholly or in part.
#[derive(Serialize)]
#[serde(remote = "Finding")]
pub(crate) struct FindingKeys {
    #[serde(with = "Word")]
    loss: Loss,
    element: String,
    name: Option<String>,
    file: String,
    line: usize,
    why: String,
}

tables!(FindingKeys: Finding);
