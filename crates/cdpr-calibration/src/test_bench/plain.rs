//! Laws without hysteresis for comparison: a straight line and polynomials.
//!
//! A record that begins under tension says nothing of the way from the cable without tension to there. The polynomial of least
//! squares then has an intercept and, often, no root from which it rises: it is no law f = Σ cₖ εᵏ. So the strain at which the
//! record begins, the preload strain, is one more unknown: of all polynomials that are 0 at a hidden start below the record
//! and rise from there on, the one with the least squares is the law.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::misfit::Misfit;
use super::record::Record;
use cdpr_model::cable::stretch::polynomial_law;

/// Highest degree that is tried.
const DEGREE: usize = 4;

/// Hidden starts are no farther below the record than this share of its elongations …
const NEAR: f64 = 1.0;

/// … and those that are tried begin at this share, so many.
const STARTS: (f64, i32) = (1e-3, 200);

/// Stiffness without tension of a law with a hidden start is no less than this share of the largest tension over all elongations.
const SOFTEST: f64 = 0.02;

/// Errors that are alike: as a share of themselves, and of the largest tension.
const ALIKE: (f64, f64) = (0.02, 1e-4);

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
    /// Strain at the least elongation of the record: where the cable had no tension lies that far before the record; 0 where the
    /// record has it.
    pub preload_strain: f64,
    /// Tension of the law at this strain (N).
    pub preload: f64,
    /// Its error on the record.
    pub misfit: Misfit,
}

/// f = c₀ + Σ cₖ εᵏ with strains from the least elongation of the record: no law of a robot file, since it need not come from no tension.
#[derive(Clone, Debug, PartialEq)]
pub struct InterceptFit {
    /// c₀, the tension at the least elongation (N).
    pub intercept: f64,
    /// c₁, c₂, … (N).
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

/// Polynomials over t = 0…1, the elongations of a record from the least to the largest.
pub(super) struct Polynomials<'a> {
    record: &'a Record,
    lower: f64,
    width: f64,
    /// Free length of the sample (m).
    length: f64,
    /// Largest tension of the record (N).
    largest: f64,
}

/// The polynomial of least squares of a degree, by powers of t, with the factors of its normal equations.
struct Free {
    coefficients: DVector<f64>,
    factors: Cholesky<f64, Dyn>,
    /// Sum of the squares of its errors (N²).
    squares: f64,
}

impl<'a> Polynomials<'a> {
    pub(super) fn new(record: &'a Record, [lower, upper]: [f64; 2], length: f64) -> Self {
        let largest = record.tensions.iter().copied().fold(0.0, f64::max);
        Self { record, lower, width: upper - lower, length, largest }
    }

