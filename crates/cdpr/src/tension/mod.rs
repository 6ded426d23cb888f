//! Cable tensions that balance a load: Aᵀ f + w = 0 read for f.
//!
//! With more cables than degrees of freedom many tensions balance the same load. [`closed_form`] takes the ones nearest to
//! the middle of the limits and does not ask whether they keep them; [`quadratic`] takes the nearest ones that do, or proves
//! that there are none and says which cables cannot. Both work on a structure matrix (n×m) and the wrench in its n rows, so
//! any robot and load will do.

pub mod closed_form;
mod error;
mod limits;
pub mod quadratic;

pub use error::InputError;
pub use limits::{Limits, LimitsError};
