//! Answer of a method to one problem.

use super::distribute::{Cause, FoundTensions, Status};
use super::method::Fallback;
use super::quadratic::{Certificate, UNDECIDED};
use super::{Limits, Method};

/// Tensions of one problem, or the reason that there are none.
#[must_use = "check `status` before using the tensions"]
#[derive(Clone, Debug)]
pub struct Answer {
    /// The method that chose the tensions.
    pub method: Method,
    /// Feasible if the tensions balance the load within their limits.
    pub status: Status,
    /// Tension per cable (N). Within the limits if feasible, and always within them for `nearest-wrench`. Otherwise the
    /// last tensions of the search: not for use.
    pub tensions: Vec<f64>,
    /// Aᵀ f + w, one entry per row (N, N·m): rounding if feasible.
    pub wrench_residual: Vec<f64>,
    /// Steps of the search, counted as the method counts them.
    pub iterations: u32,
    /// The given limits, narrowed to the range that the rates allow.
    pub limits: Limits,
    pub(super) cause: Cause,
    /// True when the rates narrowed the limits, and tensions exist without them.
    pub(super) rates_are_the_reason: bool,
    pub(super) certificate: Certificate,
}

impl Answer {
    pub(super) fn new(method: Method, cable_count: usize, dof: usize, limits: Limits) -> Self {
        Self {
            method,
            status: Status::Undecided,
            tensions: vec![0.0; cable_count],
            wrench_residual: vec![0.0; dof],
            iterations: 0,
            limits,
            cause: Cause::Certificate,
            rates_are_the_reason: false,
            certificate: Certificate::new(cable_count, dof),
        }
    }

    /// Mutable references to the fields that a method writes.
    pub(super) fn found(&mut self) -> FoundTensions<'_> {
        let Self { status, tensions, iterations, limits, cause, .. } = self;
        FoundTensions { limits, tensions, status, cause, iterations }
    }

    /// True if the tensions are feasible, if the method gives balanced tensions beyond their limits, or if it gives
    /// tensions that balance a part of an infeasible load.
    pub fn has_tensions(&self) -> bool {
        self.status == Status::Feasible
            || match self.method.fallback() {
                Fallback::Nothing => false,
                Fallback::BeyondLimits => true,
                Fallback::PartOfLoad => self.certificate().is_some(),
            }
    }

    /// The proof that no tensions balance the load within the limits, for checking by other means. `None` unless
    /// infeasible, and `None` if the rate of a cable keeps it beyond its limits: this needs no proof.
    pub fn certificate(&self) -> Option<&Certificate> {
        (self.status == Status::Infeasible && self.cause == Cause::Certificate).then_some(&self.certificate)
    }

    /// The wrench that the cables do not balance (N, N·m): −(Aᵀ f + w), zero to rounding if feasible.
    pub fn missing_wrench(&self) -> Vec<f64> {
        self.wrench_residual.iter().map(|residual| -residual).collect()
    }

    /// The reason that the tensions are not for use; `None` if feasible. It names the limits and cables that exclude
    /// the load and by how much, or the residual at which the method stopped although other methods find tensions.
    pub fn reason(&self) -> Option<String> {
        match self.status {
            Status::Feasible => None,
            Status::Undecided => Some(UNDECIDED.to_owned()),
            Status::Infeasible => Some(self.proof()),
            Status::NotFound => {
                let method = self.method;
                let missed = self.missed_limits();
                let unbalanced = self.unbalanced();
                let so_far = match self.cause {
                    Cause::TooManyFaces { dimension } => format!(
                        "the allowed tensions have {dimension} dimensions, and faces of faces of their set are too many to add up"
                    ),
                    _ if missed.is_empty() && unbalanced > 0.0 => {
                        format!(
                            "the tensions keep the limits and leave {unbalanced:.2e} of the load in a row of the balance"
                        )
                    }
                    _ if missed.is_empty() => format!("after {} steps the tensions still change", self.iterations),
                    _ => missed,
                };
                Some(format!(
                    "{so_far}; tensions that keep the limits exist, the method {method} does not find them, qp does"
                ))
            }
        }
    }

    fn proof(&self) -> String {
        if let Cause::OutOfReach { cable, previous, reach, least, largest } = self.cause {
            let (side, limit) =
                if previous > largest { ("above its largest", largest) } else { ("below its least", least) };
            return format!(
                "cable {} had {previous:.1} N, {:.1} N {side} tension of {limit} N, and its rate lets it change by {reach:.1} N in \
                 this step",
                cable + 1,
                (previous - limit).abs()
            );
        }
        let words = self.certificate.to_string();
        let words = match self.rates_are_the_reason {
            true => format!(
                "with limits as near to the previous tensions as the rates ask, {words}; without the rates there are tensions"
            ),
            false => words,
        };
        match (self.method.fallback(), self.missed_limits()) {
            (Fallback::BeyondLimits, missed) if !missed.is_empty() => {
                format!("{missed}; no tensions keep the limits: {words}")
            }
            _ => words,
        }
    }

    /// Largest row of Aᵀ f + w by amount (N, N·m); 0 if it is below 100 times the tolerance of the limits.
    fn unbalanced(&self) -> f64 {
        let most = self.wrench_residual.iter().fold(0.0_f64, |most, row| most.max(row.abs()));
        if most > 1e2 * self.limits.tolerance() { most } else { 0.0 }
    }

    /// "cable 3 has 9100.0 N, its largest tension is 9000 N; …"
    fn missed_limits(&self) -> String {
        self.limits.missed(&self.tensions).join("; ")
    }
}
