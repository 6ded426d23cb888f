//! Tables of a robot file for cables that do not stretch linearly, and the conditions under which they are a law.
//!
//! A law is refused unless tension rises with strain: otherwise several lengths would have the same tension. The
//! formulas themselves are in [`cdpr_core::cable::stretch`]; [`registry::LAWS`] has an entry for each.

pub(crate) mod cubic;
mod entries;
mod hysteresis;
mod linear;
mod numbers;
mod polynomial;
pub mod registry;
mod two_piece;

use serde::{Deserialize, Serialize};
use thiserror::Error;

pub use cdpr_core::cable::stretch::hysteresis::TRANSITION_LIMIT;
use cubic::Cubic;
pub use hysteresis::hysteresis_law;
pub use polynomial::polynomial_law;

/// Largest crossing of the branches by rounding of their printed digits, as a fraction of the largest tension.
const CROSSING_TOLERANCE: f64 = 1e-9;

/// Largest deviation of the sum of the transitions' fractions from 1 by rounding of their printed digits.
const SHARE_TOLERANCE: f64 = 1e-6;

/// Loading and unloading branch of a cable, as cubic pieces between knots, and the transition between them.
///
/// The tension at strain 0 is zero. A record of a test bench determines this table.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct HysteresisTable {
    /// Strains of the knots, rising from 0.
    #[schemars(length(min = 2))]
    pub strain: Vec<f64>,
    /// Tension of the loading branch at the knots (N), rising from 0.
    pub loading_N: Vec<f64>,
    /// Tension of the unloading branch at the knots (N), rising from 0, nowhere above the loading branch.
    pub unloading_N: Vec<f64>,
    /// Slope of the loading branch at the knots (N per unit strain); a monotone interpolation when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loading_slope_N: Option<Vec<f64>>,
    /// Slope of the unloading branch at the knots (N per unit strain); a monotone interpolation when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unloading_slope_N: Option<Vec<f64>>,
    /// Strains after a reversal of the motion within which fractions of the transition to the other branch are done;
    /// at most 8.
    #[schemars(length(min = 1, max = 8))]
    pub transition_strain: Vec<f64>,
    /// Fractions of the transition, one per strain of `transition_strain`, which add up to 1; equal when missing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transition_share: Option<Vec<f64>>,
}

/// Reason that numbers are no law of stretch.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum StretchError {
    /// A polynomial without coefficients.
    #[error("tension_of_strain_N is empty")]
    NoCoefficients,
    /// The linear coefficient is not above zero.
    #[error(
        "the first coefficient of tension_of_strain_N is {found}; it is the stiffness at zero tension and must be above zero"
    )]
    NoStiffness {
        /// c₁ (N).
        found: f64,
    },
    /// The polynomial stops rising within the tensions in use.
    #[error(
        "the tension does not rise with strain: the slope of tension_of_strain_N turns at strain {strain:.4e}, where the tension is {tension:.1} N{}",
        .largest.map_or(String::new(), |largest| format!(", below tension_max_N = {largest}"))
    )]
    Turns {
        /// Least strain at which the slope is no longer positive.
        strain: f64,
        /// Tension there (N).
        tension: f64,
        /// Largest tension in use, if known (N).
        largest: Option<f64>,
    },
    /// A number is not finite.
    #[error("{key} has an entry that is not a finite number")]
    NotFinite {
        /// The key.
        key: &'static str,
    },
    /// A list has the wrong number of entries.
    #[error("{key} has {found} entries, {expected} are expected: one for each entry of {of}")]
    Count {
        /// The key.
        key: &'static str,
        /// Its entries.
        found: usize,
        /// Entries expected.
        expected: usize,
        /// The list with which it is compared.
        of: &'static str,
    },
    /// Too few or too many entries.
    #[error("{key} has {found} entries; {allowed} are allowed")]
    Entries {
        /// The key.
        key: &'static str,
        /// Its entries.
        found: usize,
        /// Allowed numbers of entries, in words.
        allowed: &'static str,
    },
    /// The first knot is not at zero strain or tension.
    #[error("{key} begins with {found}; an unstrained cable has no tension, so it begins with 0")]
    Start {
        /// The key.
        key: &'static str,
        /// Its first entry.
        found: f64,
    },
    /// A branch does not rise everywhere.
    #[error("{key} does not rise everywhere: near strain {strain:.4e} its slope is {slope:.4e} N")]
    NotRising {
        /// The key.
        key: &'static str,
        /// Strain at which the branch does not rise.
        strain: f64,
        /// The slope there (N; of strains: the step).
        slope: f64,
    },
    /// The unloading branch is above the loading branch.
    #[error(
        "at strain {strain:.4e} the unloading branch is {above:.3} N above the loading branch: the cable would give energy"
    )]
    Crossing {
        /// Strain at which the branches cross.
        strain: f64,
        /// Difference of the branches (N).
        above: f64,
    },
    /// A law with some of its numbers missing.
    #[error("{key} is given, but {missing} is not")]
    Incomplete {
        /// A key that is given.
        key: &'static str,
        /// The key that is missing.
        missing: &'static str,
    },
    /// A transition that is not a strain, or an invalid fraction.
    #[error("{key} has the entry {found}; {rule}")]
    Transition {
        /// The key.
        key: &'static str,
        /// The entry, or the sum of all.
        found: f64,
        /// Violated rule, in words.
        rule: &'static str,
    },
}

