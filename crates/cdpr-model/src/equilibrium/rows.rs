//! Answers at many poses for callers that hold arrays: rows in, rows out, put side by side in lanes on the way.
//!
//! A part of the rows that stays in the cache is transposed, computed and transposed back, then the next one. Every number has the
//! bits that the single pose gives; quaternions are normalised first.

#[cfg(test)]
mod tests;

use std::sync::atomic::{AtomicBool, Ordering};

use thiserror::Error;

use super::distribution::{self, Distributions};
use super::{ForwardBatch, ForwardError, ForwardSettings, Solutions, State, Status};
use crate::geometry::{POSE_ROWS, PoseBatch, PoseRowError, PoseRows};
use crate::model::Model;
use crate::scalar::{LANES, LaneTable, chunk_for_threads, over_parts};
use crate::statics::Load;
use crate::tension::{self, InputError, Limits, Method};

/// Poses that are transposed, computed and transposed back at a time (14 to 90 kB).
const CHUNK: usize = 512;

/// Arrays that cannot be answered.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RowsError {
    /// A row that is no pose.
    #[error(transparent)]
    Pose(#[from] PoseRowError),
    /// An array of another size than the poses and the robot ask for.
    #[error("expected {expected} {what}, found {found}")]
    Count {
        /// Entries of the array, in words.
        what: &'static str,
        /// Entries asked for.
        expected: usize,
        /// Entries given.
        found: usize,
    },
    /// A forward problem that cannot be posed.
    #[error(transparent)]
    Forward(#[from] ForwardError),
    /// Limits that do not fit the model.
    #[error(transparent)]
    Tension(#[from] InputError),
}

/// Forward problems of an array: N rows of m controlled lengths, each with its guess.
#[derive(Clone, Copy, Debug)]
pub struct ForwardRows<'a> {
    /// Controlled lengths, m for each problem (m).
    pub lengths: &'a [f64],
    /// A guess for each problem, or one for all.
    pub guesses: PoseRows<'a>,
    /// The load on the platform; `None`: that of the robot's file.
    pub load: Option<&'a Load>,
}

/// Room for the answers of [`Model::forward_of_rows`].
#[derive(Debug)]
pub struct ForwardAnswers<'a> {
    /// Poses: x, y, z (m), qx, qy, qz, qw.
    pub poses: &'a mut [[f64; POSE_ROWS]],
    /// How each search ended.
    pub statuses: &'a mut [Status],
    /// Root mean square of the residuals of lengths that are fitted (m).
    pub residual_rms: Option<&'a mut [f64]>,
    /// Steps of all starts.
    pub iterations: Option<&'a mut [u32]>,
    /// Tensions, m for each problem (N); NaN if lengths alone are fitted.
    pub tensions: Option<&'a mut [f64]>,
}

fn check(what: &'static str, expected: usize, found: usize) -> Result<(), RowsError> {
    if expected == found { Ok(()) } else { Err(RowsError::Count { what, expected, found }) }
}

