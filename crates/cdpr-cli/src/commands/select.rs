//! `cdpr select`: the simplest control model that is good enough, on data it was not fitted to.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use cdpr_model::measurement::{Samples, Split};
use cdpr_model::model::{Composition, Model};
use cdpr_model::reading::Size;
use cdpr_model::robot::Robot;
use clap::Args;

use crate::answer::{Output, TrustArguments};
use crate::session::command_line;
use cdpr_reports::NamedFile;
use cdpr_reports::comparison::{ComparisonData, DataDivision};

use crate::failure::Failure;
use crate::files;
use crate::inputs::RobotArgument;
use crate::measurements::{DataArguments, screen, unseen};
use crate::selecting::{SelectionArguments, write_folder};

const EXAMPLES: &str = "\
Examples:
  cdpr select robot.toml samples.csv --out result
  cdpr select robot.toml train.csv --validation other-day.csv --require position_mean_m=0.005
  cdpr select robot.toml samples.csv --split region:4 --criterion length --format json
  cdpr select robot.toml samples.csv --candidates 'standard;standard:length-offset;pulley:frame-anchor,pulley-radius'";

/// Identify candidate control models, judge each on data it was not fitted to, and recommend one.
///
/// Recommended is the simplest candidate (the first of the list) that is as good as the best on the same samples
/// and keeps every limit of --require, of those whose fit converged. The exit code is 1 when none does, and when the recommended one is not to be trusted.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    robot: RobotArgument,

    #[command(flatten)]
    data: DataArguments,

    /// Measurements to judge by; DATA is then only fitted to.
    #[arg(long, value_name = "FILE", conflicts_with = "split")]
    validation: Option<PathBuf>,

    /// How DATA is parted: column (`set`), blocks:K, kfold:K or region:K. Default: the column `set` where it names train
    /// and validation rows, else blocks:5.
    #[arg(long, value_name = "SPLIT")]
    split: Option<Split>,

    #[command(flatten)]
    selection: SelectionArguments,

    #[command(flatten)]
    trust: TrustArguments,

    /// Folder for the result: result.json, run.toml, tables, calibrated robots, report.html.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let comparison = arguments.selection.compare(arguments.data(output)?)?;
    let mut answer = comparison.answer();
    if let Some(folder) = &arguments.out {
        write_folder(folder, &comparison, Vec::new())?;
        answer.out = Some(folder.display().to_string());
    }
    output.answer_accepting(&answer, arguments.trust)
}

impl Arguments {
    fn data(&self, output: &Output) -> Result<ComparisonData, Failure> {
        let robot = self.robot.read()?;
        let reader = reader_of(&robot, self.robot.model(Composition::STANDARD)?);
        let division = match self.data.lacks_poses(&reader)? {
            true => self.without_poses(&reader, output)?,
            false => self.with_poses(&reader, output)?,
        };
        let DataDivision { samples, internal, data_count, folds, words } = division;
        let mut inputs = vec![NamedFile::new("robot", robot.to_toml())];
        for path in [Some(self.data.path()), self.data.merged_path(), self.validation.as_deref()].into_iter().flatten()
        {
            inputs.push(NamedFile::new(path.display().to_string(), files::read(path, Size::Table)?));
        }
        Ok(ComparisonData {
            robot,
            samples,
            internal,
            data_count,
            folds,
            data_name: self.data.name(),
            validation_name: words,
            command: command_line(),
            warnings: output.warnings(),
            inputs,
        })
    }
}

impl Arguments {
    fn with_poses(&self, reader: &Model, output: &Output) -> Result<DataDivision, Failure> {
        let samples = self.data.read(reader, output)?;
        samples.check().map_err(|error| Failure::refused(&self.data.name(), &error))?;
        let samples = screen(samples, reader, output);
        let Some(path) = &self.validation else { return self.one_file(samples) };
        let other = screen(self.data.read_other(path, reader, output)?, reader, output);
        two_files(&samples, &unseen(&samples, other, path, output)?, path)
    }

    fn one_file(&self, samples: Samples) -> Result<DataDivision, Failure> {
        DataDivision::of_one_file(samples, self.split, self.selection.seed)
            .map_err(|error| Failure::refused("--split", &error))
    }

    /// Samples of sensors inside the machine, parted alike.
    fn without_poses(&self, reader: &Model, output: &Output) -> Result<DataDivision, Failure> {
        let name = self.data.name();
        self.selection.refuse_without_poses(&name, self.split)?;
        let mut internal = self.data.read_internal(reader, output)?;
        let mut division = match &self.validation {
            Some(path) => {
                let other = self.data.read_other_internal(path, reader, output)?;
                let division = two_files(&internal.samples, &other.samples, path)?;
                internal = internal.followed_by(&other).map_err(|error| Failure::refused(&name, &error))?;
                division
            }
            None => self.one_file(internal.samples.clone())?,
        };
        division.words.push_str(
            "; the pose of a sample is what its own rows tell, and errors are scaled for what it takes up of them",
        );
        division.internal = Some(internal);
        Ok(division)
    }
}

fn two_files(train: &Samples, validation: &Samples, path: &Path) -> Result<DataDivision, Failure> {
    let name = path.display().to_string();
    DataDivision::of_two_files(train, validation, &name).map_err(|error| Failure::refused(&name, &error))
}

/// The model that reads motor angles: with drums where the robot has them. Each candidate then reads them by its own winches.
fn reader_of(robot: &Robot, plain: Model) -> Model {
    let drums = Composition { drum: true, ..Composition::STANDARD };
    Model::new(robot.clone(), drums).unwrap_or(plain)
}
