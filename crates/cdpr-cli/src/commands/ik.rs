//! `cdpr ik`: cable lengths and directions at a pose, and the lengths that winches must pay out.

use std::process::ExitCode;

use cdpr::cable::DegenerateCourse;
use cdpr::geometry::Pose;
use cdpr::model::{Composition, Model, StretchEffect};
use cdpr::nalgebra::Vector3;
use cdpr::robot::Cable;
use cdpr::statics::{check_tensions, controlled_lengths, holds};
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::inputs::{ModelArguments, pose_of, wrench_of};
use crate::numbers::NumberList;
use crate::pose_answer::{PoseAnswer, axis_names, components};
use crate::statics_failure::refused;
use crate::table::{Table, cell};
use crate::tension_choice::{Chosen, tensions_of};

const EXAMPLES: &str = "\
Examples:
  cdpr ik planar-example --pose 0.5,4
  cdpr ik cogiro --pose 0,0,1.5,0,0,0.1 --format json
  cdpr ik robot.toml --pose=-1,2 --model pulley
  cdpr ik robot.toml --pose=-1,2 --model pulley+drum
  cdpr ik planar-example --pose 0.5,4 --model elastic
  cdpr ik planar-example --pose 0.5,4 --model elastic --tensions 5900,6100,2500,2400";

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
}

/// Entries are null where a cable has no unique course, controlled lengths also where no tensions balance the load.
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
    #[serde(skip)]
    cable_names: Vec<String>,
    #[serde(skip)]
    axes: Vec<String>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let pose = pose_of(model.robot(), "--pose", &arguments.pose)?;
    check_forces(&model, &arguments)?;
    let mut answer = solve(&model, &pose)?;
    if model.composition().depends_on_tension() {
        answer.stretch(&model, &pose, &arguments)?;
    } else if arguments.tensions.is_some() || arguments.wrench.is_some() {
        let elastic = Composition { stretch: StretchEffect::Linear, ..model.composition() };
        output.remark(&format!(
            "the cables of model `{}` are rigid: tensions and wrench change nothing; `--model {elastic}` asks for elastic ones",
            model.composition()
        ));
    }
    answer.record(&model);
    if model.composition().drum {
        answer.wind(&model)?;
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

fn solve(model: &Model, pose: &Pose) -> Result<InverseKinematics, Failure> {
    let robot = model.robot();
    let courses: Vec<_> = (0..model.cable_count()).map(|cable| model.course(cable, pose).map(|(c, _)| c)).collect();
    let reasons: Vec<&DegenerateCourse> = courses.iter().filter_map(|course| course.as_ref().err()).collect();
    if let Some(overflow) = reasons.iter().find(|reason| matches!(reason, DegenerateCourse::NotFinite { .. })) {
        return Err(Failure::numerical(overflow.to_string()));
    }
    let reason = reasons.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ");
    let courses: Vec<_> = courses.iter().map(|course| course.as_ref().ok()).collect();
    let lengths: Vec<_> = courses.iter().map(|course| course.map(|course| course.length)).collect();
    let direction = |course: &cdpr::cable::Course<f64>| components(robot, &Vector3::from(course.direction));
    Ok(InverseKinematics {
        robot: robot.name.clone(),
        model: model.composition().to_string(),
        status: if reason.is_empty() { "solved" } else { "singular" },
        reason: (!reason.is_empty()).then_some(reason),
        pose: PoseAnswer::new(robot, pose),
        recorded_lengths_m: None,
        motor_angles_rad: None,
        encoder_counts: None,
        // a rigid cable is as long as its course
        controlled_lengths_m: lengths.clone(),
        cable_lengths_m: lengths,
        directions: courses.iter().map(|course| course.map(direction)).collect(),
        wrap_angles_rad: (model.composition().pulley)
            .then(|| courses.iter().map(|course| course.map(|course| course.wrap_angle)).collect()),
        tensions: None,
        platform_tensions: None,
        cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
        axes: axis_names(robot),
    })
}

impl InverseKinematics {
    /// Controlled lengths of elastic cables, under the tensions given or those of the load.
    fn stretch(&mut self, model: &Model, pose: &Pose, arguments: &Arguments) -> Result<(), Failure> {
        let geometric = std::mem::replace(&mut self.controlled_lengths_m, vec![None; model.cable_count()]);
        if geometric.contains(&None) {
            return Ok(());
        }
        let chosen = tensions_of(model, pose, arguments.wrench.as_ref(), arguments.tensions.as_ref())?;
        match chosen {
            Chosen::Tensions(tensions) => {
                if model.composition().has_closed_form() {
                    let lengths =
                        controlled_lengths(model, pose, &tensions).map_err(|error| refused("--tensions", &error))?;
                    self.controlled_lengths_m = lengths.into_iter().map(Some).collect();
                } else {
                    self.hang(model, pose, &tensions)?;
                }
                self.tensions = Some(tensions);
            }
            Chosen::None { status, reason } => (self.status, self.reason) = (status, Some(reason)),
        }
        Ok(())
    }

    /// Cables whose laws have no closed form: lengths, end tangents and wrap angles follow from the tensions together.
    fn hang(&mut self, model: &Model, pose: &Pose, tensions: &[f64]) -> Result<(), Failure> {
        let holds = holds(model, pose, tensions).map_err(|error| refused("--tensions", &error))?;
        for (cable, held) in holds.iter().enumerate() {
            self.controlled_lengths_m[cable] = Some(held.hold.controlled_length);
            self.cable_lengths_m[cable] = Some(held.hold.strained_length);
            self.directions[cable] = Some(components(model.robot(), &Vector3::from(held.hold.direction)));
            if let Some(angles) = &mut self.wrap_angles_rad {
                angles[cable] = Some(held.hold.wrap_angle);
            }
        }
        if model.composition().is_sagging() {
            self.platform_tensions = Some(holds.iter().map(|held| held.hold.platform_tension).collect());
        }
        Ok(())
    }

    /// What the robot would record, where its file says that this is something else.
    fn record(&mut self, model: &Model) {
        let is_calibrated = |cable: &Cable| cable.length_scale.is_some() || cable.length_offset.is_some();
        if model.robot().cables.iter().any(is_calibrated) {
            let controlled = self.controlled_lengths_m.iter().enumerate();
            let recorded = controlled.map(|(cable, length)| length.map(|length| model.recorded_length(cable, length)));
            self.recorded_lengths_m = Some(recorded.collect());
        }
    }

    /// What the motors are told.
    fn wind(&mut self, model: &Model) -> Result<(), Failure> {
        let angle =
            |(cable, length): (usize, &Option<f64>)| length.map(|length| model.motor_angle(cable, length)).transpose();
        let angles: Vec<Option<f64>> = self
            .controlled_lengths_m
            .iter()
            .enumerate()
            .map(angle)
            .collect::<Result<_, _>>()
            .map_err(|error| Failure::refused("--pose", &error))?;
        let count = |(cable, angle): (usize, &Option<f64>)| model.winch(cable)?.encoder_counts((*angle)?);
        let counts: Vec<Option<f64>> = angles.iter().enumerate().map(count).collect();
        self.encoder_counts = counts.iter().any(Option::is_some).then_some(counts);
        self.motor_angles_rad = Some(angles);
        Ok(())
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
        format!("{text}\n{}", table.text())
    }
}