    /// The polynomial of least squares of degree 4 with its intercept.
    pub(super) fn with_intercept(&self) -> Option<InterceptFit> {
        let coefficients = self.free(DEGREE)?.coefficients;
        let value = |t: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c);
        let misfit = Misfit::of(self.rows().map(|(t, tension)| value(t) - tension));
        let own = self.by_strain(coefficients.as_slice());
        Some(InterceptFit { intercept: coefficients[0], coefficients: own, misfit })
    }

    /// The law with the least error of degree 1 to 4: a polynomial that rises from no tension to the largest; `None` when none rises. Of laws that are as
    /// good that of the highest degree, at the root of the polynomial of least squares where that is near.
    pub(super) fn law(&self) -> Option<PolynomialFit> {
        let free: Vec<Free> = (1..=DEGREE).rev().filter_map(|degree| self.free(degree)).collect();
        let whole = |free: &Free| {
            let root = root_below(free.coefficients.as_slice())?;
            self.rising(free.coefficients.as_slice(), root)
        };
        let least = free.iter().map(|free| free.squares).fold(f64::INFINITY, f64::min);
        let wholes: Vec<PolynomialFit> = free.iter().filter_map(whole).collect();
        let near = |fit: &&PolynomialFit| {
            fit.preload_strain * self.length <= NEAR * self.width && fit.misfit.rms <= self.as_good_as(self.rms(least))
        };
        if let Some(fit) = wholes.iter().find(near) {
            return Some(fit.clone());
        }
        let with_start = self.with_start(&free);
        let fits = wholes.into_iter().chain(with_start);
        fits.reduce(|best, other| if other.misfit.rms <= self.as_good_as(best.misfit.rms) { other } else { best })
    }

    /// t and tension row by row.
    fn rows(&self) -> impl Iterator<Item = (f64, f64)> {
        let rows = self.record.elongations.iter().zip(&self.record.tensions);
        rows.map(|(elongation, tension)| ((elongation - self.lower) / self.width, *tension))
    }

    /// Coefficients by powers of the strain, of those by powers of t; the constant is left out.
    fn by_strain(&self, coefficients: &[f64]) -> Vec<f64> {
        let per_strain = self.length / self.width;
        (1..).zip(&coefficients[1..]).map(|(k, c)| c * per_strain.powi(k)).collect()
    }

    fn free(&self, degree: usize) -> Option<Free> {
        let terms = degree + 1;
        let (mut normal, mut right) = (DMatrix::zeros(terms, terms), DVector::zeros(terms));
        for (t, tension) in self.rows() {
            let row = DVector::from_fn(terms, |k, _| t.powi(k as i32));
            normal.ger(1.0, &row, &row, 1.0);
            right.axpy(tension, &row, 1.0);
        }
        let factors = normal.cholesky()?;
        let coefficients = factors.solve(&right);
        let value = |t: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c);
        let squares = self.rows().map(|(t, tension)| (value(t) - tension).powi(2)).sum();
        Some(Free { coefficients, factors, squares })
    }

    /// Root of the mean of squares (N).
    fn rms(&self, squares: f64) -> f64 {
        (squares / self.record.tensions.len() as f64).sqrt()
    }

    /// Largest error that is as good as another one (N).
    fn as_good_as(&self, rms: f64) -> f64 {
        (1.0 + ALIKE.0) * rms + ALIKE.1 * self.largest
    }

    /// The best of the laws that are 0 at a hidden start below the record, no farther from it than it is wide.
    fn with_start(&self, free: &[Free]) -> Option<PolynomialFit> {
        let (nearest, count) = STARTS;
        let start = |k: i32| nearest * (NEAR / nearest).powf(f64::from(k) / f64::from(count));
        let softest = SOFTEST * self.largest * self.length / self.width;
        let best_at = |start: f64| {
            let rising = free.iter().filter_map(|free| {
                let (coefficients, price) = free.zero_at(-start);
                let law = self.law_from(coefficients.as_slice(), -start)?;
                (law[0] >= softest).then_some((free.squares + price, coefficients))
            });
            rising
                .min_by(|one, other| one.0.total_cmp(&other.0))
                .map(|(squares, coefficients)| (squares, -start, coefficients))
        };
        let found = (0..=count).filter_map(|k| best_at(start(k)));
        let (_, root, coefficients) = found.min_by(|one, other| one.0.total_cmp(&other.0))?;
        self.rising(coefficients.as_slice(), root)
    }

    /// Coefficients of the law of a polynomial by powers of t with a root there; `None` unless it rises from the root to the largest tension.
    fn law_from(&self, coefficients: &[f64], root: f64) -> Option<Vec<f64>> {
        let (mut shifted, degree) = (coefficients.to_vec(), coefficients.len() - 1);
        // p(t) by powers of t − root, by repeated division
        for from in 0..degree {
            for k in (from..degree).rev() {
                shifted[k] += root * shifted[k + 1];
            }
        }
        let coefficients = self.by_strain(&shifted);
        polynomial_law(&coefficients, Some(self.largest)).ok().map(|_| coefficients)
    }

    /// The law of a polynomial by powers of t with a root there, with its error.
    fn rising(&self, coefficients: &[f64], root: f64) -> Option<PolynomialFit> {
        let coefficients = self.law_from(coefficients, root)?;
        let law = polynomial_law(&coefficients, Some(self.largest)).ok()?;
        let strain = |t: f64| (t - root) * self.width / self.length;
        let misfit = Misfit::of(self.rows().map(|(t, tension)| law.tension(strain(t)).0 - tension));
        let preload_strain = strain(0.0).max(0.0);
        Some(PolynomialFit { preload: law.tension(preload_strain).0, preload_strain, coefficients, misfit })
    }
}

impl Free {
    /// The polynomial of least squares among those with a root there, and by how much its squares are more (N²).
    fn zero_at(&self, root: f64) -> (DVector<f64>, f64) {
        let powers = DVector::from_fn(self.coefficients.len(), |k, _| root.powi(k as i32));
        let push = self.factors.solve(&powers);
        let (gap, fraction) = (powers.dot(&self.coefficients), powers.dot(&push));
        (&self.coefficients - push * (gap / fraction), gap * gap / fraction)
    }
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
