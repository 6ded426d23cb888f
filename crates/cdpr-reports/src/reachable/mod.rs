//! Poses that a study reaches: answer, picture, and how they move with one number.

mod answer;
mod differential;
mod picture;
mod words;

pub use answer::{ReachableAnswer, Searched};
pub use differential::{Change, Differential, differential};
pub use picture::Picture;
