//! Poses as the rows of an array, as tables and other languages hold them.

use thiserror::Error;

use super::pose_batch::{POSE_ROWS, PoseBatch};
use crate::scalar::{Kernel, LANES, Lanes, Line, SINE_LIMIT, dispatch, has_room, load_items, sin_cos};

/// Norms of quaternions that differ from one by more are refused.
const NORM_TOLERANCE: f64 = 1e-6;
/// Squared norms that differ from one by less are those of unit quaternions, as products leave them: their bits are kept.
const ROUNDED: f64 = 1e-14;

/// Poses of an array, a row each: positions in the world (m) with rotations from the platform into the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PoseRows<'a> {
    /// x, y, z, then the quaternion qx, qy, qz, qw.
    Quaternions(&'a [[f64; 7]]),
    /// x, y, z, then the angles φx, φy, φz of R = Rx(φx) Ry(φy) Rz(φz) (rad).
    Angles(&'a [[f64; 6]]),
}

/// A row that is no pose; rows count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PoseRowError {
    /// A quaternion that is no rotation.
    #[error(
        "row {row}: the quaternion has the norm {norm:.9}, and a rotation has 1 (within 1e-6): are columns missing or swapped?"
    )]
    Norm {
        /// The row.
        row: usize,
        /// Norm of its quaternion.
        norm: f64,
    },
    /// A number that is NaN or infinite.
    #[error("row {row}: column {column} is {number}")]
    NotFinite {
        /// The row.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// The number.
        number: f64,
    },
    /// An angle of more than 80 000 turns.
    #[error("row {row}: {angle} rad is no angle that a platform turns by")]
    Angle {
        /// The row.
        row: usize,
        /// The angle (rad).
        angle: f64,
    },
}

impl PoseRowError {
    /// The error of the row that stands this many further down in the whole array.
    #[must_use]
    pub fn behind(mut self, rows: usize) -> Self {
        match &mut self {
            Self::Norm { row, .. } | Self::NotFinite { row, .. } | Self::Angle { row, .. } => *row += rows,
        }
        self
    }
}

impl<'a> From<&'a [[f64; 7]]> for PoseRows<'a> {
    fn from(rows: &'a [[f64; 7]]) -> Self {
        Self::Quaternions(rows)
    }
}

impl<'a> From<&'a [[f64; 6]]> for PoseRows<'a> {
    fn from(rows: &'a [[f64; 6]]) -> Self {
        Self::Angles(rows)
    }
}

impl<'a> PoseRows<'a> {
    /// Number of poses.
    pub fn len(&self) -> usize {
        match self {
            Self::Quaternions(rows) => rows.len(),
            Self::Angles(rows) => rows.len(),
        }
    }

    /// True without poses.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The rows from `first` on, at most `count`; panics if there is no row `first`.
    pub fn part(&self, first: usize, count: usize) -> PoseRows<'a> {
        let end = self.len().min(first + count);
        match self {
            Self::Quaternions(rows) => PoseRows::Quaternions(&rows[first..end]),
            Self::Angles(rows) => PoseRows::Angles(&rows[first..end]),
        }
    }

    /// The first row that is no pose, as an error.
    pub fn check(&self) -> Result<(), PoseRowError> {
        self.refuse().map_or(Ok(()), Err)
    }

    fn refuse(&self) -> Option<PoseRowError> {
        (0..self.len()).find_map(|row| {
            let (numbers, turn): (&[f64], _) = match self {
                Self::Quaternions(rows) => (&rows[row], Turn::Quaternion),
                Self::Angles(rows) => (&rows[row], Turn::Angles),
            };
            if let Some(column) = numbers.iter().position(|number| !number.is_finite()) {
                return Some(PoseRowError::NotFinite { row, column, number: numbers[column] });
            }
            match turn {
                Turn::Quaternion => {
                    let norm = numbers[3..].iter().map(|entry| entry * entry).sum::<f64>().sqrt();
                    ((norm - 1.0).abs() >= NORM_TOLERANCE).then_some(PoseRowError::Norm { row, norm })
                }
                Turn::Angles => {
                    let large = numbers[3..].iter().find(|angle| angle.abs() >= SINE_LIMIT);
                    large.map(|&angle| PoseRowError::Angle { row, angle })
                }
            }
        })
    }
}

/// Rotation of a row.
#[derive(Clone, Copy)]
enum Turn {
    Quaternion,
    Angles,
}

