//! Tensions within limits at many poses: structure matrices side by side in lanes, then each pose's own programme.
//!
//! Every pose has the bits of the single one: the solvers forget the pose before.

use nalgebra::DMatrix;

use super::{Reason, Solver};
use crate::geometry::{Pose, PoseBatch};
use crate::model::Model;
use crate::scalar::{LANES, LaneTable, Line, over_parts};
use crate::statics::Load;
use crate::tension::{InputError, Limits, Method, Options, Status};

/// Poses whose structure matrices are kept at once: few enough to stay in the cache.
const CHUNK: usize = 64;

/// Tensions at many poses, each with its status.
#[must_use = "check `status` before using tensions"]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Distributions {
    /// A row per cable, then the code of the status.
    table: LaneTable,
}

impl Distributions {
    /// Number of poses.
    pub fn len(&self) -> usize {
        self.table.len()
    }

    /// True without poses.
    pub fn is_empty(&self) -> bool {
        self.table.is_empty()
    }

    /// Whether the tensions of one pose (from 0) balance the load within the limits; panics if there is no such pose, as all of these do.
    ///
    /// [`Status::Undecided`] where a cable has no path, with tensions that are NaN.
    pub fn status(&self, item: usize) -> Status {
        status(self.table.get(self.table.rows() - 1, item))
    }

    /// Tension of one cable (0-based; N). Unless the status is [`Status::Feasible`] it is what the method falls back to.
    pub fn tension(&self, cable: usize, item: usize) -> f64 {
        assert!(cable + 1 < self.table.rows(), "cable {cable} of {}", self.table.rows() - 1);
        self.table.get(cable, item)
    }
}

fn code(status: Status) -> f64 {
    match status {
        Status::Feasible => 0.0,
        Status::Infeasible => 1.0,
        Status::NotFound => 2.0,
        Status::Undecided => 3.0,
    }
}

fn status(code: f64) -> Status {
    match code {
        0.0 => Status::Feasible,
        1.0 => Status::Infeasible,
        2.0 => Status::NotFound,
        _ => Status::Undecided,
    }
}

/// Tensions that balance the load within the limits at each pose, chosen by a method: [`super::solve`] for each with its bits, and
/// several times faster for straight cables.
///
/// Claims no memory in the loop of straight cables once `distributions` has had as many poses before.
///
/// ```
/// use cdpr::equilibrium::distribution;
/// use cdpr::geometry::PoseBatch;
/// use cdpr::tension::{Limits, Method, Status};
/// use cdpr::{Load, Model, Robot};
///
/// let robot = Robot::builtin("cogiro").ok_or("unknown robot")?;
/// let home = robot.home.ok_or("no home pose")?;
/// let (load, limits) = (Load::of(&robot)?, Limits::uniform(8, 0.0, 5000.0)?);
/// let model = Model::new(robot, "standard".parse()?)?;
/// let poses: PoseBatch = [home; 3].iter().collect();
/// let mut found = distribution::Distributions::default();
/// distribution::solve_batch(&model, &load, &limits, Method::Qp, &poses, &mut found)?;
/// assert_eq!(found.status(2), Status::Feasible);
/// assert_eq!(found.tension(7, 2), distribution::solve(&model, &home, &load, &limits)?.tensions[7]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve_batch(
    model: &Model,
    load: &Load,
    limits: &Limits,
    method: Method,
    poses: &PoseBatch,
    distributions: &mut Distributions,
) -> Result<(), InputError> {
    let cables = model.cable_count();
    if limits.cable_count() != cables {
        return Err(InputError::LimitCount { expected: cables, found: limits.cable_count() });
    }
    let table = &mut distributions.table;
    table.reshape(cables + 1, poses.len());
    let mut work = Work {
        solver: Solver::by(method, model, load, limits),
        part: PoseBatch::default(),
        matrices: LaneTable::default(),
        matrix: DMatrix::zeros(model.dof(), cables),
    };
    over_parts(table.lines_mut(), cables + 1, &mut work, |work, first, lines| {
        let end = poses.len().min(first + lines.len() / (cables + 1) * LANES);
        work.solve_part(poses, first, end, lines);
    });
    Ok(())
}

/// Memory of one thread.
#[derive(Clone)]
struct Work {
    solver: Solver,
    part: PoseBatch,
    matrices: LaneTable,
    matrix: DMatrix<f64>,
}

impl Work {
    /// The poses from `first` to before `end`, whose lines these are.
    fn solve_part(&mut self, poses: &PoseBatch, first: usize, end: usize, lines: &mut [Line]) {
        let rows = self.solver.model.cable_count() + 1;
        for (start, lines) in (first..end).step_by(CHUNK).zip(lines.chunks_mut(CHUNK / LANES * rows)) {
            let count = CHUNK.min(end - start);
            let is_straight = self.solver.model.cables().has_fixed_directions();
            if is_straight {
                self.part.fill_from(poses, start, count);
                self.solver.model.batch_structure_matrices(&self.part, &mut self.matrices);
            }
            for item in 0..count {
                let mut column = |row: usize, number: f64| lines[item / LANES * rows + row].0[item % LANES] = number;
                let pose = poses.get(start + item);
                match is_straight {
                    true => self.straight(item, &pose, &mut column),
                    false => self.sagging(&pose, &mut column),
                }
            }
        }
    }