impl StretchError {
    /// Stable short name of the error.
    pub(crate) fn code(&self) -> &'static str {
        match self {
            Self::NoStiffness { .. } | Self::Turns { .. } | Self::NotRising { .. } => "stretch::not-rising",
            Self::Crossing { .. } => "stretch::branches-cross",
            Self::NoCoefficients | Self::Count { .. } | Self::Entries { .. } | Self::Incomplete { .. } => {
                "stretch::entries"
            }
            Self::NotFinite { .. } | Self::Start { .. } | Self::Transition { .. } => "stretch::value",
        }
    }

    /// The key with the wrong value.
    #[cfg(feature = "files")]
    pub(crate) fn key(&self) -> &'static str {
        match self {
            Self::NoCoefficients | Self::NoStiffness { .. } | Self::Turns { .. } => "tension_of_strain_N",
            Self::Crossing { .. } => "unloading_N",
            Self::NotFinite { key }
            | Self::Count { key, .. }
            | Self::Entries { key, .. }
            | Self::Start { key, .. }
            | Self::Incomplete { key, .. }
            | Self::NotRising { key, .. }
            | Self::Transition { key, .. } => key,
        }
    }

    /// Advice on how to correct the value.
    #[cfg(feature = "files")]
    pub(crate) fn help(&self) -> &'static str {
        match self {
            Self::NoCoefficients => {
                "write [c1, c2, …] in N for f = c1 ε + c2 ε² + …; a cable of constant E·A has [E·A]"
            }
            Self::NoStiffness { .. } => {
                "f = c1 ε + c2 ε² + …: fit the record with c1 as an unknown above zero, and without a constant"
            }
            Self::Turns { largest: None, .. } => {
                "state tension_max_N if the cable is not used so far, or fit the record with fewer terms"
            }
            Self::Turns { .. } => "fit the record with fewer terms, or over all tensions up to tension_max_N",
            Self::NotFinite { .. } => "write a number",
            Self::Count { .. } | Self::Entries { .. } => "complete the list, or shorten the other one",
            Self::Incomplete { .. } => "state all numbers of the law, or none of them",
            Self::Start { .. } => {
                "count strain from where the cable has no tension, and begin strain, loading_N and unloading_N with 0"
            }
            Self::NotRising { .. } => "correct the entries around it, give fewer knots, or leave the slopes out",
            Self::Crossing { .. } => {
                "are loading_N and unloading_N exchanged? else correct the entries around it, or leave the slopes out"
            }
            Self::Transition { .. } => {
                "a transition is the strain after which the tension has reached the other branch, e.g. transition_strain = [0.0005]"
            }
        }
    }
}

/// One piece of both branches, from strain `start` over `width`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BranchPiece {
    /// Strain at its beginning.
    pub(crate) start: f64,
    /// Length of the piece, in strain.
    pub(crate) width: f64,
    /// Loading branch as a function of strain − start.
    pub(crate) loading: Cubic,
    /// Unloading branch as a function of strain − start.
    pub(crate) unloading: Cubic,
}

