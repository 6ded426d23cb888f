//! `cdpr initial-tension`: how winches are set for a path, an area or a volume.

use std::path::PathBuf;
use std::process::ExitCode;
use std::str::FromStr;

use cdpr_model::control::Initial;
use cdpr_model::control::InputError;
use cdpr_model::control::initial_tension::{approach, fit, optimum};
use cdpr_model::control::initial_tensions;
use cdpr_model::geometry::Pose;
use cdpr_model::tension::Method;
use cdpr_workspace::WorkspaceError;
use cdpr_workspace::grid::{self, Grid};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::numbers::{NumberList, Unreadable};
use crate::progress::Progress;
use crate::study_file::StudyFile;
use cdpr_reports::answers::{InitialTensionAnswer, Size, WinchState};

const EXAMPLES: &str = "\
Examples:
  cdpr initial-tension studies/planar-small-circle.toml
  cdpr initial-tension study.toml --target minimum --stages 8
  cdpr initial-tension study.toml --target 2500,2500,1500,1500 --format json";

/// Initial tensions that suit the poses of a study (eq. 3.42), and how a real robot is brought to them.
///
/// Winches are set once, at the initial pose. Of all initial tensions that balance the load there and keep the limits, those are
/// found with which the tensions that emerge at the poses of the study, a path, an area or a volume, come nearest to a target. The
/// answer names the winch offsets, what is reached with them, and stage by stage what the force sensors read while the winches are
/// turned from the least tensions to these. It is negative (exit code 1) when tensions break their limits at a pose of the study.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Study file (TOML); `cdpr schema study` describes it. Its [poses] are the path, area or volume.
    #[arg(value_name = "STUDY")]
    study: PathBuf,

    /// Tensions wanted at every pose: closed-form (the middle of the limits, eq. 3.41) | minimum | another method of `cdpr tension`
    /// | one tension per cable (N), projected at every pose onto those that balance the load there.
    #[arg(long, value_name = "TARGET", default_value = "closed-form", allow_hyphen_values = true)]
    target: TargetArgument,

    /// Stages in which the winches are turned.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u16).range(1..=1000))]
    stages: u16,

    /// Seed of random poses.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,
}

/// Tensions, or how they are found.
#[derive(Clone, Debug)]
pub(crate) enum TargetArgument {
    Method(Method),
    Tensions(Vec<f64>),
}

impl FromStr for TargetArgument {
    type Err = Unreadable;

    fn from_str(text: &str) -> Result<Self, Unreadable> {
        match text.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first)) {
            true => NumberList::from_str(text).map(|numbers| Self::Tensions(numbers.0)),
            false => Method::from_str(text).map(Self::Method).map_err(|error| error.to_string().into()),
        }
    }
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let mut study_file = StudyFile::read(&arguments.study)?;
    study_file.introduce(output);
    let commands = study_file.poses(arguments.seed)?;
    let poses: Vec<Pose> = commands.iter().map(|command| command.pose).collect();
    let pose = study_file.start;
    let limits = study_file.accepted(study_file.known_limits())?;
    let progress = Progress::spinner("looking for initial tensions");
    let found = {
        let task = study_file.accepted(study_file.initial_tension_task(&limits))?;
        let (method, tensions) = match &arguments.target {
            TargetArgument::Method(method) => (Some(*method), None),
            TargetArgument::Tensions(tensions) => (None, Some(tensions.clone())),
        };
        let range = study_file.study.initial.tension_limits_N;
        let target =
            Initial { tension_method: method, tensions_N: tensions, tension_limits_N: range, ..Initial::default() };
        let refused = |error: InputError| study_file.refused(&error);
        let before = fit(&task, &study_file.offsets, &target, &poses).map_err(refused)?;
        let best = optimum(&task, &target, &poses).map_err(refused)?;
        let slack = Initial { tension_method: Some(Method::Minimum), ..Initial::default() };
        let least = initial_tensions(&slack, &study_file.machine, &pose).map_err(refused)?;
        let way = approach(&task, &least, &best.tensions, arguments.stages.into()).map_err(refused)?;
        (before, best, way)
    };
    let (before, best, way) = found;
    let reached = size(&study_file, &pose)?;
    let former = WinchState {
        offsets: std::mem::replace(&mut study_file.experiment.offsets, best.offsets.clone()),
        fit: before,
        reached,
    };
    let latter =
        WinchState { offsets: best.offsets.clone(), fit: best.fit.clone(), reached: size(&study_file, &pose)? };
    drop(progress);
    if !best.is_settled {
        output.remark("the search did not come to rest: better initial tensions may exist");
    }
    output.answer(&InitialTensionAnswer::new(&study_file, [former, latter], best, way, poses.len()))
}

/// Area or volume of the reachable workspace in the orientation of the initial pose by a grid.
fn size(study_file: &StudyFile, pose: &Pose) -> Result<Size<f64>, Failure> {
    let reachable = study_file.accepted(study_file.reachable())?;
    let refused = |error: WorkspaceError| study_file.refused(&error);
    let region = study_file.region(&reachable, pose.rotation).map_err(refused)?;
    let bounds = study_file.bounds(None).map_err(refused)?;
    let grid = Grid::new(&bounds, bounds.usual_step()).map_err(refused)?;
    let value = grid::count(&region, &grid).outcome(&grid).size;
    Ok(Size { name: "reachable", is_planar: region.dimension() == 2, value })
}
