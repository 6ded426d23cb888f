//! Files of a result: `result.json`, `run.toml`, tables, calibrated robots, `report.html`.

use std::fmt::Write;

use cdpr::identification::selection::{JudgedCandidate, Judgement};
use cdpr::reading::Keyword;
use serde::Serialize;
use sha2::{Digest, Sha256};
use thiserror::Error;

use super::{Comparison, figure_tables};
use crate::NamedFile;
use crate::answers::{Envelope, axis_names, components};
use crate::report::render;

/// A file of a result that could not be put together.
#[derive(Debug, Error)]
#[error("{file} cannot be written: {reason}")]
pub struct UnwritableFile {
    /// Name of the file.
    pub file: &'static str,
    /// Reason of the writer of its format.
    pub reason: Box<dyn std::error::Error>,
}

impl UnwritableFile {
    fn new(file: &'static str, reason: impl std::error::Error + 'static) -> Self {
        Self { file, reason: Box::new(reason) }
    }
}

impl Comparison {
    /// All files by their names in the folder of the result, `result.json` last: a folder that has it is complete.
    pub fn files(&self) -> Result<Vec<NamedFile>, UnwritableFile> {
        let mut all = vec![
            NamedFile::new("run.toml", run_file(self)?),
            NamedFile::new("candidates.csv", candidates_table(self)),
            NamedFile::new("parameters.csv", parameters_table(self)),
            NamedFile::new("validation-errors.csv", errors_table(self)),
            NamedFile::new("outliers.csv", outliers_table(self)),
            NamedFile::new("singular-values.csv", figure_tables::singular_values(self)),
            NamedFile::new("convergence.csv", figure_tables::convergence(self)),
            NamedFile::new("correlations.csv", figure_tables::correlations(self)),
        ];
        all.extend(calibrated_robots(self));
        all.push(NamedFile::new("report.html", report(self)?));
        all.push(NamedFile::new("result.json", result(self)?));
        Ok(all)
    }
}

/// Effective configuration and provenance of a result.
#[derive(Serialize)]
struct Run<'a> {
    version: &'a str,
    command: &'a str,
    seed: u64,
    robot: &'a str,
    data: &'a str,
    validation: &'a str,
    criterion: &'a str,
    candidates: Vec<String>,
    hold: String,
    loss: &'a str,
    weak_direction_limit_m: f64,
    max_iterations: u32,
    prior: Vec<PriorEntry>,
    input: Vec<InputEntry>,
}

#[derive(Serialize)]
struct PriorEntry {
    parameter: &'static str,
    sigma: f64,
}

#[derive(Serialize)]
struct InputEntry {
    file: String,
    sha256: String,
}

