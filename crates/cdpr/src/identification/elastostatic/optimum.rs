//! The best optimum over several starts, with weights that agree with it.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::Serialize;

use super::covariance::{Whitening, sigmas};
use super::descent::{End, Problem};
use super::rows::{RowModel, Sigmas};
use crate::geometry::Wrench;
use crate::identification::fit::{InputError, Settings};
use crate::measurement::Samples;
use crate::model::{Model, Parameter, ParameterKind};
use crate::robot::{ExternalWrench, Robot};
use crate::statics::Load;

/// Most repetitions of a fit with weights from its own optimum.
const REWEIGHTINGS: u32 = 6;
/// How far other starts move anchors from the file's values, in every direction (m).
const ANCHOR_SPREAD: f64 = 0.5;
/// By which factor other starts change compliances, up or down.
const COMPLIANCE_SPREAD: f64 = 10.0 / 3.0;
/// Ends of descents that differ by less than this share of their cost, or of one per sample, are the same optimum.
const SAME_BASIN: f64 = 1e-6;

/// An optimum that some of the starts led to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Basin {
    /// Weighted sum of squared residuals and priors.
    pub cost: f64,
    /// Starts that ended here.
    pub starts: usize,
    /// True when the descents that ended here converged.
    pub converged: bool,
}

/// The optimum and what belongs to it.
pub(crate) struct Optimum {
    /// The model before the fit; with a free wrench its robot states a constant one.
    pub(super) start_model: Model,
    pub(super) calibrated: Model,
    pub(super) tensions: Vec<f64>,
    pub(super) whitening: Whitening,
    pub(super) end: End,
    pub(super) basins: Vec<Basin>,
}

impl Optimum {
    pub(crate) fn calibrated(&self) -> &Model {
        &self.calibrated
    }

    pub(crate) fn converged(&self) -> bool {
        self.end.converged
    }

    pub(crate) fn iterations(&self) -> u32 {
        self.end.iterations
    }

    pub(crate) fn history(&self) -> &[f64] {
        &self.end.history
    }
}

/// Finds the optimum of an elastic model.
pub(crate) fn find(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
) -> Result<Optimum, InputError> {
    let tensions = checked_tensions(model, samples)?;
    let start_model = with_constant_wrench(model, samples, &tensions, parameters)?;
    check_courses(&start_model, samples)?;
    let (sigmas, absolute) = sigmas(samples, tensions.iter().sum::<f64>() / tensions.len() as f64);
    let problem = Problem::new(&start_model, samples, &tensions, parameters, settings);
    let mut whitening = weigh(&problem, &start_model, &sigmas, absolute)?;
    let (mut end, basins) = search(&problem, &whitening);
    for _ in 0..REWEIGHTINGS {
        let Some(here) = problem.model_at(&end.values) else { break };
        let again = weigh(&problem, &with_given_levers(&here, model)?, &sigmas, absolute)?;
        let again = match absolute {
            true => again,
            false => again.scaled(1.0 / noise_factor(end.cost, samples, model, parameters.len()).max(1e-6)),
        };
        if parameters.is_empty() || whitening.distance_to(&again) < 1e-6 {
            break;
        }
        whitening = again;
        let more = problem.descend(&end.values, &whitening);
        end = End { iterations: end.iterations + more.iterations, ..more };
    }
    let calibrated = problem.model_at(&end.values).ok_or(InputError::NotFinite)?;
    Ok(Optimum { calibrated, whitening, end, basins, tensions, start_model })
}

/// Root of the weighted sum of squares per degree of freedom.
pub(super) fn noise_factor(cost: f64, samples: &Samples, model: &Model, parameter_count: usize) -> f64 {
    let rows = (samples.len() * (model.dof() + model.cable_count())) as f64;
    (cost / (rows - parameter_count as f64).max(1.0)).sqrt()
}

/// Descends from the file's values and from other starts; the lowest end wins.
fn search(problem: &Problem<'_>, whitening: &Whitening) -> (End, Vec<Basin>) {
    let mut best = problem.descend(&problem.start, whitening);
    let mut basins = vec![Basin { cost: best.cost, starts: 1, converged: best.converged }];
    let mut random = ChaCha8Rng::seed_from_u64(problem.settings.seed);
    for _ in 1..problem.settings.starts {
        let from: Vec<f64> =
            problem.parameters.iter().zip(&problem.start).map(|(p, &value)| moved(p, value, &mut random)).collect();
        let end = problem.descend(&from, whitening);
        if !end.cost.is_finite() {
            continue;
        }
        let same = SAME_BASIN * (end.cost + problem.samples.len() as f64);
        match basins.iter_mut().find(|basin| (basin.cost - end.cost).abs() <= same) {
            Some(basin) => basin.starts += 1,
            None => basins.push(Basin { cost: end.cost, starts: 1, converged: end.converged }),
        }
        if end.cost < best.cost - same || !best.cost.is_finite() {
            best = end;
        }
    }
    basins.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    (best, basins)
}

