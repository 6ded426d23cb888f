//! A drum on a cable, and other linear machines, in time: exact for inputs that are straight between samples.

use nalgebra::{Complex, DMatrix, DVector};
use rand::RngExt;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;
use std::f64::consts::TAU;

use crate::frequency_response::Record;

/// Inertia of the drum (kg·m²), its radius (m), viscous friction (N·m·s/rad).
pub(super) const J: f64 = 1.37;
pub(super) const R: f64 = 0.1525;
pub(super) const C: f64 = 27.37;

/// x' = A x + b u, y = c x.
pub(super) struct Linear {
    pub(super) a: DMatrix<f64>,
    pub(super) b: DVector<f64>,
    pub(super) c: DVector<f64>,
}

impl Linear {
    /// J φ'' = τ − r F − c φ', F = k r φ: from torque to tension.
    pub(super) fn drum(stiffness: f64) -> Self {
        let a = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -stiffness * R * R / J, -C / J]);
        let b = DVector::from_vec(vec![0.0, 1.0 / J]);
        Self { a, b, c: DVector::from_vec(vec![stiffness * R, 0.0]) }
    }

    /// Controllable form of gain · (1 + b₁ s + …)/(1 + a₁ s + …), with fewer zeros than poles.
    pub(super) fn rational(gain: f64, above: &[f64], below: &[f64]) -> Self {
        let n = below.len();
        let last = below[n - 1];
        let mut a = DMatrix::zeros(n, n);
        (1..n).for_each(|row| a[(row - 1, row)] = 1.0);
        for column in 0..n {
            let coefficient = if column == 0 { 1.0 } else { below[column - 1] };
            a[(n - 1, column)] = -coefficient / last;
        }
        let mut b = DVector::zeros(n);
        b[n - 1] = 1.0 / last;
        let c = DVector::from_fn(n, |k, _| gain * if k == 0 { 1.0 } else { *above.get(k - 1).unwrap_or(&0.0) });
        Self { a, b, c }
    }

    /// Output at samples `step` apart from rest on, by the matrix exponential of state, input and its slope.
    pub(super) fn answer(&self, input: &[f64], step: f64) -> Vec<f64> {
        let n = self.b.len();
        let mut block = DMatrix::zeros(n + 2, n + 2);
        block.view_mut((0, 0), (n, n)).copy_from(&(&self.a * step));
        block.view_mut((0, n), (n, 1)).copy_from(&(&self.b * step));
        block[(n, n + 1)] = 1.0;
        let next = block.exp();
        let mut state = DVector::zeros(n + 2);
        let mut output = Vec::with_capacity(input.len());
        for k in 0..input.len() {
            output.push(state.rows(0, n).dot(&self.c));
            state[n] = input[k];
            state[n + 1] = input.get(k + 1).unwrap_or(&input[k]) - input[k];
            state = &next * state;
        }
        output
    }
}

/// How a record is driven and kept.
pub(super) struct Drive {
    /// Kept samples, and their distance (s).
    pub(super) samples: usize,
    pub(super) step: f64,
    /// Steps of the simulation from one kept sample to the next.
    pub(super) inside: usize,
}

impl Drive {
    pub(super) fn seconds(samples: usize, step: f64) -> Self {
        Self { samples, step, inside: 8 }
    }

    /// Record of a machine without noise under a torque that is a function of time; the output comes `late` inner steps later.
    pub(super) fn record(&self, machine: &Linear, torque: impl Fn(f64) -> f64, late: usize) -> Record {
        let fine = self.step / self.inside as f64;
        let input: Vec<f64> = (0..self.samples * self.inside).map(|k| torque(k as f64 * fine)).collect();
        let output = machine.answer(&input, fine);
        let kept = |k: usize| k * self.inside;
        Record {
            times: (0..self.samples).map(|k| k as f64 * self.step).collect(),
            input: (0..self.samples).map(|k| input[kept(k)]).collect(),
            output: (0..self.samples).map(|k| if kept(k) >= late { output[kept(k) - late] } else { 0.0 }).collect(),
        }
    }
}

/// A sweep from one frequency to another (Hz), faster and faster by the same factor, and back.
pub(super) fn chirp(from: f64, to: f64, duration: f64) -> impl Fn(f64) -> f64 {
    let half = 0.5 * duration;
    let rate = (to / from).ln() / half;
    let turns = move |t: f64| from * ((rate * t).exp() - 1.0) / rate;
    move |t| {
        let phase = if t < half { turns(t) } else { 2.0 * turns(half) - turns(duration - t) };
        (TAU * phase).sin()
    }
}

/// A sum of sines at multiples of a frequency (Hz), with phases that keep it low.
pub(super) fn multisine(base: f64, count: usize) -> impl Fn(f64) -> f64 {
    move |t| {
        let term = |k: usize| {
            let phase = -std::f64::consts::PI * (k * (k - 1)) as f64 / count as f64;
            (TAU * base * k as f64 * t + phase).cos()
        };
        (1..=count).map(term).sum::<f64>() * (2.0 / count as f64).sqrt()
    }
}

/// The record with white noise on its output.
pub(super) fn noisy(record: &Record, sigma: f64, seed: u64) -> Record {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut record = record.clone();
    for value in &mut record.output {
        let noise: f64 = random.sample(StandardNormal);
        *value += sigma * noise;
    }
    record
}

/// G(s) = k r/(J s² + c s + k r²) in closed form: its figures.
pub(super) struct ClosedForm {
    pub(super) stiffness: f64,
}

impl ClosedForm {
    fn natural(&self) -> (f64, f64) {
        let omega = R * (self.stiffness / J).sqrt();
        (omega, C / (2.0 * J * omega))
    }

    /// Frequency (Hz) at which |G| is √½ of its value at a lower frequency; of that at 0 in the textbook.
    pub(super) fn cutoff(&self, reference: f64) -> f64 {
        let (omega, zeta) = self.natural();
        // |G|⁻² is quadratic in u = (ω/ω₀)²: (1 − u)² + 4 ζ² u
        let v = (TAU * reference / omega).powi(2);
        let wanted = 2.0 * ((1.0 - v).powi(2) + 4.0 * zeta * zeta * v);
        let p = 1.0 - 2.0 * zeta * zeta;
        omega / TAU * (p + (p * p - 1.0 + wanted).sqrt()).sqrt()
    }

    /// Frequency (Hz) and gain of the peak.
    pub(super) fn peak(&self) -> (f64, f64) {
        let (omega, zeta) = self.natural();
        (omega / TAU * (1.0 - 2.0 * zeta * zeta).sqrt(), 1.0 / (R * 2.0 * zeta * (1.0 - zeta * zeta).sqrt()))
    }

    pub(super) fn pole(&self) -> Complex<f64> {
        let (omega, zeta) = self.natural();
        Complex::new(-zeta * omega, omega * (1.0 - zeta * zeta).sqrt())
    }
}
