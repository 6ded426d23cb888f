//! Sign changes of the structure matrix' minors along a straight line.

use nalgebra::{DMatrix, DVector, Vector3};

use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::Model;
use cdpr_model::scalar::polynomial::sign_changes;

/// The structure matrix times cable lengths along a straight line in one orientation: linear in the fraction t of the
/// line, so that its minors are polynomials of at most the n-th degree.
///
/// Between two sign changes of any minor, each cable stays on the same side of every hyperplane that others span: a
/// property that depends on these sides alone, such as wrench closure, does not change there.
pub(super) struct Minors {
    /// At t = 0.
    start: DMatrix<f64>,
    /// Difference between t = 1 and t = 0.
    change: DMatrix<f64>,
    /// Length of the line (m).
    length: f64,
}

/// Count of minors above which judging poses is faster.
const MOST: usize = 1000;
/// Coefficients below this fraction of the largest minor that columns of this length can have are rounding errors of
/// zero.
const ROUNDING: f64 = 1e-13;

impl Minors {
    /// The matrix along a direction of length 1 from a pose; `None` for outlets that are not points, for sagging
    /// cables, and for too many cables.
    pub(super) fn along(model: &Model, pose: &Pose, direction: &Vector3<f64>, length: f64) -> Option<Self> {
        let lines = model.straight_lines()?;
        let count = binomial(model.cable_count(), model.dof());
        if count > MOST {
            return None;
        }
        let column = |way: &Vector3<f64>, moment_arm: &Vector3<f64>| {
            let moment = moment_arm.cross(way);
            let column = Twist::new(way.x, way.y, way.z, moment.x, moment.y, moment.z);
            DVector::from_iterator(model.dof(), model.twist_basis().iter().map(|basis| basis.dot(&column)))
        };
        let ends: Vec<_> = lines.map(|(frame_anchor, anchor)| (frame_anchor, pose.rotation * anchor)).collect();
        let columns = |columns: Vec<DVector<f64>>| DMatrix::from_columns(&columns);
        let start = ends.iter().map(|(frame_anchor, arm)| column(&(*frame_anchor - pose.position - arm), arm));
        let change = ends.iter().map(|(_, arm)| column(&(-direction * length), arm));
        let (start, change) = (columns(start.collect()), columns(change.collect()));
        Some(Self { start, change, length })
    }

    /// Distances from the start at which some minor changes its sign (m), in increasing order.
    pub(super) fn sign_changes(&self) -> Vec<f64> {
        let (dof, cable_count) = self.start.shape();
        if cable_count < dof {
            return Vec::new();
        }
        let nodes = Nodes::new(dof);
        let at: Vec<DMatrix<f64>> = nodes.places.iter().map(|t| &self.start + &self.change * *t).collect();
        let mut chosen: Vec<usize> = (0..dof).collect();
        let mut marks = Vec::new();
        loop {
            let values = at.iter().map(|matrix| matrix.select_columns(&chosen).determinant());
            let values = DVector::from_iterator(nodes.places.len(), values);
            let largest: f64 = chosen.iter().map(|&cable| self.largest(cable)).product();
            if values.amax() > ROUNDING * largest {
                let coefficients = nodes.coefficients(&values);
                marks.extend(sign_changes(coefficients.as_slice(), 1.0).iter().map(|t| t * self.length));
            }
            if !next(&mut chosen, cable_count) {
                break;
            }
        }
        marks.sort_by(f64::total_cmp);
        marks
    }

    /// Largest length of a column along the line.
    fn largest(&self, cable: usize) -> f64 {
        let start = self.start.column(cable);
        start.norm().max((start + self.change.column(cable)).norm())
    }
}

/// Nodes in 0..1 that determine a polynomial.
struct Nodes {
    places: Vec<f64>,
    /// Matrix from values at the nodes to coefficients.
    inverse: DMatrix<f64>,
}

impl Nodes {
    /// Nodes for polynomials of this degree, at the extrema of Chebyshev's.
    fn new(degree: usize) -> Self {
        let angle = |k: usize| std::f64::consts::PI * k as f64 / degree as f64;
        let places: Vec<f64> = (0..=degree).map(|k| 0.5 - 0.5 * angle(k).cos()).collect();
        let powers = DMatrix::from_fn(degree + 1, degree + 1, |row, power| places[row].powi(power as i32));
        // distinct nodes always determine the coefficients
        let inverse = powers.try_inverse().unwrap_or_else(|| DMatrix::zeros(degree + 1, degree + 1));
        Self { places, inverse }
    }

    fn coefficients(&self, values: &DVector<f64>) -> DVector<f64> {
        &self.inverse * values
    }
}

/// Advances to the next choice out of `count`, in lexicographic order; false after the last one.
fn next(chosen: &mut [usize], count: usize) -> bool {
    let size = chosen.len();
    let Some(place) = (0..size).rev().find(|&place| chosen[place] < count - size + place) else { return false };
    chosen[place] += 1;
    for later in place + 1..size {
        chosen[later] = chosen[later - 1] + 1;
    }
    true
}

/// Number of choices of `size` out of `count`.
fn binomial(count: usize, size: usize) -> usize {
    (0..size.min(count)).fold(1, |ways: usize, k| ways.saturating_mul(count - k) / (k + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_choices_come_once() {
        let (mut chosen, mut count) = (vec![0, 1, 2], 1);
        while next(&mut chosen, 6) {
            count += 1;
        }
        assert_eq!((count, binomial(6, 3), binomial(8, 6), binomial(5, 5)), (20, 20, 28, 1));
        assert_eq!(chosen, [3, 4, 5]);
    }
}
