//! Objective of a fit, the errors that it does not look at, and the optima of other objectives.

use cdpr::geometry::MotionPattern;
use cdpr::identification::{Certificate, JudgedOptimum, Minimize, Objective, ObjectiveValues};
use cdpr::metamodel::accuracy::Accuracy;
use serde::Serialize;

use crate::number_format::cell;
use crate::table::Table;

/// Objective of a fit with the values of all objectives, and the driven errors.
#[derive(Clone, Debug, Serialize)]
pub struct ObjectiveAnswer {
    /// Residuals that were made small.
    pub objective: Objective,
    /// Cost of all samples.
    pub minimize: Minimize,
    /// Values of every objective on the samples of the fit, after and before.
    pub objective_values: ObjectiveValues,
    /// The same of the model as given.
    pub objective_values_before: ObjectiveValues,
    /// Proof of the least largest error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub certificate: Option<Certificate>,
    /// Whether the search of the fit ended at an optimum.
    #[serde(skip)]
    pub converged: bool,
    /// The calibrated controller on a machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub driven: Option<Accuracy>,
    /// The controller as given on it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub driven_before: Option<Accuracy>,
    /// The model as given and the optimum of every objective, each judged by all.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub objectives: Vec<JudgedOptimum>,
}

impl ObjectiveAnswer {
    /// Doubts about the objective.
    pub(super) fn doubts(&self) -> Vec<String> {
        let (Some(driven), Some(before)) = (&self.driven, &self.driven_before) else { return Vec::new() };
        let (after, before) = (driven.position_error_m.mean, before.position_error_m.mean);
        let is_worse = after > before;
        let words = || {
            format!(
                "the calibrated controller drives worse than the one as given: {} instead of {} mm in the mean, whatever it predicts",
                cell(Some(1e3 * after), 3),
                cell(Some(1e3 * before), 3)
            )
        };
        is_worse.then(words).into_iter().collect()
    }

    /// Tables and sentences.
    pub(super) fn words(&self, pattern: MotionPattern, width: Option<usize>) -> String {
        let mut text = String::new();
        if (self.objective, self.minimize) != (Objective::Length, Minimize::Squares) {
            text.push_str(&format!("\nobjective: {} of {}\n", self.cost(), self.residuals(pattern)));
        }
        if let Some(certificate) = &self.certificate {
            text.push_str(&proof(certificate, self.converged));
        }
        if let Some(driven) = &self.driven {
            text.push_str(&format!("\n{}", self.driven_table(driven, pattern, width)));
        }
        if !self.objectives.is_empty() {
            text.push_str(&format!("\n{}", comparison(&self.objectives, pattern, width)));
        }
        text
    }

    fn cost(&self) -> &'static str {
        match self.minimize {
            Minimize::Mean => "mean of the norms",
            Minimize::Max => "largest norm",
            _ => "sum of squares",
        }
    }

    fn residuals(&self, pattern: MotionPattern) -> String {
        match self.objective {
            Objective::Pose if pattern.has_rotation() => {
                let length = self.objective_values.rotation_length_m;
                format!("the errors of predicted poses, rotations by {} m", cell(Some(length), 3))
            }
            Objective::Pose => "the errors of predicted poses".to_owned(),
            Objective::Both => "lengths and poses in their accuracies, the poses unknown".to_owned(),
            _ => "the length residuals".to_owned(),
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
