//! Positions at which a criterion holds: in one orientation, in all of a set, or in at least one of it.

use nalgebra::{UnitQuaternion, Vector3};

use super::criterion::Spans;
use super::{Criterion, Point, Verdict, WorkspaceError};
use cdpr_model::geometry::{MotionPattern, Pose};
use cdpr_model::model::Model;

/// Orientations that count (the archetypes of Merlet 2006, ch. 7, and Pott 2018, ch. 5).
///
/// Sets of orientations are samples: a position of the total-orientation or the dextrous workspace was judged in each
/// of them and in none between ([`Region::side`]).
#[derive(Clone, Debug, PartialEq)]
pub enum Archetype {
    /// Positions that the platform reaches in this orientation.
    ConstantOrientation(UnitQuaternion<f64>),
    /// Positions that it reaches in every one of these orientations.
    TotalOrientation(Vec<UnitQuaternion<f64>>),
    /// Positions that it reaches in at least one of these orientations.
    InclusionOrientation(Vec<UnitQuaternion<f64>>),
    /// Positions that it reaches in at least one orientation, sampled by a given one and a number spread evenly.
    Maximal {
        /// The given orientation: its constant-orientation workspace lies in the maximal one.
        besides: UnitQuaternion<f64>,
        /// Number of orientations spread evenly.
        orientations: usize,
    },
    /// Positions that it reaches in every orientation, sampled by a given one and a number spread evenly.
    Dextrous {
        /// The given orientation: the dextrous workspace lies in its constant-orientation one.
        besides: UnitQuaternion<f64>,
        /// Number of orientations spread evenly.
        orientations: usize,
    },
}

/// Side on which the size of a region bounds the archetype's size, since orientations are samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The sizes are equal.
    Exact,
    /// The region is no larger: other orientations of the set may add positions.
    AtLeast,
    /// The region is no smaller: other orientations of the set may rule positions out.
    AtMost,
}

impl Archetype {
    /// The archetype's name: `constant-orientation`, `total-orientation` and so on.
    pub fn name(&self) -> &'static str {
        match self {
            Self::ConstantOrientation(_) => "constant-orientation",
            Self::TotalOrientation(_) => "total-orientation",
            Self::InclusionOrientation(_) => "inclusion-orientation",
            Self::Maximal { .. } => "maximal",
            Self::Dextrous { .. } => "dextrous",
        }
    }
}

/// Positions at which a criterion holds in the orientations of an archetype: the set that grid, octree and hull
/// measure.
#[derive(Clone)]
pub struct Region<'a> {
    criterion: &'a dyn Criterion,
    axes: Vec<Vector3<f64>>,
    orientations: Vec<UnitQuaternion<f64>>,
    needs_every: bool,
    archetype: &'static str,
    side: Side,
}

/// Number of points passed to the criterion at once.
const BATCH: usize = 512;

impl<'a> Region<'a> {
    /// The positions of this model's platform at which the criterion holds.
    pub fn new(model: &Model, criterion: &'a dyn Criterion, archetype: &Archetype) -> Result<Self, WorkspaceError> {
        let robot = model.robot();
        let name = archetype.name();
        let (orientations, needs_every) = match archetype {
            Archetype::ConstantOrientation(orientation) => (vec![*orientation], true),
            _ if !robot.motion_pattern.has_rotation() => {
                return Err(WorkspaceError::NoRotation { archetype: name, pattern: robot.motion_pattern.name() });
            }
            Archetype::TotalOrientation(orientations) => (orientations.clone(), true),
            Archetype::InclusionOrientation(orientations) => (orientations.clone(), false),
            Archetype::Maximal { besides, orientations } => (spread(model, *besides, *orientations), false),
            Archetype::Dextrous { besides, orientations } => (spread(model, *besides, *orientations), true),
        };
        if orientations.is_empty() {
            return Err(WorkspaceError::NoOrientation { archetype: name });
        }
        let side = match archetype {
            Archetype::ConstantOrientation(_) => Side::Exact,
            Archetype::TotalOrientation(all) | Archetype::InclusionOrientation(all) if all.len() == 1 => Side::Exact,
            _ if needs_every => Side::AtMost,
            _ => Side::AtLeast,
        };
        Ok(Self { criterion, axes: model.axes().to_vec(), orientations, needs_every, archetype: name, side })
    }

    /// 2 in a plane, 3 in space.
    pub fn dimension(&self) -> usize {
        self.axes.len()
    }

