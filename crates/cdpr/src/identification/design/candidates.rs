//! Poses that could be measured.

use nalgebra::{DMatrix, DVector};

use super::plan_error::PlanError;
use crate::equilibrium::State;
use crate::equilibrium::distribution;
use crate::geometry::Pose;
use crate::measurement::{Samples, SensorSigmas};
use crate::metamodel::Experiment;
use crate::metamodel::study::CommandedPose;
use crate::model::{Model, SpanEffect};
use crate::scalar::decomposition::svd;
use crate::statics::Load;
use crate::tension::Limits;

/// Share of the way to the limits that levels of tension go.
const SHARE: f64 = 0.8;

/// Poses that could be measured, with what the model expects to record there.
#[derive(Clone, Debug)]
pub struct Candidates {
    /// Exact records of the model as it is, under the accuracies of the sensors.
    pub samples: Samples,
    /// Place of each in the list that was asked, from 0.
    pub places: Vec<usize>,
    /// Poses of that list that cannot be measured, with the reason.
    pub left_out: Vec<(usize, String)>,
}

impl Candidates {
    /// Poses as they are; elastic models have so many levels of tension at each, the nearest to the middle of the limits first.
    pub fn new(model: &Model, poses: &[Pose], levels: usize, sigmas: SensorSigmas) -> Result<Self, PlanError> {
        let all = poses.iter().copied().enumerate();
        Self::of(model, all.map(|(place, pose)| (place, Ok(pose))), levels, sigmas)
    }

    /// Poses of an experiment that its controller reaches within its requirements (eq. 3.33).
    pub fn reached(
        model: &Model,
        (experiment, poses): (&Experiment, &[CommandedPose]),
        levels: usize,
        sigmas: SensorSigmas,
    ) -> Result<Self, PlanError> {
        let reachable = experiment.reachable()?;
        let outcomes = experiment.assess(poses)?.outcomes;
        let judged = poses.iter().zip(&outcomes).map(|(command, outcome)| {
            let verdict = reachable.verdict(&command.pose, outcome);
            verdict.reason.map_or(Ok(command.pose), |reason| Err(Unmeasurable(reason)))
        });
        Self::of(model, judged.enumerate(), levels, sigmas)
    }

