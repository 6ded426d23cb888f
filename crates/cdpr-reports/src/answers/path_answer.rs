//! Path of a penalty: JSON, words and figure.

use cdpr_calibration::selection::SelectionCriterion;
use cdpr_calibration::{PathParameter, PathPoint, PathSettings, Penalty, PenaltyPath, Towards};
use cdpr_model::model::FreeParameters;
use schemars::JsonSchema;
use serde::Serialize;

use crate::figures::{Figure, PathCurves};
use crate::keys::{Each, PathParameterKeys, PathPointKeys, Shown, Word};
use crate::number_format::{cell, condition, significant};
use crate::report::Addition;
use crate::table::Table;

/// Path of a penalty with its choice.
#[derive(Serialize, JsonSchema)]
pub struct PathAnswer {
    /// Penalties from large to small, with what they lead to.
    #[serde(with = "Each::<PathPointKeys>")]
    pub path: Vec<PathPoint>,
    /// Parameters in the order of the values.
    #[serde(with = "Each::<PathParameterKeys>")]
    pub path_parameters: Vec<PathParameter>,
    /// The penalty and the choice.
    pub path_choice: PathChoice,
    #[serde(skip)]
    criterion: SelectionCriterion,
}

/// Choice of cross-validation.
#[derive(Serialize, JsonSchema)]
pub struct PathChoice {
    /// The penalty.
    #[serde(with = "Word")]
    pub penalty: Penalty,
    /// Its centre.
    #[serde(with = "Word")]
    pub towards: Towards,
    /// Parameters that it acts on; empty: all that are free.
    #[serde(with = "Shown")]
    pub shrink: FreeParameters,
    /// Data held out, in words.
    pub held_out: String,
    /// λ of the least error.
    pub best_lambda: Option<f64>,
    /// Largest λ that is as good on the same samples.
    pub chosen_lambda: Option<f64>,
    /// Parameters that stay at the centre there.
    pub left: Vec<String>,
    /// File of the robot there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub out: Option<String>,
}

/// Rows of a table of the path at most, those marked besides.
const ROWS: usize = 10;
/// Words below the figure on a page.
const FIGURE_WORDS: &str = "Changes of all penalised parameters over the penalty, strong ones left; numbers above: parameters off the centre. Below: mean error on data held out, with its standard error.";
/// Parameters that are named before the rest is counted.
const NAMED: usize = 12;

impl PathAnswer {
    /// Of a path with the data that judged it.
    pub fn new(found: &PenaltyPath, settings: &PathSettings, held_out: String, out: Option<String>) -> Self {
        let lambda = |place: Option<usize>| place.map(|place| found.points[place].lambda);
        let path_choice = PathChoice {
            penalty: settings.penalty,
            towards: settings.towards,
            shrink: settings.shrink.clone(),
            held_out,
            best_lambda: lambda(found.best),
            chosen_lambda: lambda(found.chosen),
            left: found.left.clone(),
            out,
        };
        Self {
            path: found.points.clone(),
            path_parameters: found.parameters.clone(),
            path_choice,
            criterion: settings.criterion,
        }
    }

