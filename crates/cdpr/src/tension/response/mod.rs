//! How chosen tensions follow structure matrix and load: the derivatives of every method.
//!
//! Most methods take an optimum: min Σ φᵢ(fᵢ) with Aᵀ f + w = 0 and cables on limits that stay there (`optimum`). What differs is φ,
//! and which cables are on a limit:
//!
//! * `qp`, `nearest-wrench` where the load can be balanced, `dykstra` and `improved-closed-form`: ½ (f − f_m)², the active limits of the
//!   answer; `closed-form` without limits; `minimum` ½ f², `maximum` ½ (f_max − f)², both with p = 2.
//! * `barrier`: −log (f − f_min) − log (f_max − f), no limit is active.
//!
//! `puncture` follows both ends of its way and the cable that stands at its limit there, `centroid` the moving facets of the set of
//! allowed tensions (`centroid`).
//!
//! **Where there is none.** All methods but `barrier` and `closed-form` have kinks, where a cable comes to a limit or leaves it.
//! Exactly there the derivative is that of one side.

mod centroid;
mod optimum;
#[cfg(test)]
mod tests;

use nalgebra::{DMatrix, DVector};
use thiserror::Error;

use super::affine::add_scaled;
use super::{InputError, Limits, Method, Options, Reference, solve};
use centroid::Centroid;
use optimum::Optimum;

/// Tensions this near to a limit, relative to the largest limit, are on it.
const ON_LIMIT: f64 = 1e-9;
/// Those of `dykstra`, which end ten times as far from it.
const ON_LIMIT_OF_PROJECTIONS: f64 = 1e-8;

/// The derivative of one answer of a method; see [`Response::of`].
#[derive(Clone, Debug)]
pub struct Response {
    rule: Rule,
}

#[derive(Clone, Debug)]
enum Rule {
    Optimum(Optimum),
    Puncture(Box<Puncture>),
    Centroid(Box<Centroid>),
}

/// Tensions that no derivative leads away from.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum NotSmooth {
    /// The cables between their limits cannot balance a small change.
    #[error("so many tensions are on their limits that the others cannot follow a change")]
    Pinned,
    /// The allowed tensions leave the method nothing to choose.
    #[error(
        "the tensions that balance the load within their limits form a set too thin for a derivative of the method {method}"
    )]
    Thin {
        /// The method.
        method: Method,
    },
    /// A problem that the method refuses.
    #[error(transparent)]
    Input(#[from] InputError),
}

impl Response {
    /// The derivative at the tensions that a method has found for matrix, wrench and limits, the reference in the middle of the
    /// limits.
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
        let middle = |cable: usize| limits.middle(cable);
        let free = |share: f64| between(limits, tensions, share);
        let nearest = |free: Vec<usize>, reference: &dyn Fn(usize) -> f64| {
            Optimum::nearest(structure_matrix, tensions, free, reference).ok_or(NotSmooth::Pinned)
        };
        let optimum = match method {
            Method::Qp | Method::NearestWrench | Method::ImprovedClosedForm => nearest(free(ON_LIMIT), &middle)?,
            Method::Dykstra => nearest(free(ON_LIMIT_OF_PROJECTIONS), &middle)?,
            Method::Minimum => nearest(free(ON_LIMIT), &|_| 0.0)?,
            Method::Maximum => nearest(free(ON_LIMIT), &|cable| limits.maximum()[cable])?,
            Method::ClosedForm => nearest((0..tensions.len()).collect(), &middle)?,
            Method::Barrier => {
                Optimum::barrier(structure_matrix, tensions, limits).ok_or(NotSmooth::Thin { method })?
            }
            Method::Puncture => {
                let rule = Rule::Puncture(Box::new(Puncture::of(structure_matrix, wrench, limits)?));
                return Ok(Self { rule });
            }
            Method::Centroid => {
                let found = Centroid::of(structure_matrix, limits, tensions).ok_or(NotSmooth::Thin { method })?;
                return Ok(Self { rule: Rule::Centroid(Box::new(found)) });
            }
        };
        Ok(Self { rule: Rule::Optimum(optimum) })
    }

    /// The derivative of the balanced tensions nearest to a reference (N), whatever the limits.
    pub(crate) fn of_nearest(
        structure_matrix: &DMatrix<f64>,
        tensions: &[f64],
        reference: &[f64],
    ) -> Result<Self, NotSmooth> {
        let all = (0..tensions.len()).collect();
        let optimum = Optimum::nearest(structure_matrix, tensions, all, &|cable| reference[cable]);
        Ok(Self { rule: Rule::Optimum(optimum.ok_or(NotSmooth::Pinned)?) })
    }

    /// Change of all tensions (N) when the column of one cable in the structure matrix and the wrench change so (rows of the matrix).
    pub fn change(&self, cable: usize, column: &[f64], wrench: &[f64]) -> DVector<f64> {
        match &self.rule {
            Rule::Optimum(optimum) => optimum.change(cable, column, wrench),
            Rule::Puncture(puncture) => puncture.change(cable, column, wrench),
            Rule::Centroid(centroid) => centroid.change(cable, column, wrench),
        }
    }

    /// Change of all tensions (N) per newton of one cable's reference; zero for methods that are near to none.
    pub(crate) fn change_by_reference(&self, cable: usize) -> DVector<f64> {
        match &self.rule {
            Rule::Optimum(optimum) => optimum.change_by_slope(cable),
            // the way from the minimum-norm tensions and the centroid keep no reference that could be moved cable by cable
            Rule::Puncture(puncture) => DVector::zeros(puncture.way.len()),
            Rule::Centroid(centroid) => DVector::zeros(centroid.cable_count()),
        }
    }
}

