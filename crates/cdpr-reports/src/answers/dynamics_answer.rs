//! Forward and inverse dynamics of a platform on its cables.

use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::model::Model;
use cdpr_model::robot::{Assumption, Body, Robot};
use cdpr_model::statics::{Load, StaticsError, balanced_wrench};
use cdpr_plant::{Inertia, Plant, PlantError, assumptions_under_tensions};
use schemars::JsonSchema;
use serde::Serialize;

use super::modes_answer::rows;
use super::pose_answer::{AngularRate, rates};
use super::{Answer, PoseAnswer, WrenchAnswer, assumed_numbers, degrees_of_freedom};
use crate::number_format::{cell, significant};
use crate::table::Table;

/// Mass matrix, bias, and acceleration or the wrench and tensions that it takes.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Dynamics")]
pub struct DynamicsAnswer {
    robot: String,
    model: String,
    /// `feasible`; `infeasible`, `singular` where no tensions make the acceleration.
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    pose: PoseAnswer,
    /// Names of the components of the matrix, and of velocities and accelerations one behind the other.
    degrees_of_freedom: Vec<String>,
    /// v of the platform origin.
    velocity_m_s: Vec<f64>,
    /// ω.
    #[serde(skip_serializing_if = "Option::is_none")]
    angular_velocity_rad_s: Option<AngularRate>,
    /// M (kg, kg·m, kg·m²) and n (N, N·m) of M \[v̇; ω̇\] + n = wrench.
    mass_matrix: Vec<Vec<f64>>,
    /// n, the wrench that the velocity takes: centrifugal, gyroscopic and damping parts (N, N·m).
    bias: WrenchAnswer,
    /// Acceleration of the platform origin (m/s²).
    acceleration_m_s2: Vec<f64>,
    /// Angular acceleration (rad/s²).
    #[serde(skip_serializing_if = "Option::is_none")]
    angular_acceleration_rad_s2: Option<AngularRate>,
    /// Wrench of the cables on the platform.
    cables: WrenchAnswer,
    /// Null where there are none within the limits.
    #[serde(rename = "tensions_N")]
    tensions: Option<Vec<f64>>,
    /// Numbers of the robot file that the answer rests on and that no source states.
    assumptions: Vec<Assumption>,
    #[serde(skip)]
    cable_names: Vec<String>,
}

/// Remark on an inertia that looks like a placeholder.
pub fn placeholder_words(robot: &Robot, body: &Body) -> Option<String> {
    let is_planar = robot.motion_pattern.is_planar();
    let about =
        if is_planar { robot.plane.normal().dot(&(body.inertia * robot.plane.normal())) } else { body.inertia[(0, 0)] };
    let arms = robot.cables.iter().map(|cable| (cable.platform_anchor - body.center_of_mass).norm());
    let (gyration, farthest) = ((about / body.mass).sqrt(), arms.fold(0.0, f64::max));
    body.has_placeholder_inertia(robot).then(|| {
        format!(
            "the inertia of the robot file looks like a placeholder: {} kg·m²{}, for {} kg a radius of gyration of {} m beside platform \
             anchors {} m from the centre of mass at most; accelerations that turn the platform, and tensions for them, are no better than it",
            significant(about, 4),
            if is_planar { "" } else { " about every axis" },
            significant(body.mass, 4),
            significant(gyration, 3),
            significant(farthest, 3),
        )
    })
}

impl DynamicsAnswer {
    /// Dynamics at a pose with a twist and an acceleration (world axes, about the platform origin), for which the cables exert a wrench.
    pub fn new(
        model: &Model,
        inertia: &Inertia,
        pose: &Pose,
        twist: &Twist,
        acceleration: &Twist,
        cables: &Wrench,
    ) -> Self {
        let robot = model.robot();
        let (velocity_m_s, angular_velocity_rad_s) = rates(model, twist);
        let (acceleration_m_s2, angular_acceleration_rad_s2) = rates(model, acceleration);
        Self {
            robot: robot.name.clone(),
            model: model.composition().to_string(),
            status: "feasible",
            reason: None,
            pose: PoseAnswer::new(robot, pose),
            degrees_of_freedom: degrees_of_freedom(robot),
            velocity_m_s,
            angular_velocity_rad_s,
            mass_matrix: rows(&inertia.mass_matrix_in_pattern(model, pose)),
            bias: WrenchAnswer::new(robot, &inertia.bias(pose, twist)),
            acceleration_m_s2,
            angular_acceleration_rad_s2,
            cables: WrenchAnswer::new(robot, cables),
            tensions: None,
            assumptions: assumptions_under_tensions(model).cloned().collect(),
            cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
        }
    }