    fn of(
        model: &Model,
        poses: impl Iterator<Item = (usize, Result<Pose, Unmeasurable>)>,
        levels: usize,
        sigmas: SensorSigmas,
    ) -> Result<Self, PlanError> {
        check_levels(model, levels)?;
        let tensions = model.needs_tensions().then(Vec::new);
        let samples = Samples { cable_count: model.cable_count(), sigmas, tensions, ..Samples::default() };
        let mut found = Self { samples, places: Vec::new(), left_out: Vec::new() };
        let load = model.needs_tensions().then(|| Load::of(model.robot())).transpose()?;
        let mut asked = 0;
        let mut state = State::at(model, &model.robot().home_or_middle());
        for (place, pose) in poses {
            asked += 1;
            match pose.and_then(|pose| records(model, &pose, (load.as_ref(), levels), &mut state)) {
                Ok(records) => records.into_iter().for_each(|record| found.push(place, record)),
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

    fn push(&mut self, place: usize, record: Record) {
        self.places.push(place);
        self.samples.poses.push(record.pose);
        self.samples.lengths.extend(record.lengths);
        self.samples.tensions.iter_mut().for_each(|tensions| tensions.extend(&record.tensions));
    }

    /// Number of poses of the list among the candidates.
    pub fn pose_count(&self) -> usize {
        let mut places = self.places.clone();
        places.dedup();
        places.len()
    }
}

/// Reason why a pose cannot be measured, in words.
struct Unmeasurable(String);

impl Unmeasurable {
    fn of(reason: impl ToString) -> Self {
        Self(reason.to_string())
    }
}

/// Sensors' exact records at a pose.
struct Record {
    pose: Pose,
    /// Recorded lengths (m).
    lengths: Vec<f64>,
    /// Recorded tensions (N); empty for rigid models.
    tensions: Vec<f64>,
}

fn check_levels(model: &Model, levels: usize) -> Result<(), PlanError> {
    let redundancy = model.cable_count().saturating_sub(model.dof());
    let most = 1 + 2 * redundancy;
    match levels {
        1 => Ok(()),
        _ if !model.needs_tensions() => Err(PlanError::LevelsOfRigid),
        _ if model.composition().span != SpanEffect::Straight => Err(PlanError::LevelsOfSagging),
        _ if levels == 0 || levels > most => Err(PlanError::Levels { levels, redundancy, most }),
        _ => Ok(()),
    }
}

/// Records at a pose, one for each level of tension; or why it cannot be measured.
fn records(
    model: &Model,
    pose: &Pose,
    (load, levels): (Option<&Load>, usize),
    state: &mut State,
) -> Result<Vec<Record>, Unmeasurable> {
    let of = |tensions: Vec<f64>, state: &mut State| {
        let command = model.inverse(pose, &tensions, state).map_err(Unmeasurable::of)?;
        let lengths = command.recorded_lengths().map_err(Unmeasurable::of)?;
        let tensions = tensions.iter().enumerate().map(|(cable, &tension)| model.recorded_tension(cable, tension));
        Ok(Record { pose: *pose, lengths, tensions: tensions.collect() })
    };
    let Some(load) = load else { return Ok(vec![of(vec![0.0; model.cable_count()], state)?]) };
    let limits = Limits::of(model.robot(), None, None).map_err(Unmeasurable::of)?;
    let held = distribution::solve(model, pose, load, &limits).map_err(Unmeasurable::of)?;
    if let Some(reason) = held.reason {
        return Err(Unmeasurable::of(reason));
    }
    let all = match levels {
        1 => vec![held.tensions],
        _ => at_levels(model, pose, (held.tensions, &limits), levels)?,
    };
    all.into_iter().map(|tensions| of(tensions, state)).collect()
}

/// Tensions, and others that balance the same load: most of the way to the limits to both sides along the null space, first where all tensions rise together.
fn at_levels(
    model: &Model,
    pose: &Pose,
    (middle, limits): (Vec<f64>, &Limits),
    levels: usize,
) -> Result<Vec<Vec<f64>>, Unmeasurable> {
    let matrix = model.structure_matrix(pose).map_err(Unmeasurable::of)?;
    let middle = DVector::from_vec(middle);
    let mut found = vec![middle.as_slice().to_vec()];
    for direction in null_space(&matrix) {
        for side in [1.0, -1.0] {
            let towards = &direction * side;
            let room = (0..middle.len()).map(|cable| {
                let end = if towards[cable] > 0.0 { limits.maximum()[cable] } else { limits.minimum()[cable] };
                if towards[cable].abs() < 1e-9 {
                    f64::INFINITY
                } else {
                    ((end - middle[cable]) / towards[cable]).max(0.0)
                }
            });
            let way = SHARE * room.fold(f64::INFINITY, f64::min);
            found.push((&middle + towards * way).as_slice().to_vec());
        }
    }
    found.truncate(levels);
    Ok(found)
}

/// Orthonormal directions of tensions that change no wrench; the first raises all tensions as evenly as can be.
fn null_space(matrix: &DMatrix<f64>) -> Vec<DVector<f64>> {
    let cables = matrix.ncols();
    let mut padded = DMatrix::zeros(cables.max(matrix.nrows()), cables);
    padded.rows_mut(0, matrix.nrows()).copy_from(matrix);
    let Some(v_t) = svd(padded, false, true).and_then(|found| found.v_t) else { return Vec::new() };
    let mut rest: Vec<DVector<f64>> = (matrix.nrows()..cables).map(|row| v_t.row(row).transpose()).collect();
    let together: DVector<f64> = rest.iter().map(|direction| direction * direction.sum()).sum();
    let mut found: Vec<DVector<f64>> = Vec::new();
    let starts = std::iter::once(together).chain(std::mem::take(&mut rest));
    for mut direction in starts {
        found.iter().for_each(|own| direction -= own * own.dot(&direction));
        if direction.norm() > 1e-6 && found.len() + matrix.nrows() < cables {
            found.push(direction.normalize());
        }
    }
    found
}
