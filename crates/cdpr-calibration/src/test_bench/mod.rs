//! From a record of a test bench, elongation against tension of one cable, to laws of its stretch.
//!
//! Both branches of the hysteresis, the shares of its transitions, a polynomial without hysteresis and a straight line
//! are fitted to the same samples, so that their errors can be compared (dissertation, sec. 5.1: 600 N for the line,
//! 0.5 % of the range for the branches).

mod branches;
mod doubts;
mod misfit;
mod plain;
mod record;
#[cfg(feature = "files")]
mod record_file;
mod strokes;

use nalgebra::DMatrix;
use thiserror::Error;

use cdpr_model::cable::stretch::hysteresis::Hysteresis;
use cdpr_model::cable::stretch::hysteresis_law;
use cdpr_model::robot::{HysteresisTable, StretchError};

pub use misfit::Misfit;
use plain::Polynomials;
pub use plain::{InterceptFit, LinearFit, PolynomialFit};
pub use record::Record;
#[cfg(feature = "files")]
pub use record_file::RecordReading;
use strokes::{Stroke, range};

/// A stroke over this share of the elongations counts as a full one.
const FULL_STROKE: f64 = 0.8;

/// Means over this many equal parts of the elongations are compared to see whether the record is that of a cable.
const PARTS: usize = 10;

/// How far such means may be the wrong way round, as a share of the range of tensions.
const TOLERATED: f64 = 0.02;

/// How a record is fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Free length of the sample (m).
    pub length: f64,
    /// Cubic pieces of each branch over the elongations of the record.
    pub pieces: usize,
}

impl Settings {
    /// Six pieces for a sample of this length (m).
    pub fn of_length(length: f64) -> Self {
        Self { length, pieces: 6 }
    }
}

/// Laws fitted to a record of a cable, with their misfits.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The table for the robot file.
    pub table: HysteresisTable,
    /// Error with hysteresis, over all samples.
    pub hysteresis: Misfit,
    /// Error with hysteresis while the elongation grows.
    pub loading: Misfit,
    /// Error with hysteresis while it shrinks.
    pub unloading: Misfit,
    /// The best polynomial without hysteresis that rises from no tension; `None` when none rises.
    pub polynomial: Option<PolynomialFit>,
    /// The best polynomial that need not come from no tension, to compare with.
    pub with_intercept: Option<InterceptFit>,
    /// The best straight line.
    pub linear: LinearFit,
    /// Least and largest tension of the record (N).
    pub tensions: [f64; 2],
    /// Least and largest elongation of the record (m).
    pub elongations: [f64; 2],
    /// Elongation at which the cable has no tension, extrapolated (m).
    pub zero: f64,
    /// Least and largest slope of the loading branch over the record (N/m at the sample's length).
    pub stiffness: [f64; 2],
    /// Energy that a cycle over the whole record loses by the law (J).
    pub loss: f64,
    /// The same by the areas under the full strokes of the record (J).
    pub measured_loss: f64,
    /// Full strokes with growing and with shrinking elongation.
    pub strokes: [usize; 2],
}

/// A record that determines no law.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum InputError {
    /// Elongation or tension does not vary, or no sample pulls.
    #[error("{what} of the record does not vary, or is not positive anywhere: there is nothing to fit")]
    NoRange {
        /// Elongation or tension.
        what: &'static str,
    },
    /// Not one full loading and one full unloading.
    #[error(
        "the record has {loading} full loading and {unloading} full unloading strokes (over {percent} % of its elongations); both branches need at least one of each: record a whole cycle or more, rows in their order in time"
    )]
    TooFewCycles {
        /// Full strokes with growing elongation.
        loading: usize,
        /// Full strokes with shrinking elongation.
        unloading: usize,
        /// Least share of all elongations of a full stroke (%).
        percent: u32,
    },
    /// Fewer rows than unknowns.
    #[error(
        "{found} rows do not determine {pieces} pieces of both branches; at least {needed} rows are needed: record more, or fit fewer pieces"
    )]
    TooFewRows {
        /// Rows.
        found: usize,
        /// Rows needed.
        needed: usize,
        /// Pieces asked for.
        pieces: usize,
    },
    /// Tension falls while elongation grows along a branch.
    #[error(
        "while {branch} the tension falls by {drop:.1} N although the elongation grows beyond {elongation:.5} m: did the sample slip, is the sign of a column wrong, or are rows out of order?"
    )]
    NotRising {
        /// `loading` or `unloading`.
        branch: &'static str,
        /// Elongation from which on the tension falls (m).
        elongation: f64,
        /// By how much (N).
        drop: f64,
    },
    /// More tension while unloading.
    #[error(
        "at the elongation {elongation:.5} m the tension while unloading is {above:.1} N above that while loading: the cable would give energy. Is the order of rows, or the sign of `elongation` or `direction`, reversed?"
    )]
    BranchesCross {
        /// Elongation at which the branches cross (m).
        elongation: f64,
        /// By how much (N).
        above: f64,
    },
    /// The fitted branches are no law.
    #[error("the fitted branches are no law ({0}): fit fewer pieces, or remove disturbed rows")]
    NoLaw(#[from] StretchError),
}

