//! Error tables: before and after, and fold by fold.

use cdpr_calibration::ErrorBlocks;
use cdpr_model::control::error_statistics::{LengthErrorStatistics, PoseErrorStatistics, TensionErrorStatistics};
use minijinja::Value;

use super::table::{Cell, Table};
use super::{Report, Shown};
use crate::number_format as number;

/// One line of figures; NaN where a figure does not exist.
struct Figures {
    mean: f64,
    rms: f64,
    median: f64,
    p95: f64,
    max: f64,
}

impl From<PoseErrorStatistics> for Figures {
    fn from(error: PoseErrorStatistics) -> Self {
        let PoseErrorStatistics { mean, rms, median, p95, max } = error;
        Self { mean, rms, median, p95, max }
    }
}

/// A quantity with the way to read and to write it.
struct Quantity {
    title: &'static str,
    read: fn(&ErrorBlocks) -> Figures,
    write: fn(f64) -> String,
    /// Samples that have it.
    samples: fn(&ErrorBlocks) -> usize,
}

impl Quantity {
    /// True where samples have a value, or where none of them has an answer; not where nobody measured it.
    fn is_measured(&self, blocks: &ErrorBlocks) -> bool {
        (self.read)(blocks).mean.is_finite() || (self.samples)(blocks) == 0
    }
}

const POSITION: Quantity = Quantity {
    title: "position, mm",
    read: |e| e.position_error_m.into(),
    write: |value| number::significant(1e3 * value, 3),
    samples: |e| e.answered,
};
const ROTATION: Quantity = Quantity {
    title: "rotation, °",
    read: |e| e.rotation_error_rad.into(),
    write: |value| number::significant(value.to_degrees(), 3),
    samples: |e| e.answered,
};
const LENGTH: Quantity = Quantity {
    title: "cable length, mm",
    read: |e| {
        let length = e.length_error_m;
        Figures { mean: length.mean_abs, rms: length.rms, median: f64::NAN, p95: length.p95, max: length.max }
    },
    write: |value| number::significant(1e3 * value, 3),
    samples: |e| e.length_samples,
};

const SWIVEL: Quantity = Quantity {
    title: "swivel angle, °",
    read: |e| {
        let of = |read: fn(&LengthErrorStatistics) -> f64| e.swivel_error.as_ref().map_or(f64::NAN, read);
        let median = f64::NAN;
        Figures { mean: of(|e| e.mean_abs), rms: of(|e| e.rms), median, p95: of(|e| e.p95), max: of(|e| e.max) }
    },
    write: |value| number::significant(value.to_degrees(), 3),
    samples: |e| e.length_samples,
};

const TENSION: Quantity = Quantity {
    title: "tension, N",
    read: |e| {
        let none = TensionErrorStatistics { mean_norm: f64::NAN, mean_abs: f64::NAN, rms: f64::NAN, max: f64::NAN };
        let TensionErrorStatistics { mean_abs, rms, max, .. } = e.tension_error.unwrap_or(none);
        Figures { mean: mean_abs, rms, median: f64::NAN, p95: f64::NAN, max }
    },
    write: |value| number::significant(value, 3),
    samples: |e| e.answered,
};

/// Errors of the robot as given and of the model shown, on the data of the fit and on validation data.
pub(super) fn before_and_after(report: &Report<'_>, shown: &Shown<'_>) -> Value {
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
        .filter(|(_, data, blocks)| blocks.samples > 0 && (report.is_held_out || *data == "fit"))
        .collect();
    let has_tensions = lines.iter().any(|(_, _, blocks)| blocks.tension_error.is_some());
    let has_swivels = lines.iter().any(|(_, _, blocks)| blocks.swivel_error.is_some());
    let further = has_swivels.then_some(SWIVEL).into_iter().chain(has_tensions.then_some(TENSION));
    for quantity in quantities(report).into_iter().chain(further) {
        if !lines.iter().any(|(_, _, blocks)| quantity.is_measured(blocks)) {
            continue;
        }
        for (index, (model, data, blocks)) in lines.iter().enumerate() {
            let title = if index == 0 { quantity.title } else { "" };
            let mut cells = vec![Cell::text(title), Cell::text(*model), Cell::text(*data)];
            cells.push(Cell::number((quantity.samples)(blocks).to_string()));
            let Figures { mean, rms, median, p95, max } = (quantity.read)(blocks);
            cells.extend([mean, rms, median, p95, max].map(|value| Cell::number((quantity.write)(value))));
            let class = match (index, *model, *data) {
                (_, "calibrated", "validation") => "chosen",
                (_, "calibrated", _) if !report.is_held_out => "chosen",
                (0, ..) => "group",
                _ => "",
            };
            table.push(class, cells);
        }
    }
    table.into_value()
}

fn quantities(report: &Report<'_>) -> Vec<Quantity> {
    match report.robot.motion_pattern.has_rotation() {
        true => vec![POSITION, ROTATION, LENGTH],
        false => vec![POSITION, LENGTH],
    }
}

/// Titles of columns that data without measured poses do not have.
const POSITION_MEAN: &str = "#position mean, mm";
const POSITION_P95: &str = "#position 95 %, mm";

/// Title of a column that point robots do not have either.
const ROTATION_MEAN: &str = "#rotation mean, °";

/// The validation errors of the model shown, fold by fold, and which candidate is best in each.
pub(super) fn folds(report: &Report<'_>, shown: &Shown<'_>) -> Value {
    let has_poses = shown.judgement.folds.iter().any(|(_, blocks)| POSITION.is_measured(blocks));
    let turns = has_poses && report.robot.motion_pattern.has_rotation();
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
        let figures = [
            has_poses.then(|| (POSITION.write)(blocks.position_error_m.mean)),
            has_poses.then(|| (POSITION.write)(blocks.position_error_m.p95)),
            turns.then(|| (ROTATION.write)(blocks.rotation_error_rad.mean)),
            Some((POSITION.write)(blocks.length_error_m.rms)),
            Some(blocks.not_converged.to_string()),
        ];
        let mut cells = vec![Cell::short(name), Cell::number(blocks.samples.to_string())];
        cells.extend(figures.into_iter().flatten().map(Cell::number));
        cells.push(best_in_fold(report, index));
        table.push("", cells);
    }
    table.into_value()
}

fn best_in_fold(report: &Report<'_>, fold: usize) -> Cell {
    let values = report.selection.candidates.iter().filter_map(|candidate| {
        let (_, blocks) = candidate.outcome.as_ref().ok()?.folds.get(fold)?;
        let value = report.criterion.of_blocks(blocks);
        value.is_finite().then_some((value, &candidate.name))
    });
    values.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(Cell::text(number::NONE), |(_, name)| Cell::code(name))
}
