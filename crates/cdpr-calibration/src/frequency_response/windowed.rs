//! The H1 estimate: cross spectrum by the input's spectrum, averaged over windows that overlap by half (Welch 1967; Bendat and Piersol 2010, ch. 6 and 9).
//!
//! Noise of the output alone is assumed; noise of the input lowers gains by its share of the input's power.

use nalgebra::Complex;
use rustfft::{Fft, FftPlanner};
use std::f64::consts::TAU;
use std::sync::Arc;

use super::InputError;
use super::points::{LEAST_SIGMA, Point, Points};
use super::sampling::Even;

/// Windows that are needed at least.
const FEWEST: usize = 5;

/// Lengths of a window in the record, where none is asked for: 15 windows.
const LENGTHS: usize = 8;

/// First bin that mean and drift do not reach through Hann's window.
const FIRST_BIN: usize = 2;

/// Least power of the input relative to its largest, so that leakage from excited frequencies is no excitation.
const LEAST_POWER: f64 = 1e-4;

/// Bins to both sides over which the power of the noise is averaged.
const SMOOTHED: usize = 4;

/// How a record is cut, and the transform of a window.
pub(super) struct Windows {
    /// Samples of a window, an even number.
    length: usize,
    /// Number of windows.
    pub(super) count: usize,
    /// Hann's window.
    weights: Vec<f64>,
    transform: Arc<dyn Fft<f64>>,
}

/// Spectra of a series, window by window.
pub(super) struct Spectra(Vec<Vec<Complex<f64>>>);

impl Windows {
    pub(super) fn new(even: &Even, window: Option<f64>) -> Result<Self, InputError> {
        let samples = even.len();
        let length = window.map_or(samples / LENGTHS, |window| (window / even.step).round() as usize);
        let length = (length - length % 2).max(8);
        let count = if length > samples { 0 } else { (samples - length) / (length / 2) + 1 };
        if count < FEWEST {
            let longest = 2.0 * even.duration() / (FEWEST + 1) as f64;
            let window = length as f64 * even.step;
            return Err(InputError::TooFewWindows { window, found: count, needed: FEWEST, longest });
        }
        let weight = |n: usize| 0.5 - 0.5 * (TAU * n as f64 / length as f64).cos();
        let transform = FftPlanner::new().plan_fft_forward(length);
        Ok(Self { length, count, weights: (0..length).map(weight).collect(), transform })
    }

    /// Distance of bins (Hz) at this distance of samples (s).
    fn resolution(&self, step: f64) -> f64 {
        1.0 / (self.length as f64 * step)
    }

    pub(super) fn spectra(&self, series: &[f64]) -> Spectra {
        let window = |k: usize| {
            let rows = &series[k * self.length / 2..][..self.length];
            let weighed = rows.iter().zip(&self.weights).map(|(value, weight)| Complex::from(value * weight));
            let mut bins: Vec<Complex<f64>> = weighed.collect();
            self.transform.process(&mut bins);
            bins.truncate(self.length / 2);
            bins
        };
        Spectra((0..self.count).map(window).collect())
    }

    /// Correlation of white noise in bin `i` of a window with bin `j` of the window `later` windows behind.
    fn correlation(&self, i: usize, j: usize, later: i64) -> Complex<f64> {
        let half = (self.length / 2) as i64;
        let power: f64 = self.weights.iter().map(|weight| weight * weight).sum();
        let turn = TAU * (i as f64 - j as f64) / self.length as f64;
        let term = |n: usize| {
            let other = n as i64 - later * half;
            let weight = usize::try_from(other).ok().and_then(|other| self.weights.get(other)).unwrap_or(&0.0);
            Complex::from_polar(self.weights[n] * weight, -turn * n as f64)
        };
        let sum: Complex<f64> = (0..self.length).map(term).sum();
        let sign = if later != 0 && j % 2 == 1 { -1.0 } else { 1.0 };
        sum * (sign / power)
    }
}

impl Spectra {
    /// Sum over windows of the product of two bins, the first one conjugated.
    fn product(&self, i: usize, other: &Self, j: usize) -> Complex<f64> {
        self.0.iter().zip(&other.0).map(|(a, b)| a[i].conj() * b[j]).sum()
    }

    fn power(&self, i: usize) -> f64 {
        self.0.iter().map(|bins| bins[i].norm_sqr()).sum()
    }

    /// H1 at a bin.
    fn response(&self, output: &Self, i: usize) -> Complex<f64> {
        self.product(i, output, i) / self.power(i)
    }

