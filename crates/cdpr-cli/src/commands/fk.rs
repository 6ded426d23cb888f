//! `cdpr fk`: the pose behind cable lengths.

use std::process::ExitCode;

use cdpr::equilibrium::forward_kinematics::{self, Settings, Solution, Status};
use cdpr::model::Model;
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::inputs::{ModelArguments, pose_or_home};
use crate::numbers::NumberList;
use crate::pose_answer::PoseAnswer;
use crate::table::{Table, cell};

const EXAMPLES: &str = "\
Examples:
  cdpr fk planar-example --lengths 6.621,5.731,7.214,6.265
  cdpr fk robot.toml --model pulley --lengths 6.62,5.73,7.21,6.27 --guess 0,4 --format json
  cdpr fk calibrated.toml --recorded --lengths 6.62,5.73,7.21,6.27";

/// Forward kinematics: the pose that fits given cable lengths best.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    /// Controlled cable lengths, one per cable (m).
    #[arg(long, value_name = "LENGTHS", allow_hyphen_values = true)]
    lengths: NumberList,

    /// The lengths are as the robot records them: remove the file's length_scale and length_offset_m first.
    #[arg(long)]
    recorded: bool,

    /// Pose to start the search from, components as in `cdpr ik --pose`; the home pose when left out.
    #[arg(long, value_name = "POSE", allow_hyphen_values = true)]
    guess: Option<NumberList>,
}

#[derive(Serialize)]
struct ForwardKinematics {
    robot: String,
    model: String,
    status: Status,
    reason: Option<String>,
    pose: PoseAnswer,
    residuals_m: Vec<f64>,
    residual_rms_m: f64,
    iterations: u32,
    restarts: u32,
    #[serde(skip)]
    cable_names: Vec<String>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let guess = pose_or_home(model.robot(), "--guess", arguments.guess.as_ref())?;
    let mut lengths = arguments.lengths.0;
    if arguments.recorded {
        lengths.iter_mut().enumerate().take(model.cable_count()).for_each(|(cable, length)| {
            *length = model.controlled_length(cable, *length);
        });
    }
    let solution = forward_kinematics::solve(&model, &lengths, &guess, &Settings::default())
        .map_err(|error| Failure::refused("--lengths", &error))?;
    output.answer(&ForwardKinematics::new(&model, solution))
}

impl ForwardKinematics {
    fn new(model: &Model, solution: Solution) -> Self {
        let robot = model.robot();
        Self {
            robot: robot.name.clone(),
            model: model.composition().to_string(),
            status: solution.status,
            reason: solution.reason,
            pose: PoseAnswer::new(robot, &solution.pose),
            residuals_m: solution.residuals,
            residual_rms_m: solution.residual_rms,
            iterations: solution.iterations,
            restarts: solution.restarts,
            cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
        }
    }
}

impl Answer for ForwardKinematics {
    fn is_negative(&self) -> bool {
        self.status != Status::Converged
    }

    fn words(&self) -> String {
        let Self { iterations, restarts, .. } = self;
        let steps = match restarts {
            0 => format!("{iterations} iterations"),
            1 => format!("{iterations} iterations with 1 restart"),
            _ => format!("{iterations} iterations with {restarts} restarts"),
        };
        let verdict = match self.status {
            Status::Converged => format!("converged after {steps}"),
            Status::Singular => "singular".to_owned(),
            _ => format!("not converged after {steps}"),
        };
        let mut text = format!("{}, model {}: {verdict}\n", self.robot, self.model);
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}\n"));
        }
        let best = if self.is_negative() { "best pose found" } else { "pose" };
        let mut table = Table::new(["cable", "residual mm"]);
        for (name, residual) in self.cable_names.iter().zip(&self.residuals_m) {
            table.row(vec![name.clone(), cell(Some(1e3 * residual), 6)]);
        }
        let rms = cell(Some(1e3 * self.residual_rms_m), 6);
        format!("{text}{best}: {}\n\n{}rms residual {rms} mm\n", self.pose.words(), table.text())
    }
}
