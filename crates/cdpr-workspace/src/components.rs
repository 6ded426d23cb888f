//! Parts of a region on a grid that do not touch.

use super::grid::Grid;

/// A part of a region whose cells share faces.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// Number of cells.
    pub cells: u64,
    /// Area (m²) or volume (m³).
    pub size: f64,
    /// The first of its cells in the order of the grid, as slab and index.
    pub first: (usize, usize),
}

/// The parts of a region from the answers for all cells, slab after slab, sorted from the largest to the smallest.
///
/// Panics if there is not one answer per cell.
pub fn components(grid: &Grid, answers: &[bool]) -> Vec<Component> {
    assert_eq!(answers.len() as u64, grid.points(), "one answer per cell");
    let size = grid.slab_points();
    let row = grid.counts()[0];
    let mut seen = vec![false; answers.len()];
    let (mut found, mut open) = (Vec::new(), Vec::new());
    for start in 0..answers.len() {
        if !answers[start] || seen[start] {
            continue;
        }
        let mut cells = 0;
        seen[start] = true;
        open.push(start);
        while let Some(cell) = open.pop() {
            cells += 1;
            let column = cell % row;
            let neighbours = [
                (column > 0).then(|| cell - 1),
                (column + 1 < row).then(|| cell + 1),
                (cell % size >= row).then(|| cell - row),
                (cell % size + row < size).then(|| cell + row),
                cell.checked_sub(size),
                (cell + size < answers.len()).then(|| cell + size),
            ];
            for next in neighbours.into_iter().flatten().filter(|&next| answers[next]) {
                if !std::mem::replace(&mut seen[next], true) {
                    open.push(next);
                }
            }
        }
        found.push(Component { cells, size: cells as f64 * grid.cell_size(), first: (start / size, start % size) });
    }
    found.sort_by_key(|component| std::cmp::Reverse(component.cells));
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Bounds;

    /// Cells that touch only at a corner are two parts; a row ends where the next begins.
    #[test]
    fn parts_share_faces() {
        let grid = Grid::new(&Bounds::new(2, &[0.0, 4.0, 0.0, 3.0]).unwrap(), 1.0).unwrap();
        #[rustfmt::skip]
        let answers = [
            true,  true,  false, true,
            false, false, true,  false,
            true,  false, true,  false,
        ];
        let found = components(&grid, &answers);
        assert_eq!(found.iter().map(|part| part.cells).collect::<Vec<_>>(), [2, 2, 1, 1]);
        assert_eq!(found.iter().map(|part| part.size).sum::<f64>(), 6.0);
        let grid = Grid::new(&Bounds::new(3, &[0.0, 2.0, 0.0, 2.0, 0.0, 2.0]).unwrap(), 1.0).unwrap();
        // two cells above each other, and one beside neither
        let answers = [true, false, false, false, true, false, false, true];
        assert_eq!(components(&grid, &answers).iter().map(|part| part.cells).collect::<Vec<_>>(), [2, 1]);
    }
}
