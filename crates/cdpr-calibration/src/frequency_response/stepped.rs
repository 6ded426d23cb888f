//! The response by a stepped sine: at each step, sines of the input's own frequency fitted to blocks of whole cycles.

use nalgebra::{Complex, DMatrix, DVector};
use std::f64::consts::TAU;
use std::ops::Range;

use super::InputError;
use super::points::{LEAST_SIGMA, Point, Points};
use super::sampling::Even;

/// Cycles of a step at least.
const CYCLES: usize = 5;
/// Steps of a stepped sine at least.
const STEPS: usize = 4;
/// Part of the record that steps cover at least.
const COVERED: f64 = 0.8;
/// Part by which cycles of one step may differ from their mean.
const SPREAD: f64 = 0.03;
/// Part by which the mean period of a step's halves may differ; a sweep's does.
const SWEPT: f64 = 0.004;
/// Part of a step left to what the change of frequency stirs up.
const SETTLING: f64 = 0.3;
/// Blocks of a step at most.
const BLOCKS: usize = 8;
/// Neighbours to both sides over which the power of the noise is averaged.
const SMOOTHED: usize = 3;

/// Rows of one frequency.
struct Dwell {
    rows: Range<usize>,
    cycles: usize,
    /// Frequency (Hz).
    frequency: f64,
}

/// Steps of a record's input.
pub(super) struct Dwells {
    found: Vec<Dwell>,
    /// Part of the record that they cover.
    covered: f64,
}

impl Dwells {
    pub(super) fn of(even: &Even) -> Self {
        let crossings = crossings(&even.input);
        let mut found = Vec::new();
        let mut first = 0;
        while first + CYCLES < crossings.len() {
            let mut last = first + 1;
            let mean = |last: usize| (crossings[last] - crossings[first]) / (last - first) as f64;
            while last + 1 < crossings.len() {
                let period = crossings[last + 1] - crossings[last];
                // a crossing between rows is known to a part of a row
                if (period - mean(last)).abs() > SPREAD * mean(last) + 0.5 {
                    break;
                }
                last += 1;
            }
            found.extend(dwell(&crossings[first..=last], even.step));
            first = last;
        }
        let rows: usize = found.iter().map(|dwell| dwell.rows.len()).sum();
        Self { found, covered: rows as f64 / even.len() as f64 }
    }

    /// True of a record that is a stepped sine.
    pub(super) fn are_a_stepped_sine(&self) -> bool {
        self.found.len() >= STEPS && self.covered >= COVERED
    }

    /// Points at the steps' frequencies, none of them trusted yet.
    pub(super) fn points(&self, even: &Even) -> Result<Points, InputError> {
        if !self.are_a_stepped_sine() {
            return Err(InputError::NoSteps { found: self.found.len(), percent: 100.0 * self.covered });
        }
        let mut steps: Vec<Measured> = self.found.iter().filter_map(|dwell| dwell.measured(even)).collect();
        steps.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
        let all: Vec<Point> = (0..steps.len()).map(|k| point(&steps, k)).collect();
        let distance = all.windows(2).map(|pair| pair[1].frequency - pair[0].frequency).filter(|gap| *gap > 0.0);
        let resolution = distance.fold(f64::INFINITY, f64::min);
        let fitted = (0..all.len()).collect();
        Ok(Points { next: vec![Complex::default(); all.len()], fitted, resolution, all })
    }
}

/// A run of cycles as a step; `None` where there are too few, or where their length drifts as in a sweep.
fn dwell(crossings: &[f64], step: f64) -> Option<Dwell> {
    let cycles = crossings.len() - 1;
    if cycles < CYCLES {
        return None;
    }
    let mean = |part: &[f64]| (part[part.len() - 1] - part[0]) / (part.len() - 1) as f64;
    let (whole, half) = (mean(crossings), crossings.len() / 2);
    let drift = (mean(&crossings[..=half]) - mean(&crossings[half..])).abs();
    // a crossing between rows is known to a tenth of a row
    if drift > SWEPT * whole + 0.1 / half as f64 {
        return None;
    }
    let rows = crossings[0].ceil() as usize..crossings[cycles].floor() as usize;
    Some(Dwell { rows, cycles, frequency: 1.0 / (whole * step) })
}

