//! Criteria: properties that are tested at a pose, one file each.

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
pub(crate) use cables::{check_limits, length_scale_of};
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

/// Property of poses: it holds at some poses and fails at others.
///
/// A criterion owns its inputs (model, load, limits) and gives the same answer for the same pose, independent of
/// earlier calls: threads share it.
pub trait Criterion: Sync {
    /// Name on the command line, e.g. `wrench-feasible`.
    fn name(&self) -> &str;

    /// Unit of the margin; `1` if it is dimensionless.
    fn unit(&self) -> &str;

    /// The full answer at a pose.
    fn judge(&self, pose: &Pose) -> Verdict;

    /// True if it holds at a pose: the verdict of [`Criterion::judge`], possibly computed faster.
    fn holds(&self, pose: &Pose) -> bool {
        self.judge(pose).holds()
    }

    /// Time per pose, in units of a pose of wrench feasibility in a batch, as an order of magnitude: it limits how many
    /// poses a search without a given step may judge.
    fn effort(&self) -> f64 {
        30.0
    }

    /// Spans (m) of a straight line on which it holds, in closed form: from `start` with its rotation, along a
    /// direction of length 1, up to `length` (m). `None` for criteria without a closed form, as for most: then poses
    /// are judged.
    ///
    /// A criterion answers for all lines of one model alike, with intervals or with `None`.
    fn holds_along(&self, _start: &Pose, _direction: &Vector3<f64>, _length: f64) -> Option<Spans> {
        None
    }

    /// Writes for each pose whether it holds; `answers` has one entry per pose.
    fn holds_all(&self, poses: &[Pose], answers: &mut [bool]) {
        for (pose, answer) in poses.iter().zip(answers) {
            *answer = self.holds(pose);
        }
    }
}
