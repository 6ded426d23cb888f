//! `cdpr study`: everything that a study tells, in a folder.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use cdpr_model::geometry::Pose;
use cdpr_model::reading::Size;
use cdpr_study::field::{Field, field};
use clap::Args;
use serde::Serialize;
use sha2::{Digest, Sha256};

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;
use crate::study_file::StudyFile;
use cdpr_reports::NamedFile;
use cdpr_reports::answers::{StudyAnswer, control_title, study_remarks, title};
use cdpr_reports::study_page::{self, StudyPage, StudyPageError, error_maps, errors_table, tracking_figure};

const EXAMPLES: &str = "\
Examples:
  cdpr study studies/planar-wide-grid.toml --out planar
  cdpr study study.toml --out result --seed 7 --format json";

/// Errors over the poses of a study, exact and by one linear step, as tables and maps in a folder.
///
/// Writes result.json, run.toml, errors.csv (pose by pose: what was commanded, what emerges, the error vector, that of the linear
/// step, emerging and commanded tensions, and the residual wrench that moves the platform), error maps as SVG, under force control
/// force-tracking.svg, and report.html: a page that opens from disk, with contours, error vectors and
/// the values under the pointer. The answer is negative (exit code 1) when a pose has no answer.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Study file (TOML); `cdpr schema study` describes it.
    #[arg(value_name = "STUDY")]
    study: PathBuf,

    /// Folder to write to; made where it does not exist.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,

    /// Seed of random poses.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,
}

/// Provenance of the folder.
#[derive(Serialize)]
struct Run<'a> {
    version: &'a str,
    command: String,
    seed: u64,
    study: String,
    study_sha256: String,
    control: String,
    machine: String,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let bytes = files::read(&arguments.study, Size::Text)?;
    let study_file = StudyFile::read(&arguments.study)?;
    study_file.introduce(output);
    let commands = study_file.poses(arguments.seed)?;
    let poses: Vec<Pose> = commands.iter().map(|command| command.pose).collect();
    if poses.is_empty() {
        return Err(study_file.refused(&cdpr_model::control::InputError::NoPoses));
    }
    let driving = study_file.accepted(study_file.driving())?;
    let progress = Progress::spinner("commanding the poses");
    let found = field(&driving, &poses);
    study_remarks(&study_file, &found).iter().for_each(|remark| output.remark(remark));
    let mut made = error_maps(&found, &study_file.machine);
    let tracking = tracking_figure(&found, &study_file.machine);
    made.extend(tracking.map(|figure| NamedFile::new("force-tracking.svg", figure.file())));
    made.insert(0, NamedFile::new("errors.csv", errors_table(&found, study_file.machine.robot())));
    let names = made.iter().map(|file| file.name.as_str());
    let names = ["run.toml", "report.html"].into_iter().chain(names).chain(["result.json"]).map(str::to_owned);
    let answer = StudyAnswer::new(&study_file, &found, arguments.seed, names.collect());
    let page = page(&study_file, &arguments, &found, &answer, output.remarks())?;
    drop(progress);
    made.insert(0, NamedFile::new("report.html", page));
    let run = Run {
        version: env!("CARGO_PKG_VERSION"),
        command: crate::session::command_line(),
        seed: arguments.seed,
        study: arguments.study.display().to_string(),
        study_sha256: Sha256::digest(&bytes).iter().fold(String::new(), |text, byte| format!("{text}{byte:02x}")),
        control: control_title(&study_file),
        machine: title(&study_file.machine),
    };
    let run = toml::to_string(&run).map_err(|error| Failure::unwritable("run.toml", &error))?;
    made.insert(0, NamedFile::new("run.toml", run));
    made.push(NamedFile::new("result.json", output.file(&answer, "result.json")?));
    write(&arguments.out, &made)?;
    output.answer(&answer)
}

/// The page of the study.
fn page(
    study_file: &StudyFile,
    arguments: &Arguments,
    found: &Field,
    answer: &StudyAnswer,
    mut warnings: Vec<String>,
) -> Result<String, Failure> {
    warnings.extend(answer.reason().map(str::to_owned));
    let name = arguments.study.file_stem().unwrap_or(arguments.study.as_os_str()).to_string_lossy();
    let page = study_page::render(&StudyPage {
        experiment: &study_file.experiment,
        answer,
        name: &name,
        found,
        warnings: &warnings,
        command: &crate::session::command_line(),
        seed: arguments.seed,
        version: env!("CARGO_PKG_VERSION"),
    });
    page.map_err(|error| match error {
        StudyPageError::Page(error) => Failure::unwritable("the page of the study", &error),
        refused => study_file.refused(&refused),
    })
}

/// All files, `result.json` last: a folder that has it is complete.
fn write(folder: &Path, all: &[NamedFile]) -> Result<(), Failure> {
    let _own = files::OwnFolder::make(folder)?;
    let paths: Vec<PathBuf> = all.iter().map(|file| folder.join(&file.name)).collect();
    let pairs: Vec<(&Path, &[u8])> =
        paths.iter().map(PathBuf::as_path).zip(all.iter().map(|file| &file.content[..])).collect();
    files::write_all(&pairs)
}
