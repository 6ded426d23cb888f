//! Counting cells, with a state that outlives an interruption.

use std::path::Path;
use std::time::{Duration, Instant};

use cdpr_model::reading::Size;
use cdpr_workspace::grid::{Count, Grid};
use cdpr_workspace::{Cells, Region};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::question::Question;
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;

/// How often the state is written.
const PAUSE: Duration = Duration::from_secs(2);

/// The state of a count in its file.
#[derive(Deserialize, Serialize)]
struct State {
    /// SHA-256 of everything that was asked.
    question: String,
    count: Count,
}

/// Counts all cells, from the state in the file if there is one, and keeps in `cells` which of those counted now hold.
pub(super) fn count(
    region: &Region<'_>,
    grid: &Grid,
    question: &Question<'_>,
    file: Option<&Path>,
    mut cells: Option<&mut Cells>,
) -> Result<Count, Failure> {
    let asked = fingerprint(&question.words());
    let mut count = match file {
        Some(path) => read(path, &asked, grid)?,
        None => Count::new(),
    };
    let progress = Progress::of(grid.slabs(), "judging cells");
    (0..count.slabs).for_each(|_| progress.step());
    let mut written = Instant::now();
    let mut goes_on = count.slabs < grid.slabs();
    while goes_on {
        goes_on = count.advance(region, grid, &mut |slab, answers| {
            progress.step();
            if let Some(cells) = &mut cells {
                cells.see(slab, answers);
            }
        });
        if let Some(path) = file
            && (written.elapsed() > PAUSE || !goes_on)
        {
            write(path, &asked, &count)?;
            written = Instant::now();
        }
    }
    Ok(count)
}

fn fingerprint(words: &str) -> String {
    Sha256::digest(words).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn read(path: &Path, asked: &str, grid: &Grid) -> Result<Count, Failure> {
    let Some(bytes) = files::read_if_there(path, Size::Table)? else { return Ok(Count::new()) };
    let refused = |what: &str| {
        let message = format!("--resume {}: {what}", path.display());
        Failure::input("workspace::resume", message, "give the command that began it, or the name of a new file")
    };
    let state: State = serde_json::from_slice(&bytes).map_err(|_| refused("this is no state of a count"))?;
    match state.question == asked && state.count.fits(grid) {
        true => Ok(state.count),
        false => Err(refused("this is the state of another count")),
    }
}

fn write(path: &Path, asked: &str, count: &Count) -> Result<(), Failure> {
    let state = State { question: asked.to_owned(), count: count.clone() };
    let bytes = serde_json::to_vec(&state).map_err(|error| Failure::unwritable("the state of the count", &error))?;
    files::write(path, &bytes)
}
