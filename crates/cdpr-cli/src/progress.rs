//! Signs of life on stderr for work that takes longer than a second.

use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// How long work may take before anything is shown.
const PATIENCE: Duration = Duration::from_secs(1);

/// A line on stderr that appears after a second and goes when this value goes; nothing where stderr is not a terminal.
pub(crate) struct Progress {
    bar: ProgressBar,
    done: Option<Sender<()>>,
    waiting: Option<JoinHandle<()>>,
}

impl Progress {
    /// Work whose length is not known, named by what it does.
    pub(crate) fn spinner(message: &str) -> Self {
        let style = ProgressStyle::with_template("{spinner} {msg} {elapsed}");
        Self::start(ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden()), style.ok(), message)
    }

    fn start(bar: ProgressBar, style: Option<ProgressStyle>, message: &str) -> Self {
        if let Some(style) = style {
            bar.set_style(style);
        }
        bar.set_message(message.to_owned());
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
