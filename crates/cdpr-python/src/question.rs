//! Questions that the command answers, asked with files in memory, and the command itself.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use cdpr::plant::Controller;
use cdpr_cli::{Files, Host, Observer, WorkDone, run, run_in, watch_for_interruptions};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::controller::OwnController;

/// Stack of the thread that answers, as systems give it to the first one of a process (bytes).
const STACK: usize = 8 << 20;

/// Time between two looks at signals and progress.
const LOOK: Duration = Duration::from_millis(50);

/// Work that goes on on another thread.
#[derive(Default)]
struct Watched {
    is_stopped: AtomicBool,
    /// Name, parts done and all parts of the work, if they changed since the last look.
    latest: Mutex<Option<(String, usize, Option<usize>)>>,
}

/// An answer with its files.
struct Answered {
    exit: ExitCode,
    out: Vec<u8>,
    err: Vec<u8>,
    files: Files,
}

/// Answers a command line with files in memory. Returns exit code, standard output, standard error and all files.
///
/// `observe(name, done, parts)` is called as the work goes on, `parts` being `None` if it is not known. Interruptions and exceptions of
/// `observe` stop the work. `controller` commands the machine of `run`.
#[pyfunction]
#[pyo3(signature = (words, files, observe=None, controller=None))]
pub(crate) fn ask<'py>(
    py: Python<'py>,
    words: Vec<String>,
    files: BTreeMap<PathBuf, Vec<u8>>,
    observe: Option<Bound<'py, PyAny>>,
    controller: Option<Bound<'py, PyAny>>,
) -> PyResult<(u8, Bound<'py, PyBytes>, String, Bound<'py, PyDict>)> {
    let watched = Arc::new(Watched::default());
    let (done, mut answers) = mpsc::channel();
    let note = Arc::clone(&watched);
    let controller = controller.map(|object| OwnController::of(&object)).transpose()?;
    let raised = controller.as_ref().map(OwnController::raised);
    let spawned = thread::Builder::new().name("cdpr".to_owned()).stack_size(STACK).spawn(move || {
        let observe: Observer = Arc::new(move |work| note.note(work));
        let mut host = Host::with_files(files);
        host.observe = Some(observe);
        let is_ours = controller.is_some();
        host.controller = controller.map(|own| Box::new(own) as Box<dyn Controller>);
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let line = ["cdpr".to_owned()].into_iter().chain(words).map(OsString::from);
        let run = || run_in(line, &mut host, &mut out, &mut err);
        // a controller in Python is asked at every step: attaching once is cheaper than each time
        let exit = if is_ours { Python::attach(|_| run()) } else { run() };
        // a caller who was interrupted waits no more
        let _ = done.send(Answered { exit, out, err, files: host.files });
    });
    spawned.map_err(|error| PyRuntimeError::new_err(format!("cannot start a thread: {error}")))?;
    let Answered { exit, out, err, files } = loop {
        match py.detach(|| next(&mut answers)) {
            Ok(answered) => break answered,
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the calculation failed; this is a fault of cdpr"));
            }
        }
        let told = py.check_signals().and_then(|()| watched.tell(observe.as_ref()));
        if let Err(error) = told {
            watched.is_stopped.store(true, Ordering::Relaxed);
            return Err(error);
        }
    };
    watched.tell(observe.as_ref())?;
    if let Some(error) = raised.and_then(|raised| raised.take()) {
        return Err(error);
    }
    let dict = PyDict::new(py);
    for (path, content) in &files {
        dict.set_item(path.to_string_lossy(), PyBytes::new(py, content))?;
    }
    Ok((number(exit), PyBytes::new(py, &out), String::from_utf8_lossy(&err).into_owned(), dict))
}

/// Runs a command line, the first word being the program's name, as the program `cdpr` does. Returns its exit code.
#[pyfunction]
pub(crate) fn command(py: Python<'_>, words: Vec<String>) -> u8 {
    py.detach(|| {
        watch_for_interruptions();
        let line = words.into_iter().map(OsString::from);
        number(run(line, &mut std::io::stdout(), &mut std::io::stderr()))
    })
}

fn next(answers: &mut Receiver<Answered>) -> Result<Answered, RecvTimeoutError> {
    answers.recv_timeout(LOOK)
}

/// The number of an exit code, which the standard library keeps to itself.
fn number(exit: ExitCode) -> u8 {
    (0..=u8::MAX).find(|number| ExitCode::from(*number) == exit).unwrap_or(u8::MAX)
}

impl Watched {
    /// Keeps the progress for the next look; a break once the caller has been interrupted.
    fn note(&self, work: WorkDone<'_>) -> ControlFlow<()> {
        // words and counts are whole whatever panicked
        let mut latest = self.latest.lock().unwrap_or_else(PoisonError::into_inner);
        *latest = Some((work.name.to_owned(), work.done, work.parts));
        match self.is_stopped.load(Ordering::Relaxed) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    }

    fn tell(&self, observe: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let latest = self.latest.lock().unwrap_or_else(PoisonError::into_inner).take();
        match (observe, latest) {
            (Some(observe), Some(progress)) => observe.call1(progress).map(drop),
            _ => Ok(()),
        }
    }
}
