//! Doubts about the numbers of a robot that its own file raises, without data: directions, frames, symmetry, sizes.
//!
//! No robot is refused by them; each asks about a number that is seldom meant.

mod frames;
mod gravity;
mod sizes;
mod symmetry;

use super::Robot;
use crate::finding::Finding;

/// Functions of all kinds of doubts, in the order of their findings.
const DOUBTS: [fn(&Robot) -> Vec<Finding>; 5] = [
    gravity::upside_down,
    gravity::anchors_below,
    frames::platform_anchors_in_world,
    symmetry::anchor_beside_the_symmetry,
    sizes::of_another_unit,
];

impl Robot {
    /// Doubts about the numbers of the robot, each with its kind, and its cable where it is about one.
    pub fn doubts(&self) -> Vec<Finding> {
        DOUBTS.iter().flat_map(|doubt| doubt(self)).collect()
    }
}
