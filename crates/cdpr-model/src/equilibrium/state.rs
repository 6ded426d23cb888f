//! State of a robot: its pose, the memories of its cables, and the memory in which its problems are solved.

mod balanced;
mod single_pose;

use balanced::Balanced;

use super::Solution;
use super::inverse_solution::InverseSolution;
use super::scratch::Scratch;
use super::start::Start;
use crate::cable::stretch::hysteresis::Memory;
use crate::geometry::Pose;
use crate::model::Model;

/// State of a robot under one model, owned by the caller.
///
/// [`Model::inverse`] and [`Model::forward`] read the memories of the cables and write their answer into the state;
/// neither moves the robot: any number of problems may be solved before `State::settle_forward` or
/// `State::settle_inverse` moves it. The same state and the same input give the same bytes; a clone is a snapshot, and
/// putting it back restores the robot.
///
/// ```
/// use cdpr::equilibrium::State;
/// use cdpr::model::{Composition, Model};
/// # let robot = cdpr::robot::Robot::builtin("planar-example").ok_or("unknown robot")?;
/// let model = Model::new(robot, Composition::ELASTIC)?;
/// let mut state = State::at_home(&model);
/// let command = model.inverse(&state.pose(), &[6000.0, 6000.0, 2500.0, 2500.0], &mut state)?;
/// let lengths = command.controlled_lengths()?;
/// let snapshot = state.clone();
/// let emerged = model.forward(&lengths, None, None, &mut state)?.pose;
/// # let mut state = snapshot;
/// assert_eq!(model.forward(&lengths, None, None, &mut state)?.pose, emerged);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct State {
    pose: Pose,
    /// Memory of every cable; empty if the laws have none.
    memories: Vec<Memory>,
    pub(super) inverse: InverseSolution,
    pub(super) scratch: Option<Scratch>,
    pub(super) start: Start,
    balanced: Option<Balanced>,
}

impl State {
    /// The robot at rest at a pose, with cables that were never loaded.
    pub fn at(model: &Model, pose: &Pose) -> Self {
        let virgin = |cable: usize| model.law(cable).stretch.memory().copied();
        Self {
            pose: *pose,
            memories: (0..model.cable_count()).filter_map(virgin).collect(),
            inverse: InverseSolution::unsolved(model.cable_count()),
            scratch: None,
            start: Start::Guess,
            balanced: None,
        }
    }

    /// [`State::at`] the home pose of the robot, or at the middle of its frame anchors if its file states none.
    pub fn at_home(model: &Model) -> Self {
        Self::at(model, &model.robot().home_or_middle())
    }

    /// Pose at which the robot settled last.
    pub fn pose(&self) -> Pose {
        self.pose
    }

    /// Memory of every cable (strain and stops of its hysteresis); empty if the laws have none.
    pub fn memories(&self) -> &[Memory] {
        &self.memories
    }

    /// Start of the search of the last [`Model::forward`].
    pub fn start(&self) -> Start {
        self.start
    }

    /// Answer of the last [`Model::forward`]; `None` before the first.
    pub(crate) fn forward_solution(&self) -> Option<&Solution> {
        self.scratch.as_ref().map(Scratch::solution)
    }

    /// Moves the robot to the pose of the last [`Model::forward`] and updates the memories of its cables. Does nothing
    /// before the first.
    pub fn settle_forward(&mut self, model: &Model) {
        let Some(solution) = self.scratch.as_ref().map(Scratch::solution) else { return };
        self.pose = solution.pose;
        remember(&mut self.memories, model, solution.tensions.iter().copied());
    }

    /// Moves the robot to the pose of the last [`Model::inverse`], and updates the memories of its cables from its
    /// tensions.
    pub fn settle_inverse(&mut self, model: &Model) {
        self.pose = self.inverse.pose;
        remember(&mut self.memories, model, self.inverse.cables.iter().map(|cable| cable.outlet_tension));
    }
}

/// Moves every memory to a tension at the cable's outlet (N); a tension that is not finite changes nothing.
fn remember(memories: &mut [Memory], model: &Model, tensions: impl Iterator<Item = f64>) {
    for (cable, (memory, tension)) in memories.iter_mut().zip(tensions).enumerate() {
        if tension.is_finite() {
            let next = model.law(cable).stretch.with_memory(memory).memory_at(tension);
            *memory = next.unwrap_or(*memory);
        }
    }
}
