//! Costs of accuracy: the joined rows of a sweep over calibrations.

use cdpr_study::sweep::{CalibrationOutcome, CalibrationPoint, CalibrationTable, Row};
use schemars::JsonSchema;
use serde::Serialize;

use crate::answers::Answer;
use crate::figures::{CostCurve, CostCurves};
use crate::number_format::{NONE, short, significant};
use crate::table::Table;

/// Calibrations with what they cost and come to.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "CalibrationCosts")]
pub struct CostResult {
    /// Outcome in a word.
    pub status: &'static str,
    /// Why no calibration has an answer.
    pub reason: Option<String>,
    /// Fingerprint of the plan.
    pub plan: String,
    /// Keys of the parameters.
    pub parameters: Vec<String>,
    /// Calibrations in the order of the plan.
    pub rows: Vec<CostRow>,
    /// Cheapest calibration for every accuracy that is wanted.
    pub cheapest: Vec<Cheapest>,
    /// Names of the files written.
    pub files: Vec<String>,
}

/// A calibration.
#[derive(Clone, Serialize, JsonSchema)]
#[schemars(rename = "CostedCalibration")]
pub struct CostRow {
    /// Number of the calibration in the plan, from 0.
    point: usize,
    /// Values of the parameters.
    values: Vec<f64>,
    /// Sensor of the pose.
    sensor: String,
    /// Effects of the control model.
    model: String,
    /// Free parameters.
    free: String,
    /// Number of measured poses.
    poses: usize,
    /// Total price of sensor, model and poses.
    price: f64,
    #[serde(flatten)]
    outcome: Option<CalibrationOutcome>,
    /// Why there is none.
    reason: Option<String>,
}

/// Cheapest calibration for an accuracy.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "CheapestCalibration")]
pub struct Cheapest {
    /// Accuracy that is wanted (m).
    accuracy_m: f64,
    /// Values of the parameters.
    values: Vec<f64>,
    /// Number of the calibration; `None` if none is as accurate.
    point: Option<usize>,
    /// Its price.
    price: Option<f64>,
    /// The same in words.
    words: String,
}

impl CostRow {
    fn of(row: Row, parameters: usize, asked: Option<CalibrationPoint<'_>>) -> Self {
        let values = row.values.iter().copied().take(parameters).collect();
        let Row { point, calibration, reason, .. } = row;
        let of = |own: fn(&CalibrationPoint<'_>) -> String| asked.as_ref().map(own).unwrap_or_default();
        Self {
            point,
            values,
            sensor: of(|asked| asked.sensor.name.clone()),
            model: of(|asked| asked.model.model.clone()),
            free: of(|asked| asked.model.free.clone()),
            poses: asked.map_or(0, |asked| asked.poses),
            price: asked.map_or(0.0, |asked| asked.price),
            outcome: calibration,
            reason,
        }
    }

    fn driven(&self) -> Option<f64> {
        self.outcome.as_ref().map(|outcome| outcome.driven_position_m).filter(|error| error.is_finite())
    }

    fn name(&self) -> String {
        format!("{}, {}", self.sensor, self.model)
    }
}

impl CostResult {
    /// Rows of a plan, named by its fingerprint, with the keys of its parameters and its table of calibrations.
    pub fn new(plan: String, parameters: Vec<String>, table: &CalibrationTable, rows: Vec<Row>) -> Self {
        let count = parameters.len();
        let row = |row: Row| {
            let values = row.values.clone();
            CostRow::of(row, count, table.at(&values))
        };
        let rows: Vec<CostRow> = rows.into_iter().map(row).collect();
        let none = rows.iter().all(|row| row.outcome.is_none());
        let first = rows.iter().find_map(|row| row.reason.clone()).unwrap_or_default();
        let reason = none.then(|| format!("none of {} calibrations has an answer; the first: {first}", rows.len()));
        Self {
            status: if none { "no-answers" } else { "merged" },
            reason,
            plan,
            parameters,
            cheapest: cheapest(&rows, &table.accuracy_m),
            rows,
            files: Vec::new(),
        }
    }

    /// Table of the calibrations (CSV).
    pub fn csv(&self) -> String {
        let mut text = self.parameters.iter().map(|key| format!("\"{key}\",")).collect::<String>();
        text.push_str(
            "sensor,model,free,poses,price,parameter_count,validation_position_m,validation_length_m,driven_position_m,driven_position_max_m,\
             driven_rotation_rad,driven_tension_N,reason\n",
        );
        let number = |value: Option<f64>| {
            value.filter(|value| value.is_finite()).map_or_else(String::new, |value| value.to_string())
        };
        let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        for row in &self.rows {
            let own = |read: fn(&CalibrationOutcome) -> Option<f64>| number(row.outcome.as_ref().and_then(read));
            let mut cells: Vec<String> = row.values.iter().map(f64::to_string).collect();
            cells.extend([quoted(&row.sensor), quoted(&row.model), quoted(&row.free)]);
            cells.extend([row.poses.to_string(), row.price.to_string()]);
            cells.push(row.outcome.as_ref().map_or_else(String::new, |one| one.parameter_count.to_string()));
            cells.extend([
                own(|one| one.validation_position_m),
                own(|one| Some(one.validation_length_m)),
                own(|one| Some(one.driven_position_m)),
                own(|one| Some(one.driven_position_max_m)),
                own(|one| Some(one.driven_rotation_rad)),
                own(|one| one.driven_tension_N),
                row.reason.as_deref().map_or_else(String::new, quoted),
            ]);
            text.push_str(&format!("{}\n", cells.join(",")));
        }
        text
    }

