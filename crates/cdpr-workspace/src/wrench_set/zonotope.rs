//! The available wrench set of a pose.

use nalgebra::DMatrix;
use thiserror::Error;

use super::facets::{Rows, dot, hyperplanes, moved, norm, remainder};
use cdpr_model::model::Model;
use cdpr_model::tension::Limits;

/// Most cables of a set: facets grow with the fifth power of their number, and 24 cables take a tenth of a second per
/// pose.
pub const CABLE_LIMIT: usize = 24;

/// A generator this small relative to the largest adds only rounding to the dimension of the set.
const LOST: f64 = 1e-10;

/// The available wrench set {−Aᵀ f | f_min ≤ f ≤ f_max} by its generators and facets.
///
/// Rows are those of the structure matrix. Inside, each row is divided by its length (see `row_lengths`), so that all
/// are forces and distances are in newtons.
#[derive(Clone, Debug)]
pub struct Zonotope {
    /// −Aᵀ ½(f_min + f_max), rows divided by their lengths (N).
    pub(super) center: Rows,
    /// −½ (f_max − f_min) times a column of Aᵀ, rows divided by their lengths (N): one for each cable that has a range.
    pub(super) generators: Vec<Rows>,
    /// The cable (from 0) of each generator.
    pub(super) cables: Vec<usize>,
    /// Orthonormal rows of the space that the generators span, then those of its complement.
    pub(super) axes: Vec<Rows>,
    /// Dimension of the set.
    pub(super) dimension: usize,
    pub(super) facets: Vec<Facet>,
    pub(super) row_lengths: Vec<f64>,
    pub(super) limits: Limits,
}

/// normal · w ≤ offset for all available wrenches, met by some.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    /// Unit normal, outwards.
    pub(super) normal: Rows,
    /// Offset (N).
    pub(super) offset: f64,
    /// Bit i: generator i has sign + on this facet.
    pub(super) plus: u64,
    /// Bit i: generator i lies in the facet and may have any value.
    pub(super) free: u64,
}

/// Input that has no wrench set.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum WrenchSetError {
    /// More cables than [`CABLE_LIMIT`].
    #[error("{found} cables; wrench sets are made for at most {CABLE_LIMIT}")]
    TooManyCables {
        /// Number of cables.
        found: usize,
    },
    /// A structure matrix without rows or with more than six.
    #[error("a wrench has 1 to 6 components, the structure matrix has {found} rows")]
    Rows {
        /// Number of rows.
        found: usize,
    },
    /// Counts that do not match.
    #[error("expected {expected} {what}, found {found}")]
    Count {
        /// Quantity counted, in words.
        what: &'static str,
        /// Expected count.
        expected: usize,
        /// Count found.
        found: usize,
    },
    /// NaN, infinite, or a length that is not above zero.
    #[error("the {what} is {value}; {rule}")]
    Number {
        /// Name of the number.
        what: &'static str,
        /// Value given.
        value: f64,
        /// Rule that it breaks, in words.
        rule: &'static str,
    },
}

/// Most hyperplanes through n − 1 of m generators: C(m, n − 1), with which the work for a set grows.
pub(crate) fn most_hyperplanes(cables: usize, dimension: usize) -> f64 {
    (1..dimension.min(cables + 1)).map(|k| (cables + 1 - k) as f64 / k as f64).product()
}

/// Divisor of each row of a model's structure matrix that turns all rows into forces: 1 for forces, the length scale
/// (m) for moments.
pub fn row_lengths(model: &Model, length_scale: f64) -> Vec<f64> {
    let translations = model.robot().motion_pattern.translations();
    (0..model.dof()).map(|row| if row < translations { 1.0 } else { length_scale }).collect()
}

impl Zonotope {
    /// The wrenches (rows of the structure matrix, N and N·m) that tensions within limits balance, −Aᵀ f.
    ///
    /// `row_lengths` are the lengths by which moments are divided before they are compared with forces, see
    /// [`row_lengths`](row_lengths()). Any rank and any number of cables up to [`CABLE_LIMIT`] is allowed: fewer cables
    /// than rows, or cables without a range of tensions, make a flat set.
    pub fn available(
        structure_matrix: &DMatrix<f64>,
        limits: &Limits,
        row_lengths: &[f64],
    ) -> Result<Self, WrenchSetError> {
        check(structure_matrix, limits, row_lengths)?;
        let column = |cable: usize, tension: f64| {
            let mut rows = [0.0; 6];
            for (row, length) in row_lengths.iter().enumerate() {
                rows[row] = -tension * structure_matrix[(row, cable)] / length;
            }
            rows
        };
        let mut set = Self {
            center: [0.0; 6],
            generators: Vec::new(),
            cables: Vec::new(),
            axes: Vec::new(),
            dimension: 0,
            facets: Vec::new(),
            row_lengths: row_lengths.to_vec(),
            limits: limits.clone(),
        };
        for cable in 0..limits.cable_count() {
            set.center = moved(set.center, 1.0, &column(cable, limits.middle(cable)));
            let generator = column(cable, 0.5 * (limits.maximum()[cable] - limits.minimum()[cable]));
            if generator.iter().any(|&row| row != 0.0) {
                set.generators.push(generator);
                set.cables.push(cable);
            }
        }
        set.drop_lost();
        set.span();
        set.shift_hyperplanes();
        Ok(set)
    }