/// Places at which a series rises through zero, in rows, each after it was clearly below and before it is clearly above.
fn crossings(series: &[f64]) -> Vec<f64> {
    let rms = (series.iter().map(|value| value * value).sum::<f64>() / series.len() as f64).sqrt();
    let (mut all, mut is_below, mut last) = (Vec::new(), false, None);
    for k in 1..series.len() {
        let (before, value) = (series[k - 1], series[k]);
        if before < 0.0 && value >= 0.0 {
            last = Some((k - 1) as f64 + before / (before - value));
        }
        if value < -0.4 * rms {
            is_below = true;
        }
        if is_below && value > 0.4 * rms {
            all.extend(last);
            is_below = false;
        }
    }
    all
}

/// Measurement of a step by its blocks.
struct Measured {
    frequency: f64,
    response: Complex<f64>,
    coherence: f64,
    blocks: usize,
    /// Sum over blocks of the input's squared amplitudes.
    input: f64,
    /// Variance of the output's amplitude in a block, times the block's length (s).
    noise: f64,
    /// Length of a block (s).
    length: f64,
}

impl Dwell {
    /// `None` where fewer than three blocks are left.
    fn measured(&self, even: &Even) -> Option<Measured> {
        let cycle = 1.0 / (self.frequency * even.step);
        let skipped = ((SETTLING * self.cycles as f64).ceil() as usize).max(1);
        let cycles = self.cycles - skipped;
        let blocks = cycles.min(BLOCKS);
        if blocks < 3 {
            return None;
        }
        let each = cycles / blocks;
        let begin = self.rows.start as f64 + skipped as f64 * cycle;
        let rows = |block: usize| {
            let [from, to] = [block, block + 1].map(|edge| (begin + (edge * each) as f64 * cycle).round() as usize);
            from..to.min(self.rows.end)
        };
        let rows: Vec<Range<usize>> = (0..blocks).map(rows).collect();
        let amplitudes = |series: &[f64]| -> Option<Vec<Complex<f64>>> {
            rows.iter().map(|rows| amplitude(series, rows.clone(), self.frequency * even.step)).collect()
        };
        let (inputs, outputs) = (amplitudes(&even.input)?, amplitudes(&even.output)?);
        let input: f64 = inputs.iter().map(Complex::norm_sqr).sum();
        let output: f64 = outputs.iter().map(Complex::norm_sqr).sum();
        let cross: Complex<f64> = inputs.iter().zip(&outputs).map(|(input, output)| input.conj() * output).sum();
        let response = cross / input;
        let left = (output - response.norm_sqr() * input).max(0.0) / (blocks - 1) as f64;
        let length = each as f64 / self.frequency;
        let coherence = (response.norm_sqr() * input / output).min(1.0);
        Some(Measured { frequency: self.frequency, response, coherence, blocks, input, noise: left * length, length })
    }
}

/// A step as a point; the noise of a block is that of the steps around it, weighed by their blocks.
fn point(steps: &[Measured], k: usize) -> Point {
    let near = &steps[k.saturating_sub(SMOOTHED)..(k + SMOOTHED + 1).min(steps.len())];
    let freedom = |step: &Measured| (step.blocks - 1) as f64;
    let noise = near.iter().map(|step| freedom(step) * step.noise).sum::<f64>() / near.iter().map(freedom).sum::<f64>();
    let step = &steps[k];
    let sigma = (0.5 * noise / step.length / step.input).sqrt().max(LEAST_SIGMA * step.response.norm());
    let Measured { frequency, response, coherence, .. } = *step;
    Point { frequency, response, coherence, sigma, is_trusted: false }
}

/// Complex amplitude of a sine in rows of a series, beside a mean and a drift; `None` where rows do not determine it.
fn amplitude(series: &[f64], rows: Range<usize>, turns_per_row: f64) -> Option<Complex<f64>> {
    let count = rows.len();
    let angle = |k: usize| TAU * turns_per_row * (rows.start + k) as f64;
    let matrix = DMatrix::from_fn(count, 4, |k, column| match column {
        0 => angle(k).cos(),
        1 => -angle(k).sin(),
        2 => 1.0,
        _ => k as f64 / count as f64 - 0.5,
    });
    let right = DVector::from_column_slice(series.get(rows.clone())?);
    let solution = (matrix.tr_mul(&matrix)).cholesky()?.solve(&matrix.tr_mul(&right));
    Some(Complex::new(solution[0], solution[1]))
}
