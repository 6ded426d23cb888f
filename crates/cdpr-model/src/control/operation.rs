//! Operation of a machine by a control model: (x̂, f̂) = υ̂(φ(x) + q_off).

use super::input_error::{InputError, check_same_robot};
use super::machine::Machine;
use super::operation_error::OperationError;
use super::outcome::Outcome;
use super::status::Status;
use super::winding::Winding;
use crate::cable::stretch::hysteresis::Memory;
use crate::compensation::Beyond;
use crate::control::controller::{Control, Controller};
use crate::control::{CommandedPose, History, Reach};
use crate::equilibrium::{Solutions, State};
use crate::geometry::{Pose, PoseBatch};
use crate::model::{Model, WinchError};
use crate::scalar::LaneTable;

/// Emerging poses and tensions of many commands.
pub struct Emerged {
    /// Indices of the commands that were sent.
    pub commanded: Vec<usize>,
    /// Solution of each command that was sent.
    pub solutions: Solutions,
    /// Commanded tensions, cable by cable for each of those commands (N); empty if lengths do not depend on tensions.
    pub commanded_tensions: Vec<f64>,
}

/// A control model on a machine with set winches, which answers pose by pose. A clone is a snapshot: it continues from
/// the same states to the same bytes.
///
/// A kinematic control model sends its geometric lengths. An elastic one sends the controlled lengths q_θ at which its
/// cables, at the commanded pose and under its own load, have the tensions nearest to the middle of the limits (the
/// exact distribution of `cdpr tension`), or those of another method that [`Control`] names. Both send them in the
/// units of their own encoders, length_scale · q_θ + length_offset, corrected by the map that [`Control`] names, which
/// is zero beyond its margin. Winches are commanded by motor angles: if one of the two models has the effect `drum`,
/// these are the angles at which the control model's drums (without the effect: ideal winches) have its lengths, and
/// the machine pays out the lengths of its own drums at them. `offsets` (m, one per cable) are added: those of
/// [`super::winch_offsets`], or zeros. The machine removes scale and offset of its own encoders and answers by its
/// forward problem ([`crate::equilibrium::forward_problem`]): elastic cables, and rigid ones too few to hold the
/// platform, pull or are slack; other rigid ones fit their lengths best.
#[derive(Clone, Debug)]
pub struct Operation {
    control: Controller,
    machine: Machine,
    winding: Winding,
    offsets: Vec<f64>,
    states: States,
    way: Option<PathTaken>,
}

/// States of the control model, with the memories of its commands, and of the machine.
#[derive(Clone, Debug)]
struct States {
    control: State,
    machine: State,
}

/// Point on the path of a machine with hysteresis, passed to an observer.
pub enum PathPoint<'w> {
    /// Control model and machine are at the start of a path.
    Start,
    /// A command and its outcome, before control model and machine settle there.
    Arrival(Arrival<'w>),
}

/// A command on a path with its outcome.
pub struct Arrival<'w> {
    /// The command.
    pub command: &'w CommandedPose,
    /// Outcome of the command.
    pub outcome: &'w Outcome,
    /// Memories of the control model's cables before it.
    pub control: &'w [Memory],
    /// Memories of the machine's cables before it.
    pub machine: &'w [Memory],
}

/// Path of a machine with hysteresis so far.
#[derive(Clone, Debug)]
struct PathTaken {
    history: History,
    /// Pose at which every path begins.
    start_pose: Pose,
    start: States,
    /// Last command; `None` before the first one.
    last: Option<Pose>,
}

impl Operation {
    /// An operation with these winch offsets (m). Refuses different robots, and elastic ones with an unknown load or
    /// limits.
    pub fn new(control: impl Into<Control>, machine: &Model, offsets: &[f64]) -> Result<Self, InputError> {
        let control = control.into();
        check_same_robot(&control.model, machine)?;
        let (expected, found) = (machine.cable_count(), offsets.len());
        if expected != found {
            return Err(InputError::Count { key: "offset_m", expected, found });
        }
        let winding = Winding::new(&control.model, machine)?;
        let states = States { control: State::at_home(&control.model), machine: State::at_home(machine) };
        let (control, machine) = (Controller::new(control)?, Machine::new(machine)?);
        Ok(Self { control, machine, winding, offsets: offsets.to_vec(), states, way: None })
    }

    /// The machine.
    pub fn machine(&self) -> &Model {
        self.machine.model()
    }

    /// True if tensions emerge with the pose.
    pub fn knows_tensions(&self) -> bool {
        self.machine.knows_tensions()
    }

