//! Files of a result: `result.json`, `run.toml`, tables, calibrated robots, `report.html`.

use cdpr_model::reading::Keyword;
use serde::Serialize;
use sha2::{Digest, Sha256};
use thiserror::Error;

use super::{Comparison, tables};
use crate::NamedFile;
use crate::answers::Envelope;
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
            NamedFile::new("candidates.csv", tables::candidates(self)),
            NamedFile::new("parameters.csv", tables::parameters(self)),
            NamedFile::new("validation-errors.csv", tables::errors(self)),
            NamedFile::new("outliers.csv", tables::outliers(self)),
            NamedFile::new("singular-values.csv", tables::singular_values(self)),
            NamedFile::new("convergence.csv", tables::convergence(self)),
            NamedFile::new("correlations.csv", tables::correlations(self)),
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
