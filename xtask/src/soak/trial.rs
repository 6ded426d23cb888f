//! Random robots through the command that users get: no panic, an exit code that is documented, an end in bounded time.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use super::random::Random;
use super::robots::{RobotFile, Size, number};

/// Processor time that one command may take (s); all its threads together.
const LONGEST: u32 = 60;
/// Memory that one command may claim (KiB).
const MEMORY: u32 = 8 << 20;
/// Runs spent on making a finding smaller.
const SHRINKING: usize = 60;

/// A robot file, the files beside it, and the commands that read them, one after the other.
#[derive(Clone)]
struct Case {
    robot: RobotFile,
    study: String,
    commands: Vec<String>,
}

/// Behaviour that a command must not show.
#[derive(Clone, Debug, PartialEq)]
enum Fault {
    /// An exit code that no page of the book names, such as that of a panic.
    Code(i32),
    /// Ended by the system: out of time, out of memory, a stack that overflowed.
    Killed,
    /// A number that is none in an answer for people.
    NaN,
}

/// A part of a round: random robots of a seed until a time.
pub(super) struct Trial<'a> {
    pub(super) program: &'a Path,
    pub(super) seed: u64,
    pub(super) end: Instant,
    /// Findings after which it ends.
    pub(super) most: usize,
}

/// Outcome of a trial.
pub(super) struct Tried {
    /// Commands that ran.
    pub(super) commands: usize,
    pub(super) findings: Vec<String>,
}

/// Runs random robots through the command.
pub(super) fn run(trial: &Trial<'_>) -> Result<Tried, String> {
    let Trial { program, seed, end, most } = *trial;
    let folder = std::env::temp_dir().join(format!("cdpr-soak-{}", std::process::id()));
    std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut tried = Tried { commands: 0, findings: Vec::new() };
    for index in 0.. {
        if Instant::now() >= end || tried.findings.len() >= most {
            break;
        }
        let case = Case::random(&mut Random::new(seed.wrapping_mul(1_000_003).wrapping_add(index)));
        tried.commands += case.commands.len();
        let Some((fault, command, words)) = case.fault(program, &folder)? else { continue };
        println!("seed {seed}, robot {index}: {fault:?} of `cdpr {command}`");
        let smaller = Case { commands: vec![command.clone()], ..case.clone() };
        let kept = if smaller.shows(&fault, program, &folder)? { smaller } else { case };
        let least = kept.shrunk(&fault, program, &folder)?;
        let Case { robot, study, commands } = &least;
        tried.findings.push(format!(
            "seed {seed}, robot {index}: {fault:?}\n{words}\n$ cdpr {}\nrobot.toml:\n{}\nstudy.toml:\n{study}",
            commands.join("\n$ cdpr "),
            robot.text()
        ));
    }
    println!("{} commands on random robots", tried.commands);
    let _ = std::fs::remove_dir_all(&folder);
    Ok(tried)
}

impl Case {
    fn random(random: &mut Random) -> Self {
        let (robot, size) = RobotFile::random(random);
        let [model, control] = [(); 2].map(|()| size.effects.model(random));
        let wild = random.pick(&[0.0, 0.0, 0.05]);
        let mut numbers = |count: usize, least: f64, most: f64| {
            (0..count).map(|_| number(random, least, most, wild)).collect::<Vec<_>>().join(",")
        };
        let pose = numbers(size.dof, -1.0, 1.0);
        let corners = [numbers(size.dof, -1.0, 0.0), numbers(size.dof, 0.0, 1.0)];
        let lists =
            [numbers(size.cables, 1.0, 9.0), numbers(size.cables, 0.0, 2000.0), numbers(size.dof, -500.0, 500.0)];
        let study = study(&pose, &corners, size, [&control, &model]);
        let mut commands = of_robot(&pose, &model, &lists, size);
        commands.extend(of_study(&model));
        // some of them: many robots find more than many commands
        let kept: Vec<String> = (0..6).map(|_| commands[random.below(commands.len())].clone()).collect();
        let simulate = kept.iter().any(|command| command.contains("data.csv"));
        let first = simulate.then(|| "simulate study.toml --out data.csv".to_owned());
        Self { robot, study, commands: first.into_iter().chain(kept).collect() }
    }

