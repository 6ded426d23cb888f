//! Virtual measurements of a machine driven by a control model.

use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::CommandedPose;
use super::Control;
use super::InputError;
use super::Operation;
use super::Outcome;
use super::Status;
use crate::geometry::{Pose, Twist};
use crate::measurement::{Samples, SensorSigmas};
use crate::model::Model;

/// Virtual measurements.
#[derive(Clone, Debug)]
pub struct Simulation {
    /// Records of the sensors.
    pub samples: Samples,
    /// True outcomes, sample by sample.
    pub outcomes: Vec<Outcome>,
    /// Indices (from 0) of commanded poses without a sample, with the reason.
    pub left_out: Vec<(usize, String)>,
}

/// Sends every commanded pose through the control model to the machine (see [`Operation`]) and records the outcome with
/// sensor noise: pose, lengths, and the tensions of a machine in equilibrium.
///
/// Recorded lengths are the readings of the machine's encoders, length_scale · q_θ + length_offset − q_off with the
/// length q_θ actually paid out. The winch offset q_off is part of the winch's zero, as on a robot with encoders set to
/// the control model's lengths at the initial pose; the machine's own model therefore explains noise-free samples
/// exactly if −q_off is part of its length offsets. A rigid machine with more cables than degrees of freedom cannot
/// hold contradictory lengths: the platform goes to the least-squares pose, the winches take up the slack, and the
/// encoders record the machine's lengths there. Recorded tensions are tension_scale · f + tension_offset.
pub fn simulate(
    control: impl Into<Control>,
    machine: &Model,
    offsets: &[f64],
    poses: &[CommandedPose],
    noise: &SensorSigmas,
    seed: u64,
) -> Result<Simulation, InputError> {
    simulate_operation(&mut Operation::new(control, machine, offsets)?, poses, noise, seed)
}

/// [`simulate`] with a given operation, e.g. one with history.
pub fn simulate_operation(
    operation: &mut Operation,
    poses: &[CommandedPose],
    noise: &SensorSigmas,
    seed: u64,
) -> Result<Simulation, InputError> {
    let machine = &operation.machine().clone();
    if poses.is_empty() {
        return Err(InputError::NoPoses);
    }
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    // pose and noise streams differ even for the same seed
    rng.set_stream(1);
    let mut sensors = Sensors { machine, noise, normal: move || StandardNormal.sample(&mut rng) };
    let tensions = operation.knows_tensions().then(Vec::new);
    let mut samples = Samples { cable_count: machine.cable_count(), sigmas: *noise, tensions, ..Samples::default() };
    let mut sets = Vec::new();
    let (mut outcomes, mut left_out) = (Vec::new(), Vec::new());
    for (index, commanded) in poses.iter().enumerate() {
        let outcome = operation.answer(commanded);
        if outcome.status != Status::Converged {
            left_out.push((index, outcome.reason.unwrap_or_default()));
            continue;
        }
        sensors.record(&outcome, &mut samples);
        sets.push(commanded.set.clone().unwrap_or_default());
        outcomes.push(outcome);
    }
    samples.set = sets.iter().any(|set| !set.is_empty()).then_some(sets);
    Ok(Simulation { samples, outcomes, left_out })
}

/// The sensors of a machine.
struct Sensors<'a, N: FnMut() -> f64> {
    machine: &'a Model,
    noise: &'a SensorSigmas,
    /// Source of standard normal numbers.
    normal: N,
}

impl<N: FnMut() -> f64> Sensors<'_, N> {
    fn record(&mut self, outcome: &Outcome, samples: &mut Samples) {
        samples.poses.push(self.pose(&outcome.pose));
        let sigma = self.noise.length.unwrap_or(0.0);
        samples.lengths.extend(outcome.recorded.iter().map(|length| length + sigma * (self.normal)()));
        let (Some(real), Some(recorded)) = (&outcome.tensions, &mut samples.tensions) else { return };
        let sigma = self.noise.tension.unwrap_or(0.0);
        for (cable, &tension) in real.iter().enumerate() {
            recorded.push(self.machine.recorded_tension(cable, tension) + sigma * (self.normal)());
        }
    }

    /// The pose with normal errors per axis of the motion pattern.
    fn pose(&mut self, pose: &Pose) -> Pose {
        let (position, rotation) = (self.noise.position.unwrap_or(0.0), self.noise.rotation.unwrap_or(0.0));
        let mut error = Twist::zeros();
        for direction in self.machine.twist_basis() {
            let is_turn = Vector3::from(direction.fixed_rows::<3>(3)).norm() > 0.0;
            error += direction * (if is_turn { rotation } else { position } * (self.normal)());
        }
        pose.displaced(&error)
    }
}