impl PoseBatch {
    /// Takes the poses of an array; memory that was claimed once is kept.
    ///
    /// Quaternions are normalised (those of unit norm keep their bits); the batch is unspecified after an error. Sines and cosines are
    /// within 2.3e-16 of those of [`Pose::from_xyz_angles`](super::Pose::from_xyz_angles).
    ///
    /// ```
    /// use cdpr::geometry::{Pose, PoseBatch, PoseRowError};
    ///
    /// let mut batch = PoseBatch::default();
    /// batch.fill_rows(&[[1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0]][..])?;
    /// assert_eq!(batch.get(0).position.z, 3.0);
    /// batch.fill_rows(&[[1.0, 2.0, 3.0, 0.1, 0.0, 0.0]][..])?;
    /// assert!((batch.get(0).xyz_angles()[0] - 0.1).abs() < 1e-15);
    /// let no_rotation = batch.fill_rows(&[[1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.5]][..]);
    /// assert_eq!(no_rotation, Err(PoseRowError::Norm { row: 0, norm: 0.5 }));
    /// # Ok::<(), PoseRowError>(())
    /// ```
    pub fn fill_rows<'a>(&mut self, rows: impl Into<PoseRows<'a>>) -> Result<(), PoseRowError> {
        let rows = rows.into();
        self.table_mut().resize(rows.len());
        let all_are_poses = dispatch(Fill { rows, lines: self.table_mut().lines_mut() });
        if all_are_poses {
            return Ok(());
        }
        rows.check()
    }
}

/// Poses of rows, put side by side; false unless all of them are poses.
struct Fill<'a> {
    rows: PoseRows<'a>,
    lines: &'a mut [Line],
}

impl Kernel for Fill<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> bool {
        match self.rows {
            PoseRows::Quaternions(rows) => fill::<L, 7>(lanes, rows, self.lines, Turn::Quaternion),
            PoseRows::Angles(rows) => fill::<L, 6>(lanes, rows, self.lines, Turn::Angles),
        }
    }
}

#[inline(always)]
fn fill<L: Lanes, const N: usize>(lanes: L, rows: &[[f64; N]], lines: &mut [Line], turn: Turn) -> bool {
    let mut all_are_poses = true;
    let numbers = rows.as_flattened();
    for (group, lines) in lines.chunks_exact_mut(POSE_ROWS).enumerate() {
        let numbers = &numbers[group * LANES * N..];
        all_are_poses &= if has_room(numbers, N) {
            fill_group(lanes, load_items(lanes, numbers, N), lines, turn)
        } else {
            // places without a pose get copies of the last one
            let mut items = [0.0; LANES * LANES];
            for lane in 0..LANES {
                let row = rows[(group * LANES + lane).min(rows.len() - 1)];
                items[lane * N..(lane + 1) * N].copy_from_slice(&row);
            }
            fill_group(lanes, load_items(lanes, &items, N), lines, turn)
        };
    }
    all_are_poses
}

#[inline(always)]
fn fill_group<L: Lanes>(lanes: L, entries: [L; LANES], lines: &mut [Line], turn: Turn) -> bool {
    // zero where the position is finite, NaN otherwise
    let zero = lanes.constant(0.0);
    let mut doubt = zero;
    for column in 0..3 {
        doubt = doubt + zero * entries[column];
        entries[column].store(&mut lines[column].0);
    }
    let (quaternion, off, limit) = match turn {
        Turn::Quaternion => normalised(lanes, [entries[3], entries[4], entries[5], entries[6]]),
        Turn::Angles => turned(lanes, [entries[3], entries[4], entries[5]]),
    };
    for (line, entry) in lines[3..].iter_mut().zip(&quaternion) {
        entry.store(&mut line.0);
    }
    let good = (off + doubt).is_less(limit);
    let every = lanes.everywhere(true);
    !lanes.any(lanes.without(every, good))
}

/// Unit quaternion, and how far its norm was off, with the limit of that.
#[inline(always)]
fn normalised<L: Lanes>(lanes: L, q: [L; 4]) -> ([L; 4], L, L) {
    let one = lanes.constant(1.0);
    let square = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
    let is_unit = (square - one).abs().is_less(lanes.constant(ROUNDED));
    if !lanes.any(lanes.without(lanes.everywhere(true), is_unit)) {
        return (q, lanes.constant(0.0), lanes.constant(NORM_TOLERANCE));
    }
    let norm = square.sqrt();
    let divisor = one.select(is_unit, norm);
    let unit = [q[0] / divisor, q[1] / divisor, q[2] / divisor, q[3] / divisor];
    (unit, (norm - one).abs(), lanes.constant(NORM_TOLERANCE))
}