    fn straight(&mut self, item: usize, pose: &Pose, write: &mut dyn FnMut(usize, f64)) {
        let Self { solver: Solver { model, load, limits, chooser }, matrices, matrix, .. } = self;
        for (row, entry) in matrix.iter_mut().enumerate() {
            *entry = matrices.get(row, item);
        }
        let wrench = load.wrench(pose);
        let mut components = [0.0; 6];
        for (component, twist) in components.iter_mut().zip(model.twist_basis()) {
            *component = twist.dot(&wrench);
        }
        chooser.forget();
        match chooser.solve(matrix, &components[..model.dof()], limits, &Options::default()) {
            Ok(answer) => {
                answer.tensions.iter().enumerate().for_each(|(cable, &tension)| write(cable, tension));
                write(answer.tensions.len(), code(answer.status));
            }
            // a cable has no path: its column is NaN
            Err(_) => self.undecided(write),
        }
    }

    fn sagging(&mut self, pose: &Pose, write: &mut dyn FnMut(usize, f64)) {
        let Ok(found) = self.solver.solve(pose) else { return self.undecided(write) };
        found.tensions.iter().enumerate().for_each(|(cable, &tension)| write(cable, tension));
        let status = match found.reason {
            None => Status::Feasible,
            Some(Reason::Infeasible(_)) => Status::Infeasible,
            Some(Reason::NotConverged(_)) => Status::NotFound,
        };
        write(found.tensions.len(), code(status));
    }

    fn undecided(&self, write: &mut dyn FnMut(usize, f64)) {
        let cables = self.solver.model.cable_count();
        (0..cables).for_each(|cable| write(cable, f64::NAN));
        write(cables, code(Status::Undecided));
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::equilibrium::distribution;
    use crate::geometry::Wrench;
    use crate::model::Composition;
    use crate::robot::{Robot, builtin};

    fn poses(model: &Model, count: u16) -> Vec<Pose> {
        let home = model.robot().home_or_middle();
        let pose = |k: u16| {
            let t = f64::from(k);
            let shift = Vector3::new(0.9 * t.sin(), 0.7 * t.cos(), 0.3 * (2.0 * t).sin());
            let along = |k: usize| model.axes().get(k).map_or(Vector3::zeros(), |axis| axis * shift[k]);
            Pose { position: home.position + along(0) + along(1) + along(2), ..home }
        };
        (0..count).map(pose).collect()
    }

    #[test]
    fn every_method_gives_the_bits_of_the_single_pose() {
        let load = Load::constant(Wrench::new(10.0, -20.0, -500.0, 5.0, 20.0, -3.0));
        let methods = [Method::Qp, Method::ClosedForm, Method::Minimum, Method::Dykstra, Method::NearestWrench];
        let mut statuses = std::collections::BTreeSet::new();
        for name in builtin::names() {
            let model = Model::new(Robot::builtin(name).unwrap(), Composition::STANDARD).unwrap();
            let limits = Limits::uniform(model.cable_count(), 50.0, 700.0).unwrap();
            let poses = poses(&model, 75);
            let mut found = Distributions::default();
            for method in methods {
                solve_batch(&model, &load, &limits, method, &poses.iter().collect(), &mut found).unwrap();
                let mut single = Solver::by(method, &model, &load, &limits);
                assert_eq!(found.len(), poses.len());
                for (item, pose) in poses.iter().enumerate() {
                    let Ok(expected) = single.solve(pose) else {
                        assert_eq!(found.status(item), Status::Undecided);
                        continue;
                    };
                    statuses.insert(code(found.status(item)) as u8);
                    assert_eq!(expected.reason.is_none(), found.status(item) == Status::Feasible, "{name}, {method}");
                    for (cable, tension) in expected.tensions.iter().enumerate() {
                        assert_eq!(tension.to_bits(), found.tension(cable, item).to_bits(), "{name}, {method}, {item}");
                    }
                }
            }
        }
        assert!(statuses.contains(&0) && statuses.contains(&1), "both verdicts are met: {statuses:?}");
    }

    #[test]
    fn sagging_cables_are_answered_one_by_one() {
        let mut robot = Robot::builtin("cogiro").unwrap();
        robot.cables.iter_mut().for_each(|cable| cable.linear_density = Some(0.1));
        let load = Load::of(&robot).unwrap();
        let limits = Limits::uniform(8, 50.0, 5000.0).unwrap();
        let model = Model::new(robot, "catenary".parse().unwrap()).unwrap();
        let poses = poses(&model, 3);
        let mut found = Distributions::default();
        solve_batch(&model, &load, &limits, Method::Qp, &poses.iter().collect(), &mut found).unwrap();
        for (item, pose) in poses.iter().enumerate() {
            let expected = distribution::solve(&model, pose, &load, &limits).unwrap();
            assert_eq!(expected.reason.is_none(), found.status(item) == Status::Feasible);
            assert_eq!(expected.tensions[5], found.tension(5, item));
        }
    }
}
