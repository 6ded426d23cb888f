//! Every held pose of a log is found, without rows of the motion between them.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};

use super::*;
use crate::geometry::Pose;

/// A log of a platform that stands at places for two seconds each, with smooth motions of three seconds between them.
struct Course {
    places: usize,
    /// Standard deviation of positions, resolution of lengths (m).
    noise: f64,
    resolution: f64,
    /// Drift of the tracker (m/s).
    drift: f64,
    /// Amplitude of a swing that dies out in 2.5 s, after each motion (m).
    swing: f64,
    rate: f64,
    seed: u64,
}

impl Default for Course {
    fn default() -> Self {
        Self { places: 16, noise: 1e-3, resolution: 1e-4, drift: 0.0, swing: 0.0, rate: 50.0, seed: 1 }
    }
}

const HOLD: f64 = 2.0;
const WAY: f64 = 3.0;
const ANCHORS: [[f64; 3]; 4] = [[-5.0, -7.0, 6.0], [5.0, -7.0, 6.0], [5.0, 7.0, 6.0], [-5.0, 7.0, -1.0]];

fn place(k: f64) -> Vector3<f64> {
    Vector3::new((1.7 * k).sin(), 1.5 * (2.3 * k).cos(), 1.5 + 0.4 * (0.9 * k).sin())
}

impl Course {
    /// Commanded position, and the time since the platform came to rest there (s).
    fn at(&self, time: f64) -> (Vector3<f64>, Option<f64>) {
        let (lap, within) = ((time / (HOLD + WAY)).floor(), time % (HOLD + WAY));
        let fraction = ((within - HOLD) / WAY).clamp(0.0, 1.0);
        let smooth = 0.5 * (1.0 - (std::f64::consts::PI * fraction).cos());
        (place(lap) + (place(lap + 1.0) - place(lap)) * smooth, (within <= HOLD).then_some(within))
    }

    fn samples(&self) -> Samples {
        let mut random = rand_chacha::ChaCha8Rng::seed_from_u64(self.seed);
        let mut noise = move || (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0;
        let (mut samples, mut times) = (Samples { cable_count: 4, ..Samples::default() }, Vec::new());
        let whole = self.places as f64 * (HOLD + WAY) - WAY;
        for row in 0..=(whole * self.rate) as usize {
            let time = row as f64 / self.rate;
            let (meant, since) = self.at(time);
            let swing = since.map_or(0.0, |since| self.swing * (-0.4 * since).exp() * (17.3 * since).sin());
            let seen = meant + Vector3::new(swing + self.drift * time, 0.0, 0.0);
            let position = seen + Vector3::new(noise(), noise(), noise()) * self.noise;
            samples.poses.push(Pose { position, ..Pose::identity() });
            for anchor in ANCHORS {
                let length = (Vector3::from(anchor) - meant).norm();
                samples.lengths.push((length / self.resolution).round() * self.resolution);
            }
            times.push(time);
        }
        samples.time = Some(times);
        samples
    }

    /// Asserts that every place is found, without a row of motion beyond a row's noise of 1 mm, and without motion in
    /// its mean.
    fn check(&self) {
        let samples = self.samples();
        let times = samples.time.clone().unwrap();
        let holds = Log::new(&samples, &times, 20.0).holds();
        assert_eq!(holds.len(), self.places, "seed {}: {holds:?}", self.seed);
        for (k, rows) in holds.iter().enumerate() {
            let here = place(k as f64);
            let begin = k as f64 * (HOLD + WAY);
            for row in rows.clone() {
                let moved = (self.at(times[row]).0 - here).norm();
                assert!(moved < 1e-3, "seed {} place {k}: {moved} m at {} s of a hold", self.seed, times[row] - begin);
            }
            let mean = rows.clone().map(|row| self.at(times[row]).0 - here).sum::<Vector3<f64>>() / rows.len() as f64;
            assert!(mean.norm() < 5e-5, "seed {} place {k}: {mean}", self.seed);
            // of a swing that dies out only the quiet part
            let least = if self.swing > 0.0 { 0.42 } else { 0.8 } * HOLD;
            assert!(times[rows.end - 1] - times[rows.start] > least, "seed {} place {k}: {rows:?}", self.seed);
        }
    }
}

#[test]
fn every_place_is_found_and_its_rows_have_no_motion() {
    (0..20).for_each(|seed| Course { seed, ..Course::default() }.check());
}

#[test]
fn noise_drift_and_swings_hide_no_place() {
    for seed in 0..5 {
        Course { noise: 5e-3, seed, ..Course::default() }.check();
        Course { noise: 0.0, resolution: 1e-9, seed, ..Course::default() }.check();
        Course { drift: 1e-4, seed, ..Course::default() }.check();
        Course { swing: 2e-3, seed, ..Course::default() }.check();
        Course { swing: 15e-3, seed, ..Course::default() }.check();
        Course { rate: 20.0, seed, ..Course::default() }.check();
        Course { rate: 250.0, seed, ..Course::default() }.check();
    }
}
