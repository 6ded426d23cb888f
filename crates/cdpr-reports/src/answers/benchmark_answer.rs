//! Robots and control models under the same rules, beside what is printed of real machines.

use cdpr_model::robot::{PublishedErrors, Robot};
use cdpr_study::benchmark::{Benchmark, BenchmarkErrors, BenchmarkRow, BenchmarkRules};
use minijinja::{Value, context};
use schemars::JsonSchema;
use serde::Serialize;

use super::Answer;
use crate::figures::{ErrorPanel, ErrorRows, Figure};
use crate::html_page::{Page, PageError, PageKind, plain, prose};
use crate::keys::BenchmarkKeys;
use crate::number_format::{NONE, significant};
use crate::table::Table;

const TEMPLATE: &str = include_str!("benchmark.html");

/// The benchmark.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Benchmark")]
pub struct BenchmarkAnswer {
    status: &'static str,
    reason: Option<String>,
    #[serde(flatten, with = "BenchmarkKeys")]
    benchmark: Benchmark,
    /// Errors that the robots' sources print of real machines.
    printed: Vec<PublishedErrors>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    files: Vec<String>,
    warnings: Vec<String>,
}

const COLUMNS: [&str; 11] = [
    "robot",
    "model",
    "poses (measured)",
    "parameters",
    "mean mm",
    "max mm",
    "relative %",
    "rotation °",
    "length mm",
    "tension N",
    "reach %",
];

const PRINTED_COLUMNS: [&str; 5] = ["machine", "mean mm", "rotation °", "length mm", "tension N"];

impl BenchmarkAnswer {
    /// The answer for robots, with the names of the files that are written.
    pub fn new(robots: &[Robot], benchmark: Benchmark, files: Vec<String>) -> Self {
        let reason = benchmark.rows.is_empty().then(|| match benchmark.left_out.first() {
            Some((robot, reason)) => format!("no robot takes part; {robot}: {reason}"),
            None => "no robot supports the models that are asked for".to_owned(),
        });
        let left_out = benchmark.left_out.iter().map(|(robot, reason)| format!("{robot} is left out: {reason}"));
        let failed = benchmark.rows.iter().filter_map(|row| {
            Some(format!("{}, {}: nothing was identified: {}", row.robot, row.model, row.reason.as_ref()?))
        });
        Self {
            status: if reason.is_none() { "done" } else { "nothing" },
            reason,
            warnings: left_out.chain(failed).collect(),
            benchmark,
            printed: published(robots),
            files,
        }
    }

    fn rows(&self) -> Vec<Vec<String>> {
        self.benchmark.rows.iter().map(cells).collect()
    }

    /// Table of all rows and of what is printed (CSV).
    pub fn csv(&self) -> String {
        let kinds = [
            "position_mean_m",
            "position_max_m",
            "position_relative",
            "rotation_mean_rad",
            "length_mean_abs_m",
            "tension_mean_norm_N",
            "reach_share",
        ];
        let mut text = "robot,motion_pattern,cables,machine,model,poses,diagonal_m,parameter_count,samples".to_owned();
        for stage in ["nominal", "identified"] {
            kinds.iter().for_each(|kind| text.push_str(&format!(",{stage}_{kind}")));
        }
        text.push_str(",source\n");
        let number = |value: Option<f64>| {
            value.filter(|value| value.is_finite()).map_or_else(String::new, |value| value.to_string())
        };
        for row in &self.benchmark.rows {
            let BenchmarkRow { robot, motion_pattern, cables, machine, model, poses, diagonal_m, .. } = row;
            text.push_str(&format!(
                "{robot},{motion_pattern},{cables},{machine},{model},{poses},{diagonal_m},{},{}",
                row.parameter_count, row.samples
            ));
            for errors in [Some(row.nominal), row.identified] {
                READS.iter().for_each(|read| text.push_str(&format!(",{}", number(errors.as_ref().and_then(read)))));
            }
            text.push_str(",\n");
        }
        for one in &self.printed {
            let numbers = [
                Some(one.position_mean_m),
                None,
                None,
                one.rotation_mean_rad,
                one.length_mean_abs_m,
                one.tension_mean_norm_N,
            ];
            text.push_str(&format!("\"{}\",,,,,,,,", one.machine));
            numbers.into_iter().for_each(|value| text.push_str(&format!(",{}", number(value))));
            text.push_str(&format!("{}\"{}\"\n", ",".repeat(9), one.source));
        }
        text
    }

