//! One descent from one start, the starts to try after it, and the verdict on what was found.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};

use super::{Settings, Status};
use crate::geometry::{Pose, Twist};
use crate::model::{CableGroup, Model};
use crate::scalar::{Kernel, LANES, Lanes, cross, dispatch_narrow, dot, ldl};

/// A model with lengths to meet.
pub(super) struct Descent<'a> {
    model: &'a Model,
    lengths: &'a [f64],
    settings: &'a Settings,
    /// Given lengths, packed like the model's groups.
    targets: Vec<[f64; LANES]>,
    mean_length: f64,
    platform_radius: f64,
}

/// Steps that shrink less than this fraction make the descent use second derivatives.
const SLOW_CONTRACTION: f64 = 0.1;

/// Where one descent ended.
pub(super) struct End {
    pub(super) pose: Pose,
    pub(super) rms: f64,
    pub(super) iterations: u32,
    stop: Stop,
    /// Smallest pivot of the scaled normal equations: near 0 where lengths do not determine the pose.
    pivot_ratio: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Stop {
    Stationary,
    /// No shorter step helped, though the steps had not become small.
    Stalled,
    IterationLimit,
    /// The start itself has no valid lengths.
    Degenerate,
}

impl<'a> Descent<'a> {
    pub(super) fn new(model: &'a Model, lengths: &'a [f64], settings: &'a Settings) -> Self {
        let pack = |chunk: &[f64]| std::array::from_fn(|lane| chunk[lane.min(chunk.len() - 1)]);
        Self {
            model,
            lengths,
            settings,
            targets: lengths.chunks(LANES).map(pack).collect(),
            mean_length: lengths.iter().sum::<f64>() / lengths.len() as f64,
            platform_radius: model.platform_radius(),
        }
    }

    /// Descends from one start.
    pub(super) fn run(&self, start: &Pose) -> End {
        match self.model.dof() {
            2 => dispatch_narrow(Search::<2> { descent: self, start }),
            3 => dispatch_narrow(Search::<3> { descent: self, start }),
            _ => dispatch_narrow(Search::<6> { descent: self, start }),
        }
    }

    pub(super) fn residuals(&self, pose: &Pose) -> Vec<f64> {
        residuals(self.model, self.lengths, pose)
    }

    /// True when nothing suggests that another start would do better.
    pub(super) fn is_good(&self, end: &End) -> bool {
        end.stop == Stop::Stationary && end.rms <= self.good_residual()
    }

    fn is_square(&self) -> bool {
        self.model.cable_count() == self.model.dof()
    }

    fn exact_residual(&self) -> f64 {
        self.settings.length_tolerance * self.mean_length.max(1.0)
    }

    /// Measured lengths leave millimetres per metre; a wrong local minimum leaves more.
    fn good_residual(&self) -> f64 {
        if self.is_square() { self.exact_residual() } else { self.settings.suspicious_residual * self.mean_length }
    }

    /// Status and reason for the best end.
    pub(super) fn judge(&self, end: &End, restarts: u32) -> (Status, Option<String>) {
        let starts = restarts + 1;
        let rms = end.rms;
        match end.stop {
            Stop::Degenerate => (Status::NotConverged, Some(self.degenerate_reason(&end.pose))),
            _ if rms > self.settings.plausible_residual * self.mean_length => (
                Status::NotConverged,
                Some(format!(
                    "the best of {starts} starts leaves {rms:.3} m rms of {:.3} m mean length: these lengths do not belong to \
                     this robot; check order, units, scale and offset",
                    self.mean_length
                )),
            ),
            Stop::IterationLimit => (
                Status::NotConverged,
                Some(format!(
                    "the limit of {} iterations was reached; the residual is {rms:.3e} m rms",
                    self.settings.max_iterations
                )),
            ),
            _ if end.pivot_ratio < 1e-12 => (
                Status::Singular,
                Some("the structure matrix has lost rank: the pose can move while all cable lengths stay".to_owned()),
            ),
            _ if self.is_square() && rms > self.exact_residual() => (
                Status::NotConverged,
                Some(format!(
                    "the best of {starts} starts is a stationary point that leaves {rms:.3e} m rms; with as many cables as \
                     degrees of freedom only a vanishing residual is a solution, so no pose near it has these lengths"
                )),
            ),
            Stop::Stalled => (
                Status::NotConverged,
                Some(format!(
                    "no step lowers the residual of {rms:.3e} m rms any further, though the steps are not yet small"
                )),
            ),
            Stop::Stationary => (Status::Converged, None),
        }
    }

