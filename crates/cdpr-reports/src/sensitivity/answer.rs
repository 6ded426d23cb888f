//! Influences, tolerances and allowances as one answer.

use cdpr_model::reading::Keyword;
use cdpr_study::Experiment;
use cdpr_study::sensitivity::{Influence, Kind, KindInfluence, Offsets, Side, counted_as, rank, rank_kinds};
use cdpr_study::study::{AccuracyOf, Distribution, Tolerances};
use cdpr_study::tolerance::{Allowance, DeviationSettings, Deviations, MonteCarlo};
use schemars::JsonSchema;
use serde::Serialize;

use crate::answers::title;
use crate::keys::{AllowanceKeys, Each, InfluenceKeys, KindInfluenceKeys, Maybe, MonteCarloKeys};

/// Numbers of a study's models and winches with what they move; keys and units as in JSON.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Sensitivity")]
pub struct SensitivityAnswer {
    /// Outcome in a word.
    pub status: &'static str,
    /// Reason why the answer is negative.
    pub reason: Option<String>,
    /// Control model.
    pub control: String,
    /// Machine.
    pub machine: String,
    /// Commanded poses.
    pub samples: usize,
    /// Poses without derivatives.
    pub unanswered_poses: usize,
    /// Winch offsets when something deviates.
    pub offsets: Offsets,
    /// `analytic`, or `central-differences` of the exact forward problem where poses need them.
    pub derivatives: &'static str,
    /// Poses whose derivatives are differences.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub difference_poses: Vec<DifferencePose>,
    /// Of differences, what they may be off by, as a share of the largest derivative of the unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference_error: Option<f64>,
    /// Kinds of parameters.
    #[serde(with = "Each::<KindInfluenceKeys>")]
    pub kinds: Vec<KindInfluence>,
    /// Kinds that are other names of an error, which counts once where the study states no tolerances.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub same_errors: Vec<SameError>,
    /// Parameters, the most influential first.
    pub parameters: Vec<ParameterAnswer>,
    /// Effects of the tolerances, where the study has any.
    pub tolerance: Option<ToleranceAnswer>,
    /// Tolerances that an accuracy allows.
    pub allowed: Option<AllowedAnswer>,
    /// Seed of random poses and robots.
    pub seed: u64,
    /// Parameters in the words; all of them where nobody chose.
    #[serde(skip)]
    pub told: usize,
    /// True of platforms that turn.
    #[serde(skip)]
    pub has_rotation: bool,
    /// True of machines whose cables remember.
    #[serde(skip)]
    pub remembers: bool,
}

/// A pose to which no exact derivative leads.
#[derive(Serialize, JsonSchema)]
pub struct DifferencePose {
    /// The pose, from 1.
    pub pose: usize,
    /// Reason in words.
    pub reason: String,
}

/// A kind that is another name of an error.
#[derive(Serialize, JsonSchema)]
pub struct SameError {
    /// Side and kind, as `winches winch-offset`.
    pub name: String,
    /// Name under which the error counts.
    pub counted_as: String,
    #[serde(skip)]
    pub(super) side: Side,
    #[serde(skip)]
    pub(super) kind: Kind,
}

/// One parameter.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ParameterSensitivity")]
pub struct ParameterAnswer {
    /// Name of the parameter.
    pub name: String,
    /// Its influence over the poses.
    #[serde(flatten, with = "InfluenceKeys")]
    pub influence: Influence,
}

/// Deviations that the tolerances of the study make.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ToleranceEffects")]
pub struct ToleranceAnswer {
    /// Distribution of the deviations.
    pub distribution: Distribution,
    /// Largest deviation in standard deviations.
    pub sigmas: f64,
    /// Spread to first order.
    pub linear: Linear,
    /// Spread of drawn robots.
    #[serde(with = "Maybe::<MonteCarloKeys>")]
    pub drawn: Option<MonteCarlo>,
}

/// To first order.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "LinearTolerance")]
pub struct Linear {
    /// Root mean square over the poses.
    pub deviation_rms_m: f64,
    /// Root mean square at the worst pose.
    pub deviation_rms_at_worst_pose_m: f64,
    /// All deviations at their worst, at the worst pose.
    pub worst_case_max_m: f64,
    /// Error with its deviations, over the poses.
    pub position_error_rms_m: f64,
}

/// Tolerances that an accuracy allows.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "AllowedTolerances")]
pub struct AllowedAnswer {
    /// Required accuracy.
    pub accuracy_m: f64,
    /// Quantity that shall keep it.
    pub accuracy_of: AccuracyOf,
    /// Largest deviation in standard deviations.
    pub sigmas: f64,
    /// Room for deviations at the worst pose.
    pub least_budget_m: f64,
    /// The pose with the least room, from 1.
    pub worst_pose: usize,
    /// Kinds of parameters.
    #[serde(with = "Each::<AllowanceKeys>")]
    pub kinds: Vec<Allowance>,
}

