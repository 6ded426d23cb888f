//! Items of an array, put side by side in lanes, and back.

use super::line::Line;
use super::{Kernel, LANES, Lanes};

/// Eight items of `rows` numbers (at most eight), item by item, as lanes: number k of all of them. Lanes beyond `rows` hold anything.
///
/// `numbers` must reach eight numbers from the beginning of the last item on ([`has_room`]).
#[inline(always)]
pub(crate) fn load_items<L: Lanes>(lanes: L, numbers: &[f64], rows: usize) -> [L; LANES] {
    let mut items = [lanes; LANES];
    for lane in 0..LANES {
        items[lane] = lanes.load(&numbers[lane * rows..]);
    }
    L::transposed(&items)
}

/// Whether eight items of `rows` numbers can be loaded or stored as eight numbers each.
#[inline(always)]
pub(crate) fn has_room(numbers: &[f64], rows: usize) -> bool {
    rows <= LANES && numbers.len() >= (LANES - 1) * rows + LANES
}

/// Numbers of items, item by item, to the lines of a table.
pub(super) struct FromItems<'a> {
    pub(super) numbers: &'a [f64],
    pub(super) rows: usize,
    pub(super) lines: &'a mut [Line],
}

impl Kernel for FromItems<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { numbers, rows, lines } = self;
        for (group, lines) in lines.chunks_exact_mut(rows).enumerate() {
            let numbers = &numbers[group * LANES * rows..];
            if has_room(numbers, rows) {
                let columns = load_items(lanes, numbers, rows);
                // indices that the compiler knows, so that the lanes stay in registers
                for row in 0..LANES {
                    if row < rows {
                        columns[row].store(&mut lines[row].0);
                    }
                }
                continue;
            }
            for (lane, item) in numbers.chunks_exact(rows).take(LANES).enumerate() {
                lines.iter_mut().zip(item).for_each(|(line, number)| line.0[lane] = *number);
            }
        }
    }
}

/// Lines of a table to numbers of items, item by item.
pub(super) struct ToItems<'a> {
    pub(super) lines: &'a [Line],
    pub(super) rows: usize,
    pub(super) numbers: &'a mut [f64],
}

impl Kernel for ToItems<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { lines, rows, numbers } = self;
        for (group, lines) in lines.chunks_exact(rows).enumerate() {
            let numbers = &mut numbers[group * LANES * rows..];
            if has_room(numbers, rows) {
                let mut columns = [lanes; LANES];
                for row in 0..LANES {
                    if row < rows {
                        columns[row] = lanes.load(&lines[row].0);
                    }
                }
                let items = L::transposed(&columns);
                // what an item writes beyond its own numbers, the next one, or the next group, overwrites
                for lane in 0..LANES {
                    items[lane].store(&mut numbers[lane * rows..]);
                }
                continue;
            }
            for (lane, item) in numbers.chunks_exact_mut(rows).take(LANES).enumerate() {
                lines.iter().zip(item).for_each(|(line, number)| *number = line.0[lane]);
            }
        }
    }
}