    /// The first fault, its command, and what the command said.
    fn fault(&self, program: &Path, folder: &Path) -> Result<Option<(Fault, String, String)>, String> {
        for (name, text) in [("robot.toml", self.robot.text()), ("study.toml", self.study.clone())] {
            std::fs::write(folder.join(name), text).map_err(|error| format!("{name}: {error}"))?;
        }
        // of the robot before
        let _ = std::fs::remove_file(folder.join("data.csv"));
        for command in &self.commands {
            if let Some((fault, words)) = fault_of(program, folder, command)? {
                return Ok(Some((fault, command.clone(), words)));
            }
        }
        Ok(None)
    }

    fn shows(&self, fault: &Fault, program: &Path, folder: &Path) -> Result<bool, String> {
        Ok(self.fault(program, folder)?.is_some_and(|(other, ..)| other == *fault))
    }

    /// Leaves out tables and lines as long as the fault stays.
    fn shrunk(mut self, fault: &Fault, program: &Path, folder: &Path) -> Result<Self, String> {
        // what takes long to fail is told as it is
        let mut runs = if *fault == Fault::Killed { 6 } else { SHRINKING };
        let mut table = self.robot.tables.len();
        while table > 0 && runs > 0 {
            table -= 1;
            for line in (0..self.robot.tables[table].len()).take(runs) {
                let mut smaller = self.clone();
                match line {
                    // the whole table first
                    0 => drop(smaller.robot.tables.remove(table)),
                    _ => drop(smaller.robot.tables[table].remove(self.robot.tables[table].len() - line)),
                }
                runs -= 1;
                if smaller.shows(fault, program, folder)? {
                    self = smaller;
                    table += usize::from(line > 0);
                    break;
                }
            }
        }
        Ok(self)
    }
}

/// The fault that one command showed, and its words.
fn fault_of(program: &Path, folder: &Path, words: &str) -> Result<Option<(Fault, String)>, String> {
    let mut command = if cfg!(unix) {
        let mut shell = Command::new("sh");
        shell.arg("-c").arg(format!("ulimit -t {LONGEST}; ulimit -v {MEMORY}; exec \"$0\" \"$@\"")).arg(program);
        shell
    } else {
        Command::new(program)
    };
    command.args(words.split_whitespace()).current_dir(folder).stdin(Stdio::null());
    let output = command.output().map_err(|error| format!("{}: {error}", program.display()))?;
    let [answer, talk] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
    let fault = match output.status.code() {
        None => Some(Fault::Killed),
        Some(code) if !(0..=4).contains(&code) => Some(Fault::Code(code)),
        Some(_) => (answer.contains("NaN ") || talk.contains("NaN ")).then_some(Fault::NaN),
    };
    Ok(fault.map(|fault| {
        let relevant = |line: &&str| line.contains("panicked") || line.contains("NaN") || line.contains("overflow");
        let lines: Vec<&str> = talk.lines().chain(answer.lines()).filter(relevant).take(5).collect();
        (fault, lines.join("\n"))
    }))
}

fn study(pose: &str, [least, most]: &[String; 2], size: Size, [control, machine]: [&str; 2]) -> String {
    let count = vec!["2"; size.translations].into_iter().chain(vec!["1"; size.dof - size.translations]);
    let count = count.collect::<Vec<_>>().join(", ");
    format!(
        "[control]\nrobot = \"robot.toml\"\nmodel = \"{control}\"\n\n[machine]\nrobot = \"robot.toml\"\nmodel = \"{machine}\"\n\n\
         [initial]\npose = [{pose}]\n\n[poses.grid]\nmin = [{least}]\nmax = [{most}]\ncount = [{count}]\n\n\
         [noise]\nposition_m = 1e-3\nlength_m = 1e-4\ntension_N = 10.0\n"
    )
}

