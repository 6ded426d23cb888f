//! Linearisation about an equilibrium: small motions of platform and drums.

use nalgebra::{Complex, DMatrix, DVector};

use super::error::PlantError;
use super::plant::Plant;
use super::state::PlantState;
use cdpr_model::cable::{CableInput, CableState};
use cdpr_model::geometry::Twist;
use cdpr_model::scalar::decomposition::eigenvalues;
use cdpr_model::statics::{StaticsError, axial_stiffness, indifferent_stiffness};

/// Largest sensible ω h: four digits of the period; at three times that value the motion grows.
pub(super) const SENSIBLE: f64 = 1.0;

/// M δz̈ + D δż + K δz = input about an equilibrium, with z the displacement \[δr; δφ\] in the n degrees of freedom,
/// followed by the angles of the drums if there are any.
///
/// For ideal winches controlled lengths are inputs: −K_wq δq_θ − D_q δq̇_θ on the right-hand side; for drums torques
/// are.
#[derive(Clone, Debug, PartialEq)]
pub struct Linearization {
    /// M, symmetric (kg, kg·m, kg·m²).
    pub mass: DMatrix<f64>,
    /// D (N·s/m and so on).
    pub damping: DMatrix<f64>,
    /// K (N/m and so on).
    pub stiffness: DMatrix<f64>,
    /// Degrees of freedom n of the platform.
    pub dof: usize,
    /// Change of the generalised force per wrench in the n degrees of freedom, then per controlled length (ideal
    /// winches) or motor torque.
    pub inputs: DMatrix<f64>,
    /// Change of the generalised force per rate of a controlled length; no columns for drums.
    pub rate_inputs: DMatrix<f64>,
    /// Path length per unit of z (m): 1 for translations, the platform radius for rotations, the drum's radius for
    /// drums.
    pub(super) ways: DVector<f64>,
    /// Stiffness that counts as zero (N/m), as in [`Stiffness`](cdpr_model::statics::Stiffness).
    pub indifferent_stiffness: f64,
}

impl Plant {
    /// Linearisation about a state, with its cables taut or slack as they are: of the laws, the geometry, the weight's
    /// moment, dampers and drums. The twist of the state has no effect.
    pub fn linearize(&self, state: &PlantState) -> Result<Linearization, PlantError> {
        let basis = self.model.twist_basis();
        let (n, m) = (basis.len(), self.model.cable_count());
        let size = n + self.drums.len();
        let mut linear = Linearization {
            mass: DMatrix::zeros(size, size),
            damping: DMatrix::zeros(size, size),
            stiffness: DMatrix::zeros(size, size),
            dof: n,
            inputs: DMatrix::zeros(size, n + m),
            rate_inputs: DMatrix::zeros(size, if self.drums.is_empty() { m } else { 0 }),
            ways: self.ways(state)?,
            indifferent_stiffness: 0.0,
        };
        let mass = state.inertia.mass_matrix_in_pattern(&self.model, &state.pose);
        linear.mass.view_mut((0, 0), (n, n)).copy_from(&mass);
        linear.inputs.view_mut((0, 0), (n, n)).fill_with_identity();
        let gradient = self.load_gradient(state);
        add_in_pattern(&mut linear.stiffness, basis, &-gradient);
        let drag = nalgebra::Matrix6::from_diagonal(&-state.inertia.drag(&Twist::repeat(1.0)));
        add_in_pattern(&mut linear.damping, basis, &drag);
        let mut stiffness = 0.0;
        for cable in 0..m {
            let motion = &state.cables[cable];
            let pull = if motion.is_broken { None } else { self.pull_of(state, cable)? };
            stiffness += pull.as_ref().map_or(0.0, axial_stiffness);
            self.add_cable(&mut linear, state, (cable, pull.as_ref()))?;
        }
        let length = state.cables.iter().map(|cable| cable.length).sum::<f64>() / m as f64;
        linear.indifferent_stiffness = indifferent_stiffness(stiffness, self.force(state), length);
        Ok(linear)
    }

