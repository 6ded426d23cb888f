//! `cdpr demo`: the main job on the built-in virtual robot.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_calibration::fit::Prior;
use cdpr_calibration::selection::Warnings;
use cdpr_model::measurement::Samples;
use cdpr_model::model::place_pulleys;
use cdpr_model::reading::ErrorCode;
use cdpr_model::robot::{ParameterKind, Robot};
use cdpr_study::{Experiment, Robots, Study};
use clap::Args;
use nalgebra::Vector3;

use crate::answer::{Output, TrustArguments};
use cdpr_reports::NamedFile;
use cdpr_reports::comparison::{ComparisonData, DataDivision};

use crate::failure::Failure;
use crate::inputs::read_robot;
use crate::selecting::{SelectionArguments, write_folder};
use cdpr_reports::answers::simulated_by;

const EXAMPLES: &str = "\
Examples:
  cdpr demo
  cdpr demo --out first-steps --require position_mean_m=0.005
  cdpr demo --format json";

/// Measurements to fit to: the 5 × 5 × 3 grid of sec. 6.1, 16 turned poses, and 8 × 8 tension tests.
const TRAINING: &str = include_str!("demo/training.toml");

/// Measurements to judge by: random poses in the same box.
const VALIDATION: &str = include_str!("demo/validation.toml");

/// The machine's name in the studies, and its file in the result.
const MACHINE_FILE: &str = "machine.toml";

/// Cable between winch and pulley of the machine (m).
const HIDDEN_LENGTH: f64 = 8.0;

/// Standard deviation of the drawings of the platform where no --prior is given (m).
const PLATFORM_ANCHORS: Prior = Prior { kind: ParameterKind::PlatformAnchor, sigma: 0.02 };

/// Show the main job on virtual measurements of the CableRobot Simulator.
///
/// The machine is the dissertation's robot as its elastostatic calibration found it (eq. 6.27–6.30), with pulleys and 8 m of
/// cable hidden behind each of them; the control model starts from the nominal robot (eq. 6.1). Candidates are identified
/// from 155 noisy measurements and judged on 60 others; one is recommended. Platform anchors have the prior 0.02 m unless
/// --prior says otherwise.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    selection: SelectionArguments,

    #[command(flatten)]
    trust: TrustArguments,

    /// Folder for the result and the measurements.
    #[arg(long, value_name = "DIR", default_value = "cdpr-demo")]
    out: PathBuf,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let machine = machine()?;
    let (training, validation) = (record(TRAINING, &machine, 1)?, record(VALIDATION, &machine, 2)?);
    let robot = read_robot("cablerobot-simulator-helicopter")?;
    let parted = DataDivision::of_two_files(&training.samples, &validation.samples, "validation.csv")
        .map_err(|error| Failure::refused("validation.csv", &error))?;
    let mut inputs =
        vec![NamedFile::new("robot.toml", robot.to_toml()), NamedFile::new(MACHINE_FILE, machine.to_toml())];
    inputs.extend(training.files("training"));
    inputs.extend(validation.files("validation"));
    let DataDivision { samples, internal, data_count, folds, words } = parted;
    let mut selection = arguments.selection;
    if selection.prior.is_empty() {
        selection.prior.push(PLATFORM_ANCHORS);
    }
    let options = selection.written();
    let comparison = selection.compare(ComparisonData {
        robot,
        samples,
        internal,
        data_count,
        folds,
        data_name: "training.csv (virtual measurements of the CableRobot Simulator)".to_owned(),
        validation_name: words,
        command: format!("cdpr select robot.toml training.csv --validation validation.csv{options} --out ."),
        warnings: Warnings {
            remarks: vec![
                "these measurements are virtual: a machine with known parameters and sensor noise made them".to_owned(),
            ],
            doubts: Vec::new(),
        },
        inputs,
    })?;
    let mut answer = comparison.answer();
    let own_files = comparison.data.inputs.clone();
    write_folder(&arguments.out, &comparison, own_files)?;
    answer.out = Some(arguments.out.display().to_string());
    output.answer_accepting(&answer, arguments.trust)
}

/// The machine: pulleys whose contact points at the pose where the winches are set are the anchors of eq. 6.27.
fn machine() -> Result<Robot, Failure> {
    let calibrated = read_robot("cablerobot-simulator-helicopter-elastostatic-calibrated")?;
    let pulleys: Vec<(f64, Vector3<f64>)> =
        calibrated.cables.iter().map(|cable| (cable.pulley_radius().unwrap_or(0.0), Vector3::z())).collect();
    let mut machine = place_pulleys(&calibrated, &pulleys, &calibrated.home_or_middle())
        .map_err(|error| Failure::refused(&calibrated.name, &error))?;
    machine.name = "demo-machine".to_owned();
    machine.title = Some("CableRobot Simulator with pulleys and hidden cable: the machine of `cdpr demo`".to_owned());
    machine.cables.iter_mut().for_each(|cable| cable.hidden_length = Some(HIDDEN_LENGTH));
    Ok(machine)
}

/// Virtual measurements, and what their files say about them.
struct Recorded {
    samples: Samples,
    study: &'static str,
    sidecar: String,
    table: String,
}

fn record(study: &'static str, machine: &Robot, seed: u64) -> Result<Recorded, Failure> {
    let robots = |name: &str| if name == MACHINE_FILE { Ok(machine.clone()) } else { read_robot(name) };
    let parsed = Study::from_toml_bytes(study.as_bytes(), "built-in study")?;
    let robots = Robots::of(&parsed, robots)?;
    let refused = |error: &dyn ErrorCode| Failure::refused("built-in study", error);
    let experiment = Experiment::new(parsed, robots).map_err(|error| refused(&error))?;
    let recorded = experiment.commands(Vec::new(), seed).and_then(|commands| experiment.record(&commands, seed));
    let samples = recorded.map_err(|error| refused(&error))?.samples;
    let sidecar = experiment.sidecar(simulated_by(), seed).to_toml();
    Ok(Recorded { table: samples.to_csv(machine), sidecar, study, samples })
}

impl Recorded {
    /// Samples, their sidecar and the study that made them.
    fn files(&self, name: &str) -> [NamedFile; 3] {
        [
            NamedFile::new(format!("{name}-study.toml"), self.study),
            NamedFile::new(format!("{name}.meta.toml"), self.sidecar.as_str()),
            NamedFile::new(format!("{name}.csv"), self.table.as_str()),
        ]
    }
}
