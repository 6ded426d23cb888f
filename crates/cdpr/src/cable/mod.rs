//! What one cable does, one file per effect, written once over [`crate::scalar::Real`].

mod course;
pub mod elasticity;
pub mod law;
pub mod outlet;
pub mod span;
mod state;
pub mod stretch;
pub mod winch;
pub(crate) mod wrench;

pub use course::{Course, DegenerateCourse};
pub use state::{CableInput, CableState, CableStateError, Recording};
pub use wrench::CableEnd;