    /// Errors of all rows.
    fn figure(&self) -> Option<Figure> {
        let panel = |label: &str, read: fn(&BenchmarkErrors) -> Option<f64>, scale: f64| {
            let value = |row: &BenchmarkRow| {
                let both = [Some(row.nominal), row.identified];
                both.map(|errors| errors.as_ref().and_then(read).map_or(f64::NAN, |value| scale * value))
            };
            ErrorPanel { label: label.to_owned(), values: self.benchmark.rows.iter().map(value).collect(), like: None }
        };
        let figure = ErrorRows {
            label: "Mean errors of every robot under every control model",
            names: self.benchmark.rows.iter().map(|row| format!("{}: {}", row.model, row.robot)).collect(),
            series: ("as the file has it", Some("identified")),
            panels: vec![panel("relative position error, %", |errors| Some(errors.position_relative), 1e2)],
        };
        figure.svg()
    }

    /// The page; `command` makes it again.
    pub fn page(&self, command: &str, version: &str) -> Result<String, PageError> {
        let row = |cells: Vec<String>| context! { cells => cells.iter().map(|cell| prose(cell)).collect::<Vec<_>>() };
        let rows = &self.benchmark.rows;
        let robots: std::collections::BTreeSet<&str> = rows.iter().map(|row| row.robot.as_str()).collect();
        let ratios: Vec<f64> = rows
            .iter()
            .filter_map(|row| Some(row.nominal.position_mean_m / row.identified?.position_mean_m))
            .filter(|ratio| ratio.is_finite())
            .collect();
        let values = context! {
            headline => match median(&ratios) {
                Some(ratio) => format!("Identification divides the mean position error by {} (median)", significant(ratio, 2)),
                None => self.reason.clone().unwrap_or_default(),
            },
            of => format!("{} robots, {} combinations with a control model", robots.len(), rows.len()),
            columns => COLUMNS,
            figure => self.figure().map(|figure| Value::from_safe_string(figure.inline())),
            rows => self.rows().into_iter().map(row).collect::<Vec<Value>>(),
            printed_columns => PRINTED_COLUMNS,
            printed => self.printed.iter().map(|one| row(printed_cells(one))).collect::<Vec<Value>>(),
            rules => rules(&self.benchmark.rules).iter().map(|rule| prose(rule)).collect::<Vec<_>>(),
            warnings => self.warnings.iter().map(|words| prose(words)).collect::<Vec<_>>(),
            command => plain(command),
            seed => self.benchmark.rules.seed,
        };
        let title = "Robots and control models under the same rules";
        Page { kind: PageKind::Benchmark, title, class: "wide", template: TEMPLATE, values, data: None, version }
            .render()
    }
}

/// Errors that the sources of the robots print, each once: files of one machine may share their source.
fn published(robots: &[Robot]) -> Vec<PublishedErrors> {
    let mut all: Vec<PublishedErrors> = Vec::new();
    for errors in robots.iter().filter_map(|robot| robot.source.as_ref()).flat_map(|source| &source.published) {
        if !all.contains(errors) {
            all.push(errors.clone());
        }
    }
    all
}

/// Numbers of errors in the order of the table (CSV).
const READS: [fn(&BenchmarkErrors) -> Option<f64>; 7] = [
    |errors| Some(errors.position_mean_m),
    |errors| Some(errors.position_max_m),
    |errors| Some(errors.position_relative),
    |errors| errors.rotation_mean_rad,
    |errors| Some(errors.length_mean_abs_m),
    |errors| errors.tension_mean_norm_N,
    |errors| Some(errors.reach_share),
];

fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied()
}

