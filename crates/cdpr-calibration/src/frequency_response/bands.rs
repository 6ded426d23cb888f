//! Uncertainty of a fit: covariance of its parameters, and standard deviations of what follows from them, to first order.

use nalgebra::{Complex, DMatrix};
use std::f64::consts::TAU;

use super::curve::slope;
use super::points::{Point, Points};
use super::refine::Refined;
use super::transfer::Transfer;
use crate::student::NORMAL_95;

/// Steps of a curve.
const CURVE: usize = 200;

/// A number with its standard deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Banded {
    /// The number.
    pub value: f64,
    /// Its standard deviation.
    pub sigma: f64,
}

impl Banded {
    /// Ends of the 95 % interval.
    pub fn band(&self) -> [f64; 2] {
        [-NORMAL_95, NORMAL_95].map(|width| self.value + width * self.sigma)
    }
}

/// A pole or a zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// Its place in the complex plane (rad/s).
    pub value: Complex<f64>,
    /// Standard deviation of real and imaginary part (rad/s).
    pub sigma: [f64; 2],
}

/// A model's response at one frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Frequency (Hz).
    pub frequency: f64,
    /// Output per input.
    pub response: Complex<f64>,
    /// Standard deviation of the gain.
    pub gain_sigma: f64,
    /// Standard deviation of the phase (rad).
    pub phase_sigma: f64,
}

/// Covariance of the parameters of a fit.
pub(super) struct Covariance<'a> {
    transfer: &'a Transfer,
    matrix: DMatrix<f64>,
}

impl<'a> Covariance<'a> {
    /// Of a fit to these points; what no model explains, a factor of all variances, counts where it is above 1. `None` where the
    /// points do not determine all parameters.
    pub(super) fn of(fit: &'a Refined, points: &Points, misfit: f64) -> Option<Self> {
        let transfer = &fit.transfer;
        let information = &fit.equations.hessian;
        let scale = information.diagonal().map(|entry| 1.0 / entry.sqrt());
        let scaled = DMatrix::from_fn(scale.len(), scale.len(), |i, j| information[(i, j)] * scale[i] * scale[j]);
        let inverse = scaled.cholesky()?.inverse();
        let inverse = DMatrix::from_fn(scale.len(), scale.len(), |i, j| inverse[(i, j)] * scale[i] * scale[j]);
        // neighbours err together: (JᵀWJ)⁻¹ Jᵀ W Σ W J (JᵀWJ)⁻¹ with the true covariance Σ of the points
        let weighed = |point: &Point| -> Vec<Complex<f64>> {
            let factor = transfer.response(point.frequency) / (point.sigma * point.sigma);
            transfer.slopes(point.frequency).iter().map(|slope| slope * factor).collect()
        };
        let rows: Vec<Vec<Complex<f64>>> = points.fitted.iter().map(|&k| weighed(&points.all[k])).collect();
        let mut middle = information.clone();
        for (k, pair) in rows.windows(2).enumerate() {
            for i in 0..scale.len() {
                for j in 0..scale.len() {
                    let term = |a: usize, b: usize| 0.5 * (pair[0][a].conj() * pair[1][b] * points.next[k]).re;
                    middle[(i, j)] += term(i, j) + term(j, i);
                }
            }
        }
        let matrix = &inverse * middle * &inverse * misfit.max(1.0);
        matrix.diagonal().iter().all(|variance| *variance > 0.0).then_some(Self { transfer, matrix })
    }

    fn sigma(&self, slopes: &[f64]) -> f64 {
        let row = nalgebra::DVector::from_column_slice(slopes);
        row.dot(&(&self.matrix * &row)).max(0.0).sqrt()
    }

    /// Derivatives of the logarithm of the gain.
    fn gain_slopes(&self, frequency: f64) -> Vec<f64> {
        self.transfer.slopes(frequency).iter().map(|slope| slope.re).collect()
    }

