//! Commands with parts, planned: their words, the files that they read, and how many parts there are.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::thread;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::failure::Failure;
use crate::parts::PartsTold;
use crate::session;
use crate::surroundings::{Files, PartsWanted, SharedFiles, Surroundings};
use cdpr_reports::answers::PROGRAM;

/// Stack of the thread that a command runs on (bytes), as much as systems give to the first one.
const STACK: usize = 8 << 20;

/// Everything that decides the answer of a command.
#[derive(Deserialize, Serialize)]
pub(super) struct CommandPlan {
    /// SHA-256 of all the rest.
    pub(super) fingerprint: String,
    /// The program that planned it; another one may compute other digits.
    program: String,
    /// Words of the command line after the name of the program.
    pub(super) command: Vec<String>,
    /// Files that the command reads.
    files: BTreeMap<PathBuf, Content>,
    /// Number of parts.
    pub(super) parts: usize,
}

/// Content of a file.
#[derive(Clone, Deserialize, Serialize)]
#[serde(untagged)]
enum Content {
    Text(String),
    /// Of a file that is no text in UTF-8.
    Bytes(Vec<u8>),
}

/// A command that went on to its end.
pub(super) struct Finished {
    pub(super) exit: ExitCode,
    pub(super) out: Vec<u8>,
    pub(super) err: Vec<u8>,
    /// Files that it wrote.
    pub(super) written: Files,
}

/// End of a run: at the parts, or behind them.
enum Run {
    Told(PartsTold),
    Finished(Finished),
}

impl CommandPlan {
    /// Returns the plan of a command line. The command runs up to its parts: an error if its words or files are wrong.
    pub(super) fn new(command: Vec<String>) -> Result<Self, Failure> {
        let (own, notes) = (session::files().unwrap_or_default(), SharedFiles::default());
        let surroundings = Surroundings {
            files: Some(own),
            parts: PartsWanted::Count,
            read: Some(notes.clone()),
            ..Surroundings::default()
        };
        let parts = match run(&command, surroundings)? {
            Run::Told(PartsTold::Count(parts)) => parts,
            Run::Told(_) => return Err(refused("it tells no number of parts")),
            Run::Finished(finished) => return Err(refused(&reason_of(&finished))),
        };
        let content = |bytes: Vec<u8>| {
            String::from_utf8(bytes).map_or_else(|error| Content::Bytes(error.into_bytes()), Content::Text)
        };
        let noted = std::mem::take(&mut *notes.lock());
        let files = noted.into_iter().map(|(path, bytes)| (path, content(bytes))).collect();
        let mut plan = Self { fingerprint: String::new(), program: PROGRAM.to_owned(), command, files, parts };
        plan.fingerprint = plan.digest();
        Ok(plan)
    }

    fn digest(&self) -> String {
        let rest = serde_json::json!([self.program, self.command, self.files, self.parts]);
        Sha256::digest(rest.to_string()).iter().fold(String::new(), |text, byte| format!("{text}{byte:02x}"))
    }

    /// True if the fingerprint is that of all the rest.
    pub(super) fn is_whole(&self) -> bool {
        self.fingerprint == self.digest()
    }

    /// A part, as JSON.
    pub(super) fn part(&self, part: usize) -> Result<Vec<u8>, Failure> {
        match run(&self.command, self.surroundings(PartsWanted::One(part)))? {
            Run::Told(PartsTold::One(bytes)) => Ok(bytes),
            Run::Told(PartsTold::Wrong(reason)) => Err(refused(&reason)),
            Run::Told(PartsTold::Count(_)) => Err(refused("it tells the number of its parts alone")),
            Run::Finished(finished) => Err(refused(&reason_of(&finished))),
        }
    }

    /// The answer with the parts given, in the format of these words.
    pub(super) fn answer(&self, parts: Vec<Vec<u8>>, format: &str) -> Result<Finished, Failure> {
        let words: Vec<String> =
            self.command.iter().cloned().chain(["--format".to_owned(), format.to_owned()]).collect();
        let surroundings = self.surroundings(PartsWanted::Given(Arc::new(parts)));
        let files = surroundings.files.clone().unwrap_or_default();
        match run(&words, surroundings)? {
            Run::Told(PartsTold::Wrong(reason)) => Err(refused(&reason)),
            Run::Told(_) => Err(refused("it takes no parts")),
            Run::Finished(finished) => {
                let mut written = std::mem::take(&mut *files.lock());
                written.retain(|path, _| !self.files.contains_key(path));
                Ok(Finished { written, ..finished })
            }
        }
    }

    fn surroundings(&self, parts: PartsWanted) -> Surroundings {
        let bytes = |content: &Content| match content {
            Content::Text(text) => text.clone().into_bytes(),
            Content::Bytes(bytes) => bytes.clone(),
        };
        let files = self.files.iter().map(|(path, content)| (path.clone(), bytes(content))).collect();
        Surroundings { files: Some(SharedFiles::new(files)), parts, ..Surroundings::default() }
    }
}

/// Runs a command on a thread of its own, whose session is no one else's.
fn run(command: &[String], surroundings: Surroundings) -> Result<Run, Failure> {
    let words = ["cdpr".to_owned()].into_iter().chain(command.iter().cloned()).map(Into::into).collect::<Vec<_>>();
    let work = move || {
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let exit = crate::run_within(words, surroundings, &mut out, &mut err);
        Finished { exit, out, err, written: Files::new() }
    };
    let started = thread::Builder::new().name("cdpr".to_owned()).stack_size(STACK).spawn(work);
    let started = started.map_err(|error| Failure::io("start", "a thread", &error))?;
    match started.join() {
        Ok(finished) => Ok(Run::Finished(finished)),
        Err(thrown) => match thrown.downcast::<PartsTold>() {
            Ok(told) => Ok(Run::Told(*told)),
            Err(thrown) => std::panic::resume_unwind(thrown),
        },
    }
}

/// Last words of a command that ended without its parts.
fn reason_of(finished: &Finished) -> String {
    let words = String::from_utf8_lossy(&finished.err).trim().to_owned();
    match words.is_empty() {
        true => {
            "its work has no parts: `benchmark`, `campaign --repeats` and `sensitivity` with tolerances have".to_owned()
        }
        false => words,
    }
}

fn refused(reason: &str) -> Failure {
    let help = "run the command itself first; with a study, `sensitivity` draws robots in parts";
    Failure::input("sweep::command", format!("this command cannot be planned: {reason}"), help)
}
