//! Vectors of lengths at poses that nobody measured: every sample takes the pose at which its lengths fit best.
//!
//! r = ρ/σ_q at the pose x that makes ‖r‖² least, in the directions that are not known. Poses are eliminated sample by sample (variable projection), the
//! derivative is that of Kaufman (1975), J_p without what J_x explains: exact for the gradient, since nothing of r is along J_x at the best pose.

use nalgebra::{DMatrix, Vector3};

use super::lengths::LengthVectors;
use super::vectors::{Stacked, Vectors};
use crate::geometry::{Pose, Twist};
use crate::measurement::{InternalSamples, Samples};
use crate::model::Model;
use crate::robot::Parameter;
use crate::scalar::ldl;

/// Degrees of freedom at most.
const DOF: usize = 6;
/// Steps to a pose at most; near it each gains some four digits.
const STEPS: u32 = 60;
/// Last step to a pose, in standard deviations, relative to a larger norm of its residuals: Newton's method is at the pose to its square behind it.
const FOUND: f64 = 1e-6;
/// Share of the squares that the next step may still promise where a pose is sought no longer.
const NEAR: f64 = 1e-6;
/// Damping of the first step.
const DAMPING: f64 = 1e-3;
/// Length of a column that is none beside the part of it that others explain.
const WITHIN: f64 = 1e-13;
/// Damping from which on a pose is as good as it gets.
const MOST_DAMPING: f64 = 1e12;

/// Length residuals at the best poses, m a sample.
pub(in crate::identification) struct PoselessVectors<'a> {
    model: &'a Model,
    parameters: &'a [Parameter],
    /// Degrees of freedom of each sample that are not known.
    directions: Vec<Vec<Twist>>,
    /// Lengths at the poses; of changes those at the common pose follow as a last sample.
    lengths: LengthVectors,
    /// Recorded lengths or changes (m).
    recorded: Vec<f64>,
    are_changes: bool,
    /// 1/σ_q (1/m).
    per_length: f64,
    at: Stacked,
    /// Memory for the derivatives of a sample's lengths by its pose.
    by_pose: DMatrix<f64>,
    /// Memory for the projector on what the pose of a sample does not explain, I − E Eᵀ.
    left: DMatrix<f64>,
    /// Poses where searches begin, the common pose last.
    guesses: Vec<Pose>,
    /// Poses found last.
    poses: Vec<Pose>,
    samples: usize,
}

impl<'a> PoselessVectors<'a> {
    /// Vectors of samples whose unknown components are guessed; σ in metres.
    pub(in crate::identification) fn new(
        model: &'a Model,
        internal: &InternalSamples,
        parameters: &'a [Parameter],
        sigma: f64,
    ) -> Self {
        let samples = internal.samples.len();
        let home = model.robot().home_or_middle();
        let guess = |sample: usize| guess(model, &internal.samples.poses[sample], &internal.known[sample], &home);
        let mut guesses: Vec<Pose> = (0..samples).map(guess).collect();
        let mut recorded = internal.samples.lengths.clone();
        if internal.are_changes {
            guesses.push(Pose::identity());
            recorded.extend(std::iter::repeat_n(0.0, model.cable_count()));
        }
        let mut motor_angles = internal.samples.motor_angles.clone();
        if let Some(angles) = motor_angles.as_mut().filter(|_| internal.are_changes) {
            angles.extend(std::iter::repeat_n(0.0, model.cable_count()));
        }
        let with_origin =
            Samples { poses: guesses.clone(), lengths: recorded, motor_angles, ..internal.samples.clone() };
        let lengths = LengthVectors::new(model, &with_origin, parameters, sigma);
        let free = |known: &Vec<bool>| {
            model.twist_basis().iter().zip(known).filter(|(_, known)| !**known).map(|(twist, _)| *twist).collect()
        };
        Self {
            at: Stacked::new(&lengths, parameters.len()),
            by_pose: DMatrix::zeros(model.cable_count(), DOF),
            left: DMatrix::zeros(model.cable_count(), model.cable_count()),
            directions: internal.known.iter().map(free).collect(),
            are_changes: internal.are_changes,
            per_length: sigma.recip(),
            poses: guesses.clone(),
            model,
            parameters,
            recorded: with_origin.lengths,
            lengths,
            guesses,
            samples,
        }
    }

