//! Choices counted over fresh records: a machine that needs its anchors behind a coarse tracker, and one whose winches alone deviate. Started by
//! `cargo xtask soak --choices`.

use std::collections::BTreeMap;

use crate::geometry::Geometry;
use crate::in_turn::in_turn;
use crate::pose::{Pose, minus, plus, times};
use crate::random::Random;
use crate::robots::{RobotFile, RobotName};
use crate::scene::{Asked, Measuring, SIGMAS, Scene, Sigmas};
use crate::trial::{Bench, ask, write_files};
use crate::written::{self, Errors};

/// Mean position error that offsets alone leave of a machine that needs its anchors (m).
const LEFT: f64 = 1.27e-3;
/// Accuracies of its record, which the sidecar states, and rows of it.
const COARSE: Sigmas = Sigmas { position: 3e-3, rotation: 3e-3, ..SIGMAS };
const COARSE_ROWS: usize = 150;
/// Poses by which offsets are found without noise, and by which robots are judged.
const FITTED: usize = 300;
const JUDGED: usize = 60;

/// Candidates of which the richer one is the truth where anchors deviate.
const PAIR: &str = "standard:length-offset;standard:frame-anchor,length-offset";

/// Which truth a record has, and between what the command chooses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Truth {
    /// Anchors and offsets deviate, the tracker is coarse; the candidates are offsets alone and both.
    AnchorsOfPair,
    /// The same records with the default ladder.
    Anchors,
    /// Offsets alone deviate; the default ladder.
    Offsets,
}

/// Records of one truth, and how many of them may be missed.
struct Count {
    truth: Truth,
    records: u64,
    most_missed: usize,
}

const COUNTS: [Count; 3] = [
    Count { truth: Truth::AnchorsOfPair, records: 20, most_missed: 1 },
    Count { truth: Truth::Anchors, records: 20, most_missed: 1 },
    // one in ten
    Count { truth: Truth::Offsets, records: 200, most_missed: 20 },
];

/// Choice of the command on one record.
struct Choice {
    seed: u64,
    robot: RobotName,
    /// Name of the recommended candidate; `none` without one.
    recommended: String,
    is_right: bool,
    errors: Option<Errors>,
}

/// Prints both counts with the seeds that missed; complaints where more missed than may.
pub(crate) fn check(bench: &Bench, first: u64) -> Vec<String> {
    let mut complaints = Vec::new();
    for count in COUNTS {
        let seeds: Vec<u64> = (first..first + count.records).collect();
        let (mut choices, mut failed) = (Vec::new(), Vec::new());
        for outcome in in_turn(&seeds, |&seed| count.truth.chosen(seed, bench)) {
            match outcome {
                Ok(choice) => choices.push(choice),
                Err(complaint) => failed.push(complaint),
            }
        }
        println!("{}\n", text(&count, &choices));
        let missed = choices.iter().filter(|choice| !choice.is_right).count();
        complaints.extend(failed);
        if missed > count.most_missed {
            complaints.push(format!(
                "{}: {missed} of {} records missed, {} may be",
                count.truth.words(),
                count.records,
                count.most_missed
            ));
        }
    }
    complaints
}

/// The count, what was recommended how often, the mean error of the written robots, and the records that missed.
fn text(count: &Count, choices: &[Choice]) -> String {
    let right = choices.iter().filter(|choice| choice.is_right).count();
    let mut lines = vec![format!("{}: {right} of {} right", count.truth.words(), choices.len())];
    let mut by_name: BTreeMap<&str, (usize, f64)> = BTreeMap::new();
    for choice in choices {
        let (number, sum) = by_name.entry(&choice.recommended).or_default();
        *number += 1;
        *sum += choice.errors.map_or(f64::NAN, |errors| errors.position);
    }
    lines.extend(by_name.iter().map(|(name, (number, sum))| {
        format!("  {number:>4} × {name}, true error {:.2} mm", 1e3 * sum / *number as f64)
    }));
    let missed = choices.iter().filter(|choice| !choice.is_right);
    lines.extend(
        missed
            .map(|choice| format!("  missed: seed {} ({}): {}", choice.seed, choice.robot.word(), choice.recommended)),
    );
    lines.join("\n")
}

