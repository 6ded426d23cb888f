//! The box of positions in which a workspace is looked for.

use nalgebra::Vector3;

use super::WorkspaceError;
use crate::model::Model;

/// Coordinates of a position along the translations of the robot (m): x, y, z, or the two of its plane and 0.
pub type Point = [f64; 3];

/// An axis-parallel box of positions in two or three dimensions (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    dimension: usize,
    least: Point,
    largest: Point,
}

impl Bounds {
    /// A box in two or three dimensions from its ends x0, x1, y0, y1 (, z0, z1) along the axes of the robot (m).
    pub fn new(dimension: usize, ends: &[f64]) -> Result<Self, WorkspaceError> {
        let dimension = dimension.clamp(2, 3);
        if ends.len() != 2 * dimension {
            return Err(WorkspaceError::BoundsCount { expected: 2 * dimension, found: ends.len() });
        }
        let mut bounds = Self { dimension, least: [0.0; 3], largest: [0.0; 3] };
        for (axis, pair) in ends.chunks_exact(2).enumerate() {
            // written so that NaN is refused too
            if !(pair[0] < pair[1] && (pair[1] - pair[0]).is_finite()) {
                return Err(WorkspaceError::Bounds { axis: axis + 1, least: pair[0], largest: pair[1] });
            }
            (bounds.least[axis], bounds.largest[axis]) = (pair[0], pair[1]);
        }
        Ok(bounds)
    }

    /// A box for a robot whose set of poses is not known yet: around its frame anchors and the travel that its file states.
    ///
    /// The box reaches a quarter of its longest side further, for the origin of a platform may leave the frame; directions in
    /// which the frame is flat, as that of a robot that hangs from a ceiling, a whole side.
    pub fn around(model: &Model) -> Result<Self, WorkspaceError> {
        let robot = model.robot();
        let mut corners: Vec<Vector3<f64>> = robot.cables.iter().map(|cable| cable.frame_anchor).collect();
        corners.extend(robot.travel.iter().flat_map(|travel| [travel.min, travel.max]));
        let mut ends = Vec::new();
        for axis in model.axes() {
            let along = || corners.iter().map(|corner| axis.dot(corner));
            ends.push([along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]);
        }
        let longest = ends.iter().map(|[least, largest]| largest - least).fold(0.0, f64::max);
        for [least, largest] in &mut ends {
            let is_flat = *largest - *least < 0.1 * longest;
            let further = if is_flat { longest } else { 0.25 * longest };
            (*least, *largest) = (*least - further, *largest + further);
        }
        Self::new(ends.len(), ends.as_flattened())
    }

    /// 2 in a plane, 3 in space.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Lower corner (m).
    pub fn least(&self) -> &Point {
        &self.least
    }

    /// Upper corner (m).
    pub fn largest(&self) -> &Point {
        &self.largest
    }

    /// The ends x0, x1, y0, y1 (, z0, z1) (m).
    pub fn ends(&self) -> Vec<f64> {
        (0..self.dimension).flat_map(|axis| [self.least[axis], self.largest[axis]]).collect()
    }

    /// A usual size of cells (m): a hundredth of the longest side in a plane, a fiftieth in space.
    pub fn usual_step(&self) -> f64 {
        let longest = (0..self.dimension).map(|axis| self.extent(axis)).fold(0.0, f64::max);
        longest / if self.dimension == 2 { 100.0 } else { 50.0 }
    }

    /// Length along an axis (m).
    pub fn extent(&self, axis: usize) -> f64 {
        self.largest[axis] - self.least[axis]
    }

    /// Area (m²) or volume (m³).
    pub fn size(&self) -> f64 {
        (0..self.dimension).map(|axis| self.extent(axis)).product()
    }

    /// The middle (m).
    pub fn middle(&self) -> Point {
        [0, 1, 2].map(|axis| 0.5 * (self.least[axis] + self.largest[axis]))
    }

    /// True for points in the box or on its faces.
    pub fn contain(&self, point: &Point) -> bool {
        (0..self.dimension).all(|axis| (self.least[axis]..=self.largest[axis]).contains(&point[axis]))
    }

    /// How far a ray from a point in the box runs until it leaves it (m), for a direction of length 1.
    pub fn way_out(&self, from: &Point, direction: &Point) -> f64 {
        let mut way = f64::INFINITY;
        for axis in 0..self.dimension {
            let end = if direction[axis] > 0.0 { self.largest[axis] } else { self.least[axis] };
            if direction[axis] != 0.0 {
                way = way.min(((end - from[axis]) / direction[axis]).max(0.0));
            }
        }
        way
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Composition;
    use crate::robot::Robot;

    #[test]
    fn reversed_missing_and_nan_ends_are_refused() {
        assert!(matches!(Bounds::new(2, &[0.0, 1.0, 2.0, -2.0]), Err(WorkspaceError::Bounds { axis: 2, .. })));
        assert!(matches!(Bounds::new(2, &[0.0, 1.0, f64::NAN, 2.0]), Err(WorkspaceError::Bounds { axis: 2, .. })));
        assert!(matches!(Bounds::new(2, &[0.0, 1.0, 2.0]), Err(WorkspaceError::BoundsCount { found: 3, .. })));
    }

    #[test]
    fn a_ray_leaves_the_box_through_the_nearest_face() {
        let bounds = Bounds::new(2, &[0.0, 4.0, 0.0, 2.0]).unwrap();
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let way = bounds.way_out(&[1.0, 1.0, 0.0], &[half, half, 0.0]);
        assert!((way - 2.0_f64.sqrt()).abs() < 1e-15);
        assert_eq!(bounds.way_out(&[1.0, 1.0, 0.0], &[-1.0, 0.0, 0.0]), 1.0);
    }

    /// The platform of a robot under a ceiling hangs below all its anchors.
    #[test]
    fn the_box_of_a_robot_with_a_flat_frame_reaches_below_it() {
        let model = Model::new(Robot::builtin("cogiro").unwrap(), Composition::STANDARD).unwrap();
        let bounds = Bounds::around(&model).unwrap();
        let home = model.robot().home.unwrap().position;
        assert!(bounds.contain(&[home.x, home.y, home.z]), "{bounds:?} {home:?}");
    }
}
