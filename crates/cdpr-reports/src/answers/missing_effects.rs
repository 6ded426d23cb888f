//! Effects that a robot's file does not support.

use cdpr_model::model::Supported;
use serde::Serialize;

/// An effect, and the key that the file lacks for it.
#[derive(Serialize)]
pub(super) struct MissingEffect {
    effect: &'static str,
    reason: String,
}

/// All effects that the file does not support.
pub(super) fn missing_effects(supported: &Supported) -> Vec<MissingEffect> {
    supported.missing.iter().map(|(effect, reason)| MissingEffect { effect, reason: reason.to_string() }).collect()
}

/// A section for people; empty where nothing is missing.
pub(super) fn section(missing: &[MissingEffect]) -> String {
    let lines: String = missing.iter().map(|one| format!("  {}: {}\n", one.effect, one.reason)).collect();
    if missing.is_empty() { lines } else { format!("\nnot supported\n{lines}") }
}
