//! Laws without hysteresis for comparison: a straight line and a polynomial.

use nalgebra::{DMatrix, DVector};

use super::misfit::Misfit;
use super::record::Record;
use crate::cable::stretch::polynomial_law;

/// Highest degree that is tried.
const DEGREE: usize = 4;

/// f = k (e − e₀).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearFit {
    /// Stiffness k (N/m).
    pub stiffness: f64,
    /// k times the sample's length, E·A (N).
    pub axial_stiffness: f64,
    /// Its error on the record.
    pub misfit: Misfit,
}

/// f = Σ cₖ εᵏ.
#[derive(Clone, Debug, PartialEq)]
pub struct PolynomialFit {
    /// c₁, c₂, … (N), the key `tension_of_strain_N`.
    pub coefficients: Vec<f64>,
    /// Its error on the record.
    pub misfit: Misfit,
}

/// The straight line of least squares.
pub(super) fn line(record: &Record, length: f64) -> LinearFit {
    let count = record.elongations.len() as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
    let (e0, f0) = (mean(&record.elongations), mean(&record.tensions));
    let rows = || record.elongations.iter().zip(&record.tensions).map(|(e, f)| (e - e0, f - f0));
    let stiffness = rows().map(|(e, f)| e * f).sum::<f64>() / rows().map(|(e, _)| e * e).sum::<f64>();
    let misfit = Misfit::of(rows().map(|(e, f)| stiffness * e - f));
    LinearFit { stiffness, axial_stiffness: stiffness * length, misfit }
}

/// The polynomial of least squares of the highest degree up to 4 that rises from no tension to the largest.
pub(super) fn polynomial(record: &Record, range: [f64; 2], length: f64) -> Option<PolynomialFit> {
    (1..=DEGREE).rev().find_map(|degree| of_degree(record, range, length, degree))
}

fn of_degree(record: &Record, [lower, upper]: [f64; 2], length: f64, degree: usize) -> Option<PolynomialFit> {
    let width = upper - lower;
    let terms = degree + 1;
    let (mut normal, mut right) = (DMatrix::zeros(terms, terms), DVector::zeros(terms));
    for (elongation, tension) in record.elongations.iter().zip(&record.tensions) {
        let t = (elongation - lower) / width;
        let row = DVector::from_fn(terms, |k, _| t.powi(k as i32));
        normal.ger(1.0, &row, &row, 1.0);
        right.axpy(*tension, &row, 1.0);
    }
    let mut shifted = normal.cholesky()?.solve(&right).as_slice().to_vec();
    let zero = root_below(&shifted)?;
    // p(t) by powers of t − zero, by repeated division
    for from in 0..degree {
        for k in (from..degree).rev() {
            shifted[k] += zero * shifted[k + 1];
        }
    }
    let per_strain = length / width;
    let coefficients: Vec<f64> = (1..=degree).map(|k| shifted[k] * per_strain.powi(k as i32)).collect();
    let largest = record.tensions.iter().copied().fold(0.0, f64::max);
    let law = polynomial_law(&coefficients, Some(largest)).ok()?;
    let strain = |elongation: f64| ((elongation - lower) / width - zero) / per_strain;
    let rows = record.elongations.iter().zip(&record.tensions);
    let misfit = Misfit::of(rows.map(|(&elongation, tension)| law.tension(strain(elongation)).0 - tension));
    Some(PolynomialFit { coefficients, misfit })
}

/// The root of a polynomial next to 0, where it rises.
fn root_below(coefficients: &[f64]) -> Option<f64> {
    let value = |t: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c);
    let slope = |t: f64| coefficients.iter().enumerate().skip(1).rev().fold(0.0, |sum, (k, c)| sum * t + c * k as f64);
    let mut t = 0.0;
    for _ in 0..100 {
        let step = value(t) / slope(t);
        t -= step;
        if !t.is_finite() {
            return None;
        }
        if step.abs() < 1e-14 {
            break;
        }
    }
    (value(t).abs() < 1e-9 * coefficients.iter().fold(1.0, |sum: f64, c| sum.max(c.abs()))).then_some(t)
}
