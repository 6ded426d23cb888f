//! The last digits with rigid cables: Newton steps on pose and tensions together.
//!
//! Flat configurations need tensions far above the load; there virtual springs would have to be so stiff that rounding
//! of the pose shows. With the tensions as additional unknowns nothing is stiff: S δf − K δx = −r and Sᵀ δx = q − q_θ,
//! with the columns S of the structure matrix for taut rigid cables and K = K_C − K_G − ∂w/∂x of all other parts.

use nalgebra::{DMatrix, DVector};

use super::descent::EquilibriumEnd;
use super::problem::Problem;
use super::rigid::Rigid;
use crate::geometry::{Pose, Twist};
use crate::solve::{self, Control, Rules, Step, StepRule, Trial, descend};
use crate::statics::{Load, geometric_stiffness, wrench_residual};

const MAX_STEPS: u32 = 8;
/// Residual wrench relative to the sum of the tensions that counts as rounding.
const RESIDUAL: f64 = 1e-11;

/// A pose with its tensions and residuals.
struct State {
    pose: Pose,
    /// One per cable (N).
    tensions: Vec<f64>,
    /// Aᵀ f + w in the robot's degrees of freedom.
    residual: DVector<f64>,
    /// Largest length error of a taut rigid cable (m).
    excess: f64,
}

/// Balance of pose and tensions together, as a problem of the common descent loop.
struct Polish<'a, 'p> {
    problem: &'a Problem<'p>,
    rigid: &'a Rigid<'a>,
    load: &'a Load,
    taut: &'a [usize],
    state: Option<State>,
    trial: Option<State>,
}

impl solve::Problem for Polish<'_, '_> {
    type Number = f64;

    fn step(&mut self, _: &Control<f64>) -> Step<f64> {
        let from = self.state.as_ref();
        let found = from.and_then(|state| self.problem.step(self.rigid, self.load, self.taut, state));
        let (is_regular, size) = (found.is_some(), found.as_ref().map_or(0.0, |(_, size)| *size));
        self.trial = found.map(|(state, _)| state);
        Step::whole(size, is_regular)
    }

    /// A step helps if it halves the residual of forces or of lengths.
    fn evaluate(&mut self, _: f64, _: bool) -> Trial<f64> {
        let halves = |trial: &State, state: &State| {
            trial.residual.norm() < 0.5 * state.residual.norm() || trial.excess < 0.5 * state.excess
        };
        let helps =
            self.trial.as_ref().is_some_and(|trial| self.state.as_ref().is_none_or(|state| halves(trial, state)));
        Trial::new(1.0, helps)
    }

    fn accept(&mut self, helps: bool, _: f64) {
        if helps {
            self.state = self.trial.take();
        }
    }
}

