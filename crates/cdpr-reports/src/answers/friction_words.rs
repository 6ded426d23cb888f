//! Friction of a winch in words.

use cdpr_calibration::friction::Figure;

use super::friction_answer::FrictionAnswer;
use super::identification_words::doubt_words;
use crate::number_format::{NONE, significant};
use crate::table::Table;

/// Significant digits of numbers, and of standard deviations.
const DIGITS: (i32, i32) = (4, 2);

/// Doubts, numbers, loads, what is open, what was left out.
pub(super) fn words(answer: &FrictionAnswer, width: Option<usize>) -> String {
    let solution = &answer.solution;
    let [lifting, lowering] = solution.directions;
    let names = match answer.records.as_slice() {
        [one] => one.clone(),
        many => format!("{} records", many.len()),
    };
    let speeds = solution.speeds.map_or_else(String::new, |[low, high]| format!(" at {low:.3} to {high:.3} rad/s"));
    let mut text = format!("{names}: {lifting} plateaus lift and {lowering} lower{speeds}\n");
    text.push_str(&doubt_words(&answer.warnings.doubts));
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
        1e3 * answer.rms_Nm,
        solution.freedom
    ));
    if answer.loads.len() > 1 {
        text.push_str(&format!("\n{}", loads(answer, width)));
    }
    text.push_str("\nnot told by these records\n");
    for open in &answer.undetermined_reasons {
        text.push_str(&format!("  {}: {}\n", open.key, open.reason));
    }
    if !answer.warnings.remarks.is_empty() {
        text.push_str("\nwarnings\n");
        answer.warnings.remarks.iter().for_each(|remark| text.push_str(&format!("  {remark}\n")));
    }
    text
}

/// A row for each load.
fn loads(answer: &FrictionAnswer, width: Option<usize>) -> String {
    let heads = ["record", "given N·m", "load N·m", "± sigma", "Coulomb N·m", "± sigma", "plateaus"];
    let mut table = Table::new(heads);
    let shown = |value: Option<f64>, digits: i32| value.map_or_else(|| NONE.to_owned(), |own| significant(own, digits));
    for load in &answer.loads {
        table.row(vec![
            load.record.to_string(),
            shown(load.given_Nm, DIGITS.0),
            shown(load.load_Nm, DIGITS.0),
            shown(load.load_sigma_Nm, DIGITS.1),
            shown(load.coulomb_Nm, DIGITS.0),
            shown(load.coulomb_sigma_Nm, DIGITS.1),
            load.plateaus.to_string(),
        ]);
    }
    table.text(width)
}