    fn degenerate_reason(&self, pose: &Pose) -> String {
        let cables = 0..self.model.cable_count();
        let found = cables.into_iter().find_map(|cable| self.model.course(cable, pose).err());
        found.map_or_else(
            || "the cable lengths cannot be computed at the start".to_owned(),
            |reason| format!("at the start, {reason}"),
        )
    }

    /// Starts to try after the guess: the home pose, then positions spread over the frame with turned platforms.
    ///
    /// Always the same for the same robot.
    pub(super) fn restart_poses(&self, guess: &Pose) -> impl Iterator<Item = Pose> {
        let home = self.model.robot().home_or_middle();
        let anchors = || self.model.robot().cables.iter().map(|cable| cable.frame_anchor);
        let min = anchors().fold(home.position, |a, b| a.inf(&b));
        let max = anchors().fold(home.position, |a, b| a.sup(&b));
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(0);
        let basis = self.model.twist_basis();
        let translations = self.model.robot().motion_pattern.translations();
        let turned_guess = Pose { position: guess.position, rotation: home.rotation };
        let scattered = (0..).map(move |index: u32| {
            // every other start keeps the home orientation: platforms seldom turn far
            let turn = if index.is_multiple_of(2) { 0.0 } else { 1.5 };
            let mut twist = Twist::zeros();
            for (axis, direction) in basis.iter().enumerate() {
                let share: f64 = rng.random_range(-0.5..0.5);
                let extent = direction.fixed_rows::<3>(0).dot(&(max - min));
                twist += direction * if axis < translations { share * extent } else { 2.0 * share * turn };
            }
            let middle = (min + max) * 0.5;
            let mut center = home;
            for direction in &basis[..translations] {
                let axis: Vector3<f64> = direction.fixed_rows::<3>(0).into();
                center.position += axis * axis.dot(&(middle - home.position));
            }
            center.displaced(&twist)
        });
        [home, turned_guess].into_iter().chain(scattered)
    }
}

/// Modelled minus given lengths at a pose (m); NaN where a cable has no course.
pub(super) fn residuals(model: &Model, lengths: &[f64], pose: &Pose) -> Vec<f64> {
    let residual =
        |(cable, length): (usize, &f64)| model.course(cable, pose).map_or(f64::NAN, |(c, _)| c.length - length);
    lengths.iter().enumerate().map(residual).collect()
}

pub(super) fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|x| x * x).sum::<f64>() / values.len() as f64).sqrt()
}

/// Sum of squares, gradient side and normal matrix at one pose, in the robot's N degrees of freedom.
struct Normal<const N: usize> {
    cost: f64,
    /// S ρ: minus the gradient, since ∂ρ/∂x = −Sᵀ.
    right: [f64; N],
    /// S Sᵀ, lower triangle.
    matrix: [[f64; N]; N],
}

/// The descent as a kernel over lanes of cables, for N degrees of freedom.
struct Search<'a, const N: usize> {
    descent: &'a Descent<'a>,
    start: &'a Pose,
}

