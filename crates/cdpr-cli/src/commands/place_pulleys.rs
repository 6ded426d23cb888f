//! `cdpr place-pulleys`: from anchors of the point model to pulleys.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_model::model::place_pulleys;
use cdpr_model::robot::Robot;
use clap::Args;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::files;
use crate::inputs::{RobotArgument, pose_or_home};
use crate::numbers::{NumberList, number_from_zero};
use cdpr_reports::answers::{PoseAnswer, axis_names, components};
use cdpr_reports::number_format::cell;
use cdpr_reports::table::Table;

const EXAMPLES: &str = "\
Examples:
  cdpr place-pulleys cogiro --axis 0,0,1 --radius 0.05 --out with-pulleys.toml
  cdpr place-pulleys planar-example --axis 0,1 --axis 0,1 --axis=-1,0 --axis 1,0 --out with-pulleys.toml
  cdpr ik with-pulleys.toml --model pulley --pose 0,4";

/// Give every cable a swivelling pulley whose contact point, at one pose, is the anchor of the file.
///
/// Published anchors mostly belong to the point model. The pulley is placed so that lengths (but for the wrapped part)
/// and directions at that pose stay the same; elsewhere the pulley shows.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    robot: RobotArgument,

    /// Swivel axis from the winch into the pulley (world; of any length): once for all cables, or once a cable in their order; those of
    /// the file when left out.
    #[arg(long = "axis", value_name = "AXIS", allow_hyphen_values = true)]
    axes: Vec<NumberList>,

    /// Pulley radius of every cable (m); that of the file when left out.
    #[arg(long, value_name = "RADIUS", value_parser = number_from_zero, allow_hyphen_values = true)]
    radius: Option<f64>,

    /// Pose at which both models agree; the home pose when left out.
    #[arg(long, value_name = "POSE", allow_hyphen_values = true)]
    pose: Option<NumberList>,

    /// Robot file to write.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

/// Pulleys placed so that cables leave them through the anchors of the point model.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "PlacedPulleys")]
pub(super) struct Placed {
    robot: String,
    pose: PoseAnswer,
    out: String,
    /// Cables with their pulleys.
    cables: Vec<PlacedCable>,
    #[serde(skip)]
    axes: Vec<String>,
}

/// Pulley of a cable.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "PlacedPulley")]
pub(super) struct PlacedCable {
    name: String,
    /// Radius of the pulley (m); null without one.
    pulley_radius_m: Option<f64>,
    /// Anchor on the frame (m).
    frame_anchor_m: Vec<f64>,
    /// Distance of the anchor from the given one (m).
    moved_m: f64,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let robot = arguments.robot.read()?;
    let axes = swivel_axes(&robot, &arguments.axes)?;
    let pose = pose_or_home(&robot, "--pose", arguments.pose.as_ref())?;
    let radius = |(index, cable): (usize, &cdpr_model::robot::Cable)| {
        arguments.radius.or(cable.pulley_radius()).map(|radius| (radius, axes[index])).ok_or_else(|| {
            let message = format!("cable {} (\"{}\") has no pulley_radius_m", index + 1, cable.name);
            Failure::input(
                "model::missing-key",
                message,
                "add the key to the robot file, or give one radius for all with --radius",
            )
        })
    };
    let pulleys = robot.cables.iter().enumerate().map(radius).collect::<Result<Vec<_>, _>>()?;
    let placed = place_pulleys(&robot, &pulleys, &pose)
        .map_err(|error| Failure::refused("the pulleys have no place", &error))?;
    files::write(&arguments.out, placed.to_toml().as_bytes())?;
    let cables = placed.cables.iter().zip(&robot.cables).map(|(cable, before)| PlacedCable {
        name: cable.name.clone(),
        pulley_radius_m: cable.pulley_radius(),
        frame_anchor_m: components(&robot, &cable.frame_anchor),
        moved_m: (cable.frame_anchor - before.frame_anchor).norm(),
    });
    output.answer(&Placed {
        cables: cables.collect(),
        pose: PoseAnswer::new(&robot, &pose),
        out: arguments.out.display().to_string(),
        axes: axis_names(&robot),
        robot: robot.name,
    })
}

/// The axis of every cable as a unit vector of the world.
fn swivel_axes(robot: &Robot, given: &[NumberList]) -> Result<Vec<Vector3<f64>>, Failure> {
    let cables = robot.cable_count();
    let refused = |message: String, help: &str| Err(Failure::input("pulley::radius-or-axis", message, help));
    match given {
        [] => match robot.cables.iter().position(|cable| cable.pulley_swivel_axis().is_none()) {
            None => Ok(robot.cables.iter().filter_map(|cable| cable.pulley_swivel_axis()).collect()),
            Some(lacking) => {
                let (number, name) = (lacking + 1, &robot.cables[lacking].name);
                let message = format!("cable {number} (\"{name}\") has no pulley_swivel_axis, and no --axis is given");
                refused(message, "give one axis for all, --axis 0,0,1, or --axis once a cable")
            }
        },
        [one] => Ok(vec![swivel_axis(robot, one)?; cables]),
        each if each.len() == cables => each.iter().map(|axis| swivel_axis(robot, axis)).collect(),
        each => {
            let message = format!("--axis is given {} times; the robot has {cables} cables", each.len());
            refused(message, "give it once for all cables, or once a cable")
        }
    }
}

/// An axis as a unit vector of the world.
fn swivel_axis(robot: &Robot, numbers: &NumberList) -> Result<Vector3<f64>, Failure> {
    let axis = match (robot.motion_pattern.is_planar(), numbers.0.as_slice()) {
        (true, &[first, second]) => robot.plane.embed([first, second]),
        (_, &[x, y, z]) => Vector3::new(x, y, z),
        (planar, found) => {
            let expected = if planar { "2 components in the robot's plane, or 3" } else { "3 components" };
            let message = format!("--axis: {expected} expected, found {}", found.len());
            return Err(Failure::input(
                "pulley::radius-or-axis",
                message,
                "upwards is --axis 0,0,1, of a planar robot mostly --axis 0,1",
            ));
        }
    };
    axis.try_normalize(0.0).filter(|axis| axis.norm().is_finite()).ok_or_else(|| {
        Failure::input(
            "pulley::radius-or-axis",
            "--axis: a vector of length 0 has no direction",
            "upwards is --axis 0,0,1",
        )
    })
}

impl Answer for Placed {
    fn words(&self, width: Option<usize>) -> String {
        let mut heading = vec!["cable".to_owned(), "radius m".to_owned()];
        heading.extend(self.axes.iter().map(|axis| format!("frame anchor {axis} m")));
        heading.push("moved by mm".to_owned());
        let mut table = Table::with_heading(heading);
        for cable in &self.cables {
            let mut cells = vec![cable.name.clone(), cell(cable.pulley_radius_m, 4)];
            cells.extend(cable.frame_anchor_m.iter().map(|&x| cell(Some(x), 6)));
            cells.push(cell(Some(1e3 * cable.moved_m), 3));
            table.row(cells);
        }
        let heading = format!("{}: pulleys placed to agree with the point model at {}", self.robot, self.pose.words());
        format!("{heading}\n\n{}\nwritten to {}\n", table.text(width), self.out)
    }
}
