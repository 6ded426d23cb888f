//! `cdpr modes`: natural frequencies and mode shapes.

use std::process::ExitCode;

use cdpr_model::model::Composition;
use cdpr_model::statics::wrench_residual;
use cdpr_plant::{Plant, PlantError, Winches};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};

use crate::answer::Output;
use crate::failure::Failure;
use crate::inputs::{PoseArgument, RobotArgument};
use crate::numbers::NumberList;
use crate::statics_failure;
use crate::tension_choice::{Chosen, tensions_of};
use cdpr_reports::answers::ModesAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr modes studies/robots/simulator-in-motion.toml --pose 0,0,1.5,0,0,0
  cdpr modes robot.toml --pose 0,0,1.5,0,0,0 --model pulley+elastic --tensions 3678,2169,4250,1708,3985,2394,4715,1684
  cdpr modes robot.toml --pose 0,0,1.5,0,0,0 --winches drums --format json";

/// Natural frequencies, damping and mode shapes of the platform at a pose, and the linear system behind them.
///
/// Small motions about the equilibrium at the pose, M δz̈ + D δż + K δz = input, with the stiffness of the cables as `cdpr stiffness` tells it, the
/// mass, centre of mass and inertia of the robot file and the damping of its cables; with drums their angles are degrees of freedom too. JSON has
/// the matrices A and B of ẏ = A y + B u.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    robot: RobotArgument,

    /// Effects of the model, joined by `+`; cables must stretch.
    #[arg(long, default_value_t = Composition::ELASTIC, value_name = "MODEL")]
    model: Composition,

    #[command(flatten)]
    pose: PoseArgument,

    /// Cable tensions in balance with the load, one per cable (N); those nearest the middle of the limits when left out.
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true)]
    tensions: Option<NumberList>,

    /// Winches that hold their lengths, or drums with inertia that hold their torques.
    #[arg(long, default_value = "ideal", value_name = "ideal|drums", value_parser = winches())]
    #[arg(hide_possible_values = true)]
    winches: Winches,
}

/// Winches by their names.
fn winches() -> impl TypedValueParser<Value = Winches> {
    let named = |name: String| if name == "drums" { Winches::Drums } else { Winches::Ideal };
    PossibleValuesParser::new(["ideal", "drums"]).map(named)
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.robot.model(arguments.model)?;
    output.about(&model.robot().name);
    let pose = arguments.pose.of(model.robot())?;
    let refused = |error: PlantError| Failure::refused("ROBOT", &error);
    let plant = Plant::new(model, arguments.winches).map_err(refused)?;
    let tensions = match tensions_of(plant.model(), &pose, None, arguments.tensions.as_ref())? {
        Chosen::Tensions(tensions) => tensions,
        Chosen::None { reason, .. } => {
            let message = format!("--pose: there is no equilibrium to swing about: {reason}");
            return Err(Failure::input("plant::no-equilibrium", message, "choose another pose, or give --tensions"));
        }
    };
    let state = plant.at_rest(&pose, &tensions).map_err(refused)?;
    let linear = plant.linearize(&state).map_err(refused)?;
    let residual = wrench_residual(plant.model(), &pose, &tensions, plant.load());
    let residual = residual.map_err(|error| statics_failure::refused("--tensions", &error))?;
    output.answer(&ModesAnswer::new(&plant, &pose, residual.as_slice(), &state, &linear))
}
