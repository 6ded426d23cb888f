//! `cdpr run`: a machine in time.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_plant::sensors::SENSORS;
use cdpr_plant::{LogFormat, Simulation, Volume};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files::{self, GrowingFile, OwnFolder};
use crate::progress::Progress;
use crate::scenario_file;
use cdpr_reports::answers::RunAnswer;
use cdpr_reports::number_format::{short, significant};
use cdpr_reports::recording::{Recording, Violation, mcap_bytes};
use cdpr_reports::run_page::RunPage;

const EXAMPLES: &str = "\
Examples:
  cdpr run studies/scenario-cable-break.toml --out broken
  cdpr run scenario.toml --out run --format json";

/// File with the rows of a run.
const LOG: &str = "log.csv";

/// Rows and bytes beyond which a run asks for `--yes`.
const MOST_ROWS: f64 = 1e7;
const MOST_BYTES: f64 = 1e9;

/// Files of a complete run.
const RESULTS: [&str; 5] = ["result.json", "report.html", "log.mcap", "tensions.svg", "pose.svg"];

/// File of sensors that has a sidecar with the accuracies.
const MEASUREMENTS: &str = "measurements.csv";
const SIDECAR: &str = "measurements.meta.toml";

/// Let a machine move: from its start through the commands and events of a scenario.
///
/// The platform moves by Newton's and Euler's equations on cables of any composition that stretches, with the mass, centre of mass and inertia of
/// the robot file. Rows of log.csv are written as the run goes on, so that a run that is ended has left all up to then; result.json,
/// report.html (playback, with broken limits marked on the time line), its drawings tensions.svg and pose.svg, and log.mcap (for Foxglove
/// and other readers of MCAP) appear when it is complete, and with sensors measurements.csv with its sidecar, tracker.csv and imu.csv, which
/// `cdpr identify` reads. Limits of tensions are judged after every step. The exit code is 1 when one is broken, and when the machine cannot
/// get to the end.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Scenario file (TOML); `cdpr schema scenario` describes it.
    #[arg(value_name = "SCENARIO")]
    scenario: PathBuf,

    /// Folder for log.csv, log.mcap, result.json, report.html and drawings.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,

    /// Record more than ten million rows or 1 GB.
    #[arg(long)]
    yes: bool,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let mut simulation = scenario_file::read(&arguments.scenario, output)?;
    arguments.check_volume(&simulation)?;
    let _own = OwnFolder::make(&arguments.out)?;
    let at = |name: &str| arguments.out.join(name);
    // results beside the log of another run would belong to nothing
    let of_sensors = SENSORS.iter().map(|sensor| sensor.file).chain([SIDECAR]);
    RESULTS.into_iter().chain(of_sensors).try_for_each(|name| files::remove(&at(name)))?;
    let progress = Progress::spinner("moving");
    let format = LogFormat::new(&simulation.plant);
    let robot = simulation.plant.model().robot().clone();
    let mut recording = Recording::new(&robot);
    let mut log = GrowingFile::make(&at(LOG))?;
    log.add(|text| text.push_str(&format.header()))?;
    let summary = simulation.run(|plant, state| {
        log.add(|text| format.write_row(plant, state, text))?;
        recording.note(state);
        Ok::<_, Failure>(progress.step_of_work())
    })?;
    log.write()?;
    recording.happened(&summary.events);
    let violations = Violation::all(&summary.violations, &robot);
    let answer = RunAnswer::new(&simulation, &summary, &violations, &at(LOG).display().to_string());
    let result = output.file(&answer, "result.json")?;
    let shown =
        Shown { arguments: &arguments, simulation: &simulation, recording: &recording, violations: &violations };
    shown.write(&answer, &result)?;
    drop(progress);
    output.answer(&answer)
}

impl Arguments {
    /// Refuses runs that would record more than anybody wants by mistake.
    fn check_volume(&self, simulation: &Simulation) -> Result<(), Failure> {
        let volume = simulation.volume;
        let cables = simulation.plant.model().cable_count();
        let bytes = volume.bytes.saturating_add(recorded_bytes(cables, volume.log_rows, volume.duration));
        let times = (volume.rows as f64 / MOST_ROWS).max(bytes as f64 / MOST_BYTES);
        if self.yes || times <= 1.0 {
            return Ok(());
        }
        let (rows, gigabytes) = (significant(volume.rows as f64, 3), significant(bytes as f64 / 1e9, 2));
        let message = format!(
            "{}: the run would record {rows} rows and about {gigabytes} GB, more than ten million rows or 1 GB",
            self.scenario.display()
        );
        let record = short(self::record_interval(&volume, cables));
        let help = format!("give [time] a larger record_s, as {record}, and sensors lower rates, or say --yes");
        Err(Failure::input("run::volume", message, help))
    }
}

