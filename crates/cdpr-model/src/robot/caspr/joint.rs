//! CASPR's joints between base and platform, and the motion patterns to which they correspond.

use std::f64::consts::PI;

use nalgebra::{UnitQuaternion, Vector3};

use super::findings::{Findings, Loss};
use crate::geometry::{MotionPattern, Plane, Pose};
use crate::reading::{Element, ReadError, help_for_unknown, numbers};
use crate::robot::TravelBox;

/// Joints that correspond to a motion pattern: name, pattern, axes of the plane.
const JOINTS: &[(&str, MotionPattern, &str)] = &[
    ("SPATIAL_EULER_XYZ", MotionPattern::Spatial, "xy"),
    ("SPATIAL_QUATERNION", MotionPattern::Spatial, "xy"),
    ("T_XYZ", MotionPattern::SpatialPoint, "xy"),
    ("PLANAR_XY", MotionPattern::Planar, "xy"),
    ("PLANAR_YZ", MotionPattern::Planar, "yz"),
    ("PLANAR_XZ", MotionPattern::Planar, "xz"),
    ("P_XY", MotionPattern::PlanarPoint, "xy"),
    ("P_XZ", MotionPattern::PlanarPoint, "xz"),
];

/// CASPR's other joints: with axes, spheres and universal joints that hold the platform as in no motion pattern.
const OTHER_JOINTS: &[&str] = &[
    "R_X",
    "R_Y",
    "R_Z",
    "R_AXIS",
    "U_XY",
    "U_YZ",
    "U_XZ",
    "P_X",
    "P_Y",
    "P_Z",
    "P_AXIS",
    "S_EULER_XYZ",
    "S_FIXED_XYZ",
    "S_QUATERNION",
    "SPHERICAL",
    "SPATIAL",
];

const POSITION_BOX_NOTE: &str =
    "joint range of the CASPR model, a box for plotting and sampling rather than a proven workspace";

/// A joint that corresponds to a motion pattern.
#[derive(Clone, Copy, Debug)]
pub(super) struct Joint {
    pub(super) name: &'static str,
    pub(super) pattern: MotionPattern,
    pub(super) plane: Plane,
}

impl Joint {
    /// The joint of a link; an error for a joint without a motion pattern.
    pub(super) fn read(element: &Element<'_, '_>) -> Result<Self, ReadError> {
        let wanted = element.required_attribute("type")?;
        if let Some((name, pattern, axes)) = JOINTS.iter().find(|(name, ..)| *name == wanted) {
            return Ok(Self { name, pattern: *pattern, plane: Plane::from_axes(axes).unwrap_or_default() });
        }
        let known: Vec<&str> = JOINTS.iter().map(|(name, ..)| *name).collect();
        if OTHER_JOINTS.contains(&wanted) {
            let message = format!(
                "the joint {wanted} holds the platform mechanically; a robot here moves as 2T, 3T, 1R2T or 3R3T"
            );
            return Err(element
                .attribute_error("type", "caspr::joint", message)
                .with_help(format!("joints that can be imported: {}", known.join(", "))));
        }
        Err(element
            .attribute_error("type", "caspr::joint", format!("unknown joint type `{wanted}`"))
            .with_help(help_for_unknown(wanted, &known)))
    }

    /// The component of a vector in the plane of a planar robot; the vector itself for spatial robots.
    pub(super) fn in_plane(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        match self.pattern.is_planar() {
            true => self.plane.embed(self.plane.components(vector)),
            false => *vector,
        }
    }

    /// The component of a vector along the normal of a planar robot (m); zero for spatial robots.
    pub(super) fn out_of_plane(&self, vector: &Vector3<f64>) -> f64 {
        if self.pattern.is_planar() { self.plane.normal().dot(vector) } else { 0.0 }
    }

    /// Number of CASPR's coordinates.
    fn coordinate_count(&self) -> usize {
        if self.name == "SPATIAL_QUATERNION" { 7 } else { self.pattern.dof() }
    }

    /// The coordinates of an attribute; `None` if it is missing.
    fn coordinates(&self, element: &Element<'_, '_>, attribute: &str) -> Result<Option<Vec<f64>>, ReadError> {
        let Some(text) = element.attribute(attribute) else { return Ok(None) };
        let wrong = |why: String| element.attribute_error(attribute, "xml::wrong-type", format!("{attribute}: {why}"));
        let list = numbers(text).map_err(|why| wrong(why.to_string()))?;
        match (list.len(), self.coordinate_count()) {
            (found, expected) if found == expected => Ok(Some(list)),
            (found, expected) => {
                Err(wrong(format!("the joint {} has {expected} coordinates, found {found}", self.name)))
            }
        }
    }