    /// Poses found last, one of each sample.
    pub(in crate::identification) fn poses(&self) -> &[Pose] {
        &self.poses[..self.samples]
    }

    fn try_write(&mut self, values: &[f64], stacked: &mut Stacked) -> Option<()> {
        let model = self.model.with_parameters(self.parameters, values)?;
        let found = self.find(&model, values, self.poses.clone());
        self.poses = match found {
            Some(poses) => poses,
            None => self.find(&model, values, self.guesses.clone())?,
        };
        (0..self.samples).for_each(|sample| self.write_sample(&model, sample, stacked));
        Some(())
    }

    /// Poses at which the lengths fit best, and the rows there; nothing where one is not found.
    fn find(&mut self, model: &Model, values: &[f64], mut poses: Vec<Pose>) -> Option<Vec<Pose>> {
        let recorded = self.recorded(model, values, &poses)?;
        let m = model.cable_count();
        for (sample, pose) in poses.iter_mut().enumerate().take(self.samples) {
            let search = Search { model, per_length: self.per_length, recorded: &recorded[sample * m..][..m] };
            *pose = search.find(pose, &self.directions[sample])?;
        }
        self.look(values, &poses)?;
        Some(poses)
    }

    /// Lengths that the poses are to have, sample by sample (m).
    fn recorded(&mut self, model: &Model, values: &[f64], poses: &[Pose]) -> Option<Vec<f64>> {
        let m = model.cable_count();
        let modelled =
            |pose: &Pose, cable: usize| model.recorded_length(cable, model.path_or_nan(cable, pose).0.length);
        if !self.parameters.iter().any(|parameter| parameter.kind.needs_motor_angles()) {
            let mut recorded = self.recorded[..self.samples * m].to_vec();
            if self.are_changes {
                let origin: Vec<f64> = (0..m).map(|cable| modelled(&poses[self.samples], cable)).collect();
                recorded.iter_mut().zip(origin.iter().cycle()).for_each(|(length, origin)| *length += origin);
            }
            return Some(recorded);
        }
        // winches make other lengths of the angles
        self.look(values, poses)?;
        let of = |k: usize| modelled(&poses[k / m], k % m) - self.residual(k / m, k % m) / self.per_length;
        Some((0..self.samples * m).map(of).collect())
    }

    /// Rows at poses.
    fn look(&mut self, values: &[f64], poses: &[Pose]) -> Option<()> {
        self.lengths.move_to(poses);
        self.lengths.write(values, &mut self.at).then_some(())
    }

    /// Residual of a sample's cable where was looked last.
    fn residual(&self, sample: usize, cable: usize) -> f64 {
        let (m, at) = (self.model.cable_count(), &self.at.residuals);
        at[sample * m + cable] - if self.are_changes { at[self.samples * m + cable] } else { 0.0 }
    }

    /// Rows of a sample without what its pose explains.
    fn write_sample(&mut self, model: &Model, sample: usize, stacked: &mut Stacked) {
        let m = model.cable_count();
        let directions = &self.directions[sample];
        let (first, origin) = (sample * m, self.samples * m);
        let pose = (&self.poses[sample], &self.poses[sample].rotation_rows());
        for cable in 0..m {
            stacked.residuals[first + cable] = self.residual(sample, cable);
            let row = Length::of(model, cable, pose, self.per_length).row(directions);
            (0..directions.len()).for_each(|k| self.by_pose[(cable, k)] = row[k]);
        }
        orthonormalise(&mut self.by_pose, directions.len());
        self.left.fill_with_identity();
        for explained in self.by_pose.column_iter().take(directions.len()) {
            self.left.ger(-1.0, &explained, &explained, 1.0);
        }
        for (column, parameter) in self.parameters.iter().enumerate() {
            // a parameter changes the length of its own cable
            let entries = self.at.jacobian.column(column);
            let origin = if self.are_changes { entries[origin + parameter.cable] } else { 0.0 };
            let entry = entries[first + parameter.cable] - origin;
            let mut target = stacked.jacobian.column_mut(column);
            let left = self.left.column(parameter.cable);
            target.as_mut_slice()[first..][..m].iter_mut().zip(&left).for_each(|(row, left)| *row = entry * left);
        }
    }
}

