//! A machine of straight cables between points: what its winches report at a pose, and the pose of what they report.

use crate::pose::{Pose, Vector, cross, dot, minus, norm, plus, times, turned};
use crate::solve::{Freedom, nearest, solved};

/// Anchors, winches and load.
#[derive(Clone, Debug)]
pub(crate) struct Geometry {
    pub(crate) freedom: Freedom,
    /// Where cables leave the frame (world, m).
    pub(crate) frame_anchors: Vec<Vector>,
    /// Where they hold the platform (platform, m).
    pub(crate) platform_anchors: Vec<Vector>,
    /// Recorded length is scale · length + offset.
    pub(crate) scales: Vec<f64>,
    pub(crate) offsets: Vec<f64>,
    /// 1/EA of each cable (1/N); empty if cables do not stretch.
    pub(crate) compliances: Vec<f64>,
    /// Force on the platform (N), for cables that stretch.
    pub(crate) force: Vector,
}

impl Geometry {
    pub(crate) fn cables(&self) -> usize {
        self.frame_anchors.len()
    }

    /// Vector along a cable from the platform to the frame (m).
    fn cable(&self, pose: &Pose, cable: usize) -> Vector {
        minus(minus(self.frame_anchors[cable], pose.position), turned(&pose.rotation, self.platform_anchors[cable]))
    }

    /// Lengths that the winches report at a pose with tensions: a stretched cable of length q under f was paid out by q (1 − f/EA).
    pub(crate) fn recorded(&self, pose: &Pose, tensions: &[f64]) -> Vec<f64> {
        let report = |cable: usize| {
            let strain = self.compliances.get(cable).map_or(0.0, |compliance| compliance * tensions[cable]);
            self.scales[cable] * norm(self.cable(pose, cable)) * (1.0 - strain) + self.offsets[cable]
        };
        (0..self.cables()).map(report).collect()
    }

    /// The pose near a guess at which these lengths are recorded: of cables that stretch where their forces balance the load, else of
    /// least squares.
    pub(crate) fn pose_of(&self, recorded: &[f64], guess: &Pose) -> Pose {
        let paid_out: Vec<f64> =
            (0..self.cables()).map(|cable| (recorded[cable] - self.offsets[cable]) / self.scales[cable]).collect();
        let rigid = |pose: &Pose| (0..self.cables()).map(|i| norm(self.cable(pose, i)) - paid_out[i]).collect();
        if self.compliances.is_empty() {
            return nearest(self.freedom, guess, rigid);
        }
        // cables that do not stretch lead near the balance
        let near = nearest(self.freedom, guess, rigid);
        nearest(self.freedom, &near, |pose| self.residual_force(pose, &paid_out))
    }

    /// Force that the cables leave unbalanced (N), and its moment about the platform where that turns.
    fn residual_force(&self, pose: &Pose, paid_out: &[f64]) -> Vec<f64> {
        let (mut force, mut moment) = (self.force, [0.0; 3]);
        for cable in 0..self.cables() {
            let vector = self.cable(pose, cable);
            let length = norm(vector);
            let tension = ((1.0 - paid_out[cable] / length) / self.compliances[cable]).max(0.0);
            let pull = times(vector, tension / length);
            force = plus(force, pull);
            moment = plus(moment, cross(turned(&pose.rotation, self.platform_anchors[cable]), pull));
        }
        let forces = self.freedom.axes.iter().map(|&axis| force[axis]);
        forces.chain(moment.into_iter().filter(|_| self.freedom.turns)).collect()
    }

    /// Tensions of four cables that balance the force on a point: the least ones and an inner tension on top, none below `floor` where that
    /// can be.
    pub(crate) fn tensions(&self, pose: &Pose, inner: f64, floor: f64) -> Vec<f64> {
        let directions: Vec<Vector> = (0..self.cables())
            .map(|cable| {
                let vector = self.cable(pose, cable);
                times(vector, 1.0 / norm(vector))
            })
            .collect();
        // f = Uᵀ (U Uᵀ)⁻¹ (−force)
        let gram = (0..3).map(|a| (0..3).map(|b| directions.iter().map(|u| u[a] * u[b]).sum()).collect()).collect();
        let multipliers = solved(gram, times(self.force, -1.0).to_vec()).unwrap_or_else(|| vec![0.0; 3]);
        let least: Vec<f64> =
            directions.iter().map(|u| dot(*u, [multipliers[0], multipliers[1], multipliers[2]])).collect();
        let kernel = kernel_of_four(&directions);
        let with = |inner: f64| -> Vec<f64> { least.iter().zip(&kernel).map(|(f, h)| f + inner * h).collect() };
        let lowest = |tensions: &[f64]| tensions.iter().copied().fold(f64::INFINITY, f64::min);
        let tries = (0..40).map(|step| with(inner * (1.0 - f64::from(step) / 10.0)));
        let fitting = tries.clone().find(|tensions| lowest(tensions) >= floor);
        fitting.or_else(|| tries.max_by(|a, b| lowest(a).total_cmp(&lowest(b)))).unwrap_or(least)
    }
}

/// Tensions of four directions that balance each other, of norm 1.
fn kernel_of_four(u: &[Vector]) -> [f64; 4] {
    let determinant = |a: usize, b: usize, c: usize| dot(u[a], cross(u[b], u[c]));
    let kernel = [determinant(1, 2, 3), -determinant(0, 2, 3), determinant(0, 1, 3), -determinant(0, 1, 2)];
    let size = kernel.iter().map(|number| number * number).sum::<f64>().sqrt();
    kernel.map(|number| number / size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use crate::robots::RobotName;

    /// Pose → lengths → pose, for cables that stretch as for others.
    #[test]
    fn recorded_lengths_lead_back_to_their_pose() {
        for robot in RobotName::ALL {
            let (machine, mut random) = (robot.file().geometry, Random::of("test", 3));
            for _ in 0..20 {
                let pose = robot.random_pose(&mut random, [0.0, 1.0]);
                let tensions = robot.tensions_at(&machine, &pose, &mut random);
                let guess = pose.moved([0.01, 0.0, -0.02], [0.0; 3]);
                let found = machine.pose_of(&machine.recorded(&pose, &tensions), &guess);
                assert!(norm(minus(found.position, pose.position)) < 1e-8, "{robot:?}: {found:?} {pose:?}");
            }
        }
    }

    #[test]
    fn tensions_balance_the_load() {
        let robot = RobotName::ElasticCamera;
        let (machine, mut random) = (robot.file().geometry, Random::of("test", 5));
        for _ in 0..20 {
            let pose = robot.random_pose(&mut random, [0.0, 1.0]);
            let tensions = robot.tensions_at(&machine, &pose, &mut random);
            let paid_out: Vec<f64> = machine.recorded(&pose, &tensions);
            let left = machine.residual_force(&pose, &paid_out);
            assert!(left.iter().all(|force| force.abs() < 1e-6), "{left:?} {tensions:?}");
        }
    }
}
