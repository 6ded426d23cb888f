//! The orientations that count.

use cdpr_model::geometry::MotionPattern;
use cdpr_model::model::Model;
use cdpr_workspace::{Archetype, WorkspaceError};
use clap::{Args, ValueEnum};
use nalgebra::UnitQuaternion;

use crate::failure::Failure;
use crate::numbers::NumberList;

/// Options about orientations.
#[derive(Debug, Args)]
pub(crate) struct OrientationArguments {
    /// Orientation of the platform: rx,ry,rz with R = Rx Ry Rz, or the angle in a plane (rad); 0 when left out.
    #[arg(long, value_name = "ROTATION", allow_hyphen_values = true, conflicts_with = "angles")]
    pub(super) rotation: Option<NumberList>,

    /// Which orientations count: one of them (`constant-orientation`), every one of --angles (`total-orientation`), one of
    /// --angles at least (`inclusion-orientation`), any orientation at all (`maximal`), all orientations (`dextrous`).
    #[arg(long, value_enum, default_value_t = Kind::ConstantOrientation, value_name = "ARCHETYPE")]
    #[arg(hide_possible_values = true)]
    archetype: Kind,

    /// Set of orientations: least, largest and number of values of each angle rx, ry, rz, or of the angle in a plane (rad).
    #[arg(long, value_name = "ANGLES", allow_hyphen_values = true)]
    angles: Option<NumberList>,

    /// Orientations that stand for all, spread evenly, of `maximal` and `dextrous`; that of --rotation counts besides.
    #[arg(long, value_name = "N", default_value_t = 100)]
    orientations: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Kind {
    ConstantOrientation,
    TotalOrientation,
    InclusionOrientation,
    Maximal,
    Dextrous,
}

/// More orientations of a set are a slip of the finger.
const MOST: f64 = 1e6;

impl OrientationArguments {
    /// The archetype; `center` is the orientation of the centre, if that was given.
    pub(super) fn archetype(&self, model: &Model, center: Option<UnitQuaternion<f64>>) -> Result<Archetype, Failure> {
        match self.archetype {
            Kind::ConstantOrientation if self.angles.is_some() => Err(Failure::input(
                "workspace::orientations",
                "--angles gives a set of orientations, but only one counts",
                "add --archetype total-orientation or inclusion-orientation, or give --rotation",
            )),
            Kind::ConstantOrientation => Ok(Archetype::ConstantOrientation(self.constant(model, center)?)),
            Kind::TotalOrientation => Ok(Archetype::TotalOrientation(self.set(model)?)),
            Kind::InclusionOrientation => Ok(Archetype::InclusionOrientation(self.set(model)?)),
            Kind::Maximal => {
                Ok(Archetype::Maximal { besides: self.constant(model, center)?, orientations: self.orientations })
            }
            Kind::Dextrous => {
                Ok(Archetype::Dextrous { besides: self.constant(model, center)?, orientations: self.orientations })
            }
        }
    }

    /// The one orientation: that of --rotation, or of the center, or none.
    fn constant(&self, model: &Model, center: Option<UnitQuaternion<f64>>) -> Result<UnitQuaternion<f64>, Failure> {
        let given = self.rotation.as_ref().map(|numbers| rotation(model, "--rotation", &numbers.0));
        Ok(given.transpose()?.or(center).unwrap_or_else(UnitQuaternion::identity))
    }

    /// Every combination of the values of each angle.
    fn set(&self, model: &Model) -> Result<Vec<UnitQuaternion<f64>>, Failure> {
        let numbers = self.angles.as_ref().map_or(&[][..], |numbers| &numbers.0);
        let count = angle_count(model);
        let refused = |message: String| {
            let help =
                "give least, largest and number of values of each angle, e.g. --angles -0.1,0.1,3,0,0,1,0,0,1 (rad)";
            Failure::input("workspace::orientations", message, help)
        };
        let is_count = |number: f64| number >= 1.0 && number.fract() == 0.0;
        if count > 0 && numbers.len() != 3 * count {
            return Err(refused(format!(
                "--angles takes {} numbers for this platform, found {}",
                3 * count,
                numbers.len()
            )));
        }
        if numbers.chunks(3).any(|range| range.len() == 3 && (!is_count(range[2]) || range[0] > range[1])) {
            return Err(refused(
                "--angles: a range is reversed, or its number of values is no whole number".to_owned(),
            ));
        }
        if numbers.chunks(3).filter_map(|range| range.get(2)).product::<f64>() > MOST {
            return Err(refused("--angles makes more than a million orientations".to_owned()));
        }
        let mut set = vec![Vec::new()];
        for range in numbers.chunks_exact(3) {
            let values = values(range[0], range[1], range[2] as usize);
            let longer = |angles: Vec<f64>| {
                values.iter().map(move |value| [angles.clone(), vec![*value]].concat()).collect::<Vec<_>>()
            };
            set = set.into_iter().flat_map(longer).collect();
        }
        set.iter().map(|angles| rotation(model, "--angles", angles)).collect()
    }
}

/// Evenly from the least to the largest value; the middle where there is but one.
fn values(least: f64, largest: f64, count: usize) -> Vec<f64> {
    match count {
        1 => vec![0.5 * (least + largest)],
        _ => (0..count).map(|index| least + (largest - least) * index as f64 / (count - 1) as f64).collect(),
    }
}

fn angle_count(model: &Model) -> usize {
    match model.robot().motion_pattern {
        MotionPattern::Planar => 1,
        MotionPattern::Spatial => 3,
        _ => 0,
    }
}

/// The orientation with these angles.
pub(in crate::commands) fn rotation(
    model: &Model,
    option: &str,
    angles: &[f64],
) -> Result<UnitQuaternion<f64>, Failure> {
    let robot = model.robot();
    let (expected, found) = (angle_count(model), angles.len());
    if expected == 0 && found > 0 {
        let pattern = robot.motion_pattern.name();
        let error = WorkspaceError::NoRotation { archetype: "constant-orientation", pattern };
        return Err(Failure::refused(option, &error));
    }
    if expected != found {
        let message =
            format!("{option}: motion pattern {} has {expected} angles, found {found}", robot.motion_pattern.name());
        return Err(Failure::input("workspace::orientations", message, "give rx,ry,rz, or the angle in a plane (rad)"));
    }
    let mut components = vec![0.0; robot.motion_pattern.translations()];
    components.extend(angles);
    let pose = robot.motion_pattern.pose(robot.plane, &components);
    Ok(pose.map_err(|error| Failure::refused(option, &error))?.rotation)
}