/// Columns of length one at right angles, by the method of Gram and Schmidt; a column within the others becomes zero.
pub(super) fn orthonormalise(columns: &mut DMatrix<f64>, count: usize) {
    for k in 0..count {
        let before = columns.column(k).norm();
        for j in 0..k {
            let (done, mut rest) = columns.columns_range_pair_mut(j..=j, k..);
            let share = done.column(0).dot(&rest.column(0));
            rest.column_mut(0).axpy(-share, &done.column(0), 1.0);
        }
        let norm = columns.column(k).norm();
        columns.column_mut(k).scale_mut(if norm > WITHIN * before { norm.recip() } else { 0.0 });
    }
}

/// Search for the pose of one sample, by a damped Newton method.
struct Search<'a> {
    model: &'a Model,
    /// 1/σ_q (1/m).
    per_length: f64,
    /// Lengths that its cables have (m).
    recorded: &'a [f64],
}

/// Squares at a pose, with half their derivatives in N directions.
struct Slope<const N: usize> {
    square: f64,
    /// −Jᵀr.
    pull: [f64; N],
    /// JᵀJ.
    plain: [[f64; N]; N],
    /// Σ r ∂²r.
    bent: [[f64; N]; N],
}

impl Search<'_> {
    /// The pose at which the lengths fit best, from one near it.
    fn find(&self, from: &Pose, directions: &[Twist]) -> Option<Pose> {
        match directions.len() {
            0 => Some(*from),
            1 => self.find_in::<1>(from, directions.first_chunk()?),
            2 => self.find_in::<2>(from, directions.first_chunk()?),
            3 => self.find_in::<3>(from, directions.first_chunk()?),
            4 => self.find_in::<4>(from, directions.first_chunk()?),
            5 => self.find_in::<5>(from, directions.first_chunk()?),
            _ => self.find_in::<DOF>(from, directions.first_chunk()?),
        }
    }

    fn find_in<const N: usize>(&self, from: &Pose, directions: &[Twist; N]) -> Option<Pose> {
        let (mut pose, mut here, mut damping) = (*from, self.slope(from, directions), DAMPING);
        let mut gain = f64::INFINITY;
        for _ in 0..STEPS {
            let step = here.step(damping)?;
            gain = step.iter().zip(here.pull).map(|(step, pull)| step * pull).sum();
            let twist: Twist = directions.iter().zip(step).map(|(twist, amount)| twist * amount).sum();
            let trial = pose.displaced(&twist);
            if gain <= FOUND * FOUND * here.square.max(1.0) {
                return Some(trial);
            }
            let there = self.slope(&trial, directions);
            if there.square <= here.square {
                (pose, here, damping) = (trial, there, 0.1 * damping);
            } else {
                damping = (10.0 * damping).max(DAMPING);
            }
            if damping > MOST_DAMPING {
                return Some(pose);
            }
        }
        // near enough for parameters that are still far from their optimum
        (gain <= NEAR * here.square).then_some(pose)
    }

    fn slope<const N: usize>(&self, pose: &Pose, directions: &[Twist; N]) -> Slope<N> {
        let mut slope = Slope { square: 0.0, pull: [0.0; N], plain: [[0.0; N]; N], bent: [[0.0; N]; N] };
        let turns = directions.map(|twist| twist.fixed_rows::<3>(3) != Vector3::zeros());
        let rotation = pose.rotation_rows();
        for (cable, recorded) in self.recorded.iter().enumerate() {
            let length = Length::of(self.model, cable, (pose, &rotation), self.per_length);
            let residual = self.per_length * (length.recorded - recorded);
            let (mut velocities, mut row) = ([Vector3::zeros(); N], [0.0; N]);
            for (i, twist) in directions.iter().enumerate() {
                velocities[i] = if turns[i] { length.velocity(twist) } else { twist.fixed_rows::<3>(0).into_owned() };
                row[i] = -length.factor * length.direction.dot(&velocities[i]);
                slope.pull[i] -= row[i] * residual;
            }
            let (bend, per_factor) = (residual * length.factor / length.free, 1.0 / (length.factor * length.factor));
            slope.square += residual * residual;
            for i in 0..N {
                for j in 0..=i {
                    slope.plain[i][j] += row[i] * row[j];
                    let across = velocities[i].dot(&velocities[j]) - row[i] * row[j] * per_factor;
                    slope.bent[i][j] += bend * across;
                    if turns[i] && turns[j] {
                        slope.bent[i][j] -= residual * length.turning(&directions[i], &directions[j]);
                    }
                }
            }
        }
        slope
    }
}

