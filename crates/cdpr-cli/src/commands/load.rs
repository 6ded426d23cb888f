//! `cdpr load`: what the cables' tensions say about the load.

use std::process::ExitCode;

use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::inputs::{ModelArguments, PoseArgument};
use crate::numbers::{NumberList, Unreadable};
use crate::statics_failure::refused;
use cdpr_reports::answers::LoadAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr load planar-example --pose 0,5.2 --tensions 5808,5909,2390,2421
  cdpr load cablerobot-simulator-helicopter-kinematic-calibrated --pose 0,0,1.5,0,0,0 \\
    --tensions 3678,2169,4250,1708,3985,2394,4715,1684 --group upper=1,3,5,7 --group lower=2,4,6,8
  cdpr load calibrated.toml --pose 0,0,1.5,0,0,0 --recorded --tensions 3710,2190,4260,1700,3990,2400,4720,1690";

/// Load estimation: the external wrench that cable tensions balance, and the tensions' internal and external part.
///
/// The wrench is constant in world axes, its moment about the platform origin: the weight is part of it. The external part
/// of the tensions carries that wrench, the internal part only tightens the cables against each other (eq. 2.40); both add
/// up to the tensions.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pose: PoseArgument,

    /// Cable tensions, one per cable (N), pull positive.
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true)]
    tensions: NumberList,

    /// The tensions are as the robot records them: remove the file's tension_scale and tension_offset_N first.
    #[arg(long)]
    recorded: bool,

    /// Also the wrench that a group of cables exerts on the platform: a name and cable numbers; may be repeated.
    #[arg(long = "group", value_name = "NAME=1,3,…", value_parser = group)]
    groups: Vec<(String, Vec<usize>)>,
}

/// A named group of cables by their numbers from 1, `upper=1,3,5,7`.
fn group(text: &str) -> Result<(String, Vec<usize>), Unreadable> {
    let form = "a name, `=` and cable numbers expected, e.g. upper=1,3,5,7";
    let (name, numbers) = text.split_once('=').ok_or(form)?;
    if name.trim().is_empty() || numbers.trim().is_empty() {
        return Err(form.into());
    }
    let number = |word: &str| match word.trim().parse::<usize>() {
        Ok(number) if number > 0 => Ok(number),
        _ => Err(Unreadable::from(format!("`{}` is not a cable number; cables are counted from 1", word.trim()))),
    };
    Ok((name.trim().to_owned(), numbers.split(',').map(number).collect::<Result<_, _>>()?))
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let robot = model.robot();
    let pose = arguments.pose.of(robot)?;
    let mut tensions = arguments.tensions.0;
    if arguments.recorded {
        tensions.iter_mut().enumerate().take(model.cable_count()).for_each(|(cable, tension)| {
            *tension = model.real_tension(cable, *tension);
        });
    }
    let answer = LoadAnswer::of(&model, &pose, tensions, &arguments.groups);
    let answer = answer.map_err(|error| refused("--tensions", &error))?;
    if !answer.is_finite() {
        return Err(Failure::numerical("the wrench of these tensions overflows; check their unit (N)"));
    }
    output.answer(&answer)
}
