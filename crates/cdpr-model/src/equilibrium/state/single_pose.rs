//! Structure matrix and tensions of one pose in the memory of a state, which is claimed only once.

use nalgebra::DMatrix;

use super::State;
use super::balanced::Balanced;
use crate::cable::GeometryError;
use crate::equilibrium::distribution::DistributionError;
use crate::geometry::Pose;
use crate::model::Model;
use crate::statics::{Load, StaticsError};
use crate::tension::Limits;
use crate::tension::closed_form::Solution;

impl State {
    /// Memory for a robot of this size, claimed once.
    fn balanced(&mut self, model: &Model) -> &mut Balanced {
        let size = (model.dof(), model.cable_count());
        if self.balanced.as_ref().is_some_and(|kept| kept.structure_matrix.shape() != size) {
            self.balanced = None;
        }
        self.balanced.get_or_insert_with(|| Balanced::of(model))
    }
}

impl Model {
    /// [`Model::structure_matrix`], written to the memory of a state; the robot does not move.
    pub fn structure_matrix_in<'s>(
        &self,
        pose: &Pose,
        state: &'s mut State,
    ) -> Result<&'s DMatrix<f64>, GeometryError> {
        let matrix = &mut state.balanced(self).structure_matrix;
        self.write_structure_matrix(pose, matrix)?;
        Ok(matrix)
    }

    /// Tensions nearest to the middle of the limits that balance the load at a pose (eq. 3.41), written to the memory
    /// of a state; the robot does not move. They agree with those of
    /// [`closed_form::solve`](crate::tension::closed_form::solve) to rounding times the condition of the structure
    /// matrix.
    ///
    /// The directions are those of straight cables; those of sagging cables follow their tensions, see
    /// [`crate::equilibrium::distribution`].
    ///
    /// ```
    /// use cdpr::equilibrium::State;
    /// use cdpr::model::{Composition, Model};
    /// use cdpr::robot::Robot;
    /// use cdpr::statics::Load;
    /// use cdpr::tension::Limits;
    ///
    /// let robot = Robot::builtin("cogiro").ok_or("unknown robot")?;
    /// let (load, limits) = (Load::of(&robot)?, Limits::uniform(8, 0.0, 5000.0)?);
    /// let model = Model::new(robot, Composition::STANDARD)?;
    /// let mut state = State::at_home(&model);
    /// let found = model.closed_form_tensions(&state.pose(), &load, &limits, &mut state)?;
    /// assert!(found.balanced);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn closed_form_tensions<'s>(
        &self,
        pose: &Pose,
        load: &Load,
        limits: &Limits,
        state: &'s mut State,
    ) -> Result<&'s Solution, DistributionError> {
        let mut wrench = [0.0; 6];
        load.write_in_pattern(self, pose, &mut wrench);
        let balanced = state.balanced(self);
        if !balanced.in_registers(self, pose, wrench, limits) {
            self.write_structure_matrix(pose, &mut balanced.structure_matrix).map_err(StaticsError::from)?;
            balanced.by_factors(&wrench[..self.dof()], limits)?;
        }
        Ok(&balanced.found)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::geometry::Wrench;
    use crate::model::Composition;
    use crate::robot::{Robot, builtin};
    use crate::tension::{InputError, closed_form};

    /// In the same state from pose to pose, for robots of all sizes, compared with the general solver, which also
    /// solves dependent rows.
    #[test]
    fn tensions_of_a_single_pose_are_those_of_the_solver_of_matrices() {
        let load = Load::constant(Wrench::new(10.0, -20.0, -500.0, 5.0, 20.0, -3.0));
        for name in builtin::names() {
            let model = Model::new(Robot::builtin(name).unwrap(), Composition::STANDARD).unwrap();
            let limits = Limits::uniform(model.cable_count(), 50.0, 2000.0).unwrap();
            let mut state = State::at_home(&model);
            let home = state.pose();
            for k in 0..16 {
                let t = f64::from(k);
                let shift = Vector3::new(0.3 * t.sin(), 0.2 * t.cos(), 0.1 * (2.0 * t).sin());
                let along = |k: usize| model.axes().get(k).map_or(Vector3::zeros(), |axis| axis * shift[k]);
                let pose = Pose { position: home.position + along(0) + along(1) + along(2), ..home };
                let matrix = model.structure_matrix(&pose).unwrap();
                assert_eq!(model.structure_matrix_in(&pose, &mut state).unwrap(), &matrix);
                let wrench = load.in_pattern(&model, &pose);
                let expected = closed_form::solve(&matrix, wrench.as_slice(), &limits).unwrap();
                let found = model.closed_form_tensions(&pose, &load, &limits, &mut state).unwrap();
                assert_eq!((found.rank, found.balanced), (expected.rank, expected.balanced), "{name}");
                assert_eq!(found.within_limits, expected.within_limits, "{name}");
                for (found, expected) in found.tensions.iter().zip(&expected.tensions) {
                    // rounding of two different factorisations, times a condition of up to a thousand
                    let apart = (found - expected).abs();
                    assert!(apart < 1e-8 * expected.abs().max(1e3), "{name}: {apart:e} of {expected}");
                }
            }
        }
    }

    #[test]
    fn mistakes_are_told_as_by_the_solver_of_matrices() {
        let model = Model::new(Robot::builtin("cogiro").unwrap(), Composition::STANDARD).unwrap();
        let mut state = State::at_home(&model);
        let pose = state.pose();
        let limits = Limits::uniform(8, 0.0, 5000.0).unwrap();
        let load = Load::constant(Wrench::repeat(f64::NAN));
        let refused = model.closed_form_tensions(&pose, &load, &limits, &mut state).unwrap_err();
        assert_eq!(refused, DistributionError::Tension(InputError::NotFinite { what: "wrench" }));
        let few = Limits::uniform(7, 0.0, 5000.0).unwrap();
        let refused =
            model.closed_form_tensions(&pose, &Load::constant(Wrench::zeros()), &few, &mut state).unwrap_err();
        assert_eq!(refused, DistributionError::Tension(InputError::LimitCount { expected: 8, found: 7 }));
    }
}
