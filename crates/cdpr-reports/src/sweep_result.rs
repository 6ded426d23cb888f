//! The joined rows of a sweep: answer, table and drawing.

use cdpr_study::sweep::Row;
use schemars::JsonSchema;
use serde::Serialize;

use crate::answers::{Answer, BEYOND_THE_WHOLE, Size, is_beyond_the_whole};
use crate::figures::{ShareCurve, Shares};
use crate::keys::SweepRowKeys;
use crate::keys::table_schema::{ByAccuracySize, PhysicalSize, ReachableSize};
use crate::number_format::{short, significant};
use crate::table::Table;

/// Rows of all points of a sweep.
#[derive(Serialize, JsonSchema)]
pub struct SweepResult {
    /// Outcome in a word.
    pub status: &'static str,
    /// Why no point has an answer.
    pub reason: Option<String>,
    /// Fingerprint of the plan.
    pub plan: String,
    /// Keys of the parameters.
    pub parameters: Vec<String>,
    /// Largest position errors that were asked for.
    pub position_error_max_m: Vec<f64>,
    /// Points in the order of the plan.
    pub rows: Vec<SweepPoint>,
    /// Names of the files written.
    pub files: Vec<String>,
    /// Remark on shares above 100 %.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remark: Option<&'static str>,
    #[serde(skip)]
    is_planar: bool,
}

/// A point of a sweep with its shares.
#[derive(Serialize, JsonSchema)]
pub struct SweepPoint {
    /// Values and cells.
    #[serde(flatten, with = "SweepRowKeys")]
    pub row: Row,
    /// Reachable with each largest position error.
    #[serde(flatten)]
    #[schemars(with = "ByAccuracySize")]
    by_accuracy: Size<Vec<f64>>,
    #[serde(flatten)]
    #[schemars(with = "PhysicalSize")]
    physical: Size,
    #[serde(flatten)]
    #[schemars(with = "ReachableSize")]
    reachable: Size,
    /// Size reached whatever the error, as a share of the physical workspace.
    pub share: Option<f64>,
    /// The same with each largest position error.
    pub share_by_accuracy: Vec<Option<f64>>,
}

impl SweepPoint {
    fn of(row: Row, is_planar: bool) -> Self {
        let whole = row.physical.filter(|whole| *whole > 0.0);
        let share = |size: f64| whole.map(|whole| size / whole);
        let size = |name, value| Size { name, is_planar, value };
        Self {
            by_accuracy: Size { name: "by_accuracy", is_planar, value: row.by_accuracy.clone() },
            physical: size("physical", row.physical),
            reachable: size("reachable", row.reachable),
            share: row.reachable.and_then(share),
            share_by_accuracy: row.by_accuracy.iter().map(|size| share(*size)).collect(),
            row,
        }
    }
}

impl SweepResult {
    /// Rows of a plan, named by its fingerprint, for a robot in a plane or in space, with the keys of its parameters and the largest position errors asked for (m).
    pub fn new(
        plan: String,
        is_planar: bool,
        parameters: Vec<String>,
        position_error_max_m: Vec<f64>,
        rows: Vec<Row>,
    ) -> Self {
        let rows: Vec<SweepPoint> = rows.into_iter().map(|row| SweepPoint::of(row, is_planar)).collect();
        let is_beyond = rows.iter().any(|row| is_beyond_the_whole(row.share));
        let reason = nowhere(&rows);
        Self {
            status: if reason.is_none() { "merged" } else { "no-answers" },
            reason,
            plan,
            parameters,
            position_error_max_m,
            is_planar,
            remark: is_beyond.then_some(BEYOND_THE_WHOLE),
            rows,
            files: Vec::new(),
        }
    }

    /// Table of the points (CSV).
    pub fn csv(&self) -> String {
        let mut text = self.parameters.iter().map(|key| format!("\"{key}\"")).collect::<Vec<_>>().join(",");
        let [physical, reachable] =
            ["physical", "reachable"].map(|name| Size { name, is_planar: self.is_planar, value: () }.key());
        text.push_str(&format!(",{physical},{reachable},share"));
        for most in &self.position_error_max_m {
            text.push_str(&format!(",share_within_{most}_m"));
        }
        text.push_str(",reason\n");
        let number = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
        for SweepPoint { row, share, share_by_accuracy, .. } in &self.rows {
            let mut cells: Vec<String> = row.values.iter().map(f64::to_string).collect();
            cells.extend([number(row.physical), number(row.reachable), number(*share)]);
            let thresholds = 0..self.position_error_max_m.len();
            cells.extend(thresholds.map(|index| number(share_by_accuracy.get(index).copied().flatten())));
            cells.push(
                row.reason.as_ref().map_or_else(String::new, |reason| format!("\"{}\"", reason.replace('"', "\"\""))),
            );
            text.push_str(&format!("{}\n", cells.join(",")));
        }
        text
    }

