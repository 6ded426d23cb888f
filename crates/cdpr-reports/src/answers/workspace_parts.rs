//! Parts of the answer about a workspace.

use schemars::JsonSchema;
use serde::Serialize;

/// A structure matrix of less than full rank wherever the criteria hold.
#[derive(Clone, Copy, Serialize, JsonSchema)]
pub(super) struct Singular {
    /// Rank of the structure matrix.
    pub(super) rank: usize,
    /// Number of degrees of freedom.
    pub(super) degrees_of_freedom: usize,
}

/// A size, or null where there is none; left out where the robot has the other kind.
#[derive(Default, Serialize, JsonSchema)]
#[serde(untagged)]
#[schemars(rename = "Size")]
pub(super) enum Unless {
    #[default]
    #[serde(skip)]
    Other,
    Size(Option<f64>),
}

impl Unless {
    /// True where the key is left out.
    pub(super) fn is_other(&self) -> bool {
        matches!(self, Self::Other)
    }
}