/// Time between rows of a log that stays within the limits, to one digit; pictures of the scene are no fewer until rows are.
fn record_interval(volume: &Volume, cables: usize) -> f64 {
    let mut interval = volume.record_interval;
    loop {
        let share = volume.record_interval / interval;
        let rows = (volume.log_rows as f64 * share) as u64;
        let bytes = volume.bytes as f64 * share + recorded_bytes(cables, rows, volume.duration) as f64;
        let times = (volume.rows as f64 * share / MOST_ROWS).max(bytes / MOST_BYTES);
        if times <= 1.0 || interval >= volume.duration {
            return interval;
        }
        interval = rounded_up(interval * times.max(1.1));
    }
}

/// Bytes of log.mcap; none where the command is built without the feature `recording`.
fn recorded_bytes(cables: usize, moments: u64, duration: f64) -> u64 {
    if cfg!(feature = "recording") { mcap_bytes(cables, moments, duration) } else { 0 }
}

/// The number of one digit next above.
fn rounded_up(number: f64) -> f64 {
    let power = 10f64.powi(number.log10().floor() as i32);
    (number / power).ceil() * power
}

/// A run and its record, as its files show them.
struct Shown<'a> {
    arguments: &'a Arguments,
    simulation: &'a Simulation,
    recording: &'a Recording<'a>,
    violations: &'a [Violation],
}

impl Shown<'_> {
    /// Writes all files that belong to a complete run.
    fn write(&self, answer: &RunAnswer, result: &str) -> Result<(), Failure> {
        let Self { recording, violations, .. } = *self;
        let page = self.page(answer)?;
        let drawings = [recording.tension_figure(violations), recording.pose_figure(violations)];
        let [tensions, pose] = drawings.map(|figure| figure.map(|figure| figure.file().into_bytes()));
        let contents = [Some(result.to_owned().into_bytes()), Some(page.into_bytes()), self.mcap()?, tensions, pose];
        let own = RESULTS.into_iter().zip(contents).filter_map(|(name, content)| Some((name, content?)));
        let all = own.chain(self.sensed().into_iter().map(|(name, text)| (name, text.into_bytes())));
        let all: Vec<_> = all.map(|(name, content)| (self.arguments.out.join(name), content)).collect();
        files::write_all(&all.iter().map(|(path, content)| (path.as_path(), content.as_slice())).collect::<Vec<_>>())
    }

    /// The run as MCAP.
    #[cfg(feature = "recording")]
    fn mcap(&self) -> Result<Option<Vec<u8>>, Failure> {
        let bytes = self.recording.mcap(self.violations);
        bytes.map(Some).map_err(|error| Failure::unwritable("the recording", &error))
    }

    /// `None`: the command is built without the feature `recording`.
    #[cfg(not(feature = "recording"))]
    fn mcap(&self) -> Result<Option<Vec<u8>>, Failure> {
        Ok(None)
    }

    /// Records of the sensors, with a sidecar for measurement files.
    fn sensed(&self) -> Vec<(&'static str, String)> {
        let Some(sensors) = &self.simulation.sensors else { return Vec::new() };
        let logs = sensors.logs(&self.simulation.plant);
        let source = format!("cdpr run {}", self.arguments.scenario.display());
        let sidecar = || sensors.sidecar(&self.simulation.plant, source).to_toml();
        let beside = logs.iter().any(|log| log.name == MEASUREMENTS).then(|| (SIDECAR, sidecar()));
        logs.into_iter().map(|log| (log.name, log.csv)).chain(beside).collect()
    }

    fn page(&self, answer: &RunAnswer) -> Result<String, Failure> {
        let name =
            self.arguments.scenario.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let facts = answer.facts(&self.simulation.plant);
        let page = RunPage {
            recording: self.recording,
            violations: self.violations,
            answer,
            name: &name,
            facts: &facts,
            command: &crate::session::command_line(),
            version: env!("CARGO_PKG_VERSION"),
        };
        page.render().map_err(|error| Failure::unwritable("the page of the run", &error))
    }
}
