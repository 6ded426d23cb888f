//! The list of all methods: one entry each.
//!
//! To add a method: its file with an `impl Distribute`, an entry here, a test. Help, schemas, errors and the book's
//! table are made from the entry, or compared with it.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::distribute::Distribute;
use super::{
    barrier, centroid, closed_form, dykstra, improved_closed_form, nearest, nearest_wrench, norm, puncture, smooth,
};
use crate::reading::{Keyword, did_you_mean};

/// Entry of a method.
struct Entry {
    name: &'static str,
    summary: &'static str,
    is_exact: bool,
    fallback: Fallback,
    stays_near_reference: bool,
    /// Least p of the p-norm that it minimizes; `None` of a method that minimizes none.
    least_p: Option<f64>,
    /// Makes the method's memory for this many cables and degrees of freedom.
    make: fn(usize, usize) -> Box<dyn Distribute>,
}

/// Tensions that a method gives if none keep balance and limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fallback {
    /// None for use.
    Nothing,
    /// Balanced tensions beyond their limits.
    BeyondLimits,
    /// Tensions within their limits that balance only a part of the load.
    PartOfLoad,
}

/// Defaults of an entry: an exact method without a reference, and without tensions for an infeasible problem.
const EXACT: Entry = Entry {
    name: "",
    summary: "",
    is_exact: true,
    fallback: Fallback::Nothing,
    stays_near_reference: false,
    least_p: None,
    make: |_, _| Box::new(nearest::Nearest),
};

macro_rules! methods {
    ($($(#[$attribute:meta])* $method:ident { summary: $summary:literal, $($field:tt)* })+) => {
        /// How tensions are chosen among those that balance the load.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default, Serialize, Deserialize, schemars::JsonSchema)]
        #[serde(rename_all = "kebab-case")]
        #[non_exhaustive]
        pub enum Method {
            $(#[doc = $summary] $(#[$attribute])* $method,)+
        }

        /// One entry per method, in the order in which they are listed.
        const METHODS: &[Entry] = &[$(Entry { summary: $summary, $($field)* }),+];

        impl Keyword for Method {
            const ALL: &'static [Self] = &[$(Self::$method),+];

            fn name(self) -> &'static str {
                self.entry().name
            }
        }
    };
}

methods! {
    #[default]
    Qp {
        summary: "the nearest to the reference within balance and limits, min ‖f − f_ref‖",
        name: "qp",
        stays_near_reference: true,
        ..EXACT
    }
    ClosedForm {
        summary: "the nearest to the reference that balance the load, f = f_ref − A⁺ᵀ (w + Aᵀ f_ref) (eq. 3.41), whether or not they keep the limits",
        name: "closed-form",
        is_exact: false,
        fallback: Fallback::BeyondLimits,
        stays_near_reference: true,
        make: |cable_count, dof| Box::new(closed_form::Solver::new(cable_count, dof)),
        ..EXACT
    }
    ImprovedClosedForm {
        summary: "the closed form; the cable that misses a limit most is put on it, the others are balanced anew (Pott 2014)",
        name: "improved-closed-form",
        is_exact: false,
        stays_near_reference: true,
        make: |cable_count, dof| Box::new(improved_closed_form::ImprovedClosedForm::new(cable_count, dof)),
        ..EXACT
    }
    Puncture {
        summary: "the first point within the limits on the way from the shortest tensions −A⁺ᵀ w to the improved closed form (Müller, Reichert, Bruckmann 2015)",
        name: "puncture",
        is_exact: false,
        make: |cable_count, dof| Box::new(puncture::Puncture::new(cable_count, dof)),
        ..EXACT
    }
    Dykstra {
        summary: "alternating projections on balance and limits, which tend to the tensions of qp (Boyle, Dykstra 1986)",
        name: "dykstra",
        is_exact: false,
        stays_near_reference: true,
        make: |cable_count, dof| Box::new(dykstra::Projections::new(cable_count, dof)),
        ..EXACT
    }
    Centroid {
        summary: "the centroid of all tensions within balance and limits (Gouttefarde et al. 2015), at any redundancy",
        name: "centroid",
        make: |cable_count, dof| Box::new(centroid::CentroidMethod::new(cable_count, dof)),
        ..EXACT
    }
    Minimum {
        summary: "the lowest, min ‖f‖ₚ within balance and limits; p from 1 (the sum) to 8, by default 2",
        name: "minimum",
        least_p: Some(1.0),
        make: |cable_count, dof| Box::new(norm::ExtremeNorm::new(norm::Extreme::Zero, cable_count, dof)),
        ..EXACT
    }
    Maximum {
        summary: "the highest, min ‖f_max − f‖ₚ: the least that is missing to the largest tensions; p = 1 is the largest sum",
        name: "maximum",
        least_p: Some(1.0),
        make: |cable_count, dof| Box::new(norm::ExtremeNorm::new(norm::Extreme::Largest, cable_count, dof)),
        ..EXACT
    }
    Barrier {
        summary: "far from all limits: the largest product of the distances to them, Π (f − f_min)(f_max − f), the analytic centre, smooth along a path",
        name: "barrier",
        make: |cable_count, dof| Box::new(barrier::Centre::new(cable_count, dof)),
        ..EXACT
    }
    Smooth {
        summary: "a p-norm about the reference with smooth limits and, at the edge of what is feasible, a part of the load left: no kink at any load (Ueland, Sauder, Skjetne 2021)",
        name: "smooth",
        is_exact: false,
        fallback: Fallback::PartOfLoad,
        stays_near_reference: true,
        least_p: Some(2.0),
        make: |cable_count, dof| Box::new(smooth::SmoothNorm::new(cable_count, dof)),
    }
    NearestWrench {
        summary: "those of qp; where no tensions balance the load, those within the limits that come nearest to it",
        name: "nearest-wrench",
        fallback: Fallback::PartOfLoad,
        stays_near_reference: true,
        make: |cable_count, dof| Box::new(nearest_wrench::NearestWrench::new(cable_count, dof)),
        ..EXACT
    }
}

/// Text that names no method.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownMethod(String);

impl Method {
    fn entry(self) -> &'static Entry {
        &METHODS[self as usize]
    }

    /// One line on the tensions that the method chooses.
    pub fn summary(self) -> &'static str {
        self.entry().summary
    }

    /// True if the method finds tensions whenever there are any. The others may miss them, and then return
    /// [`super::Status::NotFound`].
    pub fn is_exact(self) -> bool {
        self.entry().is_exact
    }

    /// Tensions that the method gives if none keep balance and limits.
    pub(super) fn fallback(self) -> Fallback {
        self.entry().fallback
    }

    /// True if its tensions leave a part of the load unbalanced when none balance it within the limits.
    pub fn may_leave_load(self) -> bool {
        self.fallback() == Fallback::PartOfLoad
    }

    /// True if its tensions stay near to the reference ([`super::Options::reference`]); the others do not use it.
    pub fn stays_near_reference(self) -> bool {
        self.entry().stays_near_reference
    }

    /// Least p of the p-norm that it minimizes ([`super::Options::p`]); `None` if it minimizes none.
    pub fn least_p(self) -> Option<f64> {
        self.entry().least_p
    }

    pub(super) fn distributor(self, cable_count: usize, dof: usize) -> Box<dyn Distribute> {
        (self.entry().make)(cable_count, dof)
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Self::named(text).ok_or_else(|| UnknownMethod(text.to_owned()))
    }
}

