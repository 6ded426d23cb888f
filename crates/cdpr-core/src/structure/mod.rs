//! Lengths and structure matrix Aᵀ of all cables at one pose, a cable per lane, into memory of the caller.

mod group;

pub use group::{CableGroup, CablePathInLanes};

use crate::cable::wrench::wrench;
use crate::geometry::{Twist, Wrench};
use crate::scalar::{Kernel, LANES, Lanes, Real};

/// Kernel of the geometric lengths q of all cables at a pose (m); returns false if a cable may have no path, and its
/// length is then meaningless.
#[derive(Debug)]
pub struct Lengths<'a> {
    /// Cables, eight per group.
    pub groups: &'a [CableGroup],
    /// r (world, m).
    pub position: [f64; 3],
    /// R by rows.
    pub rotation: &'a [[f64; 3]; 3],
    /// q of every cable, m numbers.
    pub lengths: &'a mut [f64],
}

impl Kernel for Lengths<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> bool {
        let zero = lanes.constant(0.0);
        let mut needs_scalar = zero;
        for (group, target) in self.groups.iter().zip(self.lengths.chunks_mut(LANES)) {
            let cables = group.checked_paths(lanes, self.position, self.rotation);
            needs_scalar = needs_scalar + cables.needs_scalar;
            write(&cables.path.length.to_array(), target);
        }
        !lanes.any(zero.is_less(needs_scalar))
    }
}

/// Kernel of the structure matrix Aᵀ at a pose, column by column \[u; b × u\] in the degrees of freedom; returns false
/// if a cable may have no path, and its numbers are then meaningless.
#[derive(Debug)]
pub struct StructureColumns<'a> {
    /// Cables, eight per group.
    pub groups: &'a [CableGroup],
    /// Twists of the n degrees of freedom.
    pub basis: &'a [Twist],
    /// r (world, m).
    pub position: [f64; 3],
    /// R by rows.
    pub rotation: &'a [[f64; 3]; 3],
    /// n × m numbers, cable by cable.
    pub columns: &'a mut [f64],
}

impl Kernel for StructureColumns<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> bool {
        let zero = lanes.constant(0.0);
        let mut needs_scalar = zero;
        let n = self.basis.len();
        for (group, target) in self.groups.iter().zip(self.columns.chunks_mut(LANES * n)) {
            let cables = group.checked_paths(lanes, self.position, self.rotation);
            needs_scalar = needs_scalar + cables.needs_scalar;
            let rows = in_pattern(self.basis, wrench(cables.moment_arm, cables.path.direction));
            let mut numbers = [[0.0; LANES]; 6];
            for row in 0..6 {
                numbers[row] = rows[row].to_array();
            }
            for (lane, column) in target.chunks_exact_mut(n).enumerate() {
                for (row, entry) in column.iter_mut().enumerate() {
                    *entry = numbers[row][lane];
                }
            }
        }
        !lanes.any(zero.is_less(needs_scalar))
    }
}

/// Kernel of cables in motion: lengths, tensions of linear laws continued below zero, and the wrench of the cables that
/// pull; `None` if a cable may have no path, and the numbers are then meaningless, as are tensions and wrench of cables
/// without a linear law. Lists have eight numbers per group.
#[derive(Debug)]
pub struct Pulls<'a> {
    /// Cables, eight per group.
    pub groups: &'a [CableGroup],
    /// r (world, m).
    pub position: [f64; 3],
    /// R by rows.
    pub rotation: &'a [[f64; 3]; 3],
    /// Unstrained lengths (m).
    pub unstrained: &'a [f64],
    /// 1 for a whole cable, 0 for a broken one and for a copy that fills a group.
    pub whole: &'a [f64],
    /// q of every cable (m).
    pub lengths: &'a mut [f64],
    /// Tensions (N).
    pub tensions: &'a mut [f64],
    /// ∂f/∂q (N/m).
    pub stiffnesses: &'a mut [f64],
    /// \[u; b × u\] of every cable (world), m columns; empty if they are not needed.
    pub columns: &'a mut [[f64; 6]],
}

impl Kernel for Pulls<'_> {
    type Output = Option<Wrench>;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Option<Wrench> {
        let zero = lanes.constant(0.0);
        let (mut needs_scalar, mut sum) = (zero, [zero; 6]);
        let asks_columns = !self.columns.is_empty();
        for (index, group) in self.groups.iter().enumerate() {
            let start = index * LANES;
            let cables = group.checked_paths(lanes, self.position, self.rotation);
            needs_scalar = needs_scalar + cables.needs_scalar;
            let length = cables.path.length;
            let tension = group.elasticity(lanes).tension(length, lanes.load(&self.unstrained[start..]));
            length.store(&mut self.lengths[start..]);
            tension.value.store(&mut self.tensions[start..]);
            tension.by_length.store(&mut self.stiffnesses[start..]);
            let pull = tension.value.max(zero) * lanes.load(&self.whole[start..]);
            let rows = wrench(cables.moment_arm, cables.path.direction);
            for row in 0..6 {
                sum[row] = sum[row] + pull * rows[row];
            }
            if asks_columns {
                for row in 0..6 {
                    let numbers = rows[row].to_array();
                    for (lane, column) in self.columns[start..].iter_mut().take(LANES).enumerate() {
                        column[row] = numbers[lane];
                    }
                }
            }
        }
        let [x, y, z, a] = L::sums([sum[0], sum[1], sum[2], sum[3]]);
        let [b, c, ..] = L::sums([sum[4], sum[5], zero, zero]);
        (!lanes.any(zero.is_less(needs_scalar))).then(|| Wrench::new(x, y, z, a, b, c))
    }
}

/// Writes the first of eight numbers, as many as `target` has room for.
#[inline]
fn write(numbers: &[f64; LANES], target: &mut [f64]) {
    match <&mut [f64; LANES]>::try_from(&mut *target) {
        Ok(all) => *all = *numbers,
        Err(_) => target.copy_from_slice(&numbers[..target.len()]),
    }
}

/// A wrench in the robot's degrees of freedom (the first n entries), with the bits of nalgebra's products, whose sums
/// start at zero.
#[inline(always)]
pub fn in_pattern<T: Real>(basis: &[Twist], wrench: [T; 6]) -> [T; 6] {
    let zero = wrench[0].constant(0.0);
    let mut column = [zero; 6];
    if basis.len() == 6 {
        for row in 0..6 {
            column[row] = zero + wrench[row];
        }
        return column;
    }
    for (sum, twist) in column.iter_mut().zip(basis) {
        for row in 0..6 {
            *sum = *sum + zero.constant(twist[row]) * wrench[row];
        }
    }
    column
}
