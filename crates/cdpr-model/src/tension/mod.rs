//! Cable tensions that balance a load: Aᵀ f + w = 0 read for f.
//!
//! With more cables than degrees of freedom many tensions balance the same load. [`Method`] lists the ways to choose
//! among them, and [`Solver`] runs any of them: near to a reference ([`quadratic`], [`closed_form`]), low or high, in
//! the middle of the allowed set, or as near to the load as the limits permit. All take a structure matrix (n×m) and a
//! wrench with n rows, of any robot and load. If no tensions keep the limits, every method says which limits of which
//! cables exclude the load, with a proof ([`quadratic::Certificate`]).

mod affine;
mod answer;
mod barrier;
mod centroid;
pub mod closed_form;
mod distribute;
mod dykstra;
mod error;
mod improved_closed_form;
mod intervals;
mod limits;
mod method;
mod nearest;
mod nearest_wrench;
mod norm;
mod options;
mod polytope;
mod puncture;
pub mod quadratic;
mod response;
mod smooth;
mod solver;

pub(crate) use affine::null_space;
pub use answer::Answer;
pub use distribute::Status;
pub use error::InputError;
pub use intervals::{Intervals, intervals};
pub use limits::{Limits, LimitsError};
pub use method::{Method, UnknownMethod};
pub use options::{Options, Reference};
pub use response::NotSmooth;
pub use response::Response;
pub use solver::{Solver, solve};
