//! Where a platform can be: criteria that judge one pose, and methods that find the set of poses at which they hold.
//!
//! A [`Criterion`] answers a pose with a [`Verdict`]: a signed margin and, where it fails, the first reason in words.

pub mod criterion;
mod error;
pub mod mesh;
mod verdict;
pub mod wrench_set;

pub use criterion::Criterion;
pub use error::WorkspaceError;
pub use verdict::Verdict;
