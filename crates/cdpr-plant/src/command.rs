//! Commands to winches, one per cable, and the kinds of winches that follow them.

use super::cable_motion::CableMotion;
use super::error::StepError;
use super::plant::{Plant, Winches};

/// Largest distance at which a length counts as the present length of a drum (m).
const SAME_LENGTH: f64 = 1e-9;

/// Command to one winch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Command {
    /// Controlled length (m): ideal winches approach it at a constant rate and reach it at the end of the step. A drum
    /// holds its present length with its brake.
    Length(f64),
    /// Rate of the controlled length (m/s), positive if cable is paid out: the length at the end of a step is the
    /// length at its start plus rate × time, rounded once.
    Speed(f64),
    /// Torque of the motor of a drum (N·m), positive if it pulls cable in.
    Torque(f64),
    /// Tension at the outlet (N).
    Tension(f64),
}

impl Command {
    /// Commands of lengths (m), one per cable.
    pub fn lengths(lengths: &[f64]) -> Vec<Self> {
        lengths.iter().copied().map(Self::Length).collect()
    }

    /// Commands of torques (N·m), one per cable.
    pub fn torques(torques: &[f64]) -> Vec<Self> {
        torques.iter().copied().map(Self::Torque).collect()
    }

    /// Name of the quantity in words.
    fn quantity(&self) -> &'static str {
        match self {
            Self::Length(_) => "a length",
            Self::Speed(_) => "a speed",
            Self::Torque(_) => "a torque",
            Self::Tension(_) => "a tension",
        }
    }

    /// The commanded number, in the unit of its quantity.
    fn number(&self) -> f64 {
        match self {
            Self::Length(number) | Self::Speed(number) | Self::Torque(number) | Self::Tension(number) => *number,
        }
    }

    /// True if winches of a kind follow this quantity; drums follow a length only to hold it.
    fn is_for(&self, winches: Winches) -> bool {
        match winches {
            Winches::Ideal => matches!(self, Self::Length(_) | Self::Speed(_)),
            Winches::Drums => matches!(self, Self::Length(_) | Self::Torque(_)),
        }
    }

    /// Linear interpolation from an earlier command of the same quantity at a fraction of the interval; the command
    /// itself if the quantities differ.
    pub(super) fn after(self, before: Self, fraction: f64) -> Self {
        let way = |from: f64, to: f64| if fraction < 1.0 { from + (to - from) * fraction } else { to };
        match (before, self) {
            (Self::Length(from), Self::Length(to)) => Self::Length(way(from, to)),
            (Self::Speed(from), Self::Speed(to)) => Self::Speed(way(from, to)),
            (Self::Torque(from), Self::Torque(to)) => Self::Torque(way(from, to)),
            (Self::Tension(from), Self::Tension(to)) => Self::Tension(way(from, to)),
            _ => self,
        }
    }
}

impl Plant {
    /// Checks that the winches follow the commands, and that there is one per cable.
    pub(super) fn check_commands(&self, cables: &[CableMotion], commands: &[Command]) -> Result<(), StepError> {
        let (expected, found) = (self.model.cable_count(), commands.len());
        if expected != found {
            return Err(StepError::Count { expected, found });
        }
        let winches = self.winches();
        for (index, (command, cable)) in commands.iter().zip(cables).enumerate() {
            let moves = |length: f64| !((length - cable.controlled_length).abs() <= SAME_LENGTH);
            match command {
                _ if !command.is_for(winches) => return Err(refused(index, command, winches)),
                Command::Length(length) if winches == Winches::Drums && moves(*length) => {
                    return Err(refused(index, command, winches));
                }
                _ if !command.number().is_finite() => {
                    return Err(StepError::NotFinite { cable: index + 1, number: command.number() });
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// Error for a command that the winches do not follow, naming the commands that they take and the winches that take
/// this one.
fn refused(index: usize, command: &Command, winches: Winches) -> StepError {
    let takes = match winches {
        Winches::Ideal => "ideal winches take lengths and speeds",
        Winches::Drums => "drums take torques, and hold the length at which they stand",
    };
    let others = match command {
        Command::Length(_) | Command::Speed(_) => "ideal winches follow it",
        Command::Torque(_) => "drums follow it",
        Command::Tension(_) => "no kind of winches follows tensions",
    };
    StepError::Command { cable: index + 1, quantity: command.quantity(), takes, others }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{at_home, plant, plate};
    use super::*;
    use cdpr_model::model::{Composition, Model};

    fn drums() -> Plant {
        let mut robot = plate();
        for cable in &mut robot.cables {
            (cable.winch.radius, cable.winch.drum_inertia) = (Some(0.05), Some(0.02));
        }
        Plant::new(Model::new(robot, Composition::ELASTIC).unwrap(), Winches::Drums).unwrap()
    }

    /// Every command that a winch cannot follow is refused, naming the cable, the commands it takes, and the winches
    /// that take this one.
    #[test]
    fn winches_refuse_what_they_do_not_follow() {
        let (ideal, drums) = (plant(plate(), Composition::ELASTIC, 0.0), drums());
        for (plant, wrong, words) in [
            (&ideal, Command::Torque(1.0), ["a torque", "ideal winches take lengths and speeds", "drums follow it"]),
            (&ideal, Command::Tension(9.0), ["a tension", "ideal winches take", "no kind of winches"]),
            (&drums, Command::Tension(9.0), ["a tension", "drums take torques", "no kind of winches"]),
            (&drums, Command::Speed(0.1), ["a speed", "drums take torques", "ideal winches follow it"]),
            (&drums, Command::Length(0.1), ["a length", "at which they stand", "ideal winches follow it"]),
            (&ideal, Command::Length(f64::NAN), ["cable 3", "NaN", "finite"]),
        ] {
            let mut state = at_home(plant, 60.0);
            let lengths: Vec<f64> = state.cables.iter().map(|cable| cable.controlled_length).collect();
            let mut commands = Command::lengths(&lengths);
            assert!(plant.step(&mut state, &commands, 1e-3).is_ok());
            commands[2] = wrong;
            let before = state.clone();
            let error = plant.step(&mut state, &commands, 1e-3).unwrap_err().to_string();
            assert!(error.contains("cable 3") && words.iter().all(|word| error.contains(word)), "{error}");
            assert_eq!(state, before, "nothing moved");
        }
    }

    /// Lengths and speeds side by side: a speed leads to exactly the length in a table of lengths, without rounding
    /// differences.
    #[test]
    fn speeds_lead_to_the_lengths_of_their_integral() {
        let plant = plant(plate(), Composition::ELASTIC, 4.0);
        let start = at_home(&plant, 60.0);
        let lengths: Vec<f64> = start.cables.iter().map(|cable| cable.controlled_length).collect();
        let (mut by_speed, mut by_length) = (start.clone(), start.clone());
        let mut told = lengths.clone();
        for _ in 0..100 {
            let mut commands = Command::lengths(&lengths);
            commands[1] = Command::Speed(-0.02);
            plant.step(&mut by_speed, &commands, 1e-3).unwrap();
            told[1] += -0.02 * 1e-3;
            plant.step(&mut by_length, &Command::lengths(&told), 1e-3).unwrap();
        }
        assert_eq!(by_speed.cables[1].controlled_length, told[1]);
        assert_eq!(by_speed.cables[0].controlled_length, lengths[0]);
        assert!((by_speed.cables[1].controlled_length - lengths[1] + 0.002).abs() < 1e-13);
        let apart = super::super::tests::apart(&by_speed.pose, &by_length.pose);
        assert!(apart < 1e-12, "{apart:e}");
    }
}
