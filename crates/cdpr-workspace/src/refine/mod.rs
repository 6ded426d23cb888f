//! Refinement of a search until the bound of its error is small.

mod methods;

pub use methods::ByGrid;
pub use methods::{ByHull, ByOctree, step_after};

use super::audit::LOOKS;
use super::{Audit, Bounds, Point, Region};

/// A method that finds a region, at any refinement.
pub trait RegionSearch {
    /// Result of a search.
    type Found;
    /// Error of a search.
    type Error;

    /// Searches after `refinement` refinements.
    fn find(&mut self, refinement: u32) -> Result<Self::Found, Self::Error>;

    /// Factor by which the number of judged points grows with each refinement.
    fn growth(&self) -> f64;

    /// True if memory allows this refinement.
    fn allows(&self, refinement: u32) -> bool;

    /// Number of points judged for a result, and its size (m², m³) if it has one.
    fn judged(&self, found: &Self::Found) -> (u64, Option<f64>);

    /// Writes for each point whether the result counts it as part of the region.
    fn contains(&self, found: &Self::Found, points: &[Point], answers: &mut [bool]);
}

/// Goal of a refinement: the bound of the error and the work allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// Bound of the error divided by the size.
    pub fraction: f64,
    /// Poses that may be judged, in units of [`Criterion::effort`](super::Criterion::effort).
    pub effort: f64,
    /// False if the user gave a step or a number of rays: then nothing is refined.
    pub refines: bool,
}

/// Reason for which refinement ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The bound of the error has reached the goal.
    Reached,
    /// The user gave the accuracy.
    AsAsked,
    /// The result has no size, and no refinement would give it one.
    NoSize,
    /// A further step would take more poses than the goal allows.
    Effort,
}

/// Result of a search, with the audit that bounds its error.
#[derive(Clone, Debug, PartialEq)]
pub struct Refined<T> {
    /// Result of the search.
    pub found: T,
    /// Comparison of the result with random points.
    pub audit: Audit,
    /// Reason for which refinement ended.
    pub stop: Stop,
}

/// Fewest and most points of the first audit.
const AUDIT: [f64; 2] = [4096.0, 4_194_304.0];
/// Fewest points of an audit if a pose takes so long that less work than [`AUDIT`]'s is allowed: the bound is then
/// wide.
const SHORT_AUDIT: f64 = 256.0;
/// Fraction of a box that may be left undecided if nothing was found.
const EMPTY_SHARE: f64 = 1e-4;

impl Goal {
    /// A bound of 1 % within about a second.
    pub fn usual() -> Self {
        Self { fraction: 0.01, effort: 2e6, refines: true }
    }

    /// Number of poses of this region that may be judged.
    pub fn poses(&self, region: &Region<'_>) -> f64 {
        self.effort / (region.criterion().effort() * region.orientations().len() as f64)
    }
}

/// Finds a region as accurately as the goal asks, and compares the result with the region at random points.
///
/// Draws more points if chance dominates the bound, else refines the search.
pub fn refine<S: RegionSearch>(
    region: &Region<'_>,
    bounds: &Bounds,
    goal: &Goal,
    search: &mut S,
) -> Result<Refined<S::Found>, S::Error> {
    let allowed = goal.poses(region);
    let mut found = search.find(0)?;
    let (mut judged, mut size) = search.judged(&found);
    let mut points = first_points(goal, allowed, judged);
    let (mut refinement, mut look, mut spent) = (0, 0, judged as f64);
    loop {
        look += 1;
        let contains = &mut |points: &[Point], answers: &mut [bool]| search.contains(&found, points, answers);
        let audit = Audit::of(region, bounds, [points as u64, look], contains);
        spent += points;
        let Some(least) = size else { return Ok(Refined { found, audit, stop: Stop::NoSize }) };
        let is_empty = least == 0.0 && audit.missed == 0;
        let wanted = if is_empty { EMPTY_SHARE * bounds.size() } else { goal.fraction * least };
        let costs = [4.0 * points, judged as f64 * search.growth() + points];
        let [has_points, has_refinement] = costs.map(|cost| spent + cost <= allowed && look < LOOKS);
        if !goal.refines {
            return Ok(Refined { found, audit, stop: Stop::AsAsked });
        } else if audit.error_bound() <= wanted {
            return Ok(Refined { found, audit, stop: Stop::Reached });
        } else if has_points && audit.uncertainty() > 0.5 * wanted {
            points *= 4.0;
        } else if has_refinement && search.allows(refinement + 1) {
            refinement += 1;
            found = search.find(refinement)?;
            (judged, size) = search.judged(&found);
            spent += judged as f64;
        } else {
            return Ok(Refined { found, audit, stop: Stop::Effort });
        }
    }
}

/// As many points as the search judged, or half as many if they would take more than a quarter of the work allowed.
fn first_points(goal: &Goal, allowed: f64, judged: u64) -> f64 {
    let judged = judged as f64;
    let most = if goal.refines { (0.25 * allowed).max(0.5 * judged) } else { judged };
    judged.min(most).clamp(AUDIT[0].min(allowed.max(SHORT_AUDIT)), AUDIT[1])
}
