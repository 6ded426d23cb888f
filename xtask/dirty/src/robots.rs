//! Robots of the cells: their files, the machines that deviate from these, and poses in their workspaces.

use crate::geometry::Geometry;
use crate::pose::{Pose, Vector, rotation_of};
use crate::random::Random;
use crate::solve::Freedom;

/// Deviation of the machine's frame anchors from the file, per axis (m).
const ANCHOR_DEVIATION: f64 = 0.015;
/// Deviation of its winches' zeros (m).
const OFFSET_DEVIATION: f64 = 0.020;
/// Largest turn of poses about each axis (rad).
const LARGEST_TURN: f64 = 0.25;

/// Share of each axis' span that inner poses leave free at either end.
const INNER: f64 = 1.0 / 12.0;

/// Which robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RobotName {
    /// Suspended camera: a point on four cables.
    Camera,
    /// Platform in a box: eight cables hold and turn it.
    Box,
    /// Wall plotter: a pen on two cables.
    Plotter,
    /// The suspended camera on cables that stretch, with recorded tensions.
    ElasticCamera,
}

/// Numbers of a robot file.
#[derive(Clone, Debug)]
pub(crate) struct RobotFile {
    pub(crate) robot: RobotName,
    pub(crate) geometry: Geometry,
    pub(crate) mass: f64,
}

/// Positions of a robot's work (m).
struct Space {
    least: Vector,
    most: Vector,
    home: Vector,
}

impl RobotName {
    pub(crate) const ALL: &[Self] = &[Self::Camera, Self::Box, Self::Plotter, Self::ElasticCamera];

    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::Box => "box",
            Self::Plotter => "plotter",
            Self::ElasticCamera => "elastic-camera",
        }
    }

    pub(crate) fn freedom(self) -> Freedom {
        match self {
            Self::Plotter => Freedom { axes: &[0, 2], turns: false },
            Self::Box => Freedom { axes: &[0, 1, 2], turns: true },
            Self::Camera | Self::ElasticCamera => Freedom { axes: &[0, 1, 2], turns: false },
        }
    }

    /// Rows of an ordinary record.
    pub(crate) fn rows(self) -> usize {
        match self {
            Self::Camera => 100,
            Self::Box => 120,
            Self::Plotter | Self::ElasticCamera => 80,
        }
    }

    pub(crate) fn stretches(self) -> bool {
        self == Self::ElasticCamera
    }

    fn space(self) -> Space {
        let (least, most, home) = match self {
            Self::Plotter => ([0.3, 0.0, 0.2], [1.7, 0.0, 1.2], [1.0, 0.0, 0.75]),
            Self::Box => ([-1.2, -0.9, 0.6], [1.2, 0.9, 1.9], [0.0, 0.0, 1.25]),
            Self::Camera | Self::ElasticCamera => ([-4.0, -2.5, 1.0], [4.0, 2.5, 4.5], [0.0, 0.0, 3.0]),
        };
        Space { least, most, home }
    }

    pub(crate) fn file(self) -> RobotFile {
        let corner = |index: usize, half: [f64; 2], height: f64| {
            let (x, y) = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)][index % 4];
            [x * half[0], y * half[1], height]
        };
        let (frame_anchors, platform_anchors): (Vec<Vector>, Vec<Vector>) = match self {
            Self::Plotter => (vec![[0.0, 0.0, 1.5], [2.0, 0.0, 1.5]], vec![[0.0; 3]; 2]),
            Self::Camera | Self::ElasticCamera => {
                ((0..4).map(|index| corner(index, [6.0, 4.0], 6.0)).collect(), vec![[0.0; 3]; 4])
            }
            Self::Box => (0..8)
                .map(|index| match index {
                    0..4 => (corner(index, [2.0, 1.5], 2.5), corner(index, [0.25, 0.1], -0.1)),
                    _ => (corner(index, [2.0, 1.5], 0.0), corner(index, [0.1, 0.25], 0.1)),
                })
                .unzip(),
        };
        let cables = frame_anchors.len();
        let mass = match self {
            Self::Plotter => 0.5,
            Self::Box => 10.0,
            Self::Camera | Self::ElasticCamera => 5.0,
        };
        let compliances = if self.stretches() { vec![1.0 / 2e4; cables] } else { Vec::new() };
        let geometry = Geometry {
            freedom: self.freedom(),
            frame_anchors,
            platform_anchors,
            scales: vec![1.0; cables],
            offsets: vec![0.0; cables],
            compliances,
            force: weight(mass),
        };
        RobotFile { robot: self, geometry, mass }
    }

    /// The machine of a seed: anchors and zeros that deviate from the file.
    pub(crate) fn machine(self, random: &mut Random) -> Geometry {
        let mut machine = self.file().geometry;
        for anchor in &mut machine.frame_anchors {
            self.freedom().axes.iter().for_each(|&axis| anchor[axis] += random.normal(ANCHOR_DEVIATION));
        }
        machine.offsets.iter_mut().for_each(|offset| *offset = random.normal(OFFSET_DEVIATION));
        machine
    }

    /// A pose in a part of the workspace: fractions of each axis' span.
    pub(crate) fn random_pose(self, random: &mut Random, [from, to]: [f64; 2]) -> Pose {
        let fractions = [(); 3].map(|()| random.between(from, to));
        let turn = [(); 3].map(|()| random.between(-LARGEST_TURN, LARGEST_TURN));
        self.pose_at(fractions, if self.freedom().turns { turn } else { [0.0; 3] })
    }

    /// A pose in the inner five sixths of each axis' span.
    pub(crate) fn inner_pose(self, random: &mut Random) -> Pose {
        self.random_pose(random, [INNER, 1.0 - INNER])
    }

    /// Pose at fractions of the workspace's spans.
    fn pose_at(self, fractions: Vector, turn: Vector) -> Pose {
        let Space { least, most, .. } = self.space();
        let position = std::array::from_fn(|axis| least[axis] + fractions[axis] * (most[axis] - least[axis]));
        Pose { position, rotation: rotation_of(turn) }
    }

    /// Poses of a smooth motion through the workspace at times (s): sums of two sines for each coordinate.
    pub(crate) fn path(self, random: &mut Random, times: &[f64]) -> Vec<Pose> {
        let waves: [[f64; 4]; 6] = [(); 6].map(|()| {
            [random.between(16.0, 22.0), random.between(5.5, 8.0), random.between(0.0, 6.0), random.between(0.0, 6.0)]
        });
        let wave = |axis: usize, time: f64| {
            let [slow, quick, first, second] = waves[axis];
            let angle = std::f64::consts::TAU * time;
            0.75 * (angle / slow + first).sin() + 0.2 * (angle / quick + second).sin()
        };
        let at = |time: &f64| {
            let fractions = std::array::from_fn(|axis| 0.5 + 0.5 * wave(axis, *time));
            let turn = std::array::from_fn(|axis| LARGEST_TURN * wave(axis + 3, *time));
            self.pose_at(fractions, if self.freedom().turns { turn } else { [0.0; 3] })
        };
        times.iter().map(at).collect()
    }

    /// Tensions of a machine at a pose; none of cables that do not stretch.
    pub(crate) fn tensions_at(self, machine: &Geometry, pose: &Pose, random: &mut Random) -> Vec<f64> {
        let inner = random.between(-3.0, 3.0);
        if self.stretches() { machine.tensions(pose, inner, 3.0) } else { Vec::new() }
    }

    fn columns(self) -> String {
        let motion = match self {
            Self::Plotter => "motion_pattern = \"2T\"\naxes = \"xz\"",
            Self::Box => "motion_pattern = \"3R3T\"",
            Self::Camera | Self::ElasticCamera => "motion_pattern = \"3T\"",
        };
        let gravity = self.list([0.0, 0.0, -9.81]);
        format!("{motion}\ncable_count = {}\ngravity_m_s2 = {gravity}\n", self.file().geometry.cables())
    }

    /// A vector as the robot's files write it.
    fn list(self, vector: Vector) -> String {
        let numbers: Vec<String> = self.freedom().axes.iter().map(|&axis| format!("{:?}", vector[axis])).collect();
        format!("[{}]", numbers.join(", "))
    }
}

