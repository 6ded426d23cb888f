//! `cdpr export`: the figures of a result, as drawings or as the numbers behind them, and robots as configuration of firmware.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};

use crate::answer::Output;
use crate::compensation_option::CompensationOption;
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::files;
use crate::hanging::NotAtRest;
use crate::inputs::{read_poses, read_robot};
use cdpr_model::control::Control;
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::reading::ErrorCode;
use cdpr_model::reading::Size;
use cdpr_reports::NamedFile;
use cdpr_reports::answers::{ExportAnswer, FirmwareAnswer, SkippedFigure, TableAnswer};
use cdpr_reports::firmware::{Configuration, Firmware, configuration};
use cdpr_reports::saved_result::{FigureFile, SavedResult};

const EXAMPLES: &str = "\
Examples:
  cdpr export svg cdpr-demo
  cdpr export csv cdpr-demo --out tables
  cdpr identify robot.toml samples.csv --free length-offset --format json > fit.json
  cdpr export svg fit.json
  cdpr export reprapfirmware calibrated.toml
  cdpr export klipper calibrated.toml --out printer.cfg
  cdpr export lengths calibrated.toml --poses poses.csv --compensation map.toml --out lengths.csv";

/// Write the figures of a result as SVG drawings, or the numbers behind them as CSV tables; or a robot as configuration of a printer's firmware, or as
/// table of lengths.
///
/// Figures: model-ladder, residuals, pose errors (error-map), parameters (CSV only), correlations, singular-values,
/// convergence. They are about the recommended candidate, else the best one. Firmware: lines M669 (anchors) and M666 (spools) of RepRapFirmware,
/// sections of steppers of Klipper's winch kinematics; for point platforms, to standard output without --out. Lengths: what a control model sends to
/// the winches at poses, corrected by its map (--compensation), as a measurement file that `evaluate` reads back.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[arg(value_enum, value_name = "svg|csv|reprapfirmware|klipper|lengths", hide_possible_values = true)]
    #[arg(help = "What to write")]
    kind: Kind,

    /// Folder that `select` or `demo` wrote, or a file with the JSON answer of `select`, `demo` or `identify`; for firmware and lengths a robot, its file or name.
    #[arg(value_name = "RESULT")]
    result: PathBuf,

    /// Folder to write to, `figures` beside `result.json` when left out; for firmware and lengths a file.
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,

    /// Lengths: poses (CSV) at which the control model says them.
    #[arg(long, value_name = "POSES.csv", required_if_eq("kind", "lengths"))]
    poses: Option<PathBuf>,

    /// Lengths: effects of the control model, `standard` when left out.
    #[arg(long, value_name = "MODEL")]
    model: Option<Composition>,

    #[command(flatten)]
    compensation: CompensationOption,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Kind {
    Svg,
    Csv,
    #[value(name = "reprapfirmware")]
    RepRapFirmware,
    Klipper,
    Lengths,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let is_table = matches!(arguments.kind, Kind::Lengths);
    let asked = [
        ("--compensation", arguments.compensation.is_asked()),
        ("--poses", arguments.poses.is_some()),
        ("--model", arguments.model.is_some()),
    ];
    if let Some((option, _)) = asked.into_iter().find(|(_, is_asked)| *is_asked && !is_table) {
        let message = format!(
            "{option} belongs to tables of lengths: figures have none, and firmware computes its own along straight lines from anchors, with no place for a map"
        );
        return Err(Failure::usage("usage::value", &message)
            .with_help("`cdpr export lengths` writes a table of corrected lengths"));
    }
    match arguments.kind {
        Kind::Svg => figures(arguments, SavedResult::drawings, output),
        Kind::Csv => figures(arguments, SavedResult::tables, output),
        Kind::RepRapFirmware => configured(&arguments, Firmware::RepRapFirmware, output),
        Kind::Klipper => configured(&arguments, Firmware::Klipper, output),
        Kind::Lengths => lengths(&arguments, output),
    }
}

/// Table of the lengths that a control model sends, corrected by its map.
fn lengths(arguments: &Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let name = arguments.result.to_string_lossy();
    let refused = |error: &dyn ErrorCode| Failure::refused(&name, error);
    let model = Model::new(read_robot(&name)?, arguments.model.unwrap_or(Composition::STANDARD))
        .map_err(|error| refused(&error))?;
    let map = arguments.compensation.read(&model)?;
    let path = arguments.poses.clone().unwrap_or_default();
    let poses = read_poses(&path, model.robot())?;
    let compensation = map.as_ref().map(|(map, _)| map);
    let (table, beyond) = Control { compensation: compensation.cloned(), ..Control::from(&model) }
        .table(&poses)
        .map_err(|error| refused(&error))?;
    if let Some((_, file)) = map.as_ref().filter(|_| beyond.fading > 0) {
        let (fading, all) = (beyond.fading, poses.len());
        output.remark(&format!(
            "{fading} of {all} poses lie in the margin around the samples of {file}: its correction fades there"
        ));
    }
    if let Some(words) = not_resting(&model, &poses) {
        output.remark(&words);
    }
    let out = arguments.out.as_deref();
    let answer = TableAnswer::new(&model, map.map(|(_, file)| file), &table, out.map(shown_path));
    out.map_or(Ok(()), |path| files::write(path, answer.text().as_bytes()))?;
    output.answer(&answer)
}

