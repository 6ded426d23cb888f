//! Many poses, eight side by side.

use super::Pose;
use crate::scalar::{LANES, LaneTable, Lanes, Line, Real};

pub use cdpr_core::geometry::POSE_ROWS;

/// Many poses, stored so that a vector register loads one number of eight poses at once.
///
/// Functions over whole batches are several times faster on it than on a slice of [`Pose`], since they need not
/// rearrange numbers.
///
/// ```
/// use cdpr::geometry::{Pose, PoseBatch};
///
/// let batch: PoseBatch = [Pose::identity(); 3].iter().collect();
/// assert_eq!(batch.len(), 3);
/// assert_eq!(batch.get(2), Pose::identity());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PoseBatch {
    table: LaneTable,
}

impl Default for PoseBatch {
    fn default() -> Self {
        Self { table: LaneTable::new(POSE_ROWS) }
    }
}

impl<'a> FromIterator<&'a Pose> for PoseBatch {
    fn from_iter<I: IntoIterator<Item = &'a Pose>>(poses: I) -> Self {
        let mut batch = Self::default();
        poses.into_iter().for_each(|pose| batch.push(pose));
        batch
    }
}

impl PoseBatch {
    /// Number of poses.
    pub fn len(&self) -> usize {
        self.table.len()
    }

    /// True if there are no poses.
    pub fn is_empty(&self) -> bool {
        self.table.is_empty()
    }

    /// Replaces the poses; memory that was claimed before is kept.
    pub fn fill(&mut self, poses: &[Pose]) {
        self.table.resize(poses.len());
        for (group, poses) in poses.chunks(LANES).enumerate() {
            transpose(poses, self.table.group_mut(group));
        }
    }

    /// Takes `count` poses of another batch from `first` on, which begins a group of eight; memory that was claimed once is kept.
    pub(crate) fn fill_from(&mut self, other: &Self, first: usize, count: usize) {
        self.table.resize(count);
        let lines = &other.table.lines()[first / LANES * POSE_ROWS..];
        let target = self.table.lines_mut();
        target.copy_from_slice(&lines[..target.len()]);
    }

    /// Adds a pose.
    pub fn push(&mut self, pose: &Pose) {
        let item = self.len();
        self.table.resize(item + 1);
        self.table.write(item, &pose.numbers());
    }

    /// One pose (from 0); panics if there is none.
    pub fn get(&self, item: usize) -> Pose {
        let mut numbers = [0.0; POSE_ROWS];
        self.table.read(item, &mut numbers);
        Pose::from_numbers(numbers)
    }

    /// Numbers of all poses.
    pub(crate) fn table(&self) -> &LaneTable {
        &self.table
    }

    /// Numbers of all poses, to be written.
    pub(crate) fn table_mut(&mut self) -> &mut LaneTable {
        &mut self.table
    }

    /// Poses of one group of eight, in lanes.
    #[inline(always)]
    pub(crate) fn at<L: Lanes>(&self, lanes: L, group: usize) -> ([L; 3], [[L; 3]; 3]) {
        in_lanes(lanes, self.table.group(group))
    }
}

/// Writes up to eight poses side by side; missing poses are copies of the last.
#[inline]
pub fn transpose(poses: &[Pose], rows: &mut [Line]) {
    for lane in 0..LANES {
        let Some(pose) = poses.get(lane).or(poses.last()) else { continue };
        for (row, number) in rows.iter_mut().zip(pose.numbers()) {
            row.0[lane] = number;
        }
    }
}

/// Positions and rotation rows of eight poses.
#[inline(always)]
pub fn in_lanes<L: Lanes>(lanes: L, rows: &[Line]) -> ([L; 3], [[L; 3]; 3]) {
    let mut entries = [lanes; POSE_ROWS];
    for row in 0..POSE_ROWS {
        entries[row] = lanes.load(&rows[row].0);
    }
    let [x, y, z, i, j, k, w] = entries;
    ([x, y, z], rotation_rows([i, j, k, w]))
}

/// Rotation matrix of a unit quaternion x, y, z, w, by rows, with the bits of [`Pose::rotation_matrix`].
#[inline(always)]
pub fn rotation_rows<T: Real>([i, j, k, w]: [T; 4]) -> [[T; 3]; 3] {
    let two = w.constant(2.0);
    let (ww, ii, jj, kk) = (w * w, i * i, j * j, k * k);
    let (ij, wk, wj) = (i * j * two, w * k * two, w * j * two);
    let (ik, jk, wi) = (i * k * two, j * k * two, w * i * two);
    [
        [ww + ii - jj - kk, ij - wk, wj + ik],
        [wk + ij, ww - ii + jj - kk, jk - wi],
        [ik - wj, wi + jk, ww - ii - jj + kk],
    ]
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    #[test]
    fn a_batch_gives_back_the_poses_it_was_given() {
        let pose = |index: u8| {
            let t = f64::from(index);
            Pose::from_xyz_angles(Vector3::new(t, -t, 0.5 * t), [0.1 * t, 0.2, -0.3 * t])
        };
        let poses: Vec<Pose> = (0..19).map(pose).collect();
        let mut batch = PoseBatch::default();
        for count in [19, 8, 0, 3] {
            batch.fill(&poses[..count]);
            assert_eq!(batch, poses[..count].iter().collect::<PoseBatch>());
            assert_eq!((0..batch.len()).map(|item| batch.get(item)).collect::<Vec<_>>(), poses[..count]);
        }
    }

    #[test]
    fn the_rotation_has_the_bits_of_the_single_pose() {
        for step in 0..1000 {
            let t = f64::from(step);
            let pose = Pose::from_xyz_angles(Vector3::zeros(), [t.sin() * 3.0, t.cos(), 0.01 * t]);
            let q = pose.rotation.coords;
            assert_eq!(rotation_rows([q.x, q.y, q.z, q.w]), pose.rotation_rows());
        }
    }
}
