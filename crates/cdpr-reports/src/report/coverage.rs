//! Coverage of the fit: the box of its poses, and errors beyond it against those inside.

use cdpr_calibration::Coverage;
use minijinja::{Value, context};

use super::table::{Cell, Table};
use super::{ReportPage, Shown};
use crate::number_format as number;

/// The ranges as a table, and a sentence about the samples beyond them.
pub(super) fn coverage(page: &ReportPage<'_>, shown: &Shown<'_>) -> Value {
    let coverage = &page.answer.coverage;
    let columns = [
        ("component", "def-component"),
        ("unit", ""),
        ("#fit from", "def-coverage"),
        ("#to", "def-coverage"),
        ("#validation from", "def-data"),
        ("#to", "def-data"),
    ];
    let mut table = Table::new("Ranges of the poses", &columns);
    for range in &coverage.ranges {
        let (factor, unit) = if range.unit == "rad" { (180.0 / std::f64::consts::PI, "°") } else { (1.0, range.unit) };
        let decimals = if range.unit == "rad" { 2 } else { 3 };
        let numbers = [range.fit_min, range.fit_max, range.validation_min, range.validation_max];
        let mut cells = vec![Cell::text(&range.name), Cell::text(unit)];
        cells.extend(numbers.map(|value| Cell::number(number::fixed(factor * value, decimals))));
        table.push("", cells);
    }
    context! { table => table.into_value(), words => words(page, shown, coverage) }
}

/// How many of the judged samples lie beyond, in few words.
pub(super) fn gist(page: &ReportPage<'_>) -> String {
    if !page.report.is_held_out {
        return "nothing was held out".to_owned();
    }
    let coverage = &page.answer.coverage;
    let (outside, count) = (coverage.outside, coverage.is_outside.len());
    match outside {
        0 => format!("all {count} validation samples lie within the poses of the fit"),
        outside => format!("{outside} of {count} validation samples lie outside the poses of the fit"),
    }
}

fn words(page: &ReportPage<'_>, shown: &Shown<'_>, Coverage { outside, is_outside, .. }: &Coverage) -> String {
    if !page.report.is_held_out {
        return "Nothing was held out: how the model does beyond the poses of the fit is not known.".to_owned();
    }
    let count = is_outside.len();
    if *outside == 0 {
        return format!("All {count} validation samples lie within the ranges of the poses that the fit saw.");
    }
    let mean = |wanted: bool| {
        let errors = shown.judgement.validation_errors.position.iter().zip(is_outside);
        let chosen: Vec<f64> =
            errors.filter(|(error, is)| **is == wanted && error.is_finite()).map(|(e, _)| *e).collect();
        match chosen.len() {
            0 => "no value".to_owned(),
            count => format!("{} mm", number::significant(1e3 * chosen.iter().sum::<f64>() / count as f64, 3)),
        }
    };
    format!(
        "{outside} of {count} validation samples lie outside the ranges of the poses that the fit saw. Mean position error: \
         {} inside, {} outside.",
        mean(false),
        mean(true)
    )
}
