//! Distance of a required set from the boundary of the available one, and the cables that limit it.

use super::facets::{Rows, dot, norm};
use super::required::{RequiredSet, scaled};
use super::zonotope::{Facet, Zonotope};

/// Fraction of the set's size that is rounding.
const ROUNDING: f64 = 1e-11;

/// One facet of the available wrench set: normal · w ≤ offset.
#[derive(Clone, Debug, PartialEq)]
pub struct HalfSpace {
    /// Outward normal in the rows of the structure matrix. With the rows of moments times their length scale it has
    /// length 1, so that offset − normal · w is a distance in newtons.
    pub normal: Vec<f64>,
    /// Offset (N).
    pub offset: f64,
    /// Cables (from 0) at their largest tension everywhere on the facet.
    pub at_largest: Vec<usize>,
    /// Cables (from 0) at their least tension everywhere on the facet.
    pub at_least: Vec<usize>,
}

/// A facet: normal · w ≤ offset, rows of moments divided by their lengths.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FacetView {
    /// Unit normal, outwards.
    pub(crate) normal: Rows,
    /// Offset (N).
    pub(crate) offset: f64,
    /// Bit i: cable i is at its largest tension everywhere on it.
    pub(crate) at_largest: u64,
    /// Bit i: cable i is at its least tension everywhere on it.
    pub(crate) at_least: u64,
}

/// The capacity margin of a required set.
#[derive(Clone, Debug, PartialEq)]
pub struct Margin {
    /// Distance from the set to the nearest facet (N), negative if it sticks out. From the inside it is the radius of
    /// the largest ball that can be added to every wrench of the set; from the outside it is minus the excess over the
    /// worst facet, which is at most the distance to the available set.
    pub distance: f64,
    /// The wrench of the required set nearest to that facet, or furthest beyond it (N, N·m).
    pub wrench: Vec<f64>,
    /// Half-space of that facet.
    pub half_space: HalfSpace,
    /// The cable (from 0) with the largest range along the facet's normal: the first to change for more margin. `None`
    /// if no cable acts along it.
    pub cable: Option<usize>,
}

impl Zonotope {
    /// All half-spaces, whose intersection is the set.
    pub fn half_spaces(&self) -> Vec<HalfSpace> {
        self.facets.iter().map(|facet| self.half_space(facet)).collect()
    }

    /// All facets, by bits of their cables.
    pub(crate) fn facets(&self) -> impl Iterator<Item = FacetView> + '_ {
        let bits = |generators: u64| {
            let cables = self.cables.iter().enumerate();
            cables.filter(|(index, _)| generators & (1 << index) != 0).map(|(_, &cable)| 1_u64 << cable).sum()
        };
        let all = (1_u64 << self.generators.len()) - 1;
        self.facets.iter().map(move |facet| FacetView {
            normal: facet.normal,
            offset: facet.offset,
            at_largest: bits(facet.plus & !facet.free),
            at_least: bits(all & !facet.plus & !facet.free),
        })
    }

    fn half_space(&self, facet: &Facet) -> HalfSpace {
        let cables = |plus: bool| {
            let stands = |index: &usize| facet.free & (1 << index) == 0 && (facet.plus & (1 << index) != 0) == plus;
            (0..self.generators.len()).filter(stands).map(|index| self.cables[index]).collect()
        };
        HalfSpace {
            normal: self.outward(&facet.normal),
            offset: facet.offset,
            at_largest: cables(true),
            at_least: cables(false),
        }
    }

    /// A normal for rows in N and N·m, from one for rows in newtons.
    fn outward(&self, normal: &Rows) -> Vec<f64> {
        self.row_lengths.iter().zip(normal).map(|(length, row)| row / length).collect()
    }

    /// Rounding of distances in this set (N).
    pub(crate) fn tolerance(&self) -> f64 {
        ROUNDING * (norm(&self.center) + self.generators.iter().map(norm).sum::<f64>())
    }

    /// True if tensions within limits balance this wrench (N, N·m), to rounding.
    ///
    /// False for a wrench whose length differs from the number of rows, or with a number that is not finite.
    pub fn contains(&self, wrench: &[f64]) -> bool {
        if wrench.len() != self.row_lengths.len() || !wrench.iter().all(|row| row.is_finite()) {
            return false;
        }
        let (w, tolerance) = (scaled(wrench, &self.row_lengths), self.tolerance());
        self.facets.iter().all(|facet| dot(&facet.normal, &w) <= facet.offset + tolerance)
    }

    /// True if every wrench of the required set is available, to rounding.
    pub(crate) fn contains_set(&self, required: &RequiredSet) -> bool {
        self.distance(required) >= 0.0
    }

    /// [`Margin::distance`] alone (N); −∞ for a required set that does not fit.
    pub(crate) fn distance(&self, required: &RequiredSet) -> f64 {
        self.nearest(required).map_or(f64::NEG_INFINITY, |(distance, _)| distance)
    }

    /// The capacity margin of a required set; `None` for one that does not fit the rows (see `RequiredSet::fits`).
    pub fn margin(&self, required: &RequiredSet) -> Option<Margin> {
        let (distance, facet) = self.nearest(required)?;
        let half_space = self.half_space(&facet);
        let fraction = |index: &usize| dot(&facet.normal, &self.generators[*index]).abs();
        let strongest = (0..self.generators.len()).max_by(|a, b| fraction(a).total_cmp(&fraction(b)));
        let cable = strongest.filter(|index| fraction(index) > self.tolerance()).map(|index| self.cables[index]);
        Some(Margin { distance, wrench: required.furthest(&half_space.normal), half_space, cable })
    }

    /// Distance and facet of the least margin. Distances within rounding count as zero, so that a set without thickness
    /// contains its own wrenches.
    fn nearest(&self, required: &RequiredSet) -> Option<(f64, Facet)> {
        let rows = self.row_lengths.len();
        if !required.fits(rows) {
            return None;
        }
        let mut nearest: Option<(f64, Facet)> = None;
        for facet in &self.facets {
            let left = match required {
                RequiredSet::Single(wrench) => facet.offset - dot(&facet.normal, &scaled(wrench, &self.row_lengths)),
                _ => {
                    let mut normal = facet.normal;
                    normal.iter_mut().zip(&self.row_lengths).for_each(|(row, length)| *row /= length);
                    facet.offset - required.support(&normal[..rows])
                }
            };
            if nearest.as_ref().is_none_or(|(least, _)| left < *least) {
                nearest = Some((left, *facet));
            }
        }
        let (distance, facet) = nearest?;
        Some((if distance.abs() <= self.tolerance() { 0.0 } else { distance }, facet))
    }
}
