//! Measured samples and what is known about their accuracy.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use cdpr::measurement::{Samples, SensorSigmas, Sidecar};
use cdpr::model::Model;
use cdpr::reading::Size;
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::inputs::IDEAL_WINCH;
use crate::numbers::number_from_zero;

/// `DATA` and `--sigma`.
#[derive(Clone, Debug, Args)]
pub(crate) struct DataArguments {
    /// Measurements (CSV, 256 MiB at most); sensor accuracies are read from the file beside it with the ending .meta.toml, if there is one.
    #[arg(value_name = "DATA")]
    data: PathBuf,

    /// Standard deviations of the sensors per axis, instead of the sidecar's: position_m, rotation_rad, length_m, tension_N.
    #[arg(long, value_name = "NAME=SIGMA,…", value_delimiter = ',', allow_hyphen_values = true)]
    sigma: Vec<SigmaOption>,
}

/// One entry of `--sigma`, e.g. `position_m=0.001`.
#[derive(Clone, Debug)]
struct SigmaOption {
    sensor: Sensor,
    sigma: f64,
}

#[derive(Clone, Copy, Debug)]
enum Sensor {
    Position,
    Rotation,
    Length,
    Tension,
}

impl FromStr for SigmaOption {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (name, value) = text.split_once('=').ok_or("write NAME=SIGMA, e.g. position_m=0.001")?;
        let sensor = match name.trim() {
            "position_m" => Sensor::Position,
            "rotation_rad" => Sensor::Rotation,
            "length_m" => Sensor::Length,
            "tension_N" => Sensor::Tension,
            other => {
                return Err(format!(
                    "`{other}` is not a sensor; known are position_m, rotation_rad, length_m, tension_N"
                ));
            }
        };
        Ok(Self { sensor, sigma: number_from_zero(value)? })
    }
}

impl DataArguments {
    /// The samples, with the accuracies of the sidecar and then those of the command line.
    pub(crate) fn read(&self, model: &Model, output: &Output) -> Result<Samples, Failure> {
        self.read_other(&self.data, model, output)
    }

    /// Another data set, with the same accuracies of the command line.
    pub(crate) fn read_other(&self, path: &Path, model: &Model, output: &Output) -> Result<Samples, Failure> {
        let mut samples = read_samples(path, model, output)?;
        self.sigma.iter().for_each(|option| option.apply(&mut samples.sigmas));
        Ok(samples)
    }

    /// The measurement file.
    pub(crate) fn path(&self) -> &Path {
        &self.data
    }

    /// The name of the file for people.
    pub(crate) fn name(&self) -> String {
        self.data.display().to_string()
    }
}

impl SigmaOption {
    fn apply(&self, sigmas: &mut SensorSigmas) {
        let place = match self.sensor {
            Sensor::Position => &mut sigmas.position,
            Sensor::Rotation => &mut sigmas.rotation,
            Sensor::Length => &mut sigmas.length,
            Sensor::Tension => &mut sigmas.tension,
        };
        *place = Some(self.sigma);
    }
}

/// Reads a measurement file and its sidecar; remarks of the reader go to stderr. Motor angles become the lengths of the
/// model's winches.
pub(crate) fn read_samples(path: &Path, model: &Model, output: &Output) -> Result<Samples, Failure> {
    let name = path.display().to_string();
    let reading = Samples::from_csv(&files::read(path, Size::Table)?, &name, model.robot())?;
    reading.notices.iter().for_each(|notice| output.remark(notice));
    let mut samples =
        model.with_lengths(&reading.samples).map_err(|error| Failure::refused(&name, &error))?.into_owned();
    if samples.motor_angles.is_some() && !model.composition().drum {
        output.remark(&format!("{name}: {IDEAL_WINCH}"));
    }
    let sidecar = path.with_extension("meta.toml");
    if let Some(bytes) = files::read_if_there(&sidecar, Size::Text)? {
        samples.sigmas = Sidecar::from_toml_bytes(&bytes, &sidecar.display().to_string())?.sigmas;
    }
    Ok(samples)
}
