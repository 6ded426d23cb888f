//! Wrenches in the components of a motion pattern.

use cdpr_model::geometry::{MotionPattern, Wrench};
use cdpr_model::robot::Robot;
use schemars::JsonSchema;
use serde::Serialize;

use super::pose_answer::{axis_names, components};
use crate::number_format::cell;

/// A wrench as robot files write it: world axes, moment about the platform origin. Null where it is not known.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
#[schemars(rename = "Wrench")]
pub struct WrenchAnswer {
    /// Force (N): three components, or the two of a planar robot.
    #[serde(rename = "force_N")]
    force: Option<Vec<f64>>,
    /// Moment (N·m), null for a point platform.
    #[serde(rename = "moment_Nm")]
    moment: Option<Moment>,
    /// The axes, for people.
    #[serde(skip)]
    axes: Vec<String>,
}

/// Moment of a planar or a spatial robot.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(untagged)]
enum Moment {
    /// About the plane's normal.
    Planar(f64),
    /// Three components.
    Spatial(Vec<f64>),
}

impl WrenchAnswer {
    /// Wrench (world axes, moment about the platform origin) in the components of the robot's files.
    pub fn new(robot: &Robot, wrench: &Wrench) -> Self {
        let moment = wrench.fixed_rows::<3>(3).into_owned();
        Self {
            force: Some(components(robot, &wrench.fixed_rows::<3>(0).into_owned())),
            moment: match robot.motion_pattern {
                MotionPattern::Planar => Some(Moment::Planar(robot.plane.normal().dot(&moment) + 0.0)),
                MotionPattern::Spatial => Some(Moment::Spatial(components(robot, &moment))),
                _ => None,
            },
            axes: axis_names(robot),
        }
    }

    /// Names of the components with units, the heading of [`WrenchAnswer::cells`].
    pub fn heading(&self) -> Vec<String> {
        let mut names: Vec<String> = self.axes.iter().map(|axis| format!("f{axis} N")).collect();
        match &self.moment {
            Some(Moment::Planar(_)) => names.push("m N·m".to_owned()),
            Some(Moment::Spatial(_)) => names.extend(self.axes.iter().map(|axis| format!("m{axis} N·m"))),
            None => {}
        }
        names
    }

    /// The components for a table.
    pub fn cells(&self) -> Vec<String> {
        self.numbers().map(|number| cell(Some(number), 3)).collect()
    }

    /// True when every number is finite.
    pub fn is_finite(&self) -> bool {
        self.numbers().all(f64::is_finite)
    }

    /// Force, then moment.
    fn numbers(&self) -> impl Iterator<Item = f64> {
        let moments: &[f64] = match &self.moment {
            Some(Moment::Planar(moment)) => std::slice::from_ref(moment),
            Some(Moment::Spatial(moments)) => moments,
            None => &[],
        };
        self.force.iter().flatten().chain(moments).copied()
    }
}