    /// Position from coordinates (m).
    fn position(&self, coordinates: &[f64]) -> Vector3<f64> {
        match (self.pattern.is_planar(), coordinates) {
            (true, &[first, second, ..]) => self.plane.embed([first, second]),
            (false, &[x, y, z, ..]) => Vector3::new(x, y, z),
            _ => Vector3::zeros(),
        }
    }

    /// Orientation from coordinates; `None` for a quaternion without norm 1.
    fn rotation(&self, coordinates: &[f64]) -> Option<UnitQuaternion<f64>> {
        match (self.pattern, coordinates) {
            // PLANAR_XZ turns about +y, from z to x: opposite to the direction from the first axis to the second
            (MotionPattern::Planar, &[_, _, angle]) if self.name == "PLANAR_XZ" => Some(turn(self.plane, -angle)),
            (MotionPattern::Planar, &[_, _, angle]) => Some(turn(self.plane, angle)),
            (MotionPattern::Spatial, &[_, _, _, x, y, z]) => {
                Some(Pose::from_xyz_angles(Vector3::zeros(), [x, y, z]).rotation)
            }
            (MotionPattern::Spatial, &[_, _, _, w, x, y, z]) => Pose::rotation_from_xyzw([x, y, z, w]),
            _ => Some(UnitQuaternion::identity()),
        }
    }

    /// The initial pose of a joint with its origin at `origin` (world, m).
    pub(super) fn home(
        &self,
        element: &Element<'_, '_>,
        origin: &Vector3<f64>,
        findings: &mut Findings,
    ) -> Result<Pose, ReadError> {
        let Some(coordinates) = self.coordinates(element, "q_initial")? else {
            findings.add(Loss::Ignored, element, "without q_initial; CASPR's default, zero, is the home pose");
            return Ok(Pose { position: self.in_plane(origin), ..Pose::identity() });
        };
        let rotation = self.rotation(&coordinates).ok_or_else(|| {
            element.attribute_error("q_initial", "caspr::quaternion", "the quaternion in q_initial has not the norm 1")
        })?;
        Ok(Pose { position: self.in_plane(origin) + self.position(&coordinates), rotation })
    }

    /// The box of positions between `q_min` and `q_max`.
    pub(super) fn travel(
        &self,
        element: &Element<'_, '_>,
        origin: &Vector3<f64>,
        findings: &mut Findings,
    ) -> Result<Option<TravelBox>, ReadError> {
        let is_open = |name| element.attribute(name).is_some_and(|text| text.to_lowercase().contains("inf"));
        if is_open("q_min") || is_open("q_max") {
            findings.add(Loss::Ignored, element, "an infinite range in q_min or q_max is no box of positions");
            return Ok(None);
        }
        let (lower, upper) = (self.coordinates(element, "q_min")?, self.coordinates(element, "q_max")?);
        let (Some(lower), Some(upper)) = (lower, upper) else { return Ok(None) };
        if let Some(index) = (0..lower.len()).find(|&index| lower[index] > upper[index]) {
            let message = format!("q_min[{}] = {} is above q_max = {}", index + 1, lower[index], upper[index]);
            return Err(element.attribute_error("q_min", "caspr::range", message).with_help("swap them, or mend one"));
        }
        // π is written with few digits
        let limits_turn = |&angle: &f64| angle.abs() < PI - 1e-3;
        let angles = self.pattern.translations()..lower.len();
        let full_turns = if self.coordinate_count() == 7 { 0..0 } else { angles };
        if lower[full_turns.clone()].iter().chain(&upper[full_turns]).any(limits_turn) {
            findings.add(Loss::Simplified, element, "limits of angles in q_min, q_max have no place in a robot file");
        }
        let corner = |coordinates: &[f64]| self.in_plane(origin) + self.position(coordinates);
        Ok(Some(TravelBox { min: corner(&lower), max: corner(&upper), note: Some(POSITION_BOX_NOTE.to_owned()) }))
    }
}

fn turn(plane: Plane, angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::new(plane.normal() * angle)
}
