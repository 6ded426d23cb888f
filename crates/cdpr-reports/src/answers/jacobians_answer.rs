//! Jacobians of an inverse kinematics problem: of lengths, arcs and contact points by the pose, and of the pose's angles.

use super::{components, degrees_of_freedom};
use cdpr_model::cable::CableEnd;
use cdpr_model::cable::outlet::Contact;
use cdpr_model::geometry::{MotionPattern, Pose, Twist};
use cdpr_model::model::Model;
use nalgebra::{Matrix3, Vector3};
use schemars::JsonSchema;
use serde::Serialize;

use crate::number_format::cell;
use crate::table::Table;

type Rows = Vec<Vec<f64>>;

/// Columns are the degrees of freedom: displacements and turns about world axes, of a planar robot in its plane.
#[derive(Serialize, JsonSchema)]
pub(super) struct Jacobians {
    /// Names of the degrees of freedom, the columns.
    degrees_of_freedom: Vec<String>,
    /// `None` for platforms whose turns are their angles.
    #[serde(skip_serializing_if = "Option::is_none")]
    angles: Option<AngleJacobian>,
    /// Null for cables without a unique path, and for all that hang.
    cables: Vec<Option<CableJacobians>>,
    /// Tells of cables that hang.
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'static str>,
}

/// J_P, from the rates of the angles rx, ry, rz to the angular velocity.
#[derive(Serialize, JsonSchema)]
struct AngleJacobian {
    /// The matrix, row by row.
    matrix: Rows,
    /// Null at gimbal lock.
    inverse: Option<Rows>,
    /// Reason why there is no inverse.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'static str>,
}

/// Derivatives of a cable; columns are the degrees of freedom.
#[derive(Serialize, JsonSchema)]
struct CableJacobians {
    /// Length from pulley to platform (m).
    free_length_m: f64,
    /// Length on the pulley (m).
    arc_length_m: f64,
    /// Point at which the cable leaves the pulley (m).
    contact_point_m: Vec<f64>,
    /// Of the whole length: minus the column of the structure matrix.
    length: Vec<f64>,
    /// Of the length from pulley to platform.
    free_length: Vec<f64>,
    /// Of the length on the pulley.
    arc_length: Vec<f64>,
    /// Of the point at which the cable leaves the pulley, row by row.
    contact_point: Rows,
    /// Of the anchor on the platform, row by row.
    platform_anchor: Rows,
    /// Of the vector from platform to pulley, row by row.
    cable_vector: Rows,
}

const GIMBAL_LOCK: &str = "ry is ±90°, where the axes of rx and rz are parallel: angles are no coordinates here, and no rates of theirs belong to some angular velocities";
const HANGING: &str = "cables hang: where they leave their pulleys depends on their tensions, so that the pose alone determines no contact point";

impl Jacobians {
    pub(super) fn at(model: &Model, pose: &Pose) -> Self {
        let is_straight = model.cables().has_fixed_directions();
        let of_cable = |cable: usize| match is_straight {
            true => model.contact(cable, pose).ok().map(|found| CableJacobians::of(model, &found)),
            false => None,
        };
        Self {
            degrees_of_freedom: degrees_of_freedom(model.robot()),
            angles: (model.robot().motion_pattern == MotionPattern::Spatial).then(|| AngleJacobian::at(pose)),
            cables: (0..model.cable_count()).map(of_cable).collect(),
            note: (!is_straight).then_some(HANGING),
        }
    }

