//! Friction of a winch in words.

use cdpr_calibration::friction::{Figure, Solution};
use cdpr_calibration::selection::Warnings;

use super::identification_words::doubt_words;
use crate::number_format::{NONE, significant};
use crate::table::Table;

/// Significant digits of numbers, and of standard deviations.
const DIGITS: (i32, i32) = (4, 2);

/// Doubts, numbers, loads, what is open, what was left out.
pub(super) fn words(solution: &Solution, records: &[String], warnings: &Warnings, width: Option<usize>) -> String {
    let [lifting, lowering] = solution.directions;
    let names = match records {
        [one] => one.clone(),
        many => format!("{} records", many.len()),
    };
    let speeds = solution.speeds.map_or_else(String::new, |[low, high]| format!(" at {low:.3} to {high:.3} rad/s"));
    let mut text = format!("{names}: {lifting} plateaus lift and {lowering} lower{speeds}\n");
    text.push_str(&doubt_words(&warnings.doubts));
    let mut table = Table::new(["quantity", "unit", "value", "± sigma", "95 % interval"]).left_column(1);
    let mut row = |name: &str, unit: &str, figure: Option<Figure>| {
        let Some(figure) = figure else { return };
        let sigma = figure.sigma.map_or_else(|| NONE.to_owned(), |sigma| significant(sigma, DIGITS.1));
        let interval = solution.interval(&figure).map_or_else(
            || NONE.to_owned(),
            |[low, high]| format!("{} … {}", significant(low, DIGITS.0), significant(high, DIGITS.0)),
        );
        table.row(vec![name.to_owned(), unit.to_owned(), significant(figure.value, DIGITS.0), sigma, interval]);
    };
    if let [load] = solution.loads.as_slice() {
        row("load torque", "N·m", load.torque);
    }
    row("scale of given loads", "", solution.load_scale);
    row("offset of given loads", "N·m", solution.load_offset);
    row("Coulomb friction", "N·m", solution.coulomb);
    row("  growth with the load", "", solution.coulomb_by_load);
    row("friction per speed", "N·m·s/rad", solution.viscous);
    row("static friction", "N·m", solution.standing);
    row("Stribeck speed", "rad/s", solution.stribeck_speed);
    text.push_str(&format!("\n{}", table.text(width)));
    text.push_str(&format!(
        "plateaus are {:.2} mN·m (rms) from this law, with {} degrees of freedom\n",
        1e3 * solution.rms,
        solution.freedom
    ));
    if solution.loads.len() > 1 {
        text.push_str(&format!("\n{}", loads(solution, width)));
    }
    text.push_str("\nnot told by these records\n");
    for open in &solution.undetermined {
        text.push_str(&format!("  {}: {}\n", open.quantity.key(), open.reason));
    }
    if !warnings.remarks.is_empty() {
        text.push_str("\nwarnings\n");
        warnings.remarks.iter().for_each(|remark| text.push_str(&format!("  {remark}\n")));
    }
    text
}

/// A row for each load.
fn loads(solution: &Solution, width: Option<usize>) -> String {
    let heads = ["record", "given N·m", "load N·m", "± sigma", "Coulomb N·m", "± sigma", "plateaus"];
    let mut table = Table::new(heads);
    let shown = |value: Option<f64>, digits: i32| value.map_or_else(|| NONE.to_owned(), |own| significant(own, digits));
    for load in &solution.loads {
        table.row(vec![
            (load.record + 1).to_string(),
            shown(load.given, DIGITS.0),
            shown(load.torque.map(|own| own.value), DIGITS.0),
            shown(load.torque.and_then(|own| own.sigma), DIGITS.1),
            shown(load.coulomb.map(|own| own.value), DIGITS.0),
            shown(load.coulomb.and_then(|own| own.sigma), DIGITS.1),
            load.plateaus.to_string(),
        ]);
    }
    table.text(width)
}
