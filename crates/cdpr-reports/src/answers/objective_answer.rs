//! Objective of a fit, the errors that it does not look at, and the optima of other objectives.

use cdpr_calibration::fit::Status;
use cdpr_calibration::{Certificate, ErrorBlocks, Loss, Minimize, Objective, ObjectiveValues};
use cdpr_model::geometry::MotionPattern;
use cdpr_model::reading::Keyword;
use cdpr_study::accuracy::Accuracy;
use cdpr_study::{Identification, JudgedOptimum};
use schemars::JsonSchema;
use serde::Serialize;

use crate::figures::{ErrorPanel, ErrorRows};
use crate::keys::{AccuracyKeys, Each, Maybe, OptimumKeys, Word};
use crate::number_format::{cell, significant};
use crate::report::Addition;
use crate::table::Table;

/// Objective of a fit, and the driven errors.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ObjectiveAnswer {
    /// Residuals that were made small.
    #[serde(with = "Word")]
    pub objective: Objective,
    /// Cost of all samples.
    #[serde(with = "Word")]
    pub minimize: Minimize,
    /// The calibrated controller on a machine.
    #[serde(with = "Maybe::<AccuracyKeys>", skip_serializing_if = "Option::is_none")]
    pub driven: Option<Accuracy>,
    /// The controller as given on it.
    #[serde(with = "Maybe::<AccuracyKeys>", skip_serializing_if = "Option::is_none")]
    pub driven_before: Option<Accuracy>,
    /// The model as given and the optimum of every objective, each judged by all.
    #[serde(with = "Each::<OptimumKeys>", skip_serializing_if = "Vec::is_empty")]
    pub objectives: Vec<JudgedOptimum>,
}

impl ObjectiveAnswer {
    /// Doubt about the objective: a controller that drives worse than the one as given.
    pub(super) fn doubt(&self) -> Option<String> {
        let (driven, before) = (self.driven.as_ref()?, self.driven_before.as_ref()?);
        let (after, before) = (driven.position_error_m.mean, before.position_error_m.mean);
        let is_worse = after > before;
        let words = || {
            format!(
                "the calibrated controller drives worse than the one as given: {} instead of {} mm in the mean, whatever it predicts",
                cell(Some(1e3 * after), 3),
                cell(Some(1e3 * before), 3)
            )
        };
        is_worse.then(words)
    }

    /// Tables and sentences.
    pub(super) fn words(&self, found: &Identification, pattern: MotionPattern, width: Option<usize>) -> String {
        let (mut text, fit) = (String::new(), &found.fit);
        if (self.objective, self.minimize) != (Objective::Length, Minimize::Squares) {
            text.push_str(&format!(
                "\nobjective: {} of {}\n",
                self.cost(fit.loss),
                self.residuals(&found.objective_values, pattern)
            ));
        }
        if let Some(certificate) = &fit.certificate {
            text.push_str(&proof(certificate, fit.status != Status::NotConverged));
        }
        if let Some(driven) = &self.driven {
            text.push_str(&format!("\n{}", self.driven_table(driven, pattern, width)));
        }
        if !self.objectives.is_empty() {
            text.push_str(&format!("\n{}", comparison(&self.objectives, pattern, width)));
        }
        text
    }

