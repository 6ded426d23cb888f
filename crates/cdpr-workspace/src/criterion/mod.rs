//! Criteria: what has to hold at a pose, one file each.

mod any_all;
mod cable_interference;
mod cables;
mod clearance;
mod dexterity;
mod entries;
mod entry;
mod lengths;
mod minors;
mod narrowing;
mod natural_frequency;
mod obstacles;
#[cfg(test)]
mod oracles;
mod platform_interference;
mod platform_obstacles;
pub mod registry;
mod spans;
mod stability;
mod stiffness;
#[cfg(test)]
mod tests;
mod validity;
mod wrap;
mod wrench_closure;
mod wrench_feasible;
mod wrench_set_feasible;

pub use any_all::{All, Any};
pub(crate) use cable_interference::CableInterference;
pub(crate) use dexterity::{Dexterity, JacobianConditioning};
pub use lengths::LengthLimits;
pub(crate) use natural_frequency::NaturalFrequency;
pub(crate) use obstacles::CableObstacles;
pub(crate) use platform_interference::PlatformInterference;
pub use platform_obstacles::PlatformObstacles;
pub use spans::Spans;
pub(crate) use stability::StaticStability;
pub(crate) use stiffness::MinimumStiffness;
pub(crate) use validity::ModelValidity;
pub(crate) use wrap::WrapLimits;
pub use wrench_closure::WrenchClosure;
pub(super) use wrench_closure::rank;
pub use wrench_feasible::WrenchFeasible;
pub use wrench_set_feasible::Requirement;
pub(crate) use wrench_set_feasible::WrenchSetFeasible;

use nalgebra::Vector3;

use super::Verdict;
use cdpr_model::geometry::Pose;

/// Property of poses: it holds at some and fails at others.
///
/// A criterion holds what it needs (model, load, limits) and answers the same for the same pose, whatever was asked
/// before: threads share it.
pub trait Criterion: Sync {
    /// Name on the command line, e.g. `wrench-feasible`.
    fn name(&self) -> &str;

    /// Unit of the margin; `1` where it has none.
    fn unit(&self) -> &str;

    /// The full answer at a pose.
    fn judge(&self, pose: &Pose) -> Verdict;

    /// Whether it holds at a pose: the verdict of [`Criterion::judge`], faster where that can be.
    fn holds(&self, pose: &Pose) -> bool {
        self.judge(pose).holds()
    }

    /// How long a pose takes, in units of a pose of wrench feasibility in a batch, by orders of magnitude: what a search may ask that
    /// nobody gave a step to.
    fn effort(&self) -> f64 {
        30.0
    }

    /// Spans (m) of a straight way along which it holds, in closed form: from `start` on with its rotation, along a direction of
    /// length 1, so far (m). `None` where it has no closed form, as most criteria: then poses are judged.
    ///
    /// A criterion answers all ways of one model alike, with intervals or with `None`.
    fn holds_along(&self, _start: &Pose, _direction: &Vector3<f64>, _length: f64) -> Option<Spans> {
        None
    }

    /// Whether it holds at each of many poses; `answers` has one entry per pose.
    fn holds_all(&self, poses: &[Pose], answers: &mut [bool]) {
        for (pose, answer) in poses.iter().zip(answers) {
            *answer = self.holds(pose);
        }
    }
}
