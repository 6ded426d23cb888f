//! `cdpr ik`: cable lengths and directions at a pose.

use std::process::ExitCode;

use cdpr::cable::DegenerateCourse;
use cdpr::geometry::Pose;
use cdpr::model::Model;
use cdpr::nalgebra::Vector3;
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::inputs::{ModelArguments, pose_of};
use crate::numbers::NumberList;
use crate::pose_answer::{PoseAnswer, axis_names, components};
use crate::table::{Table, cell};

const EXAMPLES: &str = "\
Examples:
  cdpr ik planar-example --pose 0.5,4
  cdpr ik cogiro --pose 0,0,1.5,0,0,0.1 --format json
  cdpr ik robot.toml --pose=-1,2 --model pulley";

/// Inverse kinematics: cable lengths, directions and wrap angles at a pose.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    /// Platform pose (m, rad): x,y | x,y,angle | x,y,z | x,y,z,rx,ry,rz, as the robot's motion pattern has it.
    #[arg(long, value_name = "POSE", allow_hyphen_values = true)]
    pose: NumberList,
}

/// Entries are null where a cable has no unique course.
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
    #[serde(skip)]
    cable_names: Vec<String>,
    #[serde(skip)]
    axes: Vec<String>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let pose = pose_of(model.robot(), "--pose", &arguments.pose)?;
    output.answer(&solve(&model, &pose)?)
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
    let has_calibration =
        robot.cables.iter().any(|cable| cable.length_scale.is_some() || cable.length_offset.is_some());
    let recorded = lengths.iter().enumerate().map(|(cable, q)| q.map(|q| model.recorded_length(cable, q)));
    let direction = |course: &cdpr::cable::Course<f64>| components(robot, &Vector3::from(course.direction));
    Ok(InverseKinematics {
        robot: robot.name.clone(),
        model: model.composition().to_string(),
        status: if reason.is_empty() { "solved" } else { "singular" },
        reason: (!reason.is_empty()).then_some(reason),
        pose: PoseAnswer::new(robot, pose),
        recorded_lengths_m: has_calibration.then(|| recorded.collect()),
        // a rigid cable is as long as its course
        controlled_lengths_m: lengths.clone(),
        cable_lengths_m: lengths,
        directions: courses.iter().map(|course| course.map(direction)).collect(),
        wrap_angles_rad: (model.composition().pulley)
            .then(|| courses.iter().map(|course| course.map(|course| course.wrap_angle)).collect()),
        cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
        axes: axis_names(robot),
    })
}

impl Answer for InverseKinematics {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self) -> String {
        let mut text = format!("{}, model {}, at {}\n", self.robot, self.model, self.pose.words());
        if let Some(reason) = &self.reason {
            text.push_str(&format!("singular: {reason}\n"));
        }
        let mut heading = vec!["cable".to_owned(), "length m".to_owned()];
        heading.extend(self.recorded_lengths_m.iter().map(|_| "recorded m".to_owned()));
        heading.extend(self.axes.iter().map(|axis| format!("pull {axis}")));
        heading.extend(self.wrap_angles_rad.iter().map(|_| "wrap °".to_owned()));
        let mut table = Table::with_heading(heading);
        for (cable, name) in self.cable_names.iter().enumerate() {
            let mut cells = vec![name.clone(), cell(self.cable_lengths_m[cable], 6)];
            cells.extend(self.recorded_lengths_m.iter().map(|recorded| cell(recorded[cable], 6)));
            let direction = self.directions[cable].as_ref();
            cells.extend((0..self.axes.len()).map(|axis| cell(direction.map(|u| u[axis]), 6)));
            cells.extend(self.wrap_angles_rad.iter().map(|angles| cell(angles[cable].map(f64::to_degrees), 3)));
            table.row(cells);
        }
        format!("{text}\n{}", table.text())
    }
}