    /// Part of a page: all optima side by side, else the model as given and the calibrated one on a machine.
    pub(super) fn addition(&self, [before, after]: [&ErrorBlocks; 2], pattern: MotionPattern) -> Option<Addition> {
        let compared = self.objectives.iter().map(|one| (name(one), &one.predicted, one.driven.as_ref()));
        let own = [("as given", before, &self.driven_before), ("calibrated", after, &self.driven)];
        let own = own.map(|(name, predicted, driven)| (name.to_owned(), predicted, driven.as_ref()));
        let rows: Vec<Judged<'_>> = match self.objectives.is_empty() {
            true if self.driven.is_none() => return None,
            true => own.into(),
            false => compared.collect(),
        };
        let refused = self.objectives.iter().filter_map(|one| Some((name(one), one.not_driven.as_ref()?)));
        Some(Addition {
            id: "objectives",
            title: "Errors of the optima",
            gist: gist(&rows),
            sentences: refused.map(|(name, why)| format!("{name} does not drive: {why}.")).collect(),
            figure: figure(&rows, pattern).svg().map(|figure| (figure, FIGURE_WORDS)),
        })
    }

    fn cost(&self, loss: Loss) -> String {
        match (self.minimize, loss) {
            (Minimize::Mean, _) => "mean of the norms".to_owned(),
            (Minimize::Max, _) => "largest norm".to_owned(),
            (_, Loss::Huber | Loss::Cauchy) => format!("sum over samples of the {} loss", loss.name()),
            _ => "sum of squares".to_owned(),
        }
    }

    fn residuals(&self, values: &ObjectiveValues, pattern: MotionPattern) -> String {
        let words = self.objective.residuals();
        match self.objective.counts_rotations() && pattern.has_rotation() {
            true => format!("{words}, rotations by {} m", cell(Some(values.rotation_length_m), 3)),
            false => words.to_owned(),
        }
    }

    fn driven_table(&self, driven: &Accuracy, pattern: MotionPattern, width: Option<usize>) -> String {
        let mut table = Table::new(["driven error", "of", "unit", "before", "after"]).left_column(1).left_column(2);
        let before = self.driven_before.as_ref();
        let mut row =
            |name: &str, of: &str, unit: &str, factor: f64, decimals: usize, value: &dyn Fn(&Accuracy) -> f64| {
                table.row(vec![
                    name.to_owned(),
                    of.to_owned(),
                    unit.to_owned(),
                    cell(before.map(|accuracy| factor * value(accuracy)), decimals),
                    cell(Some(factor * value(driven)), decimals),
                ]);
            };
        row("position", "mean", "mm", 1e3, 3, &|accuracy| accuracy.position_error_m.mean);
        row("", "max", "mm", 1e3, 3, &|accuracy| accuracy.position_error_m.max);
        if pattern.has_rotation() {
            row("rotation", "mean", "°", 1.0_f64.to_degrees(), 4, &|accuracy| accuracy.rotation_error_rad.mean);
            row("", "max", "°", 1.0_f64.to_degrees(), 4, &|accuracy| accuracy.rotation_error_rad.max);
        }
        row("length", "mean", "mm", 1e3, 3, &|accuracy| accuracy.length_error_m.mean_abs);
        table.text(width)
    }
}

/// An optimum with its predicted and driven errors.
type Judged<'a> = (String, &'a ErrorBlocks, Option<&'a Accuracy>);

/// Words below the figure on a page.
const FIGURE_WORDS: &str = "Mean errors. Predicted: poses by the recorded lengths against the measured ones. Driven: the controller on the machine, without noise. Lengths: modelled at the measured poses against the recorded ones, root mean square.";

/// The optimum with the least errors of each kind.
fn gist(rows: &[Judged<'_>]) -> String {
    let least = |read: &dyn Fn(&Judged<'_>) -> Option<f64>| {
        let known = rows.iter().filter_map(|row| Some((read(row).filter(|value| value.is_finite())?, &row.0)));
        known
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(value, name)| format!("{} mm ({name})", significant(1e3 * value, 3)))
    };
    let predicted =
        least(&|row| Some(row.1.position_error_m.mean)).map(|words| format!("least predicted error {words}"));
    let driven = least(&|row| Some(row.2?.position_error_m.mean)).map(|words| format!("least driven {words}"));
    predicted.into_iter().chain(driven).collect::<Vec<_>>().join(", ")
}