    /// Path lengths of platform and drums per unit of z (m).
    fn ways(&self, state: &PlantState) -> Result<DVector<f64>, PlantError> {
        let (translations, radius) = (self.model.robot().motion_pattern.translations(), self.model.platform_radius());
        let of_platform = (0..self.model.dof()).map(|row| Ok(if row < translations { 1.0 } else { radius }));
        let of_drum = |cable: usize| Ok(self.drum_length(cable, state.cables[cable].drum_angle)?.1.abs());
        let ways = of_platform.chain((0..self.drums.len()).map(of_drum)).collect::<Result<Vec<f64>, PlantError>>()?;
        Ok(ways.into())
    }

    /// Magnitude of the forces that load the platform (N).
    fn force(&self, state: &PlantState) -> f64 {
        let added = self.gravity.norm() * state.added.mass.abs();
        self.load.force() + added + state.external.fixed_rows::<3>(0).norm()
    }

    fn load_gradient(&self, state: &PlantState) -> nalgebra::Matrix6<f64> {
        let mut gradient = self.load.gradient(&state.pose);
        let arm = (state.pose.rotation * state.added.moment).cross_matrix();
        let moment = self.gravity.cross_matrix() * arm;
        let mut turns = gradient.fixed_view_mut::<3, 3>(3, 3);
        turns += moment;
        gradient
    }

    /// Adds the contribution of one cable and its drum.
    fn add_cable(
        &self,
        linear: &mut Linearization,
        state: &PlantState,
        (cable, pull): (usize, Option<&CableState>),
    ) -> Result<(), PlantError> {
        let (basis, n) = (self.model.twist_basis(), linear.dof);
        if let Some(pull) = pull {
            add_in_pattern(&mut linear.stiffness, basis, &pull.stiffness());
        }
        let column = DVector::from_fn(n, |row, _| {
            let column = &state.pulls.columns[cable];
            (0..6).map(|k| column[k] * basis[row][k]).sum::<f64>()
        });
        let damping = if pull.is_some() { state.pulls.laws[cable].damping } else { 0.0 };
        let spread = &column * column.transpose() * damping;
        let mut corner = linear.damping.view_mut((0, 0), (n, n));
        corner += spread;
        let by_length = pull.map_or_else(Twist::zeros, CableState::wrench_by_controlled_length);
        let by_length = DVector::from_fn(n, |row, _| basis[row].dot(&by_length));
        if self.drums.is_empty() {
            linear.inputs.view_mut((0, n + cable), (n, 1)).copy_from(&by_length);
            linear.rate_inputs.view_mut((0, cable), (n, 1)).copy_from(&(&column * -damping));
            return Ok(());
        }
        self.add_drum(linear, state, (cable, pull), (&column, &by_length, damping))
    }

    fn add_drum(
        &self,
        linear: &mut Linearization,
        state: &PlantState,
        (cable, pull): (usize, Option<&CableState>),
        (column, by_length, damping): (&DVector<f64>, &DVector<f64>, f64),
    ) -> Result<(), PlantError> {
        let (basis, n, drum) = (self.model.twist_basis(), linear.dof, &self.drums[cable]);
        let (row, angle) = (n + cable, state.cables[cable].drum_angle);
        let radius = |angle: f64| self.drum_length(cable, angle).map(|(_, radius)| radius);
        let r = radius(angle)?;
        // a groove's radius changes so slowly that rounding would dominate smaller steps
        let by_angle = (radius(angle + 1e-3)? - radius(angle - 1e-3)?) / 2e-3;
        linear.mass[(row, row)] = drum.inertia;
        linear.inputs[(row, n + cable)] = -drum.gear;
        linear.damping[(row, row)] += state.friction[cable].viscous + r * r * damping;
        linear.stiffness[(row, row)] -= state.cables[cable].tension * by_angle;
        for k in 0..n {
            linear.stiffness[(k, row)] -= by_length[k] * r;
            linear.damping[(k, row)] += column[k] * damping * r;
            linear.damping[(row, k)] += column[k] * damping * r;
        }
        // at fixed lengths q_θ(x, T), the outlet tension T changes by δT = (δq_θ − c·δx)/c_T
        if let Some(pull) = pull {
            let (by_pose, by_tension) = (pull.controlled_length_by_pose(), pull.controlled_length_by_tension);
            linear.stiffness[(row, row)] -= r * r / by_tension;
            for k in 0..n {
                linear.stiffness[(row, k)] += r * basis[k].dot(&by_pose) / by_tension;
            }
        }
        Ok(())
    }

