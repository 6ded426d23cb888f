//! Finer and finer, until the bound of the error is small.

mod methods;

pub use methods::ByGrid;
pub use methods::{ByHull, ByOctree, step_after};

use super::audit::LOOKS;
use super::{Audit, Bounds, Point, Region};

/// A way to find a region, ever finer.
pub trait RegionSearch {
    /// Finding of a search.
    type Found;
    /// Why it cannot.
    type Error;

    /// Searches with so many refinements.
    fn find(&mut self, refinement: u32) -> Result<Self::Found, Self::Error>;

    /// Points that it judges more of with each refinement, as a factor.
    fn growth(&self) -> f64;

    /// Whether memory allows so many refinements.
    fn allows(&self, refinement: u32) -> bool;

    /// Points judged for this, and its size (m², m³) where it has one.
    fn judged(&self, found: &Self::Found) -> (u64, Option<f64>);

    /// Which points count as those of the region.
    fn contains(&self, found: &Self::Found, points: &[Point], answers: &mut [bool]);
}

/// How small the bound of the error shall be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// Bound of the error divided by the size.
    pub fraction: f64,
    /// Poses that may be judged for it, in units of [`Criterion::effort`](super::Criterion::effort).
    pub effort: f64,
    /// False where a step or a number of rays was asked for: then nothing is refined.
    pub refines: bool,
}

/// Why it was refined no further.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The bound of the error is as small as wanted.
    Reached,
    /// The finding is as exact as was asked for.
    AsAsked,
    /// The finding has no size, and finer it has none either.
    NoSize,
    /// More would take more poses than the goal allows.
    Effort,
}

/// A finding, and how far it can be from the truth.
#[derive(Clone, Debug, PartialEq)]
pub struct Refined<T> {
    /// Finding of the search.
    pub found: T,
    /// Comparison of the finding with random points.
    pub audit: Audit,
    /// Why it was refined no further.
    pub stop: Stop,
}

/// Fewest and most points of the first audit.
const AUDIT: [f64; 2] = [4096.0, 4_194_304.0];
/// Fewest points where a pose takes so long that the work allowed is less than [`AUDIT`]'s: their bound is wide, and says so.
const SHORT_AUDIT: f64 = 256.0;
/// Share of a box that may be left open where nothing was found.
const EMPTY_SHARE: f64 = 1e-4;

impl Goal {
    /// A bound of 1 % within about a second.
    pub fn usual() -> Self {
        Self { fraction: 0.01, effort: 2e6, refines: true }
    }

    /// Poses of this region that may be judged.
    pub fn poses(&self, region: &Region<'_>) -> f64 {
        self.effort / (region.criterion().effort() * region.orientations().len() as f64)
    }
}

/// Finds a region as finely as the goal wants, and compares what was found with it at random points.
///
/// Where chance leaves too much open more points are drawn, else the search is refined.
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

/// As many as the search judged, or half as many where more than a quarter of the work allowed would go into them.
fn first_points(goal: &Goal, allowed: f64, judged: u64) -> f64 {
    let judged = judged as f64;
    let most = if goal.refines { (0.25 * allowed).max(0.5 * judged) } else { judged };
    judged.min(most).clamp(AUDIT[0].min(allowed.max(SHORT_AUDIT)), AUDIT[1])
}
