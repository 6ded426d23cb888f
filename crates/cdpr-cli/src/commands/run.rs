//! `cdpr run`: a machine in time.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::process::ExitCode;

use cdpr::plant::LogFormat;
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files::{self, GrowingFile, OwnFolder};
use crate::progress::Progress;
use crate::scenario_file;
use cdpr_reports::answers::RunAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr run studies/scenario-cable-break.toml --out broken
  cdpr run scenario.toml --out run --format json";

/// File with the rows of a run.
const LOG: &str = "log.csv";

/// Let a machine move: from its start through the commands and events of a scenario.
///
/// The platform moves by Newton's and Euler's equations on cables of any composition that stretches, with the mass, centre of mass and inertia of
/// the robot file. Rows of log.csv are written as the run goes on, so that a run that is ended has left all up to then; result.json
/// appears when it is complete. The exit code is 1 when the machine cannot get to the end.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Scenario file (TOML); `cdpr schema scenario` describes it.
    #[arg(value_name = "SCENARIO")]
    scenario: PathBuf,

    /// Folder for log.csv and result.json.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let mut simulation = scenario_file::read(&arguments.scenario, output)?;
    let _own = OwnFolder::make(&arguments.out)?;
    let at = |name: &str| arguments.out.join(name);
    // a result beside the log of another run would belong to nothing
    files::remove(&at("result.json"))?;
    let progress = Progress::spinner("moving");
    let format = LogFormat::new(simulation.plant.model());
    let mut log = GrowingFile::make(&at(LOG))?;
    log.add(|text| text.push_str(&format.header()))?;
    let summary = simulation.run(|plant, state| {
        log.add(|text| format.write_row(plant, state, text))?;
        Ok::<_, Failure>(ControlFlow::Continue(()))
    })?;
    log.write()?;
    drop(progress);
    let answer = RunAnswer::new(&simulation, &summary, &at(LOG).display().to_string());
    files::write(&at("result.json"), output.file(&answer, "result.json")?.as_bytes())?;
    output.answer(&answer)
}