/// Poses that the load of a hanging platform does not allow, in words; `None` without any.
fn not_resting(model: &Model, poses: &[Pose]) -> Option<String> {
    let doubts = poses.iter().map(|pose| NotAtRest::of(model, pose)).enumerate();
    let own: Vec<(usize, NotAtRest)> = doubts.filter_map(|(place, doubt)| Some((place, doubt?))).collect();
    let (worst, doubt) = own.iter().max_by(|a, b| a.1.distance().total_cmp(&b.1.distance()))?;
    Some(format!(
        "the load does not let the platform rest at {} of {} poses; at pose {}: {}; `cdpr ik ROBOT --position` tells the rest of a pose by the load",
        own.len(),
        poses.len(),
        worst + 1,
        doubt.words(model.robot())
    ))
}

/// Lines of a firmware's configuration.
fn configured(arguments: &Arguments, firmware: Firmware, output: &mut Output) -> Result<ExitCode, Failure> {
    let name = arguments.result.to_string_lossy();
    let robot = read_robot(&name)?;
    let found = configuration(&robot, firmware).map_err(|error| {
        let help = "firmware runs point platforms in space: four cables with RepRapFirmware, 26 at most with Klipper";
        Failure::refused(&name, &error).with_help(help)
    });
    let Configuration { lines, left_out } = found?;
    left_out.iter().for_each(|words| output.remark(&format!("{name}: left out: {words}")));
    let out = arguments.out.as_ref();
    out.map_or(Ok(()), |path| files::write(path, (lines.join("\n") + "\n").as_bytes()))?;
    let out = out.map(|path| shown_path(path));
    output.answer(&FirmwareAnswer::new(robot.name.clone(), lines, out))
}

fn figures(
    arguments: Arguments,
    of: fn(&SavedResult) -> Vec<FigureFile>,
    output: &mut Output,
) -> Result<ExitCode, Failure> {
    let data = read(&arguments.result)?;
    data.robot.iter().for_each(|robot| output.about(robot));
    let figures = of(&data);
    let folder = arguments.out.unwrap_or_else(|| folder_of(&arguments.result).join("figures"));
    let _own = files::OwnFolder::make(&folder)?;
    let (mut files, mut skipped) = (Vec::new(), Vec::new());
    for FigureFile { name, content, why_not } in figures {
        match content {
            Some(content) => files.push((folder.join(name), name, content)),
            None => {
                output.remark(&format!("{name} is not written: {why_not}"));
                skipped.push(SkippedFigure { figure: name, reason: why_not });
            }
        }
    }
    let pairs: Vec<(&Path, &[u8])> = files.iter().map(|(path, _, content)| (&**path, content.as_bytes())).collect();
    files::write_all(&pairs)?;
    let written = files.iter().map(|(_, name, _)| (*name).to_owned()).collect();
    let result = arguments.result.display().to_string();
    output.answer(&ExportAnswer::new(result, data.shown, shown_path(&folder), written, skipped))
}

/// The result in a folder with its tables, or that of a JSON file alone.
fn read(result: &Path) -> Result<SavedResult, Failure> {
    let is_folder = result.is_dir();
    let file = if is_folder { result.join("result.json") } else { result.to_owned() };
    let help = "RESULT is a folder that `cdpr select --out` or `cdpr demo` wrote, or a file with a JSON answer";
    let content = files::read(&file, Size::Table).map_err(|failure| failure.with_help(help))?;
    let content = NamedFile::new(shown_path(&file), content);
    let saved = SavedResult::from_json(&content);
    let mut saved = saved.map_err(|error| FileKind::Answer.refusal(&content.content, error))?;
    if is_folder {
        saved.read_tables(|name| -> Result<Option<NamedFile>, Failure> {
            let path = result.join(name);
            let size = if name.ends_with(".csv") { Size::Table } else { Size::Text };
            Ok(files::read_if_there(&path, size)?.map(|content| NamedFile::new(shown_path(&path), content)))
        })?;
    }
    Ok(saved)
}

/// The folder that a result is, or stands in.
fn folder_of(result: &Path) -> &Path {
    if result.is_dir() { result } else { result.parent().unwrap_or(Path::new("")) }
}

fn shown_path(path: &Path) -> String {
    path.display().to_string()
}
