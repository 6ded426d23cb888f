//! The path on which a machine with hysteresis in its cables comes to a pose.

use serde::{Deserialize, Serialize};

use crate::model::Model;

/// Path on which a machine with hysteresis comes to the poses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct History {
    /// Pose that each pose is reached from.
    pub reach: Reach,
    /// Steps of the way to each pose, straight and evenly turning; 10 when missing.
    #[schemars(range(min = 1, max = 1000))]
    pub sub_steps: u32,
}

impl Default for History {
    fn default() -> Self {
        Self { reach: Reach::FromInitial, sub_steps: 10 }
    }
}

/// Pose that each pose is reached from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Reach {
    /// From the initial pose, where the winches were set, each time anew.
    #[default]
    FromInitial,
    /// From the pose before, in the order of the poses; the first one from the initial pose.
    InOrder,
}

impl History {
    /// History of a machine: as stated, by default from the initial pose; `None` if its cables have no memory.
    pub fn of(machine: &Model, stated: Option<Self>) -> Option<Self> {
        let remembers = machine.composition().stretch.remembers();
        remembers.then(|| stated.unwrap_or_default())
    }
}
