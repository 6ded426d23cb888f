//! Forward kinematics at many poses at once, a pose per lane.
//!
//! Eight descents run side by side as long as they are plain Gauss–Newton iterations that shrink quickly, as they
//! nearly always are for measured lengths and guesses from the last pose. A pose that needs more (damping, second
//! derivatives, other starts) is solved by the single [`Solver`] from its beginning, and so are robots with more than
//! eight cables or with fewer degrees of freedom than six. Both give the same bits.

mod descent;
#[cfg(test)]
mod tests;

use descent::Descents;

use super::{InputError, Solver, Status};
pub use crate::equilibrium::Solutions;
use crate::equilibrium::{ITERATIONS, RMS, STATUS, TENSIONS};
use crate::geometry::PoseBatch;
use crate::model::Model;
use crate::scalar::{LANES, LaneTable, Line, Unit, over_parts};

impl Solver<'_> {
    /// Finds many poses, each with the same bits as [`Solver::solve`], from controlled lengths (a row per cable, m) and
    /// guesses.
    ///
    /// Claims no memory if `solutions` has held as many problems before, except on further threads and for reasons. The
    /// first problem with invalid numbers is an error.
    pub fn solve_batch(
        &mut self,
        lengths: &LaneTable,
        guesses: &PoseBatch,
        solutions: &mut Solutions,
    ) -> Result<(), InputError> {
        check(self.model, lengths, guesses)?;
        solutions.table.reshape(TENSIONS, guesses.len());
        over_parts(solutions.table.lines_mut(), TENSIONS, self, |solver, first, lines| {
            for (group, solutions) in (first / LANES..).zip(lines.chunks_exact_mut(TENSIONS)) {
                solver.solve_group(lengths, guesses, group, solutions);
            }
        });
        Ok(())
    }

    fn solve_group(&mut self, lengths: &LaneTable, guesses: &PoseBatch, group: usize, solutions: &mut [Line]) {
        let count = LANES.min(guesses.len() - group * LANES);
        let fits = self.model.dof() == 6 && (6..=LANES).contains(&self.model.cable_count());
        let mut is_done = [false; LANES];
        if fits {
            let descents = Descents {
                model: self.model,
                settings: &self.settings,
                platform_radius: self.platform_radius,
                lengths: lengths.group(group),
                guesses: guesses.table().group(group),
                solutions,
            };
            is_done = descents.run_on(Unit::widest());
        }
        for lane in (0..count).filter(|&lane| !is_done[lane]) {
            self.solve_one(lengths, guesses, group * LANES + lane, solutions);
        }
    }

    /// Solves one problem with the single solver.
    #[cold]
    fn solve_one(&mut self, lengths: &LaneTable, guesses: &PoseBatch, item: usize, solutions: &mut [Line]) {
        let mut numbers = std::mem::take(&mut self.scratch.lengths);
        lengths.read(item, &mut numbers);
        // numbers were checked before
        let found = self.solve(&numbers, &guesses.get(item)).is_ok();
        self.scratch.lengths = numbers;
        let lane = item % LANES;
        let solution = &self.scratch.solution;
        for (row, number) in solution.pose.numbers().into_iter().enumerate() {
            solutions[row].0[lane] = number;
        }
        solutions[RMS].0[lane] = solution.residual_rms;
        solutions[ITERATIONS].0[lane] = f64::from(solution.iterations);
        solutions[STATUS].0[lane] = if found { solution.status } else { Status::NotConverged }.code();
    }
}

/// Refuses the input that [`super::check_input`] refuses, at the first problem that has it.
pub(in crate::equilibrium) fn check(model: &Model, lengths: &LaneTable, guesses: &PoseBatch) -> Result<(), InputError> {
    let (expected, found) = (model.cable_count(), lengths.rows());
    if expected != found && !guesses.is_empty() {
        return Err(InputError::LengthCount { expected, found });
    }
    if lengths.len() != guesses.len() {
        return Err(InputError::GuessCount { expected: lengths.len(), found: guesses.len() });
    }
    for group in 0..lengths.groups() {
        let is_good = |line: &Line| line.0.iter().all(|&length| length > 0.0 && length < f64::INFINITY);
        let is_finite = |line: &Line| line.0.iter().all(|number| number.is_finite());
        if lengths.group(group).iter().all(is_good) && guesses.table().group(group).iter().all(is_finite) {
            continue;
        }
        // problems that pad the last group are not checked
        for item in group * LANES..lengths.len().min((group + 1) * LANES) {
            for cable in 0..expected {
                let length = lengths.get(cable, item);
                if !(length > 0.0 && length.is_finite()) {
                    return Err(InputError::Length { cable: cable + 1, length });
                }
            }
            if !guesses.get(item).is_finite() {
                return Err(InputError::Guess);
            }
        }
    }
    Ok(())
}
