//! `cdpr simulate`: virtual measurements from a study.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use cdpr::measurement::{Provenance, Sidecar, poses_from_csv};
use cdpr::metamodel::Study;
use cdpr::metamodel::simulate::{Simulation, simulate, winch_offsets};
use cdpr::metamodel::study::RobotModel;
use cdpr::model::Model;
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::files;
use crate::inputs::read_robot;

const EXAMPLES: &str = "\
Examples:
  cdpr simulate study.toml --out samples.csv
  cdpr simulate study.toml --out samples.csv --seed 7 --format json";

/// Drive a machine by a control model through the poses of a study, and record what its sensors see.
///
/// Beside DATA.csv a sidecar DATA.meta.toml with the sensor accuracies is written, which `identify` and `select` read.
/// In this version machines are kinematic: models `standard` and `pulley`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Study file (TOML); `cdpr schema study` describes it.
    #[arg(value_name = "STUDY")]
    study: PathBuf,

    /// Measurement file to write (CSV).
    #[arg(long, value_name = "FILE")]
    out: PathBuf,

    /// Seed of random poses and noise.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,
}

#[derive(Serialize)]
struct Simulated {
    samples: usize,
    left_out: usize,
    reasons: Vec<String>,
    seed: u64,
    out: String,
    sidecar: String,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let name = arguments.study.display().to_string();
    let study = Study::from_toml_bytes(&files::read(&arguments.study)?, &name)?;
    let folder = arguments.study.parent().unwrap_or(Path::new(""));
    study.remarks().iter().for_each(|remark| output.remark(remark));
    let simulated = Laboratory::new(&study, folder, &name)?.run(arguments.seed)?;
    let Simulation { samples, left_out, .. } = &simulated.simulation;
    if samples.is_empty() {
        let reason = left_out.first().map(|(_, reason)| reason.clone()).unwrap_or_default();
        return Err(Failure::refused(&name, &std::io::Error::other(format!("no pose gave a sample: {reason}"))));
    }
    let sidecar = arguments.out.with_extension("meta.toml");
    files::write(&sidecar, simulated.sidecar(arguments.seed).to_toml().as_bytes())?;
    files::write(&arguments.out, samples.to_csv(simulated.machine.robot()).as_bytes())?;
    output.answer(&Simulated {
        samples: samples.len(),
        left_out: left_out.len(),
        reasons: left_out.iter().map(|(pose, reason)| format!("pose {}: {reason}", pose + 1)).collect(),
        seed: arguments.seed,
        out: arguments.out.display().to_string(),
        sidecar: sidecar.display().to_string(),
    })
}

/// A study with its models.
pub(crate) struct Laboratory<'a> {
    study: &'a Study,
    folder: &'a Path,
    name: &'a str,
    control: Model,
    machine: Model,
}

/// Virtual measurements with the machine that made them.
pub(crate) struct Recorded {
    pub(crate) simulation: Simulation,
    pub(crate) machine: Model,
}

impl<'a> Laboratory<'a> {
    /// Reads the robots of a study; their paths are relative to its folder.
    pub(crate) fn new(study: &'a Study, folder: &'a Path, name: &'a str) -> Result<Self, Failure> {
        let control = model_of(&study.control, folder)?;
        let machine = model_of(&study.machine, folder)?;
        Ok(Self { study, folder, name, control, machine })
    }

    /// Runs the study.
    pub(crate) fn run(self, seed: u64) -> Result<Recorded, Failure> {
        let refused = |error: &dyn std::error::Error| Failure::refused(self.name, error);
        let initial = self.study.initial_pose(self.machine.robot()).map_err(|error| refused(&error))?;
        let set_with = match &self.study.initial.offset_robot {
            Some(robot) => Some(model_of(
                &RobotModel { robot: robot.clone(), model: self.study.control.model.clone() },
                self.folder,
            )?),
            None => None,
        };
        let set_with = set_with.as_ref().unwrap_or(&self.control);
        let offsets = winch_offsets(&self.study.initial, set_with, &self.machine, &initial)
            .map_err(|error| refused(&error))?;
        let from_file = match self.study.poses.as_ref().and_then(|poses| poses.file.as_ref()) {
            Some(file) => {
                let path = self.folder.join(&file.path);
                poses_from_csv(&files::read(&path)?, &path.display().to_string(), self.machine.robot())?
            }
            None => Vec::new(),
        };
        let poses = self.study.commanded_poses(self.machine.robot(), from_file, seed).map_err(|error| refused(&error))?;
        let noise = self.study.noise.unwrap_or_default();
        let simulation = simulate(&self.control, &self.machine, &offsets, &poses, &noise, seed);
        Ok(Recorded { simulation: simulation.map_err(|error| refused(&error))?, machine: self.machine })
    }
}

impl Recorded {
    /// What is known about the samples.
    pub(crate) fn sidecar(&self, seed: u64) -> Sidecar {
        Sidecar {
            layout_version: 1,
            sigmas: self.simulation.samples.sigmas,
            frames: None,
            provenance: Some(Provenance {
                source: Some(format!("simulated by cdpr {}", env!("CARGO_PKG_VERSION"))),
                robot: Some(self.machine.robot().name.clone()),
                seed: Some(seed),
                ..Provenance::default()
            }),
        }
    }
}

/// Reads the robot of one side of a study.
fn model_of(side: &RobotModel, folder: &Path) -> Result<Model, Failure> {
    let beside = folder.join(&side.robot);
    let is_path = side.robot.contains(['/', '\\', '.']);
    let text = if is_path { beside.display().to_string() } else { side.robot.clone() };
    let robot = read_robot(&text)?;
    let composition = side.model.parse().map_err(|error: cdpr::model::CompositionError| Failure::refused(&text, &error))?;
    Model::new(robot, composition).map_err(|error| Failure::refused(&text, &error))
}

impl Answer for Simulated {
    fn words(&self) -> String {
        let mut text = format!("{} samples written to {}, sensor accuracies to {}\n", self.samples, self.out, self.sidecar);
        if self.left_out > 0 {
            text.push_str(&format!("{} commanded poses gave no sample:\n", self.left_out));
            self.reasons.iter().take(10).for_each(|reason| text.push_str(&format!("  {reason}\n")));
        }
        text
    }
}
