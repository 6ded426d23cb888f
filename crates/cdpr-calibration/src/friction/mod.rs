//! Friction of a winch, from records of a motor that lifts and lowers a load at constant speeds.
//!
//! At constant speed the torque of the motor is that of the load and that of friction, T = L + sign(v) (T_c + d |v|), v positive where
//! the load is lifted. Lifting alone tells their sum; lifting and lowering tell both. With loads of given torques (m g r) and more than
//! one of them, L = a (m g r) + b and Coulomb friction grows with the load, T_c = c₀ + c₁ (m g r). Where the speeds reach low enough to
//! see it, (T_s − T_c) exp(−(v/v_s)²) is added, the law of the drums of a machine in time (Stribeck; Armstrong-Hélouvry, Dupont and
//! Canudas de Wit 1994).
//!
//! The unit of the fit is a plateau, not a sample: torque ripples within a turn, and samples of one turn are not independent. Standard
//! deviations are those of least squares of plateaus, with what the samples of a plateau say about its mean as the least.

mod assembly;
mod doubts;
mod grouping;
mod law;
mod least_squares;
mod outliers;
mod plateaus;
mod quantity;
mod reasons;
mod record;
#[cfg(feature = "files")]
mod record_file;
mod solution;
mod steady;
mod stribeck;
mod weighed;

use thiserror::Error;

use assembly::Fitted;
use grouping::Grouping;
use law::{Law, ROUND_OFF};
use least_squares::Fit;
use plateaus::Plateaus;
pub use plateaus::{LeftOut, Plateau};
pub use quantity::{Quantity, Undetermined};
pub use record::Record;
#[cfg(feature = "files")]
pub use record_file::RecordReading;
pub use solution::{ByDirection, Figure, HangingLoad, Judged, Solution};

/// Records that are none of a winch at constant speeds.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum InputError {
    /// No record, or one without rows.
    #[error("there are no rows: give at least one record")]
    Empty,
    /// Columns of a record of different lengths.
    #[error("record {record}: `{what}` has {found} values for {rows} speeds")]
    Lengths {
        /// Number of the record, from 1.
        record: usize,
        /// The column.
        what: &'static str,
        /// Its values.
        found: usize,
        /// Rows.
        rows: usize,
    },
    /// Values that are no numbers.
    #[error("record {record}, line {line}: {what} is not a number to calculate with")]
    NotFinite {
        /// Number of the record, from 1.
        record: usize,
        /// Its line.
        line: usize,
        /// Speed, torque, load or time.
        what: &'static str,
    },
    /// Load torques are given in some records only.
    #[error("load_Nm is given in {with} of {all} records: give the load torque in all of them, or in none")]
    MixedLoads {
        /// Records with load torques.
        with: usize,
        /// Records.
        all: usize,
    },
    /// The same torque in every row.
    #[error(
        "motor_torque_Nm is {torque} in every one of {rows} rows, whatever the speed: a commanded torque, or a sensor that was not connected? Record the torque that the motor needs"
    )]
    ConstantTorque {
        /// The torque (N·m).
        torque: f64,
        /// Rows.
        rows: usize,
    },
}

/// Identifies friction and load from records of one winch.
///
/// Each record without given load torques has a load of its own, which is fitted. Quantities that the records leave open are
/// `None` in the solution, with the reason in [`Solution::undetermined`].
pub fn identify(records: &[Record]) -> Result<Solution, InputError> {
    check(records)?;
    let grouping = Grouping::of(records);
    let plateaus = Plateaus::of(records, |record, row| grouping.group(record, row));
    let largest =
        records.iter().flat_map(|record| &record.torques).fold(0.0, |most: f64, torque| most.max(torque.abs()));
    let mut kept: Vec<usize> = (0..plateaus.sliding.len()).collect();
    let all = kept.len();
    loop {
        let rows: Vec<&Plateau> = kept.iter().map(|&row| &plateaus.sliding[row]).collect();
        let least = rows.len() as f64 * (ROUND_OFF * largest).powi(2);
        let base = fit(&grouping, &rows);
        let stribeck = stribeck::judge(&base, &rows, least);
        let chosen = stribeck.fit.as_ref().unwrap_or(&base);
        let is_full = (all - kept.len() + 1) as f64 > outliers::MOST * all as f64;
        match outliers::farthest(chosen, &rows, least).filter(|_| !is_full) {
            Some(row) => {
                kept.remove(row);
            }
            None => {
                let fitted = Fitted { kept: &kept, base: &base, judged: &stribeck };
                return Ok(assembly::assemble(&grouping, &plateaus, &fitted));
            }
        }
    }
}

/// Fits the law without the Stribeck part; friction grows with the load where there are different ones.
fn fit(grouping: &Grouping, plateaus: &[&Plateau]) -> Fit {
    let is_scaled = grouping.is_given && grouping.loads.len() > 1;
    let law = Law { loads: grouping.loads.len(), is_scaled, by_load: is_scaled, stribeck: false, by_direction: false };
    let simple = Fit::of(law, plateaus, vec![0.0; law.count()]);
    if is_scaled || !grouping.differ(&simple) {
        return simple;
    }
    let grown = Law { by_load: true, ..law };
    let start = simple.parameters.iter().copied().chain([0.0]).collect();
    Fit::of(grown, plateaus, start)
}

fn check(records: &[Record]) -> Result<(), InputError> {
    if records.iter().all(Record::is_empty) {
        return Err(InputError::Empty);
    }
    for (number, record) in (1..).zip(records) {
        let columns = [
            ("torques", Some(&record.torques)),
            ("loads", record.loads.as_ref()),
            ("times", record.times.as_ref()),
            ("positions", record.positions.as_ref()),
            ("runs", record.runs.as_ref()),
            ("masses", record.masses.as_ref()),
            ("speeds", Some(&record.speeds)),
        ];
        let rows = record.len();
        if record.lines.len() != rows {
            return Err(InputError::Lengths { record: number, what: "lines", found: record.lines.len(), rows });
        }
        for (what, values) in columns.into_iter().filter_map(|(what, values)| Some((what, values?))) {
            if values.len() != rows {
                return Err(InputError::Lengths { record: number, what, found: values.len(), rows });
            }
            if let Some(row) = values.iter().position(|value| !value.is_finite()) {
                return Err(InputError::NotFinite { record: number, line: record.lines[row], what });
            }
        }
    }
    let with = records.iter().filter(|record| record.loads.is_some()).count();
    if with > 0 && with < records.len() {
        return Err(InputError::MixedLoads { with, all: records.len() });
    }
    let torques = || records.iter().flat_map(|record| &record.torques).copied();
    let (least, most) = (torques().fold(f64::INFINITY, f64::min), torques().fold(f64::NEG_INFINITY, f64::max));
    let rows = torques().count();
    if rows > 1 && most - least <= ROUND_OFF * most.abs().max(least.abs()) {
        return Err(InputError::ConstantTorque { torque: least, rows });
    }
    Ok(())
}

#[cfg(test)]
mod tests;