    /// Forward dynamics: what tensions make of a pose with a twist under a load.
    pub fn by_tensions(
        model: &Model,
        inertia: &Inertia,
        pose: &Pose,
        twist: &Twist,
        load: &Load,
        tensions: Vec<f64>,
    ) -> Result<Self, StaticsError> {
        let cables = -balanced_wrench(model, pose, &tensions)?;
        let acceleration = inertia.acceleration(model, pose, twist, &(cables + load.wrench(pose)));
        let answer = Self::new(model, inertia, pose, twist, &acceleration, &cables);
        Ok(Self { tensions: Some(tensions), ..answer })
    }

    /// Forward dynamics: what cables make of it whose winches hold these lengths (m).
    pub fn by_lengths(
        plant: &Plant,
        pose: &Pose,
        twist: &Twist,
        load: &Load,
        lengths: &[f64],
    ) -> Result<Self, PlantError> {
        let mut state = plant.with_lengths(pose, lengths)?;
        state.set_twist(twist);
        plant.observe(&mut state)?;
        let acceleration = plant.acceleration(&state, &(load.wrench(pose) - plant.load().wrench(pose)));
        let cables = needed_wrench(&state.inertia, pose, twist, load, &acceleration);
        let answer = Self::new(plant.model(), &state.inertia, pose, twist, &acceleration, &cables);
        let tensions = state.cables.iter().map(|cable| cable.tension).collect();
        Ok(Self { tensions: Some(tensions), assumptions: plant.assumptions().cloned().collect(), ..answer })
    }

    /// The same of cables that no tensions serve.
    pub fn refused(self, status: &'static str, reason: String) -> Self {
        Self { status, reason: Some(reason), ..self }
    }

    /// True when every number is finite.
    pub fn is_finite(&self) -> bool {
        let acceleration = components(&self.acceleration_m_s2, self.angular_acceleration_rad_s2.as_ref());
        acceleration.iter().chain(self.tensions.iter().flatten()).all(|number| number.is_finite())
            && self.cables.is_finite()
            && self.bias.is_finite()
    }
}

/// Wrench of the cables that an acceleration takes under a load: M \[v̇; ω̇\] + n − w.
pub fn needed_wrench(inertia: &Inertia, pose: &Pose, twist: &Twist, load: &Load, acceleration: &Twist) -> Wrench {
    inertia.wrench_of_acceleration(pose, twist, acceleration) - load.wrench(pose)
}

/// Translation, then rotation.
fn components(translation: &[f64], turning: Option<&AngularRate>) -> Vec<f64> {
    [translation, turning.map_or(&[], AngularRate::components)].concat()
}

impl Answer for DynamicsAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut text = format!("{}, model {}, at {}\n{}", self.robot, self.model, self.pose.words(), self.status);
        self.reason.iter().for_each(|reason| text.push_str(&format!(": {reason}")));
        text.push_str("\n\nmotion (m, rad, s)\n");
        let mut motion = Table::with_heading([vec![String::new()], self.degrees_of_freedom.clone()].concat());
        let twist = components(&self.velocity_m_s, self.angular_velocity_rad_s.as_ref());
        let acceleration = components(&self.acceleration_m_s2, self.angular_acceleration_rad_s2.as_ref());
        for (name, numbers) in [("twist", twist), ("acceleration", acceleration)] {
            motion.row([vec![name.to_owned()], numbers.iter().map(|x| cell(Some(*x), 4)).collect()].concat());
        }
        text.push_str(&motion.text(width));
        text.push_str("\nmass matrix (kg, m)\n");
        let mut mass = Table::with_heading([vec![String::new()], self.degrees_of_freedom.clone()].concat());
        for (name, row) in self.degrees_of_freedom.iter().zip(&self.mass_matrix) {
            mass.row([vec![name.clone()], row.iter().map(|x| cell(Some(*x), 3)).collect()].concat());
        }
        text.push_str(&mass.text(width));
        text.push_str("\nwrenches\n");
        let mut wrenches = Table::with_heading([vec![String::new()], self.cables.heading()].concat());
        for (name, wrench) in [("bias", &self.bias), ("cables", &self.cables)] {
            wrenches.row([vec![name.to_owned()], wrench.cells()].concat());
        }
        text.push_str(&wrenches.text(width));
        if let Some(tensions) = &self.tensions {
            let mut table = Table::with_heading(vec!["cable".to_owned(), "tension N".to_owned()]);
            for (name, tension) in self.cable_names.iter().zip(tensions) {
                table.row(vec![name.clone(), cell(Some(*tension), 1)]);
            }
            text.push_str(&format!("\n{}", table.text(width)));
        }
        text + &assumed_numbers::section("the answer rests on assumed numbers", &self.assumptions)
    }
}
