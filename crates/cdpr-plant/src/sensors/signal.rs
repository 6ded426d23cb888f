//! Components of all sensors: clock, noise, low-pass and resolution.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// Times that differ by less than this are equal (s).
const SAME_TIME: f64 = 1e-9;

/// Times at which a sensor is read: the first step at or after each multiple of its interval.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Clock {
    interval: f64,
    next: u64,
}

impl Clock {
    pub(super) fn new(rate: f64) -> Self {
        Self { interval: 1.0 / rate, next: 0 }
    }

    /// Count of readings per second.
    pub(super) fn rate(&self) -> f64 {
        1.0 / self.interval
    }

    /// True if the sensor is read at a time.
    pub(super) fn is_due(&mut self, time: f64) -> bool {
        let due = time + SAME_TIME >= self.next as f64 * self.interval;
        if due {
            // steps longer than the interval skip the readings between
            self.next = ((time + SAME_TIME) / self.interval).floor() as u64 + 1;
        }
        due
    }
}

/// Normal noise of one sensor.
#[derive(Clone, Debug)]
pub(super) struct Noise(pub(super) ChaCha8Rng);

impl Noise {
    pub(super) fn new(seed: u64, stream: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(stream);
        Self(random)
    }

    /// A normally distributed number with this standard deviation.
    pub(super) fn of(&mut self, sigma: f64) -> f64 {
        let normal: f64 = StandardNormal.sample(&mut self.0);
        sigma * normal
    }
}

/// A low-pass of first order, updated with its input at the end of every step.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LowPass {
    /// Cut-off frequency (Hz); without one the input passes unchanged.
    cut_off: Option<f64>,
    /// Output and input at the end of the last step.
    last: Option<[f64; 2]>,
}

impl LowPass {
    pub(super) fn new(cut_off: Option<f64>) -> Self {
        Self { cut_off, last: None }
    }

    /// Updates the filter with an input that went on a line from its last value to this one over a time (s): exact for it, u₁ − (u₁ − u₀) (1 − e⁻ˣ)/x
    /// + (y₀ − u₀) e⁻ˣ with x = ω t.
    pub(super) fn pass(&mut self, input: f64, time: f64) {
        let output = match (self.cut_off, self.last) {
            (Some(cut_off), Some([output, before])) => {
                let angle = std::f64::consts::TAU * cut_off * time;
                let faded = -(-angle).exp_m1();
                let lag = if angle > 0.0 { faded / angle } else { 1.0 };
                input - (input - before) * lag + (output - before) * (1.0 - faded)
            }
            _ => input,
        };
        self.last = Some([output, input]);
    }

    /// Present output; 0 before any input.
    pub(super) fn output(&self) -> f64 {
        self.last.map_or(0.0, |last| last[0])
    }
}

/// The nearest whole multiple of a resolution; the value itself if the resolution is 0.
pub(super) fn counted(value: f64, resolution: f64) -> f64 {
    if resolution > 0.0 { (value / resolution).round() * resolution } else { value }
}
