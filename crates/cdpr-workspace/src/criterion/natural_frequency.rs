//! The lowest natural frequency of the platform on its cables.

use nalgebra::{DMatrix, Matrix6};

use super::cables::{mainly, not_negative};
use super::stiffness::HeldPlatform;
use super::{Criterion, Verdict};
use crate::WorkspaceError;
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::Model;
use cdpr_model::robot::{Body, Robot};
use cdpr_model::scalar::decomposition::symmetric_eigen;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;

/// The lowest frequency of small free vibrations at fixed controlled lengths, M δẍ + K_wx δx = 0, is at least the
/// required one.
///
/// M is the mass matrix of the platform about its origin (Newton, Euler), K_wx the symmetric part of the stiffness at
/// the tensions nearest to the middle of their limits that hold the load. Cables are massless and undamped. The margin
/// (Hz) is the excess of √(λ_min)/2π for the least eigenvalue of M⁻¹ K_wx; a negative λ_min keeps its sign before the
/// root. −∞ if no tensions within limits hold the load.
#[derive(Clone, Debug)]
pub(crate) struct NaturalFrequency<'a> {
    held: HeldPlatform<'a>,
    least: f64,
    /// Mass matrix about the platform origin, platform axes (kg, kg·m, kg·m²).
    mass_matrix: Matrix6<f64>,
}

const NAME: &str = "natural-frequency";

impl<'a> NaturalFrequency<'a> {
    /// The criterion for the least frequency (Hz). Needs elastic cables and a platform with mass, and with centre of
    /// mass and inertia as far as it turns.
    pub(crate) fn new(model: &'a Model, load: &Load, limits: &Limits, least: f64) -> Result<Self, WorkspaceError> {
        let least = not_negative(NAME, "least frequency", least, "it is a finite number of 0 or more (Hz)")?;
        let body = Body::of(model.robot()).map_err(|error| missing(model.robot(), error.key))?;
        let mass_matrix = body.mass_matrix();
        let held = HeldPlatform::new(model, load, limits, NAME)?;
        let criterion = Self { held, least, mass_matrix };
        match criterion.in_pattern(&Pose::identity()).cholesky() {
            Some(_) => Ok(criterion),
            None => Err(missing(model.robot(), "positive `mass_kg` and inertia in [platform]")),
        }
    }

    /// The mass matrix in the degrees of freedom of the model at a pose.
    fn in_pattern(&self, pose: &Pose) -> DMatrix<f64> {
        let rotation = pose.rotation.inverse();
        let local = |twist: &Twist| {
            let (v, omega) = (twist.fixed_rows::<3>(0).into_owned(), twist.fixed_rows::<3>(3).into_owned());
            let (v, omega) = (rotation * v, rotation * omega);
            Twist::new(v.x, v.y, v.z, omega.x, omega.y, omega.z)
        };
        let basis: Vec<Twist> = self.held.model.twist_basis().iter().map(local).collect();
        DMatrix::from_fn(basis.len(), basis.len(), |i, j| basis[i].dot(&(self.mass_matrix * basis[j])))
    }

    /// The lowest frequency (Hz) and its main direction.
    fn lowest(&self, system: &DMatrix<f64>, pose: &Pose) -> Option<(f64, String)> {
        let symmetric = (system + system.transpose()) * 0.5;
        // with M = L Lᵀ the eigenvalues of M⁻¹ K are those of L⁻¹ K L⁻ᵀ
        let lower = self.in_pattern(pose).cholesky()?.l();
        let half = lower.solve_lower_triangular(&symmetric)?;
        let whole = lower.solve_lower_triangular(&half.transpose())?;
        let eigen = symmetric_eigen(whole)?;
        let index = eigen.eigenvalues.imin();
        let shape = lower.transpose().solve_upper_triangular(&eigen.eigenvectors.column(index).into_owned())?;
        let eigenvalue = eigen.eigenvalues[index];
        let frequency = eigenvalue.abs().sqrt().copysign(eigenvalue) / std::f64::consts::TAU;
        let radius = self.held.model.platform_radius();
        let translations = self.held.model.robot().motion_pattern.translations();
        let ways = shape.iter().enumerate().map(|(row, part)| if row < translations { *part } else { part * radius });
        Some((frequency, mainly(self.held.model, ways)))
    }
}

fn missing(robot: &Robot, key: &str) -> WorkspaceError {
    WorkspaceError::MissingKey {
        criterion: NAME,
        robot: robot.name.clone(),
        key: key.to_owned(),
        cure: "vibrations need to know what is moved".to_owned(),
    }
}

impl Criterion for NaturalFrequency<'_> {
    fn name(&self) -> &str {
        NAME
    }

    fn unit(&self) -> &str {
        "Hz"
    }

    fn effort(&self) -> f64 {
        self.held.effort()
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let stiffness = match self.held.stiffness(pose) {
            Ok(stiffness) => stiffness,
            Err(verdict) => return verdict,
        };
        let Some((frequency, direction)) = self.lowest(&stiffness.system, pose) else {
            return Verdict::impossible("the stiffness is not finite", None);
        };
        let margin = frequency - self.least;
        let least = self.least;
        if margin >= 0.0 {
            return Verdict::held(margin, None);
        }
        let words = match frequency < 0.0 {
            true => format!("the platform does not swing about the pose but leaves it, mainly {direction}"),
            false => format!(
                "the lowest natural frequency is {frequency:.3} Hz, mainly {direction}; at least {least} Hz are asked for"
            ),
        };
        Verdict::failed(margin, words, None)
    }
}
