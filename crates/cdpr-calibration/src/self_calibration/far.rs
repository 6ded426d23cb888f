//! Samples that no pose explains, by what their poses and the parameters leave of their residuals.

use super::internal::Sensing;
use super::question::Question;
use super::written::Written;
use crate::norms::{Extent, Norms};

/// Rows of a sample that poses and parameters have to leave, for it to be judged.
const LEAST_LEFT: f64 = 0.5;

/// A sample beyond what noise explains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Far {
    pub(super) sample: usize,
    /// Robust standard deviations.
    pub(super) deviations: f64,
}

impl Question<'_> {
    /// Samples beyond 8 robust deviations by their residuals over the root of what poses and parameters leave of them; none where other sensors than lengths are rows,
    /// of which a pose whose search ended on the way would be one.
    pub(super) fn far(&self, end: &Written) -> Vec<Far> {
        if matches!(self.sensing, Sensing::All(..)) {
            return Vec::new();
        }
        let (size, samples) = (end.rows.size(), end.poses.len());
        let by_parameters = end.by_parameters();
        let left = |sample: usize| -> f64 {
            let rows = sample * size..(sample + 1) * size;
            let by_pose = self.internal.known[sample].iter().filter(|known| !**known).count() as f64;
            size as f64 - by_pose - by_parameters[rows].iter().sum::<f64>()
        };
        let judged: Vec<(usize, f64)> =
            (0..samples).map(|sample| (sample, left(sample))).filter(|(_, left)| *left > LEAST_LEFT).collect();
        if judged.is_empty() {
            return Vec::new();
        }
        let mean = judged.iter().map(|(_, left)| left).sum::<f64>() / judged.len() as f64;
        let dimension = mean.round().max(1.0);
        let squares = judged.iter().map(|(sample, left)| end.rows.square(*sample) * dimension / left).collect();
        let rows = judged.len() * dimension as usize;
        let norms = Norms::new(squares, None, Extent { rows, parameters: 0, absolute: self.are_stated() });
        let far = |place: usize| Far { sample: judged[place].0, deviations: norms.deviations(place) };
        norms.outliers().map(far).collect()
    }
}
