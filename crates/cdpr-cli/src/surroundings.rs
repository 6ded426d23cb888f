//! The program that a run of the command goes on in: files in memory, a taker of progress that may stop the work.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use cdpr_plant::Controller;

/// Files of a run in memory: it reads them before those of the disk, and writes here alone.
pub type Files = BTreeMap<PathBuf, Vec<u8>>;

/// Work that goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct WorkDone<'a> {
    /// The work, named by what it does, e.g. `comparing candidates`.
    pub name: &'a str,
    /// Parts that are done.
    pub done: usize,
    /// Number of all parts; `None` if it is not known.
    pub parts: Option<usize>,
}

/// Takes progress from any thread of the work, and says whether it shall go on.
pub type Observer = Arc<dyn Fn(WorkDone<'_>) -> ControlFlow<()> + Send + Sync>;

/// Things that another program brings to a run.
#[derive(Clone, Default)]
#[non_exhaustive]
pub struct Host {
    /// Files in memory: read before those of the disk, and written alone. Afterwards those of the run are among them.
    pub files: Files,
    /// Taker of progress. If it breaks, the run ends at the next step of its work.
    pub observe: Option<Observer>,
    /// Controller of the machine of `run`, in place of the scenario's.
    pub controller: Option<Box<dyn Controller>>,
}

/// The program that a run goes on in; nothing of it for a run from a shell.
#[derive(Clone, Default)]
pub(crate) struct Surroundings {
    /// Files in memory.
    pub(crate) files: Option<SharedFiles>,
    /// Taker of progress.
    pub(crate) observe: Option<Observer>,
    /// Controller of a machine in time.
    pub(crate) controller: Option<Box<dyn Controller>>,
    /// Work that is wanted of a command's parts.
    pub(crate) parts: PartsWanted,
    /// Files of the disk that the run has read, where they are noted.
    pub(crate) read: Option<SharedFiles>,
}

impl Host {
    /// A program that has only files to bring.
    pub fn with_files(files: Files) -> Self {
        Self { files, ..Self::default() }
    }
}

/// Work that a run does of its parts.
#[derive(Clone, Default)]
pub(crate) enum PartsWanted {
    /// All.
    #[default]
    All,
    /// Only their number.
    Count,
    /// One of them.
    One(usize),
    /// None: these are the parts, as JSON.
    Given(Arc<Vec<Vec<u8>>>),
}

/// Files that the parts of a run share.
#[derive(Clone, Debug, Default)]
pub(crate) struct SharedFiles(Arc<Mutex<Files>>);

impl SharedFiles {
    /// Files to begin with.
    pub(crate) fn new(files: Files) -> Self {
        Self(Arc::new(Mutex::new(files)))
    }

    /// The files, for one thread at a time.
    pub(crate) fn lock(&self) -> MutexGuard<'_, Files> {
        // files are put in whole, whatever panicked
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The bytes of a file; `None` if it is not among them.
    pub(crate) fn get(&self, path: &Path) -> Option<Vec<u8>> {
        self.lock().get(path).cloned()
    }

    /// Paths of the files directly in a folder.
    pub(crate) fn in_folder(&self, folder: &Path) -> Vec<PathBuf> {
        self.lock().keys().filter(|path| path.parent() == Some(folder)).cloned().collect()
    }
}

/// Thrown through a calculation that the observer stops and that cannot end by itself.
pub(crate) struct Stopped;

/// Leaves a calculation whose observer wants no more of it.
pub(crate) fn stop() -> ! {
    // no hook is called: this is no fault
    resume_unwind(Box::new(Stopped))
}
