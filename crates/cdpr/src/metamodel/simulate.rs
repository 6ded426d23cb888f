//! Virtual measurements of a rigid machine driven by a control model.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use thiserror::Error;

use super::study::{CommandedPose, Initial, with_pose_noise};
use crate::cable::DegenerateCourse;
use crate::equilibrium::forward_kinematics::{self, Status};
use crate::geometry::Pose;
use crate::measurement::{Samples, SensorSigmas};
use crate::model::Model;

/// Virtual measurements.
#[derive(Clone, Debug)]
pub struct Simulation {
    /// What the sensors record.
    pub samples: Samples,
    /// The poses that really emerged, sample by sample.
    pub emerging: Vec<Pose>,
    /// Commanded poses that gave no sample, from 0, with the reason.
    pub left_out: Vec<(usize, String)>,
}

/// A simulation that cannot be run.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum InputError {
    /// Control model and machine are different robots.
    #[error(
        "the control model has {control} cables and the pattern {control_pattern}, the machine {machine} cables and {machine_pattern}"
    )]
    DifferentRobots {
        /// Cables of the control model.
        control: usize,
        /// Its motion pattern.
        control_pattern: &'static str,
        /// Cables of the machine.
        machine: usize,
        /// Its motion pattern.
        machine_pattern: &'static str,
    },
    /// Not one offset per cable.
    #[error("offset_m has {found} entries; the robot has {expected} cables")]
    OffsetCount {
        /// Cables of the robot.
        expected: usize,
        /// Offsets given.
        found: usize,
    },
    /// The winches cannot be set at the initial pose.
    #[error("at the initial pose, {0}")]
    Initial(DegenerateCourse),
    /// No poses to command.
    #[error("the study commands no poses: add [poses.grid], [poses.random] or [poses.file]")]
    NoPoses,
}

/// Winch offsets that a study asks for (m): none, given ones, or those that bring the machine to the initial pose,
/// q_off = φ̂(x_ini) − φ(x_ini), φ the model in use when the winches were set (sec. 3.1; a rigid machine has no tension
/// term).
///
/// The machine's φ̂ is what its winches record, scale and offset included.
pub fn winch_offsets(
    initial: &Initial,
    set_with: &Model,
    machine: &Model,
    pose: &Pose,
) -> Result<Vec<f64>, InputError> {
    let count = machine.cable_count();
    if initial.offset.is_some() {
        return Ok(vec![0.0; count]);
    }
    if let Some(offsets) = &initial.offset_m {
        let found = offsets.len();
        return if found == count {
            Ok(offsets.clone())
        } else {
            Err(InputError::OffsetCount { expected: count, found })
        };
    }
    check_same_robot(set_with, machine)?;
    let wanted = machine.cable_lengths(pose).map_err(InputError::Initial)?;
    let sent = set_with.cable_lengths(pose).map_err(InputError::Initial)?;
    Ok((0..count).map(|cable| machine.recorded_length(cable, wanted[cable]) - sent[cable]).collect())
}

fn check_same_robot(control: &Model, machine: &Model) -> Result<(), InputError> {
    let pattern = |model: &Model| model.robot().motion_pattern.name();
    if control.cable_count() == machine.cable_count() && pattern(control) == pattern(machine) {
        return Ok(());
    }
    Err(InputError::DifferentRobots {
        control: control.cable_count(),
        control_pattern: pattern(control),
        machine: machine.cable_count(),
        machine_pattern: pattern(machine),
    })
}

/// Sends every commanded pose through the control model to the machine and records what emerges, with sensor noise.
///
/// A rigid machine with more cables than degrees of freedom cannot hold lengths that contradict each other: the platform
/// goes to the least-squares pose, the winches take up what is slack, and the encoders record the machine's lengths there.
pub fn simulate(
    control: &Model,
    machine: &Model,
    offsets: &[f64],
    poses: &[CommandedPose],
    noise: &SensorSigmas,
    seed: u64,
) -> Result<Simulation, InputError> {
    check_same_robot(control, machine)?;
    if poses.is_empty() {
        return Err(InputError::NoPoses);
    }
    let cable_count = machine.cable_count();
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    // pose and noise streams differ even for the same seed
    rng.set_stream(1);
    let mut normal = move || -> f64 { StandardNormal.sample(&mut rng) };
    let mut samples = Samples { cable_count, sigmas: *noise, ..Samples::default() };
    let mut sets = Vec::new();
    let (mut emerging, mut left_out) = (Vec::new(), Vec::new());
    for (index, commanded) in poses.iter().enumerate() {
        let (pose, lengths) = match emerge(control, machine, offsets, &commanded.pose) {
            Ok(found) => found,
            Err(reason) => {
                left_out.push((index, reason));
                continue;
            }
        };
        samples.poses.push(with_pose_noise(&pose, machine.twist_basis(), noise, &mut normal));
        let sigma = noise.length.unwrap_or(0.0);
        samples.lengths.extend(lengths.iter().map(|length| length + sigma * normal()));
        sets.push(commanded.set.clone().unwrap_or_default());
        emerging.push(pose);
    }
    samples.set = sets.iter().any(|set| !set.is_empty()).then_some(sets);
    Ok(Simulation { samples, emerging, left_out })
}

/// The pose that emerges and the lengths that are recorded there, for one commanded pose.
fn emerge(control: &Model, machine: &Model, offsets: &[f64], commanded: &Pose) -> Result<(Pose, Vec<f64>), String> {
    let sent = control.cable_lengths(commanded).map_err(|reason| reason.to_string())?;
    let controlled: Vec<f64> =
        (0..sent.len()).map(|cable| machine.controlled_length(cable, sent[cable] + offsets[cable])).collect();
    let settings = forward_kinematics::Settings::default();
    let solution =
        forward_kinematics::solve(machine, &controlled, commanded, &settings).map_err(|error| error.to_string())?;
    if solution.status != Status::Converged {
        return Err(solution.reason.unwrap_or_else(|| "the machine's forward problem has no solution".to_owned()));
    }
    let lengths = machine.cable_lengths(&solution.pose).map_err(|reason| reason.to_string())?;
    let recorded = lengths.iter().enumerate().map(|(cable, &length)| machine.recorded_length(cable, length)).collect();
    Ok((solution.pose, recorded))
}
