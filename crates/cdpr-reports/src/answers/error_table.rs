//! Error blocks side by side, for people: mm, degrees, N.

use cdpr_calibration::ErrorBlocks;
use cdpr_model::control::{LengthErrorStatistics, PoseErrorStatistics, TensionErrorStatistics};
use cdpr_model::geometry::MotionPattern;

use crate::number_format::{NONE, cell, decimals_for, significant};
use crate::table::Table;

/// Source of the errors, which tells how many of their digits mean something.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Source {
    /// Exact answers at chosen poses.
    Model,
    /// Samples: no digits finer than the standard error of the mean.
    Measurements,
}

/// Names of statistics with their values.
pub(crate) type Statistics = Vec<(&'static str, f64)>;

/// Statistics over poses.
pub(crate) fn of_poses(error: &PoseErrorStatistics) -> Statistics {
    let PoseErrorStatistics { mean, rms, median, p95, max } = *error;
    vec![("mean", mean), ("rms", rms), ("median", median), ("p95", p95), ("max", max)]
}

/// Statistics over poses and cables.
pub(crate) fn of_lengths(error: &LengthErrorStatistics) -> Statistics {
    let LengthErrorStatistics { mean_abs, rms, p95, max } = *error;
    vec![("mean", mean_abs), ("rms", rms), ("p95", p95), ("max", max)]
}

/// Statistics of tensions.
pub(crate) fn of_tensions(error: &TensionErrorStatistics) -> Statistics {
    let TensionErrorStatistics { mean_norm, mean_abs, rms, max } = *error;
    vec![("mean norm", mean_norm), ("mean", mean_abs), ("rms", rms), ("max", max)]
}

/// Value of the statistic of a name; `None` if there is no such statistic.
pub(crate) fn named(statistics: &Statistics, name: &str) -> Option<f64> {
    statistics.iter().find(|(own, _)| *own == name).map(|(_, value)| *value)
}

/// Quantity that errors are of, with its unit for people.
pub(crate) struct Quantity {
    /// Word in tables.
    pub(crate) name: &'static str,
    /// Unit for people.
    pub(crate) unit: &'static str,
    /// From SI units to this one.
    pub(crate) factor: f64,
    decimals: usize,
    /// Its statistics in SI units; `None` if the model knows none, or the data have none.
    pub(crate) read: fn(&ErrorBlocks) -> Option<Statistics>,
}

impl Quantity {
    /// A statistic in the unit for people; a dash for none.
    pub(super) fn cell(&self, value: Option<f64>) -> String {
        cell(value.map(|value| self.factor * value), self.decimals)
    }
}

/// All quantities, in the order of tables: position, rotation, length, tension, swivel.
pub(crate) fn quantities() -> [Quantity; 5] {
    let degrees = 1.0_f64.to_degrees();
    let quantity = |name, unit, factor, decimals, read| Quantity { name, unit, factor, decimals, read };
    [
        quantity("position", "mm", 1e3, 3, |blocks| Some(of_poses(&blocks.position_error_m))),
        quantity("rotation", "°", degrees, 4, |blocks| Some(of_poses(&blocks.rotation_error_rad))),
        quantity("length", "mm", 1e3, 3, |blocks| Some(of_lengths(&blocks.length_error_m))),
        quantity("tension", "N", 1.0, 1, |blocks| blocks.tension_error.as_ref().map(of_tensions)),
        quantity("swivel", "°", degrees, 4, |blocks| blocks.swivel_error.as_ref().map(of_lengths)),
    ]
}

/// A table with a column for each block and a row for each statistic; rotations only where the platform can turn.
pub(super) fn error_table(
    pattern: MotionPattern,
    columns: &[(&str, &ErrorBlocks)],
    source: Source,
    width: Option<usize>,
) -> String {
    let mut heading = vec!["error".to_owned(), "of".to_owned(), "unit".to_owned()];
    heading.extend(columns.iter().map(|(name, _)| (*name).to_owned()));
    let mut table = Table::with_heading(heading).left_column(1).left_column(2);
    let shown = |quantity: &Quantity| quantity.name != "rotation" || pattern.has_rotation();
    for mut quantity in quantities().into_iter().filter(shown) {
        let read: Vec<Option<Statistics>> = columns.iter().map(|(_, blocks)| (quantity.read)(blocks)).collect();
        let sigmas = columns.iter().zip(&read).filter_map(|((_, blocks), own)| {
            Some(quantity.factor * standard_error(blocks.samples, own.as_ref()?)).filter(|sigma| *sigma > 0.0)
        });
        if let Some(sigma) = sigmas.reduce(f64::min).filter(|_| source == Source::Measurements) {
            quantity.decimals = quantity.decimals.min(decimals_for(Some(sigma)) as usize);
        }
        for (index, (name, _)) in read.iter().flatten().next().into_iter().flatten().enumerate() {
            let first = if index == 0 { quantity.name } else { "" };
            let values = read.iter().map(|own| quantity.cell(own.as_ref().map(|own| own[index].1)));
            let words = [first, name, quantity.unit].map(str::to_owned);
            table.row(words.into_iter().chain(values).collect());
        }
    }
    table.text(width)
}

/// Errors in a row for each quantity, of which the mean is shown (of lengths the root mean square).
pub(super) fn headline_errors(
    pattern: MotionPattern,
    columns: &[(&str, &ErrorBlocks)],
    width: Option<usize>,
) -> String {
    let mut heading = vec!["error".to_owned()];
    heading.extend(columns.iter().map(|(name, _)| (*name).to_owned()));
    let mut table = Table::with_heading(heading);
    for quantity in quantities() {
        let statistic = if quantity.name == "length" { "rms" } else { "mean" };
        let value =
            |blocks: &ErrorBlocks| named(&(quantity.read)(blocks)?, statistic).filter(|value| value.is_finite());
        let values: Vec<Option<f64>> = columns.iter().map(|(_, blocks)| value(blocks)).collect();
        let is_shown = quantity.name != "rotation" || pattern.has_rotation();
        if is_shown && values.iter().any(Option::is_some) {
            let cells = values
                .iter()
                .map(|value| value.map_or_else(|| NONE.to_owned(), |value| significant(quantity.factor * value, 3)));
            table.row([format!("{} {statistic} {}", quantity.name, quantity.unit)].into_iter().chain(cells).collect());
        }
    }
    table.text(width)
}

/// One remark for samples whose forward problem has no answer; empty when all have one.
pub(super) fn convergence_remark(blocks: &ErrorBlocks, what: &str) -> Option<String> {
    let ErrorBlocks { samples, answered, not_converged, .. } = blocks;
    (*not_converged > 0).then(|| {
        let rest = match answered {
            0 => "there is no error of the pose to tell".to_owned(),
            _ => format!("errors of the pose are those of the other {answered}"),
        };
        format!("the forward problem of {not_converged} of {samples} {what} has no answer; {rest}")
    })
}

/// Standard error of the mean of a quantity over so many samples, by its mean and its root mean square; of samples whose cables err alike.
fn standard_error(samples: usize, statistics: &Statistics) -> f64 {
    let of = |name: &str| named(statistics, name).unwrap_or(f64::NAN);
    let (mean, rms) = (of("mean"), of("rms"));
    ((rms * rms - mean * mean).max(0.0) / samples.max(1) as f64).sqrt()
}
