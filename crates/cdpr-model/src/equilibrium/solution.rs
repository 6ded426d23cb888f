//! Answer of every forward problem.

use thiserror::Error;

use crate::geometry::{POSE_ROWS, Pose};
use crate::scalar::LaneTable;

/// How the search for a pose ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Status {
    /// The pose is the solution: of lengths the exact or least-squares fit, of forces a stable equilibrium.
    Converged,
    /// No solution was found; the pose is the best one and `reason` says what stands in the way.
    NotConverged,
    /// Lengths and load do not determine the pose: the platform can move there without resistance.
    Singular,
    /// An equilibrium that the smallest disturbance ends, and no stable one was found.
    Unstable,
}

/// Outcome of a forward problem; `pose` is the best one found even when it did not converge.
#[must_use = "check `status` before using the pose"]
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Platform pose.
    pub pose: Pose,
    /// How the search ended.
    pub status: Status,
    /// Tension per cable at its outlet (N), 0 where slack; empty where lengths alone are fitted, which tells none.
    pub tensions: Vec<f64>,
    /// Residual per cable at `pose` (m), modelled minus given. In an equilibrium the controlled length that pose and tension ask for minus
    /// the given one: 0 where taut, and where slack minus the length that is too much. NaN where a cable has no path.
    pub residuals: Vec<f64>,
    /// Root mean square of `residuals` of lengths that are fitted (m); NaN for an equilibrium.
    pub residual_rms: f64,
    /// Size of Aᵀ f + w in an equilibrium, moments divided by the platform radius (N); NaN where lengths are fitted.
    pub wrench_residual: f64,
    /// Smallest eigenvalue of the symmetric part of K_wx, rotations times the platform radius (N/m): positive where stable.
    ///
    /// Stiffness of the motions that taut rigid cables leave free; infinite where there are none; NaN where lengths are fitted.
    pub stability: f64,
    /// Number of slack cables; 0 where lengths are fitted.
    pub slack: usize,
    /// Steps of all starts, accepted and rejected.
    pub iterations: u32,
    /// Starts tried beyond the guess.
    pub restarts: u32,
    /// The reason in words unless converged; also set where a converged answer needs a remark.
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
    /// The reason in words, where one is known.
    pub reason: Option<String>,
}

impl Solution {
    /// The solution where it has converged.
    pub fn converged(&self) -> Result<&Self, NoSolution> {
        match self.status {
            Status::Converged => Ok(self),
            status => Err(NoSolution { status, reason: self.reason.clone() }),
        }
    }

    /// Room for an answer of this many cables, with as many tensions or none.
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

    /// True without problems.
    pub fn is_empty(&self) -> bool {
        self.table.is_empty()
    }

    /// Pose of one problem (from 0); panics where there is none, as all of these do.
    pub fn pose(&self, item: usize) -> Pose {
        Pose::from_numbers(std::array::from_fn(|row| self.table.get(row, item)))
    }

    /// True if the problems are equilibria, which tell tensions.
    pub fn has_tensions(&self) -> bool {
        self.table.rows() > TENSIONS
    }

    /// Tension of one cable (0-based; N), 0 where slack; panics where lengths alone are fitted, which tells none.
    pub fn tension(&self, cable: usize, item: usize) -> f64 {
        self.table.get(TENSIONS + cable, item)
    }

    /// How the search ended; the single problem says it in words.
    pub fn status(&self, item: usize) -> Status {
        Status::of_code(self.table.get(STATUS, item))
    }

    /// Root mean square of the residuals of lengths that are fitted (m); 0 for an equilibrium, whose taut cables obey theirs.
    pub fn residual_rms(&self, item: usize) -> f64 {
        self.table.get(RMS, item)
    }

    /// Steps of all starts.
    pub fn iterations(&self, item: usize) -> u32 {
        self.table.get(ITERATIONS, item) as u32
    }
}
