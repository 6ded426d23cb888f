//! Stiffness of the platform at a pose with given tensions: K_C, K_G, the part of the load, and quantities derived from
//! them.

use nalgebra::{DMatrix, DVector, Matrix6};

use super::Load;
use super::cable_states::cable_state;
use super::error::{StaticsError, check_tensions};
use super::stability::{Stability, indifferent_stiffness};
use crate::cable::CableState;
use crate::geometry::{Pose, Twist};
use crate::model::{Model, StretchEffect};
use crate::scalar::decomposition::{svd, symmetric_eigen};

/// Change of the wrench on the platform with small displacements at fixed controlled lengths.
///
/// All matrices are in the motion pattern's n degrees of freedom: forces by displacements in N/m, mixed parts in N,
/// moments by rotations in N·m/rad. Balance Aᵀ f(q, q_θ) + w = 0, differentiated (eq. 2.66, 2.74), reads
///
/// (K_G + ∂w/∂x − K_C) δx − K_wq δq_θ + δw = 0,  so  δx = K_wx⁻¹ (δw − K_wq δq_θ)  with  K_wx = K_C − K_G − ∂w/∂x.
#[derive(Clone, Debug, PartialEq)]
pub struct Stiffness {
    /// K_C = Aᵀ K A from the stretch of the cables, n × n (eq. 2.75).
    pub cable: DMatrix<f64>,
    /// K_G = Σ fᵢ ∂\[uᵢ; bᵢ × uᵢ\]/∂x from the turning of cables and moment arms, n × n (eq. 2.67).
    pub geometric: DMatrix<f64>,
    /// ∂w/∂x: the weight's moment turns with the platform, n × n.
    pub load: DMatrix<f64>,
    /// K_wx = K_C − K_G − ∂w/∂x, n × n: the stiffness of the system.
    pub system: DMatrix<f64>,
    /// K_wq = Aᵀ K_θ, n × m (eq. 2.79).
    pub by_controlled_length: DMatrix<f64>,
    /// Diagonal of K: ∂fᵢ/∂qᵢ at fixed controlled length (N/m).
    pub cable_stiffness: Vec<f64>,
    /// Diagonal of K_θ: −∂fᵢ/∂q_θ,ᵢ at fixed geometric length (N/m). It differs from K by 1 + strain.
    pub controlled_length_stiffness: Vec<f64>,
    /// Controlled lengths q_θ for these tensions (m).
    pub controlled_lengths: Vec<f64>,
    /// Stiffness up to which an equilibrium is indifferent (N/m): the smaller of 1e-9 of the cables' total stiffness
    /// and 1e-6 of the load's force over the mean cable length, but at least 1e-12 of the cables' total stiffness.
    pub indifferent_stiffness: f64,
    /// Scales twists to \[δr; ρ δφ\], all in metres: 1 for translations, 1/ρ for rotations.
    scaling: DVector<f64>,
}

/// Singular values below this fraction of the largest are rounding.
const ROUNDING: f64 = 1e-13;

impl Stiffness {
    /// Stiffness of cables with these tensions (N) under this load.
    ///
    /// Controlled lengths are those that give the tensions, and stay fixed. A cable without tension is slack: it
    /// neither stretches nor turns a force, and adds nothing. Tensions and load need not be in balance, but only at an
    /// equilibrium do the matrices describe how the platform moves.
    pub fn at(model: &Model, pose: &Pose, tensions: &[f64], load: &Load) -> Result<Self, StaticsError> {
        check_tensions(model, tensions)?;
        let (n, m) = (model.dof(), model.cable_count());
        let mut stiffness = Self {
            cable: DMatrix::zeros(n, n),
            geometric: DMatrix::zeros(n, n),
            load: in_pattern(model, &load.gradient(pose)),
            system: DMatrix::zeros(n, n),
            by_controlled_length: DMatrix::zeros(n, m),
            cable_stiffness: Vec::with_capacity(m),
            controlled_length_stiffness: Vec::with_capacity(m),
            controlled_lengths: Vec::with_capacity(m),
            indifferent_stiffness: 0.0,
            scaling: scaling(model),
        };
        let mut lengths = 0.0;
        let mut turning = Matrix6::zeros();
        for (index, &tension) in tensions.iter().enumerate() {
            let state = cable_state(model, pose, index, tension)?;
            if model.law(index).is_inextensible_line() {
                return Err(StaticsError::Rigid { cable: index + 1, cure: cure(model, index) });
            }
            turning += state.wrench_by_pose();
            lengths += state.strained_length;
            stiffness.add_stretch(model.twist_basis(), index, &state);
        }
        stiffness.geometric = in_pattern(model, &turning);
        stiffness.system = &stiffness.cable - &stiffness.geometric - &stiffness.load;
        stiffness.indifferent_stiffness =
            indifferent_stiffness(stiffness.cable_stiffness.iter().sum(), load.force(), lengths / m as f64);
        Ok(stiffness)
    }

