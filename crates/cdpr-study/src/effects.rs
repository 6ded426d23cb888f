//! Contribution of each effect at a pose: the machine has all effects that its file supports, the control model leaves
//! one out.
//!
//! The control model computes the controlled lengths for the pose and its tensions; the machine answers with another
//! pose and other tensions. The difference of the lengths δq_θ is the contribution of the effect to the cable. Winch
//! offsets set at the home pose compensate the difference there, so that in operation only its change from the home
//! pose to this one counts.

mod displacement;
mod error;

use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model, ModelError, Supported, WinchError};
use cdpr_model::robot::{Cable, Law, Robot};
use cdpr_model::statics::{Load, LoadError, controlled_lengths};

pub use displacement::{Displacement, DisplacementMethod, EffectState, displacement, largest};
pub use error::EffectError;

/// Contribution of one effect. A quantity that cannot be computed has a reason instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Contribution {
    /// The effect.
    pub effect: &'static str,
    /// The effect that the control model has in its place; `None` if it is left out.
    pub replaced_by: Option<&'static str>,
    /// The effects of the control model.
    pub control: Composition,
    /// Controlled lengths of the control model minus those of the machine, per cable (m).
    pub lengths: Result<Vec<f64>, EffectError>,
    /// Largest change of the tensions that balance the load and are nearest to the middle of the limits (N).
    pub distribution: Result<f64, EffectError>,
    /// Displacement of the machine's platform under the control model's lengths.
    pub platform: Result<Displacement, EffectError>,
    /// The lengths minus those at the home pose: the part that winch offsets set there do not compensate (m).
    pub lengths_beyond_home: Result<Vec<f64>, EffectError>,
    /// Displacement of the platform under these lengths.
    pub platform_beyond_home: Result<Displacement, EffectError>,
}

/// Contributions of the effects of a machine with the richest composition that its robot supports: of each on its own,
/// and of alternatives.
pub fn contributions(
    machine: &Model,
    supported: &Supported,
    state: &EffectState,
) -> Result<Vec<Contribution>, ModelError> {
    let left_out = machine.composition().effects().map(|effect| (effect, None, machine.composition().without(effect)));
    let replaced = supported
        .alternatives
        .iter()
        .map(|&(alternative, effect)| (effect, Some(alternative), supported.with_alternative(alternative)));
    let home = home(machine, state);
    left_out
        .chain(replaced)
        .map(|(effect, replaced_by, control)| {
            let control = Model::new(machine.robot().clone(), control)?;
            let comparison = Comparison { machine, control: &control };
            Ok(comparison.contribution(effect, replaced_by, state, home.as_ref()))
        })
        .collect()
}

/// The state at the home pose under the same load.
fn home(machine: &Model, state: &EffectState) -> Result<EffectState, EffectError> {
    let pose = machine.robot().home.ok_or(EffectError::NoHome)?;
    if pose == state.pose {
        return Ok(state.clone());
    }
    let tensions = match distribution(machine, &pose, &state.load) {
        Ok(tensions) => Some(tensions),
        Err(_) if machine.lengths_without_tensions(&pose).is_some() => None,
        Err(reason) => return Err(EffectError::AtHome(Box::new(reason))),
    };
    Ok(EffectState { pose, load: state.load.clone(), tensions })
}

/// The tensions nearest to the middle of the limits that balance the load (N).
fn distribution(model: &Model, pose: &Pose, load: &Result<Load, LoadError>) -> Result<Vec<f64>, EffectError> {
    let load = load.as_ref().map_err(Clone::clone)?;
    let found = model.distribute(pose, load)?;
    match found.reason {
        None => Ok(found.tensions),
        Some(reason) => Err(EffectError::Unbalanced(reason)),
    }
}

/// A machine and a model that controls it.
struct Comparison<'a> {
    machine: &'a Model,
    control: &'a Model,
}

impl Comparison<'_> {
    fn contribution(
        &self,
        effect: &'static str,
        replaced_by: Option<&'static str>,
        state: &EffectState,
        home: Result<&EffectState, &EffectError>,
    ) -> Contribution {
        let lengths = self.lengths(state);
        let lengths_beyond_home = lengths.clone().and_then(|here| {
            let there = self.lengths(home.map_err(Clone::clone)?)?;
            Ok(here.iter().zip(&there).map(|(here, there)| here - there).collect::<Vec<f64>>())
        });
        let moved = |lengths: &Result<Vec<f64>, EffectError>| {
            displacement(self.machine, state, lengths.as_ref().map_err(Clone::clone)?)
        };
        Contribution {
            effect,
            replaced_by,
            control: self.control.composition(),
            distribution: self.distribution(state),
            platform: moved(&lengths),
            platform_beyond_home: moved(&lengths_beyond_home),
            lengths,
            lengths_beyond_home,
        }
    }

    /// Controlled lengths of the control model minus those of the machine (m), for the same tensions at the end where
    /// robots measure them.
    fn lengths(&self, state: &EffectState) -> Result<Vec<f64>, EffectError> {
        let of = |model: &Model| match &state.tensions {
            Some(tensions) => Ok(controlled_lengths(model, &state.pose, tensions)?),
            None => match model.lengths_without_tensions(&state.pose) {
                Some(lengths) => Ok(lengths?),
                None => Err(EffectError::UnknownTensions),
            },
        };
        let paid_out = |(cable, length): (usize, f64)| self.paid_out(cable, length);
        let control: Vec<f64> =
            of(self.control)?.into_iter().enumerate().map(paid_out).collect::<Result<_, WinchError>>()?;
        Ok(control.iter().zip(of(self.machine)?).map(|(control, machine)| control - machine).collect())
    }

    /// The length that the machine pays out for a length of the control model (m): winches follow motor angles, which
    /// the control model without the effect `drum` computes for ideal winches.
    fn paid_out(&self, cable: usize, length: f64) -> Result<f64, WinchError> {
        match self.machine.composition().drum && !self.control.composition().drum {
            true => self.machine.controlled_length_of_motor_angle(cable, self.control.motor_angle(cable, length)?),
            false => Ok(length),
        }
    }

    fn distribution(&self, state: &EffectState) -> Result<f64, EffectError> {
        let of = |model: &Model| distribution(model, &state.pose, &state.load);
        Ok(largest(of(self.control)?.iter().zip(of(self.machine)?).map(|(control, machine)| control - machine)))
    }
}

/// Count of the numbers that an effect needs for all cables, from identification or a test bench: those of the laws in
/// the robot's file.
pub fn parameter_count(effect: &str, robot: &Robot) -> usize {
    let of_cable = |cable: &Cable| match effect {
        "pulley" => 1,
        "drum" => 2,
        word => Law::named(word).map_or(0, |law| law.number_count(cable)),
    };
    robot.cables.iter().map(of_cable).sum()
}

/// Data that an effect needs, in words.
pub fn cost(effect: &str) -> &'static str {
    match effect {
        "pulley" => "a radius per cable; swivel axes and entry points from the drawing",
        "drum" => "radius and start length per cable; pitch, axis and place of the drum from the drawing",
        "catenary" => "nothing to identify: weigh a metre of cable; lengths follow from an iteration",
        "finite-element" => "nothing to identify: as `catenary`, and slower the more elements there are",
        word => Law::named(word).map_or("", |law| law.cost),
    }
}
