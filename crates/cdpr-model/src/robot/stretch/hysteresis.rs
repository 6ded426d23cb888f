//! The law of stretch with a loading and an unloading branch, from a table.

use cdpr_core::cable::stretch::Stretch;
use cdpr_core::cable::stretch::hysteresis::{Hysteresis, Memory, Piece, StopOperator};

use super::{HysteresisTable, StretchError};
use crate::robot::Cable;

/// The law of a table; an error if the table makes no law.
pub fn hysteresis_law(table: &HysteresisTable) -> Result<Hysteresis, StretchError> {
    let checked = table.pieces()?;
    let halved = |a: [f64; 4], b: [f64; 4], sign: f64| std::array::from_fn(|k| 0.5 * (a[k] + sign * b[k]));
    let pieces = checked.iter().map(|piece| Piece {
        start: piece.start,
        middle: halved(piece.loading.0, piece.unloading.0, 1.0),
        half: halved(piece.loading.0, piece.unloading.0, -1.0),
    });
    let fractions = table.fractions();
    let total: f64 = fractions.iter().sum();
    let stops = table.transition_strain.iter().zip(fractions);
    let stops = stops.map(|(strain, fraction)| StopOperator { rate: 2.0 / strain, weight: fraction / total });
    let last_width = checked.last().map_or(0.0, |piece| piece.width);
    Hysteresis::new(pieces.collect(), last_width, stops.collect()).ok_or(StretchError::Entries {
        key: "strain",
        found: checked.len(),
        allowed: "two or more",
    })
}

/// The law of the cable, never loaded; `None` if it has no table.
pub(super) fn law(cable: &Cable) -> Result<Option<Stretch>, StretchError> {
    let law = cable.hysteresis.as_ref().map(hysteresis_law).transpose()?;
    Ok(law.map(|law| Stretch::Hysteresis(law, Memory::virgin())))
}

/// Number of values in the cable's table that a test bench measures: both branches, which begin at zero tension, and
/// the transitions between them.
pub(super) fn count(cable: &Cable) -> usize {
    let Some(table) = &cable.hysteresis else { return 0 };
    let (slopes, fractions) = ([&table.loading_slope_N, &table.unloading_slope_N], &table.transition_share);
    let branches = [&table.loading_N, &table.unloading_N].map(|branch| branch.len().saturating_sub(1));
    branches.iter().sum::<usize>()
        + slopes.into_iter().flatten().map(Vec::len).sum::<usize>()
        + table.transition_strain.len()
        // the fractions add up to 1
        + fractions.as_ref().map_or(0, |fractions| fractions.len().saturating_sub(1))
}

/// Gives a cable stiffening branches with this axial stiffness (N) at zero strain, a tenth apart in the middle.
pub(super) fn sample(cable: &mut Cable, stiffness: f64) {
    let strain = vec![0.0, 0.005, 0.02];
    let loading: Vec<f64> = strain.iter().map(|e| stiffness * e * (1.0 + 20.0 * e)).collect();
    let unloading = vec![0.0, 0.9 * loading[1], loading[2]];
    let table = HysteresisTable { strain, loading_N: loading, unloading_N: unloading, ..HysteresisTable::default() };
    cable.hysteresis = Some(HysteresisTable { transition_strain: vec![4e-4], ..table });
}
