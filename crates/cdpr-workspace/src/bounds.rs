//! The box of positions in which a workspace is searched.

use nalgebra::Vector3;

use super::{Point, WorkspaceError};
use cdpr_model::model::Model;

/// Height of a frame, as a fraction of its longest side, below which it is flat.
const FLAT: f64 = 0.1;
/// Cosine to the direction against gravity above which an axis is vertical.
const UPRIGHT: f64 = 0.99;

/// Least and largest coordinate of frame anchors, travel and home position along each axis of the robot (m).
pub(super) fn frame_of(model: &Model) -> Vec<[f64; 2]> {
    let robot = model.robot();
    let mut points: Vec<Vector3<f64>> = robot.cables.iter().map(|cable| cable.frame_anchor).collect();
    points.extend(robot.travel.iter().flat_map(|travel| [travel.min, travel.max]));
    points.extend(robot.home.iter().map(|home| home.position));
    let along = |axis: &Vector3<f64>| {
        let places = points.iter().map(|point| axis.dot(point));
        places
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, largest], place| [least.min(place), largest.max(place)])
    };
    model.axes().iter().map(along).collect()
}

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

    /// A box for a robot whose set of poses is unknown: around its frame anchors, the travel that its file states and
    /// its home position.
    ///
    /// The box extends a quarter of its longest side further, since the origin of a platform may leave the frame. At a
    /// flat frame it extends a whole side downwards and not upwards, since the platform hangs; without gravity, to both
    /// sides. It ends at the floor, the plane of height zero, if nothing of the file lies below it; the plane of a flat
    /// frame itself is no floor, since the platform hangs under it.
    pub fn around(model: &Model) -> Result<Self, WorkspaceError> {
        let gravity = model.robot().gravity.unwrap_or_default();
        let mut ends = frame_of(model);
        let longest = ends.iter().map(|[least, largest]| largest - least).fold(0.0, f64::max);
        for (axis, [least, largest]) in model.axes().iter().zip(&mut ends) {
            let is_flat = *largest - *least < FLAT * longest;
            let is_vertical = -axis.dot(&gravity) > UPRIGHT * gravity.norm();
            let has_floor = is_vertical && *least >= 0.0 && *largest >= FLAT * longest;
            let floor = if has_floor { 0.0 } else { f64::NEG_INFINITY };
            let [below, above] = match (is_flat, is_vertical) {
                (true, true) => [longest, 0.0],
                (true, false) => [longest; 2],
                (false, _) => [0.25 * longest; 2],
            };
            (*least, *largest) = ((*least - below).max(floor), *largest + above);
        }
        Self::new(ends.len(), ends.as_flattened())
    }

    /// Length of the longest side (m).
    pub(crate) fn longest(&self) -> f64 {
        (0..self.dimension).map(|axis| self.extent(axis)).fold(0.0, f64::max)
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
    pub(crate) fn largest(&self) -> &Point {
        &self.largest
    }

    /// The ends x0, x1, y0, y1 (, z0, z1) (m).
    pub fn ends(&self) -> Vec<f64> {
        (0..self.dimension).flat_map(|axis| [self.least[axis], self.largest[axis]]).collect()
    }

    /// Default size of cells (m): a hundredth of the longest side in a plane, a fiftieth in space.
    pub fn usual_step(&self) -> f64 {
        self.longest() / if self.dimension == 2 { 100.0 } else { 50.0 }
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

    /// Distance from a point in the box to its faces along a direction of length 1 (m).
    pub(crate) fn way_out(&self, from: &Point, direction: &Point) -> f64 {
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
    use nalgebra::UnitQuaternion;

    use super::*;
    use crate::Region;
    use crate::refine::Goal;
    use crate::{Archetype, Criterion, Verdict};
    use cdpr_model::geometry::Pose;
    use cdpr_model::model::Composition;
    use cdpr_model::robot::Robot;

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

    /// The platform of a robot under a ceiling hangs below all its anchors, and above the floor.
    #[test]
    fn the_box_of_a_robot_with_a_flat_frame_reaches_down_to_the_floor() {
        let ends_of = |change: &dyn Fn(&mut Robot)| {
            let mut robot = Robot::builtin("cogiro").unwrap();
            robot.travel = None;
            change(&mut robot);
            Bounds::around(&Model::new(robot, Composition::STANDARD).unwrap()).unwrap().ends()
        };
        assert_eq!(ends_of(&|robot: &mut Robot| robot.home = None)[4..], [0.0, 5.42]);
        // high above a floor, or below the origin, the file shows no floor: the longest side is 14.98 m
        let lifted = |by: f64| {
            move |robot: &mut Robot| {
                robot.cables.iter_mut().for_each(|cable| cable.frame_anchor.z += by);
                robot.home = None;
            }
        };
        let [high, low] = [100.0, -100.0].map(|by| ends_of(&lifted(by)));
        assert!((high[4] - (105.3874 - 14.9802)).abs() < 1e-9, "{high:?}");
        assert!((low[4] - (-94.6126 - 14.9802)).abs() < 1e-9, "{low:?}");
    }

    /// If the origin lies in the plane of the anchors, the plane of height zero is that of the frame: the platform
    /// hangs under it.
    #[test]
    fn the_box_of_a_robot_whose_flat_frame_lies_at_height_zero_reaches_down() {
        for (heights, top) in [([0.0, 0.0], 0.0), ([0.0, 0.02], 0.02)] {
            let mut robot = Robot::builtin("cogiro").unwrap();
            (robot.travel, robot.home) = (None, None);
            let cables = robot.cables.iter_mut().enumerate();
            cables.for_each(|(index, cable)| cable.frame_anchor.z = heights[index % 2]);
            let ends = Bounds::around(&Model::new(robot, Composition::STANDARD).unwrap()).unwrap().ends();
            assert!((ends[4] + 14.9802).abs() < 1e-9 && ends[5] == top, "{ends:?}");
        }
    }

    /// The box of a ball in the middle of the frame is the frame, that of a ball that leaves it is a little larger.
    #[test]
    fn the_box_about_a_region_is_that_of_the_frame_unless_the_region_may_reach_out_of_it() {
        struct Ball(f64);
        impl Criterion for Ball {
            fn name(&self) -> &str {
                "ball"
            }
            fn unit(&self) -> &str {
                "m"
            }
            fn judge(&self, pose: &Pose) -> Verdict {
                match self.0 - (pose.position - Vector3::new(0.0, 0.0, 1.0)).norm() {
                    margin if margin >= 0.0 => Verdict::held(margin, None),
                    margin => Verdict::failed(margin, "outside", None),
                }
            }
        }
        let model =
            Model::new(Robot::builtin("cablerobot-simulator-icosahedron").unwrap(), Composition::STANDARD).unwrap();
        let ends = |radius: f64| {
            let criterion = Ball(radius);
            let upright = Archetype::ConstantOrientation(UnitQuaternion::identity());
            let region = Region::new(&model, &criterion, &upright).unwrap();
            Bounds::about(&region, &model, &Goal::usual()).unwrap().ends()
        };
        let frame = [-5.461, 5.218, -6.509, 7.677, -1.242, 6.642];
        assert_eq!(ends(0.9), frame);
        let wider = ends(3.0);
        assert!(wider[4] < -2.0 && wider[4] > -3.6 && wider[5] == frame[5] && wider[..4] == frame[..4], "{wider:?}");
        assert_eq!(ends(0.0), Bounds::around(&model).unwrap().ends());
    }
}
