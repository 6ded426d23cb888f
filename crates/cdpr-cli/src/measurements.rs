//! Measured samples and what is known about their accuracy.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use cdpr_calibration::{Screened, repeated_of, screened};
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::measurement::{
    InternalSamples, Known, MeasurementFile, ReadingOptions, Samples, SensorSigmas, Sidecar,
};
use cdpr_model::model::Model;
use cdpr_model::reading::{ReadError, Size};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::files;
use crate::inputs::IDEAL_WINCH;
use crate::numbers::{Unreadable, number_from_zero};

/// `DATA` and the options that say how measurement files are read.
#[derive(Clone, Debug, Args)]
pub(crate) struct DataArguments {
    /// Measurements (CSV, 256 MiB at most; commas, semicolons or tabs, decimal commas with the latter two; UTF-8, UTF-16 or Latin-1); sensor
    /// accuracies and column names are read from the file beside it with the ending .meta.toml, if there is one.
    #[arg(value_name = "DATA")]
    data: PathBuf,

    /// Standard deviations of the sensors per axis, instead of the sidecar's: position_m, rotation_rad, length_m, tension_N, swivel_rad;
    /// length_scale, a ratio, of a factor that all lengths may have in common; balance_N and balance_Nm, by which cables and load may miss their
    /// equilibrium (without poses).
    #[arg(long, value_name = "NAME=SIGMA,…", value_delimiter = ',', allow_hyphen_values = true)]
    sigma: Vec<SigmaOption>,

    /// Columns of the file by the names that measurements have, e.g. x_m=X_world,cable_length_m_1=l1; before those of the sidecar.
    #[arg(long, value_name = "NAME=COLUMN,…", value_delimiter = ',')]
    columns: Vec<ColumnOption>,

    /// Leave out rows with gaps, text or quaternions that are none, and count them; otherwise they are mistakes.
    #[arg(long)]
    skip_invalid: bool,

    /// Poses from this log of a tracker, interpolated at the times (t_s) of DATA, on the same clock.
    #[arg(long, value_name = "FILE")]
    merge: Option<PathBuf>,

    /// Longest gap of the tracker's log that is interpolated (s). Default: three of its typical intervals.
    #[arg(long, value_name = "SECONDS", requires = "merge", value_parser = number_from_zero)]
    merge_gap: Option<f64>,

    /// Average the rows of poses held for a second or more (by t_s); where fewer than two are held, of short pieces of the motion.
    #[arg(long = "static")]
    at_rest: bool,
}

/// One entry of `--columns`, e.g. `x_m=X_world`.
#[derive(Clone, Debug)]
struct ColumnOption {
    name: String,
    column: String,
}

impl FromStr for ColumnOption {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (name, column) = text.split_once('=').ok_or("write NAME=COLUMN, e.g. x_m=X_world")?;
        Ok(Self { name: name.trim().to_owned(), column: column.trim().to_owned() })
    }
}

/// One entry of `--sigma`, e.g. `position_m=0.001`.
#[derive(Clone, Debug)]
pub(crate) struct SigmaOption {
    sensor: Sensor,
    sigma: f64,
}

/// Sensors by their names, which end with the unit.
const SENSORS: [(&str, Sensor); 8] = [
    ("position_m", Sensor::Position),
    ("rotation_rad", Sensor::Rotation),
    ("length_m", Sensor::Length),
    ("tension_N", Sensor::Tension),
    ("swivel_rad", Sensor::Swivel),
    ("length_scale", Sensor::LengthScale),
    ("balance_N", Sensor::BalanceForce),
    ("balance_Nm", Sensor::BalanceMoment),
];

#[derive(Clone, Copy, Debug)]
enum Sensor {
    Position,
    Rotation,
    Length,
    Tension,
    Swivel,
    LengthScale,
    BalanceForce,
    BalanceMoment,
}

impl SigmaOption {
    /// Names of the sensors.
    pub(crate) fn names() -> impl Iterator<Item = &'static str> {
        SENSORS.into_iter().map(|(name, _)| name)
    }
}

impl FromStr for SigmaOption {
    type Err = Unreadable;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (name, value) = text.split_once('=').ok_or("write NAME=SIGMA, e.g. position_m=0.001")?;
        let name = name.trim();
        let Some((_, sensor)) = SENSORS.into_iter().find(|(known, _)| *known == name) else {
            return Err(
                format!("`{name}` is not a sensor; known are {}", SENSORS.map(|(known, _)| known).join(", ")).into()
            );
        };
        Ok(Self { sensor, sigma: number_from_zero(value)? })
    }
}

impl DataArguments {
    /// The samples, with the accuracies of the sidecar and then those of the command line.
    pub(crate) fn read(&self, model: &Model, output: &Output) -> Result<Samples, Failure> {
        self.read_file(&self.data, self.merge.as_deref(), model, output)
    }

