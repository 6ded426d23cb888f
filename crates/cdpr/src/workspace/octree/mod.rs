//! Cells refined only where the boundary of the region passes (quadtree in the plane, octree in space).
//!
//! Cells are judged at their corners. Where corners differ, the boundary passes, and the cell is cut into halves along each
//! axis, down to cells of the step. Where a new corner on a face shows that the boundary goes on into a neighbour that
//! looked uniform, the neighbour is cut too, so that the boundary is followed wherever it leads. Parts of the region, and
//! gaps in it, that fit between the corners of the start cells and touch nothing else are not found.

mod nodes;
mod outcome;

use nodes::{Node, Nodes};
pub use outcome::Outcome;

use super::grid::cell_count;
use super::{Bounds, Point, Region, WorkspaceError};

/// How fine the cells are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Largest side of the smallest cells, those at the boundary (m).
    pub step: f64,
    /// How often a start cell is halved to get the smallest ones: start cells have 2^halvings times their sides.
    pub halvings: u32,
}

impl Settings {
    /// Start cells of eight steps.
    pub fn new(step: f64) -> Self {
        Self { step, halvings: 3 }
    }
}

/// More would make start cells larger than any box.
const MOST_HALVINGS: u32 = 16;
/// More corners need more than 2 GB.
const MOST_NODES: f64 = 8e9;

/// Measures a region in a box.
pub fn solve(region: &Region<'_>, bounds: &Bounds, settings: &Settings) -> Result<Outcome, WorkspaceError> {
    let mut tree = Tree::new(region, bounds, settings)?;
    tree.start();
    while tree.refine() {}
    Ok(tree.outcome())
}

struct Tree<'a> {
    region: &'a Region<'a>,
    bounds: Bounds,
    dimension: usize,
    /// Smallest cells along each axis; 1 across a plane.
    counts: [usize; 3],
    /// Side of a start cell in smallest cells.
    start: usize,
    nodes: Nodes,
    /// For each size of cell from the start cells down, which were cut.
    cut: Vec<Vec<bool>>,
    /// Corners to judge next.
    asked: Vec<Node>,
    /// Cells cut since the last batch.
    fresh: Vec<Cell>,
    points: u64,
    feasible_points: u64,
}

/// A cell by its lower corner; its side in smallest cells is `start >> level`.
#[derive(Clone, Copy, Debug)]
struct Cell {
    level: usize,
    node: Node,
}

impl<'a> Tree<'a> {
    fn new(region: &'a Region<'a>, bounds: &Bounds, settings: &Settings) -> Result<Self, WorkspaceError> {
        let halvings = settings.halvings.min(MOST_HALVINGS);
        let (dimension, start) = (bounds.dimension(), 1_usize << halvings);
        let mut counts = [1; 3];
        for (axis, count) in counts.iter_mut().enumerate().take(dimension) {
            *count = cell_count(bounds, axis, settings.step)?.next_multiple_of(start);
        }
        let corners = |axis: usize| if axis < dimension { counts[axis] + 1 } else { 1 };
        let corners = [corners(0), corners(1), corners(2)];
        if corners.iter().map(|&count| count as f64).product::<f64>() > MOST_NODES {
            return Err(WorkspaceError::StepTooFine { step: settings.step, extent: bounds.extent(0) });
        }
        let cells = |level: u32| (0..dimension).map(|axis| counts[axis] / (start >> level)).product::<usize>();
        let cut = (0..halvings).map(|level| vec![false; cells(level)]).collect();
        let (nodes, bounds) = (Nodes::new(corners), *bounds);
        let (asked, fresh) = (Vec::new(), Vec::new());
        Ok(Self { region, bounds, dimension, counts, start, nodes, cut, asked, fresh, points: 0, feasible_points: 0 })
    }

    fn side(&self, level: usize) -> usize {
        self.start >> level
    }

    /// Whether the cell is one of the smallest.
    fn is_smallest(&self, level: usize) -> bool {
        level == self.cut.len()
    }

    /// Steps of the given length to every corner of a block of so many along each axis.
    fn corners(&self, node: Node, step: usize, count: usize) -> impl Iterator<Item = Node> + use<> {
        let dimension = self.dimension;
        (0..count.pow(dimension as u32)).map(move |index| {
            let mut corner = node;
            let mut rest = index;
            for place in corner.iter_mut().take(dimension) {
                *place += rest % count * step;
                rest /= count;
            }
            corner
        })
    }

    /// Whether the corners of a cell are of both kinds.
    fn is_mixed(&self, cell: Cell) -> bool {
        let first = self.nodes.holds(cell.node);
        self.corners(cell.node, self.side(cell.level), 2).any(|corner| self.nodes.holds(corner) != first)
    }

    fn point(&self, node: Node) -> Point {
        let mut point = [0.0; 3];
        for axis in 0..self.dimension {
            let share = node[axis] as f64 / self.counts[axis] as f64;
            point[axis] = self.bounds.least()[axis] + share * self.bounds.extent(axis);
        }
        point
    }

    /// Judges the corners of the start cells and cuts those with corners of both kinds.
    fn start(&mut self) {
        let cells: Vec<Cell> = self.start_cells().collect();
        for cell in &cells {
            self.ask(cell.node, self.start, 2);
        }
        self.judge();
        for cell in cells {
            if !self.is_smallest(0) && self.is_mixed(cell) {
                self.cut(cell);
            }
        }
    }

