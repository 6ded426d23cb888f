//! How the winches are set: initial tensions and offsets.

use nalgebra::{DMatrix, DVector};

use super::control::lengths_at;
use super::input_error::{InputError, check_same_robot};
use super::study::{Initial, TensionMethod};
use crate::geometry::Pose;
use crate::model::Model;
use crate::robot::Cable;
use crate::statics::Load;

/// Winch offsets that a study asks for (m): none, given ones, or those that bring the machine to the initial pose with the
/// initial tensions, q_off = φ̂(x_ini, f_ini) − φ(x_ini).
///
/// φ̂ is the machine's inverse, φ that of the model in use when the winches were set: the control model, or that of
/// `offset_robot`. Both are taken in the units of their encoders. A kinematic φ knows no tension, so on a machine of the same
/// geometry the offsets are −f q/k_F (eq. 6.24). An elastic φ is told the same initial tensions, so that a machine that is
/// like its control model has offsets of zero.
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
    let tensions = match [machine, set_with].into_iter().find(|model| model.composition().elastic) {
        Some(elastic) => initial_tensions(initial, elastic, pose)?,
        // rigid cables have the same length at any tension
        None => vec![0.0; expected],
    };
    let (wanted, sent) = (lengths_at(machine, pose, &tensions)?, lengths_at(set_with, pose, &tensions)?);
    Ok(wanted.iter().zip(&sent).map(|(wanted, sent)| wanted - sent).collect())
}

/// The tensions f_ini that a study asks for at its initial pose, in balance with the load of the model's robot (N).
///
/// Given tensions are brought into balance by the smallest change, f − A⁺ᵀ (w + Aᵀ f); so is, with the method `closed-form`,
/// the middle of the limits (eq. 3.41).
pub fn initial_tensions(initial: &Initial, model: &Model, pose: &Pose) -> Result<Vec<f64>, InputError> {
    let structure_matrix = model.structure_matrix(pose)?;
    let wrench = Load::of(model.robot())?.in_pattern(model, pose);
    let tensions = match (&initial.tensions_N, initial.tension_method) {
        (Some(tensions), _) => {
            let (expected, found) = (model.cable_count(), tensions.len());
            if expected != found {
                return Err(InputError::Count { key: "tensions_N", expected, found });
            }
            balanced(model, &structure_matrix, &wrench, tensions)?
        }
        (None, Some(TensionMethod::ClosedForm)) => {
            let middle = middle_of_limits(model)?;
            balanced(model, &structure_matrix, &wrench, &middle)?
        }
        (None, None) => return Err(InputError::NoTensions),
    };
    match tensions.iter().position(|&tension| tension < 0.0) {
        Some(cable) => {
            let reason = format!("cable {} would have to push with {:.0} N", cable + 1, -tensions[cable]);
            Err(InputError::NotBalanced { reason })
        }
        None => Ok(tensions),
    }
}

/// The tensions nearest to these that balance the wrench: f − A⁺ᵀ (w + Aᵀ f).
fn balanced(
    model: &Model,
    structure_matrix: &DMatrix<f64>,
    wrench: &DVector<f64>,
    tensions: &[f64],
) -> Result<Vec<f64>, InputError> {
    let f = DVector::from_column_slice(tensions);
    // moments over the platform radius, so that rank and residual compare like with like
    let (mut matrix, mut missing) = (structure_matrix.clone(), wrench + structure_matrix * &f);
    for row in model.robot().motion_pattern.translations()..model.dof() {
        matrix.row_mut(row).scale_mut(1.0 / model.platform_radius());
        missing[row] /= model.platform_radius();
    }
    let size = missing.norm();
    let decomposition = matrix.clone().svd(true, true);
    let change = decomposition
        .solve(&missing, 1e-12 * decomposition.singular_values.amax())
        .expect("both sides of the decomposition were asked for");
    // rounding of numbers of this size
    let left = (&matrix * &change - &missing).norm();
    if left > 1e-9 * size.max(f.norm()) {
        let reason = format!("the cables leave {left:.3} N of it unbalanced whatever their tensions");
        return Err(InputError::NotBalanced { reason });
    }
    Ok((f - change).as_slice().to_vec())
}

fn middle_of_limits(model: &Model) -> Result<Vec<f64>, InputError> {
    let cables = model.robot().cables.iter().enumerate();
    let middle = |limits: &Cable| Some((limits.tension_min? + limits.tension_max?) / 2.0);
    cables.map(|(cable, limits)| middle(limits).ok_or(InputError::NoLimits { cable: cable + 1 })).collect()
}
