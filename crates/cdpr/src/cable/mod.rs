//! What one cable does, one file per effect, written once over [`crate::scalar::Real`].

mod course;
pub mod elasticity;
pub mod law;
pub mod outlet;
pub mod span;
pub mod stretch;
pub mod winch;

pub use course::{Course, DegenerateCourse};
