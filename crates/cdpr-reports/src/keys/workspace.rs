//! Workspaces.

use cdpr_workspace::Audit;
use schemars::JsonSchema;
use serde::Serialize;

use super::adapters::tables;

/// Random points at which the result of a method is judged.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Audit")]
#[schemars(rename = "RandomPoints")]
pub(crate) struct AuditKeys {
    /// Points drawn.
    points: u64,
    /// Points that belong to the workspace.
    feasible_points: u64,
    /// Points of the workspace that the result leaves out.
    missed: u64,
    /// Points of the result that do not belong to the workspace.
    added: u64,
}

tables!(AuditKeys: Audit);