fn of_robot(pose: &str, model: &str, [lengths, tensions, wrench]: &[String; 3], size: Size) -> Vec<String> {
    let bounds = if size.translations == 2 { "-2,2,-2,2" } else { "-2,2,-2,2,-2,2" };
    let axis = if size.translations == 2 { "0,1" } else { "0,0,1" };
    let mut commands: Vec<String> = [
        "check robot.toml".to_owned(),
        format!("ik robot.toml --pose {pose} --model {model}"),
        format!("ik robot.toml --pose {pose} --model {model} --tensions {tensions}"),
        format!("fk robot.toml --lengths {lengths} --model {model}"),
        format!("fk robot.toml --lengths {lengths} --model {model} --wrench {wrench} --guess {pose}"),
        format!("fk robot.toml --tensions {tensions} --wrench {wrench}"),
        format!("load robot.toml --pose {pose} --tensions {tensions} --model {model}"),
        format!("stiffness robot.toml --pose {pose} --tensions {tensions} --model {model}"),
        format!("stiffness robot.toml --pose {pose} --wrench {wrench}"),
        format!("model robot.toml --pose {pose} --tensions {tensions}"),
        format!("model robot.toml --pose {pose}"),
        format!("place-pulleys robot.toml --radius 0.1 --axis {axis} --pose {pose} --out placed.toml"),
        format!("advise robot.toml --task {bounds} --accuracy 0.01 --count 2"),
    ]
    .into();
    for method in tension_methods() {
        commands
            .push(format!("tension robot.toml --pose {pose} --wrench {wrench} --min 0 --max 5000 --method {method}"));
    }
    for method in ["grid --step 1", "octree --step 0.5", "hull --rays 40"] {
        commands.push(format!("workspace robot.toml --bounds {bounds} --method {method}"));
        commands.push(format!("workspace robot.toml --min 1 --max 5000 --method {method}"));
    }
    let criteria = [
        "wrench-closure",
        "wrench-set-feasible:force=10,moment=1",
        "stiffness:least=1",
        "stability",
        "natural-frequency:least=1",
        "condition:largest=100",
        "dexterity:least=0.01",
        "cable-interference:diameter=0.01",
        "platform-interference",
        "validity",
    ];
    for criterion in criteria {
        commands
            .push(format!("workspace robot.toml --bounds {bounds} --step 1 --model {model} --criterion {criterion}"));
    }
    let angles = if size.dof == 6 { "-0.2,0.2,2,0,0,1,-0.2,0.2,2" } else { "-0.2,0.2,3" };
    for archetype in ["total-orientation", "inclusion-orientation", "maximal", "dextrous"] {
        let words = format!("--step 1 --archetype {archetype} --angles {angles}");
        commands.push(format!("workspace robot.toml --bounds {bounds} --min 1 --max 5000 {words}"));
    }
    commands
}

/// Names of the methods of tension distribution, from the schema of studies.
fn tension_methods() -> Vec<&'static str> {
    let schema = include_str!("../../../schemas/study.schema.json");
    let choices = schema.split_once("\"Method\": {").map_or("", |(_, behind)| behind);
    let choices = choices.split_once(']').map_or(choices, |(inside, _)| inside);
    choices.split("\"const\": \"").skip(1).filter_map(|choice| choice.split('"').next()).collect()
}

fn of_study(model: &str) -> Vec<String> {
    let commands = [
        "accuracy study.toml".to_owned(),
        "sensitivity study.toml --robots 5".to_owned(),
        "study study.toml --out folder".to_owned(),
        "reachable study.toml --step 1".to_owned(),
        "reachable study.toml --method hull --rays 20".to_owned(),
        "initial-tension study.toml".to_owned(),
        format!("evaluate robot.toml data.csv --model {model}"),
        "identify robot.toml data.csv --free length-offset".to_owned(),
        format!(
            "identify robot.toml data.csv --model {model} --free frame-anchor,length-offset --prior frame-anchor=0.01"
        ),
        "select robot.toml data.csv --split blocks:2".to_owned(),
    ];
    commands.into()
}