impl Model {
    /// Geometric cable lengths (m) at the poses of an array, m for each pose: [`Model::cable_lengths`] for each; NaN where a cable has no
    /// path. After an error `lengths` is unspecified.
    ///
    /// ```
    /// use cdpr::{Model, Robot};
    ///
    /// let robot = Robot::builtin("cablerobot-simulator-helicopter").ok_or("unknown robot")?;
    /// let home = robot.home.ok_or("no home pose")?;
    /// let model = Model::new(robot, "standard".parse()?)?;
    /// let rows = [home.numbers(); 100]; // x, y, z, qx, qy, qz, qw
    /// let mut lengths = [0.0; 800];
    /// model.lengths_of_rows(rows[..].into(), &mut lengths)?;
    /// assert_eq!(lengths[8 * 42 + 3], model.cable_lengths(&home)?[3]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lengths_of_rows(&self, poses: PoseRows<'_>, lengths: &mut [f64]) -> Result<(), RowsError> {
        let cables = self.cable_count();
        check("lengths, one per pose and cable", poses.len() * cables, lengths.len())?;
        let is_refused = AtomicBool::new(false);
        let memory = &mut (PoseBatch::default(), LaneTable::default());
        over_parts(lengths, LANES * cables, memory, |(batch, table), first, lengths| {
            for (start, lengths) in (first..).step_by(CHUNK).zip(lengths.chunks_mut(CHUNK * cables)) {
                if batch.fill_rows(poses.part(start, CHUNK)).is_err() {
                    is_refused.store(true, Ordering::Relaxed);
                    return;
                }
                self.batch_cable_lengths(batch, table);
                table.read_rows(lengths);
            }
        });
        if is_refused.into_inner() {
            poses.check()?;
        }
        Ok(())
    }

    /// Controlled lengths (m) with which the cables hold the poses of an array under tensions (N), m for each pose:
    /// [`Model::inverse`] for each, from the memories of the state; NaN where a cable has no path or no length under its tension.
    /// After an error `lengths` is unspecified.
    ///
    /// ```
    /// use cdpr::{Model, Robot, State};
    ///
    /// let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").ok_or("unknown robot")?;
    /// let home = robot.home.ok_or("no home pose")?;
    /// let model = Model::new(robot, "elastic".parse()?)?;
    /// let (rows, tensions, mut lengths) = ([home.numbers(); 9], [3000.0; 72], [0.0; 72]);
    /// let mut state = State::at_home(&model);
    /// model.inverse_of_rows(rows[..].into(), &tensions, &state, &mut lengths)?;
    /// let single = model.inverse(&home, &tensions[..8], &mut state)?.controlled_lengths()?;
    /// assert_eq!(lengths[64..], single);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn inverse_of_rows(
        &self,
        poses: PoseRows<'_>,
        tensions: &[f64],
        state: &State,
        lengths: &mut [f64],
    ) -> Result<(), RowsError> {
        let (cables, count) = (self.cable_count(), poses.len());
        check("tensions, one per pose and cable", count * cables, tensions.len())?;
        check("lengths, one per pose and cable", count * cables, lengths.len())?;
        poses.check()?;
        let memory = &mut (PoseBatch::default(), state.clone());
        over_parts(lengths, LANES * cables, memory, |(batch, state), first, lengths| {
            for (start, lengths) in (first..).step_by(CHUNK).zip(lengths.chunks_mut(CHUNK * cables)) {
                if batch.fill_rows(poses.part(start, CHUNK)).is_err() {
                    return;
                }
                for (item, lengths) in lengths.chunks_mut(cables).enumerate() {
                    let own = &tensions[(start + item) * cables..][..cables];
                    match self.inverse(&batch.get(item), own, state) {
                        Ok(found) => lengths
                            .iter_mut()
                            .zip(&found.cables)
                            .for_each(|(length, own)| *length = own.controlled_length),
                        Err(_) => lengths.fill(f64::NAN),
                    }
                }
            }
        });
        Ok(())
    }

    /// Poses, and tensions where cables and load are in equilibrium, that belong to the controlled lengths of an array:
    /// [`Model::forward_with`] for each. After an error the answers are unspecified.
    ///
    /// ```
    /// use cdpr::equilibrium::{ForwardAnswers, ForwardRows, ForwardSettings};
    /// use cdpr::{Model, Robot, State, Status};
    ///
    /// let robot = Robot::builtin("cablerobot-simulator-helicopter").ok_or("unknown robot")?;
    /// let home = robot.home.ok_or("no home pose")?;
    /// let model = Model::new(robot, "standard".parse()?)?;
    /// let lengths = model.cable_lengths(&home)?.repeat(10);
    /// let guess = [[home.position.x + 0.1, home.position.y, home.position.z, 0.0, 0.0, 0.0]];
    /// let problems = ForwardRows { lengths: &lengths, guesses: guess[..].into(), load: None };
    /// let (mut poses, mut statuses) = ([[0.0; 7]; 10], [Status::NotConverged; 10]);
    /// let answers = ForwardAnswers {
    ///     poses: &mut poses,
    ///     statuses: &mut statuses,
    ///     residual_rms: None,
    ///     iterations: None,
    ///     tensions: None,
    /// };
    /// model.forward_of_rows(&problems, &ForwardSettings::default(), &mut State::at_home(&model), answers)?;
    /// assert_eq!(statuses[9], Status::Converged);
    /// assert!((poses[9][0] - home.position.x).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn forward_of_rows(
        &self,
        problems: &ForwardRows<'_>,
        settings: &ForwardSettings,
        state: &mut State,
        answers: ForwardAnswers<'_>,
    ) -> Result<(), RowsError> {
        let (cables, count) = (self.cable_count(), answers.poses.len());
        let ForwardAnswers { poses, statuses, mut residual_rms, mut iterations, mut tensions } = answers;
        check("lengths, one per problem and cable", count * cables, problems.lengths.len())?;
        let has_one_guess = problems.guesses.len() == 1;
        check("guesses, one per problem", count, if has_one_guess { count } else { problems.guesses.len() })?;
        check("places for statuses, one per problem", count, statuses.len())?;
        let rooms = [residual_rms.as_deref().map(<[f64]>::len), iterations.as_deref().map(<[u32]>::len)];
        rooms.into_iter().flatten().try_for_each(|len| check("places for answers, one per problem", count, len))?;
        check(
            "places for tensions, one per problem and cable",
            count * cables,
            tensions.as_deref().map_or(count * cables, <[f64]>::len),
        )?;

        let (mut lengths, mut solutions) = (LaneTable::new(cables), Solutions::default());
        let mut guesses = PoseBatch::default();
        let one = match has_one_guess {
            true => {
                guesses.fill_rows(problems.guesses)?;
                Some(guesses.get(0))
            }
            false => None,
        };
        let chunk = chunk_for_threads(CHUNK);
        for start in (0..count).step_by(chunk) {
            let end = count.min(start + chunk);
            lengths.fill_rows(&problems.lengths[start * cables..end * cables]);
            match one {
                Some(guess) => guesses = std::iter::repeat_n(&guess, end - start).collect(),
                None => guesses.fill_rows(problems.guesses.part(start, chunk)).map_err(|error| error.behind(start))?,
            }
            let batch = ForwardBatch { lengths: &lengths, guesses: &guesses, load: problems.load, only_taut: false };
            self.forward_batch(settings, &batch, state, &mut solutions)?;
            for (item, problem) in (start..end).enumerate() {
                poses[problem] = solutions.pose(item).numbers();
                statuses[problem] = solutions.status(item);
                if let Some(places) = &mut residual_rms {
                    places[problem] = solutions.residual_rms(item);
                }
                if let Some(places) = &mut iterations {
                    places[problem] = solutions.iterations(item);
                }
                if let Some(places) = &mut tensions {
                    let places = &mut places[problem * cables..(problem + 1) * cables];
                    match solutions.has_tensions() {
                        true => {
                            places.iter_mut().enumerate().for_each(|(k, place)| *place = solutions.tension(k, item))
                        }
                        false => places.fill(f64::NAN),
                    }
                }
            }
        }
        Ok(())
    }

    /// Tensions (N) that balance a load within limits at the poses of an array, m for each pose, chosen by a method:
    /// [`distribution::solve_batch`] of rows. After an error the answers are unspecified.
    ///
    /// ```
    /// use cdpr::tension::{Limits, Method, Status};
    /// use cdpr::{Load, Model, Robot};
    ///
    /// let robot = Robot::builtin("cogiro").ok_or("unknown robot")?;
    /// let home = robot.home.ok_or("no home pose")?;
    /// let (load, limits) = (Load::of(&robot)?, Limits::uniform(8, 0.0, 5000.0)?);
    /// let model = Model::new(robot, "standard".parse()?)?;
    /// let (mut tensions, mut statuses) = ([0.0; 24], [Status::Undecided; 3]);
    /// let rows = [home.numbers(); 3];
    /// model.tensions_of_rows(&load, &limits, Method::Qp, rows[..].into(), &mut tensions, &mut statuses)?;
    /// assert_eq!(statuses[2], Status::Feasible);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn tensions_of_rows(
        &self,
        load: &Load,
        limits: &Limits,
        method: Method,
        poses: PoseRows<'_>,
        tensions: &mut [f64],
        statuses: &mut [tension::Status],
    ) -> Result<(), RowsError> {
        let (cables, count) = (self.cable_count(), poses.len());
        check("places for tensions, one per pose and cable", count * cables, tensions.len())?;
        check("places for statuses, one per pose", count, statuses.len())?;
        let (mut batch, mut found) = (PoseBatch::default(), Distributions::default());
        let chunk = chunk_for_threads(CHUNK);
        for start in (0..count).step_by(chunk) {
            batch.fill_rows(poses.part(start, chunk)).map_err(|error| error.behind(start))?;
            distribution::solve_batch(self, load, limits, method, &batch, &mut found)?;
            for (item, pose) in (start..).take(batch.len()).enumerate() {
                statuses[pose] = found.status(item);
                let places = tensions[pose * cables..(pose + 1) * cables].iter_mut();
                places.enumerate().for_each(|(cable, place)| *place = found.tension(cable, item));
            }
        }
        Ok(())
    }
}
