//! Damped iterations: the one loop under every search for a pose, a cable's state, tensions or parameters.
//!
//! A [`Problem`] supplies its residual, its equations and its retraction; [`descend`] decides when a step counts, when
//! it must be shorter and when it was the last. Numbers are those of one problem (`f64`) or of eight side by side
//! ([`Lanes`](crate::scalar::Lanes)): the decisions are the same code, lane by lane.

pub mod bounded;
mod convergence;
mod damping;
mod descend;
#[cfg(test)]
mod tests;
#[cfg(all(feature = "std", debug_assertions))]
mod trace;

pub use bounded::Room;
pub use damping::OF_SINGULAR;
pub use descend::descend;

use crate::scalar::Select;

/// Predicted fraction of the cost below which the costs before and after a step are too close to judge the prediction.
pub const HIDDEN_GAIN: f64 = 1e-10;
/// Smallest pivot of least squares, relative to its diagonal entry, that determines a direction; without damping, other
/// directions would drift with rounding errors.
pub const REGULAR: f64 = 1e-11;
/// Fraction of a cost that is hidden by rounding.
pub const ROUNDING_GAIN: f64 = 1e-13;

/// Equations of a search, with its current iterate and its trial.
pub trait Problem {
    /// `f64` for one problem, lanes for several.
    type Number: Select;

    /// The step from the current iterate, which the next trials take.
    fn step(&mut self, control: &Control<Self::Number>) -> Step<Self::Number>;

    /// Residual and equations after this fraction of the step (at the start before the first step). Equations are not
    /// needed after a trial that is the last.
    fn evaluate(&mut self, fraction: Self::Number, is_last: bool) -> Trial<Self::Number>;

    /// Moves on to the trial in lanes of the mask `helps`; `contraction` is the ratio of the step to the one before it.
    fn accept(&mut self, helps: Mask<Self>, contraction: Self::Number);

    /// True if the last step is taken without a trial: the search may then end a step earlier.
    #[inline]
    fn takes_last_step(&self) -> bool {
        false
    }

    /// Lanes in which a trial that does not help, after a step of this size, leaves only rounding errors to reduce.
    #[inline(always)]
    fn rests(&mut self, size: Self::Number, tolerance: Self::Number) -> Mask<Self> {
        size.without(size.everywhere(true), tolerance.is_less(size))
    }
}

/// Lanes of a problem in which a statement holds.
pub type Mask<P> = <<P as Problem>::Number as Select>::Mask;

/// Limits of a step.
#[derive(Clone, Copy, Debug)]
pub struct Control<N> {
    /// Addition to the diagonal of the equations, in units of that diagonal.
    pub damping: N,
    /// Longest step, in the unit of [`Step::size`]; infinite unless a trust region limits it.
    pub radius: N,
}

impl Control<f64> {
    /// Control that does not limit a step.
    pub fn none() -> Self {
        Self { damping: 0.0, radius: f64::INFINITY }
    }
}

/// Step of a search.
#[derive(Clone, Copy, Debug)]
pub struct Step<N: Select> {
    /// Length, in the unit of [`Rules::tolerance`].
    pub size: N,
    /// Fraction of the cost that the equations predict the step to remove; infinite if it is not needed.
    pub gain: N,
    /// Lanes in which a region or a bound cut the step: its size and gain are then no measure of the distance to the
    /// solution.
    pub is_cut: N::Mask,
    /// Lanes whose equations have a solution.
    pub is_regular: N::Mask,
}

impl<N: Select> Step<N> {
    /// A step that is not cut, with equations that have a solution in these lanes.
    #[inline(always)]
    pub fn whole(size: N, is_regular: N::Mask) -> Self {
        Self { size, gain: size.constant(f64::INFINITY), is_cut: size.everywhere(false), is_regular }
    }
}

/// Outcome of an evaluation.
#[derive(Clone, Copy, Debug)]
pub struct Trial<N: Select> {
    /// Lanes in which the trial is better than the current iterate.
    pub helps: N::Mask,
    /// Fraction of the cost that the step removed; infinite if it is not needed.
    pub gain: N,
}

impl<N: Select> Trial<N> {
    /// A trial of unknown gain.
    #[inline(always)]
    pub fn new(n: N, helps: N::Mask) -> Self {
        Self { helps, gain: n.constant(f64::INFINITY) }
    }
}

/// Method by which a step that does not help is made shorter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepRule {
    /// Full Gauss–Newton or Newton steps: the first that does not help, or whose ratio to the step before exceeds
    /// `slowest`, ends the search.
    Plain {
        /// Largest contraction of quickly converging steps.
        slowest: f64,
    },
    /// More damping (Levenberg 1944, Marquardt 1963).
    Damping,
    /// The same direction, half as far; for one problem at a time.
    Shortening,
    /// A smaller trust region, with the shape that the problem defines: dogleg (Powell 1970) or reflective (Branch,
    /// Coleman, Li 1999).
    TrustRegion,
}

/// Rules of a search.
#[derive(Clone, Copy, Debug)]
pub struct Rules<N> {
    /// Distance from the solution that ends the search, in the problem's own unit of length.
    pub tolerance: N,
    /// Most steps; a step that is tried again at smaller length counts once.
    pub max_iterations: u32,
    /// A step predicted to remove less than this fraction of the cost ends the search untried; 0 turns this off.
    pub least_gain: f64,
    /// Way in which steps are made shorter.
    pub rule: StepRule,
}

/// End of a search.
#[derive(Clone, Copy, Debug)]
pub struct DescentEnd<N> {
    /// A [`Stop`] as a number.
    stop: N,
    /// Count of steps, unsuccessful ones included; a step that is tried again at smaller length counts once.
    pub iterations: N,
    /// Damping of the last step.
    pub damping: N,
    /// Total length of the remaining steps by the convergence test: of the last step, or of those after it if they
    /// shrink.
    pub left: N,
    /// Fraction of the cost that the last step was predicted to remove.
    pub gain: N,
}

impl<N: Select> DescentEnd<N> {
    /// Lanes that ended with this reason.
    #[inline(always)]
    pub fn is(&self, stop: Stop) -> N::Mask {
        let (code, half) = (stop as u8 as f64, 0.5);
        let n = self.stop;
        n.both(n.constant(code - half).is_less(n), n.is_less(n.constant(code + half)))
    }
}

impl DescentEnd<f64> {
    /// Reason of the end.
    #[inline]
    pub fn stop(&self) -> Stop {
        [Stop::IterationLimit, Stop::Stationary, Stop::Stalled, Stop::Singular, Stop::Degenerate][self.stop as usize]
    }
}

/// Reason why a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The step limit was reached.
    IterationLimit,
    /// The remaining steps are within the tolerance.
    Stationary,
    /// No shorter step helped, though the steps had not become small.
    Stalled,
    /// The equations have no solution at any damping.
    Singular,
    /// The start itself has no residual.
    Degenerate,
}