impl fmt::Display for UnknownMethod {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "there is no method `{}`; ", self.0)?;
        let names: Vec<_> = Method::ALL.iter().map(|method| method.name()).collect();
        if let Some(meant) = did_you_mean(&self.0, names.iter().copied()) {
            write!(f, "did you mean `{meant}`? ")?;
        }
        write!(f, "there are {}", names.join(", "))
    }
}

impl std::error::Error for UnknownMethod {}

#[cfg(test)]
mod tests {
    use super::*;

    /// Files and answers spell methods by their variants, options by the names of the entries.
    #[test]
    fn the_name_of_an_entry_is_the_one_that_files_read() {
        for &method in Method::ALL {
            let written = serde_json::to_value(method).unwrap();
            assert_eq!(written.as_str(), Some(method.name()));
            assert_eq!(method.name().parse(), Ok(method));
            assert!(!method.summary().is_empty() && !method.summary().contains('|'), "{method}");
        }
    }

    #[test]
    fn the_schema_says_of_every_method_what_its_entry_says() {
        let schema = serde_json::to_value(schemars::schema_for!(Method)).unwrap();
        let choices = schema["oneOf"].as_array().unwrap();
        let said: Vec<_> =
            choices.iter().map(|choice| (choice["const"].as_str(), choice["description"].as_str())).collect();
        let entries: Vec<_> = Method::ALL.iter().map(|method| (Some(method.name()), Some(method.summary()))).collect();
        assert_eq!(said, entries);
    }
}
