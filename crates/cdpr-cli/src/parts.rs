//! Commands whose work has parts: all of them here, or one at a time for a plan that is computed elsewhere.
//!
//! [`computed`] returns the parts of a command's work, once in a run. Run from a shell, it computes all of them. Planned by `sweep plan`, the
//! command ends there with their number; in `sweep run` it computes one and ends; in `sweep merge` it reads the rows and goes on to its answer.

use std::panic::resume_unwind;

use cdpr_study::parts::here;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::session;
use crate::surroundings::PartsWanted;

/// Thrown through a command that has told what was wanted of its parts.
pub(crate) enum PartsTold {
    /// There are so many.
    Count(usize),
    /// This is the one that was asked for, as JSON.
    One(Vec<u8>),
    /// A part that is given or computed is none of this command's; why, in words.
    Wrong(String),
}

/// The parts of a command, in their order, of which a plan may want less.
pub(crate) fn computed<T: Serialize + DeserializeOwned + Send>(
    count: usize,
    part: &(dyn Fn(usize) -> T + Sync),
) -> Vec<T> {
    match session::parts() {
        PartsWanted::All => here(count, part),
        PartsWanted::Count => tell(PartsTold::Count(count)),
        PartsWanted::One(own) if own < count => match serde_json::to_vec(&part(own)) {
            Ok(bytes) => tell(PartsTold::One(bytes)),
            Err(error) => tell(PartsTold::Wrong(error.to_string())),
        },
        PartsWanted::One(own) => tell(PartsTold::Wrong(format!("there is no part {own} of {count}"))),
        PartsWanted::Given(rows) if rows.len() == count => {
            let read = |row: &Vec<u8>| serde_json::from_slice(row);
            let all: Result<Vec<T>, _> = rows.iter().map(read).collect();
            all.unwrap_or_else(|error| tell(PartsTold::Wrong(error.to_string())))
        }
        PartsWanted::Given(rows) => tell(PartsTold::Wrong(format!("{} rows for {count} parts", rows.len()))),
    }
}

fn tell(told: PartsTold) -> ! {
    // no hook is called: this is no fault
    resume_unwind(Box::new(told))
}
