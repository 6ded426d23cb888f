//! Error blocks side by side, for people: mm, degrees, N.

use cdpr_calibration::ErrorBlocks;
use cdpr_model::geometry::MotionPattern;

use crate::number_format::{cell, decimals_for};
use crate::table::Table;

/// Source of the errors, which tells how many of their digits mean something.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Source {
    /// Exact answers at chosen poses.
    Model,
    /// Samples: no digits finer than the standard error of the mean.
    Measurements,
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
    let mut rows = |quantity: &str, unit: &str, factor: f64, decimals: usize, statistics: &[Statistic]| {
        let sigmas = columns.iter().map(|(_, blocks)| factor * standard_error(blocks, statistics));
        let decimals = match sigmas.filter(|sigma| *sigma > 0.0).reduce(f64::min) {
            Some(sigma) if source == Source::Measurements => decimals.min(decimals_for(Some(sigma)) as usize),
            _ => decimals,
        };
        for (index, (name, value)) in statistics.iter().enumerate() {
            let first = if index == 0 { quantity } else { "" };
            let mut cells = vec![first.to_owned(), (*name).to_owned(), unit.to_owned()];
            cells.extend(columns.iter().map(|(_, blocks)| cell(Some(factor * value(blocks)), decimals)));
            table.row(cells);
        }
    };
    rows("position", "mm", 1e3, 3, &POSITION);
    if pattern.has_rotation() {
        rows("rotation", "°", 1.0_f64.to_degrees(), 4, &ROTATION);
    }
    rows("length", "mm", 1e3, 3, &LENGTH);
    if columns.iter().any(|(_, blocks)| blocks.tension_error.is_some()) {
        rows("tension", "N", 1.0, 1, &TENSION);
    }
    if columns.iter().any(|(_, blocks)| blocks.swivel_error.is_some()) {
        rows("swivel", "°", 1.0_f64.to_degrees(), 4, &SWIVEL);
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

/// Standard error of the mean of a quantity, by its mean and its root mean square; of samples whose cables err alike.
fn standard_error(blocks: &ErrorBlocks, statistics: &[Statistic]) -> f64 {
    let of = |name: &str| statistics.iter().find(|(of, _)| *of == name).map_or(f64::NAN, |(_, value)| value(blocks));
    let (mean, rms) = (of("mean"), of("rms"));
    ((rms * rms - mean * mean).max(0.0) / blocks.samples.max(1) as f64).sqrt()
}

/// Name of a statistic and where it stands.
type Statistic = (&'static str, fn(&ErrorBlocks) -> f64);

const POSITION: [Statistic; 5] = [
    ("mean", |blocks| blocks.position_error_m.mean),
    ("rms", |blocks| blocks.position_error_m.rms),
    ("median", |blocks| blocks.position_error_m.median),
    ("p95", |blocks| blocks.position_error_m.p95),
    ("max", |blocks| blocks.position_error_m.max),
];

const ROTATION: [Statistic; 5] = [
    ("mean", |blocks| blocks.rotation_error_rad.mean),
    ("rms", |blocks| blocks.rotation_error_rad.rms),
    ("median", |blocks| blocks.rotation_error_rad.median),
    ("p95", |blocks| blocks.rotation_error_rad.p95),
    ("max", |blocks| blocks.rotation_error_rad.max),
];

const TENSION: [Statistic; 4] = [
    ("mean norm", |blocks| blocks.tension_error.map_or(f64::NAN, |error| error.mean_norm)),
    ("mean", |blocks| blocks.tension_error.map_or(f64::NAN, |error| error.mean_abs)),
    ("rms", |blocks| blocks.tension_error.map_or(f64::NAN, |error| error.rms)),
    ("max", |blocks| blocks.tension_error.map_or(f64::NAN, |error| error.max)),
];

const SWIVEL: [Statistic; 4] = [
    ("mean", |blocks| blocks.swivel_error.map_or(f64::NAN, |error| error.mean_abs)),
    ("rms", |blocks| blocks.swivel_error.map_or(f64::NAN, |error| error.rms)),
    ("p95", |blocks| blocks.swivel_error.map_or(f64::NAN, |error| error.p95)),
    ("max", |blocks| blocks.swivel_error.map_or(f64::NAN, |error| error.max)),
];

const LENGTH: [Statistic; 4] = [
    ("mean", |blocks| blocks.length_error_m.mean_abs),
    ("rms", |blocks| blocks.length_error_m.rms),
    ("p95", |blocks| blocks.length_error_m.p95),
    ("max", |blocks| blocks.length_error_m.max),
];
