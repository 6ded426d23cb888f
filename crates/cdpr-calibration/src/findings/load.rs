//! Statics as a witness: the load that recorded tensions balance, and whether cables that only pull can hold the platform at the measured poses.

use super::examined::Examined;
use super::numbers::unit_factor;
use super::residual_table::median;
use crate::screening::place;
use cdpr_model::equilibrium::distribution::{Reason, Solver};
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, three_digits};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{ParameterKind, Robot};
use cdpr_model::statics::{Load, balanced_wrench};
use cdpr_model::tension::Limits;

/// Ratios of loads from which on they are another load, and from which on that is worth a word.
const OTHER_LOAD: f64 = 2.0;
const WORTH_A_WORD: f64 = 1.2;
/// Ratio of the loads of two parts of the data from which on they are two.
const TWO_LOADS: f64 = 1.15;
/// Standard errors by which they have to differ.
const SURE: f64 = 6.0;
/// Load beside the sum of the tensions, below which errors of load cells tell more than the load.
pub(super) const LEAST_OF_TENSIONS: f64 = 0.1;
/// Poses at which statics is asked, and the fraction of them without an answer from which on the model hangs where nothing can.
const ASKED: usize = 20;
const MOST_WITHOUT: f64 = 0.9;
/// Largest tension in multiples of the load.
const LARGEST_TENSION: f64 = 100.0;

/// Loads along gravity that the tensions of every sample balance (N).
struct Weighed {
    of_samples: Vec<f64>,
    /// Load of the robot's file (N); `None` where it states none, or only assumes it.
    stated: Option<f64>,
}

impl Weighed {
    /// `None` without tensions, without gravity, or where the tensions are too large beside the load to tell it.
    fn of(examined: &Examined<'_>) -> Option<Self> {
        let given = examined.given;
        // in the robot's frame
        let samples = &examined.fit.as_fitted(examined.samples);
        let tensions = samples.tensions.as_ref()?;
        let down = given.gravity?.try_normalize(0.0)?;
        let model = Model::new(given.clone(), Composition::STANDARD).ok()?;
        let m = samples.cable_count;
        let mut sums = Vec::with_capacity(samples.len());
        let mut of_samples = Vec::with_capacity(samples.len());
        for (sample, pose) in samples.poses.iter().enumerate() {
            let own = &tensions[sample * m..][..m];
            let force = balanced_wrench(&model, pose, own).ok().map(|wrench| wrench.fixed_rows::<3>(0).dot(&down));
            of_samples.push(force.unwrap_or(f64::NAN));
            sums.push(own.iter().map(|tension| tension.abs()).sum::<f64>());
        }
        let (load, sum) = (median(of_samples.iter().copied()), median(sums.into_iter()));
        (load > LEAST_OF_TENSIONS * sum).then(|| Self { of_samples, stated: stated_weight(given) })
    }

    /// Median and its standard error over some samples (N).
    fn over(&self, samples: impl Iterator<Item = usize> + Clone) -> (f64, f64) {
        let values = || samples.clone().map(|sample| self.of_samples[sample]).filter(|value| value.is_finite());
        let (middle, count) = (median(values()), values().count().max(1));
        let deviation = 1.4826 * median(values().map(|value| (value - middle).abs()));
        (middle, 1.25 * deviation / (count as f64).sqrt())
    }
}

/// Weight and constant force of a robot along gravity (N), where its file states it and does not call it an assumption.
pub(super) fn stated_weight(robot: &Robot) -> Option<f64> {
    let assumed = ["mass_kg", "force_N", "gravity_m_s2"];
    if robot.assumptions.iter().any(|assumption| assumed.contains(&assumption.plain_key())) {
        return None;
    }
    weight_of(robot)
}

fn weight_of(robot: &Robot) -> Option<f64> {
    let down = robot.gravity?.try_normalize(0.0)?;
    let weight = Load::of(robot).ok()?.wrench(&Pose::identity()).fixed_rows::<3>(0).dot(&down);
    (weight > 0.0).then_some(weight)
}

