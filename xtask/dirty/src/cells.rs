//! Which cells there are: all of the table, and the fixed ones of `cargo xtask test`.

use crate::kinds::{KINDS, Kind};
use crate::trial::Cell;

/// Cells of the test.
pub(crate) const FIXED: usize = 40;
/// Clean ones among them.
const FIXED_CLEAN: usize = 8;
/// Seeds of the test, far from those of a soak: the first round of kinds states its accuracies, the second does not.
const FIXED_SEEDS: [u64; 2] = [1000, 1001];

/// Every kind with every robot that can have it, with these seeds.
pub(crate) fn all(first: u64, count: u64) -> Vec<Cell> {
    let of_kind = |kind: &'static Kind| {
        let of_robot = move |&robot| (first..first.saturating_add(count)).map(move |seed| Cell { kind, robot, seed });
        kind.robots.iter().flat_map(of_robot)
    };
    KINDS.iter().flat_map(of_kind).collect()
}

/// Cells of kinds that are not kept: each kind once, then each again with its next robot and another seed, until there are enough.
pub(crate) fn fixed() -> Vec<Cell> {
    let (clean, dirty): (Vec<&Kind>, Vec<&Kind>) =
        KINDS.iter().filter(|kind| !kind.kept).partition(|kind| kind.is_clean());
    let mut cells = round(&clean, FIXED_CLEAN);
    cells.extend(round(&dirty, FIXED - FIXED_CLEAN));
    cells
}

fn round(kinds: &[&'static Kind], count: usize) -> Vec<Cell> {
    let turns = FIXED_SEEDS.iter().enumerate().flat_map(|(turn, &seed)| {
        kinds.iter().map(move |&kind| {
            // by the name, so that a new row changes no other kind's robot
            let start = kind.name.bytes().map(usize::from).sum::<usize>();
            let robot = kind.robots[(start + turn) % kind.robots.len()];
            Cell { kind, robot, seed }
        })
    });
    turns.take(count).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::record::Record;
    use crate::scene::{Layout, SIGMAS, Scene};

    #[test]
    fn forty_cells_are_fixed_and_none_of_a_kept_kind() {
        let cells = fixed();
        let names: BTreeSet<String> = cells.iter().map(Cell::name).collect();
        assert_eq!(names.len(), FIXED);
        assert!(cells.iter().all(|cell| !cell.kind.kept));
        let kinds: BTreeSet<&str> = cells.iter().map(|cell| cell.kind.name).collect();
        assert_eq!(kinds.len(), KINDS.iter().filter(|kind| !kind.kept).count());
    }

    /// Files of a scene.
    fn files(scene: &Scene) -> (String, String, Option<String>, Option<String>) {
        let validation = scene.validation.as_ref().map(Record::csv);
        (scene.file.text(), scene.data.csv(), validation, scene.sidecar())
    }

    /// Files depend on the cell alone, and those of dirty kinds differ from those of the scene before it is spoilt.
    #[test]
    fn every_dirt_changes_the_files_and_the_same_ones_every_time() {
        for cell in all(2, 1) {
            let Cell { kind, robot, seed } = cell;
            let spoilt = files(&cell.scene().0);
            assert_eq!(spoilt, files(&cell.scene().0), "{}", cell.name());
            assert!(!spoilt.1.contains("NaN"), "{}", cell.name());
            let mut unspoilt = Scene::of(robot, seed, kind.layout, kind.name);
            unspoilt.stated = cell.states_accuracies().then_some(SIGMAS);
            // where poses lie is the layout's dirt
            let differs = !kind.is_clean() && kind.layout != Layout::Corner;
            assert!(!differs || spoilt != files(&unspoilt), "{}", cell.name());
        }
    }
}
