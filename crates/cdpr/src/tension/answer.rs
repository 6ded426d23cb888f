//! Answer of a method to one problem.

use serde::Serialize;

use super::quadratic::{Certificate, UNDECIDED};
use super::{Limits, Method};

/// Whether tensions balance the load within the limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Status {
    /// The tensions balance the load and keep their limits.
    Feasible,
    /// No tensions do: proved, see [`Answer::certificate`] and [`Answer::reason`].
    Infeasible,
    /// Some tensions do, but the method did not find them: see `Method::is_exact`.
    NotFound,
    /// Rounding or overflow kept the search from a verdict: matrices with entries at the ends of their range.
    Undecided,
}

/// Tensions of one problem, or why there are none.
#[must_use = "check `status` before using the tensions"]
#[derive(Clone, Debug)]
pub struct Answer {
    /// How the tensions were chosen.
    pub method: Method,
    /// Whether they are to be used.
    pub status: Status,
    /// Tension per cable (N). Within the limits when feasible; of `nearest-wrench` always. Otherwise as far as the method
    /// came: not for use.
    pub tensions: Vec<f64>,
    /// Aᵀ f + w (N, N·m): rounding when feasible.
    pub wrench_residual: Vec<f64>,
    /// Steps of the search, in units of the method.
    pub iterations: u32,
    /// The limits that were asked for, narrowed to what the rates allow.
    pub limits: Limits,
    pub(super) cause: Cause,
    /// True when the rates narrowed the limits, and tensions exist without them.
    pub(super) rates_are_the_reason: bool,
    pub(super) certificate: Certificate,
}

/// Origin of a reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cause {
    /// The certificate, or nothing.
    Certificate,
    /// A cable (from 0) whose previous tension (N) is so far beyond its limits that one step does not reach them.
    OutOfReach { cable: usize, previous: f64, reach: f64, least: f64, largest: f64 },
    /// Allowed tensions of so many dimensions that the faces of their set cannot be added up.
    TooManyFaces { dimension: usize },
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

    /// The proof that no tensions will do, for checking by other means. None of a cable that its rate keeps beyond its limits:
    /// that needs none.
    pub fn certificate(&self) -> Option<&Certificate> {
        (self.status == Status::Infeasible && self.cause == Cause::Certificate).then_some(&self.certificate)
    }

    /// The wrench that the cables would have to give besides (N, N·m): −(Aᵀ f + w), zero to rounding when feasible.
    pub fn missing_wrench(&self) -> Vec<f64> {
        self.wrench_residual.iter().map(|rest| -rest).collect()
    }

    /// Why the tensions are not to be used: which limits of which cables exclude the load and by how much, or how far the
    /// method came where others find tensions.
    pub fn reason(&self) -> Option<String> {
        match self.status {
            Status::Feasible => None,
            Status::Undecided => Some(UNDECIDED.to_owned()),
            Status::Infeasible => Some(self.proof()),
            Status::NotFound => {
                let method = self.method;
                let missed = self.missed_limits();
                let so_far = match self.cause {
                    Cause::TooManyFaces { dimension } => format!(
                        "the allowed tensions have {dimension} dimensions, and faces of faces of their set are too many to add up"
                    ),
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
        match (self.method, self.missed_limits()) {
            (Method::ClosedForm, missed) if !missed.is_empty() => {
                format!("{missed}; no tensions keep the limits: {words}")
            }
            _ => words,
        }
    }

    /// "cable 3 has 9100.0 N, its largest tension is 9000 N; …"
    fn missed_limits(&self) -> String {
        missed_limits(&self.tensions, &self.limits).join("; ")
    }
}

/// A sentence per cable that is beyond a limit.
pub(super) fn missed_limits(tensions: &[f64], limits: &Limits) -> Vec<String> {
    let tolerance = limits.tolerance();
    let beyond = |(index, &f): (usize, &f64)| {
        let (least, largest) = (limits.minimum()[index], limits.maximum()[index]);
        match (f < least - tolerance, f > largest + tolerance) {
            (true, _) => Some(format!("cable {} has {f:.1} N, its least tension is {least} N", index + 1)),
            (_, true) => Some(format!("cable {} has {f:.1} N, its largest tension is {largest} N", index + 1)),
            _ => None,
        }
    };
    tensions.iter().enumerate().filter_map(beyond).collect()
}
