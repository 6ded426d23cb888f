//! The model that an elastic fit starts from, where its cables can be as they were recorded.

use nalgebra::{DMatrix, DVector};

use super::rows::recorded_state;
use crate::fit::InputError;
use cdpr_model::geometry::Wrench;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::{ExternalWrench, Parameter, ParameterKind, Robot};
use cdpr_model::scalar::decomposition::pseudo_inverse;
use cdpr_model::statics::{Load, StaticsError, cable_state};

/// Steps to tensions in equilibrium: one for straight cables, of sagging ones each gains two digits and more.
const STATICS_STEPS: usize = 8;
/// Share of the largest eigenvalue below which cables act alike.
const DEPENDENT: f64 = 1e-12;

/// An elastic model with a load that a free wrench can stand for, where its cables can be as they were recorded; others as they are.
pub(crate) fn checked_start(model: &Model, samples: &Samples, parameters: &[Parameter]) -> Result<Model, InputError> {
    if !model.needs_tensions() {
        return Ok(model.clone());
    }
    let tensions = checked_tensions(model, samples)?;
    let start = with_constant_wrench(model, samples, &tensions, parameters)?;
    check_paths(&start, samples, &tensions)?;
    Ok(start)
}

/// True where nothing records tensions and statics tells them: a known load on no more cables than degrees of freedom.
pub(crate) fn follow_from_statics(model: &Model, samples: &Samples) -> bool {
    samples.tensions.is_none() && model.cable_count() <= model.dof() && Load::of(model.robot()).is_ok()
}

/// Tensions that balance the load at the measured poses best, as they would be recorded, by steps of Gauss and Newton from straight cables.
fn told_tensions(model: &Model, samples: &Samples) -> Result<Vec<f64>, InputError> {
    let (load, m, n) = (Load::of(model.robot())?, model.cable_count(), model.dof());
    let basis = model.twist_basis();
    let along = |wrench: &Wrench| DVector::from_fn(n, |row, _| basis[row].dot(wrench));
    let mut all = Vec::with_capacity(samples.len() * m);
    for pose in &samples.poses {
        let (rotation, weight) = (pose.rotation_rows(), load.wrench(pose));
        let mut tensions = vec![load.force() / m as f64; m];
        for _ in 0..STATICS_STEPS {
            let (mut missing, mut by_tension) = (along(&weight), DMatrix::zeros(n, m));
            for (cable, tension) in tensions.iter().enumerate() {
                let recorded = model.recorded_tension(cable, *tension);
                let Some(state) = recorded_state(model, cable, pose, &rotation, recorded) else { continue };
                missing += along(&state.wrench());
                by_tension.set_column(cable, &along(&state.by_given_tension(1.0).0));
            }
            let step = pseudo_inverse(&(by_tension.tr_mul(&by_tension)), DEPENDENT) * by_tension.tr_mul(&missing);
            tensions.iter_mut().zip(step.iter()).for_each(|(tension, step)| *tension = (*tension - step).max(0.0));
        }
        all.extend(tensions.iter().enumerate().map(|(cable, tension)| model.recorded_tension(cable, *tension)));
    }
    Ok(all)
}

/// Recorded tensions, or those that statics tells where it does; refused where they are missing or cables push by more than the sensors' noise.
pub(crate) fn checked_tensions(model: &Model, samples: &Samples) -> Result<Vec<f64>, InputError> {
    if follow_from_statics(model, samples) {
        return told_tensions(model, samples);
    }
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

fn check_paths(model: &Model, samples: &Samples, tensions: &[f64]) -> Result<(), InputError> {
    let m = model.cable_count();
    for (sample, pose) in samples.poses.iter().enumerate() {
        for cable in 0..model.cable_count() {
            let tension = model.real_tension(cable, tensions[sample * m + cable]);
            match cable_state(model, pose, cable, tension) {
                Err(StaticsError::CablePath(reason)) => {
                    return Err(InputError::Degenerate { sample: sample + 1, reason });
                }
                Err(StaticsError::CableState { cable, reason }) => {
                    return Err(InputError::CableState { sample: sample + 1, cable, reason });
                }
                _ => {}
            }
        }
    }
    Ok(())
}

/// A free wrench is the constant total in world axes: it replaces the weight, and starts at what the file states for the
/// mean pose, or, where the file is silent, at what the recorded tensions balance in the mean.
pub(crate) fn with_constant_wrench(
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
        let pose = &samples.poses[sample];
        let state = recorded_state(model, cable, pose, &pose.rotation_rows(), tensions[sample * m + cable]);
        sum += state.map_or_else(|| Wrench::repeat(f64::NAN), |state| state.wrench());
    }
    sum
}