    /// Drawing of the shares over the parameter (SVG), where there is just one.
    pub fn figure(&self) -> Option<String> {
        let [key] = self.parameters.as_slice() else { return None };
        let points = |share: &dyn Fn(&SweepPoint) -> Option<f64>| -> Vec<(f64, f64)> {
            self.rows.iter().filter_map(|row| Some((row.row.values[0], share(row)?))).collect()
        };
        let mut curves = vec![ShareCurve { name: "any error".to_owned(), points: points(&|row| row.share) }];
        for (index, most) in self.position_error_max_m.iter().enumerate() {
            let name = format!("{} mm", short(1e3 * most));
            curves
                .push(ShareCurve { name, points: points(&|row| row.share_by_accuracy.get(index).copied().flatten()) });
        }
        Shares { parameter: axis_label(key), curves }.svg().map(|figure| figure.file())
    }
}

impl Answer for SweepResult {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut heading = self.parameters.clone();
        heading.push("any error".to_owned());
        heading.extend(self.position_error_max_m.iter().map(|most| format!("{} mm", significant(1e3 * most, 3))));
        let mut table = Table::with_heading(heading);
        let percent =
            |share: &Option<f64>| share.map_or_else(|| "–".to_owned(), |share| format!("{:.1} %", 100.0 * share));
        for SweepPoint { row, share, share_by_accuracy, .. } in &self.rows {
            let mut cells: Vec<String> = row.values.iter().map(|value| significant(*value, 5)).collect();
            cells.push(percent(share));
            cells.extend(
                (0..self.position_error_max_m.len())
                    .map(|index| percent(&share_by_accuracy.get(index).copied().flatten())),
            );
            table.row(cells);
        }
        let mut text = format!("reached share of the physical workspace\n\n{}", table.text(width));
        if let Some(remark) = &self.remark {
            text.push_str(&format!("\n{remark}\n"));
        }
        if let Some(reason) = self.rows.iter().find_map(|row| row.row.reason.as_ref()) {
            let failed = self.rows.iter().filter(|row| row.row.reason.is_some()).count();
            text.push_str(&format!("\n{failed} points have no answer, the first because {reason}\n"));
        }
        text.push_str(&format!("\nwrote {}\n", self.files.join(", ")));
        text
    }
}

/// Why no point of the sweep has an answer, by the first of them.
fn nowhere(rows: &[SweepPoint]) -> Option<String> {
    let first = rows.first()?.row.reason.as_deref()?;
    let is_none = rows.iter().all(|row| row.row.reason.is_some());
    is_none.then(|| format!("none of {} points has an answer; the first: {first}", rows.len()))
}

/// A key as the label of an axis: its last word with its unit, and whose it is.
fn axis_label(key: &str) -> String {
    let (owner, name) = key.rsplit_once('.').map_or(("", key), |(owner, name)| (owner, name));
    let (name, entry) = name.split_once('[').map_or((name, String::new()), |(name, entry)| (name, format!("[{entry}")));
    let (words, unit) = match name.rsplit_once('_') {
        Some((words, unit @ ("m" | "N" | "rad" | "kg"))) => (words, format!(" in {unit}")),
        Some((words, "Nm")) => (words, " in N·m".to_owned()),
        _ => (name, String::new()),
    };
    let owner = if owner.is_empty() { String::new() } else { format!(" ({owner})") };
    format!("{}{entry}{unit}{owner}", words.replace('_', " "))
}

#[cfg(test)]
mod tests {
    use super::axis_label;

    #[test]
    fn axes_of_sweeps_name_their_unit_and_whose_number_it_is() {
        assert_eq!(axis_label("both.cable[*].axial_stiffness_EA_N"), "axial stiffness EA in N (both.cable[*])");
        assert_eq!(axis_label("study.initial.tension_limits_N[2]"), "tension limits[2] in N (study.initial)");
        assert_eq!(axis_label("placed_pulley_radius_m"), "placed pulley radius in m");
        assert_eq!(axis_label("machine.platform.mass"), "mass (machine.platform)");
    }
}
