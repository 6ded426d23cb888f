//! One cable at eight poses at once.

use crate::cable::{Course, outlet};
use crate::model::CableGroup;
use crate::scalar::{LANES, Lanes, add, constants, dot, rotate, scale, sub};

/// A cable at poses in lanes.
pub(crate) struct CourseInLanes<L> {
    pub(crate) course: Course<L>,
    /// b = R b_P (world, m).
    pub(crate) lever: [L; 3],
    /// 0 where the course exists for sure, 1 where the single pose must say whether it does.
    pub(crate) doubt: L,
}

/// Distances that are certainly neither zero nor too large (m).
const SHORTEST: f64 = 1e-100;
const LONGEST: f64 = 1e100;
/// Far above the sine of the angle from the swivel axis, or from the edge of the open side, that rounding cannot tell from 0.
const CLEAR: f64 = 1e-6;

impl CableGroup {
    /// Course and lever of one of the group's cables at poses given by positions and rotation rows: the bits of
    /// `Model::course_at`.
    #[inline(always)]
    pub(crate) fn course_in_lanes<L: Lanes>(
        &self,
        lane: usize,
        position: [L; 3],
        rotation: &[[L; 3]; 3],
    ) -> CourseInLanes<L> {
        let l = position[0];
        let lever = rotate(rotation, constants(l, entry(&self.platform_anchor, lane)));
        let anchor = add(position, lever);
        let frame_anchor = constants(l, entry(&self.frame_anchor, lane));
        let (zero, one) = (l.constant(0.0), l.constant(1.0));
        let mut doubt = zero;
        let course = if self.has_pulley {
            let axis = constants(l, entry(&self.swivel_axis, lane));
            let radius = l.constant(self.radius[lane]);
            let d = sub(anchor, frame_anchor);
            let b_z = dot(d, axis);
            let square = dot(d, d);
            match &self.pulley_side {
                None => {
                    // the outlet computes the same, which costs nothing twice
                    let across = sub(d, scale(b_z, axis));
                    let least = (square + radius * radius) * l.constant(CLEAR * CLEAR);
                    doubt = zero.select(least.is_less(dot(across, across)), one);
                    outlet::pulley::course(frame_anchor, axis, radius, anchor)
                }
                Some(side) => {
                    let side = constants(l, entry(side, lane));
                    let least = square.sqrt() * l.constant(CLEAR);
                    // on the closed side, or below the edge
                    let inside = dot(d, side).max(-b_z);
                    doubt = zero.select(least.is_less(inside), one);
                    outlet::pulley::course_on_side(frame_anchor, axis, side, radius, anchor)
                }
            }
        } else {
            outlet::point::course(frame_anchor, anchor)
        };
        // NaN is neither
        doubt = doubt.select(l.constant(SHORTEST).is_less(course.free_length), one);
        doubt = doubt.select(course.length.is_less(l.constant(LONGEST)), one);
        CourseInLanes { course, lever, doubt }
    }
}

#[inline(always)]
fn entry(vectors: &[[f64; LANES]; 3], lane: usize) -> [f64; 3] {
    [vectors[0][lane], vectors[1][lane], vectors[2][lane]]
}
