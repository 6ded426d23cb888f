//! Other places for samples whose sensors agree far worse than those of the others: a search may have ended where a platform is turned over.

use super::{RowsOf, SensorResidual, Settled};
use crate::norms::median;
use cdpr_model::equilibrium::restart_poses;
use cdpr_model::model::Model;

/// Squares of a sample, beside those of the median sample, from which on it is doubtful.
const DOUBTFUL: f64 = 10.0;
/// Poses of the forward problem that a doubtful sample is sought from, besides those of its neighbours.
const RESTARTS: usize = 24;
/// Share of a sample's squares below which another place is a better one.
const BETTER: f64 = 0.9;

impl SensorResidual<'_> {
    /// Takes better places of doubtful samples than those found last at these values; true where there was one, `None` if the model has no rows there.
    pub(super) fn find_better(&mut self, values: &[f64]) -> Option<bool> {
        let model = self.model.with_parameters(self.parameters, values)?;
        let load = self.load(&model)?;
        let mut is_better = false;
        let mut ends = Vec::with_capacity(self.found.len());
        for sample in 0..self.found.len() {
            let rows = self.rows_of(&model, load, sample);
            ends.push(self.sensors().settle(&rows.bare, sample, &self.found[sample])?);
        }
        let limit = DOUBTFUL * median(&mut ends.iter().map(|end| end.square).collect::<Vec<f64>>());
        for sample in (0..ends.len()).filter(|&sample| ends[sample].square > limit) {
            let rows = self.rows_of(&model, load, sample);
            let best = self.best_of(&rows, &model, sample, &ends);
            if let Some(best) = best.filter(|best| best.square < BETTER * ends[sample].square) {
                self.found[sample] = best.latent;
                is_better = true;
            }
        }
        Some(is_better)
    }

    /// The best end of searches from the poses of the neighbours, from the guess, and from those that the forward problem tries.
    fn best_of(&self, rows: &RowsOf<'_>, model: &Model, sample: usize, ends: &[Settled]) -> Option<Settled> {
        let own = &self.found[sample];
        let neighbours = [sample.checked_sub(1), Some(sample + 1)].into_iter().flatten().filter_map(|k| ends.get(k));
        let near = neighbours.map(|end| end.latent.pose).chain([self.guesses[sample].pose]);
        let starts = near.chain(restart_poses(model, &own.pose).take(RESTARTS));
        let from = |pose| self.sensors().settle(&rows.bare, sample, &self.placed(sample, &pose));
        starts.filter_map(from).filter(|end| end.is_least).reduce(Settled::better)
    }
}
