//! Lower bounds of payload and accelerations in a cell.
//!
//! The structure matrix is taken as Aᵀ(r) = T Aᵀ(c) + E + R: T = I + Σ δₐ Tₐ turns the columns of as many independent
//! cables as there are rows like their first-order change, E is what the other columns change besides, and R is what first
//! order leaves of all. W(r) contains w if T⁻¹ w lies in the set that tensions make with Aᵀ(c) + T⁻¹ (E + R), to which the
//! argument of the corners applies. With the cables of a facet among the independent ones, T moves this facet as a whole:
//! the bound is its exact slope, and terms of second order.

use nalgebra::{SMatrix, Vector3};

use super::demand::{Demand, along};
use super::face::{Course, Face, Rows};
use super::question::Capability;
use super::turning::Turning;
use crate::Point;
use cdpr_model::geometry::Wrench;

type Matrix = SMatrix<f64, 6, 6>;

/// Largest bound of |T − I| with which T is used.
const LARGEST_TURN: f64 = 0.5;
/// Part of a column, of length 1, that counts as independent of others.
const INDEPENDENT: f64 = 0.02;
/// Share of a wrench that is rounding.
const ROUNDING: f64 = 1e-12;

/// A cell with the changes of all cables in it.
pub(super) struct Cell<'a> {
    pub(super) courses: &'a [Course],
    pub(super) turnings: &'a [Turning],
    /// Half sides (m).
    pub(super) half: &'a Point,
    pub(super) faces: &'a [Face],
    /// Load at the centre.
    pub(super) load: Rows,
}

/// The transformation T with what it leaves.
struct Transformation {
    /// Tₐ along each axis (1/m).
    turns: [Matrix; 3],
    /// Bound of |T − I| in the cell.
    size: f64,
    /// ∂E/∂r along each axis, for each cable (1/m).
    left: Vec<[Rows; 3]>,
    /// Bound of |E f| for all tensions (N).
    left_size: f64,
    /// Bound of |R f| for all tensions (N).
    rest_size: f64,
}