impl<const N: usize> Kernel for Search<'_, N> {
    type Output = End;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> End {
        let settings = self.descent.settings;
        let tolerance = settings.pose_tolerance * self.descent.mean_length.max(1.0);
        let mut pose = *self.start;
        let mut normal = self.normal(lanes, &pose);
        let mut end = End { pose, rms: f64::NAN, iterations: 0, stop: Stop::IterationLimit, pivot_ratio: f64::NAN };
        if !normal.cost.is_finite() {
            return End { stop: Stop::Degenerate, ..end };
        }
        let mut damping = 0.0;
        let mut slow = false;
        let mut last_step = 0.0; // none yet: no rate of contraction to judge by
        while end.iterations < settings.max_iterations {
            end.iterations += 1;
            let matrix = if slow { self.with_curvature(&pose, &normal.matrix) } else { normal.matrix };
            let Some((step, size, ratio)) = self.step(&normal, matrix, damping) else {
                if damping > 1e6 {
                    // some direction moves no cable at all
                    end.stop = Stop::Stationary;
                    break;
                }
                damping = f64::max(10.0 * damping, 1e-6);
                continue;
            };
            end.pivot_ratio = if slow || damping > 0.0 { f64::NAN } else { ratio };
            let trial = displaced(&pose, &step);
            let next = self.normal(lanes, &trial);
            // rounding of the cost: equal costs near the optimum must not look like a failure
            if next.cost <= normal.cost * (1.0 + 1e-12) + 1e-29 * self.descent.mean_length * self.descent.mean_length {
                let contraction = size / last_step;
                (pose, normal, last_step) = (trial, next, size);
                slow = contraction.is_finite() && contraction > SLOW_CONTRACTION;
                damping = if damping < 1e-9 { 0.0 } else { damping * 0.1 };
                // what the remaining steps add up to if they go on shrinking at this rate
                if contraction < 0.5 && size * contraction <= tolerance * (1.0 - contraction)
                    || size <= 1e-3 * tolerance
                {
                    end.stop = Stop::Stationary;
                    break;
                }
            } else if size <= tolerance {
                end.stop = Stop::Stationary;
                break;
            } else if damping > 1e12 {
                end.stop = Stop::Stalled;
                break;
            } else {
                damping = f64::max(10.0 * damping, 1e-3);
                slow = true;
            }
        }
        if end.pivot_ratio.is_nan() {
            // neither damping nor curvature may hide that lengths do not determine the pose
            end.pivot_ratio = self.step(&normal, normal.matrix, 0.0).map_or(0.0, |(_, _, ratio)| ratio);
        }
        let count = self.descent.lengths.len() as f64;
        End { pose, rms: (normal.cost / count).sqrt(), ..end }
    }
}

