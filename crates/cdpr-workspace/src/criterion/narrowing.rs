//! Amount by which tension limits can narrow before no tensions are left.

use nalgebra::DMatrix;

use cdpr_model::tension::quadratic::{Certificate, Solver, Status};
use cdpr_model::tension::{InputError, Limits};

/// Limits that narrow with a number t: f_min + rise · t ≤ f ≤ f_max − fall · t.
#[derive(Clone, Debug)]
pub(super) struct Closing<'a> {
    /// The limits at t = 0.
    pub(super) limits: &'a Limits,
    /// Rate at which the least tensions rise with t.
    pub(super) rise: f64,
    /// Rate at which the largest tensions fall with t.
    pub(super) fall: f64,
}

/// The largest t with tensions between the limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Narrowing {
    /// t; −∞ if no limits allow tensions.
    pub(super) amount: f64,
    /// The cable with the largest weight in the certificate that t cannot be larger.
    pub(super) cable: Option<usize>,
}

/// Programmes solved before the search is given up; at most ten have been observed.
const MAX_PROGRAMMES: u32 = 100;

impl Closing<'_> {
    /// The t at which the limits of a cable meet, and that cable.
    pub(super) fn end(&self) -> Narrowing {
        let mut end = Narrowing { amount: f64::INFINITY, cable: None };
        for (cable, (least, largest)) in self.limits.minimum().iter().zip(self.limits.maximum()).enumerate() {
            let amount = (largest - least) / (self.rise + self.fall);
            if amount < end.amount {
                end = Narrowing { amount, cable: Some(cable) };
            }
        }
        end
    }

    fn at(&self, t: f64) -> Option<Limits> {
        let (least, largest) = (self.limits.minimum().iter(), self.limits.maximum().iter());
        let minimum: Vec<f64> = least.map(|f| f + self.rise * t).collect();
        // limits that meet may cross by rounding
        let maximum = largest.zip(&minimum).map(|(f, least)| (f - self.fall * t).max(*least)).collect();
        Limits::new(minimum, maximum).ok()
    }

    /// The t at which the cables' capacity in the direction of a certificate equals the load there.
    fn exhausted(&self, certificate: &Certificate) -> Narrowing {
        let (mut given, mut fall) = (-certificate.required, 0.0);
        let mut heaviest = (0.0, None);
        for (cable, &weight) in certificate.weights.iter().enumerate() {
            let (limit, rate) = match weight > 0.0 {
                true => (self.limits.maximum()[cable], self.fall),
                false => (self.limits.minimum()[cable], self.rise),
            };
            given += weight * limit;
            fall += weight.abs() * rate;
            if weight.abs() > heaviest.0 {
                heaviest = (weight.abs(), Some(cable));
            }
        }
        // the largest weight is 1, except for a direction in which no cable acts
        if heaviest.0 < 0.5 {
            return Narrowing { amount: f64::NEG_INFINITY, cable: None };
        }
        Narrowing { amount: given / fall, cable: heaviest.1 }
    }
}

/// The largest t up to `start` for which tensions between the limits balance the wrench: max t such that Aᵀ f + w = 0,
/// f_min + rise t ≤ f ≤ f_max − fall t.
///
/// Newton's method on the dual of this linear programme: if the programme at t is infeasible, its certificate y bounds
/// t by the t at which y no longer proves infeasibility; that is the next t. Every certificate comes from a vertex of
/// the dual, so the last of finitely many steps is exact to the rounding of the programme, 1e-10 of the limits.
pub(super) fn largest(
    qp: &mut Solver,
    matrix: &DMatrix<f64>,
    wrench: &[f64],
    closing: &Closing<'_>,
    start: Narrowing,
) -> Result<Narrowing, InputError> {
    let mut best = start;
    for _ in 0..MAX_PROGRAMMES {
        let Some(limits) = closing.at(best.amount) else { break };
        let found = qp.solve(matrix, wrench, &limits, None)?;
        if found.status == Status::Feasible {
            break;
        }
        let Some(certificate) = found.certificate() else { break };
        let next = closing.exhausted(certificate);
        if !(next.amount < best.amount) {
            break; // the remaining change is rounding
        }
        best = next;
        if best.amount == f64::NEG_INFINITY {
            break;
        }
    }
    Ok(best)
}