impl Capability<'_> {
    /// Lower bound in a cell of a quantity that is `value` at the centre; −∞ where the load may not be held.
    pub(super) fn bound(&self, demand: &Demand, value: f64, cell: &Cell<'_>) -> f64 {
        let critical = cell.faces.iter().min_by(|a, b| a.allows(demand).total_cmp(&b.allows(demand)));
        let Some(critical) = critical else { return f64::NEG_INFINITY };
        let transformation = self.transformation(cell, critical);
        let needed = cell.load.norm() + value * demand.size(self.least_length());
        let mut least = value;
        for face in cell.faces {
            if self.is_far(demand, value, face, &transformation, needed) {
                continue;
            }
            let sum = self.sum_at(demand, face, cell, &transformation, needed);
            for added in demand.wrenches(&face.normal) {
                let added = self.scaled(&added);
                let at = |factor: f64| {
                    let wrench = cell.load + added * factor;
                    face.room - factor * face.scaled.dot(&added) - sum.loss(&wrench) - factor * sum.bent
                };
                // concave in the factor
                match (at(0.0), at(value)) {
                    (without, _) if without.is_nan() || without < 0.0 => return f64::NEG_INFINITY,
                    (_, with) if with >= 0.0 || self.takes_load_off(&cell.load, &added, value) => {}
                    (without, with) => least = least.min(value * without / (without - with)),
                }
            }
        }
        least
    }

    /// True if the sum of load and what is added is a part of the load, which slack cables and those that hold it balance
    /// at every pose: where no cable must be tight, down with the fall of gravity.
    fn takes_load_off(&self, load: &Rows, added: &Rows, value: f64) -> bool {
        let (size, by) = (load.norm(), added.norm());
        let is_opposite = (load * by + added * size).norm() <= ROUNDING * size * by;
        is_opposite && value * by <= size * (1.0 + ROUNDING) && self.limits.minimum().iter().all(|least| *least == 0.0)
    }

    /// True of a face that no change in the cell reaches.
    fn is_far(&self, demand: &Demand, value: f64, face: &Face, transformation: &Transformation, needed: f64) -> bool {
        let Transformation { size, left_size, rest_size, .. } = transformation;
        let all = (size * needed + left_size + rest_size) / (1.0 - size);
        face.room - value * demand.support(&face.normal).max(0.0) >= all
    }

    /// Everything that a face loses in a cell, before the wrench is known.
    fn sum_at(
        &self,
        demand: &Demand,
        face: &Face,
        cell: &Cell<'_>,
        transformation: &Transformation,
        needed: f64,
    ) -> Sum {
        let Transformation { turns, size, left, left_size, rest_size } = transformation;
        let axes = self.model.axes();
        let further = size / (1.0 - size);
        let mut sum = Sum {
            turned: std::array::from_fn(|axis| turns[axis].tr_mul(&face.scaled)),
            slope: [0.0; 3],
            spread: 0.0,
            half: *cell.half,
            bent: 0.0,
        };
        sum.spread += further * (size * needed + left_size + rest_size);
        for (cable, (course, turning)) in cell.courses.iter().zip(cell.turnings).enumerate() {
            let [least, largest] = self.tensions_on(face, cable);
            if largest > 0.0 {
                sum.spread += largest * along(&face.normal, &course.arm).norm() * turning.remainder;
            }
            for axis in 0..axes.len() {
                let slope = face.scaled.dot(&left[cable][axis]);
                sum.slope[axis] += 0.5 * (least + largest) * slope;
                sum.spread += cell.half[axis] * 0.5 * (largest - least) * slope.abs();
            }
        }
        if let Demand::Ball { .. } = demand {
            let normals = sum.turned.map(|rows| self.normal(&rows));
            let moves = normals.iter().zip(cell.half).map(|(normal, half)| half * demand.support(normal));
            let (moved, support) = (moves.sum::<f64>(), demand.support(&face.normal));
            sum.bent = if support > 0.0 { (0.5 * moved * moved / support).min(2.0 * moved) } else { moved };
        }
        sum
    }

    /// Tensions of a cable on a face (N): least and largest.
    fn tensions_on(&self, face: &Face, cable: usize) -> [f64; 2] {
        let (least, largest) = (self.limits.minimum()[cable], self.limits.maximum()[cable]);
        match (face.at_largest & (1 << cable) != 0, face.at_least & (1 << cable) != 0) {
            (true, _) => [largest; 2],
            (_, true) => [least; 2],
            _ => [least, largest],
        }
    }

    /// T with the free cables of a face among the independent ones; T = I where the cell is too large for it.
    fn transformation(&self, cell: &Cell<'_>, critical: &Face) -> Transformation {
        let rows = |direction: Vector3<f64>, arm: &Vector3<f64>| {
            let moment = arm.cross(&direction);
            self.scaled(&Wrench::new(direction.x, direction.y, direction.z, moment.x, moment.y, moment.z))
        };
        let axes = self.model.axes();
        let columns: Vec<Rows> =
            cell.courses.iter().map(|course| rows(course.path.direction.into(), &course.arm)).collect();
        let both = || cell.courses.iter().zip(cell.turnings);
        let slopes: Vec<[Rows; 3]> = both()
            .map(|(course, turning)| {
                let slope = |axis: &Vector3<f64>| rows(turning.gradient * axis, &course.arm);
                std::array::from_fn(|axis| axes.get(axis).map_or_else(Rows::zeros, slope))
            })
            .collect();
        let turns = self.turns(&columns, &slopes, critical);
        let size_of = |turns: &[Matrix; 3]| turns.iter().zip(cell.half).map(|(turn, half)| half * turn.norm()).sum();
        let size: f64 = turns.as_ref().map_or(f64::INFINITY, size_of);
        let is_small = size <= LARGEST_TURN;
        let turns = turns.filter(|_| is_small).unwrap_or([Matrix::zeros(); 3]);
        let left: Vec<[Rows; 3]> = columns
            .iter()
            .zip(&slopes)
            .map(|(column, slopes)| std::array::from_fn(|axis| slopes[axis] - turns[axis] * column))
            .collect();
        let largest = self.limits.maximum();
        let left_of = |left: &[Rows; 3]| left.iter().zip(cell.half).map(|(left, half)| half * left.norm()).sum::<f64>();
        let left_size = left.iter().zip(largest).map(|(left, most)| most * left_of(left)).sum();
        let length = self.least_length();
        let rest_of = |(course, turning): (&Course, &Turning)| {
            turning.remainder * (1.0 + (course.arm.norm() / length).powi(2)).sqrt()
        };
        let rest_size = both().map(rest_of).zip(largest).map(|(rest, most)| most * rest).sum();
        Transformation { turns, size: if is_small { size } else { 0.0 }, left, left_size, rest_size }
    }

    /// Tₐ along each axis; `None` if there are not as many independent columns as rows.
    fn turns(&self, columns: &[Rows], slopes: &[[Rows; 3]], critical: &Face) -> Option<[Matrix; 3]> {
        let dof = self.model.dof();
        let is_free = |cable: &usize| (critical.at_largest | critical.at_least) & (1 << *cable) == 0;
        let (free, fixed): (Vec<usize>, Vec<usize>) = (0..columns.len()).partition(is_free);
        let mut basis: Vec<Rows> = Vec::with_capacity(dof);
        let mut chosen = Vec::with_capacity(dof);
        for mut group in [free, fixed] {
            while chosen.len() < dof && !group.is_empty() {
                let remainder = |cable: usize| {
                    let unit = columns[cable].normalize();
                    basis.iter().fold(unit, |rest, axis| rest - axis * axis.dot(&rest))
                };
                let rests: Vec<Rows> = group.iter().map(|&cable| remainder(cable)).collect();
                let best = (0..group.len()).max_by(|&a, &b| rests[a].norm().total_cmp(&rests[b].norm()))?;
                if !(rests[best].norm() > INDEPENDENT) {
                    break;
                }
                basis.push(rests[best].normalize());
                chosen.push(group.swap_remove(best));
            }
        }
        if chosen.len() < dof {
            return None;
        }
        let mut own = Matrix::identity();
        chosen.iter().enumerate().for_each(|(place, &cable)| own.set_column(place, &columns[cable]));
        let inverse = own.try_inverse()?;
        Some(std::array::from_fn(|axis| {
            let mut change = Matrix::zeros();
            chosen.iter().enumerate().for_each(|(place, &cable)| change.set_column(place, &slopes[cable][axis]));
            change * inverse
        }))
    }
}

/// Losses of a face in a cell.
struct Sum {
    /// Tₐᵀ n along each axis.
    turned: [Rows; 3],
    /// Slope of n · E f by position, with the middle tension of free cables.
    slope: [f64; 3],
    /// Everything that has no sign (N).
    spread: f64,
    /// Half sides of the cell (m).
    half: Point,
    /// Further loss per unit of the quantity, since other directions of a ball come first.
    bent: f64,
}

impl Sum {
    /// Loss of room with a wrench (N).
    fn loss(&self, wrench: &Rows) -> f64 {
        let along = |axis: usize| self.half[axis] * (self.slope[axis] - self.turned[axis].dot(wrench)).abs();
        self.spread + (0..3).map(along).sum::<f64>()
    }
}