    /// Bins that the input excites.
    fn excited(&self) -> Vec<usize> {
        let bins = FIRST_BIN..self.0[0].len();
        let powers: Vec<f64> = bins.clone().map(|i| self.power(i)).collect();
        let most = powers.iter().copied().fold(0.0, f64::max);
        bins.filter(|i| powers[i - FIRST_BIN] >= LEAST_POWER * most).collect()
    }
}

/// Effect of the output's noise on the estimate.
struct Noise<'a> {
    input: &'a Spectra,
    /// Correlations of windows with themselves and the next one, for the same bin and for bins two apart.
    correlations: [[Complex<f64>; 2]; 2],
}

impl<'a> Noise<'a> {
    fn new(windows: &Windows, input: &'a Spectra) -> Self {
        // depends on the distance of bins and, by a sign, on the second one's parity, which is even here
        let of = |distance: usize| [0, 1].map(|later| windows.correlation(4, 4 + distance, later));
        Self { input, correlations: [of(0), of(2)] }
    }

    /// E(e_i e_j*) of the estimate's errors for white noise of unit power, bins equal or two apart.
    fn covariance(&self, i: usize, j: usize) -> Complex<f64> {
        let [same, next] = self.correlations[(j - i) / 2];
        let windows = &self.input.0;
        let sign = if j % 2 == 1 { -1.0 } else { 1.0 };
        let mut sum = self.input.product(i, self.input, j) * same;
        for pair in windows.windows(2) {
            // the earlier window's bin i with the later one's bin j, and the other way round
            sum += (pair[0][i].conj() * pair[1][j] + pair[1][i].conj() * pair[0][j]) * next * sign;
        }
        sum / (self.input.power(i) * self.input.power(j))
    }
}

/// Points of the estimate, none of them trusted yet, at all bins that the input excites; `step` is the distance of samples (s).
pub(super) fn points(step: f64, windows: &Windows, input: &Spectra, output: &[f64]) -> Points {
    let output = windows.spectra(output);
    let bins = input.excited();
    let noise = Noise::new(windows, input);
    let shares: Vec<f64> = bins.iter().map(|&i| noise.covariance(i, i).re).collect();
    let responses: Vec<Complex<f64>> = bins.iter().map(|&i| input.response(&output, i)).collect();
    let raw: Vec<f64> = (0..bins.len())
        .map(|k| {
            let i = bins[k];
            let left = (output.power(i) - responses[k].norm_sqr() * input.power(i)).max(0.0);
            left / (windows.count as f64 - shares[k] * input.power(i)).max(1.0)
        })
        .collect();
    let powers = smoothed(&bins, &raw);
    let all: Vec<Point> = (0..bins.len())
        .map(|k| {
            let response = responses[k];
            let explained = response.norm_sqr() * input.power(bins[k]);
            let coherence = (explained / output.power(bins[k])).min(1.0);
            let sigma = (0.5 * powers[k] * shares[k]).sqrt().max(LEAST_SIGMA * response.norm());
            let frequency = bins[k] as f64 * windows.resolution(step);
            Point { frequency, response, coherence, sigma, is_trusted: false }
        })
        .collect();
    let fitted = independent(&bins, input);
    let next = |pair: &[usize]| {
        let (i, j) = (bins[pair[0]], bins[pair[1]]);
        let is_near = j == i + 2;
        let covariance = if is_near { noise.covariance(i, j) } else { Complex::default() };
        covariance * (powers[pair[0]] * powers[pair[1]]).sqrt()
    };
    let next = fitted.windows(2).map(next).chain([Complex::default()]).collect();
    Points { all, fitted, next, resolution: windows.resolution(step) }
}

/// Means over bins near each other.
fn smoothed(bins: &[usize], raw: &[f64]) -> Vec<f64> {
    let around = |k: usize| {
        let near =
            (0..bins.len()).skip(k.saturating_sub(SMOOTHED)).take_while(|&other| bins[other] <= bins[k] + SMOOTHED);
        let near: Vec<f64> = near.filter(|&other| bins[other] + SMOOTHED >= bins[k]).map(|other| raw[other]).collect();
        near.iter().sum::<f64>() / near.len() as f64
    };
    (0..bins.len()).map(around).collect()
}

/// Every second bin of each run of excited bins, those with more power: through Hann's window they tell all that the others do.
fn independent(bins: &[usize], input: &Spectra) -> Vec<usize> {
    let mut kept = Vec::new();
    let mut start = 0;
    while start < bins.len() {
        let end = (start + 1..bins.len()).find(|&k| bins[k] != bins[k - 1] + 1).unwrap_or(bins.len());
        let power = |from: usize| (from..end).step_by(2).map(|k| input.power(bins[k])).sum::<f64>();
        let from = if power(start) >= power(start + 1) { start } else { start + 1 };
        kept.extend((from..end).step_by(2));
        start = end;
    }
    kept
}
