//! Tensions within the limits with the wrench nearest to the required one.
//!
//! min ‖S (Aᵀ f + w)‖ with f_min ≤ f ≤ f_max, where S divides moments by a length (see [`super::Options::lengths`]):
//! least squares with bounded unknowns (Stark and Parker 1995). Cables start at their limits; the one whose release
//! shrinks the residual fastest is freed, the free ones are solved for by orthogonal columns, and those that run into a
//! limit stay there, until no release shrinks the residual. The wrench is unique and follows the load continuously; of
//! the tensions that give it, the quadratic programme takes those nearest to the reference. If the load can be
//! balanced, the answer is the optimum of that programme.
//!
//! **Stop rule:** no release gains more than rounding, 1e-10 of the largest terms. **Continuity:** the wrench is
//! continuous (a projection on a convex set), and so are the tensions while the rank stays. **Warm start:** none for
//! the least squares.

use nalgebra::DMatrix;

use super::affine::{add_scaled, dot};
use super::distribute::{Chosen, Distribute, FoundTensions, ON_LIMIT, Problem, Status, Task, Written};
use super::{InputError, Limits, nearest, quadratic};

/// Releases allowed, per cable.
const MAX_RELEASES: usize = 30;

/// Position of a cable's tension within its limits.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Place {
    Least,
    Largest,
    Free,
}

/// Memory for one problem.
#[derive(Clone, Debug)]
pub(super) struct NearestWrench {
    dof: usize,
    /// S Aᵀ by columns, and the residual S (Aᵀ f + w).
    matrix: DMatrix<f64>,
    residual: Vec<f64>,
    places: Vec<Place>,
    /// Free cables, in the order of their orthogonal columns Q, and R by columns of n entries.
    free: Vec<usize>,
    orthogonal: Vec<f64>,
    triangle: Vec<f64>,
    step: Vec<f64>,
    /// The wrench that the tensions balance (N, N·m).
    wrench: Vec<f64>,
    /// Cables that are not released because only rounding would gain.
    barred: Vec<bool>,
}

impl NearestWrench {
    pub(super) fn new(cable_count: usize, dof: usize) -> Self {
        Self {
            dof,
            matrix: DMatrix::zeros(dof, cable_count),
            residual: vec![0.0; dof],
            places: vec![Place::Least; cable_count],
            free: Vec::with_capacity(dof),
            orthogonal: vec![0.0; dof * dof],
            triangle: vec![0.0; dof * dof],
            step: vec![0.0; dof],
            wrench: vec![0.0; dof],
            barred: vec![false; cable_count],
        }
    }

    /// Writes the tensions; returns the number of releases.
    fn run(
        &mut self,
        problem: &Problem<'_>,
        lengths: Option<&[f64]>,
        limits: &Limits,
        reference: &[f64],
        tensions: &mut [f64],
    ) -> u32 {
        let scale = |row: usize| lengths.map_or(1.0, |lengths| 1.0 / lengths[row]);
        let mut size = 0.0_f64;
        for cable in 0..tensions.len() {
            for row in 0..self.dof {
                self.matrix[(row, cable)] = scale(row) * problem.structure_matrix[(row, cable)];
            }
            let (least, largest) = (limits.minimum()[cable], limits.maximum()[cable]);
            let is_low = reference[cable] - least <= largest - reference[cable];
            self.places[cable] = if is_low { Place::Least } else { Place::Largest };
            tensions[cable] = if is_low { least } else { largest };
            size = size.max(least.abs().max(largest.abs()) * self.matrix.column(cable).amax());
        }
        for row in 0..self.dof {
            size = size.max((scale(row) * problem.wrench[row]).abs());
        }
        self.free.clear();
        self.barred.fill(false);
        let mut releases = 0;
        while releases < MAX_RELEASES * tensions.len() {
            self.write_rest(problem.wrench, &scale, tensions);
            let Some(cable) = self.most_gaining(size) else { break };
            releases += 1;
            if self.release(cable) {
                self.settle(problem.wrench, &scale, limits, tensions);
            } else {
                self.barred[cable] = true;
            }
        }
        releases as u32
    }

    fn write_rest(&mut self, wrench: &[f64], scale: &impl Fn(usize) -> f64, tensions: &[f64]) {
        self.residual.iter_mut().zip(wrench).enumerate().for_each(|(row, (residual, w))| *residual = scale(row) * w);
        for (column, f) in self.matrix.as_slice().chunks_exact(self.dof).zip(tensions) {
            add_scaled(&mut self.residual, *f, column);
        }
    }

    /// The cable at a limit whose release shrinks the residual fastest, per newton of its pull.
    fn most_gaining(&self, size: f64) -> Option<usize> {
        let (mut best, mut found) = (1e-10 * size, None);
        for (cable, column) in self.matrix.as_slice().chunks_exact(self.dof).enumerate() {
            let gain = match self.places[cable] {
                Place::Free => continue,
                Place::Least => -dot(column, &self.residual),
                Place::Largest => dot(column, &self.residual),
            } / dot(column, column).sqrt();
            if gain > best && !self.barred[cable] {
                (best, found) = (gain, Some(cable));
            }
        }
        found
    }

