//! `cdpr ik`: cable lengths and directions at a pose, and the lengths that winches must pay out.

mod jacobians;

use std::process::ExitCode;

use cdpr::equilibrium::{CableCommand, InverseSolution, State};
use cdpr::model::{Composition, Model, StretchEffect};
use cdpr::nalgebra::Vector3;
use cdpr::robot::Cable;
use cdpr::statics::{StaticsError, check_tensions};
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::inputs::{ModelArguments, pose_of, wrench_of};
use crate::numbers::NumberList;
use crate::statics_failure::{has_no_path, refused};
use crate::table::{Table, cell};
use crate::tension_choice::{Chosen, tensions_of};
use cdpr_reports::answers::{PoseAnswer, axis_names, components};
use jacobians::Jacobians;

const EXAMPLES: &str = "\
Examples:
  cdpr ik planar-example --pose 0.5,4
  cdpr ik cogiro --pose 0,0,1.5,0,0,0.1 --format json
  cdpr ik robot.toml --pose=-1,2 --model pulley
  cdpr ik robot.toml --pose=-1,2 --model pulley+drum
  cdpr ik planar-example --pose 0.5,4 --model elastic
  cdpr ik planar-example --pose 0.5,4 --model elastic --tensions 5900,6100,2500,2400
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
    #[arg(long, value_name = "POSE", allow_hyphen_values = true)]
    pose: NumberList,

    /// Cable tensions of an elastic model, one per cable (N), not judged against limits; those nearest the middle of the
    /// limits that balance the load when left out.
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true)]
    tensions: Option<NumberList>,

    /// Load that the tensions of an elastic model balance, in place of the robot's wrench and weight: fx,fy | fx,fy,m |
    /// fx,fy,fz | fx,fy,fz,mx,my,mz (N, N·m).
    #[arg(long, value_name = "WRENCH", allow_hyphen_values = true)]
    wrench: Option<NumberList>,

    /// Shows how lengths, wrapped arcs and contact points follow the pose, and angular velocity the rates of the angles; `--format json`
    /// always does.
    #[arg(long)]
    jacobians: bool,
}

/// Entries are null where a cable has no unique path, controlled lengths also where no tensions balance the load.
#[derive(Serialize)]
struct InverseKinematics {
    robot: String,
    model: String,
    status: &'static str,
    reason: Option<String>,
    pose: PoseAnswer,
    cable_lengths_m: Vec<Option<f64>>,
    controlled_lengths_m: Vec<Option<f64>>,
    directions: Vec<Option<Vec<f64>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    wrap_angles_rad: Option<Vec<Option<f64>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    recorded_lengths_m: Option<Vec<Option<f64>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    motor_angles_rad: Option<Vec<Option<f64>>>,
    /// Null where the file does not say how its encoder counts.
    #[serde(skip_serializing_if = "Option::is_none")]
    encoder_counts: Option<Vec<Option<f64>>>,
    #[serde(rename = "tensions_N", skip_serializing_if = "Option::is_none")]
    tensions: Option<Vec<f64>>,
    /// At the platform anchors, where they differ from those at the outlets.
    #[serde(rename = "platform_tensions_N", skip_serializing_if = "Option::is_none")]
    platform_tensions: Option<Vec<f64>>,
    jacobians: Jacobians,
    #[serde(skip)]
    shows_jacobians: bool,
    #[serde(skip)]
    cable_names: Vec<String>,
    #[serde(skip)]
    axes: Vec<String>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let pose = pose_of(model.robot(), "--pose", &arguments.pose)?;
    check_forces(&model, &arguments)?;
    let mut state = State::at(&model, &pose);
    let command = |tensions: &[f64], state: &mut State| {
        let solution = model.inverse(&pose, tensions, state).map_err(|error| refused("--tensions", &error))?;
        let answer = InverseKinematics::of(&model, solution)?;
        Ok::<_, Failure>((
            InverseKinematics { shows_jacobians: arguments.jacobians, ..answer },
            solution.needs_tensions(),
        ))
    };
    let (mut answer, needs_tensions) = command(&vec![f64::NAN; model.cable_count()], &mut state)?;
    if answer.reason.is_some() {
        return output.answer(&answer);
    }
    if needs_tensions {
        match tensions_of(&model, &pose, arguments.wrench.as_ref(), arguments.tensions.as_ref())? {
            Chosen::Tensions(tensions) => {
                answer = command(&tensions, &mut state)?.0;
                answer.tensions = Some(tensions);
            }
            Chosen::None { status, reason } => (answer.status, answer.reason) = (status, Some(reason)),
        }
    } else if arguments.tensions.is_some() || arguments.wrench.is_some() {
        let elastic = Composition { stretch: StretchEffect::Linear, ..model.composition() };
        output.remark(&format!(
            "the cables of model `{}` are rigid: tensions and wrench change nothing; `--model {elastic}` asks for elastic ones",
            model.composition()
        ));
    }
    output.answer(&answer)
}

