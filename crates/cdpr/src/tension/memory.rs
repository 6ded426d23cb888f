//! Memory of each method from one problem to the next, and the order of search and exact verdict.

use super::affine::Affine;
use super::answer::{Answer, Cause, Status};
use super::problem::Problem;
use super::{
    InputError, Limits, Method, Options, barrier, centroid, closed_form, dykstra, improved_closed_form, nearest_wrench,
    norm, puncture, quadratic,
};

/// The memory of one method beside that of the quadratic programme.
#[derive(Clone, Debug)]
pub(super) enum Memory {
    Programme,
    ClosedForm(closed_form::Solver),
    ImprovedClosedForm(Affine),
    Puncture { balanced: Affine, minimum_norm: Vec<f64> },
    Dykstra { balanced: Affine, search: dykstra::Search },
    Centroid { balanced: Affine, search: centroid::Search },
    Norm(Box<norm::Search>),
    Barrier(Box<Barrier>),
    NearestWrench { search: nearest_wrench::Search, wrench: Vec<f64> },
}

/// Memory of the barrier method.
#[derive(Clone, Debug)]
pub(super) struct Barrier {
    balanced: Affine,
    search: barrier::Search,
    narrow: Limits,
    /// The last centre (N), once there is one.
    last: Vec<f64>,
    has_last: bool,
}

impl Memory {
    pub(super) fn new(method: Method, cable_count: usize, dof: usize) -> Self {
        let balanced = Affine::new(cable_count, dof);
        match method {
            Method::Qp => Self::Programme,
            Method::ClosedForm => Self::ClosedForm(closed_form::Solver::new(cable_count, dof)),
            Method::ImprovedClosedForm => Self::ImprovedClosedForm(balanced),
            Method::Puncture => Self::Puncture { balanced, minimum_norm: vec![0.0; cable_count] },
            Method::Dykstra => Self::Dykstra { balanced, search: dykstra::Search::new(cable_count) },
            Method::Centroid => Self::Centroid { balanced, search: centroid::Search::new(cable_count, dof) },
            Method::Minimum => Self::Norm(Box::new(norm::Search::new(norm::End::Zero, cable_count, dof))),
            Method::Maximum => Self::Norm(Box::new(norm::Search::new(norm::End::Largest, cable_count, dof))),
            Method::Barrier => Self::Barrier(Box::new(Barrier {
                balanced,
                search: barrier::Search::new(cable_count),
                narrow: Limits::zero(cable_count),
                last: vec![0.0; cable_count],
                has_last: false,
            })),
            Method::NearestWrench => {
                Self::NearestWrench { search: nearest_wrench::Search::new(cable_count, dof), wrench: vec![0.0; dof] }
            }
        }
    }

    pub(super) fn forget(&mut self) {
        match self {
            Self::Norm(search) => search.forget(),
            Self::Barrier(barrier) => barrier.has_last = false,
            _ => {}
        }
    }

    /// Searches before the exact verdict is asked for: true when it found tensions and needs none.
    pub(super) fn search(
        &mut self,
        problem: &Problem<'_>,
        reference: &[f64],
        answer: &mut Answer,
    ) -> Result<bool, InputError> {
        let (limits, tensions) = (&answer.limits, &mut answer.tensions);
        let Problem { structure_matrix, wrench } = *problem;
        Ok(match self {
            Self::ClosedForm(solver) => {
                let found = solver.solve(structure_matrix, wrench, limits, Some(reference))?;
                tensions.copy_from_slice(&found.tensions);
                found.balanced && found.within_limits
            }
            Self::ImprovedClosedForm(balanced) => {
                balanced.load(structure_matrix, wrench)?
                    && improved_closed_form::search(balanced, limits, reference, tensions)
            }
            Self::Puncture { balanced, minimum_norm } => {
                balanced.load(structure_matrix, wrench)?
                    && puncture::search(balanced, limits, reference, minimum_norm, tensions)
            }
            Self::Dykstra { balanced, search } => {
                balanced.load(structure_matrix, wrench)? && {
                    search.begin(balanced, reference, tensions);
                    let is_found = search.run(dykstra::FIRST_ROUNDS, balanced, limits, tensions);
                    answer.iterations = search.rounds();
                    is_found
                }
            }
            _ => false,
        })
    }

