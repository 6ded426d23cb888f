//! What later steps wait for, while the first steps run: programs of the machine, packages of the viewer and of the judges and mdbook are
//! fetched, and the builds for release are made, which have a lock of their own. Compiling alone leaves a core idle half of the time.

use std::path::Path;
use std::thread::{self, JoinHandle};

use crate::{book, browser, command, instructions, judge, python, shells};

/// Work on threads of its own.
#[derive(Default)]
pub(crate) struct Ahead {
    fetching: Option<JoinHandle<()>>,
    building: Option<JoinHandle<()>>,
}

impl Ahead {
    /// Begins. What cannot be had is left to the step that needs it, which says why.
    pub(crate) fn start(root: &Path) -> Self {
        let (root, builds) = (root.to_path_buf(), root.to_path_buf());
        let fetch = move || {
            // one after the other: Debian's packages have one lock
            let fetched: [(&str, Result<(), String>); 6] = [
                ("shells", shells::fetch()),
                ("instructions", instructions::fetch()),
                ("python", python::fetch(&root)),
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
        Self { fetching: Some(thread::spawn(fetch)), building: Some(thread::spawn(move || command::build(&builds))) }
    }

    /// Waits until everything is fetched.
    pub(crate) fn fetched(&mut self) {
        wait(&mut self.fetching);
    }

    /// Waits until the builds for release are there.
    pub(crate) fn built(&mut self) {
        wait(&mut self.building);
    }
}

fn wait(thread: &mut Option<JoinHandle<()>>) {
    if let Some(thread) = thread.take() {
        // a panic of its own was printed, and the step that lacks something says so
        let _ = thread.join();
    }
}