    /// Drawing of the driven error over the number of poses (SVG), where there is no further parameter.
    pub fn figure(&self) -> Option<String> {
        if !self.parameters.is_empty() {
            return None;
        }
        let mut curves: Vec<CostCurve> = Vec::new();
        for row in &self.rows {
            let Some(driven) = row.driven() else { continue };
            let point = (row.poses as f64, 1e3 * driven);
            match curves.iter_mut().find(|curve| curve.name == row.name()) {
                Some(curve) => curve.points.push(point),
                None => curves.push(CostCurve { name: row.name(), points: vec![point] }),
            }
        }
        curves.iter_mut().for_each(|curve| curve.points.sort_by(|a, b| a.0.total_cmp(&b.0)));
        CostCurves { curves, wanted: self.cheapest.iter().map(|one| 1e3 * one.accuracy_m).collect() }
            .svg()
            .map(|figure| figure.file())
    }
}

/// Cheapest rows of every set of values within each accuracy; of equal prices the more accurate one.
fn cheapest(rows: &[CostRow], wanted: &[f64]) -> Vec<Cheapest> {
    let mut sets: Vec<&[f64]> = Vec::new();
    rows.iter().for_each(|row| {
        if !sets.contains(&row.values.as_slice()) {
            sets.push(&row.values);
        }
    });
    let of = |values: &[f64], accuracy: f64| {
        let own = rows.iter().filter(|row| row.values == values);
        let best = own.clone().filter_map(|row| Some((row, row.driven()?)));
        let within = best.clone().filter(|(_, driven)| *driven <= accuracy);
        let cheaper =
            |a: &(&CostRow, f64), b: &(&CostRow, f64)| a.0.price.total_cmp(&b.0.price).then(a.1.total_cmp(&b.1));
        let found = within.min_by(cheaper);
        let asked = format!("{} mm", short(1e3 * accuracy));
        let words = match found {
            Some((row, driven)) => format!(
                "for {asked}: {} poses by {}, model {} ({}), at a price of {}: {} mm driven",
                row.poses,
                row.sensor,
                row.model,
                row.free,
                short(row.price),
                significant(1e3 * driven, 3)
            ),
            None => match best.min_by(|a, b| a.1.total_cmp(&b.1)) {
                Some((row, driven)) => format!(
                    "for {asked}: none of these; the best, {} mm, has {} poses by {}, model {}",
                    significant(1e3 * driven, 3),
                    row.poses,
                    row.sensor,
                    row.model
                ),
                None => format!("for {asked}: none of these has an answer"),
            },
        };
        let (point, price) = (found.map(|(row, _)| row.point), found.map(|(row, _)| row.price));
        Cheapest { accuracy_m: accuracy, values: values.to_vec(), point, price, words }
    };
    sets.iter().flat_map(|values| wanted.iter().map(|&accuracy| of(values, accuracy))).collect()
}

impl Answer for CostResult {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut heading = self.parameters.clone();
        heading.extend(
            ["sensor", "model", "poses", "price", "parameters", "validation mm", "driven mm", "max mm"]
                .map(str::to_owned),
        );
        let mut table = Table::with_heading(heading);
        for row in &self.rows {
            let own = |read: fn(&CalibrationOutcome) -> Option<f64>| {
                let value = row.outcome.as_ref().and_then(read).filter(|value| value.is_finite());
                value.map_or_else(|| NONE.to_owned(), |value| significant(1e3 * value, 3))
            };
            let mut cells: Vec<String> = row.values.iter().map(|value| significant(*value, 5)).collect();
            cells.extend([row.sensor.clone(), row.model.clone(), row.poses.to_string(), short(row.price)]);
            cells.push(row.outcome.as_ref().map_or_else(|| NONE.to_owned(), |one| one.parameter_count.to_string()));
            cells.extend([
                own(|one| one.validation_position_m),
                own(|one| Some(one.driven_position_m)),
                own(|one| Some(one.driven_position_max_m)),
            ]);
            table.row(cells);
        }
        let mut text = format!(
            "mean position errors: on another record by the same sensors, and driven on the machine without noise\n\n{}\n",
            table.text(width)
        );
        for one in &self.cheapest {
            let at: Vec<String> =
                self.parameters.iter().zip(&one.values).map(|(key, value)| format!("{key} = {value}: ")).collect();
            text.push_str(&format!("{}{}\n", at.concat(), one.words));
        }
        if let Some(reason) = self.rows.iter().find_map(|row| row.reason.as_ref()) {
            let failed = self.rows.iter().filter(|row| row.reason.is_some()).count();
            text.push_str(&format!("{failed} calibrations have no answer, the first because {reason}\n"));
        }
        text.push_str(&format!("\nwrote {}\n", self.files.join(", ")));
        text
    }
}
