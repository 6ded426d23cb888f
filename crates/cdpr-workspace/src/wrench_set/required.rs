//! The wrenches that a task requires.

use super::facets::Rows;

/// A convex set of external wrenches, in the rows of the structure matrix (N, N·m).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum RequiredSet {
    /// One wrench.
    Single(Vec<f64>),
    /// All wrenches that differ from the middle by at most the half extent in each row.
    Box {
        /// Middle of the box.
        center: Vec<f64>,
        /// Largest difference per row, 0 or more.
        half_extent: Vec<f64>,
    },
    /// An ellipsoid with its axes along the rows: Σ ((w − center)/radius)² ≤ 1. A ball of forces and moments has the
    /// radius r in the rows of forces and r times a length in those of moments.
    Ball {
        /// Middle of the ellipsoid.
        center: Vec<f64>,
        /// Radius per row, 0 or more.
        radius: Vec<f64>,
    },
    /// The convex hull of points.
    Polytope(Vec<Vec<f64>>),
    /// The convex hull of parallelotopes, such as the wrenches of a range of masses in a box of accelerations.
    Parallelotopes(Vec<Parallelotope>),
}

/// The points center + Σ sₖ edgeₖ with all |sₖ| ≤ 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Parallelotope {
    /// Middle of the parallelotope.
    pub center: Vec<f64>,
    /// Half edges of the parallelotope.
    pub edges: Vec<Vec<f64>>,
}

impl RequiredSet {
    /// True if each part has one number per row, all finite, with no negative extent, and there is at least one point.
    pub(crate) fn fits(&self, rows: usize) -> bool {
        let finite = |list: &[f64]| list.len() == rows && list.iter().all(|number| number.is_finite());
        let extent = |list: &[f64]| finite(list) && list.iter().all(|&number| number >= 0.0);
        match self {
            Self::Single(wrench) => finite(wrench),
            Self::Box { center, half_extent: reach } | Self::Ball { center, radius: reach } => {
                finite(center) && extent(reach)
            }
            Self::Polytope(points) => !points.is_empty() && points.iter().all(|point| finite(point)),
            Self::Parallelotopes(parts) => {
                let fits = |part: &Parallelotope| finite(&part.center) && part.edges.iter().all(|edge| finite(edge));
                !parts.is_empty() && parts.iter().all(fits)
            }
        }
    }

    /// The set translated by a wrench.
    #[must_use]
    pub(crate) fn shifted(&self, by: &[f64]) -> Self {
        let sum = |list: &Vec<f64>| list.iter().zip(by).map(|(a, b)| a + b).collect::<Vec<f64>>();
        match self {
            Self::Single(wrench) => Self::Single(sum(wrench)),
            Self::Box { center, half_extent } => Self::Box { center: sum(center), half_extent: half_extent.clone() },
            Self::Ball { center, radius } => Self::Ball { center: sum(center), radius: radius.clone() },
            Self::Polytope(points) => Self::Polytope(points.iter().map(sum).collect()),
            Self::Parallelotopes(parts) => Self::Parallelotopes(
                parts
                    .iter()
                    .map(|part| Parallelotope { center: sum(&part.center), edges: part.edges.clone() })
                    .collect(),
            ),
        }
    }

    /// max normal · w over the set: its support along a direction.
    pub(crate) fn support(&self, normal: &[f64]) -> f64 {
        let along = |list: &[f64]| list.iter().zip(normal).map(|(a, b)| a * b).sum::<f64>();
        match self {
            Self::Single(wrench) => along(wrench),
            Self::Box { center, half_extent } => {
                along(center) + half_extent.iter().zip(normal).map(|(h, n)| h * n.abs()).sum::<f64>()
            }
            Self::Ball { center, radius } => {
                along(center) + radius.iter().zip(normal).map(|(r, n)| (r * n).powi(2)).sum::<f64>().sqrt()
            }
            Self::Polytope(points) => points.iter().map(|point| along(point)).fold(f64::NEG_INFINITY, f64::max),
            Self::Parallelotopes(parts) => {
                parts.iter().map(|part| part.support(normal)).fold(f64::NEG_INFINITY, f64::max)
            }
        }
    }

    /// A wrench of the set that is furthest along a direction.
    pub(crate) fn furthest(&self, normal: &[f64]) -> Vec<f64> {
        let along = |list: &[f64]| list.iter().zip(normal).map(|(a, b)| a * b).sum::<f64>();
        match self {
            Self::Single(wrench) => wrench.clone(),
            Self::Box { center, half_extent } => {
                let corner = |row: usize| center[row] + half_extent[row].copysign(normal[row]);
                (0..center.len()).map(corner).collect()
            }
            Self::Ball { center, radius } => {
                let length = self.support(normal) - along(center);
                let reach = |row: usize| radius[row].powi(2) * normal[row] / length;
                (0..center.len()).map(|row| center[row] + if length > 0.0 { reach(row) } else { 0.0 }).collect()
            }
            Self::Polytope(points) => {
                points.iter().max_by(|a, b| along(a).total_cmp(&along(b))).cloned().unwrap_or_default()
            }
            Self::Parallelotopes(parts) => {
                let furthest = parts.iter().max_by(|a, b| a.support(normal).total_cmp(&b.support(normal)));
                furthest.map(|part| part.furthest(normal)).unwrap_or_default()
            }
        }
    }
}

impl Parallelotope {
    fn support(&self, normal: &[f64]) -> f64 {
        let along = |list: &[f64]| list.iter().zip(normal).map(|(a, b)| a * b).sum::<f64>();
        along(&self.center) + self.edges.iter().map(|edge| along(edge).abs()).sum::<f64>()
    }

    fn furthest(&self, normal: &[f64]) -> Vec<f64> {
        let mut point = self.center.clone();
        for edge in &self.edges {
            let fraction: f64 = edge.iter().zip(normal).map(|(a, b)| a * b).sum();
            let sign = if fraction < 0.0 { -1.0 } else { 1.0 };
            point.iter_mut().zip(edge).for_each(|(sum, row)| *sum += sign * row);
        }
        point
    }
}

/// A wrench with its rows divided by their lengths.
pub(super) fn scaled(wrench: &[f64], row_lengths: &[f64]) -> Rows {
    let mut rows = [0.0; 6];
    for ((row, value), length) in rows.iter_mut().zip(wrench).zip(row_lengths) {
        *row = value / length;
    }
    rows
}