    /// True where the data have no poses, or few of them with gaps allowed, and no tracker's log is merged with them.
    pub(crate) fn lacks_poses(&self, model: &Model) -> Result<bool, Failure> {
        let (source, robot) = (self.source(&self.data)?, model.robot());
        if self.merge.is_some() || source.file().lacks_poses(robot).map_err(|error| source.refusal(error))? {
            return Ok(self.merge.is_none());
        }
        let has_few = |internal: InternalSamples| 2 * internal.whole_poses() < internal.samples.len();
        Ok(self.skip_invalid && source.file().internal_samples(robot).is_ok_and(|(internal, _)| has_few(internal)))
    }

    /// The samples without poses.
    pub(crate) fn read_internal(&self, model: &Model, output: &Output) -> Result<InternalSamples, Failure> {
        self.read_other_internal(&self.data, model, output)
    }

    /// Another data set without poses, with the same options of the command line.
    pub(crate) fn read_other_internal(
        &self,
        path: &Path,
        model: &Model,
        output: &Output,
    ) -> Result<InternalSamples, Failure> {
        let source = self.source(path)?;
        let (mut internal, notices) =
            source.file().internal_samples(model.robot()).map_err(|error| source.refusal(error))?;
        notices.iter().for_each(|notice| output.remark(notice));
        let samples = model.with_lengths(&internal.samples).map_err(|error| Failure::refused(&source.name, &error))?;
        internal.samples = Samples { sigmas: source.sigmas, ..samples.into_owned() };
        self.sigma.iter().for_each(|option| option.apply(&mut internal.samples.sigmas));
        // the sidecar was refused where they cannot be read
        internal.facts = source.known.iter().filter_map(|text| text.parse::<Known>().ok()).collect();
        Ok(internal)
    }

    /// Another data set, whole in one file, with the same options of the command line.
    pub(crate) fn read_other(&self, path: &Path, model: &Model, output: &Output) -> Result<Samples, Failure> {
        self.read_file(path, None, model, output)
    }

    /// The measurement file.
    pub(crate) fn path(&self) -> &Path {
        &self.data
    }

    /// The tracker's log that DATA is merged with.
    pub(crate) fn merged_path(&self) -> Option<&Path> {
        self.merge.as_deref()
    }

    /// The name of the file for people.
    pub(crate) fn name(&self) -> String {
        self.data.display().to_string()
    }

    /// Reads a measurement file, the log it is merged with, and their sidecars; remarks of the reader go to stderr. Motor angles
    /// become the lengths of the model's winches.
    fn read_file(&self, path: &Path, merge: Option<&Path>, model: &Model, output: &Output) -> Result<Samples, Failure> {
        let (source, robot) = (self.source(path)?, model.robot());
        let track = merge.map(|path| self.source(path)).transpose()?;
        let reading = match &track {
            Some(track) => source.file().merged_with(&track.file(), robot, self.merge_gap),
            None => source.file().samples(robot),
        };
        let reading = reading.map_err(|error| match track.as_ref().filter(|track| track.name == error.file_name) {
            Some(track) => track.refusal(error),
            None => source.refusal(error),
        })?;
        reading.notices.iter().for_each(|notice| output.remark(notice));
        reading.findings.iter().for_each(|finding| output.doubt(finding));
        let name = &source.name;
        let mut samples =
            model.with_lengths(&reading.samples).map_err(|error| Failure::refused(name, &error))?.into_owned();
        if samples.motor_angles.is_some() && !model.composition().drum {
            output.remark(&format!("{name}: {IDEAL_WINCH}"));
        }
        samples.sigmas = source.sigmas;
        if let Some(track) = track {
            // a tracker's sidecar speaks of its poses
            samples.sigmas.position = track.sigmas.position.or(samples.sigmas.position);
            samples.sigmas.rotation = track.sigmas.rotation.or(samples.sigmas.rotation);
        }
        self.sigma.iter().for_each(|option| option.apply(&mut samples.sigmas));
        if self.at_rest { at_rest(&samples, name, model, output) } else { Ok(samples) }
    }

    /// A file with its sidecar, and the options for it.
    fn source(&self, path: &Path) -> Result<Source, Failure> {
        let name = path.display().to_string();
        let sidecar_path = path.with_extension("meta.toml");
        let sidecar = match files::read_if_there(&sidecar_path, Size::Text)? {
            Some(bytes) => Sidecar::from_toml_bytes(&bytes, &sidecar_path.display().to_string())?,
            None => Sidecar::default(),
        };
        let mut columns = sidecar.columns;
        columns.extend(self.columns.iter().map(|option| (option.name.clone(), option.column.clone())));
        let options = ReadingOptions { columns, skip_invalid: self.skip_invalid };
        let (sigmas, known) = (sidecar.sigmas, sidecar.known);
        Ok(Source { bytes: files::read(path, Size::Table)?, name, options, sigmas, known })
    }
}