    /// Removes generators too small to have a direction relative to the others.
    fn drop_lost(&mut self) {
        let largest = self.generators.iter().map(norm).fold(0.0, f64::max);
        let keep = |generator: &Rows| norm(generator) > 2.0 * LOST * largest;
        let kept = self.generators.iter().zip(&self.cables).filter(|(generator, _)| keep(generator));
        (self.generators, self.cables) = kept.map(|(generator, &cable)| (*generator, cable)).unzip();
    }

    /// One bit for each generator.
    fn all(&self) -> u64 {
        (1 << self.generators.len()) - 1
    }

    /// Finds the space of the generators by Gram–Schmidt with pivoting, and completes its axes.
    fn span(&mut self) {
        let rows = self.row_lengths.len();
        let longest = |rest: &[Rows]| rest.iter().copied().max_by(|a, b| norm(a).total_cmp(&norm(b)));
        let mut rest = self.generators.clone();
        let largest = longest(&rest).map_or(0.0, |generator| norm(&generator));
        while self.axes.len() < rows
            && let Some(pivot) = longest(&rest).filter(|pivot| norm(pivot) > LOST * largest)
        {
            let pivot = remainder(&pivot, &self.axes);
            let length = norm(&pivot);
            self.axes.push(pivot.map(|row| row / length));
            let axes = &self.axes;
            rest.iter_mut().for_each(|generator| *generator = remainder(generator, axes));
        }
        self.dimension = self.axes.len();
        while self.axes.len() < rows {
            let left = (0..rows).map(|row| remainder(&std::array::from_fn(|k| f64::from(k == row)), &self.axes));
            let Some(axis) = left.max_by(|a, b| norm(a).total_cmp(&norm(b))) else { break };
            let length = norm(&axis);
            self.axes.push(axis.map(|row| row / length));
        }
    }

    fn shift_hyperplanes(&mut self) {
        let units: Vec<Rows> = self.generators.iter().map(|generator| unit(&self.along_axes(generator))).collect();
        for hyperplane in hyperplanes(&units, self.dimension) {
            let normal = self.combined(&hyperplane.normal);
            self.shift(normal, hyperplane.contained);
        }
        // a flat set has no extent in any direction out of its space
        for index in self.dimension..self.axes.len() {
            self.shift(self.axes[index], self.all());
        }
    }

    /// Adds both facets normal to a direction.
    fn shift(&mut self, normal: Rows, free: u64) {
        let (mut width, mut plus) = (0.0, 0);
        for (index, generator) in self.generators.iter().enumerate() {
            let fraction = dot(&normal, generator);
            width += fraction.abs();
            if fraction > 0.0 && free & (1 << index) == 0 {
                plus |= 1 << index;
            }
        }
        let middle = dot(&normal, &self.center);
        let opposite = self.all() & !plus & !free;
        self.facets.push(Facet { normal, offset: middle + width, plus, free });
        self.facets.push(Facet { normal: normal.map(|row| -row), offset: width - middle, plus: opposite, free });
    }

    /// Components along the axes of the set's space.
    pub(super) fn along_axes(&self, vector: &Rows) -> Rows {
        let mut components = [0.0; 6];
        for (component, axis) in components.iter_mut().zip(&self.axes[..self.dimension]) {
            *component = dot(vector, axis);
        }
        components
    }

    fn combined(&self, components: &Rows) -> Rows {
        let mut vector = [0.0; 6];
        for (&component, axis) in components.iter().zip(&self.axes[..self.dimension]) {
            vector = moved(vector, component, axis);
        }
        vector
    }

    /// Dimension of the set: the rank of the columns of Aᵀ whose cables have a range of tensions.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Number of half-spaces.
    #[cfg(test)]
    pub(super) fn facet_count(&self) -> usize {
        self.facets.len()
    }

    /// Wrench in the middle of the set, −Aᵀ ½(f_min + f_max) (N, N·m).
    pub fn center(&self) -> Vec<f64> {
        self.unscaled(&self.center)
    }

    /// Rows in newtons converted back to N and N·m.
    pub(super) fn unscaled(&self, rows: &Rows) -> Vec<f64> {
        self.row_lengths.iter().zip(rows).map(|(length, row)| length * row).collect()
    }
}

pub(super) fn unit(vector: &Rows) -> Rows {
    let length = norm(vector);
    vector.map(|row| row / length)
}

fn check(structure_matrix: &DMatrix<f64>, limits: &Limits, row_lengths: &[f64]) -> Result<(), WrenchSetError> {
    let (rows, columns) = structure_matrix.shape();
    let count = |what, expected, found| match expected == found {
        true => Ok(()),
        false => Err(WrenchSetError::Count { what, expected, found }),
    };
    if !(1..=6).contains(&rows) {
        return Err(WrenchSetError::Rows { found: rows });
    }
    if columns > CABLE_LIMIT {
        return Err(WrenchSetError::TooManyCables { found: columns });
    }
    count("pairs of tension limits, one per cable", columns, limits.cable_count())?;
    count("row lengths, one per row of the structure matrix", rows, row_lengths.len())?;
    if let Some(&value) = structure_matrix.iter().find(|entry| !entry.is_finite()) {
        let rule = "a structure matrix has finite entries";
        return Err(WrenchSetError::Number { what: "entry of the structure matrix", value, rule });
    }
    match row_lengths.iter().find(|length| !(**length > 0.0 && length.is_finite())) {
        Some(&value) => {
            Err(WrenchSetError::Number { what: "length scale", value, rule: "it is a finite length above zero (m)" })
        }
        None => Ok(()),
    }
}
