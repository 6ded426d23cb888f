//! Payload, acceleration and speed everywhere in a box.

use cdpr_model::geometry::Pose;
use cdpr_model::robot::Robot;
use cdpr_workspace::capability::{Found, LimitedBy, Quantity, Solution, Status};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::{Value, json};

use super::capability_schema::{AccelerationDetails, AccelerationValues, CapabilityDetail, PoseNotHeld};
use super::capability_words::{AskedCapability, COLUMNS, limit_words, name_of, point_words, row_of};
use super::{Answer, PoseAnswer, axis_names, components, title};
use crate::number_format::{short, significant};
use crate::table::Table;

/// The answer; keys and units as in JSON.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Capability")]
pub struct CapabilityAnswer {
    robot: String,
    status: &'static str,
    reason: Option<String>,
    model: String,
    /// Box, ends along each axis of the robot.
    box_m: Vec<f64>,
    /// Distance from the platform origin within which the payload may lie along each axis of the platform (m).
    #[serde(rename = "payload_place_m")]
    payload_place: f64,
    /// Gap that was asked for.
    gap_wanted: f64,
    /// Poses that were judged.
    poses: u64,
    /// Mass that is carried everywhere in the box (kg); null where there is none.
    #[serde(rename = "payload_kg")]
    payload: Option<f64>,
    /// Accelerations that are possible everywhere in the box (m/s²).
    #[serde(rename = "acceleration_m_s2")]
    #[schemars(with = "AccelerationValues")]
    acceleration: Accelerations<Option<f64>>,
    /// Speed that is possible everywhere in the box (m/s); null where there is none.
    #[serde(rename = "speed_m_s")]
    speed: Option<f64>,
    /// How the payload was found, or why there is none.
    #[serde(rename = "payload")]
    #[schemars(with = "CapabilityDetail")]
    payload_detail: Value,
    /// How the accelerations were found, or why there are none.
    #[serde(rename = "acceleration")]
    #[schemars(with = "AccelerationDetails")]
    acceleration_detail: Accelerations<Value>,
    /// How the speed was found, or why there is none.
    #[serde(rename = "speed")]
    #[schemars(with = "CapabilityDetail")]
    speed_detail: Value,
    /// Pose at which the own load is not held.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<PoseNotHeld>")]
    not_held: Option<Value>,
    warnings: Vec<String>,
    /// Page that was written.
    #[serde(skip_serializing_if = "Option::is_none")]
    report: Option<String>,
    #[serde(skip)]
    pub(super) shown: Shown,
}

/// One of each acceleration.
#[derive(Serialize)]
struct Accelerations<T> {
    /// In every direction.
    ball: T,
    /// In both senses of each axis.
    per_axis: Vec<T>,
}

/// Contents of text and page.
pub(super) struct Shown {
    pub(super) heading: String,
    pub(super) rows: Vec<Vec<String>>,
    /// Sentences below the table.
    pub(super) words: Vec<String>,
}

impl CapabilityAnswer {
    /// The answer of a search.
    pub fn new(asked: &AskedCapability<'_>, solution: &Solution) -> Self {
        let robot = asked.model.robot();
        let found = |quantity: Quantity| solution.found.iter().find(|found| found.quantity == quantity);
        let value = |quantity: Quantity| found(quantity).map(|found| found.value);
        let detail = |quantity: Quantity| match found(quantity) {
            Some(found) => json_of(asked, found),
            None => json!({ "reason": why_absent(solution, quantity), "limited_by": null, "at_pose": null }),
        };
        let axes = (0..asked.model.axes().len()).map(Quantity::AxisAcceleration);
        let not_held = solution.not_held.as_ref().map(|not_held| {
            json!({
                "at_pose": PoseAnswer::new(robot, &asked.capability.pose(&not_held.at)),
                "lacking_N": not_held.lacking,
                "limited_by": json_of_limit(robot, &not_held.limited_by),
            })
        });
        Self {
            robot: robot.name.clone(),
            status: match solution.status {
                Status::Found => "found",
                Status::NotHeld => "not-held",
                _ => "poses-used-up",
            },
            reason: not_held_words(asked, solution),
            model: asked.model.composition().to_string(),
            box_m: asked.bounds.ends(),
            payload_place: asked.payload_place,
            gap_wanted: asked.settings.gap,
            poses: solution.poses,
            payload: value(Quantity::Payload),
            acceleration: Accelerations {
                ball: value(Quantity::Acceleration),
                per_axis: axes.clone().map(value).collect(),
            },
            speed: value(Quantity::Speed),
            payload_detail: detail(Quantity::Payload),
            acceleration_detail: Accelerations {
                ball: detail(Quantity::Acceleration),
                per_axis: axes.map(detail).collect(),
            },
            speed_detail: detail(Quantity::Speed),
            not_held,
            warnings: warnings(asked, solution),
            report: None,
            shown: shown(asked, solution),
        }
    }

    /// The same with the name of the page that is written.
    #[must_use]
    pub fn with_report(self, report: Option<String>) -> Self {
        Self { report, ..self }
    }

    /// Doubts and remarks.
    pub(super) fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Reason why the answer is negative.
    pub(super) fn reason(&self) -> Option<&str> {
        self.reason.as_deref()
    }
}