impl Truth {
    fn words(self) -> &'static str {
        match self {
            Self::AnchorsOfPair => "anchors and offsets deviate, tracker 3 mm, two candidates: recommended with both",
            Self::Anchors => "the same, default ladder: recommended with anchors",
            Self::Offsets => "offsets alone deviate: recommended without more",
        }
    }

    fn word(self) -> &'static str {
        match self {
            Self::AnchorsOfPair | Self::Anchors => "anchors",
            Self::Offsets => "offsets",
        }
    }

    /// True where anchors deviate.
    fn needs_anchors(self) -> bool {
        self != Self::Offsets
    }

    fn chosen(self, seed: u64, bench: &Bench) -> Result<Choice, String> {
        let folder = bench.folder.join(format!("choice-{}-{seed}", self.word()));
        let found = self.scene(seed).and_then(|scene| {
            write_files(&scene, &folder)?;
            let candidates = ["--candidates", PAIR];
            let answer = ask(&bench.command, &folder, if self == Self::AnchorsOfPair { &candidates } else { &[] })?;
            let errors = match std::fs::read_to_string(folder.join("out/calibrated.toml")) {
                Ok(text) => {
                    let written = written::robot(&text, scene.robot(), answer.elastic)?;
                    Some(written::errors(&written, &scene, &self.asked(&scene, seed)))
                }
                Err(_) => None,
            };
            let recommended = answer.recommended.unwrap_or_else(|| format!("none ({})", answer.reason));
            let is_right = self.is_right(&recommended);
            Ok(Choice { seed, robot: scene.robot(), recommended, is_right, errors })
        });
        if !bench.keep {
            // of a folder of our own; the next run has another
            let _ = std::fs::remove_dir_all(&folder);
        }
        found.map_err(|complaint| format!("{} {seed}: {complaint}", self.word()))
    }

    /// Whether the candidate is right: of two the richer one, of the ladder one that frees anchors where they deviate (alone they take up most of what offsets
    /// do), and offsets alone where nothing else deviates.
    fn is_right(self, candidate: &str) -> bool {
        let free: Vec<&str> = candidate.split_once(':').map_or(Vec::new(), |(_, free)| free.split(',').collect());
        match self {
            Self::AnchorsOfPair => ["frame-anchor", "length-offset"].iter().all(|name| free.contains(name)),
            Self::Anchors => free.contains(&"frame-anchor"),
            Self::Offsets => free == ["length-offset"],
        }
    }

    /// Files of a seed. Offsets alone are those of three robots in turn, and even seeds state accuracies.
    fn scene(self, seed: u64) -> Result<Scene, String> {
        let mut random = Random::of(self.word(), seed);
        let (robot, sigmas) = match self {
            Self::AnchorsOfPair | Self::Anchors => (RobotName::Box, COARSE),
            Self::Offsets => {
                let robots = [RobotName::Box, RobotName::Camera, RobotName::Plotter];
                (robots[usize::try_from(seed % 3).unwrap_or(0)], SIGMAS)
            }
        };
        let (file, mut machine) = (robot.file(), robot.machine(&mut random));
        let rows = match self {
            Self::AnchorsOfPair | Self::Anchors => COARSE_ROWS,
            Self::Offsets => {
                machine.frame_anchors.clone_from(&file.geometry.frame_anchors);
                robot.rows()
            }
        };
        let truth: Vec<Pose> = (0..rows).map(|_| self.pose(robot, &mut random)).collect();
        let stated = (self.needs_anchors() || seed.is_multiple_of(2)).then_some(sigmas);
        let measured = |machine: &Geometry, random: &mut Random| {
            let measuring = Measuring { robot, machine, sigmas, step: 5.0 };
            measuring.record(&truth, random)
        };
        let data = measured(&machine, &mut random);
        let mut scene = Scene { stated, ..Scene::unspoilt(file, machine, data, truth.clone()) };
        if self.needs_anchors() {
            self.scale_anchors(&mut scene, seed)?;
            scene.data = measured(&scene.machine, &mut random);
        }
        Ok(scene)
    }
    /// A pose of a record: where anchors deviate, in the inner part of the workspace.
    fn pose(self, robot: RobotName, random: &mut Random) -> Pose {
        match self {
            Self::AnchorsOfPair | Self::Anchors => robot.inner_pose(random),
            Self::Offsets => robot.random_pose(random, [0.0, 1.0]),
        }
    }

    /// The machine of a scene at other such poses, without noise.
    fn asked(self, scene: &Scene, seed: u64) -> Vec<Asked> {
        let mut random = Random::of("asked", seed);
        let ask = |_| {
            let pose = self.pose(scene.robot(), &mut random);
            scene.asked_at(pose, &mut random)
        };
        (0..JUDGED).map(ask).collect()
    }

    /// Makes the deviations of the anchors so large that offsets alone leave [`LEFT`].
    fn scale_anchors(self, scene: &mut Scene, seed: u64) -> Result<(), String> {
        for _ in 0..4 {
            let left = self.left_by_offsets(scene, seed);
            let factor = LEFT / left;
            if !(factor.is_finite() && factor > 0.0) {
                return Err(format!("offsets alone leave {left} m"));
            }
            let RobotFile { geometry, .. } = &scene.file;
            for (own, file) in scene.machine.frame_anchors.iter_mut().zip(&geometry.frame_anchors) {
                *own = plus(*file, times(minus(*own, *file), factor));
            }
        }
        Ok(())
    }

    /// Mean position error of the file's robot with the offsets that fit exact lengths best: the mean differences.
    fn left_by_offsets(self, scene: &Scene, seed: u64) -> f64 {
        let (robot, mut random) = (scene.robot(), Random::of("fitted", seed));
        let poses: Vec<Pose> = (0..FITTED).map(|_| self.pose(robot, &mut random)).collect();
        let mut fitted = scene.file.geometry.clone();
        for pose in &poses {
            let (wanted, own) = (scene.machine.recorded(pose, &[]), scene.file.geometry.recorded(pose, &[]));
            for (offset, (wanted, own)) in fitted.offsets.iter_mut().zip(wanted.iter().zip(&own)) {
                *offset += (wanted - own) / FITTED as f64;
            }
        }
        written::errors(&fitted, scene, &self.asked(scene, seed)).position
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn candidates_free_what_deviates_or_not() {
        let free = |list: &str| format!("standard:{list}");
        assert!(Truth::AnchorsOfPair.is_right(&free("frame-anchor,length-offset")));
        assert!(!Truth::AnchorsOfPair.is_right(&free("length-offset")));
        assert!(Truth::Anchors.is_right(&free("frame-anchor")) && !Truth::Anchors.is_right("standard"));
        assert!(!Truth::Anchors.is_right(&free("length-offset,length-scale")));
        assert!(Truth::Offsets.is_right(&free("length-offset")));
        assert!(!Truth::Offsets.is_right(&free("length-offset,length-scale")) && !Truth::Offsets.is_right("none"));
    }

    #[test]
    fn offsets_alone_leave_what_is_stated_and_of_offsets_nothing() {
        for seed in [1, 2] {
            let left = |truth: Truth| truth.left_by_offsets(&truth.scene(seed).unwrap(), seed);
            assert!((left(Truth::Anchors) / LEFT - 1.0).abs() < 0.01);
            assert!(left(Truth::Offsets) < 1e-6);
        }
    }
}