/// Unit quaternion of Rx Ry Rz, and the largest angle, with the limit of that.
#[inline(always)]
fn turned<L: Lanes>(lanes: L, angles: [L; 3]) -> ([L; 4], L, L) {
    let half = lanes.constant(0.5);
    let (sx, cx) = sin_cos(angles[0] * half);
    let (sy, cy) = sin_cos(angles[1] * half);
    let (sz, cz) = sin_cos(angles[2] * half);
    let (cc, ss, sc, cs) = (cx * cy, sx * sy, sx * cy, cx * sy);
    let quaternion = [sc * cz + cs * sz, cs * cz - sc * sz, cc * sz + ss * cz, cc * cz - ss * sz];
    let largest = angles[0].abs().max(angles[1].abs()).max(angles[2].abs());
    // a NaN in any of them, which a maximum may pass over
    let doubt = lanes.constant(0.0) * (angles[0] + angles[1] + angles[2]);
    (quaternion, largest + doubt, lanes.constant(SINE_LIMIT))
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::geometry::Pose;
    use crate::scalar::{Unit, dispatch_on};

    fn angle_rows(count: usize) -> Vec<[f64; 6]> {
        let mut generator = ChaCha8Rng::seed_from_u64(11);
        (0..count).map(|_| std::array::from_fn(|_| generator.random_range(-4.0..4.0))).collect()
    }

    fn pose_of(row: &[f64; 6]) -> Pose {
        Pose::from_xyz_angles(Vector3::new(row[0], row[1], row[2]), [row[3], row[4], row[5]])
    }

    #[test]
    fn rows_of_unit_quaternions_give_the_poses_to_the_last_bit() {
        for count in [0, 1, 7, 8, 9, 100] {
            let poses: Vec<Pose> = angle_rows(count).iter().map(pose_of).collect();
            let rows: Vec<[f64; 7]> = poses.iter().map(Pose::numbers).collect();
            let mut batch = PoseBatch::default();
            batch.fill_rows(&rows[..]).unwrap();
            assert_eq!(batch, poses.iter().collect::<PoseBatch>());
        }
    }

    #[test]
    fn rows_of_angles_give_the_poses_of_angles() {
        let rows = angle_rows(1003);
        let mut batch = PoseBatch::default();
        batch.fill_rows(&rows[..]).unwrap();
        for (item, row) in rows.iter().enumerate() {
            // sines within 2.3e-16, products of three of them
            let apart = (batch.get(item).rotation.coords - pose_of(row).rotation.coords).amax();
            assert!(apart < 1e-15, "row {item}: {apart:e}");
        }
    }

    #[test]
    fn quaternions_that_are_nearly_unit_are_normalised() {
        let row = [0.0, 0.0, 0.0, 0.6 * (1.0 + 4e-7), 0.0, 0.0, 0.8 * (1.0 + 4e-7)];
        let mut batch = PoseBatch::default();
        batch.fill_rows(&[row; 3][..]).unwrap();
        assert!((batch.get(2).rotation.coords.norm() - 1.0).abs() < 3e-16);
    }

    #[test]
    fn the_first_row_that_is_no_pose_is_named() {
        let good = Pose::identity().numbers();
        for (bad_at, count) in [(0, 1), (7, 8), (8, 9), (19, 30)] {
            let refused = |change: &dyn Fn(&mut [f64; 7])| {
                let mut rows = vec![good; count];
                change(&mut rows[bad_at]);
                PoseBatch::default().fill_rows(&rows[..]).unwrap_err()
            };
            assert_eq!(refused(&|row| row[6] = 1.1), PoseRowError::Norm { row: bad_at, norm: 1.1 });
            assert!(matches!(refused(&|row| row[6] = 1.0 + 2e-6), PoseRowError::Norm { row, .. } if row == bad_at));
            let infinite = PoseRowError::NotFinite { row: bad_at, column: 1, number: f64::INFINITY };
            assert_eq!(refused(&|row| row[1] = f64::INFINITY), infinite);
            let is_nan = |error| matches!(error, PoseRowError::NotFinite { row, column: 4, .. } if row == bad_at);
            assert!(is_nan(refused(&|row| row[4] = f64::NAN)));
            let mut rows = vec![[0.0; 6]; count];
            rows[bad_at][4] = f64::NAN;
            assert!(is_nan(PoseBatch::default().fill_rows(&rows[..]).unwrap_err()));
            rows[bad_at][4] = -1e6;
            let large = PoseRowError::Angle { row: bad_at, angle: -1e6 };
            assert_eq!(PoseBatch::default().fill_rows(&rows[..]).unwrap_err(), large);
        }
    }

    #[test]
    fn every_vector_unit_fills_the_same_bits() {
        let angles = angle_rows(21);
        let quaternions: Vec<[f64; 7]> =
            angles.iter().map(|row| pose_of(row).numbers().map(|n| n * (1.0 + 1e-7))).collect();
        for rows in [PoseRows::Angles(&angles), PoseRows::Quaternions(&quaternions)] {
            let mut expected = PoseBatch::default();
            expected.fill_rows(rows).unwrap();
            for unit in Unit::available() {
                let mut batch = PoseBatch::default();
                batch.table_mut().resize(rows.len());
                assert!(dispatch_on(unit, Fill { rows, lines: batch.table_mut().lines_mut() }).unwrap());
                assert_eq!(batch, expected);
            }
        }
    }
}
