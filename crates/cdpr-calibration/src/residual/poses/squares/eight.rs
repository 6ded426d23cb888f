//! Eight platforms held by springs of 1 N/m in place of their cables: where they come to rest, and how that place moves.

use super::cable::{Cable, Column, MOST_CABLES, PoseLines};
use cdpr_model::cable::CablePath;
use cdpr_model::cable::wrench::{moment_columns, turned_row, wrench};
use cdpr_model::equilibrium::turned;
use cdpr_model::geometry::{POSE_ROWS, rotation_rows};
use cdpr_model::scalar::{LANES, Lanes, add, constants, cross, dot, ldl, rotate, rotate_back, scale, sub};

/// Newton steps from one place.
const STEPS: usize = 8;

/// Product of two steps, a Newton step and itself or the chord after it, over the square of the mean length, that ends the way: what is left is some 1e-11 of
/// that length, a tenth of a nanometre for ten metres, after the long steps of a fit, and rounding after its last ones.
const SETTLED: f64 = 1e-11;

/// Newton step, over the mean length, before which the stiffness is good enough for derivatives behind it.
const NEAR: f64 = 1e-5;

/// Neutral element of sums, to the bit. Lanes of zeros would be cleared by a function, before which all registers go to the stack.
const NOTHING: f64 = -0.0;

/// Eight poses with the cables there.
pub(super) struct Eight<L> {
    l: L,
    pub(super) pose: [L; POSE_ROWS],
    /// Rotation at which the cables were asked for last.
    rotation: [[L; 3]; 3],
    cables: [At<L>; MOST_CABLES],
    /// Factors of the stiffness of the platforms with these cables.
    factor: [[L; 6]; 6],
    inverse_pivot: [L; 6],
}

/// A cable at eight poses.
#[derive(Clone, Copy)]
struct At<L> {
    /// Length and its residual beside the controlled one, which is the tension of the spring (m).
    controlled: L,
    residual: L,
    moment_arm: [L; 3],
    direction: [L; 3],
    direction_gradient: [[L; 3]; 3],
    length_by_radius: L,
    direction_by_radius: [L; 3],
}

/// Sums over the cables.
struct Springs<L> {
    /// Wrench of the springs (N, N·m).
    wrench: [L; 6],
    /// Σ ρ² and Σ q (m², m).
    squares: L,
    lengths: L,
    /// 1 where a cable may have no path.
    needs_scalar: L,
}

impl<L: Lanes> Eight<L> {
    /// Nowhere yet.
    #[inline(always)]
    pub(super) fn new(l: L) -> Self {
        let none = At {
            controlled: l,
            residual: l,
            moment_arm: [l; 3],
            direction: [l; 3],
            direction_gradient: [[l; 3]; 3],
            length_by_radius: l,
            direction_by_radius: [l; 3],
        };
        Self {
            l,
            pose: [l; POSE_ROWS],
            rotation: [[l; 3]; 3],
            cables: [none; MOST_CABLES],
            factor: [[l; 6]; 6],
            inverse_pivot: [l; 6],
        }
    }

    /// Goes to these poses.
    #[inline(always)]
    pub(super) fn load(&mut self, from: &PoseLines) {
        for row in 0..POSE_ROWS {
            self.pose[row] = self.l.load(&from[row].0);
        }
    }

    #[inline(always)]
    pub(super) fn store(&self, to: &mut PoseLines) {
        for row in 0..POSE_ROWS {
            self.pose[row].store(&mut to[row].0);
        }
    }

    /// Moves to the poses that belong to a change of the parameters, to first order.
    #[inline(always)]
    pub(super) fn follow(&mut self, derivatives: &[Column], change: &[f64], units: &[f64; 6], count: usize) {
        let l = self.l;
        let mut twist = [l.constant(0.0); 6];
        for (column, change) in derivatives.iter().zip(change) {
            let change = l.constant(*change);
            for row in 0..6 {
                twist[row] = twist[row] + l.load(&column[row].0) * change;
            }
        }
        for row in 0..6 {
            twist[row] = twist[row] * l.constant(1.0 / units[row]);
        }
        self.pose = turned(self.pose, &twist);
        if count < LANES {
            // copies of the last sample weigh nothing, and follow it
            for row in 0..POSE_ROWS {
                let mut numbers = self.pose[row].to_array();
                let last = numbers[count - 1];
                numbers[count..].fill(last);
                self.pose[row] = l.load(&numbers);
            }
        }
    }

