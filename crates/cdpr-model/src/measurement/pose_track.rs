//! Poses over time, interpolated except in long gaps of the recording.

use crate::geometry::Pose;

/// Longest gap that is interpolated, in typical intervals.
const LONGEST_GAP: f64 = 3.0;

/// A recording of poses on one clock.
pub(crate) struct PoseTrack {
    /// Increasing times (s).
    times: Vec<f64>,
    poses: Vec<Pose>,
    /// The longest gap that is interpolated (s).
    pub(crate) longest_gap: f64,
}

impl PoseTrack {
    /// Poses at their times, in any order; of equal times the first counts. Gaps up to three typical intervals are
    /// interpolated.
    pub(crate) fn new(times: &[f64], poses: &[Pose]) -> Self {
        let mut order: Vec<usize> = (0..times.len().min(poses.len())).collect();
        order.sort_by(|&a, &b| times[a].total_cmp(&times[b]));
        order.dedup_by(|later, earlier| times[*later] <= times[*earlier]);
        let times: Vec<f64> = order.iter().map(|&index| times[index]).collect();
        let mut intervals: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        intervals.sort_by(f64::total_cmp);
        let typical = intervals.get(intervals.len() / 2).copied().unwrap_or(0.0);
        let poses = order.iter().map(|&index| poses[index]).collect();
        Self { times, poses, longest_gap: LONGEST_GAP * typical }
    }

    /// First and last time (s); `None` without poses.
    pub(crate) fn span(&self) -> Option<(f64, f64)> {
        Some((*self.times.first()?, *self.times.last()?))
    }

    /// The pose at a time, interpolated between its neighbours; `None` before, after, and in long gaps.
    pub(crate) fn at(&self, time: f64) -> Option<Pose> {
        let after = self.times.partition_point(|known| *known < time);
        if self.times.get(after) == Some(&time) {
            return Some(self.poses[after]);
        }
        let before = after.checked_sub(1)?;
        let interval = self.times.get(after)? - self.times[before];
        // allows for the rounding error of a gap exactly at the limit
        if interval > self.longest_gap * (1.0 + 1e-9) {
            return None;
        }
        let (from, to) = (&self.poses[before], &self.poses[after]);
        Some(from.displaced(&(from.displacement_to(to) * ((time - self.times[before]) / interval))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poses_are_interpolated_between_neighbours_and_not_in_gaps() {
        let pose = |angle: f64| Pose::from_xyz_angles([angle, 0.0, 0.0].into(), [0.0, 0.0, angle]);
        let times = [0.2, 0.0, 0.1, 0.1, 0.9, 1.0];
        let track = PoseTrack::new(&times, &[0.2, 0.0, 0.1, 7.0, 0.9, 1.0].map(pose));
        for time in [0.0, 0.04, 0.1, 0.17, 0.95, 1.0] {
            let found = track.at(time).unwrap();
            assert!(found.displacement_to(&pose(time)).norm() < 1e-12, "{time}: {found:?}");
        }
        for time in [-0.01, 0.5, 1.01, f64::NAN] {
            assert!(track.at(time).is_none(), "{time}");
        }
    }
}
