//! Problems of tension distribution, and clarabel (an interior-point solver) as a second opinion on them: for the oracle test
//! and the bench.
#![allow(dead_code, reason = "each user needs its own part")]

use cdpr_model::tension::Limits;
use clarabel::algebra::CscMatrix;
use clarabel::solver::SupportedConeT::{NonnegativeConeT, ZeroConeT};
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use nalgebra::DMatrix;

/// Balance, load and limits.
#[derive(Clone, Debug)]
pub(crate) struct Problem {
    /// n × m.
    pub(crate) matrix: DMatrix<f64>,
    pub(crate) wrench: Vec<f64>,
    pub(crate) limits: Limits,
}

/// What clarabel says of a problem.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Opinion {
    /// The tensions nearest to the middle of the limits (N).
    Optimum(Vec<f64>),
    Infeasible,
    /// It stopped early, as it does near the boundary of what is feasible.
    Unclear,
}

/// The problem as clarabel wants it: tensions as a part of the largest limit, rows of length 1.
#[derive(Clone, Debug)]
pub(crate) struct Conic {
    unit: f64,
    cost: CscMatrix<f64>,
    linear: Vec<f64>,
    rows: CscMatrix<f64>,
    right: Vec<f64>,
    cones: [SupportedConeT<f64>; 2],
    /// What the rows of the balance were multiplied by.
    scales: Vec<f64>,
}

impl Problem {
    pub(crate) fn cable_count(&self) -> usize {
        self.limits.cable_count()
    }

    /// The largest limit by amount (N): the unit of [`Problem::margin`].
    pub(crate) fn largest_limit(&self) -> f64 {
        let all = self.limits.minimum().iter().chain(self.limits.maximum());
        all.fold(0.0, |most, limit| most.max(limit.abs()))
    }

    /// ½ ‖f − f_m‖² in squares of the largest limit.
    pub(crate) fn cost(&self, tensions: &[f64]) -> f64 {
        let away = tensions.iter().enumerate().map(|(cable, f)| (f - self.limits.middle(cable)) / self.largest_limit());
        0.5 * away.map(|part| part * part).sum::<f64>()
    }

    /// min ½ ‖f − f_m‖² within balance and limits.
    pub(crate) fn conic(&self) -> Conic {
        let (m, unit) = (self.cable_count(), self.largest_limit());
        let linear = (0..m).map(|cable| -self.limits.middle(cable) / unit).collect();
        let (rows, right) = self.constraints(None);
        let cones = [ZeroConeT(self.wrench.len()), NonnegativeConeT(2 * m)];
        let scales = self.matrix.row_iter().map(|row| 1.0 / row.norm()).collect();
        Conic { unit, cost: CscMatrix::identity(m), linear, rows, right, cones, scales }
    }

    /// How much narrower all limits could be (positive) or have to be wider (negative) at the least for tensions to exist, as
    /// a part of the largest limit: max t such that Aᵀ f + w = 0 and f_min + t ≤ f ≤ f_max − t.
    pub(crate) fn margin(&self) -> f64 {
        let (m, n) = (self.cable_count(), self.wrench.len());
        let (rows, right) = self.constraints(Some((n..n + 2 * m).map(|row| (row, 1.0)).collect()));
        let mut linear = vec![0.0; m];
        linear.push(-1.0);
        let cones = [ZeroConeT(n), NonnegativeConeT(2 * m)];
        let cost = CscMatrix::zeros((m + 1, m + 1));
        let mut solver = DefaultSolver::new(&cost, &linear, &rows, &right, &cones, settings()).expect("a programme");
        solver.solve();
        assert!(
            matches!(solver.solution.status, SolverStatus::Solved | SolverStatus::AlmostSolved),
            "a linear programme that always has a solution: {}",
            solver.solution.status
        );
        solver.solution.x[m]
    }

    /// Whether tensions exist, by a linear programme without an aim.
    pub(crate) fn is_feasible(&self) -> Opinion {
        let programme = self.conic();
        let m = self.cable_count();
        Conic { cost: CscMatrix::zeros((m, m)), linear: vec![0.0; m], ..programme }.solve()
    }

    /// Balance, lower and upper limits, with a further column after the tensions'.
    fn constraints(&self, further: Option<Vec<(usize, f64)>>) -> (CscMatrix<f64>, Vec<f64>) {
        let (n, m) = self.matrix.shape();
        let unit = self.largest_limit();
        let scales: Vec<f64> = self.matrix.row_iter().map(|row| 1.0 / row.norm()).collect();
        let mut columns: Vec<Vec<(usize, f64)>> = Vec::new();
        for cable in 0..m {
            let mut column: Vec<(usize, f64)> =
                (0..n).map(|row| (row, self.matrix[(row, cable)] * scales[row])).collect();
            column.extend([(n + cable, -1.0), (n + m + cable, 1.0)]);
            columns.push(column);
        }
        columns.extend(further);
        let mut right: Vec<f64> = self.wrench.iter().zip(&scales).map(|(w, scale)| -w * scale / unit).collect();
        right.extend(self.limits.minimum().iter().map(|least| -least / unit));
        right.extend(self.limits.maximum().iter().map(|largest| largest / unit));
        let starts = columns.iter().scan(0, |end, column| {
            *end += column.len();
            Some(*end)
        });
        let starts = std::iter::once(0).chain(starts).collect();
        let (places, values) = columns.iter().flatten().copied().unzip();
        (CscMatrix::new(n + 2 * m, columns.len(), starts, places, values), right)
    }
}

impl Conic {
    pub(crate) fn solve(&self) -> Opinion {
        self.solve_with_multipliers().0
    }

    /// The opinion to 1e-12 instead of 1e-8, where clarabel comes that far.
    pub(crate) fn solve_sharply(&self) -> Opinion {
        let sharp = 1e-12;
        self.solve_to(DefaultSettings { tol_gap_abs: sharp, tol_gap_rel: sharp, tol_feas: sharp, ..settings() }).0
    }

    /// The opinion, and the multipliers of the balance y (N): near the optimum f − f_m = A y for tensions off their limits.
    pub(crate) fn solve_with_multipliers(&self) -> (Opinion, Vec<f64>) {
        self.solve_to(settings())
    }

    fn solve_to(&self, settings: DefaultSettings<f64>) -> (Opinion, Vec<f64>) {
        let Self { cost, linear, rows, right, cones, .. } = self;
        let mut solver = DefaultSolver::new(cost, linear, rows, right, cones, settings).expect("a programme");
        solver.solve();
        let solution = &solver.solution;
        let multipliers = solution.z.iter().zip(&self.scales).map(|(z, scale)| -z * scale * self.unit).collect();
        let opinion = match solution.status {
            SolverStatus::Solved => Opinion::Optimum(solution.x.iter().map(|f| f * self.unit).collect()),
            SolverStatus::PrimalInfeasible => Opinion::Infeasible,
            _ => Opinion::Unclear,
        };
        (opinion, multipliers)
    }
}

fn settings() -> DefaultSettings<f64> {
    DefaultSettings { verbose: false, max_threads: 1, ..DefaultSettings::default() }
}
