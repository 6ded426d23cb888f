//! Options of a distribution besides balance and limits.

use super::limits::can_be_calculated_with;
use super::{InputError, Limits};

/// Tensions to which the chosen ones are to be near.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub enum Reference<'a> {
    /// f_m = ½ (f_min + f_max), of the cables' own limits.
    #[default]
    Middle,
    /// The tensions of the step before ([`Options::previous`]).
    Previous,
    /// The given tensions, one per cable (N).
    Given(&'a [f64]),
}

/// Options of a distribution; `Options::default()` asks for no rates, p = 2 and the middle of the limits as reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options<'a> {
    /// Tensions to which methods with a reference stay near ([`super::Method::stays_near_reference`]). The others do
    /// not use it.
    pub reference: Reference<'a>,
    /// Tensions of the step before, one per cable (N).
    pub previous: Option<&'a [f64]>,
    /// Largest change of tension per time, one number per cable (N/s, 0 or more): with the previous tensions and the
    /// time step it narrows the limits to [previous − rate · Δt, previous + rate · Δt].
    pub rates: Option<&'a [f64]>,
    /// Δt, the time since the previous tensions (s).
    pub time_step: f64,
    /// The p of methods that minimize a p-norm, from [`super::Method::least_p`] to 8. The default 2 gives one answer
    /// that follows the load continuously; 1 adds the tensions up, and the answer jumps between corners of the allowed
    /// set.
    pub p: f64,
    /// Smoothing width of `smooth`, from 1e-4 to 1: the fraction of half the largest range by which a tension stays
    /// away from a limit that it would just touch with p = 2 alone.
    pub smoothing: f64,
    /// Divisors of the rows of the wrench where forces are weighed against moments (`nearest-wrench`): 1 for forces and
    /// a length for moments (m). `None` divides by 1 everywhere: 1 N·m then counts as much as 1 N.
    pub lengths: Option<&'a [f64]>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self {
            reference: Reference::Middle,
            previous: None,
            rates: None,
            time_step: 1.0,
            p: 2.0,
            smoothing: 0.1,
            lengths: None,
        }
    }
}

/// The largest p of a p-norm: beyond it rounding of |f|ᵖ hides all but the largest tensions.
pub(super) const LARGEST_P: f64 = 8.0;

impl Options<'_> {
    /// Checks sizes and values, for any method.
    pub(super) fn check(&self, cable_count: usize, dof: usize) -> Result<(), InputError> {
        let given = match self.reference {
            Reference::Given(reference) => Some(reference),
            _ => None,
        };
        if let Some(reference) = given
            && reference.len() != cable_count
        {
            return Err(InputError::ReferenceLength { expected: cable_count, found: reference.len() });
        }
        for (what, list, expected) in [
            ("previous tensions", self.previous, cable_count),
            ("rates of tension", self.rates, cable_count),
            ("lengths of wrench rows", self.lengths, dof),
        ] {
            if let Some(list) = list.filter(|list| list.len() != expected) {
                return Err(InputError::OptionCount { what, expected, found: list.len() });
            }
        }
        for (what, list) in [("reference", given), ("previous tensions", self.previous)] {
            if list.is_some_and(|list| !list.iter().all(|&number| can_be_calculated_with(number))) {
                return Err(InputError::NotFinite { what });
            }
        }
        self.check_values()
    }

    fn check_values(&self) -> Result<(), InputError> {
        let needs_previous = self.reference == Reference::Previous || self.rates.is_some();
        if needs_previous && self.previous.is_none() {
            return Err(InputError::NoPrevious);
        }
        let refuse = |what, value, expected| Err(InputError::OptionValue { what, value, expected });
        if !(self.p >= 1.0 && self.p <= LARGEST_P) {
            return refuse("p of the p-norm", self.p, "from 1 to 8");
        }
        if !(self.smoothing >= 1e-4 && self.smoothing <= 1.0) {
            return refuse("smoothing width", self.smoothing, "from 1e-4 to 1");
        }
        if !(self.time_step >= 0.0 && self.time_step.is_finite()) {
            return refuse("time step (s)", self.time_step, "finite, 0 or more");
        }
        if let Some(&rate) = self.rates.into_iter().flatten().find(|rate| !(**rate >= 0.0)) {
            return refuse("rate of tension (N/s)", rate, "0 or more");
        }
        match self.lengths.into_iter().flatten().find(|length| !(**length > 0.0 && length.is_finite())) {
            Some(&length) => refuse("length of a wrench row (m)", length, "finite and above 0"),
            None => Ok(()),
        }
    }

    /// Writes the reference tensions (N): by default the middle of these limits.
    pub(super) fn write_reference(&self, limits: &Limits, reference: &mut [f64]) {
        match (self.reference, self.previous) {
            (Reference::Given(given), _) => reference.copy_from_slice(given),
            (Reference::Previous, Some(previous)) => reference.copy_from_slice(previous),
            _ => reference.iter_mut().enumerate().for_each(|(cable, place)| *place = limits.middle(cable)),
        }
    }
}
