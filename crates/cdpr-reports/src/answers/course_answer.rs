//! Course of a fit: JSON, words, table and figure.

use cdpr_calibration::CourseStep;
use cdpr_calibration::fit::Estimate;
use schemars::JsonSchema;
use serde::Serialize;

use super::uncertainty_answer::shown;
use crate::figures::{CourseHeight, CoursePanel, Figure, course};
use crate::keys::{CourseStepKeys, Each};
use crate::number_format::{NONE, condition, significant};
use crate::report::Addition;
use crate::table::Table;

/// Steps of a fit with the parameters that they move.
#[derive(Serialize, JsonSchema)]
#[serde(transparent)]
#[schemars(rename = "FitCourse")]
pub struct CourseAnswer {
    #[serde(with = "Each::<CourseStepKeys>")]
    steps: Vec<CourseStep>,
    #[serde(skip)]
    parameters: Vec<Estimate>,
}

/// Rows of the table at most.
const ROWS: usize = 12;
/// Words below the figure on a page.
const FIGURE_WORDS: &str = "Changes of the parameters from the file's values, root mean squares of the rows, and condition of their Jacobian after every step; \
                            named are the parameters that moved most.";

/// Number of a step.
type Read = fn(&CourseStep) -> Option<f64>;
/// Number of a step with its name and unit.
type Column = (&'static str, Read);

const STEP: Column = ("step mm", |step| Some(1e3 * step.step_m?));
const LENGTH: Column = ("lengths mm", |step| Some(1e3 * step.length_rms_m));
const FORCE: Column = ("forces N", |step| step.force_rms);
const MOMENT: Column = ("moments N·m", |step| step.moment_rms);
const POSITION: Column = ("predicted mm", |step| Some(1e3 * step.position_rms_m?));

impl CourseAnswer {
    /// Of steps that move these parameters; `None` without any.
    pub fn new(steps: Vec<CourseStep>, parameters: Vec<Estimate>) -> Option<Self> {
        (!steps.is_empty()).then_some(Self { steps, parameters })
    }

    /// Those columns that have numbers.
    fn columns(&self) -> impl Iterator<Item = Column> {
        let is_there = |(_, read): &Column| self.steps.iter().any(|step| read(step).is_some());
        [STEP, LENGTH, FORCE, MOMENT, POSITION].into_iter().filter(is_there)
    }

    pub(super) fn words(&self, width: Option<usize>) -> String {
        let heading = ["step".to_owned()].into_iter().chain(self.columns().map(|(name, _)| name.to_owned()));
        let conditions = ["condition", "with unit columns"].map(str::to_owned);
        let mut table = Table::with_heading(heading.chain(conditions).collect());
        let last = self.steps.len() - 1;
        for (number, step) in self.steps.iter().enumerate().filter(|(number, _)| *number < ROWS || *number == last) {
            let figure = |(_, read): Column| read(step).map_or_else(|| NONE.to_owned(), |value| significant(value, 4));
            let conditions = [step.condition, step.condition_scaled].map(condition);
            table.row([number.to_string()].into_iter().chain(self.columns().map(figure)).chain(conditions).collect());
        }
        format!(
            "\ncourse: {last} steps, each with the largest change of a parameter in mm of cable; residuals are root mean squares\n\n{}",
            table.text(width)
        )
    }

    /// Part of a page.
    pub(super) fn addition(&self) -> Addition {
        let (first, last) = (&self.steps[0], &self.steps[self.steps.len() - 1]);
        let fall = |(name, read): Column| {
            let (quantity, unit) = name.split_once(' ').unwrap_or((name, ""));
            let ends = [read(first)?, read(last)?].map(|value| significant(value, 3));
            Some(format!("{quantity} {} → {} {unit}", ends[0], ends[1]))
        };
        let falls: Vec<String> = self.columns().skip(1).filter_map(fall).collect();
        Addition {
            id: "course",
            title: "Parameters step by step",
            gist: format!("{} steps: rms of {}", self.steps.len() - 1, falls.join(", ")),
            sentences: Vec::new(),
            figure: self.figure().map(|figure| (figure, FIGURE_WORDS)),
        }
    }

    /// Parameters by kind and unit, rows and condition over the steps (Figs. 4.13–4.15, 6.7, 6.20).
    pub fn figure(&self) -> Option<Figure> {
        let mut panels = self.parameter_panels();
        let panel = |title: &str, unit: &str, reads: &[(&str, Read)], height: CourseHeight| CoursePanel {
            title: title.to_owned(),
            label: unit.to_owned(),
            curves: reads.iter().map(|(name, read)| ((*name).to_owned(), self.curve(*read))).collect(),
            height,
        };
        let has = |(_, read): Column| self.steps.iter().any(|step| read(step).is_some());
        panels.push(panel("length rows", "rms in mm", &[("", LENGTH.1)], CourseHeight::Size));
        if has(FORCE) {
            let curves = [("forces", FORCE.1), ("moments", MOMENT.1)];
            let curves = if has(MOMENT) { &curves[..] } else { &curves[..1] };
            panels.push(panel("wrench rows", "rms in N, N·m", curves, CourseHeight::Size));
        }
        if has(POSITION) {
            panels.push(panel("predicted position", "rms error in mm", &[("", POSITION.1)], CourseHeight::Size));
        }
        let conditions: [(&str, Read); 2] = [
            ("condition, SI units", |step| Some(step.condition)),
            ("condition, columns of one length", |step| Some(step.condition_scaled)),
        ];
        panels.extend(conditions.map(|(title, read)| panel(title, "κ", &[("", read)], CourseHeight::Value)));
        course(&panels)
    }

    fn curve(&self, read: Read) -> Vec<f64> {
        self.steps.iter().map(|step| read(step).unwrap_or(f64::NAN)).collect()
    }

    /// Changes of the parameters, a panel for every kind and unit.
    fn parameter_panels(&self) -> Vec<CoursePanel> {
        let mut panels: Vec<CoursePanel> = Vec::new();
        for (k, parameter) in self.parameters.iter().enumerate() {
            let (unit, factor) = shown(parameter.unit);
            let kind = parameter.parameter.kind.name();
            let label = if unit.is_empty() { "change".to_owned() } else { format!("change in {unit}") };
            let changes = self.steps.iter().map(|step| factor * (step.values[k] - parameter.start)).collect();
            let short = parameter.name.strip_prefix(kind).unwrap_or(&parameter.name).trim_start_matches('.');
            let curve = (short.to_owned(), changes);
            match panels.iter_mut().find(|panel| (&*panel.title, &panel.label) == (kind, &label)) {
                Some(panel) => panel.curves.push(curve),
                None => panels.push(CoursePanel {
                    title: kind.to_owned(),
                    label,
                    curves: vec![curve],
                    height: CourseHeight::Change,
                }),
            }
        }
        panels
    }

    /// Table of the steps, SI (CSV).
    pub fn csv(&self) -> String {
        let own = "step,step_m,length_rms_m,force_rms_N,moment_rms_Nm,position_rms_m,rank,condition,condition_scaled";
        let heading = |estimate: &Estimate| match estimate.unit {
            "" => format!(",{}", estimate.name),
            unit => format!(",{} [{unit}]", estimate.name),
        };
        let mut text = own.to_owned() + &self.parameters.iter().map(heading).collect::<String>() + "\n";
        for (number, step) in self.steps.iter().enumerate() {
            let optional = [step.step_m, Some(step.length_rms_m), step.force_rms, step.moment_rms, step.position_rms_m];
            let mut cells = vec![number.to_string()];
            cells.extend(optional.map(|value| value.map_or_else(String::new, |value| value.to_string())));
            cells.extend([step.rank.to_string(), step.condition.to_string(), step.condition_scaled.to_string()]);
            cells.extend(step.values.iter().map(f64::to_string));
            text.push_str(&format!("{}\n", cells.join(",")));
        }
        text
    }
}