/// A measurement file with all that is known about it.
struct Source {
    bytes: Vec<u8>,
    name: String,
    options: ReadingOptions,
    sigmas: SensorSigmas,
    /// Facts known of the robot besides.
    known: Vec<String>,
}

impl Source {
    fn file(&self) -> MeasurementFile<'_> {
        MeasurementFile { bytes: &self.bytes, name: &self.name, options: &self.options }
    }

    fn refusal(&self, error: ReadError) -> Failure {
        FileKind::Table.refusal(&self.bytes, error)
    }
}

/// The samples without rows that repeat others or that a stuck sensor spoils, which are told.
pub(crate) fn screen(samples: Samples, model: &Model, output: &Output) -> Samples {
    let Screened { samples, findings } = screened(model.robot(), &samples);
    findings.iter().for_each(|finding| output.doubt(finding));
    samples
}

/// The samples for validation without rows that the fit has seen, which are told; an error where these are more than half.
pub(crate) fn unseen(train: &Samples, other: Samples, path: &Path, output: &Output) -> Result<Samples, Failure> {
    let seen = repeated_of(&other, train);
    if seen.is_empty() {
        return Ok(other);
    }
    let (name, count, all) = (path.display(), seen.len(), other.len());
    if 2 * count > all {
        let what = match count == all {
            true => "the validation file is the training file: all of its rows are in both".to_owned(),
            false => format!("{count} of {all} rows are rows of the training file, too"),
        };
        let message = format!("{name}: {what}: errors on them tell nothing of other data");
        let help = "record poses anew for the validation, or leave --validation out: parts of the data are then held out in turn";
        return Err(Failure::input("data::validation-is-training", message, help));
    }
    let text = format!(
        "{name}: {count} of {all} rows are rows of the training file, too: they are left out of the validation"
    );
    output.doubt(&Finding::new(FindingKind::Repeat, Severity::Caution, text).of_size(count as f64, "rows"));
    let kept: Vec<usize> = (0..all).filter(|sample| seen.binary_search(sample).is_err()).collect();
    Ok(other.subset(&kept))
}

/// Reasons against options where poses are not measured.
pub(crate) const NO_POSE: &str = "there is no pose to be compared with";
pub(crate) const BY_REGIONS: &str = "regions are parted by poses";
pub(crate) const NO_OUTLIER: &str = "a pose takes up most of an outlier, so that its residual does not show it";

/// Refuses the first option asked for of those that need measured poses, each with what it needs them for.
pub(crate) fn refuse_without_poses(data: &str, asked: &[(&str, bool, &str)]) -> Result<(), Failure> {
    let Some((option, _, reason)) = asked.iter().find(|(_, is_asked, _)| *is_asked) else { return Ok(()) };
    Err(Failure::input(
        "data::option-needs-poses",
        format!("{data}: {option} needs measured poses, and these data have none: {reason}"),
        "leave it out, or write the poses that are found with `cdpr identify --out-poses FILE` and ask of that file",
    ))
}

/// Samples at rest, and a remark on what they are means of.
fn at_rest(samples: &Samples, name: &str, model: &Model, output: &Output) -> Result<Samples, Failure> {
    let at_rest = samples.at_rest(model.robot()).map_err(|error| Failure::refused(name, &error))?;
    output.remark(&format!("{name}: {at_rest}"));
    Ok(at_rest.samples)
}

/// Samples of another command's file, with its sidecar and no options.
pub(crate) fn read_measured(path: &Path, model: &Model, output: &Output) -> Result<Samples, Failure> {
    let plain = DataArguments {
        data: path.to_owned(),
        sigma: Vec::new(),
        columns: Vec::new(),
        skip_invalid: false,
        merge: None,
        merge_gap: None,
        at_rest: false,
    };
    plain.read(model, output)
}

impl SigmaOption {
    /// Writes the accuracy.
    pub(crate) fn apply(&self, sigmas: &mut SensorSigmas) {
        let place = match self.sensor {
            Sensor::Position => &mut sigmas.position,
            Sensor::Rotation => &mut sigmas.rotation,
            Sensor::Length => &mut sigmas.length,
            Sensor::Tension => &mut sigmas.tension,
            Sensor::Swivel => &mut sigmas.swivel,
            Sensor::LengthScale => &mut sigmas.length_scale,
            Sensor::BalanceForce => &mut sigmas.balance_force,
            Sensor::BalanceMoment => &mut sigmas.balance_moment,
        };
        *place = Some(self.sigma);
    }
}