impl<const N: usize> Slope<N> {
    /// A damped Newton step, of Gauss and Newton where the bend of the lengths turns it uphill.
    fn step(&self, damping: f64) -> Option<[f64; N]> {
        let solved = |with_bend: bool| {
            let mut matrix = self.plain;
            for i in 0..N {
                if with_bend {
                    (0..=i).for_each(|j| matrix[i][j] += self.bent[i][j]);
                }
                matrix[i][i] += damping * self.plain[i][i];
            }
            let mut step = self.pull;
            ldl::solve(&mut matrix, &mut step).map(|_| step)
        };
        solved(true).or_else(|| solved(false))
    }
}

/// Length of a cable at a pose.
struct Length {
    /// From the platform to the frame.
    direction: Vector3<f64>,
    /// From the platform's origin to its anchor (world, m).
    arm: Vector3<f64>,
    /// Length (m), of a cable over a pulley with its arc, and as it is recorded.
    free: f64,
    recorded: f64,
    /// Standard deviations that are one metre.
    factor: f64,
}

impl Length {
    fn of(model: &Model, cable: usize, (pose, rotation): (&Pose, &[[f64; 3]; 3]), per_length: f64) -> Self {
        let (path, end) = model.path_at(cable, pose.position.into(), rotation);
        let recorded = model.recorded_length(cable, path.length);
        let factor = per_length * (model.recorded_length(cable, 1.0) - model.recorded_length(cable, 0.0));
        Self { direction: path.direction.into(), arm: end.moment_arm.into(), free: path.length, recorded, factor }
    }

    /// Changes with directions of the pose.
    fn row(&self, directions: &[Twist]) -> [f64; DOF] {
        let mut row = [0.0; DOF];
        for (entry, twist) in row.iter_mut().zip(directions) {
            *entry = -self.factor * self.direction.dot(&self.velocity(twist));
        }
        row
    }

    /// Part of the second change with two directions that turns of the platform make.
    fn turning(&self, first: &Twist, second: &Twist) -> f64 {
        let (a, b) = (first.fixed_rows::<3>(3), second.fixed_rows::<3>(3));
        let turned = a.cross(&b.cross(&self.arm)) + b.cross(&a.cross(&self.arm));
        0.5 * self.factor * self.direction.dot(&turned)
    }

    /// Velocity of the platform anchor.
    fn velocity(&self, twist: &Twist) -> Vector3<f64> {
        twist.fixed_rows::<3>(0) + twist.fixed_rows::<3>(3).cross(&self.arm)
    }
}

/// Known components of a pose, the others as at home.
pub(super) fn guess(model: &Model, pose: &Pose, known: &[bool], home: &Pose) -> Pose {
    let mut guess = *home;
    for (twist, _) in model.twist_basis().iter().zip(known).filter(|(_, known)| **known) {
        let axis = twist.fixed_rows::<3>(0).into_owned();
        guess.position += axis * (pose.position - guess.position).dot(&axis);
    }
    let is_turned =
        model.twist_basis().iter().zip(known).any(|(twist, known)| *known && twist.fixed_rows::<3>(3).norm() > 0.0);
    if is_turned { Pose { rotation: pose.rotation, ..guess } } else { guess }
}

impl Vectors for PoselessVectors<'_> {
    fn size(&self) -> usize {
        self.model.cable_count()
    }

    fn unknowns(&self) -> usize {
        self.directions.iter().map(Vec::len).sum()
    }

    fn samples(&self) -> usize {
        self.samples
    }

    fn write(&mut self, values: &[f64], stacked: &mut Stacked) -> bool {
        self.try_write(values, stacked).is_some() && stacked.is_finite()
    }
}