    /// Adds the effect of a changing tension: K_C is (∂W/∂q_θ)(∂q_θ/∂x) at fixed tension.
    fn add_stretch(&mut self, basis: &[Twist], index: usize, state: &CableState) {
        let (by_length, by_pose) = (state.wrench_by_controlled_length(), state.controlled_length_by_pose());
        for (row, twist) in basis.iter().enumerate() {
            self.by_controlled_length[(row, index)] = -twist.dot(&by_length);
        }
        for (column, twist) in basis.iter().enumerate() {
            let lengthens = twist.dot(&by_pose);
            for row in 0..basis.len() {
                self.cable[(row, column)] -= self.by_controlled_length[(row, index)] * lengthens;
            }
        }
        let along = |a: [f64; 3]| crate::scalar::dot(a, state.direction);
        self.cable_stiffness.push(axial_stiffness(state));
        self.controlled_length_stiffness.push(-along(state.by_controlled_length));
        self.controlled_lengths.push(state.controlled_length);
    }

    /// Compliance K_wx⁻¹, the displacement per wrench, δx = K_wx⁻¹ δw (m/N, 1/N, rad/(N·m)); `None` if the stiffness is
    /// singular, so that some displacement meets no resistance.
    ///
    /// The sign is that of δx = +K_wx⁻¹ δw; eq. 2.78 has the opposite one.
    pub fn compliance(&self) -> Option<DMatrix<f64>> {
        let scaled = self.scaled(&self.system);
        let values = svd(scaled.clone(), false, false)?.singular_values;
        if !(values.min() > ROUNDING * values.max()) {
            return None;
        }
        // (S K S)⁻¹ = S⁻¹ K⁻¹ S⁻¹
        Some(self.scaled(&scaled.try_inverse()?))
    }

    /// Displacement of the platform per change of the controlled lengths, −K_wx⁻¹ K_wq, n × m (eq. 2.80); `None` as for
    /// [`Stiffness::compliance`].
    pub fn pose_by_controlled_lengths(&self) -> Option<DMatrix<f64>> {
        Some(-(self.compliance()? * &self.by_controlled_length))
    }

    /// Eigenvalues of the symmetric part of K_wx, ascending (N/m), rotations divided by the platform radius. Empty if
    /// numbers overflow.
    ///
    /// Moments of constant direction add a skew part to K_wx; the work of a displacement, and so stability, depends
    /// only on the symmetric part.
    pub fn eigenvalues(&self) -> Vec<f64> {
        let symmetric = self.scaled(&((&self.system + self.system.transpose()) * 0.5));
        let mut values =
            symmetric_eigen(symmetric).map_or_else(Vec::new, |eigen| eigen.eigenvalues.as_slice().to_vec());
        values.sort_by(f64::total_cmp);
        values
    }

    /// Judges an equilibrium by the smallest of the [eigenvalues](Stiffness::eigenvalues).
    pub fn stability(&self) -> Stability {
        Stability::of(self.eigenvalues().first().copied().unwrap_or(f64::NAN), self.indifferent_stiffness)
    }

    /// S M S.
    fn scaled(&self, matrix: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] * self.scaling[i] * self.scaling[j])
    }
}

/// Stiffness of a cable along its direction at fixed controlled length, ∂f/∂q (N/m).
pub fn axial_stiffness(state: &CableState) -> f64 {
    let along = |a: [f64; 3]| crate::scalar::dot(a, state.direction);
    -along(state.tangent.map(along))
}

/// K_G = Σ fᵢ ∂\[uᵢ; bᵢ × uᵢ\]/∂x, n × n: the change of the wrench of constant tensions with the pose (eq. 2.67).
///
/// Unlike [`Stiffness::at`] it does not need the cables' elasticity.
pub fn geometric_stiffness(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<DMatrix<f64>, StaticsError> {
    check_tensions(model, tensions)?;
    let mut turning = Matrix6::zeros();
    for (index, &tension) in tensions.iter().enumerate() {
        turning += cable_state(model, pose, index, tension)?.wrench_by_pose();
    }
    Ok(in_pattern(model, &turning))
}

fn scaling(model: &Model) -> DVector<f64> {
    let translations = model.robot().motion_pattern.translations();
    let radius = model.platform_radius();
    DVector::from_fn(model.dof(), |row, _| if row < translations { 1.0 } else { 1.0 / radius })
}

/// Bᵀ M B for the twist basis B.
fn in_pattern(model: &Model, matrix: &Matrix6<f64>) -> DMatrix<f64> {
    let basis: &[Twist] = model.twist_basis();
    let mut projected = DMatrix::zeros(basis.len(), basis.len());
    for (column, twist) in basis.iter().enumerate() {
        let change = matrix * twist;
        basis.iter().enumerate().for_each(|(row, other)| projected[(row, column)] = other.dot(&change));
    }
    projected
}

fn cure(model: &Model, index: usize) -> String {
    let mut composition = model.composition();
    if composition.is_elastic() {
        let name = &model.robot().cables[index].name;
        return format!("cable \"{name}\" has the compliance 0 in the robot file, give it an axial_stiffness_EA_N");
    }
    composition.stretch = StretchEffect::Linear;
    format!("the model `{}` knows rigid cables only, use the model `{composition}`", model.composition())
}
