//! How the errors of what is measured reach the rows of a sample.

use cdpr_model::geometry::Twist;
use cdpr_model::model::Model;
use cdpr_model::scalar::cholesky::{LowerTriangle, factorize};
use cdpr_model::scalar::{Kernel, LANES, Lanes, Line, dispatch};

/// Derivatives of one sample's rows by what is measured, scaled to standard deviations.
#[derive(Clone, Debug)]
pub(crate) struct Noise {
    /// Each row by the directions of the pattern.
    pub(crate) by_pose: Vec<[f64; 6]>,
    /// For each cable the n wrench rows and its length row by its tension.
    pub(crate) by_tension: Vec<[f64; 7]>,
    /// Standard deviation of each length row by the recorded length itself.
    pub(super) length: Vec<f64>,
}

impl Noise {
    pub(crate) fn new(model: &Model) -> Self {
        let (m, n) = (model.cable_count(), model.dof());
        Self { by_pose: vec![[0.0; 6]; n + m], by_tension: vec![[0.0; 7]; m], length: vec![0.0; m] }
    }

    /// Number of rows that say something: all but the length rows of slack cables.
    pub(super) fn informative_rows(&self) -> usize {
        self.by_pose.len() - self.length.iter().filter(|&&sigma| sigma >= SLACK_SIGMA).count()
    }

    /// Writes the Cholesky factor of N diag(σ²) Nᵀ to a row-major matrix, its diagonal inverted; `None` if a number is none. The triangle and
    /// the columns of N are memory.
    pub(super) fn factor(
        &self,
        triangle: &mut LowerTriangle,
        columns: &mut Vec<Line>,
        factor: &mut [f64],
    ) -> Option<()> {
        let (count, m) = (self.by_pose.len(), self.length.len());
        let (n, groups) = (count - m, triangle.groups());
        columns.clear();
        columns.resize((6 + m) * groups, Line::default());
        for (row, by_pose) in self.by_pose.iter().enumerate() {
            for (k, entry) in by_pose.iter().enumerate() {
                columns[k * groups + row / LANES].0[row % LANES] = *entry;
            }
        }
        for (cable, (by_tension, column)) in
            self.by_tension.iter().zip(columns[6 * groups..].chunks_exact_mut(groups)).enumerate()
        {
            let own = column.iter_mut().flat_map(|line| &mut line.0);
            own.take(n).zip(by_tension).for_each(|(entry, by_tension)| *entry = *by_tension);
            column[(n + cable) / LANES].0[(n + cable) % LANES] = by_tension[n];
        }
        let is_regular = dispatch(Factor { columns, length: &self.length, count, lines: triangle.lines_mut() });
        for (column, lines) in triangle.lines_mut().chunks_exact(groups).enumerate() {
            for (row, entry) in (column..count).map(|row| (row, lines[row / LANES].0[row % LANES])) {
                factor[row * count + column] = entry;
            }
        }
        is_regular.then_some(())
    }

    /// Nᵀ y in standard deviations: along the directions of the pose, then per cable.
    pub(super) fn back(&self, y: &[f64], pose: &mut [f64; 6], tensions: &mut [f64]) {
        let n = self.by_pose.len() - self.length.len();
        *pose = std::array::from_fn(|k| self.by_pose.iter().zip(y).map(|(row, y)| row[k] * y).sum());
        for (cable, by_tension) in self.by_tension.iter().enumerate() {
            tensions[cable] = (0..n).map(|k| by_tension[k] * y[k]).sum::<f64>() + by_tension[n] * y[n + cable];
        }
    }

    /// N z for displacements in standard deviations, added to `rows`.
    pub(super) fn forth(&self, pose: &[f64; 6], tensions: &[f64], rows: &mut [f64]) {
        let n = self.by_pose.len() - self.length.len();
        for (row, by_pose) in rows.iter_mut().zip(&self.by_pose) {
            *row += (0..6).map(|k| by_pose[k] * pose[k]).sum::<f64>();
        }
        for (cable, by_tension) in self.by_tension.iter().enumerate() {
            (0..n).for_each(|k| rows[k] += by_tension[k] * tensions[cable]);
            rows[n + cable] += by_tension[n] * tensions[cable];
        }
    }
}

/// Factor of N Nᵀ plus the squares of what lengths have of their own.
struct Factor<'a> {
    /// N by columns, rows in lanes.
    columns: &'a [Line],
    length: &'a [f64],
    count: usize,
    lines: &'a mut [Line],
}

impl Kernel for Factor<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> bool {
        let Self { columns, length, count, lines } = self;
        let groups = count.div_ceil(LANES);
        for (place, target) in lines.chunks_exact_mut(groups).enumerate() {
            for group in place / LANES..groups {
                let mut sum = l.constant(0.0);
                for column in columns.chunks_exact(groups) {
                    sum = sum + l.constant(column[place / LANES].0[place % LANES]) * l.load(&column[group].0);
                }
                sum.store(&mut target[group].0);
            }
        }
        let first = count - length.len();
        for (row, own) in (first..).zip(length) {
            lines[row * groups + row / LANES].0[row % LANES] += own * own;
        }
        factorize(l, count, lines)
    }
}

/// Standard deviation of a length row that says nothing (m).
pub(super) const SLACK_SIGMA: f64 = 1e3;

/// Tensions below this many standard deviations of the force sensor may be those of a slack cable.
const SLACK_SIGMAS: f64 = 4.0;
/// Standard deviation of tensions that nothing measured, as a multiple of their mean: equilibrium tells them.
const UNMEASURED: f64 = 30.0;

/// Standard deviations of everything measured, as the weights use them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sigmas {
    /// Per axis (m).
    pub(crate) position: f64,
    /// Per axis (rad).
    pub(crate) rotation: f64,
    /// (m)
    pub(crate) length: f64,
    /// (N)
    pub(crate) tension: f64,
    /// Tension below which a cable may be slack (N).
    pub(crate) slack: f64,
}

/// Derivatives by what is measured itself instead of by standard deviations.
pub(crate) const UNITS: Sigmas =
    Sigmas { position: 1.0, rotation: 1.0, length: 1.0, tension: 1.0, slack: SLACK_SIGMAS };

impl Sigmas {
    /// With the slack limit of a sensor's accuracy.
    pub(super) fn with_sensor(self) -> Self {
        Self { slack: SLACK_SIGMAS * self.tension, ..self }
    }

    /// With tensions that equilibrium tells alone, of this mean (N).
    pub(super) fn told_by_statics(self, mean: f64) -> Self {
        Self { tension: UNMEASURED * mean, slack: 0.0, ..self }
    }

    /// Of the direction of a motion pattern: a turn or a shift.
    pub(super) fn along(&self, twist: &Twist) -> f64 {
        if twist.fixed_rows::<3>(3).norm_squared() > 0.0 { self.rotation } else { self.position }
    }
}