impl SensitivityAnswer {
    /// The answer with its status.
    pub fn new(
        found: &Deviations,
        experiment: &Experiment,
        tolerances: &Tolerances,
        settings: &DeviationSettings,
    ) -> Self {
        answer(found, experiment, tolerances, settings)
    }
}

fn answer(
    found: &Deviations,
    experiment: &Experiment,
    tolerances: &Tolerances,
    settings: &DeviationSettings,
) -> SensitivityAnswer {
    let (control, machine) = (&experiment.control, &experiment.machine);
    let pattern = machine.robot().motion_pattern;
    let known: Vec<_> = found.poses.iter().filter_map(|at| at.derivatives.as_ref().ok()).collect();
    let (status, reason) = status(found, settings);
    let difference_error = found.difference_error();
    let by_differences = found.by_differences();
    let difference_poses: Vec<_> =
        by_differences.map(|(place, kink)| DifferencePose { pose: place + 1, reason: kink.to_string() }).collect();
    let kinds = rank_kinds(&found.causes, &known, pattern.translations());
    let parameters = rank(&found.causes, &known, pattern.translations());
    SensitivityAnswer {
        status,
        reason,
        control: title(control),
        machine: title(machine),
        samples: found.poses.len(),
        unanswered_poses: found.poses.len() - known.len(),
        offsets: settings.offsets,
        derivatives: if difference_poses.is_empty() { "analytic" } else { "central-differences" },
        difference_poses,
        difference_error,
        same_errors: if found.spread.is_none() { same_errors(found, &kinds) } else { Vec::new() },
        kinds,
        parameters: parameters
            .into_iter()
            .map(|influence| ParameterAnswer { name: influence.cause.name(machine), influence })
            .collect(),
        tolerance: tolerance(found, tolerances),
        allowed: allowances(found, tolerances, settings),
        seed: settings.seed,
        told: usize::MAX,
        has_rotation: experiment.machine.robot().motion_pattern.has_rotation(),
        remembers: experiment.machine.composition().stretch.remembers(),
    }
}

fn same_errors(found: &Deviations, kinds: &[KindInfluence]) -> Vec<SameError> {
    let name = |side: Side, kind: Kind| format!("{} {kind}", side.name());
    let one = |&KindInfluence { side, kind, .. }: &KindInfluence| {
        let (first_side, first) = counted_as(side, kind, &found.causes)?;
        Some(SameError { name: name(side, kind), counted_as: name(first_side, first), side, kind })
    };
    kinds.iter().filter_map(one).collect()
}

fn status(found: &Deviations, settings: &DeviationSettings) -> (&'static str, Option<String>) {
    let mut failed =
        found.poses.iter().enumerate().filter_map(|(place, at)| Some((place, at.derivatives.as_ref().err()?)));
    if let Some((place, why)) = failed.next() {
        let (count, all) = (1 + failed.count(), found.poses.len());
        return (
            "not-converged",
            Some(format!("{count} of {all} poses have no derivatives, first pose {}: {why}", place + 1)),
        );
    }
    match (&found.allowed, settings.accuracy) {
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

fn tolerance(found: &Deviations, tolerances: &Tolerances) -> Option<ToleranceAnswer> {
    let spread = found.spread.as_ref()?;
    let rms = |values: &[f64]| {
        let finite: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
        (finite.iter().map(|value| value * value).sum::<f64>() / finite.len() as f64).sqrt()
    };
    let largest = |values: &[f64]| values.iter().copied().fold(f64::NAN, f64::max);
    Some(ToleranceAnswer {
        distribution: tolerances.distribution,
        sigmas: tolerances.sigmas,
        linear: Linear {
            deviation_rms_m: rms(&spread.deviation),
            deviation_rms_at_worst_pose_m: largest(&spread.deviation),
            worst_case_max_m: largest(&spread.worst_case),
            position_error_rms_m: rms(&spread.error),
        },
        drawn: found.drawn.clone(),
    })
}

fn allowances(found: &Deviations, tolerances: &Tolerances, settings: &DeviationSettings) -> Option<AllowedAnswer> {
    let (allowed, accuracy) = (found.allowed.as_ref()?, settings.accuracy?);
    Some(AllowedAnswer {
        accuracy_m: accuracy,
        accuracy_of: tolerances.accuracy_of,
        sigmas: tolerances.sigmas,
        least_budget_m: allowed.budget,
        worst_pose: allowed.worst_pose + 1,
        kinds: allowed.kinds.clone(),
    })
}