    /// Tables for people.
    pub(super) fn words(&self, [cable_names, axes]: [&[String]; 2], width: Option<usize>) -> String {
        let mut text = String::new();
        if let Some(angles) = &self.angles {
            text.push_str("\nangular velocity per rate of the angles, J_P\n");
            text.push_str(&table(
                "J_P",
                &["rx", "ry", "rz"].map(str::to_owned),
                &named("ω ", axes, &angles.matrix),
                width,
            ));
            match (&angles.inverse, angles.reason) {
                (Some(inverse), _) => {
                    let names = ["rate rx", "rate ry", "rate rz"].map(str::to_owned);
                    text.push_str("\nrates of the angles per angular velocity, its inverse\n");
                    let columns: Vec<String> = axes.iter().map(|axis| format!("ω {axis}")).collect();
                    text.push_str(&table("1/J_P", &columns, &named("", &names, inverse), width));
                }
                (None, reason) => text.push_str(&format!("it has no inverse: {}\n", reason.unwrap_or_default())),
            }
        }
        text.push_str("\nper displacement (1) and turn (m/rad) of the platform\n");
        let mut rows = Vec::new();
        for (name, cable) in cable_names.iter().zip(&self.cables) {
            let Some(cable) = cable else { continue };
            let lines = [("length", &cable.length), ("free length", &cable.free_length), ("arc", &cable.arc_length)];
            rows.extend(lines.map(|(line, row)| (format!("{name} {line}"), row.clone())));
            rows.extend(named(&format!("{name} contact "), axes, &cable.contact_point));
        }
        text.push_str(&table("cable", &self.degrees_of_freedom, &rows, width));
        self.note.iter().for_each(|note| text.push_str(&format!("{note}\n")));
        text
    }
}

impl AngleJacobian {
    fn at(pose: &Pose) -> Self {
        let angles = pose.xyz_angles();
        let inverse = Pose::xyz_angle_jacobian_inverse(angles);
        let rows = |matrix: &Matrix3<f64>| -> Rows {
            matrix.row_iter().map(|row| row.iter().map(|entry| entry + 0.0).collect()).collect()
        };
        Self {
            matrix: rows(&Pose::xyz_angle_jacobian(angles)),
            reason: inverse.is_none().then_some(GIMBAL_LOCK),
            inverse: inverse.as_ref().map(rows),
        }
    }
}

impl CableJacobians {
    fn of(model: &Model, (contact, end): &(Contact<f64>, CableEnd<f64>)) -> Self {
        let robot = model.robot();
        let row = |by_pose: [f64; 6]| -> Vec<f64> {
            let by_pose = Twist::from(by_pose);
            // + 0.0: the sign of zero says nothing
            model.twist_basis().iter().map(|direction| direction.dot(&by_pose) + 0.0).collect()
        };
        // three world rows as those of the robot's axes
        let rows = |world: [[f64; 6]; 3]| -> Rows {
            let along = |axis: &Vector3<f64>| {
                row(std::array::from_fn(|k| axis.x * world[0][k] + axis.y * world[1][k] + axis.z * world[2][k]))
            };
            model.axes().iter().map(along).collect()
        };
        let by_pose = contact.by_pose(end);
        let (free, arc) = (by_pose.free_length, by_pose.arc_length);
        let span = Vector3::from(end.anchor) - Vector3::from(contact.point);
        Self {
            free_length_m: span.norm(),
            arc_length_m: contact.arc_length,
            contact_point_m: components(robot, &contact.point.into()),
            length: row(std::array::from_fn(|k| free[k] + arc[k])),
            free_length: row(free),
            arc_length: row(arc),
            contact_point: rows(by_pose.point),
            platform_anchor: rows(end.by_pose()),
            cable_vector: rows(by_pose.cable_vector),
        }
    }
}

/// Rows with a name in front.
fn named(prefix: &str, names: &[String], rows: &Rows) -> Vec<(String, Vec<f64>)> {
    names.iter().zip(rows).map(|(name, row)| (format!("{prefix}{name}"), row.clone())).collect()
}

fn table(title: &str, columns: &[String], rows: &[(String, Vec<f64>)], width: Option<usize>) -> String {
    let mut table = Table::with_heading([&[title.to_owned()], columns].concat());
    for (name, row) in rows {
        table.row([vec![name.clone()], row.iter().map(|&entry| cell(Some(entry), 6)).collect()].concat());
    }
    table.text(width)
}
