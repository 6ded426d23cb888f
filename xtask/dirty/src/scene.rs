//! Scenes: robot file, record and validation record of a machine before they are spoilt.

use crate::geometry::Geometry;
use crate::pose::{Pose, Vector};
use crate::random::Random;
use crate::record::{Record, Row, Style};
use crate::robots::{RobotFile, RobotName};

/// Accuracies of the sensors, per axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sigmas {
    pub(crate) position: f64,
    pub(crate) rotation: f64,
    pub(crate) length: f64,
    pub(crate) tension: f64,
}

/// Accuracies that the sensors have.
pub(crate) const SIGMAS: Sigmas = Sigmas { position: 1e-3, rotation: 1e-3, length: 5e-4, tension: 0.5 };

/// Poses of a record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Layout {
    /// As many poses as the robot's record has, anywhere in the workspace, 5 s one after the other.
    Scattered,
    /// The same, with this number of rows.
    Few(usize),
    /// In a corner of the workspace, an eighth of each span.
    Corner,
    /// Along a smooth motion, ten rows a second.
    Moving,
}

/// Rows of a record to validate by.
const VALIDATION_ROWS: usize = 40;
/// Rows of a record in motion, and time between them (s).
const MOVING: (usize, f64) = (300, 0.1);
/// Poses at which a written robot is judged.
const JUDGED: usize = 60;

/// Files of a cell, and the truth behind them.
pub(crate) struct Scene {
    pub(crate) file: RobotFile,
    /// The machine that made the record, without what disturbs it.
    pub(crate) machine: Geometry,
    pub(crate) data: Record,
    /// The poses of `data` without noise.
    pub(crate) truth: Vec<Pose>,
    pub(crate) validation: Option<Record>,
    /// Accuracies that the sidecars state.
    pub(crate) stated: Option<Sigmas>,
    /// Frame of the tracker, world to tracker, if it is another one throughout.
    pub(crate) tracker: Option<Pose>,
    /// Marker on the platform; `None` if its origin is measured.
    pub(crate) marker: Option<Vector>,
}

/// A machine at a pose that an operator asks for.
pub(crate) struct Asked {
    pub(crate) pose: Pose,
    pub(crate) recorded: Vec<f64>,
}

impl Scene {
    /// The scene of a robot and a seed; `words` name the kind of dirt, for which other poses and noise are drawn.
    pub(crate) fn of(robot: RobotName, seed: u64, layout: Layout, words: &str) -> Self {
        let machine = robot.machine(&mut Random::of(robot.word(), seed));
        let mut random = Random::of(&format!("{words} {}", robot.word()), seed);
        let (file, truth) = (robot.file(), poses(robot, layout, &mut random));
        let step = if layout == Layout::Moving { MOVING.1 } else { 5.0 };
        let data = Measuring { robot, machine: &machine, sigmas: SIGMAS, step }.record(&truth, &mut random);
        Self::unspoilt(file, machine, data, truth)
    }

    /// A record of a machine at these poses, with nothing stated.
    pub(crate) fn unspoilt(file: RobotFile, machine: Geometry, data: Record, truth: Vec<Pose>) -> Self {
        Self { file, machine, data, truth, validation: None, stated: None, tracker: None, marker: None }
    }

    pub(crate) fn robot(&self) -> RobotName {
        self.file.robot
    }

    pub(crate) fn cables(&self) -> usize {
        self.machine.cables()
    }

    /// Measures anew after the machine was changed: other noise at the same poses.
    pub(crate) fn measure_again(&mut self, random: &mut Random) {
        let step = self.data.rows.get(1).map_or(1.0, |row| row.time);
        let measuring = Measuring { robot: self.robot(), machine: &self.machine, sigmas: SIGMAS, step };
        self.data = measuring.record(&self.truth, random);
    }