/// Robots of all judged candidates, and the recommended one at the top.
fn calibrated_robots(comparison: &Comparison) -> Vec<NamedFile> {
    let mut robots = Vec::new();
    let chosen = comparison.answer().status;
    for (index, candidate) in comparison.selection.candidates.iter().enumerate() {
        let Ok(judgement) = &candidate.outcome else { continue };
        let robot = judgement.fit.model.robot();
        let text = robot.with_calibration(judgement.verdict().fit_status()).to_toml();
        let plain: String =
            candidate.name.chars().map(|c| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' }).collect();
        // names that only differ in brackets differ by their number
        let name = format!("calibrated/{:02}-{}.toml", index + 1, plain.chars().take(100).collect::<String>());
        robots.push(NamedFile::new(name, text));
        if comparison.selection.recommended == Some(index) {
            robots.push(NamedFile::new("calibrated.toml", robot.with_calibration(chosen).to_toml()));
        }
    }
    robots
}

fn run_file(comparison: &Comparison) -> Result<String, UnwritableFile> {
    let settings = &comparison.settings;
    let hash =
        |content: &[u8]| Sha256::digest(content).iter().fold(String::new(), |text, byte| format!("{text}{byte:02x}"));
    let run = Run {
        version: env!("CARGO_PKG_VERSION"),
        command: &comparison.data.command,
        seed: settings.seed,
        robot: &comparison.data.robot.name,
        data: &comparison.data.data_name,
        validation: &comparison.data.validation_name,
        criterion: &settings.criterion.to_string(),
        candidates: comparison.candidates.iter().map(ToString::to_string).collect(),
        hold: settings.fit.hold.to_string(),
        loss: settings.fit.loss.name(),
        weak_direction_limit_m: settings.fit.weak_direction_limit,
        max_iterations: settings.fit.max_iterations,
        prior: settings.fit.priors.iter().map(|p| PriorEntry { parameter: p.kind.name(), sigma: p.sigma }).collect(),
        input: comparison
            .data
            .inputs
            .iter()
            .map(|file| InputEntry { file: file.name.clone(), sha256: hash(&file.content) })
            .collect(),
    };
    toml::to_string(&run).map_err(|error| UnwritableFile::new("run.toml", error))
}

fn result(comparison: &Comparison) -> Result<String, UnwritableFile> {
    Envelope::default().file(&comparison.answer()).map_err(|error| UnwritableFile::new("result.json", error))
}

fn report(comparison: &Comparison) -> Result<String, UnwritableFile> {
    render(&comparison.report()).map_err(|error| UnwritableFile::new("report.html", error))
}

/// Judged candidates with their names.
pub(super) fn judged(comparison: &Comparison) -> impl Iterator<Item = (&JudgedCandidate, &Judgement)> {
    comparison.selection.candidates.iter().filter_map(|candidate| Some((candidate, candidate.outcome.as_ref().ok()?)))
}

/// A field of a table; empty where there is no number.
fn field(value: f64) -> String {
    if value.is_nan() { String::new() } else { value.to_string() }
}

fn candidates_table(comparison: &Comparison) -> String {
    let mut text = String::from(
        "candidate,parameter_count,criterion,standard_error,train_position_mean_m,validation_position_mean_m,\
         validation_rotation_mean_rad,validation_length_rms_m,rank,condition,validation_samples,answered,at_bound,\
         weak_direction_count,weak_direction_deviation_m,loss,outliers\n",
    );
    for (candidate, judgement) in judged(comparison) {
        let (train, validation, analysis) = (&judgement.train, &judgement.validation, &judgement.fit.analysis);
        let errors = [
            judgement.criterion,
            judgement.standard_error,
            train.position_error_m.mean,
            validation.position_error_m.mean,
            validation.rotation_error_rad.mean,
            validation.length_error_m.rms,
        ];
        let _ = writeln!(
            text,
            "\"{}\",{},{},{},{},{},{},{},{},{},{},{}",
            candidate.name,
            judgement.fit.parameters.len(),
            errors.map(field).join(","),
            analysis.rank,
            analysis.condition,
            validation.samples,
            validation.answered,
            judgement.fit.at_bound().count(),
            analysis.weak_direction_count,
            analysis.weak_deviation,
            judgement.fit.loss.name(),
            judgement.fit.outliers.len(),
        );
    }
    text
}

fn parameters_table(comparison: &Comparison) -> String {
    let mut text = String::from("candidate,parameter,unit,start,value,sigma,change,prior_sigma,at_bound\n");
    let optional = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
    for (candidate, judgement) in judged(comparison) {
        for estimate in &judgement.fit.parameters {
            let _ = writeln!(
                text,
                "\"{}\",{},{},{},{},{},{},{},{}",
                candidate.name,
                estimate.name,
                estimate.unit,
                estimate.start,
                estimate.value,
                optional(estimate.sigma),
                estimate.change,
                optional(estimate.prior_sigma),
                estimate.at_bound,
            );
        }
    }
    text
}

/// Outliers of every judged candidate's fit.
fn outliers_table(comparison: &Comparison) -> String {
    let mut text = String::from("candidate,sample,line,residual_m,weight,reason\n");
    for (candidate, judgement) in judged(comparison) {
        for outlier in &judgement.fit.outliers {
            let line = outlier.line.map(|line| line.to_string()).unwrap_or_default();
            let (sample, residual, weight) = (outlier.sample, field(outlier.residual_m), outlier.weight);
            let _ = writeln!(text, "\"{}\",{sample},{line},{residual},{weight},\"{}\"", candidate.name, outlier.reason);
        }
    }
    text
}

/// Errors of the recommended (else the best) candidate, one row per validation sample; of a planar robot along the axes of its plane.
fn errors_table(comparison: &Comparison) -> String {
    let robot = &comparison.data.robot;
    let count = robot.cable_count();
    let lengths: Vec<String> = (1..=count).map(|cable| format!("length_error_m_{cable}")).collect();
    let axes = axis_names(robot);
    let named = |before: &str| axes.iter().map(|axis| format!("{before}{axis}_m")).collect::<Vec<_>>().join(",");
    let (place, shift, lengths) = (named(""), named("d"), lengths.join(","));
    let mut text = format!("sample,{place},position_error_m,{shift},rotation_error_rad,{lengths}\n");
    let Some(judgement) = shown(comparison) else { return text };
    let errors = &judgement.validation_errors;
    for (row, sample) in judgement.validation_samples.iter().enumerate() {
        let fields = |vector| components(robot, &vector).into_iter().map(field).collect::<Vec<_>>().join(",");
        let (place, shift) =
            (fields(comparison.data.samples.poses[*sample].position), fields(errors.position_vector[row].into()));
        let lengths: Vec<String> = errors.length[row * count..][..count].iter().map(|&error| field(error)).collect();
        let (position, rotation) = (field(errors.position[row]), field(errors.rotation[row]));
        let _ = writeln!(text, "{},{place},{position},{shift},{rotation},{}", sample + 1, lengths.join(","));
    }
    text
}

/// The candidate that tables by sample and by pairs of parameters are about: the recommended, else the best one.
pub(super) fn shown(comparison: &Comparison) -> Option<&Judgement> {
    let index = comparison.selection.recommended.or(comparison.selection.best)?;
    comparison.selection.candidates[index].outcome.as_ref().ok()
}
