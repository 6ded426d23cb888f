//! Calls that share a folder, one after the other: files, inputs made by seed, and the calls whose answers are compared.

use crate::dirt::Dirt;

/// Calls in a folder of their own.
pub(crate) struct Group {
    /// First word of its calls' names.
    pub(crate) name: String,
    /// Whether `cargo xtask test` runs it, or the whole corpus alone.
    pub(crate) in_part: bool,
    pub(crate) steps: Vec<Step>,
}

/// A step in a group's folder.
pub(crate) enum Step {
    /// Writes a file.
    Write { file: String, text: String },
    /// Changes one passage of a file.
    Replace { file: String, from: String, to: String },
    /// Runs the command to make inputs; it must succeed, and its answer is not compared.
    Prepare(String),
    /// Writes a robot file whose anchors deviate from those of another, each coordinate by up to so many metres.
    Deviate { from: String, to: String, metres: f64, seed: u64 },
    /// Writes measurements spoilt in one way, with the same sidecar.
    Spoil { from: String, to: String, dirt: Dirt, seed: u64 },
    /// Runs the command; its answer and these files are compared.
    Call(Call),
}

/// A call of the command. `{shared}`, `{studies}`: folders; `{lengths}`, `{tensions}`: those of the latest answer that has them, rounded. Words in single
/// quotes may have blanks.
pub(crate) struct Call {
    pub(crate) words: String,
    /// Files that it writes and that are compared.
    pub(crate) files: Vec<String>,
}

impl Group {
    /// A group that the test runs, too.
    pub(crate) fn new(name: &str) -> Self {
        Self { name: name.to_owned(), in_part: true, steps: Vec::new() }
    }

    /// Leaves it to the whole corpus.
    pub(crate) fn whole_only(mut self) -> Self {
        self.in_part = false;
        self
    }

    fn step(mut self, step: Step) -> Self {
        self.steps.push(step);
        self
    }

    pub(crate) fn write(self, file: &str, text: &str) -> Self {
        self.step(Step::Write { file: file.to_owned(), text: text.to_owned() })
    }

    pub(crate) fn replace(self, file: &str, from: &str, to: &str) -> Self {
        self.step(Step::Replace { file: file.to_owned(), from: from.to_owned(), to: to.to_owned() })
    }

    pub(crate) fn prepare(self, words: &str) -> Self {
        self.step(Step::Prepare(words.to_owned()))
    }

    pub(crate) fn deviate(self, from: &str, to: &str, metres: f64, seed: u64) -> Self {
        self.step(Step::Deviate { from: from.to_owned(), to: to.to_owned(), metres, seed })
    }

    pub(crate) fn spoil(self, from: &str, to: &str, dirt: Dirt, seed: u64) -> Self {
        self.step(Step::Spoil { from: from.to_owned(), to: to.to_owned(), dirt, seed })
    }

    pub(crate) fn call(self, words: &str) -> Self {
        self.call_and_read(words, &[])
    }

    /// A call, and files that it writes.
    pub(crate) fn call_and_read(self, words: &str, files: &[&str]) -> Self {
        let files = files.iter().map(|file| (*file).to_owned()).collect();
        self.step(Step::Call(Call { words: words.to_owned(), files }))
    }

    /// A call for each of some words, which stand for `%`.
    pub(crate) fn calls(self, pattern: &str, words: &[&str]) -> Self {
        words.iter().fold(self, |group, word| group.call(&pattern.replace('%', word)))
    }

    /// Names of its calls, by which their answers are stored.
    pub(crate) fn names(&self) -> impl Iterator<Item = String> {
        let of_call = |step: &Step| match step {
            Step::Call(call) => Some(self.name_of(call)),
            _ => None,
        };
        self.steps.iter().filter_map(of_call)
    }

    pub(crate) fn name_of(&self, call: &Call) -> String {
        format!("{}: {}", self.name, call.words)
    }

    /// Whether a call or the robot of one is read in `../shared`.
    pub(crate) fn reads_shared(&self) -> bool {
        self.steps.iter().any(|step| match step {
            Step::Call(Call { words, .. }) | Step::Prepare(words) => words.contains("{shared}"),
            Step::Deviate { from, .. } | Step::Spoil { from, .. } => from.contains("{shared}"),
            Step::Write { text, .. } | Step::Replace { to: text, .. } => text.contains("{shared}"),
        })
    }
}
