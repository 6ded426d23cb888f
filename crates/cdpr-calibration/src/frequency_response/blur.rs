//! What windows do to a response: the estimate that a known machine would give, less its true response.
//!
//! A window sees the answer to what happened before it, and averages the response over its resolution. Near a light resonance that is more
//! than noise leaves. The fitted function driven by the recorded input has the same blur, so that it can be taken off and the fit repeated.

use nalgebra::Complex;
use rustfft::FftPlanner;

use super::points::Point;
use super::sampling::{Even, without_drift};
use super::transfer::Transfer;
use super::windowed::{Spectra, Windows};

/// Blur at each point, where a transfer function answers the record's input.
pub(super) fn blur(even: &Even, windows: &Windows, input: &Spectra, points: &[Point], transfer: &Transfer) -> Vec<Complex<f64>> {
    let answer = windows.spectra(&without_drift(answered(even, transfer)));
    let resolution = windows.resolution(even.step);
    let bin = |point: &Point| (point.frequency / resolution).round() as usize;
    points.iter().map(|point| input.response(&answer, bin(point)) - transfer.response(point.frequency)).collect()
}

/// Answer of a transfer function at rest to the input of a record.
fn answered(even: &Even, transfer: &Transfer) -> Vec<f64> {
    let count = even.len();
    // as many zeros behind the record as rows, so that its end does not answer before its beginning
    let length = (2 * count).next_power_of_two();
    let mut planner = FftPlanner::new();
    let mut bins: Vec<Complex<f64>> = even.input.iter().map(|value| Complex::from(*value)).collect();
    bins.resize(length, Complex::default());
    planner.plan_fft_forward(length).process(&mut bins);
    let distance = 1.0 / (length as f64 * even.step);
    for k in 0..=length / 2 {
        let response = transfer.response(k as f64 * distance);
        bins[k] *= response;
        if 0 < k && k < length / 2 {
            bins[length - k] *= response.conj();
        }
    }
    planner.plan_fft_inverse(length).process(&mut bins);
    bins.iter().take(count).map(|value| value.re / length as f64).collect()
}
