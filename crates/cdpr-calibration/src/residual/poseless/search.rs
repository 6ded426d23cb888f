//! Search for the pose of one sample at which its lengths fit best.

use nalgebra::Vector3;

use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::Model;
use cdpr_model::scalar::ldl;

/// Degrees of freedom at most.
pub(super) const DOF: usize = 6;
/// Steps to a pose at most; near it each gains some four digits.
const STEPS: u32 = 60;
/// Last step to a pose, in standard deviations, relative to a larger norm of its residuals: Newton's method is at the pose to its square behind it.
const FOUND: f64 = 1e-6;
/// Share of the squares that the next step may still promise where a pose is sought no longer.
const NEAR: f64 = 1e-6;
/// Damping of the first step.
const DAMPING: f64 = 1e-3;
/// Damping from which on a pose is as good as it gets.
const MOST_DAMPING: f64 = 1e12;
/// Share of the last promise from which on steps of Gauss and Newton are slow, so that the bends of the lengths are worth their price. Far from the pose these lead
/// platforms that turn to places where they are upside down.
const SLOW: f64 = 0.01;
/// Longest turn of a step (rad), and its longest shift beside the mean length: a longer step says little about where it leads.
const LONGEST: f64 = 0.5;

/// Search for the pose of one sample: damped steps of Gauss and Newton while they are fast, of Newton from there.
pub(super) struct Search<'a> {
    pub(super) model: &'a Model,
    /// 1/σ_q (1/m).
    pub(super) per_length: f64,
    /// Lengths that its cables have (m).
    pub(super) recorded: &'a [f64],
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

/// A pose with the squares of its residuals.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) pose: Pose,
    pub(super) square: f64,
}

impl Search<'_> {
    /// The pose at which the lengths fit best, from one near it; `None` if the search does not settle.
    pub(super) fn find(&self, from: &Pose, directions: &[Twist]) -> Option<Found> {
        match directions.len() {
            0 => Some(Found { pose: *from, square: self.slope::<0>(from, &[]).square }),
            1 => self.find_in::<1>(from, directions.first_chunk()?),
            2 => self.find_in::<2>(from, directions.first_chunk()?),
            3 => self.find_in::<3>(from, directions.first_chunk()?),
            4 => self.find_in::<4>(from, directions.first_chunk()?),
            5 => self.find_in::<5>(from, directions.first_chunk()?),
            _ => self.find_in::<DOF>(from, directions.first_chunk()?),
        }
    }

    fn find_in<const N: usize>(&self, from: &Pose, directions: &[Twist; N]) -> Option<Found> {
        let turns = directions.map(|twist| twist.fixed_rows::<3>(3) != Vector3::zeros());
        let longest_shift = LONGEST * self.recorded.iter().sum::<f64>() / self.recorded.len() as f64;
        let (mut pose, mut here, mut damping) = (*from, self.slope(from, directions), DAMPING);
        let is_turning = turns.contains(&true);
        let (mut gain, mut is_bent) = (f64::INFINITY, !is_turning);
        for _ in 0..STEPS {
            let mut step = here.step(damping, is_bent)?;
            let is_whole = !(is_turning && shorten(&mut step, &turns, longest_shift));
            let promised: f64 = step.iter().zip(here.pull).map(|(step, pull)| step * pull).sum();
            is_bent |= is_whole && promised > SLOW * gain;
            gain = promised;
            let twist: Twist = directions.iter().zip(step).map(|(twist, amount)| twist * amount).sum();
            let trial = pose.displaced(&twist);
            if is_whole && gain <= FOUND * FOUND * here.square.max(1.0) {
                return Some(Found { pose: trial, square: here.square });
            }
            let there = self.slope(&trial, directions);
            if there.square <= here.square {
                (pose, here, damping) = (trial, there, 0.1 * damping);
            } else {
                damping = (10.0 * damping).max(DAMPING);
            }
            if damping > MOST_DAMPING {
                return Some(Found { pose, square: here.square });
            }
        }
        // near enough for parameters that are still far from their optimum
        (gain <= NEAR * here.square).then_some(Found { pose, square: here.square })
    }

    fn slope<const N: usize>(&self, pose: &Pose, directions: &[Twist; N]) -> Slope<N> {
        let mut slope = Slope { square: 0.0, pull: [0.0; N], plain: [[0.0; N]; N], bent: [[0.0; N]; N] };
        let turns = directions.map(|twist| twist.fixed_rows::<3>(3) != Vector3::zeros());
        let rotation = pose.rotation_rows();
        for (cable, recorded) in self.recorded.iter().enumerate() {
            let length = Length::of(self.model, cable, pose, &rotation, self.per_length);
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
    /// A damped step of Newton where it is `bent` by the lengths' second derivatives and these do not turn it uphill, else of Gauss and Newton.
    fn step(&self, damping: f64, is_bent: bool) -> Option<[f64; N]> {
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
        is_bent.then(|| solved(true)).flatten().or_else(|| solved(false))
    }
}

/// Shortens a step that is too long, in directions that are turns or not; true where it was.
fn shorten<const N: usize>(step: &mut [f64; N], turns: &[bool; N], longest_shift: f64) -> bool {
    let size = |of_turns: bool| {
        let own = step.iter().zip(turns).filter(|(_, turns)| **turns == of_turns);
        own.map(|(amount, _)| amount * amount).sum::<f64>().sqrt()
    };
    let excess = (size(true) / LONGEST).max(size(false) / longest_shift);
    if excess > 1.0 {
        step.iter_mut().for_each(|amount| *amount /= excess);
    }
    excess > 1.0
}

/// Length of a cable at a pose.
pub(super) struct Length {
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
    pub(super) fn of(model: &Model, cable: usize, pose: &Pose, rotation: &[[f64; 3]; 3], per_length: f64) -> Self {
        let (path, end) = model.path_at(cable, pose.position.into(), rotation);
        let recorded = model.recorded_length(cable, path.length);
        let factor = per_length * (model.recorded_length(cable, 1.0) - model.recorded_length(cable, 0.0));
        Self { direction: path.direction.into(), arm: end.moment_arm.into(), free: path.length, recorded, factor }
    }

    /// Changes with directions of the pose.
    pub(super) fn row(&self, directions: &[Twist]) -> [f64; DOF] {
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
