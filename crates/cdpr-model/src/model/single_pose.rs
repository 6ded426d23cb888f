//! Lengths and structure matrix at one pose, a cable per lane, written to memory of the caller.
//!
//! The bits are those of [`Model::path`] cable by cable. If a cable may have no path, that function is called for the
//! error.

use cdpr_core::structure::{Lengths, StructureColumns};
use nalgebra::DMatrix;

use super::Model;
use crate::cable::GeometryError;
use crate::geometry::Pose;
use crate::scalar::dispatch_narrow;

impl Model {
    /// Geometric cable lengths q at a pose (m).
    pub fn cable_lengths(&self, pose: &Pose) -> Result<Vec<f64>, GeometryError> {
        let mut lengths = vec![0.0; self.cable_count()];
        self.write_cable_lengths(pose, &mut lengths)?;
        Ok(lengths)
    }

    /// Writes [`Model::cable_lengths`] to the first m numbers of `lengths`; panics if it has fewer. Claims no memory.
    pub fn write_cable_lengths(&self, pose: &Pose, lengths: &mut [f64]) -> Result<(), GeometryError> {
        let lengths = &mut lengths[..self.cable_count()];
        let (position, rotation) = (pose.position.into(), pose.rotation_rows());
        if dispatch_narrow(Lengths { groups: self.groups(), position, rotation: &rotation, lengths }) {
            return Ok(());
        }
        for (cable, length) in lengths.iter_mut().enumerate() {
            *length = self.checked_path(cable, position, &rotation)?.0.length;
        }
        Ok(())
    }

    /// Structure matrix Aᵀ in the robot's degrees of freedom, n × m: columns \[uᵢ; bᵢ × uᵢ\] in the twist basis.
    ///
    /// Aᵀ f + w = 0 and δq = −A δx (see the book, “Models”).
    pub fn structure_matrix(&self, pose: &Pose) -> Result<DMatrix<f64>, GeometryError> {
        let mut matrix = DMatrix::zeros(self.dof(), self.cable_count());
        self.write_structure_matrix(pose, &mut matrix)?;
        Ok(matrix)
    }

    /// Writes [`Model::structure_matrix`] to `matrix`; claims no memory if that is n × m already.
    pub fn write_structure_matrix(&self, pose: &Pose, matrix: &mut DMatrix<f64>) -> Result<(), GeometryError> {
        let size = (self.dof(), self.cable_count());
        if matrix.shape() != size {
            *matrix = DMatrix::zeros(size.0, size.1);
        }
        let (position, rotation) = (pose.position.into(), pose.rotation_rows());
        let basis = self.twist_basis();
        let columns = matrix.as_mut_slice();
        if dispatch_narrow(StructureColumns { groups: self.groups(), basis, position, rotation: &rotation, columns }) {
            return Ok(());
        }
        for cable in 0..self.cable_count() {
            let column = self.checked_structure_column(cable, position, &rotation)?;
            for (row, basis) in self.twist_basis().iter().enumerate() {
                matrix[(row, cable)] = basis.dot(&column);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::geometry::Twist;
    use crate::model::{Composition, place_pulleys};
    use crate::robot::{Robot, builtin};
    use crate::scalar::{Unit, dispatch_on};

    /// Every built-in robot with point outlets, and with pulleys if its anchors have room for them.
    fn models() -> Vec<Model> {
        let all = builtin::names().flat_map(|name| {
            let robot = Robot::builtin(name).unwrap();
            let axis = if robot.motion_pattern.is_planar() { robot.plane.embed([0.0, 1.0]) } else { Vector3::z() };
            let pulleys = vec![(0.05, axis); robot.cable_count()];
            let placed = place_pulleys(&robot, &pulleys, &robot.home_or_middle()).ok();
            let with_pulleys = placed.and_then(|robot| Model::new(robot, Composition::PULLEY).ok());
            Model::new(robot, Composition::STANDARD).ok().into_iter().chain(with_pulleys)
        });
        all.collect()
    }

    /// On every unit, column by column and cable by cable.
    #[test]
    fn a_single_pose_has_the_bits_of_its_paths() {
        let (mut compared, mut with_pulleys) = (0, 0);
        for model in models() {
            let home = model.robot().home_or_middle();
            for k in 0..16 {
                let step = 0.1 * (f64::from(k) - 8.0);
                let twist = model.twist_basis().iter().enumerate();
                let twist = twist.fold(Twist::zeros(), |sum, (row, basis)| sum + basis * (step * (row as f64).cos()));
                let pose = home.displaced(&twist);
                let paths: Result<Vec<_>, _> = (0..model.cable_count()).map(|cable| model.path(cable, &pose)).collect();
                let (lengths, matrix) = (model.cable_lengths(&pose), model.structure_matrix(&pose));
                let paths = match paths {
                    Ok(paths) => paths,
                    Err(reason) => {
                        assert_eq!((lengths, matrix), (Err(reason), Err(reason)), "{}", model.robot().name);
                        continue;
                    }
                };
                let (lengths, matrix) = (lengths.unwrap(), matrix.unwrap());
                for (cable, (path, _)) in paths.iter().enumerate() {
                    assert_eq!(lengths[cable].to_bits(), path.length.to_bits(), "{}", model.robot().name);
                    let column = model.structure_column(cable, &pose).unwrap();
                    for (row, basis) in model.twist_basis().iter().enumerate() {
                        let expected = basis.dot(&column);
                        assert_eq!(matrix[(row, cable)], expected, "{} ({row}, {cable})", model.robot().name);
                    }
                }
                let (position, rotation) = (pose.position.into(), pose.rotation_rows());
                for unit in Unit::available() {
                    let (mut other, basis) = (matrix.clone(), model.twist_basis());
                    let columns = other.as_mut_slice();
                    let kernel =
                        StructureColumns { groups: model.groups(), basis, position, rotation: &rotation, columns };
                    let _ = dispatch_on(unit, kernel);
                    assert_eq!(other, matrix, "{} on {unit:?}", model.robot().name);
                }
                compared += 1;
                with_pulleys += usize::from(model.composition().pulley);
            }
        }
        assert!(compared > 300 && with_pulleys > 100, "{compared} poses, {with_pulleys} over pulleys");
    }

    #[test]
    fn a_cable_without_a_course_is_named() {
        let model = Model::new(Robot::builtin("planar-example").unwrap(), Composition::STANDARD).unwrap();
        let cable = &model.robot().cables[2];
        let onto = Pose { position: cable.frame_anchor - cable.platform_anchor, ..Pose::identity() };
        let expected = GeometryError::ZeroLength { cable: 3 };
        assert_eq!(model.cable_lengths(&onto), Err(expected));
        assert_eq!(model.structure_matrix(&onto), Err(expected));
    }
}
