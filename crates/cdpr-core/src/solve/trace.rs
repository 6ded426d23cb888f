//! Trials of all searches as rows of a file, for debugging: `CDPR_TRACE=trail.csv` in a build with debug assertions.
//!
//! Releases contain none of this. A search writes its rows when it ends, so that rows of searches on several threads
//! are not mixed; of eight problems side by side the first is written.

use std::fmt::Write as _;
use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::PathBuf;
use std::string::String;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::{Control, Step};
use crate::scalar::Select;

/// Columns of the file.
const HEADER: &str = "search,problem,trial,helps,step_size,step_fraction,predicted_gain,damping,radius,stop\n";

/// The file that the environment names, emptied at the first call; `None` if it names none.
fn file() -> Option<&'static PathBuf> {
    static FILE: OnceLock<Option<PathBuf>> = OnceLock::new();
    let named = || {
        let path = PathBuf::from(std::env::var_os("CDPR_TRACE")?);
        // a file that cannot be written leaves the search as it is
        std::fs::write(&path, HEADER).ok()?;
        Some(path)
    };
    FILE.get_or_init(named).as_ref()
}

/// The trail of one search.
pub(super) struct Trace {
    rows: String,
    search: usize,
    problem: &'static str,
    trials: usize,
}

impl Trace {
    /// The trail of a search for this type of problem; `None` unless the environment names a file.
    pub(super) fn begin<P: ?Sized>() -> Option<Self> {
        static SEARCHES: AtomicUsize = AtomicUsize::new(1);
        file()?;
        let problem = core::any::type_name::<P>();
        // generic arguments say little and hold commas
        let problem = problem.split('<').next().unwrap_or(problem);
        Some(Self { rows: String::new(), search: SEARCHES.fetch_add(1, Ordering::Relaxed), problem, trials: 0 })
    }

    /// Adds a trial: its step, and how the search goes on after it.
    pub(super) fn add<N: Select>(&mut self, step: &Step<N>, fraction: N, control: &Control<N>, helps: bool, stop: N) {
        let Self { rows, search, problem, trials } = self;
        let [size, gain, fraction] = [step.size, step.gain, fraction].map(N::first);
        let (damping, radius, stop) = (control.damping.first(), control.radius.first(), stop.first());
        // writing to a string does not fail
        let _ = writeln!(
            rows,
            "{search},{problem},{trials},{helps},{size:e},{fraction},{gain:e},{damping:e},{radius:e},{stop}"
        );
        *trials += 1;
    }
}

impl Drop for Trace {
    fn drop(&mut self) {
        if let Some(mut file) = file().and_then(|path| OpenOptions::new().append(true).open(path).ok()) {
            let _ = file.write_all(self.rows.as_bytes());
        }
    }
}

#[cfg(test)]
mod tests {
    use std::process::Command;
    use std::vec::Vec;

    use super::HEADER;

    /// The tests of searches, run once more by a process whose environment names a file.
    #[test]
    fn every_trial_of_a_search_is_a_row() {
        let folder = std::env::temp_dir().join(std::format!("cdpr-trace-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join("trail.csv");
        let tests = Command::new(std::env::current_exe().unwrap())
            .args(["solve::tests::", "--test-threads", "2"])
            .env("CDPR_TRACE", &path)
            .output()
            .unwrap();
        assert!(tests.status.success());
        let text = std::fs::read_to_string(&path).unwrap();
        let rows: Vec<Vec<&str>> =
            text.strip_prefix(HEADER).unwrap().lines().map(|row| row.split(',').collect()).collect();
        assert!(rows.len() > 20, "{text}");
        let mut before: Option<&Vec<&str>> = None;
        for row in &rows {
            assert_eq!(row.len(), HEADER.split(',').count(), "{row:?}");
            assert!(row[1].contains("::"), "{row:?}");
            // rows of a search follow one another, and count its trials
            let goes_on = before.is_some_and(|before| before[0] == row[0]);
            let trial: usize = row[2].parse().unwrap();
            assert_eq!(trial, before.filter(|_| goes_on).map_or(0, |before| before[2].parse::<usize>().unwrap() + 1));
            assert!(row[4].parse::<f64>().is_ok() && row[7].parse::<f64>().is_ok(), "{row:?}");
            before = Some(row);
        }
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
