//! Signs of life of long work, and the wish to stop it.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

/// Called after each part of long work: `Break` stops the work, which then returns its error `Stopped`.
///
/// ```
/// use std::cell::Cell;
/// use std::ops::ControlFlow;
///
/// let left = Cell::new(10);
/// let progress = || {
///     left.set(left.get() - 1);
///     if left.get() > 0 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
/// };
/// let _: &cdpr::calibration::Progress<'_> = &progress;
/// ```
pub type Progress<'a> = dyn Fn() -> ControlFlow<()> + 'a;

/// The progress of work that nobody observes: it always goes on.
pub fn unobserved() -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// The caller's progress asked to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Stopped;

/// Reports a part that is done; an error if the work shall stop.
pub(crate) fn report(progress: &Progress<'_>) -> Result<(), Stopped> {
    if progress().is_break() { Err(Stopped) } else { Ok(()) }
}

/// The progress of work that several threads share: once it was asked to stop, all of them stop.
pub(crate) struct SharedProgress<'a> {
    progress: &'a (dyn Fn() -> ControlFlow<()> + Sync),
    is_stopped: AtomicBool,
}

impl<'a> SharedProgress<'a> {
    pub(crate) fn of(progress: &'a (dyn Fn() -> ControlFlow<()> + Sync)) -> Self {
        Self { progress, is_stopped: AtomicBool::new(false) }
    }

    /// Reports a part that is done; an error if the work shall stop.
    pub(crate) fn report(&self) -> Result<(), Stopped> {
        if (self.progress)().is_break() {
            self.is_stopped.store(true, Ordering::Relaxed);
        }
        if self.is_stopped() { Err(Stopped) } else { Ok(()) }
    }

    /// True if the work was asked to stop.
    pub(crate) fn is_stopped(&self) -> bool {
        self.is_stopped.load(Ordering::Relaxed)
    }

    /// The progress of parts of a part, which are not reported: they stop if the whole work does.
    pub(crate) fn silent(&self) -> ControlFlow<()> {
        if self.is_stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
