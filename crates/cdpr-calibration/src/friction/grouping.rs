//! Rows of the same load.

use super::Record;
use super::law::Hung;
use super::least_squares::{Fit, SAME};

/// Given torques that differ by less than this share of the largest are one load.
const ALIKE: f64 = 0.02;

/// Loads of all records.
pub(super) struct Grouping {
    /// True where the records give the loads' torques.
    pub(super) is_given: bool,
    /// Given torques: the largest of each load, ascending. Without them, record and mass of each load.
    pub(super) loads: Vec<Hanging>,
    /// Load of each row of each record.
    rows: Vec<Vec<usize>>,
}

/// One load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hanging {
    /// The first record with it.
    pub(super) record: usize,
    /// Its given torque (N·m).
    pub(super) torque: Option<f64>,
    /// Its given mass (kg).
    pub(super) mass: Option<f64>,
}

impl Grouping {
    /// Loads of records that have the same columns.
    pub(super) fn of(records: &[Record]) -> Self {
        if records.iter().any(|record| record.loads.is_some()) { Self::given(records) } else { Self::fitted(records) }
    }

    /// Load of a row.
    pub(super) fn group(&self, record: usize, row: usize) -> usize {
        self.rows[record][row]
    }

    /// A load as the law takes it.
    pub(super) fn hung(&self, group: usize) -> Hung {
        Hung { group, given: self.loads[group].torque.unwrap_or(0.0) }
    }

    /// True for loads of which a fit says that they differ.
    pub(super) fn differ(&self, fit: &Fit) -> bool {
        let torques = &fit.parameters[..self.loads.len()];
        let (least, most) = torques
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), own| (least.min(*own), most.max(*own)));
        self.loads.len() > 1 && most - least > SAME * most.abs().max(least.abs())
    }

    /// Loads by their torques: a new one begins where torques have a gap.
    fn given(records: &[Record]) -> Self {
        let of = |record: &Record| record.loads.clone().unwrap_or_default();
        let mut all: Vec<f64> = records.iter().flat_map(of).collect();
        all.sort_by(f64::total_cmp);
        let largest = all.iter().fold(0.0, |most: f64, load| most.max(load.abs()));
        let bounds: Vec<f64> = all
            .windows(2)
            .filter(|pair| pair[1] - pair[0] > ALIKE * pair[1].abs().max(0.05 * largest))
            .map(|pair| 0.5 * (pair[0] + pair[1]))
            .collect();
        let group = |load: f64| bounds.partition_point(|bound| *bound < load);
        let rows: Vec<Vec<usize>> = records.iter().map(|record| of(record).into_iter().map(group).collect()).collect();
        let loads = (0..=bounds.len())
            .map(|own| {
                let torques: Vec<f64> = all.iter().copied().filter(|load| group(*load) == own).collect();
                let torque = torques.iter().sum::<f64>() / torques.len() as f64;
                let record = rows.iter().position(|groups| groups.contains(&own)).unwrap_or(0);
                Hanging { record, torque: Some(torque), mass: None }
            })
            .collect();
        Self { is_given: true, loads, rows }
    }

    /// One load of each record, and of each number of its column of masses.
    fn fitted(records: &[Record]) -> Self {
        let mut loads: Vec<Hanging> = Vec::new();
        let mut rows = Vec::new();
        for (number, record) in records.iter().enumerate() {
            let own = (0..record.len()).map(|row| {
                let mass = record.masses.as_ref().map(|masses| masses[row]);
                let wanted = Hanging { record: number, torque: None, mass };
                let known = loads.iter().position(|load| *load == wanted);
                known.unwrap_or_else(|| {
                    loads.push(wanted);
                    loads.len() - 1
                })
            });
            rows.push(own.collect());
        }
        Self { is_given: false, loads, rows }
    }
}