fn moved(parameter: &Parameter, value: f64, random: &mut ChaCha8Rng) -> f64 {
    let amount = 2.0 * random.random::<f64>() - 1.0;
    match parameter.kind {
        kind if kind.is_anchor() => value + ANCHOR_SPREAD * amount,
        ParameterKind::Compliance => value * COMPLIANCE_SPREAD.powf(amount),
        _ => value,
    }
}

fn weigh(problem: &Problem<'_>, at: &Model, sigmas: &Sigmas, absolute: bool) -> Result<Whitening, InputError> {
    let load = Load::of(at.robot())?;
    let rows = RowModel::new(at, load, problem.parameters);
    Whitening::new(&rows, problem.samples, problem.tensions, sigmas, absolute).ok_or(InputError::NotFinite)
}

/// Recorded tensions, refused where they are missing or cables push by more than the sensors' noise.
fn checked_tensions(model: &Model, samples: &Samples) -> Result<Vec<f64>, InputError> {
    let tensions = samples.tensions.clone().ok_or(InputError::NoTensions)?;
    let allowance = 5.0 * samples.sigmas.tension.unwrap_or(0.0);
    let m = model.cable_count();
    let pushing: Vec<usize> = (0..samples.len())
        .filter(|sample| (0..m).any(|cable| model.real_tension(cable, tensions[sample * m + cable]) < -allowance))
        .collect();
    match pushing.first() {
        None => Ok(tensions),
        Some(&first) => {
            let rows = &tensions[first * m..][..m];
            let worst = (0..m).min_by(|a, b| rows[*a].total_cmp(&rows[*b])).unwrap_or(0);
            Err(InputError::NegativeTension {
                samples: pushing.iter().map(|sample| sample + 1).collect(),
                cable: worst + 1,
                tension: rows[worst],
            })
        }
    }
}

fn check_courses(model: &Model, samples: &Samples) -> Result<(), InputError> {
    for (sample, pose) in samples.poses.iter().enumerate() {
        for cable in 0..model.cable_count() {
            model.course(cable, pose).map_err(|reason| InputError::Degenerate { sample: sample + 1, reason })?;
        }
    }
    Ok(())
}

/// A free wrench is the constant total in world axes: it replaces the weight, and starts at what the file states for the
/// mean pose, or, where the file is silent, at what the recorded tensions balance in the mean.
fn with_constant_wrench(
    model: &Model,
    samples: &Samples,
    tensions: &[f64],
    parameters: &[Parameter],
) -> Result<Model, InputError> {
    let stated = Load::of(model.robot());
    if !parameters.iter().any(|parameter| parameter.kind == ParameterKind::Wrench) {
        return stated.map(|_| model.clone()).map_err(InputError::from);
    }
    let mean = |wrench: &dyn Fn(usize) -> Wrench| (0..samples.len()).map(wrench).sum::<Wrench>() / samples.len() as f64;
    let wrench = match stated {
        Ok(load) => mean(&|sample| load.wrench(&samples.poses[sample])),
        Err(_) => mean(&|sample| -pull(model, samples, tensions, sample)),
    };
    let external = ExternalWrench { wrench, includes_gravity: true, note: Some("identified".to_owned()) };
    let robot = Robot { external_wrench: Some(external), ..model.robot().clone() };
    Ok(Model::new(robot, model.composition())?)
}

/// Wrench of all cables on the platform (world).
fn pull(model: &Model, samples: &Samples, tensions: &[f64], sample: usize) -> Wrench {
    let m = model.cable_count();
    let mut sum = Wrench::zeros();
    for cable in 0..m {
        let (course, lever) = model.course_or_nan(cable, &samples.poses[sample]);
        let u = nalgebra::Vector3::from(course.direction);
        let moment = lever.cross(&u);
        let tension = model.real_tension(cable, tensions[sample * m + cable]);
        sum += Wrench::new(u.x, u.y, u.z, moment.x, moment.y, moment.z) * tension;
    }
    sum
}

/// The calibrated model with the platform anchors as given: weakly determined ones may end metres away, and a variance
/// that grows with the lever would reward them for it.
fn with_given_levers(calibrated: &Model, given: &Model) -> Result<Model, InputError> {
    let mut robot = calibrated.robot().clone();
    for (cable, given) in robot.cables.iter_mut().zip(&given.robot().cables) {
        cable.platform_anchor = given.platform_anchor;
    }
    Ok(Model::new(robot, calibrated.composition())?)
}
