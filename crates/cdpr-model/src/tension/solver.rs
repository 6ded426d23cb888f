//! One interface to all methods.

use nalgebra::DMatrix;

use super::answer::Answer;
use super::closed_form::write_residual;
use super::distribute::{Cause, Distribute, Problem, Status, Task};
use super::error::{check_shape, check_sizes};
use super::{InputError, Limits, Method, Options, quadratic};

/// A solver with the memory of one method: [`Solver::solve`] claims none, except for a closed form with lost rank.
///
/// ```
/// use cdpr::nalgebra::DMatrix;
/// use cdpr::tension::{Limits, Method, Options, Solver, Status};
///
/// // a point between two cables that pull up and one that pulls down
/// let matrix = DMatrix::from_row_slice(1, 3, &[1.0, 1.0, -1.0]);
/// let limits = Limits::uniform(3, 100.0, 1000.0)?;
/// let mut solver = Solver::new(Method::Minimum, 3, 1);
/// let answer = solver.solve(&matrix, &[-500.0], &limits, &Options::default())?;
/// assert_eq!(answer.status, Status::Feasible);
/// assert!((answer.tensions[0] - 300.0).abs() < 1e-6 && (answer.tensions[2] - 100.0).abs() < 1e-6);
/// let heavy = solver.solve(&matrix, &[-2500.0], &limits, &Options::default())?;
/// assert!(heavy.reason().is_some_and(|reason| reason.contains("cables 1 and 2 would need 2.60 kN together")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Solver {
    dof: usize,
    qp: quadratic::Solver,
    reference: Vec<f64>,
    /// The method.
    distributor: Box<dyn Distribute>,
    answer: Answer,
}

/// Distributes tensions once by any method; see [`Solver`] for many problems.
pub fn solve(
    method: Method,
    structure_matrix: &DMatrix<f64>,
    wrench: &[f64],
    limits: &Limits,
    options: &Options<'_>,
) -> Result<Answer, InputError> {
    let (dof, cable_count) = structure_matrix.shape();
    let mut solver = Solver::new(method, cable_count, dof);
    solver.solve(structure_matrix, wrench, limits, options)?;
    Ok(solver.answer)
}

impl Solver {
    /// A solver with this method for this many cables and degrees of freedom.
    pub fn new(method: Method, cable_count: usize, dof: usize) -> Self {
        Self {
            dof,
            qp: quadratic::Solver::new(cable_count, dof),
            reference: vec![0.0; cable_count],
            distributor: method.distributor(cable_count, dof),
            answer: Answer::new(method, cable_count, dof, Limits::zero(cable_count)),
        }
    }

    /// Forgets the last problem: the next answer does not depend on it, to the last bit.
    pub fn forget(&mut self) {
        self.qp.forget();
        self.distributor.forget();
    }

    /// Returns tensions that balance the wrench within the limits, chosen by the method.
    ///
    /// The wrench has one component per row of the structure matrix (N, N·m). Errors are wrong sizes and values out of
    /// range; an infeasible problem is an answer with a status.
    pub fn solve(
        &mut self,
        structure_matrix: &DMatrix<f64>,
        wrench: &[f64],
        limits: &Limits,
        options: &Options<'_>,
    ) -> Result<&Answer, InputError> {
        let cable_count = self.reference.len();
        check_shape(structure_matrix, self.dof, cable_count)?;
        check_sizes(structure_matrix, wrench, limits, None)?;
        options.check(cable_count, self.dof)?;
        options.write_reference(limits, &mut self.reference);
        let problem = Problem { structure_matrix, wrench };
        if self.begin(limits, options) {
            self.search(&problem, options)?;
            self.look_for_rates(&problem, limits, options)?;
        }
        if self.answer.status == Status::Feasible {
            self.answer.limits.clamp(&mut self.answer.tensions);
        }
        let answer = &mut self.answer;
        write_residual(structure_matrix, wrench, &answer.tensions, &mut answer.wrench_residual);
        if !answer.tensions.iter().chain(&answer.wrench_residual).all(|number| number.is_finite()) {
            answer.status = Status::Undecided;
        }
        Ok(answer)
    }

    /// Writes the limits in force; false if a rate keeps a cable beyond its limits.
    fn begin(&mut self, limits: &Limits, options: &Options<'_>) -> bool {
        let answer = &mut self.answer;
        answer.limits.copy_from(limits);
        (answer.cause, answer.iterations, answer.rates_are_the_reason) = (Cause::Certificate, 0, false);
        let (Some(previous), Some(rates)) = (options.previous, options.rates) else { return true };
        let Err(cable) = answer.limits.narrow_around(previous, rates, options.time_step) else { return true };
        let (least, largest) = (limits.minimum()[cable], limits.maximum()[cable]);
        let reach = rates[cable] * options.time_step;
        answer.cause = Cause::OutOfReach { cable, previous: previous[cable], reach, least, largest };
        answer.status = Status::Infeasible;
        answer.tensions.copy_from_slice(previous);
        false
    }

    fn search(&mut self, problem: &Problem<'_>, options: &Options<'_>) -> Result<(), InputError> {
        let Self { qp, reference, distributor, answer, .. } = self;
        let task = Task { problem: *problem, options, reference };
        if distributor.search(&task, &mut answer.found())? {
            answer.status = Status::Feasible;
            return Ok(());
        }
        let found = qp.solve(problem.structure_matrix, problem.wrench, &answer.limits, Some(reference))?;
        answer.iterations = answer.iterations.max(found.iterations);
        let is_exact = answer.method.is_exact();
        answer.status = match found.status {
            quadratic::Status::Feasible if is_exact => Status::Feasible,
            quadratic::Status::Feasible => Status::NotFound,
            quadratic::Status::Infeasible => Status::Infeasible,
            quadratic::Status::Undecided => Status::Undecided,
        };
        if is_exact {
            answer.tensions.copy_from_slice(&found.tensions);
        }
        if let Some(certificate) = found.certificate() {
            answer.certificate.copy_from(certificate);
        }
        distributor.refine(&task, qp, &mut answer.found())
    }

    /// Solves an infeasible problem again without the rates, to see whether these are the reason.
    fn look_for_rates(
        &mut self,
        problem: &Problem<'_>,
        limits: &Limits,
        options: &Options<'_>,
    ) -> Result<(), InputError> {
        if self.answer.status == Status::Infeasible && options.rates.is_some() {
            let free = self.qp.solve(problem.structure_matrix, problem.wrench, limits, None)?;
            self.answer.rates_are_the_reason = free.status == quadratic::Status::Feasible;
        }
        Ok(())
    }
}