/// Fits all laws to a record.
pub fn identify(record: &Record, settings: &Settings) -> Result<Solution, InputError> {
    let elongations = range(&record.elongations).ok_or(InputError::NoRange { what: "elongation" })?;
    let tensions =
        range(&record.tensions).filter(|range| range[1] > 0.0).ok_or(InputError::NoRange { what: "tension" })?;
    let pieces = settings.pieces.max(1);
    let (found, needed) = (record.elongations.len(), 8 * (pieces + 1));
    if found < needed {
        return Err(InputError::TooFewRows { found, needed, pieces });
    }
    let strokes = strokes::strokes(record);
    let full = |is_loading: bool| {
        let width = FULL_STROKE * (elongations[1] - elongations[0]);
        strokes.iter().filter(move |stroke| stroke.is_loading == is_loading && stroke.width(record) >= width)
    };
    let count = [full(true).count(), full(false).count()];
    if count[0] == 0 || count[1] == 0 {
        let percent = (100.0 * FULL_STROKE).round() as u32;
        return Err(InputError::TooFewCycles { loading: count[0], unloading: count[1], percent });
    }
    check_means(record, elongations, tensions, [full(true).collect(), full(false).collect()])?;
    let smooth = strokes::smoothed(record, &strokes);
    let fit = branches::fit(&smooth, &record.tensions, pieces);
    let (table, zero) = fit.table(elongations, settings.length);
    let law = hysteresis_law(&table)?;
    let strain = |elongation: f64| (elongation - zero) / settings.length;
    let residuals = residuals(&law, fit.start(strain(smooth[0])), &smooth, &record.tensions, strain);
    let on = |is_loading: bool| {
        let rows = strokes.iter().filter(move |stroke| stroke.is_loading == is_loading);
        Misfit::of(rows.flat_map(|stroke| stroke.rows.clone()).map(|row| residuals[row]))
    };
    let slopes = (0..=200).map(|k| elongations[0] + (elongations[1] - elongations[0]) * f64::from(k) / 200.0);
    let slopes: Vec<f64> = slopes.map(|elongation| law.loading(strain(elongation)).1 / settings.length).collect();
    let area = |is_loading: bool| {
        let areas: Vec<f64> = full(is_loading).map(|stroke| stroke.area(record).abs()).collect();
        areas.iter().sum::<f64>() / areas.len() as f64
    };
    let polynomials = Polynomials::new(record, elongations, settings.length);
    Ok(Solution {
        hysteresis: Misfit::of(residuals.iter().copied()),
        loading: on(true),
        unloading: on(false),
        polynomial: polynomials.law(),
        with_intercept: polynomials.with_intercept(),
        linear: plain::line(record, settings.length),
        tensions,
        elongations,
        zero,
        stiffness: range(&slopes).unwrap_or([slopes[0]; 2]),
        loss: settings.length * law.cycle_loss(strain(elongations[0]), strain(elongations[1]), 1000),
        measured_loss: area(true) - area(false),
        strokes: count,
        table,
    })
}

/// Modelled minus recorded tensions along the record.
fn residuals(
    law: &Hysteresis,
    mut memory: cdpr_model::cable::stretch::hysteresis::Memory,
    elongations: &[f64],
    tensions: &[f64],
    strain: impl Fn(f64) -> f64,
) -> Vec<f64> {
    let row = |(&elongation, &tension): (&f64, &f64)| {
        let strain = strain(elongation);
        let modelled = law.tension(strain, &memory).0;
        memory = law.advance(strain, &memory);
        modelled - tension
    };
    elongations.iter().zip(tensions).map(row).collect()
}

/// Refuses records whose branches fall, or lie the wrong way round, by more than noise can do.
fn check_means(
    record: &Record,
    elongations: [f64; 2],
    tensions: [f64; 2],
    full: [Vec<&Stroke>; 2],
) -> Result<(), InputError> {
    let width = (elongations[1] - elongations[0]) / PARTS as f64;
    let allowed = TOLERATED * (tensions[1] - tensions[0]);
    let mut means = DMatrix::from_element(2, PARTS, f64::NAN);
    for (branch, strokes) in full.iter().enumerate() {
        let mut sums = [(0.0, 0.0); PARTS];
        for row in strokes.iter().flat_map(|stroke| stroke.rows.clone()) {
            let part = (((record.elongations[row] - elongations[0]) / width) as usize).min(PARTS - 1);
            sums[part] = (sums[part].0 + record.tensions[row], sums[part].1 + 1.0);
        }
        for (part, (sum, count)) in sums.into_iter().enumerate() {
            means[(branch, part)] = sum / count;
        }
    }
    for part in 0..PARTS {
        let elongation = elongations[0] + width * (part as f64 + 0.5);
        for (row, branch) in ["loading", "unloading"].into_iter().enumerate() {
            let drop = if part == 0 { 0.0 } else { means[(row, part - 1)] - means[(row, part)] };
            if drop > allowed {
                return Err(InputError::NotRising { branch, elongation: elongation - width, drop });
            }
        }
        let above = means[(1, part)] - means[(0, part)];
        if above > allowed {
            return Err(InputError::BranchesCross { elongation, above });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
