//! Sensitivities and tolerances of a study: what `cdpr sensitivity` computes, tells and writes.

mod answer;
mod map;
mod names;
pub(crate) mod tables;
mod words;

use cdpr::metamodel::sensitivity::{Cause, Offsets, PoseSensitivity, Sensitivity};
use cdpr::metamodel::study::{AccuracyOf, CommandedPose, Tolerances};
use cdpr::metamodel::tolerance::{Allowed, Engine, MonteCarlo, Settings, Spread, allowed, monte_carlo, sigmas};
use cdpr::metamodel::{InputError, Status};

pub(crate) use map::map;
pub(crate) use names::place_of;

use crate::failure::Failure;
use crate::laboratory::Laboratory;

/// What is asked of a study.
pub(crate) struct Asked {
    /// What deviations do to the winch offsets.
    pub(crate) offsets: Offsets,
    /// How drawn robots answer.
    pub(crate) engine: Engine,
    /// How many are drawn.
    pub(crate) robots: usize,
    /// Required accuracy (m).
    pub(crate) accuracy: Option<f64>,
    /// Parameters in the table.
    pub(crate) top: usize,
    /// Of poses and robots.
    pub(crate) seed: u64,
}

/// What is found.
pub(crate) struct Found {
    pub(crate) causes: Vec<Cause>,
    pub(crate) commanded: Vec<CommandedPose>,
    pub(crate) poses: Vec<PoseSensitivity>,
    /// Distance from the commanded position without deviations, pose by pose (m); NaN without an answer.
    pub(crate) errors: Vec<f64>,
    /// Where tolerances are given.
    pub(crate) spread: Option<Spread>,
    pub(crate) drawn: Option<MonteCarlo>,
    /// Where an accuracy is required.
    pub(crate) allowed: Option<Allowed>,
}

impl Found {
    pub(crate) fn of(laboratory: &Laboratory, tolerances: &Tolerances, asked: &Asked) -> Result<Self, Failure> {
        let refused = |error: InputError| laboratory.refused(&error);
        let machine = &laboratory.machine;
        let setting = laboratory.setting(asked.offsets);
        let commanded = laboratory.untested_poses(asked.seed)?;
        if commanded.is_empty() {
            return Err(refused(InputError::NoPoses));
        }
        let mut sensitivity =
            Sensitivity::new(laboratory.controller(), machine, &laboratory.offsets, &setting).map_err(refused)?;
        let history = laboratory.history();
        if let Some(history) = &history {
            sensitivity = sensitivity.with_history(history, &setting.pose);
        }
        let causes = sensitivity.causes().to_vec();
        let poses = sensitivity.along(&commanded).map_err(refused)?;
        let error = |(at, command): (&PoseSensitivity, &CommandedPose)| match at.outcome.status {
            Status::Converged => (at.outcome.pose.position - command.pose.position).norm(),
            _ => f64::NAN,
        };
        let errors: Vec<f64> = poses.iter().zip(&commanded).map(error).collect();
        let translations = machine.robot().motion_pattern.translations();
        let sigmas = sigmas(&causes, tolerances);
        let is_given = sigmas.iter().any(|&sigma| sigma > 0.0);
        let spread = is_given.then(|| Spread::of(&poses, &errors, &sigmas, tolerances.reach(), translations));
        let settings = Settings {
            sigmas: &sigmas,
            distribution: tolerances.distribution,
            robots: asked.robots,
            seed: asked.seed,
            engine: asked.engine,
            history,
        };
        let drawn = match is_given && asked.robots > 0 {
            true => Some(
                monte_carlo(
                    (laboratory.controller(), machine),
                    (&setting, &laboratory.offsets),
                    &causes,
                    (&commanded, &poses),
                    &settings,
                )
                .map_err(refused)?,
            ),
            false => None,
        };
        let named = |side, kind| {
            let mut own = tolerances.entries().filter(|&(_, _, _, sigma)| sigma > 0.0);
            !is_given || own.any(|(other, of, ..)| (other, of) == (side, kind))
        };
        let counted = match tolerances.accuracy_of {
            AccuracyOf::Error => errors.clone(),
            AccuracyOf::Deviation => vec![0.0; errors.len()],
        };
        let allowed = asked
            .accuracy
            .map(|accuracy| allowed(&causes, &poses, &counted, (accuracy, tolerances.sigmas), &named, translations));
        Ok(Self { causes, commanded, poses, errors, spread, drawn, allowed })
    }

    /// Of derivatives by differences, the largest error that is estimated, as a share of the largest derivative by a number of the same
    /// unit at the same pose; nothing for analytic ones.
    pub(crate) fn difference_error(&self) -> Option<f64> {
        let mut worst = None;
        for derivatives in self.poses.iter().filter_map(|at| at.derivatives.as_ref().ok()) {
            let Some(errors) = &derivatives.errors else { continue };
            for (column, cause) in self.causes.iter().enumerate() {
                let same = (0..self.causes.len()).filter(|&other| self.causes[other].kind.unit() == cause.kind.unit());
                let largest = same.map(|other| derivatives.pose.column(other).amax()).fold(0.0, f64::max);
                let share = if largest > 0.0 { errors[column] / largest } else { 0.0 };
                worst = Some(f64::max(worst.unwrap_or(0.0), share));
            }
        }
        worst
    }

    /// Standard deviations of what neither side has.
    pub(crate) fn without_effect(&self, tolerances: &Tolerances) -> Vec<String> {
        let has = |side, kind| self.causes.iter().any(|cause| (cause.side, cause.kind) == (side, kind));
        let idle = tolerances.entries().filter(|&(side, kind, _, sigma)| sigma > 0.0 && !has(side, kind));
        idle.map(|(side, _, key, _)| {
            let side = side.name();
            format!("[tolerances.{side}] {key} without effect: the model of this side has no such number")
        })
        .collect()
    }
}
