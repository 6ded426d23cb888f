//! Runs groups of calls, two at a time.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::answer;
use crate::dirt;
use crate::group::{Call, Group, Step};

/// Groups that run at the same time.
const THREADS: usize = 2;
/// Commands that print text for people or files for programs: exit status alone.
const WORDS_ONLY: [&str; 5] = ["schema", "explain", "completions", "man", "help"];

/// Places that calls read.
pub(crate) struct Places {
    /// The command that is asked.
    pub(crate) command: PathBuf,
    pub(crate) studies: PathBuf,
    pub(crate) shared: PathBuf,
    /// Folder of the groups' folders.
    pub(crate) scratch: PathBuf,
}

/// Answers by the names of their calls, and the time of each.
#[derive(Default)]
pub(crate) struct Answers {
    pub(crate) values: BTreeMap<String, Value>,
    pub(crate) times: Vec<(Duration, String)>,
    /// What kept calls from being made, a line each.
    pub(crate) complaints: Vec<String>,
}

/// Runs the groups in their order on [`THREADS`] threads.
pub(crate) fn run(groups: &[&Group], places: &Places) -> Answers {
    let (next, answers) = (AtomicUsize::new(0), Mutex::new(Answers::default()));
    let work = || {
        while let Some(group) = groups.get(next.fetch_add(1, Ordering::Relaxed)) {
            let of_group =
                Worker { group, places, lengths: String::new(), tensions: String::new(), answers: Answers::default() }
                    .run();
            let mut sum = answers.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            sum.values.extend(of_group.values);
            sum.times.extend(of_group.times);
            sum.complaints.extend(of_group.complaints);
        }
    };
    std::thread::scope(|scope| (0..THREADS).for_each(|_| drop(scope.spawn(work))));
    answers.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner)
}

/// A group at work.
struct Worker<'a> {
    group: &'a Group,
    places: &'a Places,
    /// Lengths and tensions of the latest answers that had some.
    lengths: String,
    tensions: String,
    answers: Answers,
}

impl Worker<'_> {
    fn run(mut self) -> Answers {
        let folder = self.folder();
        if let Err(error) = std::fs::create_dir_all(&folder) {
            self.complain(&format!("{}: {error}", folder.display()));
            return self.answers;
        }
        for step in &self.group.steps {
            if let Err(complaint) = self.step(step) {
                self.complain(&complaint);
            }
        }
        self.answers
    }

    fn complain(&mut self, words: &str) {
        self.answers.complaints.push(format!("{}: {words}", self.group.name));
    }

    fn folder(&self) -> PathBuf {
        self.places.scratch.join(&self.group.name)
    }

    fn step(&mut self, step: &Step) -> Result<(), String> {
        match step {
            Step::Write { file, text } => write(&self.folder().join(file), &self.in_place(text)),
            Step::Replace { file, from, to } => {
                let text = read(&self.path(file))?;
                match text.contains(from) {
                    true => write(&self.path(file), &text.replacen(from, to, 1)),
                    false => Err(format!("{file} has no `{from}`")),
                }
            }
            Step::Prepare(words) => self.prepare(words),
            Step::Deviate { from, to, metres, seed } => {
                let text = read(&self.path(from))?;
                write(&self.path(to), &dirt::deviating(&text, *metres, *seed))
            }
            Step::Spoil { from, to, dirt, seed } => {
                let text = read(&self.path(from))?;
                write(&self.path(to), &dirt.on(&text, *seed))?;
                let [from, to] = [from, to].map(|file| self.path(file).with_extension("meta.toml"));
                if from.is_file() { write(&to, &read(&from)?) } else { Ok(()) }
            }
            Step::Call(call) => self.call(call),
        }
    }

    fn path(&self, file: &str) -> PathBuf {
        self.folder().join(self.in_place(file))
    }

    fn prepare(&mut self, words: &str) -> Result<(), String> {
        let output = self.command(words)?;
        let talk = String::from_utf8_lossy(&output.stderr).into_owned();
        if output.status.success() { Ok(()) } else { Err(format!("cdpr {words}: {}\n{talk}", output.status)) }
    }

    fn call(&mut self, call: &Call) -> Result<(), String> {
        let start = Instant::now();
        let output = self.command(&call.words)?;
        let name = self.group.name_of(call);
        self.answers.times.push((start.elapsed(), name.clone()));
        let found: Value = serde_json::from_slice(&output.stdout).unwrap_or(Value::Null);
        let subcommand = call.words.split(' ').next().unwrap_or_default();
        let mut answer = json!({"exit": output.status.code()});
        if !WORDS_ONLY.contains(&subcommand) {
            answer["answer"] = answer::compared(&self.without_places(&found), &mut Vec::new());
        }
        for file in &call.files {
            answer["files"][file] = answer::of_file(&self.folder().join(file));
        }
        self.answers.values.insert(name, answer);
        self.lengths = list(&found["controlled_lengths_m"], 4).unwrap_or_else(|| std::mem::take(&mut self.lengths));
        self.tensions = list(&found["tensions_N"], 2).unwrap_or_else(|| std::mem::take(&mut self.tensions));
        Ok(())
    }

    fn command(&self, words: &str) -> Result<std::process::Output, String> {
        let mut command = Command::new(&self.places.command);
        command.args(split(&self.in_place(words))).args(["--format", "json", "--threads", "1"]);
        command.current_dir(self.folder()).stdin(Stdio::null()).env("NO_COLOR", "1");
        command.output().map_err(|error| format!("{}: {error}", self.places.command.display()))
    }

    /// Words with places, and numbers of answers before.
    fn in_place(&self, words: &str) -> String {
        let shown = |path: &Path| path.display().to_string();
        let words = words.replace("{shared}", &shown(&self.places.shared));
        let words = words.replace("{studies}", &shown(&self.places.studies));
        words.replace("{lengths}", &self.lengths).replace("{tensions}", &self.tensions)
    }

    /// The answer with names of folders that are the same on every machine.
    fn without_places(&self, answer: &Value) -> Value {
        match answer {
            Value::String(text) => {
                let text = text.replace(&self.places.shared.display().to_string(), "{shared}");
                Value::from(text.replace(&self.places.studies.display().to_string(), "{studies}"))
            }
            Value::Array(list) => list.iter().map(|value| self.without_places(value)).collect(),
            Value::Object(entries) => {
                entries.iter().map(|(key, value)| (key.clone(), self.without_places(value))).collect()
            }
            other => other.clone(),
        }
    }
}

/// Numbers of a list, rounded so that what rounding left of them is the same for every build; `None` if there are none.
fn list(value: &Value, digits: usize) -> Option<String> {
    let numbers: Vec<f64> = value.as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
    Some(numbers.iter().map(|number| format!("{number:.digits$}")).collect::<Vec<_>>().join(","))
}

/// Words between blanks, and those in single quotes as one.
fn split(words: &str) -> Vec<String> {
    let parts = words.split('\'').enumerate();
    parts
        .flat_map(|(index, part)| match index % 2 {
            0 => part.split_whitespace().map(str::to_owned).collect(),
            _ => vec![part.to_owned()],
        })
        .collect()
}

fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    std::fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_in_quotes_stay_together() {
        assert_eq!(
            split("sensitivity s.toml --map 'machine frame-anchor[1].x'"),
            ["sensitivity", "s.toml", "--map", "machine frame-anchor[1].x"]
        );
    }
}