/// Findings about the load.
pub(super) fn findings(examined: &Examined<'_>) -> Vec<Finding> {
    let of_tensions = Weighed::of(examined);
    let parts = of_tensions
        .as_ref()
        .and_then(|weighed| two_parts(weighed, examined).or_else(|| two_times(weighed, examined.samples)));
    let own = || of_tensions.as_ref().and_then(|weighed| of_file(weighed, examined));
    parts.or_else(own).or_else(|| identified(examined)).into_iter().collect()
}

/// Another load in the data that are held out.
fn two_parts(weighed: &Weighed, examined: &Examined<'_>) -> Option<Finding> {
    if examined.held_out.is_empty() {
        return None;
    }
    let is_held = |sample: &usize| examined.held_out.binary_search(sample).is_ok();
    let (fit, fit_error) = weighed.over((0..examined.samples.len()).filter(|sample| !is_held(sample)));
    let (held, held_error) = weighed.over(examined.held_out.iter().copied());
    let is_other = ratio(held, fit) > TWO_LOADS && (held - fit).abs() > SURE * fit_error.hypot(held_error);
    is_other.then(|| {
        let text = format!(
            "not to be trusted: the tensions of the validation data balance {} N, those of the fit {} N: another payload",
            three_digits(held),
            three_digits(fit)
        );
        Finding::new(FindingKind::Load, Severity::Distrust, text).of_size(held, "N")
    })
}

/// Another load from a row on.
fn two_times(weighed: &Weighed, samples: &Samples) -> Option<Finding> {
    let count = samples.len();
    let side = 6.max(count / 50);
    let values = &weighed.of_samples;
    if count < 2 * side + 2 || values.iter().any(|value| !value.is_finite()) {
        return None;
    }
    let mut sums = vec![0.0; count + 1];
    (0..count).for_each(|sample| sums[sample + 1] = sums[sample] + values[sample]);
    let means = |first: usize| [sums[first] / first as f64, (sums[count] - sums[first]) / (count - first) as f64];
    let gain = |first: usize| {
        let [before, after] = means(first);
        (before - after).powi(2) * first as f64 * (count - first) as f64 / count as f64
    };
    let first = (side..count - side).max_by(|&a, &b| gain(a).total_cmp(&gain(b)))?;
    let mean = sums[count] / count as f64;
    let all: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    let ([before, after], explained) = (means(first), gain(first) / all);
    (ratio(before, after) > TWO_LOADS && explained > 0.7).then(|| {
        let text = format!(
            "not to be trusted: the tensions balance {} N up to {} and {} N from there on (explains {:.0} %): another payload",
            three_digits(before),
            place(samples, first),
            three_digits(after),
            100.0 * explained
        );
        let found = Finding::new(FindingKind::Load, Severity::Distrust, text).of_size(after, "N").explaining(explained);
        crate::screening::at(samples, first, found)
    })
}

/// A load that is not that of the file.
fn of_file(weighed: &Weighed, examined: &Examined<'_>) -> Option<Finding> {
    let stated = weighed.stated?;
    let (load, error) = weighed.over(0..examined.samples.len());
    judged(load, error, stated, "the recorded tensions balance").map(|found| match found.severity {
        Severity::Caution => {
            Finding { text: format!("{}{}", found.text, freeing(examined, ParameterKind::Mass)), ..found }
        }
        _ => found,
    })
}

/// The option that identifies a number of the weight, as the end of a sentence; empty where it is free, and where the model has none.
pub(super) fn freeing(examined: &Examined<'_>, kind: ParameterKind) -> String {
    let is_of_load = examined.fit.parameters.iter().any(|estimate| estimate.parameter.kind.is_of_load());
    match examined.fit.model.needs_tensions() && !is_of_load {
        true => format!(" (`{kind}` in `--free` finds it)"),
        false => String::new(),
    }
}

