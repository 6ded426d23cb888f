//! Cables at rest with given tensions, whatever their effects: pulls, wrenches and stiffness of one cable.

use nalgebra::{Matrix3, Matrix6, Vector3};

use super::error::{StaticsError, check_tensions};
use crate::cable::law::{Hold, Known};
use crate::cable::stretch::hysteresis::Memory;
use crate::geometry::{Pose, Wrench};
use crate::model::Model;

/// A cable at rest and the lever at which it pulls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// What the cable does.
    pub hold: Hold,
    /// b = R b_P (world, m).
    pub lever: Vector3<f64>,
    /// True when the robot's tensions are meant at the platform.
    pub is_known_at_platform: bool,
}

/// All cables of a model at a pose with these tensions (N), which are those at the outlets, or where the file says that they
/// are measured.
pub fn holds(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<Vec<Held>, StaticsError> {
    check_tensions(model, tensions)?;
    tensions.iter().enumerate().map(|(index, &tension)| held(model, pose, index, tension)).collect()
}

/// One cable of [`holds`] (0-based).
pub fn held(model: &Model, pose: &Pose, index: usize, tension: f64) -> Result<Held, StaticsError> {
    // a pose without a course is told in the words of the geometry
    model.course(index, pose)?;
    held_at(model, pose, index, tension, None)
}

/// [`held`] where the cable is known to have a course, from a memory of its own or never loaded.
pub(super) fn held_at(
    model: &Model,
    pose: &Pose,
    index: usize,
    tension: f64,
    memory: Option<&Memory>,
) -> Result<Held, StaticsError> {
    let known = model.known_tension(index, tension);
    let is_known_at_platform = matches!(known, Known::PlatformTension(_));
    let (hold, lever) = model
        .hold_from(index, pose, known, memory)
        .map_err(|reason| StaticsError::Hold { cable: index + 1, reason })?;
    Ok(Held { hold, lever, is_known_at_platform })
}

impl Held {
    /// Wrench on the platform, \[t; b × t\] (N, N·m).
    pub fn wrench(&self) -> Wrench {
        self.wrench_of(&self.hold.pull.into())
    }

    /// Change of the wrench with the tension where the robot measures it, at a fixed pose: the column of the structure matrix of
    /// a straight cable.
    pub fn wrench_by_tension(&self) -> Wrench {
        let by_tension = Vector3::from(self.hold.by_tension);
        self.wrench_of(&match self.is_known_at_platform {
            true => by_tension / by_tension.dot(&Vector3::from(self.hold.direction)),
            false => by_tension,
        })
    }

    /// Change of the wrench with the controlled length, at a fixed pose (N/m, N).
    pub fn wrench_by_controlled_length(&self) -> Wrench {
        self.wrench_of(&self.hold.by_controlled_length.into())
    }

    fn wrench_of(&self, pull: &Vector3<f64>) -> Wrench {
        let moment = self.lever.cross(pull);
        Wrench::new(pull.x, pull.y, pull.z, moment.x, moment.y, moment.z)
    }

    /// −∂\[t; b × t\]/∂\[δr; δφ\] at fixed controlled length.
    pub fn stiffness(&self) -> Matrix6<f64> {
        self.stiffness_of(&matrix(&self.hold.tangent), &self.hold.pull.into())
    }

    /// −∂\[t; b × t\]/∂\[δr; δφ\] at fixed tension at the outlet: minus the cable's share of K_G.
    pub fn stiffness_at_tension(&self) -> Matrix6<f64> {
        let by_length = Vector3::from(self.hold.by_controlled_length);
        let length_change = Vector3::from(self.hold.controlled_length_by_anchor).transpose();
        self.stiffness_of(&(matrix(&self.hold.tangent) + by_length * length_change), &self.hold.pull.into())
    }

    /// \[I, −\[b\]×\]ᵀ M \[I, −\[b\]×\] for M = −∂t/∂p_B, and the lever that turns under the pull.
    fn stiffness_of(&self, tangent: &Matrix3<f64>, pull: &Vector3<f64>) -> Matrix6<f64> {
        let lever = self.lever.cross_matrix();
        let by_turn = -tangent * lever;
        let mut stiffness = Matrix6::zeros();
        stiffness.fixed_view_mut::<3, 3>(0, 0).copy_from(&-tangent);
        stiffness.fixed_view_mut::<3, 3>(0, 3).copy_from(&-by_turn);
        stiffness.fixed_view_mut::<3, 3>(3, 0).copy_from(&-(lever * tangent));
        // (δφ × b) × t = [t]× [b]× δφ
        let turned = pull.cross_matrix() * lever;
        stiffness.fixed_view_mut::<3, 3>(3, 3).copy_from(&-(lever * by_turn + turned));
        stiffness
    }
}

/// A matrix given by its rows.
fn matrix(rows: &[[f64; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|row, column| rows[row][column])
}
