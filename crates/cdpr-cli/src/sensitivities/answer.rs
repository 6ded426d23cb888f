//! The answer of `cdpr sensitivity` for scripts.

use cdpr::metamodel::Experiment;
use cdpr::metamodel::sensitivity::{Kind, Offsets, Side, rank, rank_kinds};
use cdpr::metamodel::study::{AccuracyOf, Distribution, Tolerances};
use cdpr::metamodel::tolerance::{Engine, Quantiles};
use serde::Serialize;

use super::{Asked, Deviations};
use crate::study_file::title;

/// All that is told.
#[derive(Serialize)]
pub(crate) struct Told {
    pub(super) status: &'static str,
    pub(super) reason: Option<String>,
    pub(super) control: String,
    pub(super) machine: String,
    /// Commanded poses.
    pub(super) samples: usize,
    pub(super) unanswered_poses: usize,
    pub(super) offsets: Offsets,
    /// `analytic`, or `central-differences` of the exact forward problem.
    pub(super) derivatives: &'static str,
    /// Of differences, what they may be off by, as a share of the largest derivative of the unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) difference_error: Option<f64>,
    pub(super) kinds: Vec<ToldKind>,
    pub(super) parameters: Vec<ToldParameter>,
    pub(super) tolerance: Option<ToldTolerance>,
    pub(super) allowed: Option<ToldAllowed>,
    pub(super) seed: u64,
    #[serde(skip)]
    pub(super) top: usize,
    #[serde(skip)]
    pub(super) has_rotation: bool,
}

/// All parameters of one kind together.
#[derive(Serialize)]
pub(super) struct ToldKind {
    pub(super) side: Side,
    pub(super) kind: Kind,
    pub(super) count: usize,
    pub(super) unit: &'static str,
    pub(super) position_rms_m_per_unit: f64,
    pub(super) position_max_m_per_unit: f64,
}

/// One parameter.
#[derive(Serialize)]
#[expect(non_snake_case, reason = "the fields are the keys of the answer, units included")]
pub(super) struct ToldParameter {
    pub(super) name: String,
    pub(super) side: Side,
    pub(super) kind: Kind,
    pub(super) unit: &'static str,
    pub(super) position_mean_m_per_unit: f64,
    pub(super) position_max_m_per_unit: f64,
    pub(super) rotation_mean_rad_per_unit: f64,
    pub(super) rotation_max_rad_per_unit: f64,
    pub(super) tension_mean_N_per_unit: Option<f64>,
    pub(super) tension_max_N_per_unit: Option<f64>,
}

/// What the tolerances of the study do.
#[derive(Serialize)]
pub(super) struct ToldTolerance {
    pub(super) distribution: Distribution,
    pub(super) sigmas: f64,
    pub(super) linear: Linear,
    pub(super) drawn: Option<Drawn>,
}

/// To first order.
#[derive(Serialize)]
pub(super) struct Linear {
    pub(super) deviation_rms_m: f64,
    pub(super) deviation_rms_at_worst_pose_m: f64,
    pub(super) worst_case_max_m: f64,
    pub(super) position_error_rms_m: f64,
}

/// Of drawn robots.
#[derive(Serialize)]
pub(super) struct Drawn {
    pub(super) engine: Engine,
    pub(super) robots: usize,
    pub(super) unanswered: usize,
    pub(super) reason: Option<String>,
    pub(super) position_error_m: Quantiles,
    pub(super) rotation_error_rad: Quantiles,
    pub(super) deviation_m: Quantiles,
    pub(super) mean_of_robot_m: Quantiles,
    pub(super) max_of_robot_m: Quantiles,
}

/// What an accuracy allows.
#[derive(Serialize)]
pub(super) struct ToldAllowed {
    pub(super) accuracy_m: f64,
    pub(super) accuracy_of: AccuracyOf,
    pub(super) sigmas: f64,
    pub(super) least_budget_m: f64,
    pub(super) worst_pose: usize,
    pub(super) kinds: Vec<ToldAllowance>,
}

/// Of one kind, in its unit.
#[derive(Serialize)]
pub(super) struct ToldAllowance {
    pub(super) side: Side,
    pub(super) kind: Kind,
    pub(super) unit: &'static str,
    pub(super) sigma_alone: f64,
    pub(super) worst_case_alone: f64,
    pub(super) sigma_joint: Option<f64>,
    pub(super) worst_case_joint: Option<f64>,
}

