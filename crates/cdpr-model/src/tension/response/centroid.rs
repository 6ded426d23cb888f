//! The derivative of the centroid of all allowed tensions.
//!
//! In coordinates λ around the centroid c the balanced tensions are f = c + H λ. A change of matrix and load moves them
//! by δ(λ) = −A⁺ᵀ (dAᵀ f + dw) at fixed λ, which is affine: the centroid moves along with δ(0). Within these
//! coordinates the facets of the limits move outwards with the speed ∓δᵢ/‖Hᵢ‖, and V dc = Σ ∫ λ · speed over all
//! facets: moments of facets up to the second, by the same recursion as the volume (Lasserre 1983).

use nalgebra::{DMatrix, DVector};

use crate::tension::distribute::Derivative;
use crate::tension::{Limits, null_space};

/// Distances below this, relative to the size of the whole set, are rounding.
const ROUNDING: f64 = 1e-12;
/// Normals that differ by less than this angle are parallel.
const PARALLEL: f64 = 1e-9;

/// The centroid with the moments of its facets.
#[derive(Clone, Debug)]
pub(in crate::tension) struct Centroid {
    tensions: Vec<f64>,
    /// H.
    basis: DMatrix<f64>,
    /// A⁺ᵀ: the minimum-norm tensions for a wrench, without those of cables that have no range.
    minimum_norm: DMatrix<f64>,
    facets: Vec<Facet>,
    /// Volume of the set, in powers of `unit`.
    volume: f64,
    /// Unit of λ (N).
    unit: f64,
}

/// Facet of the allowed set on which a cable is at a limit.
#[derive(Clone, Debug)]
struct Facet {
    cable: usize,
    /// 1 at the largest tension, −1 at the least.
    side: f64,
    moments: Moments,
}

/// Integrals of 1, λ and λλᵀ over a set.
#[derive(Clone, Debug)]
struct Moments {
    volume: f64,
    first: DVector<f64>,
    second: DMatrix<f64>,
}

/// a·λ ≤ b with ‖a‖ = 1.
#[derive(Clone, Debug)]
struct HalfSpace {
    normal: DVector<f64>,
    offset: f64,
}

impl Centroid {
    /// Computes the moments; `None` if the set has no volume.
    pub(in crate::tension) fn of(matrix: &DMatrix<f64>, limits: &Limits, tensions: &[f64]) -> Option<Self> {
        let is_fixed = |cable: &usize| limits.maximum()[*cable] - limits.minimum()[*cable] <= limits.tolerance();
        let fixed: Vec<usize> = (0..tensions.len()).filter(is_fixed).collect();
        let (n, m) = matrix.shape();
        let mut kept = matrix.clone().insert_rows(n, fixed.len(), 0.0);
        fixed.iter().enumerate().for_each(|(row, &cable)| kept[(n + row, cable)] = 1.0);
        let basis = null_space(&kept).ok()?;
        let minimum_norm = kept.pseudo_inverse(ROUNDING).ok()?.columns(0, n).into_owned();
        let unit = limits.diameter();
        let dimension = basis.ncols();
        let (mut half_spaces, mut places) = (Vec::new(), Vec::new());
        for cable in (0..m).filter(|cable| dimension > 0 && basis.row(*cable).norm() > PARALLEL) {
            let row = basis.row(cable).transpose();
            let ends =
                [(1.0, limits.maximum()[cable] - tensions[cable]), (-1.0, tensions[cable] - limits.minimum()[cable])];
            for (side, distance) in ends {
                half_spaces
                    .push(HalfSpace { normal: &row * (side / row.norm()), offset: distance / unit / row.norm() });
                places.push((cable, side));
            }
        }
        let mut facets = Vec::new();
        let mut volume = if dimension == 0 { 1.0 } else { 0.0 };
        for (index, (cable, side)) in places.into_iter().enumerate() {
            let Some(moments) = facet(&half_spaces, index) else { continue };
            volume += half_spaces[index].offset * moments.volume / dimension as f64;
            facets.push(Facet { cable, side, moments });
        }
        // the centroid of a set of almost no volume consists of rounding errors
        let is_thick = volume > ROUNDING;
        is_thick.then(|| Self { tensions: tensions.to_vec(), basis, minimum_norm, facets, volume, unit })
    }
}

