//! Numbers of a robot that no source states and nobody measured, as answers tell them.

use cdpr_model::robot::Assumption;

/// A section for people; empty where nothing is assumed.
pub(super) fn section(heading: &str, assumptions: &[Assumption]) -> String {
    let lines: String = assumptions.iter().map(|one| format!("  {}: {}\n", one.key, one.reason)).collect();
    if assumptions.is_empty() { lines } else { format!("\n{heading}\n{lines}") }
}

/// The same in a line.
pub(super) fn line(assumptions: &[Assumption]) -> String {
    assumptions.iter().map(|one| format!("{} ({})", one.key, one.reason)).collect::<Vec<_>>().join("; ")
}