/// An identified load that is not that of the file.
fn identified(examined: &Examined<'_>) -> Option<Finding> {
    let is_load =
        |kind: ParameterKind| matches!(kind, ParameterKind::Wrench | ParameterKind::Force | ParameterKind::Mass);
    let estimate = examined.fit.parameters.iter().find(|estimate| is_load(estimate.parameter.kind))?;
    let (stated, found) = (stated_weight(examined.given)?, weight_of(examined.fit.model.robot())?);
    judged(found, estimate.sigma.unwrap_or(0.0), stated, "the identified load is")
}

fn judged(load: f64, error: f64, stated: f64, what: &str) -> Option<Finding> {
    let factor = load / stated;
    let words = format!(
        "{what} {} N, {} of the load that the robot file states, {} N",
        three_digits(load),
        three_digits(factor),
        three_digits(stated)
    );
    let slack = (3.0 * error / load.abs().max(f64::MIN_POSITIVE)).min(0.02);
    if let Some(unit) = unit_factor(factor, slack) {
        let text = format!("not to be trusted: {words}: {unit}");
        return Some(Finding::new(FindingKind::Unit, Severity::Distrust, text).of_size(factor, ""));
    }
    let of =
        |severity: Severity, text: String| Some(Finding::new(FindingKind::Load, severity, text).of_size(load, "N"));
    match ratio(load, stated) {
        other if !(other <= OTHER_LOAD) => {
            of(Severity::Distrust, format!("not to be trusted: {words}: another payload, or load cells that are wrong"))
        }
        some if some > WORTH_A_WORD && (load - stated).abs() > SURE * error => {
            of(Severity::Caution, format!("{words}: is the mass right?"))
        }
        _ => None,
    }
}

/// The larger of two loads over the smaller; infinite where one has another sign.
fn ratio(a: f64, b: f64) -> f64 {
    let ratio = a / b;
    if ratio > 0.0 { ratio.max(1.0 / ratio) } else { f64::INFINITY }
}

/// A model whose cables would have to push at the measured poses.
pub(super) fn gravity(examined: &Examined<'_>) -> Option<Finding> {
    let robot = examined.fit.model.robot();
    let samples = examined.fit.as_fitted(examined.samples);
    if robot.cables.len() < robot.motion_pattern.dof() || samples.is_empty() {
        return None;
    }
    stated_weight(examined.given)?;
    let asked = ASKED.min(samples.len());
    let poses: Vec<Pose> = (0..asked).map(|place| samples.poses[place * samples.len() / asked]).collect();
    let (given, own) = (without(examined.given, &poses)?, without(robot, &poses)?);
    let limit = MOST_WITHOUT * asked as f64;
    (own as f64 >= limit).then(|| {
        let is_of_file = given as f64 >= limit && examined.fit.frames.is_none();
        let of_file = match is_of_file {
            true => ", as by the robot file: are gravity, load and anchors right?",
            false => ": the platform cannot have hung there",
        };
        let text = format!(
            "not to be trusted: by this answer no tensions without pushing balance the load at {own} of {asked} measured poses{of_file}"
        );
        Finding::new(FindingKind::Gravity, Severity::Distrust, text).of_size(own as f64 / asked as f64, "")
    })
}

/// Poses of these at which no tensions from zero on balance the load.
fn without(robot: &Robot, poses: &[Pose]) -> Option<usize> {
    let model = Model::new(robot.clone(), Composition::STANDARD).ok()?;
    let load = Load::of(robot).ok()?;
    let limits = Limits::uniform(model.cable_count(), 0.0, LARGEST_TENSION * load.force()).ok()?;
    let mut solver = Solver::new(&model, &load, &limits);
    let mut is_without = |pose: &Pose| match solver.solve(pose) {
        Ok(found) => Some(matches!(found.reason, Some(Reason::Infeasible(_)))),
        Err(_) => None,
    };
    poses.iter().map(&mut is_without).map(|found| found.map(usize::from)).sum()
}
