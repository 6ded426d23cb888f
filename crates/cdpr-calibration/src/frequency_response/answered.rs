//! Answer of a transfer function to the input of a record.

use nalgebra::Complex;
use rustfft::FftPlanner;

use super::sampling::{Even, without_drift};
use super::transfer::Transfer;

/// The record's output less what a transfer function, at rest before, answers to its input.
pub(super) fn remainder(even: &Even, transfer: &Transfer) -> Vec<f64> {
    let answer = without_drift(answered(even, transfer));
    even.output.iter().zip(answer).map(|(output, answer)| output - answer).collect()
}

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
