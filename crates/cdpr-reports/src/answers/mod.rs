//! Results as JSON objects with units in their keys, and the keys that all of them share.

mod envelope;
mod pose_answer;
mod selection_answer;
mod wrench_answer;

pub use envelope::{Envelope, PROGRAM, simulated_by};
pub use pose_answer::{PoseAnswer, axis_names, components};
pub use selection_answer::{AsGiven, CandidateAnswer, FoldAnswer, JudgedAnswer, SelectionAnswer, Timing};
pub use wrench_answer::WrenchAnswer;