impl Derivative for Centroid {
    fn change(&self, cable: usize, column: &[f64], wrench: &[f64]) -> DVector<f64> {
        let [by_tension, by_wrench] =
            [column, wrench].map(|change| -(&self.minimum_norm * DVector::from_column_slice(change)));
        // δ(λ) = away + slope (H_k · λ)
        let away = &by_tension * self.tensions[cable] + by_wrench;
        let slope = by_tension * self.unit;
        let along = self.basis.row(cable).transpose();
        let mut moved = DVector::zeros(self.basis.ncols());
        for Facet { cable, side, moments } in &self.facets {
            let speed = &moments.first * away[*cable] + &moments.second * &along * slope[*cable];
            moved -= speed * (side / self.basis.row(*cable).norm());
        }
        away + &self.basis * moved / self.volume
    }

    fn change_by_reference(&self, _cable: usize) -> DVector<f64> {
        DVector::zeros(self.tensions.len())
    }
}

/// Moments of the polytope that half-spaces enclose.
fn moments(half_spaces: &[HalfSpace], dimension: usize) -> Moments {
    let mut sum = Moments::zero(dimension);
    for index in 0..half_spaces.len() {
        // the integral of a homogeneous function of degree k, as a sum over cones from the origin
        if let Some(part) = facet(half_spaces, index) {
            let (offset, d) = (half_spaces[index].offset, dimension as f64);
            sum.volume += part.volume * offset / d;
            sum.first += part.first * (offset / (d + 1.0));
            sum.second += part.second * (offset / (d + 2.0));
        }
    }
    sum
}

/// Moments of the facet on one of the planes, in the coordinates of the polytope; `None` if it is empty, or the same as
/// an earlier one.
fn facet(half_spaces: &[HalfSpace], index: usize) -> Option<Moments> {
    let HalfSpace { normal, offset } = &half_spaces[index];
    let dimension = normal.len();
    let frame = beside(normal);
    let mut below = Vec::new();
    for (other, half_space) in half_spaces.iter().enumerate().filter(|(other, _)| *other != index) {
        let cos = half_space.normal.dot(normal);
        let remainder = half_space.offset - cos * offset;
        let row = frame.transpose() * &half_space.normal;
        let length = row.norm();
        if length < PARALLEL {
            let is_same = cos > 0.0 && remainder.abs() <= ROUNDING;
            if remainder < -ROUNDING || (is_same && other < index) {
                return None;
            }
        } else {
            below.push(HalfSpace { normal: row / length, offset: remainder / length });
        }
    }
    let foot = normal * *offset;
    if dimension == 1 {
        return Some(Moments { volume: 1.0, second: &foot * foot.transpose(), first: foot });
    }
    let own = moments(&below, dimension - 1);
    if !(own.volume > 0.0) {
        return None;
    }
    let first = &frame * own.first;
    let mixed = &foot * first.transpose();
    Some(Moments {
        volume: own.volume,
        second: &foot * foot.transpose() * own.volume
            + &mixed
            + mixed.transpose()
            + &frame * own.second * frame.transpose(),
        first: foot * own.volume + first,
    })
}

/// Orthonormal columns at right angles to a normal, by a reflection that takes the last axis to it.
fn beside(normal: &DVector<f64>) -> DMatrix<f64> {
    let dimension = normal.len();
    let head = normal[dimension - 1];
    let mut reflector = normal.clone();
    reflector[dimension - 1] += 1.0_f64.copysign(head);
    let reflection = DMatrix::identity(dimension, dimension) - &reflector * reflector.transpose() / (1.0 + head.abs());
    reflection.columns(0, dimension - 1).into_owned()
}

impl Moments {
    fn zero(dimension: usize) -> Self {
        Self { volume: 0.0, first: DVector::zeros(dimension), second: DMatrix::zeros(dimension, dimension) }
    }
}