    /// Comes to rest; false where that is not plain. Factors and cables are those of a place that is a small step away.
    #[inline(always)]
    pub(super) fn settle(&mut self, cables: &[Cable], group: usize, plausible: f64) -> bool {
        let l = self.l;
        let count = l.constant(cables.len() as f64);
        let everywhere = |lanes| !l.any(l.without(l.everywhere(true), lanes));
        for _ in 0..STEPS {
            let springs = self.visit::<true>(cables, group);
            self.write_stiffness(cables.len());
            let (is_regular, inverse_pivot) = ldl::factorize_in_lanes(6, &mut self.factor);
            self.inverse_pivot = inverse_pivot;
            let mean = springs.lengths / count;
            // rms ≤ plausible · mean, written so that NaN is refused too
            let most = l.constant(plausible * plausible) * mean * mean * count;
            let is_plain = l.without(springs.squares.is_less(most), l.constant(0.5).is_less(springs.needs_scalar));
            if !everywhere(l.both(is_plain, l.constant(0.5).is_less(is_regular))) {
                return false;
            }
            let first = self.step(springs.wrench);
            let limit = mean * mean * l.constant(SETTLED);
            if everywhere(first.is_less(limit)) {
                return true;
            }
            let chord = self.visit::<false>(cables, group).wrench;
            let second = self.step(chord);
            let is_near = first.is_less(mean * mean * l.constant(NEAR * NEAR));
            if everywhere(l.both(is_near, (first * second).is_less(limit * limit))) {
                return true;
            }
        }
        false
    }

    /// Steps to where a wrench vanishes with the stiffness; the square of the step (m², a radian as a metre).
    #[inline(always)]
    fn step(&mut self, mut amounts: [L; 6]) -> L {
        self.solve(&mut amounts);
        self.pose = turned(self.pose, &amounts);
        let mut square = amounts[0] * amounts[0];
        for row in 1..6 {
            square = square + amounts[row] * amounts[row];
        }
        square
    }

    /// Steps of the platforms with wrenches on them.
    #[inline(always)]
    fn solve(&self, right: &mut [L; 6]) {
        ldl::substitute(6, &self.factor, &self.inverse_pivot, right);
    }

    /// Sums over the cables at the poses, and with `KEEP` the cables themselves.
    #[inline(always)]
    fn visit<const KEEP: bool>(&mut self, cables: &[Cable], group: usize) -> Springs<L> {
        let l = self.l;
        let zero = l.constant(0.0);
        let [x, y, z, i, j, k, w] = self.pose;
        let rotation = rotation_rows([i, j, k, w]);
        let mut sums = Springs { wrench: [zero; 6], squares: zero, lengths: zero, needs_scalar: zero };
        for (place, cable) in cables.iter().enumerate() {
            let values = &cable.values;
            let moment_arm = rotate(&rotation, constants(l, values.platform_anchor));
            let anchor = add([x, y, z], moment_arm);
            let outlet = values.outlet.map(|number| l.constant(*number));
            let path: CablePath<L> = outlet.path(anchor);
            let recorded = l.load(&cable.recorded()[group * LANES..]);
            let controlled = (recorded - l.constant(values.offset)) * l.constant(cable.per_scale);
            let residual = path.length - controlled;
            let pull = wrench(moment_arm, path.direction);
            for row in 0..6 {
                sums.wrench[row] = sums.wrench[row] + residual * pull[row];
            }
            if KEEP {
                sums.squares = sums.squares + residual * residual;
                sums.lengths = sums.lengths + path.length;
                let no_length = zero.select(zero.is_less(controlled), l.constant(1.0));
                sums.needs_scalar = sums.needs_scalar.max(outlet.needs_scalar(anchor, &path)).max(no_length);
                self.cables[place] = At {
                    controlled,
                    residual,
                    moment_arm,
                    direction: path.direction,
                    direction_gradient: path.direction_gradient,
                    length_by_radius: path.length_by_radius,
                    direction_by_radius: path.direction_by_radius,
                };
            }
        }
        if KEEP {
            self.rotation = rotation;
        }
        sums
    }

    /// Writes −∂W/∂\[δr; δφ\] of the springs' wrench W, its symmetric part, lower triangle: Σ s sᵀ + ρ ∂²q/∂x² with s = \[u; b × u\].
    #[inline(always)]
    fn write_stiffness(&mut self, cables: usize) {
        let nothing = self.l.constant(NOTHING);
        let [mut of_forces, mut mixed, mut of_moments] = [[[nothing; 3]; 3]; 3];
        let half = self.l.constant(0.5);
        for at in &self.cables[..cables] {
            let (b, s, pull) = (at.moment_arm, wrench(at.moment_arm, at.direction), scale(at.residual, at.direction));
            let mut bend = at.direction_gradient;
            for row in 0..3 {
                bend[row] = scale(at.residual, bend[row]);
            }
            let (columns, along) = (moment_columns(&bend, b), dot(b, pull));
            for i in 0..3 {
                let row = turned_row(&columns, b, i);
                for j in 0..=i {
                    let turn = half * (b[i] * pull[j] + b[j] * pull[i]);
                    let turn = if i == j { turn - along } else { turn };
                    of_forces[i][j] = of_forces[i][j] + (s[i] * s[j] - bend[i][j]);
                    of_moments[i][j] = of_moments[i][j] + (s[3 + i] * s[3 + j] - (row[j] + turn));
                }
                for j in 0..3 {
                    mixed[i][j] = mixed[i][j] + (s[3 + i] * s[j] - columns[j][i]);
                }
            }
        }
        for i in 0..3 {
            self.factor[i][..3].copy_from_slice(&of_forces[i]);
            self.factor[3 + i][..3].copy_from_slice(&mixed[i]);
            self.factor[3 + i][3..].copy_from_slice(&of_moments[i]);
        }
    }

