//! Records that a model expects at a pose: at levels of tension, and in tension tests.

use nalgebra::{DMatrix, DVector};

use super::plan_error::PlanError;
use cdpr_model::control::{CommandedPose, Shortening};
use cdpr_model::equilibrium::distribution::{self, DistributionError};
use cdpr_model::equilibrium::{State, Status};
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Model, SpanEffect};
use cdpr_model::scalar::decomposition::svd;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;

/// Share of the way to the limits that levels of tension go.
const SHARE: f64 = 0.8;

/// Reason why a pose cannot be measured, in words.
pub(super) struct Unmeasurable(pub(super) String);

impl Unmeasurable {
    fn of(reason: impl ToString) -> Self {
        Self(reason.to_string())
    }
}

/// Sensors' exact records at a pose.
pub(super) struct Record {
    pub(super) pose: Pose,
    /// Recorded lengths (m).
    pub(super) lengths: Vec<f64>,
    /// Recorded tensions (N); empty for rigid models.
    pub(super) tensions: Vec<f64>,
}

pub(super) fn check_levels(model: &Model, levels: usize) -> Result<(), PlanError> {
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

/// Records that a model expects, pose by pose.
pub(super) struct Records<'m> {
    model: &'m Model,
    /// Load and tension limits of an elastic model.
    held: Option<(Load, Limits)>,
    levels: usize,
}

impl<'m> Records<'m> {
    /// Of a model, with so many levels of tension at every pose.
    pub(super) fn new(model: &'m Model, levels: usize) -> Result<Self, PlanError> {
        let held = || -> Result<(Load, Limits), PlanError> {
            let limits = Limits::of(model.robot(), None, None).map_err(DistributionError::from)?;
            Ok((Load::of(model.robot())?, limits))
        };
        Ok(Self { model, held: model.needs_tensions().then(held).transpose()?, levels })
    }

    /// Records at a pose, one for each level of tension, or that of its tension test; or why it cannot be measured.
    pub(super) fn at(&self, command: &CommandedPose, state: &mut State) -> Result<Vec<Record>, Unmeasurable> {
        let pose = &command.pose;
        let Some((load, limits)) = &self.held else {
            return match command.shortened {
                None => Ok(vec![self.record(pose, vec![0.0; self.model.cable_count()], state)?]),
                Some(_) => Err(Unmeasurable::of("a tension test tells nothing of rigid cables")),
            };
        };
        let middle = distribution::solve(self.model, pose, load, limits).map_err(Unmeasurable::of)?;
        if let Some(reason) = middle.reason {
            return Err(Unmeasurable::of(reason));
        }
        let all = match command.shortened {
            Some(test) => return Ok(vec![self.tested((pose, &middle.tensions), (load, limits), test, state)?]),
            None if self.levels == 1 => vec![middle.tensions],
            None => at_levels(self.model, pose, (middle.tensions, limits), self.levels)?,
        };
        all.into_iter().map(|tensions| self.record(pose, tensions, state)).collect()
    }

    fn record(&self, pose: &Pose, tensions: Vec<f64>, state: &mut State) -> Result<Record, Unmeasurable> {
        let command = self.model.inverse(pose, &tensions, state).map_err(Unmeasurable::of)?;
        let lengths = command.recorded_lengths().map_err(Unmeasurable::of)?;
        Ok(Record { pose: *pose, lengths, tensions: self.recorded(&tensions) })
    }

    fn recorded(&self, tensions: &[f64]) -> Vec<f64> {
        tensions.iter().enumerate().map(|(cable, &tension)| self.model.recorded_tension(cable, tension)).collect()
    }

    /// Pose and tensions at which the model comes to rest with one cable shortened.
    fn tested(
        &self,
        (pose, tensions): (&Pose, &[f64]),
        (load, limits): (&Load, &Limits),
        test: Shortening,
        state: &mut State,
    ) -> Result<Record, Unmeasurable> {
        let command = self.model.inverse(pose, tensions, state).map_err(Unmeasurable::of)?;
        let mut lengths = command.controlled_lengths().map_err(Unmeasurable::of)?;
        lengths[test.cable] -= test.by;
        let rest = self.model.forward(&lengths, Some(load), Some(pose), state).map_err(Unmeasurable::of)?;
        if rest.status != Status::Converged {
            let reason = rest.reason.clone();
            return Err(Unmeasurable(reason.unwrap_or_else(|| "the platform comes to no rest".to_owned())));
        }
        let ends = limits.minimum().iter().zip(limits.maximum());
        let broken = rest.tensions.iter().zip(ends).position(|(own, (low, high))| !(*low..=*high).contains(own));
        if let Some(cable) = broken {
            return Err(Unmeasurable(format!(
                "cable {} would have {:.0} N with cable {} shortened by {} m, beyond its limits",
                cable + 1,
                rest.tensions[cable],
                test.cable + 1,
                test.by
            )));
        }
        let lengths = lengths.iter().enumerate().map(|(cable, &length)| self.model.recorded_length(cable, length));
        Ok(Record { pose: rest.pose, lengths: lengths.collect(), tensions: self.recorded(&rest.tensions) })
    }
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