impl<const N: usize> Search<'_, N> {
    /// Normal equations at a pose: one pass over the cables, eight at a time.
    #[inline(always)]
    fn normal<L: Lanes>(&self, lanes: L, pose: &Pose) -> Normal<N> {
        let rotation = pose.rotation_rows();
        let mut normal = Normal { cost: 0.0, right: [0.0; N], matrix: [[0.0; N]; N] };
        for (group, targets) in self.descent.model.groups().iter().zip(&self.descent.targets) {
            self.add_group(lanes, group, targets, pose, &rotation, &mut normal);
        }
        normal
    }

    #[inline(always)]
    fn add_group<L: Lanes>(
        &self,
        lanes: L,
        group: &CableGroup,
        targets: &[f64; LANES],
        pose: &Pose,
        rotation: &[[f64; 3]; 3],
        normal: &mut Normal<N>,
    ) {
        let (course, lever) = group.courses(lanes, pose.position.into(), rotation);
        let weight = lanes.load(&group.weight);
        let residual = (course.length - lanes.load(targets)) * weight;
        let u = course.direction.map(|x| x * weight);
        let rows = self.in_basis(lanes, u, cross(lever, u));
        normal.cost += (residual * residual).sum();
        for i in 0..N {
            normal.right[i] += (rows[i] * residual).sum();
            for j in 0..=i {
                normal.matrix[i][j] += (rows[i] * rows[j]).sum();
            }
        }
    }

    /// The normal matrix plus Σ ρ ∂²q/∂x²: Gauss–Newton becomes Newton.
    ///
    /// With dp = v + ω × b and D = ∂u/∂p_B: ∂²q = −dpᵀ D dp − (u·ω)(b·ω) + (u·b) ω·ω. Lengths that do not fit the robot
    /// leave residuals large enough for this to decide how fast, and whether, the descent arrives.
    fn with_curvature(&self, pose: &Pose, matrix: &[[f64; N]; N]) -> [[f64; N]; N] {
        let model = self.descent.model;
        let mut matrix = *matrix;
        for (cable, target) in self.descent.lengths.iter().enumerate() {
            let Ok((course, b)) = model.course(cable, pose) else { continue };
            let residual = course.length - target;
            let u = Vector3::from(course.direction);
            let gradient = nalgebra::Matrix3::from_fn(|row, column| course.direction_gradient[row][column]);
            let parts = |k: usize| {
                let (v, omega): (Vector3<f64>, Vector3<f64>) = (
                    model.twist_basis()[k].fixed_rows::<3>(0).into(),
                    model.twist_basis()[k].fixed_rows::<3>(3).into(),
                );
                (v + omega.cross(&b), omega)
            };
            for i in 0..N {
                let (motion_i, omega_i) = parts(i);
                for j in 0..=i {
                    let (motion_j, omega_j) = parts(j);
                    let mixed = 0.5 * (u.dot(&omega_i) * b.dot(&omega_j) + u.dot(&omega_j) * b.dot(&omega_i));
                    let curvature = -motion_i.dot(&(gradient * motion_j)) - mixed + u.dot(&b) * omega_i.dot(&omega_j);
                    matrix[i][j] += residual * curvature;
                }
            }
        }
        matrix
    }

    /// Columns [u; b × u] in the robot's degrees of freedom.
    #[inline(always)]
    fn in_basis<L: Lanes>(&self, lanes: L, u: [L; 3], moment: [L; 3]) -> [L; N] {
        if N == 6 {
            return std::array::from_fn(|row| if row < 3 { u[row] } else { moment[row - 3] });
        }
        let basis = self.descent.model.twist_basis();
        std::array::from_fn(|row| {
            let constants = |first: usize| std::array::from_fn(|k| lanes.constant(basis[row][first + k]));
            dot(constants(0), u) + dot(constants(3), moment)
        })
    }

    /// Damped step as a twist, its size (m; angles times the platform radius) and the pivot ratio of `matrix`, which is
    /// the normal matrix or that with curvature.
    #[inline(always)]
    fn step(&self, normal: &Normal<N>, mut matrix: [[f64; N]; N], damping: f64) -> Option<(Twist, f64, f64)> {
        let mut step = normal.right;
        for k in 0..N {
            matrix[k][k] += damping * normal.matrix[k][k];
        }
        let ratio = ldl::solve(&mut matrix, &mut step)?;
        let mut twist = Twist::zeros();
        if N == 6 {
            twist.as_mut_slice().copy_from_slice(&step);
        } else {
            for (direction, amount) in self.descent.model.twist_basis().iter().zip(step) {
                twist += direction * amount;
            }
        }
        let turn = twist.fixed_rows::<3>(3).norm();
        let shift = twist.fixed_rows::<3>(0).norm();
        // a step that turns the platform by more than half a radian says little about where it leads
        let shorten = f64::min(1.0, 0.5 / turn.max(shift / self.descent.mean_length));
        if shorten < 1.0 {
            twist *= shorten;
        }
        let radius = self.descent.platform_radius;
        Some((twist, shorten * (shift * shift + radius * radius * turn * turn).sqrt(), ratio))
    }
}

/// The pose after a step; the turn (1, ω/2) normalised equals exp(ω) to third order and needs no sine.
#[inline(always)]
fn displaced(pose: &Pose, twist: &Twist) -> Pose {
    let half = twist.fixed_rows::<3>(3) * 0.5;
    let turn = Quaternion::new(1.0, half[0], half[1], half[2]);
    let rotation = UnitQuaternion::new_normalize(turn * pose.rotation.quaternion());
    Pose { position: pose.position + twist.fixed_rows::<3>(0), rotation }
}