/// Cables that are on no limit.
fn between(limits: &Limits, tensions: &[f64], share: f64) -> Vec<usize> {
    let largest = limits.minimum().iter().chain(limits.maximum()).fold(0.0, |most: f64, limit| most.max(limit.abs()));
    let is_free = |cable: &usize| {
        let to = |limit: &[f64]| (tensions[*cable] - limit[*cable]).abs();
        to(limits.minimum()).min(to(limits.maximum())) > share * largest
    };
    (0..tensions.len()).filter(is_free).collect()
}

/// The first point within the limits on the way from the minimum-norm tensions to the improved closed form.
#[derive(Clone, Debug)]
struct Puncture {
    /// Of the minimum-norm tensions, and of the improved closed form.
    ends: [Optimum; 2],
    /// From the minimum-norm tensions to the improved closed form (N).
    way: Vec<f64>,
    /// Part of the way that is gone, and the cable that is on its limit there; nothing where the minimum-norm tensions keep the limits.
    at: Option<(f64, usize)>,
}

impl Puncture {
    fn of(matrix: &DMatrix<f64>, wrench: &[f64], limits: &Limits) -> Result<Self, NotSmooth> {
        let zeros = vec![0.0; matrix.ncols()];
        let to_zero = Options { reference: Reference::Given(&zeros), ..Options::default() };
        let minimum_norm = solve(Method::ClosedForm, matrix, wrench, limits, &to_zero)?.tensions;
        let inner = solve(Method::ImprovedClosedForm, matrix, wrench, limits, &Options::default())?.tensions;
        let way: Vec<f64> = inner.iter().zip(&minimum_norm).map(|(inner, outer)| inner - outer).collect();
        let mut at = None;
        for (cable, (outer, way)) in minimum_norm.iter().zip(&way).enumerate() {
            let limit = outer.clamp(limits.minimum()[cable], limits.maximum()[cable]);
            let part = (limit - outer) / way;
            if limit != *outer && *way != 0.0 && at.is_none_or(|(most, _)| part > most) {
                at = Some((part, cable));
            }
        }
        let all = (0..zeros.len()).collect();
        let of_shortest = Optimum::nearest(matrix, &minimum_norm, all, &|_| 0.0);
        let free = between(limits, &inner, ON_LIMIT);
        let of_inner = Optimum::nearest(matrix, &inner, free, &|cable| limits.middle(cable));
        let ends = [of_shortest.ok_or(NotSmooth::Pinned)?, of_inner.ok_or(NotSmooth::Pinned)?];
        Ok(Self { ends, way, at })
    }

    fn change(&self, cable: usize, column: &[f64], wrench: &[f64]) -> DVector<f64> {
        let [outer, inner] = self.ends.each_ref().map(|end| end.change(cable, column, wrench));
        let Some((part, blocking)) = self.at else { return outer };
        let mut change = outer * (1.0 - part) + inner * part;
        // the cable on its limit stays there
        let further = -change[blocking] / self.way[blocking];
        add_scaled(change.as_mut_slice(), further, &self.way);
        change
    }
}
