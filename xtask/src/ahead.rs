//! Fetches what later steps wait for while the first steps compile: programs of the machine, packages of the viewer and of the judges,
//! mdbook.

use std::path::Path;
use std::thread::{self, JoinHandle};

use crate::{book, browser, instructions, judge};

/// Fetching on a thread of its own.
pub(crate) struct Ahead(Option<JoinHandle<()>>);

impl Ahead {
    /// Begins to fetch. What cannot be had is left to the step that needs it, which says why.
    pub(crate) fn start(root: &Path) -> Self {
        let root = root.to_path_buf();
        let fetch = move || {
            // one after the other: Debian's packages have one lock
            let fetched: [(&str, Result<(), String>); 4] = [
                ("instructions", instructions::fetch()),
                ("judge", judge::fetch(&root)),
                ("browser", browser::fetch(&root)),
                ("book", book::fetch(&root)),
            ];
            for (step, result) in fetched {
                if let Err(reason) = result {
                    println!("for the step `{step}`: {reason}");
                }
            }
        };
        Self(Some(thread::spawn(fetch)))
    }

    /// Nothing is fetched ahead: steps fetch what they need.
    pub(crate) fn nothing() -> Self {
        Self(None)
    }

    /// Waits until everything is there.
    pub(crate) fn wait(&mut self) {
        if let Some(thread) = self.0.take() {
            // a panic of its own was printed, and the step that lacks something says so
            let _ = thread.join();
        }
    }
}