    /// Reaches each pose from the initial one, or from the one before, on a path that changes the memories of the
    /// machine's cables, and those of the control model's cables as commanded; no effect for machines without
    /// hysteresis. Without this call every pose is reached at once by cables that were never loaded.
    #[must_use]
    pub fn with_history<'h>(self, history: impl Into<Option<&'h History>>, start: &Pose) -> Self {
        self.with_history_along(history.into().map(|history| (history, start)), &mut |_| ())
    }

    /// [`Operation::with_history`] that passes the start of the path to an observer.
    pub fn with_history_along(
        mut self,
        history: Option<(&History, &Pose)>,
        observe: &mut dyn FnMut(PathPoint<'_>),
    ) -> Self {
        if let Some((history, start)) = history.filter(|_| self.machine.remembers()) {
            self.begin(history, start, observe);
        }
        self
    }

    /// Begins a path at a pose, with control model and machine at rest there and cables that were never loaded.
    fn begin(&mut self, history: &History, start: &Pose, observe: &mut dyn FnMut(PathPoint<'_>)) {
        let state = |model: &Model| State::at(model, start);
        self.states = States { control: state(self.control.model()), machine: state(self.machine.model()) };
        let _ = self.settled(&CommandedPose::at(*start), observe);
        self.way = Some(PathTaken { history: *history, start_pose: *start, start: self.states.clone(), last: None });
    }

    /// The operation without further starts of the forward problem: the machine comes to rest from the commanded pose,
    /// or not at all.
    #[must_use]
    pub(crate) fn without_restarts(mut self) -> Self {
        self.machine = self.machine.without_restarts();
        if let Some(way) = self.way.take() {
            self.begin(&way.history, &way.start_pose, &mut |_| ());
        }
        self
    }

    /// The operation with the control model without its map, its path begun anew; `None` if it has none.
    pub fn without_map(&self) -> Option<Self> {
        self.control.compensation()?;
        let Self { control, way, .. } = self.clone();
        let mut alone = Self { control: control.without_map(), way: None, ..self.clone() };
        if let Some(way) = way {
            alone.begin(&way.history, &way.start_pose, &mut |_| ());
        }
        Some(alone)
    }

    /// Poses at which the map's correction fades or is zero; empty without a map.
    pub fn beyond_map(&self, poses: impl Iterator<Item = Pose>) -> Beyond {
        let map = self.control.compensation();
        map.map_or_else(Beyond::default, |map| Beyond::of(poses.map(|pose| map.at(&pose).fraction)))
    }

    /// Lengths that the control model sends for a pose, without the winch offsets (m); an error if it has none.
    pub fn command(&mut self, pose: &Pose) -> Result<Vec<f64>, OperationError> {
        self.control.lengths(pose, None, &mut self.states.control)
    }

    /// Controlled lengths of the machine's cables for a commanded pose (m); an error if there are none.
    pub fn controlled_lengths(&mut self, pose: &Pose) -> Result<Vec<f64>, OperationError> {
        let sent = self.sent(&CommandedPose::at(*pose))?;
        let paid_out = self.winding.to_machine(&sent)?;
        let machine = self.machine.model();
        Ok(paid_out.iter().enumerate().map(|(cable, &length)| machine.controlled_length(cable, length)).collect())
    }

    /// Tensions of the last command (N), if the control model commands tensions.
    pub fn commanded_tensions(&self) -> Option<Vec<f64>> {
        self.control.tensions().map(<[f64]>::to_vec)
    }

    /// Lengths that the winches pay out for these sent lengths, in the units of the machine's encoders (m).
    pub fn paid_out(&self, sent: &[f64]) -> Result<Vec<f64>, WinchError> {
        self.winding.to_machine(sent)
    }

    /// [`Operation::controlled_lengths`] of many poses at once, with the same bits; `None` with drums or with lengths
    /// that depend on tensions, or if a pose has no lengths.
    fn kinematic_lengths(&self, poses: &PoseBatch) -> Option<LaneTable> {
        let control = self.control.kinematic().filter(|_| self.winding.is_none())?;
        let (machine, cables) = (self.machine.model(), control.cable_count());
        let mut lengths = LaneTable::default();
        control.batch_cable_lengths(poses, &mut lengths);
        for (index, line) in lengths.lines_mut().iter_mut().enumerate() {
            let cable = index % cables;
            for length in &mut line.0 {
                let sent = control.recorded_length(cable, *length) + self.offsets[cable];
                *length = machine.controlled_length(cable, sent);
            }
        }
        (0..cables).all(|cable| lengths.row(cable).all(f64::is_finite)).then_some(lengths)
    }

    /// Emerging poses and tensions for many commands at once, of those for which the control model has lengths; with
    /// `only_taut` only those with every cable taut. `None` for rigid machines, and for those with a history.
    pub fn answer_all(&mut self, poses: &[Pose], only_taut: bool) -> Option<Emerged> {
        if self.way.is_some() || !self.machine.knows_tensions() {
            return None;
        }
        let mut guesses = PoseBatch::default();
        guesses.fill(poses);
        let (mut commanded, mut commanded_tensions): (Vec<usize>, _) = ((0..poses.len()).collect(), Vec::new());
        let lengths = self.kinematic_lengths(&guesses).unwrap_or_else(|| {
            let mut lengths = LaneTable::new(self.machine().cable_count());
            (guesses, commanded) = (PoseBatch::default(), Vec::with_capacity(poses.len()));
            for (index, pose) in poses.iter().enumerate() {
                if let Ok(controlled) = self.controlled_lengths(pose) {
                    lengths.resize(commanded.len() + 1);
                    lengths.write(commanded.len(), &controlled);
                    guesses.push(pose);
                    commanded.push(index);
                    commanded_tensions.extend(self.control.tensions().into_iter().flatten());
                }
            }
            lengths
        });
        let solutions = self.machine.answer_all(&lengths, &guesses, only_taut, &mut self.states.machine)?;
        Some(Emerged { commanded, solutions, commanded_tensions })
    }

    /// Outcome of one command.
    pub fn answer(&mut self, command: &CommandedPose) -> Outcome {
        self.answer_along(command, &mut |_| ())
    }

    /// [`Operation::answer`] that passes every point of the path to an observer.
    pub fn answer_along(&mut self, command: &CommandedPose, observe: &mut dyn FnMut(PathPoint<'_>)) -> Outcome {
        let Some(mut way) = self.way.take() else {
            observe(PathPoint::Start);
            return self.arrived(command, observe);
        };
        let outcome = self.go(&mut way, command, observe);
        self.way = Some(way);
        outcome
    }

    /// Goes the sub-steps of a path to its end; control model and machine settle at every equilibrium.
    fn go(&mut self, way: &mut PathTaken, command: &CommandedPose, observe: &mut dyn FnMut(PathPoint<'_>)) -> Outcome {
        let last = way.last.filter(|_| way.history.reach == Reach::InOrder);
        if last.is_none() {
            self.states.clone_from(&way.start);
            observe(PathPoint::Start);
        }
        let from = last.unwrap_or(way.start_pose);
        let whole = from.displacement_to(&command.pose);
        let steps = way.history.sub_steps;
        for step in 1..steps {
            let fraction = f64::from(step) / f64::from(steps);
            let _ = self.settled(&CommandedPose::at(from.displaced(&(whole * fraction))), observe);
        }
        way.last = Some(command.pose);
        self.settled(command, observe)
    }

    /// Outcome of a command; control model and machine settle there if it is an equilibrium.
    fn settled(&mut self, command: &CommandedPose, observe: &mut dyn FnMut(PathPoint<'_>)) -> Outcome {
        let outcome = self.arrived(command, observe);
        if outcome.status == Status::Converged {
            self.states.machine.settle_forward(self.machine.model());
            self.states.control.settle_inverse(self.control.model());
        }
        outcome
    }

    /// Outcome of a command, passed to the observer with the memories before it.
    fn arrived(&mut self, command: &CommandedPose, observe: &mut dyn FnMut(PathPoint<'_>)) -> Outcome {
        let outcome = self.reach(command);
        let (control, machine) = (self.states.control.memories(), self.states.machine.memories());
        observe(PathPoint::Arrival(Arrival { command, outcome: &outcome, control, machine }));
        outcome
    }

    /// Lengths sent to the winches (m): φ(x) + q_off, with the cable of a tension test shortened.
    fn sent(&mut self, command: &CommandedPose) -> Result<Vec<f64>, OperationError> {
        let mut sent = self.control.lengths(&command.pose, command.tensions.as_deref(), &mut self.states.control)?;
        sent.iter_mut().zip(&self.offsets).for_each(|(length, offset)| *length += offset);
        if let Some(test) = command.shortened {
            sent[test.cable] -= test.by;
        }
        Ok(sent)
    }

    /// Outcome of a command without sub-steps.
    fn reach(&mut self, command: &CommandedPose) -> Outcome {
        let sent = match self.sent(command) {
            Ok(lengths) => lengths,
            Err(reason) => return nothing_sent(&command.pose, &reason),
        };
        let paid_out = match self.winding.to_machine(&sent) {
            Ok(lengths) => lengths,
            Err(reason) => return nothing_sent(&command.pose, &reason),
        };
        let commanded_tensions = self.commanded_tensions();
        let mut outcome = self.machine.answer(paid_out, &command.pose, &mut self.states.machine);
        (outcome.sent, outcome.commanded_tensions) = (sent, commanded_tensions);
        if let Ok(recorded) = self.winding.to_control(&outcome.recorded) {
            outcome.recorded = recorded;
        }
        outcome.recorded.iter_mut().zip(&self.offsets).for_each(|(length, offset)| *length -= offset);
        outcome
    }
}

fn nothing_sent(commanded: &Pose, reason: &dyn std::error::Error) -> Outcome {
    Outcome {
        pose: *commanded,
        sent: Vec::new(),
        recorded: Vec::new(),
        tensions: None,
        commanded_tensions: None,
        status: Status::NotCommanded,
        reason: Some(reason.to_string()),
    }
}