fn json_of(asked: &AskedCapability<'_>, found: &Found) -> Value {
    let unit = match found.quantity {
        Quantity::Payload => "kg",
        Quantity::Speed => "m_s",
        _ => "m_s2",
    };
    let robot = asked.model.robot();
    let pose: Pose = asked.capability.pose(&found.at);
    let direction = found.limited_by.direction.map(|direction| components(robot, &direction));
    let mut all = json!({
        "limited_by": json_of_limit(robot, &found.limited_by),
        "at_pose": PoseAnswer::new(robot, &pose),
        format!("at_least_{unit}"): found.at_least.is_finite().then_some(found.at_least),
        "gap": found.gap(),
    });
    if let (Some(direction), Some(keys)) = (direction, all.as_object_mut()) {
        keys.insert("direction".to_owned(), json!(direction));
    }
    all
}

fn json_of_limit(robot: &Robot, limited_by: &LimitedBy) -> Value {
    let numbers = |cables: &[usize]| cables.iter().map(|cable| cable + 1).collect::<Vec<_>>();
    let LimitedBy { limit, cable, at_largest, at_least, .. } = limited_by;
    json!({
        "limit": limit.name(),
        "cable": cable.map(|cable| cable + 1),
        "cable_name": cable.map(|cable| &robot.cables[cable].name),
        "at_tension_max": numbers(at_largest),
        "at_tension_min": numbers(at_least),
    })
}

fn why_absent(solution: &Solution, quantity: Quantity) -> String {
    let absent = solution.absent.iter().find(|absent| absent.quantity == quantity);
    absent.map_or_else(
        || "the robot does not hold its own load everywhere in the box".to_owned(),
        |absent| absent.reason.clone(),
    )
}

fn not_held_words(asked: &AskedCapability<'_>, solution: &Solution) -> Option<String> {
    let not_held = solution.not_held.as_ref()?;
    let robot = asked.model.robot();
    let place = point_words(robot, &not_held.at);
    if let Some(reason) = &not_held.reason {
        return Some(format!("a cable has no path everywhere in the box, at ({place}) m: {reason}"));
    }
    let (cables, dof) = (asked.model.cable_count(), asked.model.dof());
    let hangs = match cables < dof {
        true => format!(
            ". {cables} cables leave the platform {} of its {dof} degrees of freedom, in which it turns as its load says: it keeps no orientation of a box (`cdpr ik --position` \
             tells the one that it has)",
            dof - cables
        ),
        false => String::new(),
    };
    Some(format!(
        "the robot does not hold its own load everywhere in the box: at ({place}) m it lacks {} N; limit: {}{hangs}",
        significant(not_held.lacking, 3),
        limit_words(robot, &not_held.limited_by)
    ))
}

fn warnings(asked: &AskedCapability<'_>, solution: &Solution) -> Vec<String> {
    let mut all = Vec::new();
    if solution.status == Status::PosesUsedUp {
        let widest = solution.found.iter().map(Found::gap).fold(0.0, f64::max);
        all.push(format!(
            "after {} poses the values are known within {} % only; --poses allows more, a smaller box needs fewer",
            solution.poses,
            significant(1e2 * widest, 2)
        ));
    }
    let free = asked.capability.without_speed_limit();
    if !free.is_empty() {
        let numbers: Vec<String> = free.iter().map(|cable| (cable + 1).to_string()).collect();
        all.push(format!("cables {} have no limit of their speed in the robot file", numbers.join(", ")));
    }
    all
}

fn shown(asked: &AskedCapability<'_>, solution: &Solution) -> Shown {
    let robot = asked.model.robot();
    let ends = asked.bounds.ends();
    let sides = axis_names(robot).into_iter().zip(ends.chunks(2));
    let sides: Vec<String> =
        sides.map(|(axis, ends)| format!("{axis} {} … {} m", short(ends[0]), short(ends[1]))).collect();
    let mut words = Vec::new();
    if !solution.found.is_empty() {
        let place = match asked.payload_place > 0.0 {
            true => {
                format!(" or anywhere within ± {} m of it along each axis of the platform", short(asked.payload_place))
            }
            false => String::new(),
        };
        let is_answered = |quantity: Quantity| solution.found.iter().any(|found| found.quantity == quantity);
        if is_answered(Quantity::Payload) {
            words.push(format!("The payload is a mass at the platform origin{place}, besides the robot’s own load."));
        }
        if is_answered(Quantity::Acceleration) {
            words.push("Accelerations are those of the robot’s own mass from rest, without turning.".to_owned());
        }
        words.push(format!(
            "“At least” holds at every pose of the box in this orientation, by branch and bound over {} poses; the value is \
             that of its pose, and the gap is the difference between the two.",
            solution.poses
        ));
    }
    for absent in &solution.absent {
        // one reason for all accelerations
        let quantity = match absent.quantity {
            Quantity::AxisAcceleration(_) => continue,
            Quantity::Acceleration => "acceleration".to_owned(),
            other => name_of(robot, other).0.split(',').next().unwrap_or_default().to_owned(),
        };
        words.push(format!("No {quantity}: {}.", absent.reason));
    }
    Shown {
        heading: format!("{} in the box {}", title(asked.model), sides.join(", ")),
        rows: solution.found.iter().map(|found| row_of(asked, found)).collect(),
        words,
    }
}

impl Answer for CapabilityAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut text = format!("{}\n", self.shown.heading);
        self.reason.iter().for_each(|reason| text.push_str(&format!("{reason}\n")));
        self.warnings.iter().for_each(|warning| text.push_str(&format!("warning: {warning}\n")));
        if !self.shown.rows.is_empty() {
            let mut table = Table::new(COLUMNS).left_column(4).left_column(5);
            table.rows(self.shown.rows.clone());
            text.push_str(&format!("\n{}", table.text(width)));
        }
        text.push('\n');
        self.shown.words.iter().for_each(|word| text.push_str(&format!("{word}\n")));
        self.report.iter().for_each(|report| text.push_str(&format!("\nwrote {report}\n")));
        text
    }
}
