//! `cdpr ik`: cable lengths and directions at a pose, and the lengths that winches must pay out.

use std::process::ExitCode;

use cdpr_model::equilibrium::{InverseSolution, State};
use cdpr_model::model::{Composition, Model, StretchEffect};
use cdpr_model::statics::check_tensions;
use clap::Args;

use crate::answer::{Answer, Output};
use crate::compensation_option::CompensationOption;
use crate::failure::Failure;
use crate::hanging::{NotAtRest, hanging_at, position_of};
use crate::inputs::{ModelArguments, pose_of, wrench_of};
use crate::numbers::NumberList;
use crate::statics_failure::{has_no_path, refused};
use crate::tension_choice::{Chosen, tensions_of};
use cdpr_reports::answers::{InverseAnswer, NoHangingAnswer};

const EXAMPLES: &str = "\
Examples:
  cdpr ik planar-example --pose 0.5,4
  cdpr ik cogiro --pose 0,0,1.5,0,0,0.1 --format json
  cdpr ik robot.toml --pose=-1,2 --model pulley
  cdpr ik robot.toml --pose=-1,2 --model pulley+drum
  cdpr ik planar-example --pose 0.5,4 --model elastic
  cdpr ik planar-example --pose 0.5,4 --model elastic --tensions 5900,6100,2500,2400
  cdpr ik hanging.toml --position 0.3,-0.5
  cdpr ik calibrated.toml --pose 0.5,0.3,1.6,0,0,0 --compensation map.toml
  cdpr ik caroca-pulleys --pose 3.5,2,1.5,0,0,0.1 --model pulley --jacobians";

/// Inverse kinematics: cable lengths, directions and wrap angles at a pose.
///
/// Elastic cables need less length than the geometry says, by their stretch under the tensions. These are given, or those
/// that balance the load within the robot's tension limits.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    /// Platform pose (m, rad): x,y | x,y,angle | x,y,z | x,y,z,rx,ry,rz, as the robot's motion pattern has it.
    #[arg(long, value_name = "POSE", allow_hyphen_values = true, required_unless_present = "position")]
    pose: Option<NumberList>,

    /// Position alone, of a platform with fewer cables than degrees of freedom (m): x,y | x,y,z; the load decides the rest of the pose. Lists all
    /// poses at which it hangs there, stable ones first.
    #[arg(long, value_name = "POSITION", allow_hyphen_values = true, conflicts_with_all = ["pose", "tensions"])]
    position: Option<NumberList>,

    /// Cable tensions of an elastic model, one per cable (N), not judged against limits; those nearest the middle of the
    /// limits that balance the load when left out.
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true)]
    tensions: Option<NumberList>,

    /// Load that the tensions of an elastic model balance, in place of the robot's wrench and weight: fx,fy | fx,fy,m |
    /// fx,fy,fz | fx,fy,fz,mx,my,mz (N, N·m).
    #[arg(long, value_name = "WRENCH", allow_hyphen_values = true)]
    wrench: Option<NumberList>,

    #[command(flatten)]
    compensation: CompensationOption,

    /// Shows how lengths, wrapped arcs and contact points follow the pose, and angular velocity the rates of the angles; `--format json`
    /// always does.
    #[arg(long)]
    jacobians: bool,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    check_forces(&model, &arguments)?;
    let (pose, hanging) = match (&arguments.pose, &arguments.position) {
        (Some(pose), _) => (pose_of(model.robot(), "--pose", pose)?, None),
        (None, Some(position)) => {
            let at = position_of(model.robot(), "--position", position)?;
            let hanging = hanging_at(&model, &at, arguments.wrench.as_ref())?;
            match hanging.found.first() {
                Some(first) => (first.pose, Some(hanging)),
                None => return output.answer(&NoHangingAnswer::new(&model, &at, &hanging)),
            }
        }
        (None, None) => {
            let help = "give --pose, or --position of a platform that hangs";
            return Err(Failure::input("usage::missing-argument", "neither pose nor position is given", help));
        }
    };
    let map = arguments.compensation.read(&model)?;
    let mut state = State::at(&model, &pose);
    let command = |tensions: &[f64], state: &mut State| {
        let solution = model.inverse(&pose, tensions, state).map_err(|error| refused("--tensions", &error))?;
        check(solution)?;
        let answer = InverseAnswer::new(&model, solution).showing_jacobians(arguments.jacobians);
        Ok::<_, Failure>((answer, solution.needs_tensions()))
    };
    let (mut answer, needs_tensions) = command(&vec![f64::NAN; model.cable_count()], &mut state)?;
    if answer.is_negative() {
        return output.answer(&answer);
    }
    if let Some(hanging) = &hanging {
        let tensions = hanging.found[0].tensions.clone();
        if needs_tensions {
            answer = command(&tensions, &mut state)?.0;
        }
        answer = answer.with_tensions(tensions).hanging(&model, hanging);
    } else if needs_tensions {
        match tensions_of(&model, &pose, arguments.wrench.as_ref(), arguments.tensions.as_ref())? {
            Chosen::Tensions(tensions) => answer = command(&tensions, &mut state)?.0.with_tensions(tensions),
            Chosen::None { status, reason } => answer = answer.without_tensions(status, reason),
        }
    } else if arguments.tensions.is_some() || arguments.wrench.is_some() {
        let elastic = Composition { stretch: StretchEffect::Linear, ..model.composition() };
        output.remark(&format!(
            "the cables of model `{}` are rigid: tensions and wrench change nothing; `--model {elastic}` asks for elastic ones",
            model.composition()
        ));
    }
    if let Some(doubt) = NotAtRest::of(&model, &pose).filter(|_| hanging.is_none() && arguments.wrench.is_none()) {
        answer = answer.with_warning(format!(
            "the load does not let the platform rest at this pose: {}; `--position` tells the rest of a pose by the load",
            doubt.words(model.robot())
        ));
    }
    if let Some((map, _)) = map {
        answer = answer.with_correction(&model, &pose, &map).map_err(|error| Failure::refused("--pose", &error))?;
    }
    output.answer(&answer)
}

/// Refuses tensions that the cables cannot have, and numbers that overflow; poses without a unique path have an answer.
fn check(solution: &InverseSolution) -> Result<(), Failure> {
    if let Some(failure) = solution.failures.iter().find(|failure| !has_no_path(failure)) {
        return Err(refused("--tensions", failure));
    }
    solution.winch_failures.first().map_or(Ok(()), |failure| Err(Failure::refused("--pose", failure)))
}

/// Tensions and wrench are right in number and kind, whether they are needed or not.
fn check_forces(model: &Model, arguments: &Arguments) -> Result<(), Failure> {
    if let Some(NumberList(tensions)) = &arguments.tensions {
        check_tensions(model, tensions).map_err(|error| refused("--tensions", &error))?;
    }
    arguments.wrench.iter().try_for_each(|numbers| wrench_of(model.robot(), "--wrench", numbers).map(|_| ()))
}
