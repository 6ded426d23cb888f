//! A control model on a machine, asked from several threads.

use std::sync::{Mutex, PoisonError};

use super::control::Control;
use super::input_error::InputError;
use super::operate::{Operation, Outcome, Status};
use super::study::{CommandedPose, History, Reach};
use crate::geometry::Pose;
use crate::model::Model;

/// Control model, machine and winches that are set, with operations that threads take and put back.
///
/// Every pose is answered for itself: machines with history come to each one from the initial pose, for in an order of their
/// own the points of a map would say more of the order than of the machine.
pub struct Driving<'a> {
    control: Control<'a>,
    machine: &'a Model,
    offsets: Vec<f64>,
    history: Option<(History, Pose)>,
    restarts: bool,
    idle: Mutex<Vec<Operation<'a>>>,
}

/// Poses that a thread answers before it looks for more: the same on any number of threads, as batches are answered together.
const SHARE: usize = 64;

impl<'a> Driving<'a> {
    /// Refuses what [`Operation::new`] refuses; `offsets` are those of [`super::winch_offsets`] (m).
    pub fn new(control: impl Into<Control<'a>>, machine: &'a Model, offsets: &[f64]) -> Result<Self, InputError> {
        let control = control.into();
        let operation = Operation::new(control, machine, offsets)?;
        let idle = Mutex::new(vec![operation]);
        Ok(Self { control, machine, offsets: offsets.to_vec(), history: None, restarts: true, idle })
    }

    /// Cables that remember come to every pose from this one in steps, as [`Operation::with_history`] says.
    #[must_use]
    pub fn with_history(mut self, history: &History, start: &Pose) -> Self {
        self.history = Some((History { reach: Reach::FromInitial, ..*history }, *start));
        self.idle = Mutex::default();
        self
    }

    /// The machine comes to rest where it is led from the commanded pose, or nowhere: no other starts are tried for it.
    #[must_use]
    pub fn without_restarts(mut self) -> Self {
        self.restarts = false;
        self.idle = Mutex::default();
        self
    }

    /// The control model.
    pub fn control(&self) -> Control<'a> {
        self.control
    }

    /// The machine.
    pub fn machine(&self) -> &'a Model {
        self.machine
    }

    /// What is added to the control model's lengths (m).
    pub fn offsets(&self) -> &[f64] {
        &self.offsets
    }

    /// How cables that remember come to every pose, and from where.
    pub(super) fn history(&self) -> Option<&(History, Pose)> {
        self.history.as_ref()
    }

    /// Work with an operation of its own; nothing if none can be made, which [`Driving::new`] has ruled out.
    pub(super) fn with<T>(&self, work: impl FnOnce(&mut Operation<'a>) -> T) -> Option<T> {
        let idle = || self.idle.lock().unwrap_or_else(PoisonError::into_inner);
        let waiting = idle().pop();
        let mut operation = waiting.or_else(|| self.begin().ok())?;
        let answer = work(&mut operation);
        idle().push(operation);
        Some(answer)
    }

    fn begin(&self) -> Result<Operation<'a>, InputError> {
        let operation = Operation::new(self.control, self.machine, &self.offsets)?;
        let operation = if self.restarts { operation } else { operation.without_restarts() };
        Ok(match &self.history {
            Some((history, start)) => operation.with_history(history, start),
            None => operation,
        })
    }

    /// What emerges when a pose is commanded.
    pub fn outcome(&self, pose: &Pose) -> Outcome {
        let answer = self.with(|operation| operation.answer(&CommandedPose::at(*pose)));
        answer.unwrap_or_else(|| Outcome {
            pose: *pose,
            sent: Vec::new(),
            recorded: Vec::new(),
            tensions: None,
            status: Status::NotCommanded,
            reason: Some("the machine cannot be driven".to_owned()),
        })
    }

    /// What emerges for each of many poses; threads share them with the feature `parallel`, with the same answers.
    pub fn outcomes(&self, poses: &[Pose]) -> Vec<Outcome> {
        self.each(poses, |pose| self.outcome(pose))
    }

    /// Something of each of many items, which threads take in shares of their own.
    pub(super) fn each_share<I: Sync, T: Send>(
        &self,
        items: &[I],
        of: impl Fn(&[I]) -> Vec<T> + Send + Sync,
    ) -> Vec<T> {
        #[cfg(feature = "parallel")]
        {
            use rayon::prelude::*;
            items.par_chunks(SHARE).flat_map_iter(of).collect()
        }
        #[cfg(not(feature = "parallel"))]
        items.chunks(SHARE).flat_map(of).collect()
    }

    /// Something of each of many items, in their order.
    pub(super) fn each<I: Sync, T: Send>(&self, items: &[I], of: impl Fn(&I) -> T + Send + Sync) -> Vec<T> {
        #[cfg(feature = "parallel")]
        {
            use rayon::prelude::*;
            items.par_iter().with_min_len(SHARE).map(of).collect()
        }
        #[cfg(not(feature = "parallel"))]
        items.iter().map(of).collect()
    }
}
