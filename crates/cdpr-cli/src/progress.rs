//! Signs of life on stderr for work that takes longer than a second.

use std::ops::ControlFlow;
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::session;

/// How long work may take before anything is shown.
const PATIENCE: Duration = Duration::from_secs(1);

/// A line on stderr that appears after a second and goes when this value goes; it does not appear if stderr is no terminal or
/// quiet was asked for.
pub(crate) struct Progress {
    bar: ProgressBar,
    done: Option<Sender<()>>,
    waiting: Option<JoinHandle<()>>,
}

impl Progress {
    /// Work whose length is not known, named by what it does.
    pub(crate) fn spinner(message: &str) -> Self {
        Self::start(None, "{spinner} {msg} {elapsed}", message)
    }

    /// Work in this many parts, named by what it does; [`Self::step`] tells of each part that is done.
    pub(crate) fn of(parts: usize, message: &str) -> Self {
        let left = "{spinner} {msg} [{bar:20}] {pos} of {len}, {elapsed}, about {eta} left";
        Self::start(u64::try_from(parts).ok(), left, message)
    }

    /// There are this many parts after all.
    pub(crate) fn expect(&self, parts: usize) {
        self.bar.set_length(parts as u64);
    }

    /// One part is done.
    pub(crate) fn step(&self) {
        self.bar.inc(1);
    }

    /// One part is done, and the work goes on: an interruption ends the process.
    pub(crate) fn step_of_work(&self) -> ControlFlow<()> {
        self.step();
        ControlFlow::Continue(())
    }

    fn start(parts: Option<u64>, template: &str, message: &str) -> Self {
        let bar = ProgressBar::with_draw_target(parts, ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.set_message(message.to_owned());
        if !session::shows_progress() {
            return Self { bar, done: None, waiting: None };
        }
        let (done, is_done) = mpsc::channel::<()>();
        let shown = bar.clone();
        let waiting = thread::spawn(move || {
            if is_done.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                // indicatif itself stays silent where stderr is not a terminal
                shown.set_draw_target(ProgressDrawTarget::stderr());
                shown.enable_steady_tick(Duration::from_millis(100));
            }
        });
        Self { bar, done: Some(done), waiting: Some(waiting) }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        // closing the channel ends the waiting
        self.done = None;
        if let Some(waiting) = self.waiting.take() {
            // a thread that could not draw has nothing to tell
            let _ = waiting.join();
        }
        self.bar.finish_and_clear();
    }
}
