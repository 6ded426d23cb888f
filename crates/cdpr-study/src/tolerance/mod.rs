//! Tolerances of numbers: the effect of deviations on the accuracy, and the deviations that an accuracy allows.
//!
//! [`Spread`] is linear: independent deviations with standard deviations σ_p move the position by the root mean square
//! s(x) = √(Σ σ_p² ‖∂r/∂p‖²), and by Σ τ_p ‖∂r/∂p‖ at most. [`monte_carlo`] draws robots, exactly or linearly.
//! [`allowed`] solves the inverse question.

mod allowed;
mod batch;
mod deviations;
mod monte_carlo;
mod robots;

pub use allowed::{Allowance, Allowed, allowed};
pub use deviations::{DeviationSettings, Deviations};
pub use monte_carlo::{DrawnPart, Engine, MonteCarlo, Quantiles, Settings, monte_carlo};

use super::sensitivity::{ParameterDeviation, PoseSensitivity};

/// Spread of the position by deviations, to first order.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// Root mean square over robots of the distance from the position of the robot without deviations (m), pose by
    /// pose; NaN without derivatives.
    pub deviation: Vec<f64>,
    /// Root mean square of the distance from the commanded position (m), pose by pose.
    pub error: Vec<f64>,
    /// Bound of the distance from the position of the robot without deviations, with all deviations at their worst (m).
    pub worst_case: Vec<f64>,
}

impl Spread {
    /// Spread for these standard deviations (one per cause, in its unit); in the worst case each deviates by `reach`
    /// times its own.
    pub fn of(poses: &[PoseSensitivity], errors: &[f64], sigmas: &[f64], reach: f64, translations: usize) -> Self {
        let mut spread = Self { deviation: Vec::new(), error: Vec::new(), worst_case: Vec::new() };
        for (at, error) in poses.iter().zip(errors) {
            let Ok(derivatives) = &at.derivatives else {
                for list in [&mut spread.deviation, &mut spread.error, &mut spread.worst_case] {
                    list.push(f64::NAN);
                }
                continue;
            };
            let moved =
                sigmas.iter().enumerate().map(|(cause, sigma)| sigma * derivatives.position(translations, cause));
            let (squares, sum) = moved.fold((0.0, 0.0), |(squares, sum), way| (squares + way * way, sum + way));
            spread.deviation.push(squares.sqrt());
            spread.error.push((error * error + squares).sqrt());
            spread.worst_case.push(reach * sum);
        }
        spread
    }
}

/// Standard deviation of every cause, from a study's tolerances.
pub fn sigmas(causes: &[ParameterDeviation], tolerances: &super::study::Tolerances) -> Vec<f64> {
    causes.iter().map(|cause| tolerances.sigma(cause)).collect()
}
