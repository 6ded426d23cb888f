//! `cdpr fk`: the pose behind cable lengths, or behind tensions.

use std::process::ExitCode;

use cdpr_model::equilibrium::{
    ForwardError, ForwardProblem, ForwardSettings, Solution, Start, State, Status, forward_statics,
};
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Cables, Model};
use cdpr_model::statics::Load;
use cdpr_model::tension::{Intervals, intervals};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::inputs::{IDEAL_WINCH, ModelArguments, load_of, pose_of};
use crate::numbers::NumberList;
use cdpr_reports::answers::{ForwardAnswer, undetermined_words};

/// Excess of a rigid cable's length from which on it is slack (m).
const SLACK: f64 = 1e-6;

const EXAMPLES: &str = "\
Examples:
  cdpr fk planar-example --lengths 6.621,5.731,7.214,6.265
  cdpr fk robot.toml --model pulley --lengths 6.62,5.73,7.21,6.27 --guess 0,4 --format json
  cdpr fk robot.toml --model elastic --lengths 6.62,5.73,7.21,6.27 --wrench 0,-1962
  cdpr fk robot.toml --model drum --motor-angles 66.2,57.3,72.1,62.7
  cdpr fk planar-example --tensions 5808,5909,2390,2421
  cdpr fk calibrated.toml --recorded --lengths 6.62,5.73,7.21,6.27";

/// Forward problem: the pose behind given cable lengths, or at which given tensions balance the load.
///
/// Elastic models, and robots with fewer cables than degrees of freedom, rest where cables and load are in equilibrium: the
/// answer has tensions too. Rigid models with as many cables or more fit the lengths as well as possible.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    /// Controlled cable lengths, one per cable (m).
    #[arg(long, value_name = "LENGTHS", allow_hyphen_values = true, required_unless_present_any = ["tensions", "motor_angles"])]
    lengths: Option<NumberList>,

    /// Instead of lengths: angles of the winches' motors, one per cable (rad). With the effect `drum` the drums of the file
    /// tell the lengths, otherwise ideal winches of their radius.
    #[arg(long, value_name = "ANGLES", allow_hyphen_values = true, conflicts_with_all = ["lengths", "tensions", "recorded"])]
    motor_angles: Option<NumberList>,

    /// Instead of lengths: tensions that winches or weights keep constant, one per cable (N).
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true, conflicts_with_all = ["lengths", "recorded"])]
    tensions: Option<NumberList>,

    /// The lengths are as the robot records them: remove the file's length_scale and length_offset_m first.
    #[arg(long)]
    recorded: bool,

    /// Load on the platform: force and moment about its origin, world axes (N, N·m); replaces the file's external wrench and
    /// weight.
    #[arg(long, value_name = "WRENCH", allow_hyphen_values = true)]
    wrench: Option<NumberList>,

    /// Pose to start the search from, components as in `cdpr ik --pose`; the home pose when left out.
    #[arg(long, value_name = "POSE", allow_hyphen_values = true)]
    guess: Option<NumberList>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let guess = arguments.guess.as_ref().map(|guess| pose_of(model.robot(), "--guess", guess)).transpose()?;
    let (answer, remark) = match (&arguments.tensions, &arguments.lengths, &arguments.motor_angles) {
        (Some(tensions), _, _) => (arguments.by_tensions(&model, &tensions.0, guess.as_ref())?, None),
        (None, Some(lengths), _) => arguments.by_lengths(&model, &lengths.0, guess.as_ref())?,
        (None, None, Some(angles)) => {
            let refused = |error| Failure::refused("--motor-angles", &error);
            let lengths = model.controlled_lengths_of_motor_angles(&angles.0).map_err(refused)?;
            if !model.composition().drum {
                output.remark(IDEAL_WINCH);
            }
            arguments.by_lengths(&model, &lengths, guess.as_ref())?
        }
        (None, None, None) => {
            let message = "neither lengths nor motor angles nor tensions are given";
            let help = "give --lengths, --motor-angles or --tensions";
            return Err(Failure::input("usage::missing-argument", message, help));
        }
    };
    remark.iter().for_each(|remark| output.remark(remark));
    output.answer(&answer)
}

/// Tensions of rigid cables that balance the load at a pose, within which statics leaves them a choice; `None` where it leaves none.
///
/// A cable that is longer than its way to the platform is slack.
fn choice_of_tensions(model: &Model, load: &Load, solution: &Solution) -> Result<Option<Intervals>, Failure> {
    if model.cables() != Cables::Rigid || solution.status != Status::Converged {
        return Ok(None);
    }
    let Ok(matrix) = model.structure_matrix(&solution.pose) else { return Ok(None) };
    let wrench = load.in_pattern(model, &solution.pose);
    let limits = |residual: &f64| if *residual < -SLACK { [0.0, 0.0] } else { [0.0, f64::INFINITY] };
    let limits: Vec<[f64; 2]> = solution.residuals.iter().map(limits).collect();
    let found =
        intervals(&matrix, wrench.as_slice(), &limits).map_err(|error| Failure::refused("--lengths", &error))?;
    Ok(found.filter(|found| found.freedom > 0))
}

impl Arguments {
    fn by_tensions(&self, model: &Model, tensions: &[f64], guess: Option<&Pose>) -> Result<ForwardAnswer, Failure> {
        let load = load_of(model.robot(), self.wrench.as_ref())?;
        let (start, guess) = Start::of(model.robot(), guess);
        let solution = forward_statics::solve(model, tensions, &load, &guess, &forward_statics::Settings::default())
            .map_err(|error| Failure::refused("--tensions", &error))?;
        Ok(ForwardAnswer::of_tensions(model, tensions, solution).sought_from(start))
    }

    fn by_lengths(
        &self,
        model: &Model,
        lengths: &[f64],
        guess: Option<&Pose>,
    ) -> Result<(ForwardAnswer, Option<String>), Failure> {
        let mut lengths = lengths.to_vec();
        if self.recorded {
            lengths.iter_mut().enumerate().take(model.cable_count()).for_each(|(cable, length)| {
                *length = model.controlled_length(cable, *length);
            });
        }
        let refused = |error: ForwardError| match &error {
            ForwardError::Load(_) => Failure::refused("ROBOT", &error),
            ForwardError::Input(_) => Failure::refused("--lengths", &error),
        };
        let load = self.wrench.as_ref().map(|wrench| load_of(model.robot(), Some(wrench))).transpose()?;
        let settings = ForwardSettings::default();
        let mut state = State::at_home(model);
        let problem = model.forward_problem(load.as_ref(), &mut state).map_err(refused)?;
        let solution =
            model.forward_with(&settings, &lengths, load.as_ref(), guess, &mut state).map_err(refused)?.clone();
        if problem == ForwardProblem::Equilibrium {
            let acting = load.map_or_else(|| load_of(model.robot(), None), Ok)?;
            let choice = choice_of_tensions(model, &acting, &solution)?;
            let answer = ForwardAnswer::of_lengths(model, solution, problem).sought_from(state.start());
            let remark = choice.as_ref().and_then(|choice| undetermined_words(model, choice));
            return Ok((choice.into_iter().fold(answer, ForwardAnswer::with_intervals), remark));
        }
        let answer = ForwardAnswer::of_lengths(model, solution, problem).sought_from(state.start());
        let alternative = model.forward_alternative(&settings, &lengths, guess, &mut state).map_err(refused)?;
        let mut answer = answer.with_alternative(model, alternative);
        if load.is_some() {
            answer.remark("--wrench does not matter here: rigid cables fit their lengths whatever the load");
        }
        Ok((answer, None))
    }
}