impl HysteresisTable {
    /// The pieces of both branches, after checks that both rise, and that unloading is nowhere above loading.
    pub(crate) fn pieces(&self) -> Result<Vec<BranchPiece>, StretchError> {
        self.check_entries()?;
        self.check_transitions()?;
        let [loading_slopes, unloading_slopes] = self.slopes();
        let largest = self.loading_N.iter().copied().fold(0.0, f64::max);
        let piece = |k: usize| {
            let (start, width) = (self.strain[k], self.strain[k + 1] - self.strain[k]);
            let between = |values: &[f64], slopes: &[f64]| {
                Cubic::hermite(width, [values[k], values[k + 1]], [slopes[k], slopes[k + 1]])
            };
            let loading = between(&self.loading_N, &loading_slopes);
            let unloading = between(&self.unloading_N, &unloading_slopes);
            for (key, branch) in [("loading_N", loading), ("unloading_N", unloading)] {
                let (x, slope) = branch.least_slope(width);
                if !(slope > 0.0) {
                    return Err(StretchError::NotRising { key, strain: start + x, slope });
                }
            }
            let (x, gap) = (loading - unloading).least_value(width);
            if gap < -CROSSING_TOLERANCE * largest {
                return Err(StretchError::Crossing { strain: start + x, above: -gap });
            }
            Ok(BranchPiece { start, width, loading, unloading })
        };
        (0..self.strain.len() - 1).map(piece).collect()
    }

    /// Fractions of the transitions, equal if the table states none.
    pub(crate) fn fractions(&self) -> Vec<f64> {
        let count = self.transition_strain.len();
        self.transition_share.clone().unwrap_or_else(|| vec![1.0 / count as f64; count])
    }

    fn check_entries(&self) -> Result<(), StretchError> {
        let count = self.strain.len();
        if count < 2 {
            return Err(StretchError::Entries { key: "strain", found: count, allowed: "2 or more" });
        }
        let lists = [
            ("strain", Some(&self.strain)),
            ("loading_N", Some(&self.loading_N)),
            ("unloading_N", Some(&self.unloading_N)),
            ("loading_slope_N", self.loading_slope_N.as_ref()),
            ("unloading_slope_N", self.unloading_slope_N.as_ref()),
        ];
        for (place, (key, list)) in lists.into_iter().enumerate() {
            let Some(list) = list else { continue };
            if list.len() != count {
                return Err(StretchError::Count { key, found: list.len(), expected: count, of: "strain" });
            }
            if !list.iter().all(|x| x.is_finite()) {
                return Err(StretchError::NotFinite { key });
            }
            let is_slope = place > 2;
            if !is_slope && list[0] != 0.0 {
                return Err(StretchError::Start { key, found: list[0] });
            }
            let falls = |k: &usize| !(list[k + 1] - list[*k] > 0.0);
            if let Some(k) = (0..count - 1).find(falls).filter(|_| !is_slope) {
                let step = list[k + 1] - list[k];
                let slope = if place == 0 { step } else { step / (self.strain[k + 1] - self.strain[k]) };
                return Err(StretchError::NotRising { key, strain: self.strain[k], slope });
            }
        }
        Ok(())
    }

    fn check_transitions(&self) -> Result<(), StretchError> {
        let (key, found) = ("transition_strain", self.transition_strain.len());
        if found == 0 || found > TRANSITION_LIMIT {
            return Err(StretchError::Entries { key, found, allowed: "1 to 8" });
        }
        if let Some(&found) = self.transition_strain.iter().find(|&&x| !(x > 0.0 && x.is_finite())) {
            return Err(StretchError::Transition { key, found, rule: "a transition takes a strain above zero" });
        }
        let Some(fractions) = &self.transition_share else { return Ok(()) };
        let (key, of) = ("transition_share", "transition_strain");
        if fractions.len() != found {
            return Err(StretchError::Count { key, found: fractions.len(), expected: found, of });
        }
        if let Some(&found) = fractions.iter().find(|&&x| !(x >= 0.0 && x.is_finite())) {
            return Err(StretchError::Transition { key, found, rule: "a share is not negative" });
        }
        let sum: f64 = fractions.iter().sum();
        if (sum - 1.0).abs() > SHARE_TOLERANCE {
            return Err(StretchError::Transition { key, found: sum, rule: "that is the sum, and shares add up to 1" });
        }
        Ok(())
    }

    /// Slopes of both branches at the knots, as stated or from monotone interpolation.
    fn slopes(&self) -> [Vec<f64>; 2] {
        let mut loading = cubic::rising_slopes(&self.strain, &self.loading_N);
        let mut unloading = cubic::rising_slopes(&self.strain, &self.unloading_N);
        // the branches have the same slope at zero tension, so that the law has no kink there
        let common = loading[0].min(unloading[0]);
        (loading[0], unloading[0]) = (common, common);
        [self.loading_slope_N.clone().unwrap_or(loading), self.unloading_slope_N.clone().unwrap_or(unloading)]
    }
}
