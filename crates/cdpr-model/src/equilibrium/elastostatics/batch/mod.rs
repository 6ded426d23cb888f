//! The elastostatic forward problem at many poses at once, a pose per lane.
//!
//! Eight descents run side by side as long as undamped Newton steps at least halve the residual wrench and no cable
//! ends slack. A pose that needs more is solved by the single [`Solver`] from its beginning, and so are robots with
//! more than eight cables, with fewer than six degrees of freedom, or with cables that are rigid, sag or do not stretch
//! linearly. Both give the same bits.

mod descent;
#[cfg(test)]
mod tests;

use descent::{Descents, Ending};

use super::{InputError, LoadParts, Solver, Status};
pub use crate::equilibrium::Solutions;
use crate::equilibrium::forward_kinematics::batch::check;
use crate::equilibrium::{ITERATIONS, RMS, STATUS, TENSIONS};
use crate::geometry::PoseBatch;
use crate::scalar::{LANES, LaneTable, Line, Unit, over_parts};

impl Solver<'_> {
    /// Finds many poses, each with the same bits as [`Solver::solve`], from controlled lengths (a row per cable, m) and
    /// guesses, all under the solver's load.
    ///
    /// Claims no memory if `solutions` has held as many problems before, except on further threads and for reasons. The
    /// first problem with invalid numbers is an error.
    pub fn solve_batch(
        &mut self,
        controlled_lengths: &LaneTable,
        guesses: &PoseBatch,
        solutions: &mut Solutions,
    ) -> Result<(), InputError> {
        self.solve_lanes(controlled_lengths, guesses, solutions, false)
    }

    /// [`Solver::solve_batch`] for equilibria in which every cable pulls.
    ///
    /// If a cable pushes in the equilibrium of bars, the search ends with [`Status::NotConverged`] instead of looking
    /// for the slack cables, which takes ten times as long.
    pub(crate) fn solve_taut_batch(
        &mut self,
        controlled_lengths: &LaneTable,
        guesses: &PoseBatch,
        solutions: &mut Solutions,
    ) -> Result<(), InputError> {
        self.solve_lanes(controlled_lengths, guesses, solutions, true)
    }

    fn solve_lanes(
        &mut self,
        controlled_lengths: &LaneTable,
        guesses: &PoseBatch,
        solutions: &mut Solutions,
        only_taut: bool,
    ) -> Result<(), InputError> {
        check(self.model, controlled_lengths, guesses)?;
        self.only_taut = only_taut;
        let rows = TENSIONS + self.model.cable_count();
        solutions.table.reshape(rows, guesses.len());
        over_parts(solutions.table.lines_mut(), rows, self, |solver, first, lines| {
            for (group, solutions) in (first / LANES..).zip(lines.chunks_exact_mut(rows)) {
                solver.solve_group((controlled_lengths, guesses), group, solutions);
            }
        });
        self.only_taut = false;
        Ok(())
    }

    fn solve_group(&mut self, (lengths, guesses): (&LaneTable, &PoseBatch), group: usize, solutions: &mut [Line]) {
        let count = LANES.min(guesses.len() - group * LANES);
        let model = self.model;
        let is_plain = self.scratch.composed.is_none() && !self.scratch.is_rigid.contains(&true);
        let mut endings = [Ending::Open; LANES];
        if is_plain && model.dof() == 6 && (6..=LANES).contains(&model.cable_count()) {
            let descents = Descents {
                model,
                settings: &self.settings,
                load: LoadParts::of(&self.load),
                platform_radius: self.platform_radius,
                lengths: lengths.group(group),
                guesses: guesses.table().group(group),
                solutions,
            };
            endings = descents.run_on(Unit::widest());
        }
        for (lane, ending) in endings.into_iter().enumerate().take(count) {
            match ending {
                Ending::Solved => {}
                Ending::Pushes if self.only_taut => solutions[STATUS].0[lane] = Status::NotConverged.code(),
                _ => self.solve_one(lengths, guesses, group * LANES + lane, solutions),
            }
        }
    }

    /// Solves one problem with the single solver.
    #[cold]
    fn solve_one(&mut self, lengths: &LaneTable, guesses: &PoseBatch, item: usize, solutions: &mut [Line]) {
        let mut numbers = std::mem::take(&mut self.scratch.lengths);
        lengths.read(item, &mut numbers);
        let found = self.solve(&numbers, &guesses.get(item)).map(|solution| solution.status);
        self.scratch.lengths = numbers;
        let (lane, solution) = (item % LANES, &self.scratch.solution);
        for (row, number) in solution.pose.numbers().into_iter().enumerate() {
            solutions[row].0[lane] = number;
        }
        for (cable, tension) in solution.tensions.iter().enumerate() {
            solutions[TENSIONS + cable].0[lane] = *tension;
        }
        solutions[RMS].0[lane] = 0.0;
        solutions[ITERATIONS].0[lane] = f64::from(solution.iterations);
        solutions[STATUS].0[lane] = found.unwrap_or(Status::NotConverged).code();
    }
}
