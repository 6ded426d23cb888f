//! The commanded poses of a study.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::{PoseFilter, PoseGrid, RandomPoses, Study, TensionTests};
use cdpr_model::control::InputError;
use cdpr_model::control::{CommandedPose, Shortening};
use cdpr_model::geometry::{PatternError, Pose};
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use cdpr_model::statics::Load;
use cdpr_model::tension;
use cdpr_workspace::criterion::{Criterion, WrenchFeasible};

impl Study {
    /// All poses to command: those of the file (read by the caller), the grid, the random ones, then the tension tests.
    pub fn commanded_poses(
        &self,
        robot: &Robot,
        from_file: Vec<Pose>,
        seed: u64,
    ) -> Result<Vec<CommandedPose>, PatternError> {
        let mut all = self.plain_poses(robot, from_file, seed)?;
        if let Some(tests) = self.poses.as_ref().and_then(|poses| poses.tension_tests.as_ref()) {
            all.extend(tests.commands(&all, robot.cable_count()));
        }
        Ok(all)
    }

    fn plain_poses(&self, robot: &Robot, from_file: Vec<Pose>, seed: u64) -> Result<Vec<CommandedPose>, PatternError> {
        let Some(poses) = &self.poses else { return Ok(Vec::new()) };
        let in_set = |pose: Pose, set: &Option<String>| CommandedPose { set: set.clone(), ..CommandedPose::at(pose) };
        let file_set = poses.file.as_ref().and_then(|file| file.set.clone());
        let mut all: Vec<CommandedPose> = from_file.into_iter().map(|pose| in_set(pose, &file_set)).collect();
        let pattern = robot.motion_pattern;
        if let Some(grid) = &poses.grid {
            for components in grid.points() {
                all.push(in_set(pattern.pose(robot.plane, &components)?, &grid.set));
            }
            // an empty grid still has to fit the pattern
            pattern.pose(robot.plane, &grid.min)?;
        }
        let random = poses.random.as_ref();
        if let Some((random, corners)) = random.and_then(|random| Some((random, random.corners(poses.grid.as_ref())?)))
        {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            for _ in 0..random.count {
                let components = random.components(corners, pattern.translations(), &mut rng);
                all.push(in_set(pattern.pose(robot.plane, &components)?, &random.set));
            }
        }
        Ok(all)
    }

    /// Removes the poses that `[poses] only` excludes.
    pub(crate) fn keep_wanted(&self, machine: &Model, poses: &mut Vec<CommandedPose>) -> Result<(), InputError> {
        let Some(PoseFilter::WrenchFeasible) = self.poses.as_ref().and_then(|poses| poses.only) else { return Ok(()) };
        let limits = tension::Limits::of(machine.robot(), None, None)?;
        let (expected, found, poses_before) = (machine.cable_count(), limits.cable_count(), poses.len());
        let feasible = WrenchFeasible::new(machine, &Load::of(machine.robot())?, &limits)
            .map_err(|_| InputError::Count { key: "tension limits", expected, found })?;
        poses.retain(|command| feasible.holds(&command.pose));
        match poses.is_empty() && poses_before > 0 {
            true => Err(InputError::NoneFeasible { poses: poses_before }),
            false => Ok(()),
        }
    }
}

impl TensionTests {
    /// Every cable shortened in turn at the middles of `count` equal parts of the list; at every pose if there are
    /// fewer poses.
    fn commands(&self, poses: &[CommandedPose], cable_count: usize) -> Vec<CommandedPose> {
        let count = self.count.min(poses.len());
        let chosen = (0..count).map(|part| &poses[(2 * part + 1) * poses.len() / (2 * count)]);
        let shortened = |pose: &CommandedPose, cable: usize| CommandedPose {
            pose: pose.pose,
            set: self.set.clone().or_else(|| pose.set.clone()),
            shortened: Some(Shortening { cable, by: self.shorten_m }),
            tensions: None,
        };
        chosen.flat_map(|pose| (0..cable_count).map(move |cable| shortened(pose, cable))).collect()
    }
}

impl PoseGrid {
    fn points(&self) -> Vec<Vec<f64>> {
        let mut points = vec![Vec::new()];
        for ((&min, &max), &count) in self.min.iter().zip(&self.max).zip(&self.count) {
            let value = |index: usize| match count {
                1 => 0.5 * (min + max),
                _ => min + (max - min) * index as f64 / (count - 1) as f64,
            };
            let extended =
                |point: &Vec<f64>| (0..count).map(|index| [point.as_slice(), &[value(index)]].concat()).collect();
            points = points.iter().flat_map(|point| -> Vec<Vec<f64>> { extended(point) }).collect();
        }
        points
    }
}

impl RandomPoses {
    /// Lower and upper corner of the box: its own, else those of the grid.
    pub(super) fn corners<'a>(&'a self, grid: Option<&'a PoseGrid>) -> Option<[&'a [f64]; 2]> {
        let of_grid = || grid.map(|grid| [&grid.min[..], &grid.max[..]]);
        let own = self.min.as_deref().zip(self.max.as_deref());
        own.map(|(min, max)| [min, max]).or_else(of_grid)
    }

    fn components(&self, [min, max]: [&[f64]; 2], translations: usize, rng: &mut ChaCha8Rng) -> Vec<f64> {
        let mut uniform = |low: f64, high: f64| low + (high - low) * rng.random::<f64>();
        let component = |(index, (&min, &max)): (usize, (&f64, &f64))| {
            let angle = index.checked_sub(translations).and_then(|angle| self.rotation_rad.as_ref()?.get(angle));
            angle.map_or_else(|| (min, max), |&limit| (-limit.abs(), limit.abs()))
        };
        let ranges: Vec<(f64, f64)> = min.iter().zip(max).enumerate().map(component).collect();
        ranges.into_iter().map(|(low, high)| uniform(low, high)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tension_tests_are_spread_over_the_poses_and_shorten_every_cable_once() {
        let poses: Vec<CommandedPose> = (0..91)
            .map(|k| {
                let mut pose = Pose::identity();
                pose.position.x = f64::from(k);
                CommandedPose::at(pose)
            })
            .collect();
        let tests = TensionTests { shorten_m: 0.03, count: 8, set: None };
        let commands = tests.commands(&poses, 8);
        assert_eq!(commands.len(), 64);
        let at: Vec<f64> = commands.iter().step_by(8).map(|command| command.pose.position.x).collect();
        assert_eq!(at, [5.0, 17.0, 28.0, 39.0, 51.0, 62.0, 73.0, 85.0]);
        let cables: Vec<usize> = commands[8..16].iter().filter_map(|c| c.shortened).map(|test| test.cable).collect();
        assert_eq!(cables, (0..8).collect::<Vec<_>>());
        // more tests than poses: every pose once
        assert_eq!(tests.commands(&poses[..2], 8).len(), 16);
        assert!(tests.commands(&[], 8).is_empty());
    }
}