impl Problem<'_> {
    /// Takes steps on pose and tensions from a pose near the solution; `None` if they do not converge or change the set
    /// of taut cables.
    pub(super) fn polished(
        &self,
        rigid: &Rigid<'_>,
        end: &EquilibriumEnd,
        tensions: &[f64],
    ) -> Option<(EquilibriumEnd, Vec<f64>)> {
        let load = self.full_load;
        let taut: Vec<usize> = rigid.cables().filter(|&cable| tensions[cable] > 0.0).collect();
        let start = self.state(rigid, load, &taut, end.pose, tensions.to_vec())?;
        let mut polish = Polish { problem: self, rigid, load, taut: &taut, state: None, trial: Some(start) };
        let rules = Rules {
            // to rounding
            tolerance: f64::EPSILON * self.mean_length,
            max_iterations: MAX_STEPS,
            least_gain: 0.0,
            rule: StepRule::Plain { slowest: f64::INFINITY },
        };
        descend(&mut polish, &rules);
        let state = polish.state?;
        let pushes = state.tensions.iter().any(|&tension| tension < 0.0);
        let too_long = rigid.cables().any(|cable| {
            let (path, _) = self.model.path_or_nan(cable, &state.pose);
            !(path.length - rigid.lengths[cable] <= self.settings.length_tolerance)
        });
        let pull: f64 = state.tensions.iter().sum();
        if pushes || too_long || !(state.residual.norm() <= RESIDUAL * pull.max(1.0)) {
            return None;
        }
        let stiffness = self.stiffness(rigid, load, &state)?;
        let mut end = EquilibriumEnd { pose: state.pose, residual: [0.0; 6], ..*end };
        for (i, direction) in self.model.twist_basis().iter().enumerate() {
            for k in 0..6 {
                end.residual[k] += direction[k] * state.residual[i];
            }
            for j in 0..=i {
                end.stiffness[i][j] = 0.5 * (stiffness[(i, j)] + stiffness[(j, i)]);
            }
        }
        Some((end, state.tensions))
    }

    fn state(
        &self,
        rigid: &Rigid<'_>,
        load: &Load,
        taut: &[usize],
        pose: Pose,
        mut tensions: Vec<f64>,
    ) -> Option<State> {
        let mut excess = 0.0_f64;
        for (cable, tension) in tensions.iter_mut().enumerate() {
            let length = self.model.path(cable, &pose).ok()?.0.length;
            if !rigid.is_rigid[cable] {
                *tension = self.model.elasticity(cable).tension(length, rigid.lengths[cable]).value.max(0.0);
            } else if taut.contains(&cable) {
                excess = excess.max((length - rigid.lengths[cable]).abs());
            }
        }
        // statics refuses tensions below zero, which cables do not have
        let residual = wrench_residual(self.model, &pose, &tensions, load).ok()?;
        Some(State { pose, tensions, residual, excess })
    }

    /// K_C of the elastic cables − K_G − ∂w/∂x.
    fn stiffness(&self, rigid: &Rigid<'_>, load: &Load, state: &State) -> Option<DMatrix<f64>> {
        let gradient = load.gradient(&state.pose);
        let basis = self.model.twist_basis();
        let by_load = DMatrix::from_fn(basis.len(), basis.len(), |i, j| basis[i].dot(&(gradient * basis[j])));
        let mut stiffness = -geometric_stiffness(self.model, &state.pose, &state.tensions).ok()? - by_load;
        let structure_matrix = self.model.structure_matrix(&state.pose).ok()?;
        for cable in (0..rigid.lengths.len()).filter(|&cable| !rigid.is_rigid[cable] && state.tensions[cable] > 0.0) {
            let length = self.model.path(cable, &state.pose).ok()?.0.length;
            let by_length = self.model.elasticity(cable).tension(length, rigid.lengths[cable]).by_length;
            let column = structure_matrix.column(cable);
            stiffness.ger(by_length, &column, &column, 1.0);
        }
        Some(stiffness)
    }

    /// State after Newton's step, and the size of the step (m); rotations count by the platform radius.
    fn step(&self, rigid: &Rigid<'_>, load: &Load, taut: &[usize], state: &State) -> Option<(State, f64)> {
        let (n, k) = (self.model.dof(), taut.len());
        let structure_matrix = self.model.structure_matrix(&state.pose).ok()?;
        let mut system = DMatrix::zeros(n + k, n + k);
        let mut right = DVector::zeros(n + k);
        system.view_mut((0, 0), (n, n)).copy_from(&self.stiffness(rigid, load, state)?);
        right.rows_mut(0, n).copy_from(&state.residual);
        for (index, &cable) in taut.iter().enumerate() {
            right[n + index] = self.model.path(cable, &state.pose).ok()?.0.length - rigid.lengths[cable];
            for row in 0..n {
                system[(row, n + index)] = -structure_matrix[(row, cable)];
                system[(n + index, row)] = structure_matrix[(row, cable)];
            }
        }
        let step = system.lu().solve(&right)?;
        let mut twist = Twist::zeros();
        for (direction, amount) in self.model.twist_basis().iter().zip(step.iter()) {
            twist += direction * *amount;
        }
        let mut tensions = state.tensions.clone();
        for (index, &cable) in taut.iter().enumerate() {
            tensions[cable] += step[n + index];
        }
        let size = twist.fixed_rows::<3>(0).norm().hypot(self.platform_radius * twist.fixed_rows::<3>(3).norm());
        Some((self.state(rigid, load, taut, state.pose.displaced(&twist), tensions)?, size))
    }
}
