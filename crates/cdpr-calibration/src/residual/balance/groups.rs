//! Rows of an elastic model at its optimum, as its analysis takes them.

use super::BalanceResidual;
use super::noise::SLACK_SIGMA;
use super::rows::{RowModel, SampleRows, first_columns};
use crate::fit::InputError;
use crate::residual::rows::GroupRows;
use cdpr_model::model::Model;
use cdpr_model::scalar::TriangularFactor;
use cdpr_model::statics::Load;
use nalgebra::DMatrix;

impl BalanceResidual<'_> {
    /// All rows of the model at its optimum.
    pub(super) fn group_rows(&self, calibrated: &Model) -> Result<Vec<GroupRows>, InputError> {
        let Self { samples, parameters, at, .. } = self;
        let row_model = RowModel::new(calibrated, Load::of(calibrated.robot())?, parameters);
        let mut rows = SampleRows::new(calibrated, parameters.len());
        let [mut plain, mut weighted] = [(); 2].map(|()| TriangularFactor::new(parameters.len()));
        // a length knows the parameters of its own cable only: few columns, whose factor joins at the end
        let first = first_columns(calibrated, parameters);
        let own = |cable: usize| first[cable]..first[cable + 1];
        let mut of_lengths: Vec<_> =
            (0..samples.cable_count).map(|cable| TriangularFactor::new(own(cable).len())).collect();
        let wrench_rows = rows.count - samples.cable_count;
        let mut residuals = vec![Vec::with_capacity(samples.len()); rows.count];
        let mut all = Vec::with_capacity(samples.len() * rows.count * parameters.len());
        for sample in 0..samples.len() {
            at.write(&row_model, samples, sample, &mut rows);
            rows.derivatives().take(wrench_rows).for_each(|row| plain.push(row.iter().copied()));
            for (cable, (row, factor)) in rows.derivatives().skip(wrench_rows).zip(&mut of_lengths).enumerate() {
                factor.push(row[own(cable)].iter().copied());
            }
            at.whiten(sample, &mut rows);
            for row in rows.derivatives() {
                weighted.push(row.iter().copied());
                all.extend_from_slice(row);
            }
            residuals.iter_mut().enumerate().for_each(|(row, residuals)| residuals.push(rows.residual(row)));
        }
        for (cable, factor) in of_lengths.into_iter().enumerate() {
            let columns = own(cable);
            for row in factor.into_matrix().row_iter() {
                let entry = |k: usize| if columns.contains(&k) { row[k - columns.start] } else { 0.0 };
                plain.push((0..parameters.len()).map(entry));
            }
        }
        let (count, cables) = (samples.len() * residuals.len(), 0..samples.cable_count);
        let group = GroupRows {
            parameters: 0..parameters.len(),
            cables,
            count,
            plain,
            conventions: 0,
            weighted,
            weighted_rows: DMatrix::from_row_slice(count, parameters.len(), &all),
            series: residuals,
        };
        Ok(vec![group])
    }

    /// 1/σ of every row over the samples, 0 for the length rows of slack cables.
    pub(super) fn all_row_weights(&self) -> Vec<Vec<f64>> {
        let Self { samples, at, noise, .. } = self;
        let mut weights = vec![Vec::with_capacity(samples.len()); self.size()];
        let least = 1.0 / (SLACK_SIGMA * noise);
        for sample in 0..samples.len() {
            for (row, deviation) in at.deviations(sample).enumerate() {
                let weight = 1.0 / deviation;
                weights[row].push(if weight > least { weight } else { 0.0 });
            }
        }
        weights
    }
}
