//! Errors of modelled lengths at what was measured.

use super::balance::rows::{RowModel, SampleRows};
use crate::recorded::Recorded;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::statics::Load;

/// Modelled minus recorded lengths of a sample (from 0) at its measured pose, of elastic models at its measured tensions (m).
pub(crate) fn length_errors(model: &Model, samples: &Samples, sample: usize) -> Vec<f64> {
    if model.needs_tensions() {
        return of_elastic(model, samples, sample);
    }
    let modelled = |cable: usize| {
        let path = model.path(cable, &samples.poses[sample]);
        path.map_or(f64::NAN, |(path, _)| model.recorded_length(cable, path.length))
    };
    samples.lengths_of(sample).iter().enumerate().map(|(cable, recorded)| modelled(cable) - recorded).collect()
}

/// The same of an elastic model; empty if load or tensions are unknown.
fn of_elastic(model: &Model, samples: &Samples, sample: usize) -> Vec<f64> {
    let (Ok(load), Some(tensions)) = (Load::of(model.robot()), &samples.tensions) else { return Vec::new() };
    let m = samples.cable_count;
    let mut rows = SampleRows::new(model, 0);
    let tensions = &tensions[sample * m..][..m];
    RowModel::new(model, load, &[]).write(&samples.poses[sample], tensions, Recorded::of(samples, sample), &mut rows);
    (0..m).map(|cable| rows.residual(rows.count - m + cable)).collect()
}