    /// Frees a cable; false if its pull depends on those of the free ones.
    fn release(&mut self, cable: usize) -> bool {
        let (dof, count) = (self.dof, self.free.len());
        if count == dof || !self.orthogonalize(cable, count) {
            return false;
        }
        self.free.push(cable);
        self.places[cable] = Place::Free;
        true
    }

    /// Writes column `count` of Q and R, by two passes of Gram and Schmidt.
    fn orthogonalize(&mut self, cable: usize, count: usize) -> bool {
        let dof = self.dof;
        let (done, residual) = self.orthogonal.split_at_mut(count * dof);
        let column = &mut residual[..dof];
        column.copy_from_slice(&self.matrix.as_slice()[cable * dof..][..dof]);
        let whole = dot(column, column).sqrt();
        let entries = &mut self.triangle[count * dof..][..dof];
        entries.fill(0.0);
        for _ in 0..2 {
            for (earlier, entry) in done.chunks_exact(dof).zip(entries.iter_mut()) {
                let along = dot(earlier, column);
                *entry += along;
                add_scaled(column, -along, earlier);
            }
        }
        let length = dot(column, column).sqrt();
        if !(length > 1e-9 * whole) {
            return false;
        }
        entries[count] = length;
        column.iter_mut().for_each(|entry| *entry /= length);
        true
    }

    /// Solves for the free cables and moves towards the solution; cables that run into a limit stay there, until none
    /// does.
    fn settle(&mut self, wrench: &[f64], scale: &impl Fn(usize) -> f64, limits: &Limits, tensions: &mut [f64]) {
        while !self.free.is_empty() {
            self.write_step();
            let (mut part, mut blocking) = (1.0, None);
            for (place, &cable) in self.free.iter().enumerate() {
                let (f, step) = (tensions[cable], self.step[place]);
                let limit = if step < 0.0 { limits.minimum()[cable] } else { limits.maximum()[cable] };
                // fraction of the step up to the limit, zero for a cable that stands on it
                let way = (limit - f) / step;
                if step != 0.0 && way < part {
                    (part, blocking) = (way.max(0.0), Some(place));
                }
            }
            for (place, &cable) in self.free.iter().enumerate() {
                tensions[cable] += part * self.step[place];
            }
            let Some(place) = blocking else {
                self.barred.fill(false);
                return;
            };
            let cable = self.free.remove(place);
            let is_low = self.step[place] < 0.0;
            self.places[cable] = if is_low { Place::Least } else { Place::Largest };
            tensions[cable] = if is_low { limits.minimum()[cable] } else { limits.maximum()[cable] };
            // a cable that returns at once to its limit would be released for ever
            self.barred[cable] = part == 0.0;
            self.write_rest(wrench, scale, tensions);
            for place in place..self.free.len() {
                self.orthogonalize(self.free[place], place);
            }
        }
    }

    /// Writes the change of the free tensions with the least residual: R step = −Qᵀ residual.
    fn write_step(&mut self) {
        let (dof, count) = (self.dof, self.free.len());
        for place in (0..count).rev() {
            let mut sum = -dot(&self.orthogonal[place * dof..][..dof], &self.residual);
            for later in place + 1..count {
                sum -= self.triangle[later * dof + place] * self.step[later];
            }
            self.step[place] = sum / self.triangle[place * dof + place];
        }
    }
}

impl NearestWrench {
    /// Replaces the tensions by those nearest to the reference that give the same wrench.
    fn take_nearest_to_reference(
        &mut self,
        task: &Task<'_>,
        limits: &Limits,
        qp: &mut quadratic::Solver,
        tensions: &mut [f64],
    ) -> Result<(), InputError> {
        let matrix = task.problem.structure_matrix;
        let wrench = &mut self.wrench;
        wrench.fill(0.0);
        for (column, f) in matrix.column_iter().zip(tensions.iter()) {
            wrench.iter_mut().zip(&column).for_each(|(residual, entry)| *residual -= entry * f);
        }
        let found = qp.solve(matrix, wrench, limits, Some(task.reference))?;
        if found.status == quadratic::Status::Feasible {
            tensions.copy_from_slice(&found.tensions);
        }
        Ok(())
    }
}

impl Distribute for NearestWrench {
    fn refine(
        &mut self,
        task: &Task<'_>,
        qp: &mut quadratic::Solver,
        found: &mut FoundTensions<'_>,
    ) -> Result<(), InputError> {
        if *found.status == Status::Infeasible {
            let FoundTensions { limits, tensions, iterations, .. } = found;
            **iterations = self.run(&task.problem, task.options.lengths, limits, task.reference, tensions);
            self.take_nearest_to_reference(task, limits, qp, tensions)?;
        }
        Ok(())
    }

    /// Derivative of balanced tensions.
    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        nearest::derivative(chosen, ON_LIMIT)
    }
}