    /// Tells the changes of some numbers with the parameters of a cable, from those with a wrench: which parameter, which number, its change.
    #[inline(always)]
    pub(super) fn by_parameters<const N: usize>(
        &self,
        place: usize,
        by_wrench: &[[L; 6]; N],
        cable: &Cable,
        mut tell: impl FnMut(usize, usize, L),
    ) {
        let at = &self.cables[place];
        let per_scale = self.l.constant(cable.per_scale);
        let has_platform_anchor = cable.places.iter().any(|slot| (3..6).contains(slot));
        let has_length = cable.places.iter().any(|slot| *slot >= 6);
        let pull_by_anchor = at.pull_by_anchor();
        // the most common places come without a choice
        let (anchors, others) = match *cable.places {
            [0, 1, 2, ref others @ ..] => (3, others),
            ref all => (0, all),
        };
        for (row, &[x, y, z, a, b, c]) in by_wrench.iter().enumerate() {
            let turn = [a, b, c];
            // by a pull at the platform anchor
            let by_pull = add([x, y, z], cross(turn, at.moment_arm));
            let by_anchor = rotate(&pull_by_anchor, by_pull);
            let (mut in_platform, mut along) = (by_anchor, at.residual);
            if has_platform_anchor {
                let lever = sub(scale(at.residual, cross(at.direction, turn)), by_anchor);
                in_platform = rotate_back(&self.rotation, lever);
            }
            if has_length {
                along = dot(by_pull, at.direction);
            }
            for axis in 0..anchors {
                tell(axis, row, by_anchor[axis]);
            }
            for (index, slot) in (anchors..).zip(others) {
                // numbers that are chosen by a constant stay in registers
                let change = match slot {
                    0 => by_anchor[0],
                    1 => by_anchor[1],
                    2 => by_anchor[2],
                    3 => in_platform[0],
                    4 => in_platform[1],
                    5 => in_platform[2],
                    6 => along * per_scale,
                    7 => along * per_scale * at.controlled,
                    _ => along * at.length_by_radius + at.residual * dot(by_pull, at.direction_by_radius),
                };
                tell(index, row, change);
            }
        }
    }

    /// Change of half the sum of the squared residuals with a wrench on the platform.
    #[inline(always)]
    pub(super) fn half_squares_by_wrench(&self, by_turn: &[[L; 3]; 3], weighted: &[L; 6]) -> [L; 6] {
        let [x, y, z, a, b, c] = *weighted;
        let [turned_x, turned_y, turned_z] = rotate_back(by_turn, [a, b, c]);
        let mut by_wrench = [x, y, z, turned_x, turned_y, turned_z];
        self.solve(&mut by_wrench);
        by_wrench
    }

    /// Changes of the six residuals with a wrench on the platform, by rows.
    #[inline(always)]
    pub(super) fn by_wrench(&self, by_turn: &[[L; 3]; 3], weights: &[L; 6]) -> [[L; 6]; 6] {
        let mut rows = [[weights[0].constant(NOTHING); 6]; 6];
        for k in 0..3 {
            rows[k][k] = weights[k];
            for column in 0..3 {
                rows[3 + k][3 + column] = weights[3 + k] * by_turn[k][column];
            }
        }
        for row in &mut rows {
            self.solve(row);
        }
        rows
    }
}

impl<L: Lanes> At<L> {
    /// Change of the pull ρ u on the platform with the frame anchor, symmetric: u uᵀ − ρ ∂u/∂b.
    #[inline(always)]
    fn pull_by_anchor(&self) -> [[L; 3]; 3] {
        let (u, gradient) = (self.direction, &self.direction_gradient);
        let mut by_anchor = *gradient;
        for i in 0..3 {
            for j in 0..3 {
                by_anchor[i][j] = u[i] * u[j] - self.residual * gradient[i][j];
            }
        }
        by_anchor
    }
}
