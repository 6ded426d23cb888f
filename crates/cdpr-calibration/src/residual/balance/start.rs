//! The model that an elastic fit starts from, where its cables can be as they were recorded.

use super::rows::recorded_state;
use crate::fit::InputError;
use cdpr_model::geometry::Wrench;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::{ExternalWrench, Parameter, ParameterKind, Robot};
use cdpr_model::statics::{Load, StaticsError, cable_state};

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

/// Recorded tensions, refused where they are missing or cables push by more than the sensors' noise.
pub(crate) fn checked_tensions(model: &Model, samples: &Samples) -> Result<Vec<f64>, InputError> {
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
