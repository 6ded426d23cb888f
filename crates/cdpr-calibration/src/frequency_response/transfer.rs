//! Rational transfer functions with a delay.

use nalgebra::{Complex, DMatrix, Schur};
use std::f64::consts::TAU;
use std::fmt;

/// Transfer function `gain · e^(−s·delay) · N(s)/D(s)`, both polynomials being 1 at s = 0: none of its poles and zeros is 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Transfer {
    /// Gain at zero frequency (output's unit per input's unit).
    pub gain: f64,
    /// Delay (s); 0 for a model without one.
    pub delay: f64,
    /// Coefficients of D from the first power on, in `s / unit`.
    pub(super) denominator: Vec<f64>,
    /// The same of N.
    pub(super) numerator: Vec<f64>,
    /// Angular frequency that polynomials count in (rad/s).
    pub(super) unit: f64,
    /// Whether the delay is one of the parameters.
    pub(super) has_delay: bool,
}

/// Numbers of poles and zeros.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Orders {
    /// Number of poles.
    pub poles: usize,
    /// Number of zeros, at most that of poles.
    pub zeros: usize,
    /// Whether there is a delay.
    pub has_delay: bool,
}

impl Transfer {
    /// Response at a frequency (Hz).
    pub fn response(&self, frequency: f64) -> Complex<f64> {
        let s = self.place(frequency);
        let ratio = polynomial(&self.numerator, s) / polynomial(&self.denominator, s);
        ratio * self.gain * (-s * self.delay * self.unit).exp()
    }

    /// Poles (rad/s), slowest first, of a pair the one with positive imaginary part first.
    pub fn poles(&self) -> Vec<Complex<f64>> {
        roots(&self.denominator).into_iter().map(|root| root * self.unit).collect()
    }

    /// Zeros (rad/s), in the same order.
    pub fn zeros(&self) -> Vec<Complex<f64>> {
        roots(&self.numerator).into_iter().map(|root| root * self.unit).collect()
    }

    /// Numbers of poles and zeros.
    pub fn orders(&self) -> Orders {
        Orders { poles: self.denominator.len(), zeros: self.numerator.len(), has_delay: self.has_delay }
    }

    /// j ω in the unit of the polynomials.
    fn place(&self, frequency: f64) -> Complex<f64> {
        Complex::new(0.0, TAU * frequency / self.unit)
    }

    /// Derivatives of the logarithm of the response by the parameters, at a frequency (Hz).
    pub(super) fn slopes(&self, frequency: f64) -> Vec<Complex<f64>> {
        let s = self.place(frequency);
        let (below, above) = (polynomial(&self.denominator, s), polynomial(&self.numerator, s));
        let mut slopes = vec![Complex::from(1.0 / self.gain)];
        for (count, first) in [(self.denominator.len(), -s / below), (self.numerator.len(), s / above)] {
            let mut slope = first;
            for _ in 0..count {
                slopes.push(slope);
                slope *= s;
            }
        }
        slopes.extend(self.has_delay.then_some(-s));
        slopes
    }

    /// Derivative of the logarithm of the response by the frequency (1/Hz).
    pub(super) fn logarithmic_slope(&self, frequency: f64) -> Complex<f64> {
        let s = self.place(frequency);
        let relative = |coefficients: &[f64]| derivative(coefficients, s) / polynomial(coefficients, s);
        let by_place = relative(&self.numerator) - relative(&self.denominator) - self.delay * self.unit;
        by_place * Complex::new(0.0, TAU / self.unit)
    }

    /// Parameters: gain, coefficients of D and N, and the delay in units of `1 / unit`.
    pub(super) fn parameters(&self) -> Vec<f64> {
        let delay = self.has_delay.then_some(self.delay * self.unit);
        [self.gain].into_iter().chain(self.denominator.iter().chain(&self.numerator).copied()).chain(delay).collect()
    }

    /// The function of the same orders with these parameters.
    pub(super) fn with(&self, parameters: &[f64]) -> Self {
        let (poles, zeros) = (self.denominator.len(), self.numerator.len());
        Self {
            gain: parameters[0],
            denominator: parameters[1..=poles].to_vec(),
            numerator: parameters[1 + poles..=poles + zeros].to_vec(),
            delay: if self.has_delay { parameters[1 + poles + zeros] / self.unit } else { 0.0 },
            ..self.clone()
        }
    }

    /// Derivatives of the poles (rad/s) by the parameters, a row each.
    pub(super) fn pole_slopes(&self) -> Vec<Vec<Complex<f64>>> {
        self.root_slopes(&self.denominator, 1)
    }

    /// The same of the zeros.
    pub(super) fn zero_slopes(&self) -> Vec<Vec<Complex<f64>>> {
        self.root_slopes(&self.numerator, 1 + self.denominator.len())
    }

    fn root_slopes(&self, coefficients: &[f64], first: usize) -> Vec<Vec<Complex<f64>>> {
        let count = self.parameters().len();
        let of = |root: Complex<f64>| {
            let slope = derivative(coefficients, root);
            let mut row = vec![Complex::default(); count];
            for k in 0..coefficients.len() {
                row[first + k] = -root.powi(k as i32 + 1) / slope * self.unit;
            }
            row
        };
        roots(coefficients).into_iter().map(of).collect()
    }
}

/// 1 + c₁ s + c₂ s² + …
fn polynomial(coefficients: &[f64], s: Complex<f64>) -> Complex<f64> {
    coefficients.iter().rev().fold(Complex::default(), |sum, coefficient| (sum + coefficient) * s) + 1.0
}

/// c₁ + 2 c₂ s + …
fn derivative(coefficients: &[f64], s: Complex<f64>) -> Complex<f64> {
    coefficients.iter().enumerate().map(|(k, coefficient)| s.powi(k as i32) * (coefficient * (k + 1) as f64)).sum()
}

/// Roots of 1 + c₁ s + c₂ s² + …: reciprocals of the eigenvalues of a companion matrix, with a step of Newton's.
fn roots(coefficients: &[f64]) -> Vec<Complex<f64>> {
    let count = coefficients.len();
    if count == 0 {
        return Vec::new();
    }
    // of the reversed polynomial, which is monic: xⁿ + c₁ xⁿ⁻¹ + … + cₙ with x = 1/s
    let companion = DMatrix::from_fn(count, count, |row, column| match row {
        0 => -coefficients[column],
        _ if row == column + 1 => 1.0,
        _ => 0.0,
    });
    let Some(schur) = Schur::try_new(companion, f64::EPSILON, 10_000) else { return Vec::new() };
    let mut roots: Vec<Complex<f64>> = schur.complex_eigenvalues().iter().map(|eigenvalue| 1.0 / eigenvalue).collect();
    for root in &mut roots {
        let step = polynomial(coefficients, *root) / derivative(coefficients, *root);
        if step.norm() < 1e-3 * root.norm() {
            *root -= step;
        }
    }
    // pairs have the same size to rounding
    let size = |root: &Complex<f64>| (root.norm() * 1e9).round();
    roots.sort_by(|a, b| {
        let by_size = if (a.norm() / b.norm() - 1.0).abs() < 1e-9 {
            std::cmp::Ordering::Equal
        } else {
            size(a).total_cmp(&size(b))
        };
        by_size.then(b.im.total_cmp(&a.im))
    });
    roots
}

impl fmt::Display for Orders {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counted = |count: usize, one: &str| format!("{count} {one}{}", if count == 1 { "" } else { "s" });
        let delay = if self.has_delay { ", a delay" } else { "" };
        write!(to, "{}, {}{delay}", counted(self.poles, "pole"), counted(self.zeros, "zero"))
    }
}
