//! A control model on a machine, asked from several threads.

use super::input_error::InputError;
use super::operation::Operation;
use super::outcome::Outcome;
use crate::control::controller::Control;
use crate::control::{CommandedPose, History, Reach};
use crate::geometry::Pose;
use crate::model::Model;

/// Control model, machine and winches that are set; every question begins from a copy of the same operation.
///
/// Every pose is answered for itself: machines with history come to each one from the initial pose, for in an order of their
/// own the points of a map would say more of the order than of the machine.
#[derive(Clone, Debug)]
pub struct Driving<'a> {
    control: Control<'a>,
    offsets: Vec<f64>,
    history: Option<(History, Pose)>,
    operation: Operation<'a>,
}

/// Poses that a thread answers before it looks for more: the same on any number of threads, as batches are answered together.
const SHARE: usize = 64;

impl<'a> Driving<'a> {
    /// Refuses what [`Operation::new`] refuses; `offsets` are those of [`super::winch_offsets`] (m).
    pub fn new(control: impl Into<Control<'a>>, machine: &'a Model, offsets: &[f64]) -> Result<Self, InputError> {
        let control = control.into();
        let operation = Operation::new(control, machine, offsets)?;
        Ok(Self { control, offsets: offsets.to_vec(), history: None, operation })
    }

    /// Cables that remember come to every pose from this one in steps, as [`Operation::with_history`] says.
    #[must_use]
    pub fn with_history<'h>(mut self, history: impl Into<Option<&'h History>>, start: &Pose) -> Self {
        let Some(history) = history.into() else { return self };
        let history = History { reach: Reach::FromInitial, ..*history };
        self.operation = self.operation.with_history(&history, start);
        self.history = Some((history, *start));
        self
    }

    /// The machine comes to rest where it is led from the commanded pose, or nowhere: no other starts are tried for it.
    #[must_use]
    pub fn without_restarts(mut self) -> Self {
        self.operation = self.operation.without_restarts();
        self
    }

    /// The same under the control model without its map; `None` if it has none.
    pub fn without_map(&self) -> Option<Self> {
        let operation = self.operation.without_map()?;
        Some(Self { control: Control { compensation: None, ..self.control }, operation, ..self.clone() })
    }

    /// The control model.
    pub fn control(&self) -> Control<'a> {
        self.control
    }

    /// The machine.
    pub fn machine(&self) -> &'a Model {
        self.operation.machine()
    }

    /// Winch offsets, added to the control model's lengths (m).
    pub fn offsets(&self) -> &[f64] {
        &self.offsets
    }

    /// How cables that remember come to every pose, and from where.
    pub fn history(&self) -> Option<&(History, Pose)> {
        self.history.as_ref()
    }

    /// An operation of one's own, as set.
    pub fn operation(&self) -> Operation<'a> {
        self.operation.clone()
    }

    /// Outcome of one commanded pose.
    pub fn outcome(&self, pose: &Pose) -> Outcome {
        self.operation().answer(&CommandedPose::at(*pose))
    }

    /// Outcome of each of many commanded poses; threads share them with the feature `parallel`, with the same answers.
    pub fn outcomes(&self, poses: &[Pose]) -> Vec<Outcome> {
        self.each_share(poses, |poses| {
            let mut operation = self.operation();
            poses.iter().map(|pose| operation.answer(&CommandedPose::at(*pose))).collect()
        })
    }

    /// Applies `of` to shares of many items, which threads take in turn; answers in the order of the items.
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