/// Cells of a row: both stages of every error.
fn cells(row: &BenchmarkRow) -> Vec<String> {
    let figure = |value: Option<f64>, scale: f64| {
        value.filter(|value| value.is_finite()).map_or(NONE.to_owned(), |value| significant(scale * value, 3))
    };
    let both = |read: fn(&BenchmarkErrors) -> Option<f64>, scale: f64| {
        let nominal = read(&row.nominal);
        match (nominal, &row.identified) {
            (Some(_), Some(errors)) => format!("{} → {}", figure(nominal, scale), figure(read(errors), scale)),
            _ => figure(nominal, scale),
        }
    };
    let [mean, max, relative, rotation, length, tension, reach] = READS;
    vec![
        row.robot.clone(),
        row.model.clone(),
        format!("{} ({})", row.poses, row.samples),
        row.parameter_count.to_string(),
        both(mean, 1e3),
        both(max, 1e3),
        both(relative, 1e2),
        both(rotation, 1.0_f64.to_degrees()),
        both(length, 1e3),
        both(tension, 1.0),
        both(reach, 1e2),
    ]
}

fn printed_cells(one: &PublishedErrors) -> Vec<String> {
    let figure = |value: Option<f64>, scale: f64| value.map_or(NONE.to_owned(), |value| significant(scale * value, 3));
    vec![
        format!("{} ({})", one.machine, one.source),
        figure(Some(one.position_mean_m), 1e3),
        figure(one.rotation_mean_rad, 1.0_f64.to_degrees()),
        figure(one.length_mean_abs_m, 1e3),
        figure(one.tension_mean_norm_N, 1.0),
    ]
}

/// Rules in words.
fn rules(rules: &BenchmarkRules) -> Vec<String> {
    let percent = |share: f64| format!("{} %", significant(1e2 * share, 2));
    vec![
        format!(
            "The machine is the robot with all effects that its file supports and elastic cables in any case: {} strain at the largest tension where the file states \
             no stiffness.",
            percent(rules.strain_at_largest_tension)
        ),
        format!(
            "Its frame anchors are off by {} of their mean distance from their middle, platform anchors by as much of theirs from the origin, stiffnesses by {} (1 σ, \
             anchors per axis).",
            percent(rules.anchor_deviation),
            percent(rules.stiffness_deviation)
        ),
        format!(
            "Poses: a grid of 5 along each translation, 3 along the last of three, over {} of the travel box about the home pose (of the box of the frame anchors where \
             none is stated), and {} poses turned by up to {}°; of these the wrench-feasible ones.",
            percent(rules.box_share),
            rules.turned_poses,
            significant(rules.turn_rad.to_degrees(), 2)
        ),
        format!(
            "Identified from {} of these poses, measured to {} mm and {} mrad, lengths to {} mm, tensions to {} of the largest: frame anchors, of elastic models with \
             compliances. Winches are set at the home pose before, with tensions nearest the middle of the limits.",
            rules.measured_poses,
            significant(1e3 * rules.position_m, 2),
            significant(1e3 * rules.rotation_rad, 2),
            significant(1e3 * rules.length_m, 2),
            percent(rules.tension_share)
        ),
        "Errors are driven on the machine without noise: position and rotation of the platform, lengths as of eq. 6.6, the 2-norm over cables of emerging less \
         commanded tensions; reach is the share of poses at which it rests within its tension limits."
            .to_owned(),
    ]
}

impl Answer for BenchmarkAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut table = Table::new(COLUMNS).left_column(1);
        table.rows(self.rows());
        let mut text = String::from("errors with the numbers of the file → with identified ones\n\n");
        text.push_str(&table.text(width));
        if !self.printed.is_empty() {
            let mut printed = Table::new(PRINTED_COLUMNS);
            printed.rows(self.printed.iter().map(printed_cells));
            text.push_str(&format!("\nprinted of real machines\n\n{}", printed.text(width)));
        }
        text.push('\n');
        rules(&self.benchmark.rules).iter().for_each(|rule| text.push_str(&format!("{rule}\n")));
        self.warnings.iter().for_each(|warning| text.push_str(&format!("caution: {warning}\n")));
        if !self.files.is_empty() {
            text.push_str(&format!("\nwrote {}\n", self.files.join(", ")));
        }
        text
    }
}
