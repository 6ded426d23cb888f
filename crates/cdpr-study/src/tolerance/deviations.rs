//! Deviations of an experiment: derivatives, spread, drawn robots, and the tolerances that an accuracy allows.

use super::monte_carlo::Draw;
use super::{Allowed, DrawnPart, Engine, MonteCarlo, Settings, Spread, allowed, sigmas};
use crate::experiment::Experiment;
use crate::parts::{self, Parts};
use crate::sensitivity::{Differentiation, Kind, Kink, Offsets, ParameterDeviation, PoseSensitivity, Side, counted_as};
use crate::study::{AccuracyOf, Tolerances};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::InputError;
use cdpr_model::control::Status;
use cdpr_model::reading::Keyword;

/// Settings of a study of deviations, in addition to the tolerances of the study.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeviationSettings {
    /// Treatment of the winch offsets under deviations.
    pub offsets: Offsets,
    /// Method by which drawn robots answer.
    pub engine: Engine,
    /// Number of robots to draw; 0 draws none.
    pub robots: usize,
    /// Required accuracy (m) for which allowed tolerances are computed; `None` if they are not needed.
    pub accuracy: Option<f64>,
    /// Seed of the robots drawn.
    pub seed: u64,
}

/// Effect of deviations at the poses of an experiment.
#[derive(Clone, Debug)]
pub struct Deviations {
    /// Deviations, in the order of the columns of all derivatives.
    pub causes: Vec<ParameterDeviation>,
    /// Commanded poses.
    pub commanded: Vec<CommandedPose>,
    /// Outcome and derivatives, pose by pose.
    pub poses: Vec<PoseSensitivity>,
    /// Distance from the commanded position without deviations, pose by pose (m); NaN without an answer.
    pub errors: Vec<f64>,
    /// Spread to first order; `None` without tolerances.
    pub spread: Option<Spread>,
    /// Results of drawn robots; `None` without tolerances.
    pub drawn: Option<MonteCarlo>,
    /// Tolerances that the required accuracy allows; `None` without one.
    pub allowed: Option<Allowed>,
}

impl Experiment {
    /// Effect of deviations at commanded poses, at least one. If no standard deviation is above 0, nothing is spread,
    /// and every error is jointly allowed its tolerance once, under the name that [`counted_as`] gives it.
    pub fn deviations(
        &self,
        commanded: Vec<CommandedPose>,
        tolerances: &Tolerances,
        settings: &DeviationSettings,
    ) -> Result<Deviations, InputError> {
        self.deviations_in_parts(commanded, tolerances, settings, &parts::here)
    }

    /// The same with robots drawn in parts.
    pub fn deviations_in_parts(
        &self,
        commanded: Vec<CommandedPose>,
        tolerances: &Tolerances,
        settings: &DeviationSettings,
        parts: &Parts<'_, DrawnPart>,
    ) -> Result<Deviations, InputError> {
        if commanded.is_empty() {
            return Err(InputError::NoPoses);
        }
        let mut sensitivity = self.sensitivity(settings.offsets)?;
        let poses = sensitivity.along(&commanded)?;
        let causes = sensitivity.causes().to_vec();
        let sigmas = sigmas(&causes, tolerances);
        let is_given = sigmas.iter().any(|&sigma| sigma > 0.0);
        let errors = poses.iter().zip(&commanded).map(|(at, command)| position_error(at, command)).collect();
        let mut found = Deviations { causes, commanded, poses, errors, spread: None, drawn: None, allowed: None };
        let translations = self.machine.robot().motion_pattern.translations();
        if is_given {
            let spread = Spread::of(&found.poses, &found.errors, &sigmas, tolerances.reach(), translations);
            found.spread = Some(spread);
            found.drawn = self.drawn(&found, &sigmas, tolerances, settings, parts)?;
        }
        found.allowed = settings.accuracy.map(|accuracy| {
            let named = |side: Side, kind: Kind| {
                let mut own = tolerances.entries().filter(|&(_, _, _, sigma)| sigma > 0.0);
                match is_given {
                    true => own.any(|(other, of, ..)| (other, of) == (side, kind)),
                    // nobody says what deviates: everything does, and an error of two names only once
                    false => counted_as(side, kind, &found.causes).is_none(),
                }
            };
            let counted = match tolerances.accuracy_of {
                AccuracyOf::Error => found.errors.clone(),
                AccuracyOf::Deviation => vec![0.0; found.errors.len()],
            };
            allowed(&found.causes, &found.poses, &counted, accuracy, tolerances.sigmas, &named, translations)
        });
        Ok(found)
    }

    fn drawn(
        &self,
        found: &Deviations,
        sigmas: &[f64],
        tolerances: &Tolerances,
        asked: &DeviationSettings,
        parts: &Parts<'_, DrawnPart>,
    ) -> Result<Option<MonteCarlo>, InputError> {
        if asked.robots == 0 {
            return Ok(None);
        }
        let settings = Settings {
            causes: &found.causes,
            sigmas,
            distribution: tolerances.distribution,
            robots: asked.robots,
            seed: asked.seed,
            engine: asked.engine,
            history: self.history(),
        };
        let (control, setting) = (self.controller()?, self.setting(asked.offsets));
        let draw = Draw {
            control: &control,
            machine: &self.machine,
            setting: &setting,
            offsets: &self.offsets,
            poses: &found.commanded,
            nominal: &found.poses,
        };
        draw.in_parts(&settings, parts).map(Some)
    }
}

/// Distance from the commanded position (m); NaN without an answer.
fn position_error(at: &PoseSensitivity, command: &CommandedPose) -> f64 {
    match at.outcome.status {
        Status::Converged => (at.outcome.pose.position - command.pose.position).norm(),
        _ => f64::NAN,
    }
}

impl Deviations {
    /// Largest estimated error of derivatives by differences, as a fraction of the largest derivative by a number of
    /// the same unit at the same pose; `None` for analytic ones.
    pub fn difference_error(&self) -> Option<f64> {
        let mut worst = None;
        for derivatives in self.poses.iter().filter_map(|at| at.derivatives.as_ref().ok()) {
            let Some(errors) = derivatives.errors() else { continue };
            for (column, cause) in self.causes.iter().enumerate() {
                let same = (0..self.causes.len()).filter(|&other| self.causes[other].kind.unit() == cause.kind.unit());
                let largest = same.map(|other| derivatives.pose.column(other).amax()).fold(0.0, f64::max);
                let fraction = if largest > 0.0 { errors[column] / largest } else { 0.0 };
                worst = Some(f64::max(worst.unwrap_or(0.0), fraction));
            }
        }
        worst
    }

    /// Poses (0-based) with derivatives by differences, and the reasons for which they have no exact ones.
    pub fn by_differences(&self) -> impl Iterator<Item = (usize, &Kink)> {
        self.poses.iter().enumerate().filter_map(|(place, at)| match &at.derivatives.as_ref().ok()?.differentiation {
            Differentiation::Differences { kink, .. } => Some((place, kink)),
            Differentiation::Exact => None,
        })
    }

    /// Remarks on standard deviations of numbers that the side does not have.
    pub fn without_effect(&self, tolerances: &Tolerances) -> Vec<String> {
        let has = |side, kind| self.causes.iter().any(|cause| (cause.side, cause.kind) == (side, kind));
        let idle = tolerances.entries().filter(|&(side, kind, _, sigma)| sigma > 0.0 && !has(side, kind));
        idle.map(|(side, _, key, _)| {
            let side = side.name();
            format!("[tolerances.{side}] {key} without effect: the model of this side has no such number")
        })
        .collect()
    }
}
