//! Motion patterns: planar and point robots select rows of the spatial equations.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::{Pose, Twist};

/// Which degrees of freedom a platform has: R rotations, T translations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[non_exhaustive]
pub enum MotionPattern {
    /// Point platform in a plane.
    #[serde(rename = "2T")]
    PlanarPoint,
    /// Point platform in space.
    #[serde(rename = "3T")]
    SpatialPoint,
    /// Platform in a plane, turning about the plane's normal.
    #[serde(rename = "1R2T")]
    Planar,
    /// Platform with all six degrees of freedom.
    #[serde(rename = "3R3T")]
    Spatial,
}

impl MotionPattern {
    /// Number of degrees of freedom n.
    pub fn dof(self) -> usize {
        match self {
            Self::PlanarPoint => 2,
            Self::SpatialPoint | Self::Planar => 3,
            Self::Spatial => 6,
        }
    }

    /// Number of translations.
    pub fn translations(self) -> usize {
        if self.is_planar() { 2 } else { 3 }
    }

    /// True for 2T and 1R2T, whose files use 2-vectors in a plane.
    pub fn is_planar(self) -> bool {
        matches!(self, Self::PlanarPoint | Self::Planar)
    }

    /// True if the platform can rotate.
    pub fn has_rotation(self) -> bool {
        matches!(self, Self::Planar | Self::Spatial)
    }

    /// The name used in files: `2T`, `3T`, `1R2T` or `3R3T`.
    pub fn name(self) -> &'static str {
        match self {
            Self::PlanarPoint => "2T",
            Self::SpatialPoint => "3T",
            Self::Planar => "1R2T",
            Self::Spatial => "3R3T",
        }
    }

    /// Names of the pose components, as the option `--pose` expects them.
    pub(crate) fn pose_components(self) -> &'static str {
        match self {
            Self::PlanarPoint => "x,y",
            Self::SpatialPoint => "x,y,z",
            Self::Planar => "x,y,angle",
            Self::Spatial => "x,y,z,rx,ry,rz",
        }
    }
}

/// The plane of a planar robot: two world axes e₁, e₂; angles turn from e₁ to e₂ about n = e₁ × e₂.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plane {
    first: usize,
    second: usize,
}

impl Plane {
    /// The plane of a file's `axes`, e.g. `"xz"`; `None` unless it is two different letters out of x, y, z.
    pub fn from_axes(axes: &str) -> Option<Self> {
        let index = |letter: u8| "xyz".bytes().position(|known| known == letter);
        let &[first, second] = axes.as_bytes() else { return None };
        let (first, second) = (index(first)?, index(second)?);
        (first != second).then_some(Self { first, second })
    }

    /// The letters of the two axes.
    pub fn axes(self) -> String {
        [self.first, self.second].iter().map(|&index| ["x", "y", "z"][index]).collect()
    }

    /// The two axes as indices of world coordinates.
    pub(crate) fn indices(self) -> [usize; 2] {
        [self.first, self.second]
    }

    /// e₁ (unit, world).
    pub fn first_axis(self) -> Vector3<f64> {
        Vector3::ith(self.first, 1.0)
    }

    /// e₂ (unit, world).
    pub fn second_axis(self) -> Vector3<f64> {
        Vector3::ith(self.second, 1.0)
    }

    /// n = e₁ × e₂ (unit, world): the axis of angle and moment.
    pub fn normal(self) -> Vector3<f64> {
        self.first_axis().cross(&self.second_axis())
    }

    /// The vector with these two components along e₁ and e₂ (world, m).
    pub fn embed(self, components: [f64; 2]) -> Vector3<f64> {
        self.first_axis() * components[0] + self.second_axis() * components[1]
    }

    /// The two components of a point (m).
    pub fn components(self, point: &Vector3<f64>) -> [f64; 2] {
        [point[self.first], point[self.second]]
    }
}

impl Default for Plane {
    fn default() -> Self {
        Self { first: 0, second: 1 }
    }
}

/// A pose that does not fit the motion pattern.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PatternError {
    /// Another number of pose components than the pattern has.
    #[error("motion pattern {pattern} takes the pose components {components}, found {found} numbers")]
    ComponentCount {
        /// Name of the pattern.
        pattern: &'static str,
        /// Names of its components.
        components: String,
        /// Number of components given.
        found: usize,
    },
    /// A component is NaN or infinite.
    #[error("pose component {index} is {value}; a pose takes finite numbers (m, rad)")]
    NotFinite {
        /// Position in the list, from 1.
        index: usize,
        /// Value given.
        value: f64,
    },
}

impl MotionPattern {
    /// Directions in which a pose can move, as n columns of twists; translations along the file's axes first.
    pub fn twist_basis(self, plane: Plane) -> Vec<Twist> {
        let stacked = |v: Vector3<f64>, omega: Vector3<f64>| Twist::new(v.x, v.y, v.z, omega.x, omega.y, omega.z);
        let zero = Vector3::zeros();
        let mut basis = match self.is_planar() {
            true => vec![stacked(plane.first_axis(), zero), stacked(plane.second_axis(), zero)],
            false => (0..3).map(|axis| stacked(Vector3::ith(axis, 1.0), zero)).collect(),
        };
        match self {
            Self::Planar => basis.push(stacked(zero, plane.normal())),
            Self::Spatial => basis.extend((0..3).map(|axis| stacked(zero, Vector3::ith(axis, 1.0)))),
            Self::PlanarPoint | Self::SpatialPoint => {}
        }
        basis
    }