    /// Gain at zero frequency.
    pub(super) fn gain(&self) -> Banded {
        Banded { value: self.transfer.gain, sigma: self.matrix[(0, 0)].sqrt() }
    }

    /// Delay (s); `None` for a function without one.
    pub(super) fn delay(&self) -> Option<Banded> {
        let last = self.matrix.nrows() - 1;
        let sigma = self.matrix[(last, last)].sqrt() / self.transfer.unit;
        self.transfer.has_delay.then_some(Banded { value: self.transfer.delay, sigma })
    }

    /// Gain at a frequency (Hz).
    pub(super) fn gain_at(&self, frequency: f64) -> Banded {
        let value = self.transfer.response(frequency).norm();
        Banded { value, sigma: value * self.sigma(&self.gain_slopes(frequency)) }
    }

    /// The response from one frequency to another (Hz).
    pub(super) fn curve(&self, first: f64, last: f64) -> Vec<CurvePoint> {
        let at = |k: usize| {
            let frequency = first * (last / first).powf(k as f64 / CURVE as f64);
            let phases: Vec<f64> = self.transfer.slopes(frequency).iter().map(|slope| slope.im).collect();
            let response = self.transfer.response(frequency);
            let (gain_sigma, phase_sigma) = (self.gain_at(frequency).sigma, self.sigma(&phases));
            CurvePoint { frequency, response, gain_sigma, phase_sigma }
        };
        (0..=CURVE).map(at).collect()
    }

    /// Frequency at which the gain crosses a fixed part of the gain at another frequency (Hz).
    pub(super) fn crossing(&self, frequency: f64, reference: f64) -> Banded {
        let (here, there) = (self.gain_slopes(frequency), self.gain_slopes(reference));
        let slopes: Vec<f64> = here.iter().zip(there).map(|(here, there)| here - there).collect();
        Banded { value: frequency, sigma: self.sigma(&slopes) / slope(self.transfer, frequency).abs() }
    }

    /// Frequency of a peak inside the band (Hz).
    pub(super) fn peak(&self, frequency: f64) -> Banded {
        // the slopes are analytic: differences of them lose half the digits of no more than a standard deviation
        let h = 1e-4 * frequency;
        let (behind, before) = (self.gain_slopes(frequency + h), self.gain_slopes(frequency - h));
        let slopes: Vec<f64> =
            behind.iter().zip(before).map(|(behind, before)| (behind - before) / (2.0 * h)).collect();
        let bend = (slope(self.transfer, frequency + h) - slope(self.transfer, frequency - h)) / (2.0 * h);
        Banded { value: frequency, sigma: self.sigma(&slopes) / bend.abs() }
    }

    pub(super) fn poles(&self) -> Vec<Root> {
        self.roots(self.transfer.poles(), self.transfer.pole_slopes())
    }

    pub(super) fn zeros(&self) -> Vec<Root> {
        self.roots(self.transfer.zeros(), self.transfer.zero_slopes())
    }

    fn roots(&self, values: Vec<Complex<f64>>, slopes: Vec<Vec<Complex<f64>>>) -> Vec<Root> {
        let of = |row: &[Complex<f64>], part: fn(&Complex<f64>) -> f64| {
            self.sigma(&row.iter().map(part).collect::<Vec<f64>>())
        };
        let root = |(value, row): (Complex<f64>, Vec<Complex<f64>>)| {
            let imaginary = if value.im == 0.0 { 0.0 } else { of(&row, |slope| slope.im) };
            Root { value, sigma: [of(&row, |slope| slope.re), imaginary] }
        };
        values.into_iter().zip(slopes).map(root).collect()
    }
}

impl Root {
    /// Natural frequency (Hz).
    pub fn frequency(&self) -> f64 {
        self.value.norm() / TAU
    }

    /// Damping ratio; negative on the right of the imaginary axis.
    pub fn damping(&self) -> f64 {
        -self.value.re / self.value.norm()
    }
}