/// Tensions and wrench are right in number and kind, whether they are needed or not.
fn check_forces(model: &Model, arguments: &Arguments) -> Result<(), Failure> {
    if let Some(NumberList(tensions)) = &arguments.tensions {
        check_tensions(model, tensions).map_err(|error| refused("--tensions", &error))?;
    }
    arguments.wrench.iter().try_for_each(|numbers| wrench_of(model.robot(), "--wrench", numbers).map(|_| ()))
}

impl InverseKinematics {
    /// The answer in its units; refuses tensions that the cables cannot have, and numbers that overflow.
    fn of(model: &Model, solution: &InverseSolution) -> Result<Self, Failure> {
        let mut reasons = Vec::new();
        for failure in &solution.failures {
            match failure {
                StaticsError::CablePath(reason) if has_no_path(failure) => reasons.push(reason.to_string()),
                _ => return Err(refused("--tensions", failure)),
            }
        }
        if let Some(failure) = solution.winch_failures.first() {
            return Err(Failure::refused("--pose", failure));
        }
        let robot = model.robot();
        let known = |of: fn(&CableCommand) -> f64| -> Vec<Option<f64>> {
            solution.cables.iter().map(of).map(|number| number.is_finite().then_some(number)).collect()
        };
        let lengths = known(|cable| cable.length);
        let direction = |cable: &CableCommand| components(robot, &Vector3::from(cable.direction));
        let directions = solution.cables.iter().zip(&lengths).map(|(cable, length)| length.map(|_| direction(cable)));
        let is_calibrated = |cable: &Cable| cable.length_scale.is_some() || cable.length_offset.is_some();
        let counts: Vec<_> = solution.cables.iter().map(|cable| cable.encoder_counts).collect();
        let platform_tensions: Option<Vec<f64>> = solution.cables.iter().map(|cable| cable.platform_tension).collect();
        Ok(Self {
            robot: robot.name.clone(),
            model: model.composition().to_string(),
            status: if reasons.is_empty() { "solved" } else { "singular" },
            reason: (!reasons.is_empty()).then(|| reasons.join("; ")),
            pose: PoseAnswer::new(robot, &solution.pose),
            recorded_lengths_m: robot.cables.iter().any(is_calibrated).then(|| known(|cable| cable.recorded_length)),
            motor_angles_rad: (model.composition().drum)
                .then(|| solution.cables.iter().map(|cable| cable.motor_angle).collect()),
            encoder_counts: counts.iter().any(Option::is_some).then_some(counts),
            controlled_lengths_m: known(|cable| cable.controlled_length),
            directions: directions.collect(),
            wrap_angles_rad: (model.composition().pulley).then(|| known(|cable| cable.wrap_angle)),
            cable_lengths_m: lengths,
            tensions: None,
            platform_tensions,
            jacobians: Jacobians::at(model, &solution.pose),
            shows_jacobians: false,
            cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
            axes: axis_names(robot),
        })
    }
}

impl Answer for InverseKinematics {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self) -> String {
        let mut text = format!("{}, model {}, at {}\n", self.robot, self.model, self.pose.words());
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{}: {reason}\n", self.status));
        }
        let mut heading = vec!["cable".to_owned(), "length m".to_owned()];
        let is_elastic = self.controlled_lengths_m != self.cable_lengths_m;
        heading.extend(is_elastic.then(|| "controlled m".to_owned()));
        heading.extend(self.recorded_lengths_m.iter().map(|_| "recorded m".to_owned()));
        heading.extend(self.motor_angles_rad.iter().map(|_| "motor rad".to_owned()));
        heading.extend(self.encoder_counts.iter().map(|_| "counts".to_owned()));
        heading.extend(self.tensions.iter().map(|_| "tension N".to_owned()));
        heading.extend(self.platform_tensions.iter().map(|_| "at platform N".to_owned()));
        heading.extend(self.axes.iter().map(|axis| format!("pull {axis}")));
        heading.extend(self.wrap_angles_rad.iter().map(|_| "wrap °".to_owned()));
        let mut table = Table::with_heading(heading);
        for (cable, name) in self.cable_names.iter().enumerate() {
            let mut cells = vec![name.clone(), cell(self.cable_lengths_m[cable], 6)];
            cells.extend(is_elastic.then(|| cell(self.controlled_lengths_m[cable], 6)));
            cells.extend(self.recorded_lengths_m.iter().map(|recorded| cell(recorded[cable], 6)));
            cells.extend(self.motor_angles_rad.iter().map(|angles| cell(angles[cable], 6)));
            cells.extend(self.encoder_counts.iter().map(|counts| cell(counts[cable], 0)));
            cells.extend(self.tensions.iter().map(|tensions| cell(Some(tensions[cable]), 3)));
            cells.extend(self.platform_tensions.iter().map(|tensions| cell(Some(tensions[cable]), 3)));
            let direction = self.directions[cable].as_ref();
            cells.extend((0..self.axes.len()).map(|axis| cell(direction.map(|u| u[axis]), 6)));
            cells.extend(self.wrap_angles_rad.iter().map(|angles| cell(angles[cable].map(f64::to_degrees), 3)));
            table.row(cells);
        }
        let jacobians = self.shows_jacobians.then(|| self.jacobians.words(&self.cable_names, &self.axes));
        format!("{text}\n{}{}", table.text(), jacobians.unwrap_or_default())
    }
}
