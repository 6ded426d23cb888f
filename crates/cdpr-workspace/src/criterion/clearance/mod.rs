//! Distances between straight cables, boxes and convex bodies: pure geometry.

mod boxes;
mod cone;
mod segment;
mod solid;

pub(super) use boxes::AxisBox;
pub(super) use cone::Cone;
pub(super) use segment::Segment;
pub(super) use solid::{Other, Solid};