    /// Chooses among allowed tensions after the exact verdict; `answer` begins with some.
    pub(super) fn search_on(
        &mut self,
        problem: &Problem<'_>,
        options: &Options<'_>,
        reference: &[f64],
        qp: &mut quadratic::Solver,
        answer: &mut Answer,
    ) -> Result<(), InputError> {
        let Problem { structure_matrix, wrench } = *problem;
        let (limits, tensions) = (&answer.limits, &mut answer.tensions);
        let steps = match (self, answer.status) {
            (Self::Dykstra { balanced, search }, Status::NotFound) => {
                let rounds = dykstra::MAX_ROUNDS - dykstra::FIRST_ROUNDS;
                let is_found = search.run(rounds, balanced, limits, tensions);
                answer.status = if is_found { Status::Feasible } else { Status::NotFound };
                answer.iterations = search.rounds();
                return Ok(());
            }
            (Self::Centroid { balanced, search }, Status::Feasible) => {
                balanced.load(structure_matrix, wrench)?;
                if let Err(dimension) = search.run(balanced, limits, tensions) {
                    (answer.status, answer.cause) = (Status::NotFound, Cause::TooManyFaces { dimension });
                }
                return Ok(());
            }
            (Self::NearestWrench { search, wrench: nearest }, Status::Infeasible) => {
                answer.iterations = search.run(problem, options.lengths, limits, reference, tensions);
                return take_nearest_to_reference(problem, nearest, limits, reference, qp, tensions);
            }
            (Self::Norm(search), Status::Feasible) => search.run(problem, limits, options.p, tensions)?,
            (Self::Barrier(barrier), Status::Feasible) => barrier.run(problem, limits, reference, qp, tensions)?,
            _ => return Ok(()),
        };
        match steps {
            Some(steps) => answer.iterations = steps,
            None => answer.status = Status::NotFound,
        }
        Ok(())
    }
}

/// Of the tensions that give the same wrench, takes the nearest to the reference. `wrench` is memory.
fn take_nearest_to_reference(
    problem: &Problem<'_>,
    wrench: &mut [f64],
    limits: &Limits,
    reference: &[f64],
    qp: &mut quadratic::Solver,
    tensions: &mut [f64],
) -> Result<(), InputError> {
    wrench.fill(0.0);
    for (column, f) in problem.structure_matrix.column_iter().zip(tensions.iter()) {
        wrench.iter_mut().zip(&column).for_each(|(rest, entry)| *rest -= entry * f);
    }
    let found = qp.solve(problem.structure_matrix, wrench, limits, Some(reference))?;
    if found.status == quadratic::Status::Feasible {
        tensions.copy_from_slice(&found.tensions);
    }
    Ok(())
}

impl Barrier {
    /// Moves allowed tensions to the centre of all; they stay where the set has no inside.
    fn run(
        &mut self,
        problem: &Problem<'_>,
        limits: &Limits,
        reference: &[f64],
        qp: &mut quadratic::Solver,
        tensions: &mut [f64],
    ) -> Result<Option<u32>, InputError> {
        self.balanced.load(problem.structure_matrix, problem.wrench)?;
        let mut is_inside = false;
        if self.has_last {
            self.narrow.narrow_from(limits, barrier::MARGINS[2]);
            self.balanced.nearest(&self.last, tensions);
            is_inside = self.narrow.contain(tensions, 0.0);
        }
        let mut margins = barrier::MARGINS.iter();
        while !is_inside {
            let Some(&margin) = margins.next() else { break };
            self.narrow.narrow_from(limits, margin);
            let found = qp.solve(problem.structure_matrix, problem.wrench, &self.narrow, Some(reference))?;
            is_inside = found.status == quadratic::Status::Feasible;
            if is_inside {
                tensions.copy_from_slice(&found.tensions);
            }
        }
        self.has_last = false;
        if !is_inside {
            let found = qp.solve(problem.structure_matrix, problem.wrench, limits, Some(reference))?;
            tensions.copy_from_slice(&found.tensions);
            return Ok(Some(0));
        }
        let steps = self.search.run(&mut self.balanced, limits, tensions);
        self.has_last = steps.is_some();
        self.last.copy_from_slice(tensions);
        Ok(steps)
    }
}
