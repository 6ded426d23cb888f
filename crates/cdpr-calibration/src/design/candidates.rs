//! Poses that could be measured.

use super::plan_error::PlanError;
use super::records::{Record, Records, Unmeasurable, check_levels};
use cdpr_model::control::{CommandedPose, Shortening};
use cdpr_model::equilibrium::State;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::Model;

/// Poses that could be measured, with what the model expects to record there.
#[derive(Clone, Debug)]
pub struct Candidates {
    /// Exact records of the model as it is, under the accuracies of the sensors.
    pub samples: Samples,
    /// Place of each in the list that was asked, from 0.
    pub places: Vec<usize>,
    /// Cable of each that is shortened for a tension test; `None` elsewhere.
    pub tests: Vec<Option<Shortening>>,
    /// Poses of that list that cannot be measured, with the reason.
    pub left_out: Vec<(usize, String)>,
}

impl Candidates {
    /// Poses as they are; elastic models have so many levels of tension at each, the nearest to the middle of the limits first.
    pub fn new(model: &Model, poses: &[Pose], levels: usize, sigmas: SensorSigmas) -> Result<Self, PlanError> {
        let commands: Vec<CommandedPose> = poses.iter().copied().map(CommandedPose::at).collect();
        Self::of_commands(model, &commands, levels, sigmas)
    }

    /// Commands as they are. A tension test is where the model comes to rest with one cable shortened from the middle of the limits.
    pub fn of_commands(
        model: &Model,
        commands: &[CommandedPose],
        levels: usize,
        sigmas: SensorSigmas,
    ) -> Result<Self, PlanError> {
        Self::of(model, commands.iter().map(Ok), levels, sigmas)
    }

    /// Adds every cable in turn shortened by a length (m) at poses of the list that was asked; those that cannot be measured are no candidates.
    pub fn add_tension_tests(&mut self, model: &Model, poses: &[Pose], by: f64) -> Result<(), PlanError> {
        if !model.needs_tensions() {
            return Err(PlanError::TestsOfRigid);
        }
        let (expected, mut state) = (Records::new(model, 1)?, State::at(model, &model.robot().home_or_middle()));
        for (place, pose) in poses.iter().enumerate() {
            for cable in 0..model.cable_count() {
                let test = Some(Shortening { cable, by });
                let command = CommandedPose { shortened: test, ..CommandedPose::at(*pose) };
                let Ok(records) = expected.at(&command, &mut state) else { continue };
                records.into_iter().for_each(|record| self.push((place, test), record));
            }
        }
        Ok(())
    }

    /// Commands as they are, without those that have a reason to be left out: one entry per command, `None` where it can be measured.
    pub fn of_reachable(
        model: &Model,
        commands: &[CommandedPose],
        reasons: Vec<Option<String>>,
        levels: usize,
        sigmas: SensorSigmas,
    ) -> Result<Self, PlanError> {
        let judged = commands.iter().zip(reasons);
        let judged = judged.map(|(command, reason)| reason.map_or(Ok(command), |reason| Err(Unmeasurable(reason))));
        Self::of(model, judged, levels, sigmas)
    }

    fn of<'c>(
        model: &Model,
        commands: impl Iterator<Item = Result<&'c CommandedPose, Unmeasurable>>,
        levels: usize,
        sigmas: SensorSigmas,
    ) -> Result<Self, PlanError> {
        check_levels(model, levels)?;
        let tensions = model.needs_tensions().then(Vec::new);
        let samples = Samples { cable_count: model.cable_count(), sigmas, tensions, ..Samples::default() };
        let mut found = Self { samples, places: Vec::new(), tests: Vec::new(), left_out: Vec::new() };
        let expected = Records::new(model, levels)?;
        let mut asked = 0;
        let mut state = State::at(model, &model.robot().home_or_middle());
        for (place, command) in commands.enumerate() {
            asked += 1;
            match command.and_then(|command| Ok((command.shortened, expected.at(command, &mut state)?))) {
                Ok((test, records)) => records.into_iter().for_each(|record| found.push((place, test), record)),
                Err(Unmeasurable(reason)) => found.left_out.push((place, reason)),
            }
        }
        match found.left_out.first() {
            _ if asked == 0 => Err(PlanError::NoCandidate { poses: 0, reason: "there are none".to_owned() }),
            Some((_, reason)) if found.places.is_empty() => {
                Err(PlanError::NoCandidate { poses: asked, reason: reason.clone() })
            }
            _ => Ok(found),
        }
    }

    /// Samples with the records that the model expects at their poses and tensions; as they are where it has none.
    pub(super) fn exact(model: &Model, samples: &Samples) -> Option<Samples> {
        let (mut state, mut exact) = (State::at(model, samples.poses.first()?), samples.clone());
        exact.motor_angles = None;
        exact.lengths.clear();
        for (sample, pose) in samples.poses.iter().enumerate() {
            let recorded =
                samples.tensions.as_deref().map(|all| &all[sample * samples.cable_count..][..samples.cable_count]);
            let real = |(cable, &tension): (usize, &f64)| model.real_tension(cable, tension).max(0.0);
            let tensions: Vec<f64> = match model.needs_tensions() {
                true => recorded?.iter().enumerate().map(real).collect(),
                false => vec![0.0; model.cable_count()],
            };
            exact.lengths.extend(model.inverse(pose, &tensions, &mut state).ok()?.recorded_lengths().ok()?);
        }
        Some(exact)
    }

    fn push(&mut self, (place, test): (usize, Option<Shortening>), record: Record) {
        self.places.push(place);
        self.tests.push(test);
        self.samples.poses.push(record.pose);
        self.samples.lengths.extend(record.lengths);
        self.samples.tensions.iter_mut().for_each(|tensions| tensions.extend(&record.tensions));
    }

    /// Number of poses of the list among the candidates.
    pub fn pose_count(&self) -> usize {
        let mut places = self.places.clone();
        places.sort_unstable();
        places.dedup();
        places.len()
    }
}
