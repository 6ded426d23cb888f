//! Answer of every forward problem.

use thiserror::Error;

use crate::geometry::{POSE_ROWS, Pose};
use crate::reading::keywords;
use crate::scalar::LaneTable;

/// How the search for a pose ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// The pose is the solution: of lengths the exact or least-squares fit, of forces a stable equilibrium.
    Converged,
    /// No solution was found; the pose is the best one and `reason` states the cause.
    NotConverged,
    /// Lengths and load do not determine the pose: the platform can move there without resistance.
    Singular,
    /// An equilibrium that the smallest disturbance ends; no stable one was found.
    Unstable,
}

keywords!(Status: Converged = "converged", NotConverged = "not-converged", Singular = "singular", Unstable = "unstable");

/// Outcome of a forward problem; `pose` is the best one found even when it did not converge.
#[must_use = "check `status` before using the pose"]
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Platform pose.
    pub pose: Pose,
    /// How the search ended.
    pub status: Status,
    /// Tension per cable at its outlet (N), 0 if slack; empty if only lengths are fitted, from which no tensions
    /// follow.
    pub tensions: Vec<f64>,
    /// Residual per cable at `pose` (m), modelled minus given length. In an equilibrium it is the controlled length
    /// that follows from pose and tension minus the given one: 0 for a taut cable, minus the excess length for a slack
    /// one. NaN for a cable without a path.
    pub residuals: Vec<f64>,
    /// Root mean square of `residuals` if lengths are fitted (m); NaN for an equilibrium.
    pub residual_rms: f64,
    /// Size of Aᵀ f + w in an equilibrium, moments divided by the platform radius (N); NaN if lengths are fitted.
    pub wrench_residual: f64,
    /// Smallest eigenvalue of the symmetric part of K_wx, rotations divided by the platform radius (N/m): positive if
    /// stable.
    ///
    /// With taut rigid cables it is the stiffness of the motions that they leave free, infinite if there are none. NaN
    /// if lengths are fitted.
    pub stability: f64,
    /// Number of slack cables; 0 if lengths are fitted.
    pub slack: usize,
    /// Steps of all starts, accepted and rejected.
    pub iterations: u32,
    /// Starts tried beyond the guess.
    pub restarts: u32,
    /// The reason unless converged, or a remark on a converged answer; `None` without either.
    pub reason: Option<String>,
}

impl Status {
    /// The status as a number, for tables of lanes.
    pub(super) fn code(self) -> f64 {
        match self {
            Self::Converged => 0.0,
            Self::NotConverged => 1.0,
            Self::Singular => 2.0,
            Self::Unstable => 3.0,
        }
    }

    /// Inverse of [`Status::code`].
    pub(super) fn of_code(code: f64) -> Self {
        match code {
            0.0 => Self::Converged,
            2.0 => Self::Singular,
            3.0 => Self::Unstable,
            _ => Self::NotConverged,
        }
    }
}

/// A forward problem whose search ended without an answer.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{}", .reason.as_deref().unwrap_or("the forward problem has no solution"))]
pub struct NoSolution {
    /// End of the search.
    pub status: Status,
    /// The reason in words, if known.
    pub reason: Option<String>,
}

impl Solution {
    /// The solution if it has converged; otherwise its status and reason.
    pub fn converged(&self) -> Result<&Self, NoSolution> {
        match self.status {
            Status::Converged => Ok(self),
            status => Err(NoSolution { status, reason: self.reason.clone() }),
        }
    }

    /// Memory for an answer with this many cables and tensions.
    pub(super) fn unsolved(cables: usize, tensions: usize) -> Self {
        Self {
            pose: Pose::identity(),
            status: Status::NotConverged,
            tensions: vec![f64::NAN; tensions],
            residuals: vec![f64::NAN; cables],
            residual_rms: f64::NAN,
            wrench_residual: f64::NAN,
            stability: f64::NAN,
            slack: 0,
            iterations: 0,
            restarts: 0,
            reason: None,
        }
    }
}

/// Rows of a table of solutions: the pose, these, then the tensions.
pub(super) const RMS: usize = POSE_ROWS;
pub(super) const ITERATIONS: usize = POSE_ROWS + 1;
pub(super) const STATUS: usize = POSE_ROWS + 2;
pub(super) const TENSIONS: usize = POSE_ROWS + 3;

/// Outcomes of many forward problems; a pose is the best one found even when it did not converge.
#[must_use = "check `status` before using a pose"]
#[derive(Clone, Debug, PartialEq)]
pub struct Solutions {
    pub(super) table: LaneTable,
}

impl Default for Solutions {
    fn default() -> Self {
        Self { table: LaneTable::new(TENSIONS) }
    }
}

impl Solutions {
    /// Number of problems.
    pub fn len(&self) -> usize {
        self.table.len()
    }

    /// True if there are no problems.
    pub fn is_empty(&self) -> bool {
        self.table.is_empty()
    }

    /// Pose of one problem (from 0); panics for an item out of range, as all of these functions do.
    pub fn pose(&self, item: usize) -> Pose {
        Pose::from_numbers(std::array::from_fn(|row| self.table.get(row, item)))
    }

    /// True if the problems are equilibria, which tell tensions.
    pub fn has_tensions(&self) -> bool {
        self.table.rows() > TENSIONS
    }

    /// Tension of one cable (from 0) at its outlet (N), 0 if slack; panics if only lengths were fitted, from which no
    /// tensions follow.
    pub fn tension(&self, cable: usize, item: usize) -> f64 {
        self.table.get(TENSIONS + cable, item)
    }

    /// Status of one problem; only the solver of a single problem gives a reason in words.
    pub fn status(&self, item: usize) -> Status {
        Status::of_code(self.table.get(STATUS, item))
    }

    /// Root mean square of the residuals if lengths are fitted (m); 0 for an equilibrium, since its taut cables have
    /// their lengths.
    pub fn residual_rms(&self, item: usize) -> f64 {
        self.table.get(RMS, item)
    }

    /// Steps of all starts.
    pub fn iterations(&self, item: usize) -> u32 {
        self.table.get(ITERATIONS, item) as u32
    }
}
