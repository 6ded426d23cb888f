//! `cdpr stiffness`: how stiffly the cables hold the platform.

use std::process::ExitCode;

use cdpr_model::model::{Composition, StretchEffect};
use cdpr_model::statics::{Stiffness, wrench_residual};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::inputs::{PoseArgument, RobotArgument, load_of};
use crate::numbers::NumberList;
use crate::statics_failure::{has_no_path, refused};
use crate::tension_choice::{Chosen, tensions_of};
use cdpr_reports::answers::StiffnessAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr stiffness planar-example --pose 0,5.2
  cdpr stiffness cablerobot-simulator-helicopter --pose 0,0,1.5,0,0,0 --tensions 3678,2169,4250,1708,3985,2394,4715,1684
  cdpr stiffness robot.toml --pose 0,0,2,0,0,0 --model pulley+elastic --wrench 0,0,-5500,0,-480,0 --format json";

/// Stiffness and compliance of the platform at a pose, and whether it is a stable equilibrium.
///
/// Displacements are [δr; δφ] in world axes, turns about the platform origin, controlled cable lengths stay fixed:
/// K = K_C − K_G − ∂w/∂x from the stretch of the cables, their turning, and the weight's moment.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    robot: RobotArgument,

    /// Effects of the model, joined by `+`; cables must stretch, since rigid ones do not give way.
    #[arg(long, default_value_t = Composition::ELASTIC, value_name = "MODEL")]
    model: Composition,

    #[command(flatten)]
    pose: PoseArgument,

    /// Cable tensions, one per cable (N); those nearest the middle of the limits that balance the load when left out.
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true)]
    tensions: Option<NumberList>,

    /// Constant load in place of the robot's wrench and weight: fx,fy | fx,fy,m | fx,fy,fz | fx,fy,fz,mx,my,mz (N, N·m).
    #[arg(long, value_name = "WRENCH", allow_hyphen_values = true)]
    wrench: Option<NumberList>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.robot.model(arguments.model)?;
    if !model.needs_tensions() {
        let elastic = Composition { stretch: StretchEffect::Linear, ..model.composition() };
        let message = format!("--model {}: its cables are rigid, so the stiffness is infinite", model.composition());
        return Err(Failure::input("stiffness::rigid-cable", message, format!("use `--model {elastic}`")));
    }
    let pose = arguments.pose.of(model.robot())?;
    let load = load_of(model.robot(), arguments.wrench.as_ref())?;
    let answer = StiffnessAnswer::new(&model, &pose);
    let tensions = match tensions_of(&model, &pose, arguments.wrench.as_ref(), arguments.tensions.as_ref())? {
        Chosen::Tensions(tensions) => tensions,
        Chosen::None { status, reason } => return output.answer(&answer.refused(status, reason)),
    };
    let answer = match Stiffness::at(&model, &pose, &tensions, &load) {
        Ok(stiffness) => {
            let residual = wrench_residual(&model, &pose, &tensions, &load);
            let residual = residual.map_err(|error| refused("--tensions", &error))?;
            if !stiffness.system.iter().all(|x| x.is_finite()) {
                let message = "the stiffness overflows; check the units of tensions, stiffness and lengths";
                return Err(Failure::numerical(message));
            }
            answer.with(&model, &stiffness, tensions, residual.as_slice())
        }
        Err(error) if has_no_path(&error) => answer.refused("singular", error.to_string()),
        Err(error) => return Err(refused("--tensions", &error)),
    };
    output.answer(&answer)
}