    /// Names of the pose components, for a planar robot with the letters of its plane.
    pub fn component_names(self, plane: Plane) -> Vec<String> {
        let mut names: Vec<String> = self.pose_components().split(',').map(str::to_owned).collect();
        if self.is_planar() {
            plane.axes().chars().zip(&mut names).for_each(|(axis, name)| *name = axis.to_string());
        }
        names
    }

    /// Names of the components of a wrench, for a planar robot with the letters of its plane: forces, then the moments
    /// about the platform origin.
    pub fn wrench_names(self, plane: Plane) -> Vec<String> {
        let letters = self.component_names(plane);
        let forces = letters.iter().take(self.translations()).map(|axis| format!("f{axis}"));
        let moments: &[&str] = match self {
            Self::PlanarPoint | Self::SpatialPoint => &[],
            Self::Planar => &["m"],
            Self::Spatial => &["mx", "my", "mz"],
        };
        forces.chain(moments.iter().map(|name| (*name).to_owned())).collect()
    }

    /// Checks that there is one finite number per degree of freedom.
    fn check(self, plane: Plane, components: &[f64]) -> Result<(), PatternError> {
        let (expected, found) = (self.dof(), components.len());
        if expected != found {
            return Err(PatternError::ComponentCount {
                pattern: self.name(),
                components: self.component_names(plane).join(","),
                found,
            });
        }
        if let Some(index) = components.iter().position(|x| !x.is_finite()) {
            return Err(PatternError::NotFinite { index: index + 1, value: components[index] });
        }
        Ok(())
    }

    /// Twist, or acceleration, from its components in the degrees of freedom: translations, then rotations (world axes;
    /// m/s, rad/s and so on).
    pub fn twist(self, plane: Plane, components: &[f64]) -> Result<Twist, PatternError> {
        self.check(plane, components)?;
        Ok(self.twist_basis(plane).iter().zip(components).map(|(basis, number)| basis * *number).sum())
    }

    /// Pose from the components of `MotionPattern::component_names` (m, rad).
    pub fn pose(self, plane: Plane, components: &[f64]) -> Result<Pose, PatternError> {
        self.check(plane, components)?;
        let position = match self.is_planar() {
            true => plane.embed([components[0], components[1]]),
            false => Vector3::new(components[0], components[1], components[2]),
        };
        Ok(match self {
            Self::PlanarPoint | Self::SpatialPoint => Pose { position, ..Pose::identity() },
            Self::Planar => {
                Pose { position, ..Pose::identity() }.displaced(&(self.twist_basis(plane)[2] * components[2]))
            }
            Self::Spatial => Pose::from_xyz_angles(position, [components[3], components[4], components[5]]),
        })
    }

    /// The components of a pose, the inverse of [`MotionPattern::pose`] (m, rad).
    pub fn pose_to_components(self, plane: Plane, pose: &Pose) -> Vec<f64> {
        let mut components = match self.is_planar() {
            true => plane.components(&pose.position).to_vec(),
            false => pose.position.as_slice().to_vec(),
        };
        match self {
            Self::Planar => components.push(pose.rotation.scaled_axis().dot(&plane.normal())),
            Self::Spatial => components.extend(pose.xyz_angles()),
            Self::PlanarPoint | Self::SpatialPoint => {}
        }
        components
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_survive_the_round_trip_in_every_pattern() {
        let plane = Plane::from_axes("xz").unwrap();
        for (pattern, components) in [
            (MotionPattern::PlanarPoint, vec![1.0, 2.0]),
            (MotionPattern::SpatialPoint, vec![1.0, 2.0, 3.0]),
            (MotionPattern::Planar, vec![1.0, 2.0, 0.3]),
            (MotionPattern::Spatial, vec![1.0, 2.0, 3.0, 0.1, 0.2, 0.3]),
        ] {
            let pose = pattern.pose(plane, &components).unwrap();
            for (found, expected) in pattern.pose_to_components(plane, &pose).iter().zip(&components) {
                assert!((found - expected).abs() < 1e-14);
            }
        }
    }

    /// In the xz plane angles turn from x to z, that is about −y.
    #[test]
    fn a_planar_angle_turns_from_the_first_axis_to_the_second() {
        let plane = Plane::from_axes("xz").unwrap();
        let pose = MotionPattern::Planar.pose(plane, &[0.0, 0.0, std::f64::consts::FRAC_PI_2]).unwrap();
        assert!((pose.transform(&Vector3::x()) - Vector3::z()).norm() < 1e-15);
    }

    #[test]
    fn components_of_a_wrench_bear_the_letters_of_the_plane() {
        let names =
            |pattern: MotionPattern, axes: &str| pattern.wrench_names(Plane::from_axes(axes).unwrap()).join(",");
        assert_eq!(names(MotionPattern::Planar, "xz"), "fx,fz,m");
        assert_eq!(names(MotionPattern::PlanarPoint, "zy"), "fz,fy");
        assert_eq!(names(MotionPattern::SpatialPoint, "xy"), "fx,fy,fz");
        assert_eq!(names(MotionPattern::Spatial, "xy"), "fx,fy,fz,mx,my,mz");
    }

    #[test]
    fn wrong_component_counts_and_nan_are_refused() {
        let plane = Plane::default();
        assert!(matches!(
            MotionPattern::Planar.pose(plane, &[1.0, 2.0]),
            Err(PatternError::ComponentCount { found: 2, .. })
        ));
        assert!(matches!(
            MotionPattern::PlanarPoint.pose(plane, &[1.0, f64::NAN]),
            Err(PatternError::NotFinite { index: 2, .. })
        ));
    }
}
