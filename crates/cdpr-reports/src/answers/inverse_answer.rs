//! Cable lengths and directions at a pose, and the lengths that winches must pay out.

use cdpr_model::compensation::{Beyond, Compensation, Correction, MapError};
use cdpr_model::equilibrium::hanging::HangingPoses;
use cdpr_model::equilibrium::{CableCommand, InverseSolution};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::Cable;
use cdpr_model::statics::StaticsError;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

use super::hanging_answer::HangingKeys;
use super::jacobians_answer::Jacobians;
use super::{Answer, PoseAnswer, axis_names, components};
use crate::number_format::cell;
use crate::table::Table;

/// Lengths and directions of all cables. Entries are null where a cable has no unique path, controlled lengths also where no tensions balance the load.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "InverseKinematics")]
pub struct InverseAnswer {
    robot: String,
    model: String,
    status: &'static str,
    reason: Option<String>,
    pose: PoseAnswer,
    /// Lengths of the cables (m).
    cable_lengths_m: Vec<Option<f64>>,
    /// Lengths that the winches set, without strain (m).
    controlled_lengths_m: Vec<Option<f64>>,
    /// Unit vectors along the cables, away from the platform.
    directions: Vec<Option<Vec<f64>>>,
    /// Angles by which the cables wrap their pulleys (rad).
    #[serde(skip_serializing_if = "Option::is_none")]
    wrap_angles_rad: Option<Vec<Option<f64>>>,
    /// Lengths as the robot records them (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    recorded_lengths_m: Option<Vec<Option<f64>>>,
    /// Angles of the motors (rad).
    #[serde(skip_serializing_if = "Option::is_none")]
    motor_angles_rad: Option<Vec<Option<f64>>>,
    /// Null where the file does not say how its encoder counts.
    #[serde(skip_serializing_if = "Option::is_none")]
    encoder_counts: Option<Vec<Option<f64>>>,
    /// Correction of a map, to be added to recorded lengths.
    #[serde(skip_serializing_if = "Option::is_none")]
    correction_m: Option<Vec<f64>>,
    /// Share of the map that acts at the pose: 1 among its samples, less in the margin around them.
    #[serde(skip_serializing_if = "Option::is_none")]
    correction_share: Option<f64>,
    /// Controlled lengths with the correction.
    #[serde(skip_serializing_if = "Option::is_none")]
    corrected_lengths_m: Option<Vec<Option<f64>>>,
    #[serde(rename = "tensions_N", skip_serializing_if = "Option::is_none")]
    tensions: Option<Vec<f64>>,
    /// At the platform anchors, where they differ from those at the outlets.
    #[serde(rename = "platform_tensions_N", skip_serializing_if = "Option::is_none")]
    platform_tensions: Option<Vec<f64>>,
    /// Derivatives of the cables' lengths and paths.
    jacobians: Jacobians,
    #[serde(flatten)]
    hanging: Option<HangingKeys>,
    warnings: Vec<String>,
    #[serde(skip)]
    shows_jacobians: bool,
    #[serde(skip)]
    cable_names: Vec<String>,
    #[serde(skip)]
    axes: Vec<String>,
}

impl InverseAnswer {
    /// The answer in its units; cables without a unique path make it negative.
    pub fn new(model: &Model, solution: &InverseSolution) -> Self {
        let course = |failure: &StaticsError| match failure {
            StaticsError::CablePath(reason) => reason.to_string(),
            other => other.to_string(),
        };
        let reasons: Vec<String> = solution.failures.iter().map(course).collect();
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
        Self {
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
            correction_m: None,
            correction_share: None,
            corrected_lengths_m: None,
            tensions: None,
            platform_tensions,
            jacobians: Jacobians::at(model, &solution.pose),
            hanging: None,
            warnings: Vec::new(),
            shows_jacobians: false,
            cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
            axes: axis_names(robot),
        }
    }

    /// The same with Jacobians in its words too, where they are wanted.
    pub fn showing_jacobians(self, shows_jacobians: bool) -> Self {
        Self { shows_jacobians, ..self }
    }

    /// The same with the tensions that stretch the cables (N).
    pub fn with_tensions(self, tensions: Vec<f64>) -> Self {
        Self { tensions: Some(tensions), ..self }
    }

    /// The same with all poses at which the platform hangs at the position.
    pub fn hanging(self, model: &Model, poses: &HangingPoses) -> Self {
        Self { hanging: Some(HangingKeys::new(model, poses)), ..self }
    }

    /// The same with a caution.
    pub fn with_warning(mut self, warning: String) -> Self {
        self.warnings.push(warning);
        self
    }

    /// The same with the correction of a map at its pose, refused beyond the map: controlled lengths are those whose recorded ones are longer by it.
    pub fn with_correction(self, model: &Model, pose: &Pose, map: &Compensation) -> Result<Self, MapError> {
        let controlled = self.controlled_lengths_m.iter().enumerate();
        let recorded =
            |(cable, length): (usize, &Option<f64>)| model.recorded_length(cable, length.unwrap_or(f64::NAN));
        let correction = map.at(pose).known()?;
        let corrected = controlled.map(recorded).zip(&correction.lengths).map(|(length, own)| length + own).enumerate();
        let lengths = corrected.map(|(cable, length)| model.controlled_length(cable, length));
        let lengths = lengths.map(|length| length.is_finite().then_some(length)).collect();
        Ok(Self {
            warnings: self.warnings.into_iter().chain(fading(&correction)).collect(),
            correction_share: Some(correction.fraction),
            correction_m: Some(correction.lengths),
            corrected_lengths_m: Some(lengths),
            ..self
        })
    }

    /// The same without tensions: the status in a word, and the reason.
    pub fn without_tensions(self, status: &'static str, reason: String) -> Self {
        Self { status, reason: Some(reason), ..self }
    }
}

/// Caution that a map fades at the pose; `None` if it acts as a whole.
fn fading(correction: &Correction) -> Option<String> {
    let reason = correction.reason.as_ref().filter(|_| Beyond::of([correction.fraction].into_iter()).fading > 0)?;
    Some(format!(
        "the pose lies in the margin around the samples of the map ({reason}): {:.0} % of its correction are left",
        100.0 * correction.fraction
    ))
}

impl Answer for InverseAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut text = format!("{}, model {}, at {}\n", self.robot, self.model, self.pose.words());
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{}: {reason}\n", self.status));
        }
        self.warnings.iter().for_each(|warning| text.push_str(&format!("caution: {warning}\n")));
        text.extend(self.hanging.iter().map(HangingKeys::words));
        let mut heading = vec!["cable".to_owned(), "length m".to_owned()];
        let is_elastic = self.controlled_lengths_m != self.cable_lengths_m;
        heading.extend(is_elastic.then(|| "controlled m".to_owned()));
        heading.extend(self.corrected_lengths_m.iter().map(|_| "corrected m".to_owned()));
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
            cells.extend(self.corrected_lengths_m.iter().map(|corrected| cell(corrected[cable], 6)));
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
        let jacobians = self.shows_jacobians.then(|| self.jacobians.words([&self.cable_names, &self.axes], width));
        format!("{text}\n{}{}", table.text(width), jacobians.unwrap_or_default())
    }
}
