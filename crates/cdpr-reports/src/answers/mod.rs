//! Results as JSON objects with units in their keys, and the keys that all of them share.

mod advice_answer;
mod envelope;
mod pose_answer;
mod selection_answer;
mod share;
mod wrench_answer;

pub use advice_answer::{AdviceAnswer, AdviceTiming, AdvisedModel, EffectAnswer};
pub use envelope::{Envelope, PROGRAM, simulated_by};
pub use pose_answer::{PoseAnswer, axis_names, components, degrees_of_freedom, title};
pub use selection_answer::{AsGiven, CandidateAnswer, FoldAnswer, JudgedAnswer, SelectionAnswer, Timing};
pub use share::{BEYOND_THE_WHOLE, is_beyond_the_whole};
pub use wrench_answer::WrenchAnswer;
