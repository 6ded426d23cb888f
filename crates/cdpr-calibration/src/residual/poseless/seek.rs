//! Search for the poses of all samples from several places each, so that none ends where a platform is upside down.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::search::Found;
use super::{PoselessResidual, guess};
use cdpr_model::equilibrium::restart_poses;
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::Model;

/// Other poses of the forward problem that a doubtful sample is sought from.
const RESTARTS: usize = 24;
/// Orientations that it is sought from besides.
const ORIENTATIONS: usize = 40;
/// Their seed: the same robot and lengths give the same poses.
const SEED: u64 = 40;
/// Quantiles of the normal distribution: the 99.9 % point, beyond which a sample's squares are doubtful beside the median sample's.
const BEYOND: f64 = 3.090_232;
const MEDIAN: f64 = 0.0;
/// Share of a sample's squares below which another pose is a better one, and the least difference of squares that is told from rounding (σ²).
const BETTER: f64 = 0.999;
const TOLD: f64 = 1e-12;
/// Samples from which on their median tells their scale; fewer are held against the accuracy, too.
const MANY: usize = 8;

impl PoselessResidual<'_> {
    /// The best pose of every sample: from the one found last, the guess, and the poses of the samples before and behind it; of doubtful samples from those
    /// that the forward problem tries besides, and from orientations of all kinds. `None` if a sample has none.
    pub(super) fn seek(&mut self, model: &Model, values: &[f64]) -> Option<Vec<Pose>> {
        let recorded = self.recorded(model, values)?;
        let from = |sample: usize, pose: &Pose| {
            self.search(model, &recorded, sample)
                .find(pose, &self.directions[sample])
                .filter(|found| found.square.is_finite())
        };
        let mut best: Vec<Option<Found>> = vec![None; self.samples];
        for sample in 0..self.samples {
            let last = self.are_sought.then(|| self.base[sample]);
            let before = sample.checked_sub(1).and_then(|before| Some(self.placed(sample, &best[before]?.pose)));
            let starts = last.into_iter().chain([self.guesses[sample]]).chain(before.filter(|_| self.turns()));
            best[sample] = starts.filter_map(|start| from(sample, &start)).fold(None, better);
        }
        for sample in (0..self.samples.saturating_sub(1)).rev().filter(|_| self.turns()) {
            let behind = best[sample + 1].and_then(|behind| from(sample, &self.placed(sample, &behind.pose)));
            best[sample] = behind.into_iter().fold(best[sample], better);
        }
        let squares: Vec<f64> = best.iter().map(|found| found.map_or(f64::INFINITY, |found| found.square)).collect();
        let scale = self.scale_of(&squares);
        for sample in 0..self.samples {
            if squares[sample] > scale * self.expected(sample, BEYOND) {
                let around = best[sample].map_or(self.guesses[sample], |found| found.pose);
                let starts = self.scattered(model, sample, &around);
                best[sample] = starts.iter().filter_map(|start| from(sample, start)).fold(best[sample], better);
            }
        }
        let mut poses: Vec<Pose> = best.into_iter().map(|found| Some(found?.pose)).collect::<Option<_>>()?;
        poses.extend_from_slice(&self.guesses[self.samples..]);
        Some(poses)
    }

    /// Takes poses that fit better than those found last; true where there was one. A point has no orientation to be mistaken in.
    pub(super) fn find_better(&mut self, values: &[f64]) -> Option<bool> {
        if !self.turns() {
            return None;
        }
        let model = self.model.with_parameters(self.parameters, values)?;
        self.poses = self.find(&model, values)?;
        self.take_for_base();
        let recorded = self.recorded(&model, values)?;
        let square = |vectors: &Self, pose: &Pose, sample: usize| {
            Some(vectors.search(&model, &recorded, sample).find(pose, &[])?.square)
        };
        let before: Vec<f64> =
            (0..self.samples).map(|sample| square(self, &self.poses[sample], sample)).collect::<Option<_>>()?;
        let poses = self.seek(&model, values)?;
        let mut is_better = false;
        for sample in 0..self.samples {
            let there = square(self, &poses[sample], sample)?;
            if there < BETTER * before[sample] && before[sample] - there > TOLD {
                self.poses[sample] = poses[sample];
                is_better = true;
            }
        }
        self.take_for_base();
        Some(is_better)
    }

    /// True for robots that turn.
    fn turns(&self) -> bool {
        self.model.twist_basis().iter().any(|twist| twist.fixed_rows::<3>(3) != Vector3::zeros())
    }

    /// A pose with what is known of a sample's.
    fn placed(&self, sample: usize, pose: &Pose) -> Pose {
        guess(&self.model, &self.guesses[sample], &self.known[sample], pose)
    }

    /// Squares of a sample at a point of the normal distribution, by the cube of Wilson and Hilferty (1931), of noise as large as the accuracy.
    fn expected(&self, sample: usize, point: f64) -> f64 {
        let freedom = self.model.cable_count().saturating_sub(self.directions[sample].len()) as f64;
        let spread = 2.0 / (9.0 * freedom.max(1.0));
        freedom.max(1.0) * (1.0 - spread + point * spread.sqrt()).powi(3)
    }

    /// Squares of the median sample, in units of those that its degrees of freedom let expect.
    fn scale_of(&self, squares: &[f64]) -> f64 {
        let own = |(sample, square): (usize, &f64)| square / self.expected(sample, MEDIAN);
        let mut scales: Vec<f64> = squares.iter().enumerate().map(own).filter(|scale| scale.is_finite()).collect();
        scales.sort_by(f64::total_cmp);
        let median = scales.get(scales.len() / 2).copied().unwrap_or(1.0);
        let scale = if squares.len() < MANY { median.min(1.0) } else { median };
        scale.max(TOLD)
    }

    /// Starts of a doubtful sample around a pose.
    fn scattered(&self, model: &Model, sample: usize, around: &Pose) -> Vec<Pose> {
        let mut generator = ChaCha8Rng::seed_from_u64(SEED);
        let others = restart_poses(model, around).take(RESTARTS).map(|pose| self.placed(sample, &pose));
        let turns: Vec<&Twist> =
            self.directions[sample].iter().filter(|twist| twist.fixed_rows::<3>(3) != Vector3::zeros()).collect();
        let mut turned = || {
            let amount = |twist: &&Twist| *twist * generator.random_range(-std::f64::consts::PI..std::f64::consts::PI);
            around.displaced(&turns.iter().map(amount).sum())
        };
        let count = if turns.is_empty() { 0 } else { ORIENTATIONS };
        let turned: Vec<Pose> = (0..count).map(|_| turned()).collect();
        others.chain(turned).collect()
    }
}

/// The better of two poses; the one that was found first where they fit as well.
fn better(best: Option<Found>, other: Found) -> Option<Found> {
    match best {
        Some(best) if !(other.square < BETTER * best.square) => Some(best),
        _ => Some(other),
    }
}
