//! Cells: a kind of dirt, a robot and a seed; their files, the command's answer, and the verdict on it.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::answer::Answer;
use crate::kinds::{Kind, Place};
use crate::random::Random;
use crate::robots::RobotName;
use crate::scene::{SIGMAS, Scene};
use crate::verdict::Verdict;
use crate::written::{self, Errors};

/// A cell of the table.
#[derive(Clone, Copy)]
pub(crate) struct Cell {
    pub(crate) kind: &'static Kind,
    pub(crate) robot: RobotName,
    pub(crate) seed: u64,
}

/// Outcome of a cell.
pub(crate) struct Outcome {
    pub(crate) cell: Cell,
    pub(crate) place: Place,
    pub(crate) answer: Answer,
    pub(crate) errors: Option<Errors>,
    pub(crate) verdict: Verdict,
}

/// Where cells are run.
pub(crate) struct Bench {
    /// The command that answers.
    pub(crate) command: PathBuf,
    /// Folder of the cells' folders.
    pub(crate) folder: PathBuf,
    /// Leaves the cells' folders.
    pub(crate) keep: bool,
}

impl Cell {
    pub(crate) fn name(&self) -> String {
        format!("{}/{}/{}", self.kind.name, self.robot.word(), self.seed)
    }

    pub(crate) fn states_accuracies(&self) -> bool {
        self.kind.states_accuracies(self.seed)
    }

    /// The spoilt scene, and the place of its dirt.
    pub(crate) fn scene(&self) -> (Scene, Place) {
        let Self { kind, robot, seed } = *self;
        let mut scene = Scene::of(robot, seed, kind.layout, kind.name);
        scene.stated = self.states_accuracies().then_some(SIGMAS);
        let mut random = Random::of(&format!("dirt {} {}", kind.name, robot.word()), seed);
        let place = (kind.spoil)(&mut scene, &mut random);
        (scene, place)
    }

    /// Writes the files, asks the command, and judges.
    pub(crate) fn run(&self, bench: &Bench) -> Result<Outcome, String> {
        let (scene, place) = self.scene();
        let folder = bench.folder.join(self.name().replace('/', "-"));
        let outcome = self.judged(&scene, place, &folder, &bench.command);
        if !bench.keep {
            // of a folder of our own; the next run has another
            let _ = std::fs::remove_dir_all(&folder);
        }
        outcome.map_err(|complaint| format!("{}: {complaint}", self.name()))
    }

    fn judged(&self, scene: &Scene, place: Place, folder: &Path, command: &Path) -> Result<Outcome, String> {
        write_files(scene, folder)?;
        let answer = ask(command, folder, if scene.validation.is_some() { &VALIDATED } else { &[] })?;
        let errors = match std::fs::read_to_string(folder.join("out/calibrated.toml")) {
            Ok(text) => {
                let written = written::robot(&text, self.robot, answer.elastic)?;
                let asked = scene.asked(&mut Random::of("asked", self.seed));
                Some(written::errors(&written, scene, &asked))
            }
            Err(_) => None,
        };
        let verdict = Verdict::of(self.kind, &place, &answer, errors);
        Ok(Outcome { cell: *self, place, answer, errors, verdict })
    }
}

pub(crate) fn write_files(scene: &Scene, folder: &Path) -> Result<(), String> {
    let error = |error: std::io::Error| format!("{}: {error}", folder.display());
    std::fs::create_dir_all(folder).map_err(error)?;
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).map_err(error);
    write("robot.toml", &scene.file.text())?;
    let records = [("data", Some(&scene.data)), ("validation", scene.validation.as_ref())];
    for (name, record) in records.into_iter().filter_map(|(name, record)| Some((name, record?))) {
        write(&format!("{name}.csv"), &record.csv())?;
        if let Some(sidecar) = scene.sidecar() {
            write(&format!("{name}.meta.toml"), &sidecar)?;
        }
    }
    Ok(())
}

/// Words for a record to validate by.
const VALIDATED: [&str; 2] = ["--validation", "validation.csv"];

/// Answer of the command to the files of a folder, with more words than those of every call.
pub(crate) fn ask(program: &Path, folder: &Path, more: &[&str]) -> Result<Answer, String> {
    let mut command = Command::new(program);
    command.args(["select", "robot.toml", "data.csv", "--format", "json", "--quiet", "--out", "out"]);
    command.args(["--threads", "1"]);
    command.args(more);
    command.current_dir(folder).stdin(Stdio::null()).env("NO_COLOR", "1");
    let output = command.output().map_err(|error| format!("{}: {error}", program.display()))?;
    let talk = String::from_utf8_lossy(&output.stderr).into_owned();
    let exit = output.status.code().filter(|code| (0..=2).contains(code));
    let exit = exit.ok_or_else(|| format!("the command ended with {}: {talk}", output.status))?;
    Answer::of(exit, &String::from_utf8_lossy(&output.stdout))
}

impl Outcome {
    /// The first finding: kind, cable and line; the code of a refusal; `-` without any.
    pub(crate) fn first(&self) -> String {
        if self.answer.is_refusal() {
            return self.answer.code.clone();
        }
        let Some(found) = self.answer.findings.first() else { return "-".to_owned() };
        let place = [("cable", found.cable), ("line", found.line)];
        let place = place.iter().filter_map(|(word, number)| Some(format!(" {word} {}", (*number)?)));
        format!("{}{}", found.kind, place.collect::<String>())
    }

    /// The cell in a line: what was told and found, and what was the truth.
    pub(crate) fn words(&self) -> String {
        let millimetres = |errors: Option<Errors>| {
            errors
                .map_or("none".to_owned(), |it| format!("{:.1} mm {:.2}°", 1e3 * it.position, it.rotation.to_degrees()))
        };
        let Place { cable, lines } = &self.place;
        let cable = cable.map(|cable| format!(", cable {cable}")).unwrap_or_default();
        let lines = if lines.is_empty() { String::new() } else { format!(", line {lines:?}") };
        format!(
            "{}: first finding `{}`, {} (exit {}); dirt: {}{cable}{lines}; error {}, told {}",
            self.cell.name(),
            self.first(),
            if self.answer.status.is_empty() { "refused" } else { &self.answer.status },
            self.answer.exit,
            self.cell.kind.name,
            millimetres(self.errors),
            millimetres(self.answer.told),
        )
    }
}
