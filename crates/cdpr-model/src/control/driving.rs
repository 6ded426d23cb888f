//! A control model on a machine, used from several threads.

use super::input_error::InputError;
use super::operation::Operation;
use super::outcome::Outcome;
use crate::control::controller::Control;
use crate::control::{CommandedPose, History, Reach};
use crate::geometry::Pose;
use crate::model::Model;

/// Control model, machine and set winches; every answer begins from a copy of the same operation.
///
/// The answer at a pose does not depend on other poses: machines with hysteresis come to each one from the initial
/// pose, since in an order of their own the points of a map would depend on that order.
#[derive(Clone, Debug)]
pub struct Driving {
    control: Control,
    offsets: Vec<f64>,
    history: Option<(History, Pose)>,
    operation: Operation,
}

/// Number of poses that a thread takes at a time: the same for any number of threads, since batches are answered
/// together.
const SHARE: usize = 64;

impl Driving {
    /// Refuses the input that [`Operation::new`] refuses; `offsets` are those of [`super::winch_offsets`] (m).
    pub fn new(control: impl Into<Control>, machine: &Model, offsets: &[f64]) -> Result<Self, InputError> {
        let control = control.into();
        let operation = Operation::new(control.clone(), machine, offsets)?;
        Ok(Self { control, offsets: offsets.to_vec(), history: None, operation })
    }

    /// Lets cables with memory come to every pose from this one in steps, as in [`Operation::with_history`].
    #[must_use]
    pub fn with_history<'h>(mut self, history: impl Into<Option<&'h History>>, start: &Pose) -> Self {
        let Some(history) = history.into() else { return self };
        let history = History { reach: Reach::FromInitial, ..*history };
        self.operation = self.operation.with_history(&history, start);
        self.history = Some((history, *start));
        self
    }

    /// Without further starts of the forward problem: the machine comes to rest from the commanded pose, or not at all.
    #[must_use]
    pub fn without_restarts(mut self) -> Self {
        self.operation = self.operation.without_restarts();
        self
    }

    /// The same with the control model without its map; `None` if it has none.
    pub fn without_map(&self) -> Option<Self> {
        let operation = self.operation.without_map()?;
        Some(Self { control: Control { compensation: None, ..self.control.clone() }, operation, ..self.clone() })
    }

    /// The control model.
    pub fn control(&self) -> &Control {
        &self.control
    }

    /// The machine.
    pub fn machine(&self) -> &Model {
        self.operation.machine()
    }

    /// Winch offsets, added to the control model's lengths (m).
    pub fn offsets(&self) -> &[f64] {
        &self.offsets
    }

    /// History with which cables with memory come to every pose, and its initial pose.
    pub fn history(&self) -> Option<&(History, Pose)> {
        self.history.as_ref()
    }

    /// A copy of the operation as it was set.
    pub fn operation(&self) -> Operation {
        self.operation.clone()
    }

    /// Outcome of one commanded pose.
    pub fn outcome(&self, pose: &Pose) -> Outcome {
        self.operation().answer(&CommandedPose::at(*pose))
    }

    /// Outcomes of many commanded poses; with the feature `parallel` threads divide them, with the same answers.
    pub fn outcomes(&self, poses: &[Pose]) -> Vec<Outcome> {
        self.each_share(poses, |poses| {
            let mut operation = self.operation();
            poses.iter().map(|pose| operation.answer(&CommandedPose::at(*pose))).collect()
        })
    }

    /// Applies `of` to parts of many items, which threads take in turn; returns the answers in the order of the items.
    pub fn each_share<I: Sync, T: Send>(&self, items: &[I], of: impl Fn(&[I]) -> Vec<T> + Send + Sync) -> Vec<T> {
        #[cfg(feature = "parallel")]
        {
            use rayon::prelude::*;
            items.par_chunks(SHARE).flat_map_iter(of).collect()
        }
        #[cfg(not(feature = "parallel"))]
        items.chunks(SHARE).flat_map(of).collect()
    }
}
