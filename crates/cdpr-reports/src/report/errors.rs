//! Error tables: before and after, and fold by fold.

use cdpr_calibration::ErrorBlocks;
use minijinja::Value;

use super::table::{Cell, Table};
use super::{ReportPage, Shown};
use crate::answers::{Quantity, Statistics, named, quantities};
use crate::number_format as number;

/// Title of a quantity with its unit.
fn title(quantity: &Quantity) -> String {
    let name = match quantity.name {
        "length" => "cable length",
        "swivel" => "swivel angle",
        other => other,
    };
    format!("{name}, {}", quantity.unit)
}

/// A statistic in the unit for people; a dash for none.
fn figure(quantity: &Quantity, statistics: &Statistics, name: &str) -> String {
    number::significant(named(statistics, name).map_or(f64::NAN, |value| quantity.factor * value), 3)
}

/// Samples that have the quantity.
fn samples(quantity: &Quantity, blocks: &ErrorBlocks) -> usize {
    if ["length", "swivel"].contains(&quantity.name) { blocks.length_samples } else { blocks.answered }
}

/// True where samples have a value, or where none of them has an answer; not where nobody measured it.
fn is_measured(quantity: &Quantity, blocks: &ErrorBlocks) -> bool {
    let mean = (quantity.read)(blocks).and_then(|statistics| named(&statistics, "mean"));
    mean.is_some_and(f64::is_finite) || samples(quantity, blocks) == 0
}

/// Errors of the robot as given and of the model shown, on the data of the fit and on validation data.
pub(super) fn before_and_after(page: &ReportPage<'_>, shown: &Shown<'_>) -> Value {
    let columns = [
        ("error", "def-errors"),
        ("model", ""),
        ("data", "def-data"),
        ("#samples", ""),
        ("#mean", "def-mean"),
        ("#rms", "def-rms"),
        ("#median", "def-median"),
        ("#95 %", "def-p95"),
        ("#largest", "def-max"),
    ];
    let mut table = Table::new("Errors before and after calibration", &columns);
    let given = shown.before();
    let lines = given.into_iter().map(|given| ("as given", given.judgement)).chain([("calibrated", shown.judgement)]);
    let lines: Vec<_> = lines
        .flat_map(|(model, judgement)| [(model, "fit", &judgement.train), (model, "validation", &judgement.validation)])
        .filter(|(_, data, blocks)| blocks.samples > 0 && (page.report.is_held_out || *data == "fit"))
        .collect();
    let [position, rotation, length, tension, swivel] = quantities();
    let turns = page.report.robot.motion_pattern.has_rotation();
    let has = |quantity: &Quantity| lines.iter().any(|(_, _, blocks)| (quantity.read)(blocks).is_some());
    for quantity in [position, rotation, length, swivel, tension] {
        let is_shown = has(&quantity) && (turns || quantity.name != "rotation");
        if !is_shown || !lines.iter().any(|(_, _, blocks)| is_measured(&quantity, blocks)) {
            continue;
        }
        for (index, (model, data, blocks)) in lines.iter().enumerate() {
            let title = if index == 0 { title(&quantity) } else { String::new() };
            let statistics = (quantity.read)(blocks).unwrap_or_default();
            let mut cells = vec![Cell::text(title), Cell::text(*model), Cell::text(*data)];
            cells.push(Cell::number(samples(&quantity, blocks).to_string()));
            let names = ["mean", "rms", "median", "p95", "max"];
            cells.extend(names.map(|name| Cell::number(figure(&quantity, &statistics, name))));
            let class = match (index, *model, *data) {
                (_, "calibrated", "validation") => "chosen",
                (_, "calibrated", _) if !page.report.is_held_out => "chosen",
                (0, ..) => "group",
                _ => "",
            };
            table.push(class, cells);
        }
    }
    table.into_value()
}

/// Titles of columns that data without measured poses do not have.
const POSITION_MEAN: &str = "#position mean, mm";
const POSITION_P95: &str = "#position 95 %, mm";

/// Title of a column that point robots do not have either.
const ROTATION_MEAN: &str = "#rotation mean, °";

/// The validation errors of the model shown, fold by fold, and which candidate is best in each.
pub(super) fn folds(page: &ReportPage<'_>, shown: &Shown<'_>) -> Value {
    let [position, rotation, ..] = quantities();
    let has_poses = shown.judgement.folds.iter().any(|(_, blocks)| is_measured(&position, blocks));
    let turns = has_poses && page.report.robot.motion_pattern.has_rotation();
    let mut columns = vec![
        ("fold", "def-fold"),
        ("#samples", ""),
        (POSITION_MEAN, "def-mean"),
        (POSITION_P95, "def-p95"),
        (ROTATION_MEAN, "def-mean"),
        ("#length rms, mm", "def-rms"),
        ("#not converged", "def-not-converged"),
        ("best candidate in it", "def-criterion"),
    ];
    columns.retain(|(title, _)| match *title {
        ROTATION_MEAN => turns,
        POSITION_MEAN | POSITION_P95 => has_poses,
        _ => true,
    });
    let mut table = Table::new(format!("Validation errors of `{}` fold by fold", shown.name), &columns);
    for (index, (name, blocks)) in shown.judgement.folds.iter().enumerate() {
        let write = |quantity: &Quantity, value: f64| number::significant(quantity.factor * value, 3);
        let figures = [
            has_poses.then(|| write(&position, blocks.position_error_m.mean)),
            has_poses.then(|| write(&position, blocks.position_error_m.p95)),
            turns.then(|| write(&rotation, blocks.rotation_error_rad.mean)),
            Some(write(&position, blocks.length_error_m.rms)),
            Some(blocks.not_converged.to_string()),
        ];
        let mut cells = vec![Cell::short(name), Cell::number(blocks.samples.to_string())];
        cells.extend(figures.into_iter().flatten().map(Cell::number));
        cells.push(best_in_fold(page, index));
        table.push("", cells);
    }
    table.into_value()
}

fn best_in_fold(page: &ReportPage<'_>, fold: usize) -> Cell {
    let values = page.answer.candidates.iter().filter_map(|candidate| {
        let (_, blocks) = candidate.judged?.folds.get(fold)?;
        let value = page.answer.criterion.of_blocks(blocks);
        value.is_finite().then_some((value, candidate.name))
    });
    values.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(Cell::text(number::NONE), |(_, name)| Cell::code(name))
}