    /// A record to validate by, of a machine that may be another one.
    pub(crate) fn validate_by(&mut self, machine: &Geometry, random: &mut Random) {
        let poses: Vec<Pose> = (0..VALIDATION_ROWS).map(|_| self.robot().random_pose(random, [0.0, 1.0])).collect();
        let measuring = Measuring { robot: self.robot(), machine, sigmas: SIGMAS, step: 5.0 };
        self.validation = Some(measuring.record(&poses, random));
    }

    /// The machine at poses all over its workspace, without noise.
    pub(crate) fn asked(&self, random: &mut Random) -> Vec<Asked> {
        let ask = |_| {
            let pose = self.robot().random_pose(random, [0.0, 1.0]);
            self.asked_at(pose, random)
        };
        (0..JUDGED).map(ask).collect()
    }

    /// The machine at a pose, without noise.
    pub(crate) fn asked_at(&self, pose: Pose, random: &mut Random) -> Asked {
        let tensions = self.robot().tensions_at(&self.machine, &pose, random);
        Asked { pose, recorded: self.machine.recorded(&pose, &tensions) }
    }

    /// A pose as the tracker of this scene sees it, without noise.
    pub(crate) fn seen(&self, pose: &Pose) -> Pose {
        let marker = Pose::shifted(self.marker.unwrap_or_default());
        let seen = pose.then(&marker);
        self.tracker.map_or(seen, |tracker| tracker.then(&seen))
    }

    /// The sidecar of a file; `None` where nothing is stated.
    pub(crate) fn sidecar(&self) -> Option<String> {
        let Sigmas { position, rotation, length, tension } = self.stated?;
        let robot = self.robot();
        let mut text = format!("layout_version = 1\n[sigmas]\nposition_m = {position:?}\nlength_m = {length:?}\n");
        if robot.freedom().turns {
            text += &format!("rotation_rad = {rotation:?}\n");
        }
        if robot.stretches() {
            text += &format!("tension_N = {tension:?}\n");
        }
        Some(text)
    }
}

fn poses(robot: RobotName, layout: Layout, random: &mut Random) -> Vec<Pose> {
    let (rows, part) = match layout {
        Layout::Moving => {
            let times: Vec<f64> = (0..MOVING.0).map(|row| row as f64 * MOVING.1).collect();
            return robot.path(random, &times);
        }
        Layout::Scattered => (robot.rows(), [0.0, 1.0]),
        Layout::Few(rows) => (rows, [0.0, 1.0]),
        Layout::Corner => (robot.rows(), [0.0, 0.125]),
    };
    (0..rows).map(|_| robot.random_pose(random, part)).collect()
}

/// A machine that is measured, and by what.
pub(crate) struct Measuring<'a> {
    pub(crate) robot: RobotName,
    pub(crate) machine: &'a Geometry,
    /// Accuracies of the sensors.
    pub(crate) sigmas: Sigmas,
    /// Time between rows (s).
    pub(crate) step: f64,
}

impl Measuring<'_> {
    /// Noisy rows at poses.
    pub(crate) fn record(&self, poses: &[Pose], random: &mut Random) -> Record {
        let Self { robot, machine, sigmas, step } = *self;
        let rows = poses.iter().enumerate().map(|(index, pose)| {
            let tensions = robot.tensions_at(machine, pose, random);
            let mut lengths = machine.recorded(pose, &tensions);
            lengths.iter_mut().for_each(|length| *length += random.normal(sigmas.length));
            Row {
                time: index as f64 * step,
                pose: self.noisy(pose, random),
                lengths,
                tensions: tensions.iter().map(|tension| tension + random.normal(sigmas.tension)).collect(),
                set: None,
            }
        });
        Record { robot, rows: rows.collect(), style: Style::default() }
    }

    fn noisy(&self, pose: &Pose, random: &mut Random) -> Pose {
        let (mut translation, mut turn) = ([0.0; 3], [0.0; 3]);
        let freedom = self.robot.freedom();
        freedom.axes.iter().for_each(|&axis| translation[axis] = random.normal(self.sigmas.position));
        if freedom.turns {
            turn = [(); 3].map(|()| random.normal(self.sigmas.rotation));
        }
        pose.moved(translation, turn)
    }
}