/// Force of a mass (N).
pub(crate) fn weight(mass: f64) -> Vector {
    [0.0, 0.0, -9.81 * mass]
}

impl RobotFile {
    /// The file.
    pub(crate) fn text(&self) -> String {
        let (robot, Space { least, most, home }) = (self.robot, self.robot.space());
        let limits = match robot {
            RobotName::Plotter => [0.5, 30.0],
            RobotName::Box => [20.0, 1000.0],
            RobotName::Camera | RobotName::ElasticCamera => [1.0, 300.0],
        };
        let mut text = format!("layout_version = 1\nname = \"{}\"\n{}", robot.word(), robot.columns());
        text += &format!("\n[platform]\nmass_kg = {:?}\n", self.mass);
        let list = |vector: Vector| robot.list(vector);
        text += &format!("\n[home_pose]\nposition_m = {}\n", list(home));
        if robot.freedom().turns {
            text += "rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\n";
        }
        text += &format!("\n[workspace]\nposition_min_m = {}\nposition_max_m = {}\n", list(least), list(most));
        text += &format!("\n[cable_defaults]\ntension_min_N = {:?}\ntension_max_N = {:?}\n", limits[0], limits[1]);
        if let Some(compliance) = self.geometry.compliances.first() {
            text += &format!("axial_stiffness_EA_N = {:?}\n", (1.0 / compliance).round());
        }
        let anchors = self.geometry.frame_anchors.iter().zip(&self.geometry.platform_anchors);
        for (cable, (frame, platform)) in anchors.enumerate() {
            text += &format!("\n[[cable]]\nname = \"{}\"\nframe_anchor_m = {}\n", cable + 1, list(*frame));
            if robot.freedom().turns {
                text += &format!("platform_anchor_m = {}\n", list(*platform));
            }
        }
        text
    }
}
