//! The folder of a result: `result.json`, `run.toml`, tables, calibrated robots, `report.html`.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use cdpr::identification::selection::{Judged, Judgement};
use serde::Serialize;
use sha2::{Digest, Sha256};

use super::{Compared, figure_tables};
use crate::failure::Failure;
use crate::files;
use cdpr_reports::answers::Envelope;
use cdpr_reports::report::render;

/// A file by its name in the folder.
pub(crate) struct NamedFile {
    pub(crate) name: String,
    pub(crate) content: Vec<u8>,
}

impl NamedFile {
    pub(crate) fn new(name: impl Into<String>, content: impl Into<Vec<u8>>) -> Self {
        Self { name: name.into(), content: content.into() }
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

/// Writes the result into a folder, which is made where it does not exist; files of the same names are replaced, and calibrated robots
/// of a former result go.
///
/// All files are written before the first is put in its place; `result.json` comes last, so that a folder that has it is
/// complete. Of two processes that write into one folder the second waits for the first.
pub(crate) fn write_folder(folder: &Path, compared: &Compared, more: Vec<NamedFile>) -> Result<(), Failure> {
    let mut all = more;
    all.push(NamedFile::new("run.toml", run_file(compared)?));
    all.push(NamedFile::new("candidates.csv", candidates_table(compared)));
    all.push(NamedFile::new("parameters.csv", parameters_table(compared)));
    all.push(NamedFile::new("validation-errors.csv", errors_table(compared)));
    all.push(NamedFile::new("singular-values.csv", figure_tables::singular_values(compared)));
    all.push(NamedFile::new("convergence.csv", figure_tables::convergence(compared)));
    all.push(NamedFile::new("correlations.csv", figure_tables::correlations(compared)));
    all.extend(calibrated_robots(compared));
    all.push(NamedFile::new("report.html", report(compared)?));
    all.push(NamedFile::new("result.json", result(compared)?));
    let _own = files::OwnFolder::make(folder)?;
    files::make_folder(&folder.join("calibrated"))?;
    let paths: Vec<PathBuf> = all.iter().map(|file| folder.join(&file.name)).collect();
    let pairs: Vec<(&Path, &[u8])> =
        paths.iter().map(PathBuf::as_path).zip(all.iter().map(|file| &file.content[..])).collect();
    files::write_all(&pairs)?;
    remove_former(folder, &paths)
}

/// Removes the calibrated robots that another result left here: they are named as ours are, and none of ours.
fn remove_former(folder: &Path, ours: &[PathBuf]) -> Result<(), Failure> {
    let calibrated = folder.join("calibrated");
    let unreadable = |error: std::io::Error| Failure::io("read", &calibrated.display().to_string(), &error);
    let mut former = vec![folder.join("calibrated.toml")];
    for entry in std::fs::read_dir(&calibrated).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let is_numbered = name
            .split_once('-')
            .is_some_and(|(number, _)| number.len() >= 2 && number.chars().all(|digit| digit.is_ascii_digit()));
        if is_numbered && name.ends_with(".toml") {
            former.push(path);
        }
    }
    for path in former.iter().filter(|path| !ours.contains(*path)) {
        match std::fs::remove_file(path) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                return Err(Failure::io("remove", &path.display().to_string(), &error));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Robots of all judged candidates, and the recommended one at the top.
fn calibrated_robots(compared: &Compared) -> Vec<NamedFile> {
    let mut robots = Vec::new();
    for (index, candidate) in compared.selection.candidates.iter().enumerate() {
        let Ok(judgement) = &candidate.outcome else { continue };
        let text = judgement.fit.model.robot().to_toml();
        let plain: String =
            candidate.name.chars().map(|c| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' }).collect();
        // names that only differ in brackets differ by their number
        let name = format!("calibrated/{:02}-{}.toml", index + 1, plain.chars().take(100).collect::<String>());
        robots.push(NamedFile::new(name, text.clone()));
        if compared.selection.recommended == Some(index) {
            robots.push(NamedFile::new("calibrated.toml", text));
        }
    }
    robots
}

fn run_file(compared: &Compared) -> Result<String, Failure> {
    let settings = &compared.settings;
    let hash =
        |content: &[u8]| Sha256::digest(content).iter().fold(String::new(), |text, byte| format!("{text}{byte:02x}"));
    let run = Run {
        version: env!("CARGO_PKG_VERSION"),
        command: &compared.comparison.command,
        seed: settings.seed,
        robot: &compared.comparison.robot.name,
        data: &compared.comparison.data_name,
        validation: &compared.comparison.validation_name,
        criterion: settings.criterion.words(),
        candidates: compared.candidates.iter().map(ToString::to_string).collect(),
        hold: settings.fit.hold.to_string(),
        weak_direction_limit_m: settings.fit.weak_direction_limit,
        max_iterations: settings.fit.max_iterations,
        prior: settings.fit.priors.iter().map(|p| PriorEntry { parameter: p.kind.name(), sigma: p.sigma }).collect(),
        input: compared
            .comparison
            .inputs
            .iter()
            .map(|file| InputEntry { file: file.name.clone(), sha256: hash(&file.content) })
            .collect(),
    };
    toml::to_string(&run).map_err(|error| Failure::unwritable("run.toml", &error))
}

fn result(compared: &Compared) -> Result<String, Failure> {
    Envelope::default().file(&compared.answer()).map_err(|error| Failure::unwritable("result.json", &error))
}

fn report(compared: &Compared) -> Result<String, Failure> {
    render(&compared.told()).map_err(|error| Failure::unwritable("report.html", &error))
}

/// Judged candidates with their names.
pub(super) fn judged(compared: &Compared) -> impl Iterator<Item = (&Judged, &Judgement)> {
    compared.selection.candidates.iter().filter_map(|candidate| Some((candidate, candidate.outcome.as_ref().ok()?)))
}

/// A field of a table; empty where there is no number.
fn field(value: f64) -> String {
    if value.is_nan() { String::new() } else { value.to_string() }
}

fn candidates_table(compared: &Compared) -> String {
    let mut text = String::from(
        "candidate,parameter_count,criterion,standard_error,train_position_mean_m,validation_position_mean_m,\
         validation_rotation_mean_rad,validation_length_rms_m,rank,condition,validation_samples,answered,at_bound,\
         weak_direction_count,weak_direction_deviation_m\n",
    );
    for (candidate, judgement) in judged(compared) {
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
            "\"{}\",{},{},{},{},{},{},{},{},{}",
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
        );
    }
    text
}

fn parameters_table(compared: &Compared) -> String {
    let mut text = String::from("candidate,parameter,unit,start,value,sigma,change,prior_sigma,at_bound\n");
    let optional = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
    for (candidate, judgement) in judged(compared) {
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

/// Errors of the recommended (else the best) candidate, one row per validation sample.
fn errors_table(compared: &Compared) -> String {
    let count = compared.comparison.robot.cable_count();
    let lengths: Vec<String> = (1..=count).map(|cable| format!("length_error_m_{cable}")).collect();
    let mut text =
        format!("sample,x_m,y_m,z_m,position_error_m,dx_m,dy_m,dz_m,rotation_error_rad,{}\n", lengths.join(","));
    let Some(judgement) = shown(compared) else { return text };
    let errors = &judgement.validation_errors;
    for (row, sample) in judgement.validation_samples.iter().enumerate() {
        let [dx, dy, dz] = errors.position_vector[row].map(field);
        let lengths: Vec<String> = errors.length[row * count..][..count].iter().map(|&error| field(error)).collect();
        let (position, rotation) = (field(errors.position[row]), field(errors.rotation[row]));
        let [x, y, z]: [f64; 3] = compared.comparison.samples.poses[*sample].position.into();
        let _ = writeln!(text, "{},{x},{y},{z},{position},{dx},{dy},{dz},{rotation},{}", sample + 1, lengths.join(","));
    }
    text
}

/// The candidate that tables by sample and by pairs of parameters are about: the recommended, else the best one.
pub(super) fn shown(compared: &Compared) -> Option<&Judgement> {
    let index = compared.selection.recommended.or(compared.selection.best)?;
    compared.selection.candidates[index].outcome.as_ref().ok()
}