    fn unit(&self) -> &'static str {
        if self.path_choice.penalty == Penalty::Ridge { "1/m²" } else { "1/m" }
    }

    fn centre(&self) -> &'static str {
        match self.path_choice.towards {
            Towards::Zero => "zero",
            _ => "the file's values",
        }
    }

    fn place(&self, lambda: Option<f64>) -> Option<usize> {
        let lambda = lambda?;
        self.path.iter().position(|point| point.lambda == lambda)
    }

    pub(super) fn words(&self, width: Option<usize>) -> String {
        let PathChoice { penalty, held_out, out, .. } = &self.path_choice;
        let (best, chosen) = (self.place(self.path_choice.best_lambda), self.place(self.path_choice.chosen_lambda));
        let mut text = format!("\npath: {penalty} towards {}, judged by {held_out}\n\n", self.centre());
        text.push_str(&self.table([best, chosen], width));
        text.push_str(&self.choice_words());
        if let Some(out) = out {
            text.push_str(&format!("robot at the chosen λ written to {out}\n"));
        }
        text
    }

    /// The choice and what leaves.
    fn choice_words(&self) -> String {
        let PathChoice { penalty, left, chosen_lambda, .. } = &self.path_choice;
        let Some(chosen) = self.place(*chosen_lambda) else {
            return "no λ is chosen: no place of the path predicts the data held out\n".to_owned();
        };
        let point = &self.path[chosen];
        let (count, all) = (point.parameter_count, self.path_parameters.len());
        let mut text = format!(
            "chosen: λ = {} {}, the largest that is as good as the best on the same samples: {}\n",
            condition(point.lambda),
            self.unit(),
            match *penalty {
                Penalty::Ridge => "a ridge leaves no parameter out".to_owned(),
                _ => format!("{count} of {all} parameters"),
            }
        );
        if !left.is_empty() {
            text.push_str(&format!("left at {}: {}\n", self.centre(), named(left)));
        }
        text
    }

    /// Part of a page.
    pub(super) fn addition(&self) -> Addition {
        let PathChoice { penalty, held_out, .. } = &self.path_choice;
        Addition {
            id: "path",
            title: "Path of a penalty",
            gist: format!("{penalty} towards {}, judged by {held_out}", self.centre()),
            sentences: self.choice_words().lines().map(str::to_owned).collect(),
            figure: self.figure().map(|figure| (figure, FIGURE_WORDS)),
        }
    }

    fn table(&self, [best, chosen]: [Option<usize>; 2], width: Option<usize>) -> String {
        let criterion = self.criterion;
        let error = format!("{criterion} {}", criterion.unit());
        let lambda = format!("λ in {}", self.unit());
        let heading = [lambda.as_str(), "parameters", "χ²", &error, "±", ""].map(str::to_owned).to_vec();
        let mut table = Table::with_heading(heading).left_column(5);
        let last = self.path.len().saturating_sub(1);
        let stride = self.path.len().div_ceil(ROWS).max(1);
        for (k, point) in self.path.iter().enumerate() {
            if k % stride != 0 && k != last && Some(k) != best && Some(k) != chosen {
                continue;
            }
            let note = match (Some(k) == best, Some(k) == chosen) {
                (true, true) => "best, chosen",
                (true, false) => "best",
                (false, true) => "chosen",
                _ if !point.converged => "not converged",
                _ => "",
            };
            let figure = |value: Option<f64>| cell(value.map(|value| criterion.in_unit(value)), 3);
            table.row(vec![
                condition(point.lambda),
                point.parameter_count.to_string(),
                significant(point.squares, 5),
                figure(point.validation),
                figure(point.standard_error),
                note.to_owned(),
            ]);
        }
        table.text(width)
    }

    /// Changes over λ, and the errors below them.
    pub fn figure(&self) -> Option<Figure> {
        let above = self.path.iter().filter(|point| point.lambda > 0.0).count();
        let points = &self.path[..above];
        let kind = |name: &str| name.split(['[', '.']).next().unwrap_or(name).to_owned();
        let of = |k: usize| points.iter().map(|point| 1e3 * point.changes_m[k]).collect::<Vec<f64>>();
        let penalised = self.path_parameters.iter().enumerate().filter(|(_, one)| one.is_penalised);
        let criterion = self.criterion;
        let figure = |value: Option<f64>| value.map_or(f64::NAN, |value| criterion.in_unit(value));
        let curves = PathCurves {
            unit: self.unit(),
            lambdas: points.iter().map(|point| point.lambda).collect(),
            counts: points.iter().map(|point| point.parameter_count).collect(),
            parameters: penalised.map(|(k, one)| (kind(&one.name), one.name.clone(), of(k))).collect(),
            centre: self.centre(),
            errors: points.iter().map(|point| (figure(point.validation), figure(point.standard_error))).collect(),
            error_label: format!("held-out error in {}", criterion.unit()),
            marked: self
                .place(self.path_choice.best_lambda)
                .zip(self.place(self.path_choice.chosen_lambda))
                .map(|(best, chosen)| [best, chosen]),
        };
        curves.svg()
    }
}

/// The first names, and how many more.
fn named(names: &[String]) -> String {
    let more = names.len().saturating_sub(NAMED);
    let rest = if more > 0 { format!(" and {more} more (see --format json)") } else { String::new() };
    names[..names.len() - more].join(", ") + &rest
}