/// The answer with its status.
pub(crate) fn answer(found: &Deviations, experiment: &Experiment, tolerances: &Tolerances, asked: &Asked) -> Told {
    let (control, machine) = (&experiment.control, &experiment.machine);
    let pattern = machine.robot().motion_pattern;
    let known: Vec<_> = found.poses.iter().filter_map(|at| at.derivatives.as_ref().ok()).collect();
    let (status, reason) = status(found, asked);
    let difference_error = found.difference_error();
    let parameters = rank(&found.causes, &known, pattern.translations());
    Told {
        status,
        reason,
        control: title(control),
        machine: title(machine),
        samples: found.poses.len(),
        unanswered_poses: found.poses.len() - known.len(),
        offsets: asked.settings.offsets,
        derivatives: if difference_error.is_some() { "central-differences" } else { "analytic" },
        difference_error,
        kinds: rank_kinds(&found.causes, &known, pattern.translations())
            .into_iter()
            .map(|kind| ToldKind {
                side: kind.side,
                kind: kind.kind,
                count: kind.count,
                unit: kind.kind.unit(),
                position_rms_m_per_unit: kind.position_rms,
                position_max_m_per_unit: kind.position_max,
            })
            .collect(),
        parameters: parameters
            .into_iter()
            .map(|influence| ToldParameter {
                name: influence.cause.name(machine),
                side: influence.cause.side,
                kind: influence.cause.kind,
                unit: influence.cause.kind.unit(),
                position_mean_m_per_unit: influence.position_mean,
                position_max_m_per_unit: influence.position_max,
                rotation_mean_rad_per_unit: influence.rotation_mean,
                rotation_max_rad_per_unit: influence.rotation_max,
                tension_mean_N_per_unit: influence.tension_mean,
                tension_max_N_per_unit: influence.tension_max,
            })
            .collect(),
        tolerance: tolerance(found, tolerances, asked),
        allowed: allowances(found, tolerances, asked),
        seed: asked.settings.seed,
        top: asked.top,
        has_rotation: pattern.has_rotation(),
    }
}

fn status(found: &Deviations, asked: &Asked) -> (&'static str, Option<String>) {
    let mut failed =
        found.poses.iter().enumerate().filter_map(|(place, at)| Some((place, at.derivatives.as_ref().err()?)));
    if let Some((place, why)) = failed.next() {
        let (count, all) = (1 + failed.count(), found.poses.len());
        return (
            "not-converged",
            Some(format!("{count} of {all} poses have no derivatives, first pose {}: {why}", place + 1)),
        );
    }
    match (&found.allowed, asked.settings.accuracy) {
        // written so that NaN counts too
        (Some(allowed), Some(accuracy)) if !(allowed.budget > 0.0) => {
            let (pose, error) = (allowed.worst_pose + 1, 1e3 * found.errors[allowed.worst_pose]);
            let asked = 1e3 * accuracy;
            let reason = format!(
                "no tolerance gives {asked:.3} mm: at pose {pose} the error is {error:.3} mm without any deviation; a better \
                 control model may, or accuracy_of = \"deviation\" asks for the deviations alone"
            );
            ("accuracy-missed", Some(reason))
        }
        _ => ("converged", None),
    }
}

fn tolerance(found: &Deviations, tolerances: &Tolerances, asked: &Asked) -> Option<ToldTolerance> {
    let spread = found.spread.as_ref()?;
    let rms = |values: &[f64]| {
        let finite: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
        (finite.iter().map(|value| value * value).sum::<f64>() / finite.len() as f64).sqrt()
    };
    let largest = |values: &[f64]| values.iter().copied().fold(f64::NAN, f64::max);
    let drawn = found.drawn.as_ref().map(|drawn| Drawn {
        engine: asked.settings.engine,
        robots: drawn.robots,
        unanswered: drawn.unanswered,
        reason: drawn.reason.clone(),
        position_error_m: drawn.error,
        rotation_error_rad: drawn.rotation_error,
        deviation_m: drawn.deviation,
        mean_of_robot_m: drawn.mean_of_robot,
        max_of_robot_m: drawn.max_of_robot,
    });
    Some(ToldTolerance {
        distribution: tolerances.distribution,
        sigmas: tolerances.sigmas,
        linear: Linear {
            deviation_rms_m: rms(&spread.deviation),
            deviation_rms_at_worst_pose_m: largest(&spread.deviation),
            worst_case_max_m: largest(&spread.worst_case),
            position_error_rms_m: rms(&spread.error),
        },
        drawn,
    })
}

fn allowances(found: &Deviations, tolerances: &Tolerances, asked: &Asked) -> Option<ToldAllowed> {
    let (allowed, accuracy) = (found.allowed.as_ref()?, asked.settings.accuracy?);
    let kinds = allowed.kinds.iter().map(|allowance| ToldAllowance {
        side: allowance.side,
        kind: allowance.kind,
        unit: allowance.kind.unit(),
        sigma_alone: allowance.alone,
        worst_case_alone: allowance.alone_worst_case,
        sigma_joint: allowance.joint,
        worst_case_joint: allowance.joint_worst_case,
    });
    Some(ToldAllowed {
        accuracy_m: accuracy,
        accuracy_of: tolerances.accuracy_of,
        sigmas: tolerances.sigmas,
        least_budget_m: allowed.budget,
        worst_pose: allowed.worst_pose + 1,
        kinds: kinds.collect(),
    })
}