    /// The criterion.
    pub fn criterion(&self) -> &'a dyn Criterion {
        self.criterion
    }

    /// The orientations that count.
    pub fn orientations(&self) -> &[UnitQuaternion<f64>] {
        &self.orientations
    }

    /// The name of the archetype.
    pub fn archetype(&self) -> &'static str {
        self.archetype
    }

    /// Side on which its size bounds the archetype's, whose set of orientations may have more than were judged.
    pub fn side(&self) -> Side {
        self.side
    }

    /// The same region for another criterion.
    #[must_use]
    pub fn with_criterion<'b>(&self, criterion: &'b dyn Criterion) -> Region<'b> {
        Region { criterion, ..self.clone() }
    }

    /// Position of a point in the world (m).
    pub fn position(&self, point: &Point) -> Vector3<f64> {
        self.axes.iter().zip(point).map(|(axis, along)| axis * *along).sum()
    }

    /// Coordinates of a position in the world along the robot's translations (m).
    pub fn point(&self, position: &Vector3<f64>) -> Point {
        let mut point = [0.0; 3];
        point.iter_mut().zip(&self.axes).for_each(|(along, axis)| *along = axis.dot(position));
        point
    }

    /// The full answer at a point: the least margin of the orientations if all must hold, the largest if one must.
    ///
    /// Reason and cable are those of the orientation with this margin.
    pub fn judge(&self, point: &Point) -> Verdict {
        let position = self.position(point);
        let mut decisive: Option<Verdict> = None;
        for rotation in &self.orientations {
            let verdict = self.criterion.judge(&Pose { position, rotation: *rotation });
            let is_decisive = |before: &Verdict| match self.needs_every {
                true => verdict.margin < before.margin,
                false => verdict.margin > before.margin,
            };
            if decisive.as_ref().is_none_or(is_decisive) {
                decisive = Some(verdict);
            }
        }
        decisive.unwrap_or_else(|| Verdict::impossible("there is no orientation to judge", None))
    }

    /// True if a point belongs to the region.
    pub fn holds(&self, point: &Point) -> bool {
        let position = self.position(point);
        let mut answers =
            self.orientations.iter().map(|rotation| self.criterion.holds(&Pose { position, rotation: *rotation }));
        if self.needs_every { answers.all(|holds| holds) } else { answers.any(|holds| holds) }
    }

    /// Spans (m) of a ray from a point that belong to the region, in closed form, along a direction of length 1 up to
    /// `length` (m); `None` if the criterion has no closed form or several orientations count.
    pub(crate) fn holds_along(&self, from: &Point, direction: &Point, length: f64) -> Option<Spans> {
        let [rotation] = self.orientations[..] else { return None };
        let start = Pose { position: self.position(from), rotation };
        self.criterion.holds_along(&start, &self.position(direction), length)
    }

    /// Writes for each point whether it belongs to the region; `answers` has one entry per point.
    ///
    /// Threads share the points with the feature `parallel`; the answers do not depend on it.
    pub fn holds_all(&self, points: &[Point], answers: &mut [bool]) {
        #[cfg(feature = "parallel")]
        {
            use rayon::prelude::*;
            let fractions = points.par_chunks(BATCH).zip(answers.par_chunks_mut(BATCH));
            fractions.for_each(|(points, answers)| self.holds_batch(points, answers));
        }
        #[cfg(not(feature = "parallel"))]
        for (points, answers) in points.chunks(BATCH).zip(answers.chunks_mut(BATCH)) {
            self.holds_batch(points, answers);
        }
    }

    /// Asks orientation after orientation about the points that earlier ones left undecided.
    fn holds_batch(&self, points: &[Point], answers: &mut [bool]) {
        answers.fill(self.needs_every);
        let mut open: Vec<usize> = (0..points.len()).collect();
        let (mut poses, mut said) = (Vec::with_capacity(points.len()), vec![false; points.len()]);
        for &rotation in &self.orientations {
            poses.clear();
            poses.extend(open.iter().map(|&index| Pose { position: self.position(&points[index]), rotation }));
            self.criterion.holds_all(&poses, &mut said[..open.len()]);
            open.iter().zip(&said).for_each(|(&index, &holds)| answers[index] = holds);
            open.retain(|&index| answers[index] == self.needs_every);
            if open.is_empty() {
                break;
            }
        }
    }
}

/// One orientation, followed by `count` others spread evenly over all that the platform can take.
///
/// In a plane angles of equal distance; in space the super-Fibonacci spiral (Alexa 2022, eq. 5).
fn spread(model: &Model, besides: UnitQuaternion<f64>, count: usize) -> Vec<UnitQuaternion<f64>> {
    let tau = std::f64::consts::TAU;
    let first = std::iter::once(besides);
    if model.robot().motion_pattern == MotionPattern::Planar {
        let normal = model.robot().plane.normal();
        let at = |index: usize| UnitQuaternion::new(normal * (tau * index as f64 / count as f64));
        return first.chain((0..count).map(at)).collect();
    }
    // the positive root of ψ⁴ = ψ + 4 makes the second spiral as irrational as √2 makes the first
    let (phi, psi) = (std::f64::consts::SQRT_2, 1.533_751_168_755_204_3);
    let at = |index: usize| {
        let s = index as f64 + 0.5;
        let fraction = s / count as f64;
        let (inner, outer) = (fraction.sqrt(), (1.0 - fraction).sqrt());
        let (alpha, beta) = (tau * s / phi, tau * s / psi);
        let quaternion =
            nalgebra::Quaternion::new(outer * beta.cos(), inner * alpha.sin(), inner * alpha.cos(), outer * beta.sin());
        UnitQuaternion::new_normalize(quaternion)
    };
    first.chain((0..count).map(at)).collect()
}
