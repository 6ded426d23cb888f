//! Effects that a robot's file does not support.

use cdpr_model::model::{ModelError, Supported};
use schemars::JsonSchema;
use serde::Serialize;

/// An effect, and the key that the file lacks for it.
#[derive(Serialize, JsonSchema)]
pub(super) struct MissingEffect {
    /// Name of the effect.
    effect: &'static str,
    /// Reason why it is not supported.
    reason: String,
    /// Key that the file lacks.
    #[serde(skip)]
    key: Option<&'static str>,
}

/// All effects that the file does not support.
pub(super) fn missing_effects(supported: &Supported) -> Vec<MissingEffect> {
    let key = |reason: &ModelError| match reason {
        ModelError::MissingKey { key, .. } => Some(*key),
        _ => None,
    };
    let one = |(effect, reason): &(&'static str, ModelError)| MissingEffect {
        effect,
        reason: reason.to_string(),
        key: key(reason),
    };
    supported.missing.iter().map(one).collect()
}

/// A line for people, each effect with the key that it needs; empty where nothing is missing.
pub(super) fn line(missing: &[MissingEffect]) -> String {
    let one = |missing: &MissingEffect| match missing.key {
        Some(key) => format!("{} ({key})", missing.effect),
        None => missing.effect.to_owned(),
    };
    match missing {
        [] => String::new(),
        _ => {
            let all: Vec<String> = missing.iter().map(one).collect();
            format!("not supported     {}; `cdpr model` says how to add them\n", all.join(", "))
        }
    }
}

/// A section for people; empty where nothing is missing.
pub(super) fn section(missing: &[MissingEffect]) -> String {
    let lines: String = missing.iter().map(|one| format!("  {}: {}\n", one.effect, one.reason)).collect();
    if missing.is_empty() { lines } else { format!("\nnot supported\n{lines}") }
}
