//! Setting of the winches: initial tensions and offsets.

use super::input_error::{InputError, check_same_robot};
use super::winding::Winding;
use crate::control::Initial;
use crate::control::controller::lengths_at;
use crate::equilibrium::distribution::{self, DistributionError};
use crate::geometry::Pose;
use crate::model::Model;
use crate::statics::Load;
use crate::tension::{Limits, Method, Options, Reference, Solver, closed_form};

/// Winch offsets for a study (m): none, given ones, or those that bring the machine to the initial pose with the
/// initial tensions, q_off = φ̂(x_ini, f_ini) − φ(x_ini).
///
/// φ̂ is the machine's inverse, φ that of the model in use when the winches were set: the control model, or that of
/// `offset_robot`. Both are in the units of their encoders. A kinematic φ does not depend on tensions, so that on a
/// machine of the same geometry the offsets are −f q/k_F (eq. 6.24). An elastic φ takes the same initial tensions, so
/// that a machine equal to its control model has offsets of zero. With drums the machine's lengths are converted to
/// those of the model in use at the motor angles that give them.
pub fn winch_offsets(
    initial: &Initial,
    set_with: &Model,
    machine: &Model,
    pose: &Pose,
) -> Result<Vec<f64>, InputError> {
    let expected = machine.cable_count();
    if initial.offset.is_some() {
        return Ok(vec![0.0; expected]);
    }
    if let Some(offsets) = &initial.offset_m {
        let found = offsets.len();
        return if found == expected {
            Ok(offsets.clone())
        } else {
            Err(InputError::Count { key: "offset_m", expected, found })
        };
    }
    check_same_robot(set_with, machine)?;
    // rigid cables have the same length at any tension
    let tensions = tensions_set(initial, set_with, machine, pose)?.unwrap_or_else(|| vec![0.0; expected]);
    let wanted = Winding::new(set_with, machine)?.to_control(&lengths_at(machine, pose, &tensions)?)?;
    let sent = lengths_at(set_with, pose, &tensions)?;
    Ok(wanted.iter().zip(&sent).map(|(wanted, sent)| wanted - sent).collect())
}

/// Model that determines the tensions set by the winches: the machine, or, if it is straight and rigid, the model in
/// use when they were set; `None` if both are, since tensions then do not change lengths.
pub fn tension_model<'a>(set_with: &'a Model, machine: &'a Model) -> Option<&'a Model> {
    [machine, set_with].into_iter().find(|model| model.needs_tensions())
}

/// [`initial_tensions`] of the model that determines them; `None` if none does.
pub fn tensions_set(
    initial: &Initial,
    set_with: &Model,
    machine: &Model,
    pose: &Pose,
) -> Result<Option<Vec<f64>>, InputError> {
    tension_model(set_with, machine).map(|model| initial_tensions(initial, model, pose)).transpose()
}

/// The initial tensions f_ini of a study at its initial pose, in balance with the load of the model's robot (N).
///
/// Given tensions are brought into balance by the smallest change, f − A⁺ᵀ (w + Aᵀ f); so is, with the method
/// `closed-form`, the middle of the limits (eq. 3.41). Both may leave the limits; the other methods keep them.
pub fn initial_tensions(initial: &Initial, model: &Model, pose: &Pose) -> Result<Vec<f64>, InputError> {
    // a pose without a path gives the error of the geometry
    model.structure_matrix(pose)?;
    let load = Load::of(model.robot())?;
    let wrench = load.in_pattern(model, pose);
    let nearest_to = |middle: &Limits| -> Result<Vec<f64>, InputError> {
        let mut found = None;
        let balance = distribution::balance(model, pose, wrench.as_slice(), &mut |matrix, wrench| {
            let solution = closed_form::solve(matrix, wrench, middle)?;
            found = solution.balanced.then_some(solution.tensions);
            Ok(found.clone().filter(|tensions| tensions.iter().all(|tension| *tension >= 0.0)))
        });
        match (found, balance.map_err(refused)?.reason) {
            (Some(tensions), None) => Ok(tensions),
            (None, _) => Err(not_balanced("the cables leave a part of it whatever their tensions".to_owned())),
            (_, Some(reason)) => Err(not_balanced(reason.to_string())),
        }
    };
    let tensions = match (&initial.tensions_N, initial.tension_method) {
        (Some(tensions), _) => {
            let (expected, found) = (model.cable_count(), tensions.len());
            if expected != found {
                return Err(InputError::Count { key: "tensions_N", expected, found });
            }
            nearest_to(&Limits::new(tensions.clone(), tensions.clone())?)?
        }
        (None, Some(Method::ClosedForm)) => nearest_to(&aim(initial, model)?)?,
        (None, Some(method)) => {
            chosen_by((method, &Options::default()), &aim(initial, model)?, model, pose, wrench.as_slice())?
        }
        (None, None) => return Err(InputError::NoTensions),
    };
    match tensions.iter().position(|&tension| tension < 0.0) {
        Some(cable) => {
            let push = -tensions[cable];
            Err(not_balanced(format!("cable {} would have to push with {push:.0} N", cable + 1)))
        }
        None => Ok(tensions),
    }
}

/// The tensions within limits nearest to a reference, in balance with the load (N).
pub(super) fn tensions_within(
    limits: &Limits,
    reference: Reference<'_>,
    model: &Model,
    pose: &Pose,
) -> Result<Vec<f64>, InputError> {
    model.structure_matrix(pose)?;
    let wrench = Load::of(model.robot())?.in_pattern(model, pose);
    let options = Options { reference, ..Options::default() };
    chosen_by((Method::Qp, &options), limits, model, pose, wrench.as_slice())
}

/// Limits of the initial tensions (N): those of the study, otherwise those of the robot's file.
pub fn aim(initial: &Initial, model: &Model) -> Result<Limits, InputError> {
    Ok(match initial.tension_limits_N {
        Some([low, high]) => Limits::uniform(model.cable_count(), low, high)?,
        None => Limits::of(model.robot(), None, None)?,
    })
}

/// Tensions by a method that keeps the limits.
fn chosen_by(
    (method, options): (Method, &Options<'_>),
    limits: &Limits,
    model: &Model,
    pose: &Pose,
    wrench: &[f64],
) -> Result<Vec<f64>, InputError> {
    let mut solver = Solver::new(method, model.cable_count(), model.dof());
    let mut found = (Vec::new(), None);
    let balance = distribution::balance(model, pose, wrench, &mut |matrix, wrench| {
        solver.forget();
        let answer = solver.solve(matrix, wrench, limits, options)?;
        found = (answer.tensions.clone(), answer.reason());
        Ok(found.1.is_none().then(|| found.0.clone()))
    });
    let unsettled = balance.map_err(refused)?.reason;
    match (found, unsettled) {
        ((tensions, None), None) => Ok(tensions),
        ((_, Some(reason)), _) => Err(not_balanced(reason)),
        (_, Some(reason)) => Err(not_balanced(reason.to_string())),
    }
}

fn refused(error: DistributionError) -> InputError {
    match error {
        DistributionError::Statics(error) => error.into(),
        DistributionError::Tension(error) => error.into(),
        DistributionError::Limits(error) => error.into(),
    }
}

fn not_balanced(reason: String) -> InputError {
    InputError::NotBalanced { reason }
}
