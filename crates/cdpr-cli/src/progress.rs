//! Signs of life on stderr for work that takes longer than a second: a line that moves on terminals, now and then a plain one elsewhere.

use std::io::Write as _;
use std::ops::ControlFlow;
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use crate::console::Signs;
use crate::pace::{Pace, time};
use crate::session;
use crate::surroundings::{self, Observer, WorkDone};

/// How long work may take before a line moves.
const PATIENCE: Duration = Duration::from_secs(1);

/// How long it may take before the first plain line; each further one comes after half as much time again as all before.
const PATIENCE_OF_LOGS: Duration = Duration::from_secs(10);

/// A line on stderr that appears after a second and goes when this value goes, with a word how long it took; plain lines where stderr is no terminal; nothing if quiet
/// was asked for.
pub(crate) struct Progress {
    bar: ProgressBar,
    work: Arc<Mutex<Work>>,
    begun: Instant,
    done: Option<Sender<()>>,
    waiting: Option<JoinHandle<()>>,
    observe: Option<Observer>,
}

/// Work on its way.
struct Work {
    name: String,
    pace: Pace,
    /// True once a line of it was shown.
    is_shown: bool,
}

fn locked(work: &Mutex<Work>) -> MutexGuard<'_, Work> {
    // counts and words are whole whatever panicked
    work.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Progress {
    /// Work whose length is not known, named by what it does.
    pub(crate) fn spinner(message: &str) -> Self {
        Self::start(None, "{spinner} {msg}, {pace}", message)
    }

    /// Work in this many parts, named by what it does; [`Self::step`] tells of each part that is done.
    pub(crate) fn of(parts: usize, message: &str) -> Self {
        Self::start(Some(parts), "{spinner} {msg} [{bar:20}] {pace}", message)
    }

    /// There are this many parts after all.
    pub(crate) fn expect(&self, parts: usize) {
        self.bar.set_length(parts as u64);
        locked(&self.work).pace.parts = Some(parts);
    }

    /// The work has come to a part of another name.
    pub(crate) fn at(&self, message: &str) {
        self.bar.set_message(message.to_owned());
        message.clone_into(&mut locked(&self.work).name);
        self.go_on();
    }

    /// One part is done; leaves the calculation if the observer of the run wants no more of it.
    pub(crate) fn step(&self) {
        if self.step_of_work().is_break() {
            surroundings::stop();
        }
    }

    /// One part is done; a break if the observer of the run wants no more of the work. From a shell an interruption ends the process.
    pub(crate) fn step_of_work(&self) -> ControlFlow<()> {
        self.bar.inc(1);
        locked(&self.work).pace.step(self.begun.elapsed());
        self.observed()
    }

    /// Tells the observer of the run how far the work is.
    fn observed(&self) -> ControlFlow<()> {
        let Some(observe) = &self.observe else { return ControlFlow::Continue(()) };
        let (name, done, parts) = {
            let work = locked(&self.work);
            (work.name.clone(), work.pace.count(), work.pace.parts)
        };
        observe(WorkDone { name: &name, done, parts })
    }

    /// Leaves the calculation if the observer of the run wants no more of it.
    fn go_on(&self) {
        if self.observed().is_break() {
            surroundings::stop();
        }
    }

    fn start(parts: Option<usize>, template: &str, message: &str) -> Self {
        let begun = Instant::now();
        let bar = ProgressBar::with_draw_target(parts.map(|parts| parts as u64), ProgressDrawTarget::hidden());
        let work = Work { name: message.to_owned(), pace: Pace::of(parts), is_shown: false };
        let work = Arc::new(Mutex::new(work));
        if let Ok(style) = ProgressStyle::with_template(template) {
            let pace = Arc::clone(&work);
            let words = move |_: &ProgressState, line: &mut dyn std::fmt::Write| {
                // a line that cannot be written has nothing to tell
                let _ = write!(line, "{}", locked(&pace).pace.words(begun.elapsed()));
            };
            bar.set_style(style.progress_chars("=> ").with_key("pace", words));
        }
        bar.set_message(message.to_owned());
        let (signs, observe) = (session::signs(), session::observer());
        if signs == Signs::Nothing {
            let quiet = Self { bar, work, begun, done: None, waiting: None, observe };
            quiet.go_on();
            return quiet;
        }
        let (done, is_done) = mpsc::channel::<()>();
        let (shown, told) = (bar.clone(), Arc::clone(&work));
        let waiting = thread::spawn(move || {
            let is_over = |time: Duration| is_done.recv_timeout(time) != Err(RecvTimeoutError::Timeout);
            if signs == Signs::Line {
                if !is_over(PATIENCE) {
                    locked(&told).is_shown = true;
                    // indicatif itself stays silent where stderr is not a terminal
                    shown.set_draw_target(ProgressDrawTarget::stderr());
                    shown.enable_steady_tick(Duration::from_millis(100));
                }
                return;
            }
            let mut wait = PATIENCE_OF_LOGS;
            while !is_over(wait) {
                let mut work = locked(&told);
                work.is_shown = true;
                say(&format!("{}: {}", work.name, work.pace.words(begun.elapsed())));
                wait = begun.elapsed() / 2;
            }
        });
        Self { bar, work, begun, done: Some(done), waiting: Some(waiting), observe }
    }
}

/// Writes a line to stderr.
fn say(line: &str) {
    // when stderr is gone there is nobody to tell
    let _ = writeln!(std::io::stderr(), "{line}");
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
        let work = locked(&self.work);
        if work.is_shown {
            // work that stops before its end, at an error for one, is not done
            let end = if work.pace.is_done() { "done in" } else { "ended after" };
            say(&format!("{}: {end} {}", work.name, time(self.begun.elapsed())));
        }
    }
}