fn figure(rows: &[Judged<'_>], pattern: MotionPattern) -> ErrorRows {
    let panel = |label: &str, read: &dyn Fn(&Judged<'_>) -> Option<f64>| ErrorPanel {
        label: label.to_owned(),
        values: rows.iter().map(|row| [read(row).unwrap_or(f64::NAN), f64::NAN]).collect(),
        like: None,
    };
    let like = |first: usize, panel: ErrorPanel| ErrorPanel { like: Some(first), ..panel };
    let mut panels = vec![
        panel("predicted position, mm", &|row| Some(1e3 * row.1.position_error_m.mean)),
        like(0, panel("driven position, mm", &|row| Some(1e3 * row.2?.position_error_m.mean))),
        panel("length, mm", &|row| Some(1e3 * row.1.length_error_m.rms)),
    ];
    if pattern.has_rotation() {
        panels.push(panel("predicted rotation, °", &|row| Some(row.1.rotation_error_rad.mean.to_degrees())));
        panels.push(like(3, panel("driven rotation, °", &|row| Some(row.2?.rotation_error_rad.mean.to_degrees()))));
    }
    ErrorRows {
        label: "Errors of the optima, predicted, driven and of lengths",
        names: rows.iter().map(|row| row.0.clone()).collect(),
        series: ("error", None),
        panels,
    }
}

/// Samples that hold the largest error up.
fn proof(certificate: &Certificate, converged: bool) -> String {
    let names: Vec<String> = certificate.active.iter().map(|active| active.sample.to_string()).collect();
    if !converged {
        return format!(
            "the search for the least largest error stopped before its end: {} samples have the largest now ({}), and it may still fall\n",
            names.len(),
            names.join(", ")
        );
    }
    format!(
        "the largest error is the least near here: {} samples have it ({}), and no change of the parameters makes all of them smaller (gap {:.0e})\n",
        names.len(),
        names.join(", "),
        certificate.gap
    )
}

/// A row for each optimum, a column for each error that judges it.
fn comparison(optima: &[JudgedOptimum], pattern: MotionPattern, width: Option<usize>) -> String {
    let is_driven = optima.iter().any(|optimum| optimum.driven.is_some() || optimum.not_driven.is_some());
    let mut heading = vec!["optimum of", "length rms mm", "mean", "max", "pose rms mm", "mean", "max", "predicted mm"];
    heading.extend(pattern.has_rotation().then_some("°"));
    heading.extend(is_driven.then_some("driven mm"));
    heading.extend((is_driven && pattern.has_rotation()).then_some("° "));
    let mut table = Table::with_heading(heading.into_iter().map(str::to_owned).collect());
    for optimum in optima {
        let values = &optimum.values;
        let norms = [&values.length_norm_m, &values.pose_norm_m].map(|norm| [norm.rms, norm.mean, norm.max]);
        let mut row = vec![name(optimum)];
        row.extend(norms.as_flattened().iter().map(|norm| cell(Some(1e3 * norm), 3)));
        row.push(cell(Some(1e3 * optimum.predicted.position_error_m.mean), 3));
        if pattern.has_rotation() {
            row.push(cell(Some(optimum.predicted.rotation_error_rad.mean.to_degrees()), 4));
        }
        if is_driven {
            let driven = optimum.driven.as_ref();
            row.push(cell(driven.map(|driven| 1e3 * driven.position_error_m.mean), 3));
            if pattern.has_rotation() {
                row.push(cell(driven.map(|driven| driven.rotation_error_rad.mean.to_degrees()), 4));
            }
        }
        table.row(row);
    }
    let mut text = table.text(width)
        + "norms of a sample's length residuals and pose errors; predicted and driven: means over the poses\n";
    for optimum in optima {
        if let Some(reason) = &optimum.not_driven {
            text.push_str(&format!("{} does not drive: {reason}\n", name(optimum)));
        }
    }
    text
}

fn name(optimum: &JudgedOptimum) -> String {
    let Some(of) = optimum.of else { return "(as given)".to_owned() };
    let end = if optimum.converged { "" } else { " (not converged)" };
    format!("{} {}{end}", of.objective.name(), of.minimize)
}
