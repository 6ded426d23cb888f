//! Derivatives of the chosen tensions by structure matrix, load and reference, for every method.
//!
//! Most methods minimize Σ φᵢ(fᵢ) with Aᵀ f + w = 0, and cables on limits stay there (`optimum`). They differ in φ and
//! in the cables that are on a limit; each method states its own in its file (`Distribute::derivative`):
//!
//! * `qp`, `nearest-wrench` if the load can be balanced, `dykstra` and `improved-closed-form`: ½ (f − f_m)², the active
//!   limits of the answer; `closed-form` without limits; `minimum` ½ f², `maximum` ½ (f_max − f)², both with p = 2.
//! * `smooth` with p = 2: ½ ((f − f_m)/α)² − c log (f − f_min)(f_max − f), no limit is active.
//! * `barrier`: −log (f − f_min) − log (f_max − f), no limit is active.
//!
//! `puncture` follows both ends of its segment and the cable that stands at its limit there, `centroid` the moving
//! facets of the set of allowed tensions (`centroid`). A method without a derivative in closed form is solved again
//! beside the problem (`differences`).
//!
//! **Kinks.** All methods but `barrier`, `smooth` and `closed-form` have kinks, where a cable comes to a limit or
//! leaves it. Exactly there the derivative is that of one side.

pub(super) mod centroid;
mod differences;
pub(super) mod optimum;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use thiserror::Error;

use super::distribute::{Chosen, Derivative, NoDerivative, Problem};
use super::{InputError, Limits, Method};
use differences::Differences;
use optimum::Optimum;

/// The derivative of one answer of a method; see [`Response::of`].
#[derive(Clone, Debug)]
pub struct Response {
    derivative: Arc<dyn Derivative>,
}

/// Reason that the chosen tensions have no derivative.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum NotSmooth {
    /// The cables between their limits cannot balance a small change.
    #[error("so many tensions are on their limits that the others cannot follow a change")]
    Pinned,
    /// The set of allowed tensions is too thin for a derivative.
    #[error(
        "the tensions that balance the load within their limits form a set too thin for a derivative of the method {method}"
    )]
    Thin {
        /// The method.
        method: Method,
    },
    /// The method refuses the problem.
    #[error(transparent)]
    Input(#[from] InputError),
}

impl Response {
    /// The derivative at the tensions that a method has chosen for matrix, wrench and limits, with the reference in the
    /// middle of the limits.
    ///
    /// ```
    /// use cdpr::nalgebra::DMatrix;
    /// use cdpr::tension::{Limits, Method, Options, Response, solve};
    ///
    /// // two cables up, one down: half of a further newton of load is carried by each of the upper ones, and a third less by all
    /// let matrix = DMatrix::from_row_slice(1, 3, &[1.0, 1.0, -1.0]);
    /// let limits = Limits::uniform(3, 100.0, 1000.0)?;
    /// let found = solve(Method::Minimum, &matrix, &[-500.0], &limits, &Options::default())?;
    /// let response = Response::of(Method::Minimum, &matrix, &[-500.0], &limits, &found.tensions)?;
    /// // cable 3 stays on its least tension
    /// let change = response.change(0, &[0.0], &[-1.0]);
    /// assert!((change[0] - 0.5).abs() < 1e-9 && (change[1] - 0.5).abs() < 1e-9 && change[2] == 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(
        method: Method,
        structure_matrix: &DMatrix<f64>,
        wrench: &[f64],
        limits: &Limits,
        tensions: &[f64],
    ) -> Result<Self, NotSmooth> {
        let chosen = Chosen { problem: Problem { structure_matrix, wrench }, limits, tensions };
        let (dof, cable_count) = structure_matrix.shape();
        let written = match method.distributor(cable_count, dof).derivative(&chosen) {
            Ok(None) => Differences::of(method, &chosen).map(|found| Arc::new(found) as Arc<dyn Derivative>),
            Ok(Some(derivative)) => Ok(Arc::from(derivative)),
            Err(reason) => Err(reason),
        };
        let derivative = written.map_err(|reason| match reason {
            NoDerivative::Pinned => NotSmooth::Pinned,
            NoDerivative::Thin => NotSmooth::Thin { method },
            NoDerivative::Input(error) => NotSmooth::Input(error),
        })?;
        Ok(Self { derivative })
    }

    /// The derivative of the balanced tensions nearest to a reference (N), without regard to limits.
    pub fn of_nearest(structure_matrix: &DMatrix<f64>, tensions: &[f64], reference: &[f64]) -> Result<Self, NotSmooth> {
        let all = (0..tensions.len()).collect();
        let optimum = Optimum::nearest(structure_matrix, tensions, all, &|cable| reference[cable]);
        Ok(Self { derivative: Arc::new(optimum.ok_or(NotSmooth::Pinned)?) })
    }

    /// Change of all tensions (N) when one cable's column of the structure matrix and the wrench change by these
    /// amounts (one entry per row of the matrix).
    pub fn change(&self, cable: usize, column: &[f64], wrench: &[f64]) -> DVector<f64> {
        self.derivative.change(cable, column, wrench)
    }

    /// Change of all tensions (N) per newton of one cable's reference; zero for methods without a reference.
    pub fn change_by_reference(&self, cable: usize) -> DVector<f64> {
        self.derivative.change_by_reference(cable)
    }
}