    fn start_cells(&self) -> impl Iterator<Item = Cell> + use<> {
        let (side, dimension) = (self.start, self.dimension);
        let counts = [0, 1, 2].map(|axis| if axis < dimension { self.counts[axis] / side } else { 1 });
        (0..counts.iter().product()).map(move |index: usize| {
            let along = [index % counts[0], index / counts[0] % counts[1], index / (counts[0] * counts[1])];
            Cell { level: 0, node: along.map(|place| place * side) }
        })
    }

    fn ask(&mut self, node: Node, step: usize, count: usize) {
        for corner in self.corners(node, step, count) {
            if self.nodes.ask(corner) {
                self.asked.push(corner);
            }
        }
    }

    fn is_known_and_mixed(&self, cell: Cell) -> bool {
        self.corners(cell.node, self.side(cell.level), 2).all(|corner| self.nodes.known(corner).is_some())
            && self.is_mixed(cell)
    }

    /// Asks for the middles of those edges and faces of a cell whose ends differ, and for its own: between ends that agree
    /// it is taken for uniform, as cells are.
    fn ask_where_it_is_crossed(&mut self, node: Node, side: usize) {
        let middles: Vec<Node> = self.corners(node, side / 2, 3).collect();
        for middle in middles {
            let is_end =
                |corner: &Node| (0..self.dimension).all(|axis| middle[axis].abs_diff(corner[axis]) <= side / 2);
            let mut ends = self.corners(node, side, 2).filter(is_end).map(|corner| self.nodes.holds(corner));
            let first = ends.next();
            if ends.any(|end| Some(end) != first) && self.nodes.ask(middle) {
                self.asked.push(middle);
            }
        }
    }

    /// Judges the corners asked for, all at once.
    fn judge(&mut self) {
        let points: Vec<Point> = self.asked.iter().map(|&node| self.point(node)).collect();
        let mut answers = vec![false; points.len()];
        self.region.holds_all(&points, &mut answers);
        for (&node, &holds) in self.asked.iter().zip(&answers) {
            self.nodes.answer(node, holds);
            self.feasible_points += u64::from(holds);
        }
        self.points += points.len() as u64;
        self.asked.clear();
    }

    fn cut_index(&self, level: usize, node: Node) -> usize {
        let side = self.side(level);
        let row = |axis: usize| if axis < self.dimension { self.counts[axis] / side } else { 1 };
        (node[2] / side * row(1) + node[1] / side) * row(0) + node[0] / side
    }

    /// Cuts a cell and whatever contains it; asks for the corners of its parts.
    fn cut(&mut self, cell: Cell) {
        for level in 0..=cell.level {
            let side = self.side(level);
            let node = cell.node.map(|place| place / side * side);
            let index = self.cut_index(level, node);
            if !self.cut[level][index] {
                self.cut[level][index] = true;
                self.fresh.push(Cell { level, node });
                match level > 0 && self.is_known_and_mixed(Cell { level, node }) {
                    true => self.ask_where_it_is_crossed(node, side),
                    false => self.ask(node, side / 2, 3),
                }
            }
        }
    }

    /// Judges the new corners and cuts what they show the boundary to pass; false when it is followed everywhere.
    fn refine(&mut self) -> bool {
        self.judge();
        let fresh = std::mem::take(&mut self.fresh);
        for &cell in &fresh {
            let (level, half) = (cell.level + 1, self.side(cell.level) / 2);
            if !self.is_smallest(level) {
                let parts: Vec<Node> = self.corners(cell.node, half, 2).collect();
                for node in parts {
                    if self.is_mixed(Cell { level, node }) {
                        self.cut(Cell { level, node });
                    }
                }
            }
            self.follow(cell);
        }
        !self.fresh.is_empty()
    }

    /// Cuts the neighbours of a cut cell into which the boundary goes on.
    fn follow(&mut self, cell: Cell) {
        let side = self.side(cell.level);
        for axis in 0..self.dimension {
            for is_upper in [false, true] {
                let mut neighbour = cell.node;
                if is_upper {
                    neighbour[axis] += side;
                } else if neighbour[axis] >= side {
                    neighbour[axis] -= side;
                } else {
                    continue;
                }
                if neighbour[axis] >= self.counts[axis] || self.cut[cell.level][self.cut_index(cell.level, neighbour)] {
                    continue;
                }
                let value = self.nodes.holds(self.leaf(neighbour, cell.level));
                let mut face = cell.node;
                face[axis] += if is_upper { side } else { 0 };
                let is_on_face = |corner: &Node| corner[axis] == face[axis];
                let differs = self
                    .corners(cell.node, side / 2, 3)
                    .filter(is_on_face)
                    .any(|corner| self.nodes.holds(corner) != value);
                if differs {
                    self.cut(Cell { level: cell.level, node: neighbour });
                }
            }
        }
    }

    /// Lower corner of the uncut cell that contains a cell which is not cut itself.
    fn leaf(&self, node: Node, level: usize) -> Node {
        let at = |level: usize| node.map(|place| place / self.side(level) * self.side(level));
        (0..level).find(|&level| !self.cut[level][self.cut_index(level, at(level))]).map_or(node, at)
    }
}
