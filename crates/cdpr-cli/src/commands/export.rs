//! `cdpr export`: the figures of a result, as drawings or as the numbers behind them, and robots as configuration of firmware.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::inputs::read_robot;
use cdpr::reading::Size;
use cdpr_reports::NamedFile;
use cdpr_reports::answers::{ExportAnswer, FirmwareAnswer, SkippedFigure};
use cdpr_reports::firmware::{Configuration, Firmware, configuration};
use cdpr_reports::saved_result::{FigureFile, SavedResult};

const EXAMPLES: &str = "\
Examples:
  cdpr export svg cdpr-demo
  cdpr export csv cdpr-demo --out tables
  cdpr identify robot.toml samples.csv --free length-offset --format json > fit.json
  cdpr export svg fit.json
  cdpr export reprapfirmware calibrated.toml
  cdpr export klipper calibrated.toml --out printer.cfg";

/// Write the figures of a result as SVG drawings, or the numbers behind them as CSV tables; or a robot as configuration of a printer's firmware.
///
/// Figures: model-ladder, residuals, pose errors (error-map), parameters (CSV only), correlations, singular-values,
/// convergence. They are about the recommended candidate, else the best one. Firmware: lines M669 (anchors) and M666 (spools) of RepRapFirmware,
/// sections of steppers of Klipper's winch kinematics; for point platforms, to standard output without --out.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// What to write.
    #[arg(value_enum, value_name = "svg|csv|reprapfirmware|klipper", hide_possible_values = true)]
    kind: Kind,

    /// Folder that `select` or `demo` wrote, or a file with the JSON answer of `select`, `demo` or `identify`; for firmware a robot, its file or name.
    #[arg(value_name = "RESULT")]
    result: PathBuf,

    /// Folder to write to, `figures` beside `result.json` when left out; for firmware a file.
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Kind {
    Svg,
    Csv,
    #[value(name = "reprapfirmware")]
    RepRapFirmware,
    Klipper,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    match arguments.kind {
        Kind::Svg => figures(arguments, SavedResult::drawings, output),
        Kind::Csv => figures(arguments, SavedResult::tables, output),
        Kind::RepRapFirmware => configured(&arguments, Firmware::RepRapFirmware, output),
        Kind::Klipper => configured(&arguments, Firmware::Klipper, output),
    }
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
    let of = (arguments.result.display().to_string(), data.shown);
    output.answer(&ExportAnswer::new(of, shown_path(&folder), (written, skipped)))
}

/// The result in a folder with its tables, or that of a JSON file alone.
fn read(result: &Path) -> Result<SavedResult, Failure> {
    let is_folder = result.is_dir();
    let file = if is_folder { result.join("result.json") } else { result.to_owned() };
    let help = "RESULT is a folder that `cdpr select --out` or `cdpr demo` wrote, or a file with a JSON answer";
    let content = files::read(&file, Size::Table).map_err(|failure| failure.with_help(help))?;
    let mut saved = SavedResult::from_json(&NamedFile::new(shown_path(&file), content))?;
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