    /// State of the cable at its lengths with all derivatives; `None` if it is slack.
    fn pull_of(&self, state: &PlantState, cable: usize) -> Result<Option<CableState>, PlantError> {
        let motion = &state.cables[cable];
        if !self.sags && !(state.pulls.laws[cable].tension > 0.0) {
            return Ok(None);
        }
        let law = match &motion.memory {
            Some(memory) => self.model.law(cable).with_memory(memory),
            None => self.model.law(cable).clone(),
        };
        let end = self.model.cable_end(cable, state.pose.position.into(), &state.pose.rotation_rows());
        let input = CableInput::ControlledLength(motion.unstrained_length());
        let found = law.state_from(end, input, motion.span);
        found.map(Some).map_err(|reason| StaticsError::of_cable(cable, motion.length, reason).into())
    }
}

impl Linearization {
    /// Number of entries of z.
    pub fn size(&self) -> usize {
        self.mass.nrows()
    }

    /// System matrix A of ẏ = A y + B u with y = \[δz; δż\]; `None` if the mass matrix is singular.
    pub fn system_matrix(&self) -> Option<DMatrix<f64>> {
        let size = self.size();
        let inverse = self.mass.clone().try_inverse()?;
        let mut matrix = DMatrix::zeros(2 * size, 2 * size);
        matrix.view_mut((0, size), (size, size)).fill_with_identity();
        matrix.view_mut((size, 0), (size, size)).copy_from(&-(&inverse * &self.stiffness));
        matrix.view_mut((size, size), (size, size)).copy_from(&-(&inverse * &self.damping));
        Some(matrix)
    }

    /// Input matrix B of ẏ = A y + B u, with u = \[wrench; controlled lengths or torques; rates of controlled
    /// lengths\]; `None` if the mass matrix is singular.
    pub fn input_matrix(&self) -> Option<DMatrix<f64>> {
        let size = self.size();
        let inverse = self.mass.clone().try_inverse()?;
        let (inputs, rates) = (self.inputs.ncols(), self.rate_inputs.ncols());
        let mut matrix = DMatrix::zeros(2 * size, inputs + rates);
        matrix.view_mut((size, 0), (size, inputs)).copy_from(&(&inverse * &self.inputs));
        matrix.view_mut((size, inputs), (size, rates)).copy_from(&(&inverse * &self.rate_inputs));
        Some(matrix)
    }

    /// Eigenvalues of A (1/s); `None` if they were not found.
    pub fn eigenvalues(&self) -> Option<Vec<Complex<f64>>> {
        eigenvalues(self.system_matrix()?)
    }

    /// Largest sensible step of [`Plant::step`] (s), from the fastest motion; `None` if there is none.
    pub fn largest_step(&self) -> Option<f64> {
        self.fastest().filter(|fastest| *fastest > 0.0).map(sensible_step)
    }

    /// Largest magnitude of an eigenvalue of A (rad/s): the fastest motion.
    pub(super) fn fastest(&self) -> Option<f64> {
        Some(self.eigenvalues()?.iter().map(|value| value.norm()).fold(0.0, f64::max))
    }
}

/// Largest sensible step (s) of a machine whose fastest motion has this rate (rad/s).
pub(super) fn sensible_step(fastest: f64) -> f64 {
    one_digit_below(SENSIBLE / fastest)
}

/// The largest number with one significant digit that is not above `number`.
fn one_digit_below(number: f64) -> f64 {
    let power = 10f64.powi(number.log10().floor() as i32);
    // the product of two rounded numbers may lie above
    let digit = (number / power).floor();
    if digit * power <= number { digit * power } else { (digit - 1.0) * power }
}

/// Adds Bᵀ M B to the block of the platform.
fn add_in_pattern(target: &mut DMatrix<f64>, basis: &[Twist], matrix: &nalgebra::Matrix6<f64>) {
    for (column, twist) in basis.iter().enumerate() {
        let change = matrix * twist;
        basis.iter().enumerate().for_each(|(row, other)| target[(row, column)] += other.dot(&change));
    }
}
