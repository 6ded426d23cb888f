//! Starts of a fit and the optima they led to, in words.

use cdpr_calibration::Starts;

use crate::number_format::{cell, significant};
use crate::table::Table;

/// Optima that a table shows before it refers to the others.
const MOST_OPTIMA: usize = 10;

/// A sentence where all starts agree, else a table of optima; empty for one start.
pub(super) fn start_words(starts: &Starts, width: Option<usize>) -> String {
    let Starts { count, unconverged, optima, .. } = starts;
    if *count <= 1 {
        return String::new();
    }
    let summary = summary(starts);
    if optima.len() < 2 {
        return format!("\n{summary}\n");
    }
    let mut table = Table::new(["optimum", "cost", "starts", "share %", "spread mm", "from the best mm"]);
    for (place, optimum) in optima.iter().take(MOST_OPTIMA).enumerate() {
        table.row(vec![
            (place + 1).to_string(),
            significant(optimum.cost, 5),
            optimum.starts.to_string(),
            cell(Some(100.0 * optimum.fraction), 0),
            significant(1e3 * optimum.spread_m, 2),
            significant(1e3 * optimum.distance_m, 4),
        ]);
    }
    let more = match optima.len().saturating_sub(MOST_OPTIMA) {
        0 => String::new(),
        more => format!("and {more} more (see --format json)\n"),
    };
    let failed =
        if *unconverged > 0 { format!("{unconverged} of {count} starts did not converge\n") } else { String::new() };
    format!("\n{summary}\n{}{more}{failed}", table.text(width))
}

/// How many starts led to how many optima.
pub(crate) fn summary(starts: &Starts) -> String {
    let Starts { count, unconverged, optima, .. } = starts;
    let drawn = match starts.ranges.is_empty() {
        true => String::new(),
        false => format!(" (the file's values, others by a Sobol sequence: {})", starts.ranges.join(", ")),
    };
    match &optima[..] {
        [] => format!("none of {count} starts{drawn} converged"),
        [one] if *unconverged == 0 => {
            format!("all {count} starts{drawn} led to one optimum, to {} mm", significant(1e3 * one.spread_m, 2))
        }
        [one] => format!(
            "{} of {count} starts{drawn} led to one optimum, to {} mm; the others did not converge",
            one.starts,
            significant(1e3 * one.spread_m, 2)
        ),
        _ => format!("{count} starts{drawn} led to {} optima; the one with the lowest cost is reported", optima.len()),
    }
}
