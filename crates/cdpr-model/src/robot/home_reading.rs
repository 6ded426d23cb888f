//! The `[home_pose]` of a robot file. Orientations are stored so that writing and reading gives the same bits.

use nalgebra::{Quaternion, UnitQuaternion};

use super::file::HomeSection;
use super::reader::{Reader, square};
use crate::geometry::{MotionPattern, Plane, Pose};
use crate::reading::{ReadError, Step};

/// Steps per unit to which quaternion components are rounded.
const ROTATION_GRID: f64 = (1_u64 << 48) as f64;

/// Difference of squares of quaternion components below which they count as equal: far more than rounding, far less
/// than any significant turn.
const TIE: f64 = 1e-9;

/// The home pose, with the orientation key that the motion pattern needs and no other.
pub(super) fn read_home(reader: &Reader<'_>, home: &HomeSection) -> Result<Pose, ReadError> {
    let position = reader.vector(&path("position_m"), &home.position_m)?;
    let (plane, name) = (reader.plane, reader.pattern.name());
    let rotation = match (reader.pattern, &home.rotation, home.angle_rad) {
        (MotionPattern::Spatial, Some(rows), None) => matrix_rotation(reader, rows)?,
        (MotionPattern::Planar, None, Some(angle)) => planar_rotation(plane, principal_angle(plane, angle)),
        (MotionPattern::PlanarPoint | MotionPattern::SpatialPoint, None, None) => UnitQuaternion::identity(),
        (MotionPattern::Spatial, ..) => {
            let message = format!("a home pose of motion pattern {name} has `rotation`, and no `angle_rad`");
            let help = "unturned is rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]";
            return Err(error(reader, "angle_rad", message).with_help(help));
        }
        (MotionPattern::Planar, ..) => {
            let message = format!("a home pose of motion pattern {name} has `angle_rad`, and no `rotation`");
            return Err(error(reader, "rotation", message).with_help("unturned is angle_rad = 0.0"));
        }
        (_, rotation, _) => {
            let key = if rotation.is_some() { "rotation" } else { "angle_rad" };
            let message = format!("a platform of motion pattern {name} does not turn");
            return Err(error(reader, key, message).with_help("leave the key out"));
        }
    };
    Ok(Pose { position, rotation })
}

fn path(key: &str) -> [Step<'_>; 2] {
    [Step::Key("home_pose"), Step::Key(key)]
}

fn error(reader: &Reader<'_>, key: &str, message: String) -> ReadError {
    reader.document.error_at(&path(key), "robot::home-pose", message)
}

fn matrix_rotation(reader: &Reader<'_>, rows: &[Vec<f64>]) -> Result<UnitQuaternion<f64>, ReadError> {
    match square(rows).and_then(|rows| Pose::rotation_from_rows(&rows)) {
        Some(rotation) => Ok(rounded(&rotation)),
        None => Err(error(reader, "rotation", "this is not a rotation matrix".to_owned())
            .with_help("3 rows of 3 numbers, orthonormal to 1e-6 (give nine digits), determinant +1")),
    }
}

/// The rotation of a planar platform by an angle (rad).
pub(super) fn planar_rotation(plane: Plane, angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::new(plane.normal() * angle)
}

/// The angle of a planar rotation (rad), in [−π, π].
pub(super) fn planar_angle(plane: Plane, rotation: &UnitQuaternion<f64>) -> f64 {
    rotation.scaled_axis().dot(&plane.normal())
}

/// The same orientation by an angle in [−π, π], unchanged if it already is in that range (rad).
fn principal_angle(plane: Plane, angle: f64) -> f64 {
    if angle.abs() <= std::f64::consts::PI { angle } else { planar_angle(plane, &planar_rotation(plane, angle)) }
}

/// The rotation with three components of its quaternion rounded to 2⁻⁴⁸ (4e-15), and the largest one computed from
/// them.
///
/// A matrix and a quaternion convert to each other with rounding errors of 1e-16. The coarser grid absorbs them, so
/// that an orientation written as a matrix is read back to the same bits.
fn rounded(rotation: &UnitQuaternion<f64>) -> UnitQuaternion<f64> {
    let unit = UnitQuaternion::new_normalize(rotation.into_inner());
    let mut components = <[f64; 4]>::from(unit.coords);
    // among equal components, as in quarter turns, rounding must not choose: the last one counts as the largest
    let larger = |best: usize, next| {
        if components[next] * components[next] > components[best].powi(2) + TIE { next } else { best }
    };
    let largest = [2, 1, 0].into_iter().fold(3, larger);
    let sign = components[largest].signum();
    components = components.map(|component| (component * sign * ROTATION_GRID).round() / ROTATION_GRID);
    components[largest] = 0.0;
    components[largest] = (1.0 - components.iter().map(|component| component * component).sum::<f64>()).sqrt();
    let [x, y, z, w] = components;
    UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use nalgebra::Vector3;

    use super::*;

    /// Quarter, half and third turns have quaternions with equal components, of which rounding could make any the
    /// largest.
    #[test]
    fn turns_with_equal_quaternion_components_come_back_to_the_bit() {
        let quarters = [0, 1, 2, 3].map(|quarter| f64::from(quarter) * FRAC_PI_2);
        for angles in quarters.iter().flat_map(|x| quarters.iter().flat_map(move |y| quarters.map(|z| [*x, *y, z]))) {
            let turn = Pose::from_xyz_angles(Vector3::zeros(), angles).rotation;
            let kept = rounded(&turn);
            let again = rounded(&UnitQuaternion::from_rotation_matrix(&kept.to_rotation_matrix()));
            assert_eq!(kept.coords, again.coords, "{angles:?}");
            assert!(kept.angle_to(&turn) < 1e-7, "{angles:?}"); // the arc cosine inside loses half the digits
            assert!((kept.norm() - 1.0).abs() < 4.0 * f64::EPSILON);
        }
    }
}
