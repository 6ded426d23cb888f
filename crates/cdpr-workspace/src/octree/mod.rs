//! Cells refined only where the boundary of the region passes, in a plane or in space.
//!
//! The corners of large start cells are judged. On each of their edges whose ends differ, bisection finds the boundary
//! down to an edge of the smallest cells; from the cell there it is followed through every face whose corners differ
//! into the next cell. All corners of every smallest cell that the boundary passes are judged, and no others near it.
//! Corners drawn at random, one from each cell of a coarse grid, are further seeds, from which the boundary is followed
//! in the same way. Parts of the region, and gaps in it, that fit between all of these and touch nothing else are not
//! found: an [`Audit`](super::Audit) bounds their size.

mod nodes;
mod outcome;
mod seeds;
mod surface;

use nodes::{Node, Nodes};
pub use outcome::{Outcome, solve};

use super::grid::cell_count;
use super::{Bounds, Point, Region, WorkspaceError};

/// Size of the cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Largest side of the smallest cells, those at the boundary (m).
    pub step: f64,
    /// Number of halvings from a start cell to the smallest cells: start cells have 2^halvings times their sides.
    pub halvings: u32,
}

impl Settings {
    /// Start cells of eight steps.
    pub fn new(step: f64) -> Self {
        Self { step, halvings: 3 }
    }
}

/// Most halvings; more would make start cells larger than any box.
const MOST_HALVINGS: u32 = 16;
/// Most corners; more need more than 2 GB.
const MOST_NODES: f64 = 5e9;

/// Follows the boundary of a region in a box.
pub fn search<'a>(region: &'a Region<'a>, bounds: &Bounds, settings: &Settings) -> Result<Octree<'a>, WorkspaceError> {
    let mut octree = Octree::new(region, bounds, settings)?;
    octree.follow_everywhere();
    Ok(octree)
}

/// Cells refined where the boundary of a region passes.
pub struct Octree<'a> {
    region: &'a Region<'a>,
    bounds: Bounds,
    dimension: usize,
    /// Smallest cells along each axis; 1 across a plane.
    counts: [usize; 3],
    /// Side of a start cell in smallest cells.
    start: usize,
    nodes: Nodes,
    /// A bit for each smallest cell, set if the boundary was followed into it.
    reached: Vec<u64>,
    /// Smallest cells that the boundary passes.
    cells: Vec<Cell>,
    /// Corners to judge next.
    asked: Vec<Node>,
    points: u64,
    feasible_points: u64,
}

/// A smallest cell by its lower corner, with bits of the corners that hold.
#[derive(Clone, Copy, Debug)]
struct Cell {
    node: Node,
    corners: u8,
}

/// An edge along an axis whose ends have different answers.
#[derive(Clone, Copy, Debug)]
struct Edge {
    /// Lower end of the edge.
    node: Node,
    axis: usize,
    /// Length in smallest cells.
    length: usize,
}

impl Edge {
    fn middle(&self) -> Node {
        further(self.node, self.axis, self.length / 2)
    }
}

/// Corners of the lower and of the upper face across each axis.
const FACES: [[u8; 2]; 3] = [[0b0101_0101, 0b1010_1010], [0b0011_0011, 0b1100_1100], [0b0000_1111, 0b1111_0000]];

impl<'a> Octree<'a> {
    fn new(region: &'a Region<'a>, bounds: &Bounds, settings: &Settings) -> Result<Self, WorkspaceError> {
        let halvings = settings.halvings.min(MOST_HALVINGS);
        let (dimension, start) = (bounds.dimension(), 1_usize << halvings);
        let mut counts = [1; 3];
        for (axis, count) in counts.iter_mut().enumerate().take(dimension) {
            *count = cell_count(bounds, axis, settings.step)?.next_multiple_of(start);
        }
        let corners = [0, 1, 2].map(|axis| counts[axis] + usize::from(axis < dimension));
        if corners.iter().map(|&count| count as f64).product::<f64>() > MOST_NODES {
            return Err(WorkspaceError::StepTooFine { step: settings.step, extent: bounds.extent(0) });
        }
        let reached = vec![0; counts.iter().product::<usize>().div_ceil(64)];
        let (nodes, bounds, cells, asked) = (Nodes::new(corners), *bounds, Vec::new(), Vec::new());
        Ok(Self {
            region,
            bounds,
            dimension,
            counts,
            start,
            nodes,
            reached,
            cells,
            asked,
            points: 0,
            feasible_points: 0,
        })
    }

    fn point(&self, node: Node) -> Point {
        let mut point = [0.0; 3];
        for axis in 0..self.dimension {
            let fraction = node[axis] as f64 / self.counts[axis] as f64;
            point[axis] = self.bounds.least()[axis] + fraction * self.bounds.extent(axis);
        }
        point
    }

    fn ask(&mut self, node: Node) {
        if self.nodes.ask(node) {
            self.asked.push(node);
        }
    }

    /// Judges all requested corners at once.
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

    fn follow_everywhere(&mut self) {
        let front = self.crossed_cells();
        self.follow(front);
        let front = self.seeded_cells();
        self.follow(front);
    }

    /// Follows the boundary from these cells.
    fn follow(&mut self, mut front: Vec<Node>) {
        while !front.is_empty() {
            for &node in &front {
                (0..1 << self.dimension)
                    .for_each(|corner| self.ask([0, 1, 2].map(|axis| node[axis] + (corner >> axis & 1))));
            }
            self.judge();
            let mut next = Vec::new();
            for node in front {
                let cell = Cell { node, corners: self.nodes.corners(node, self.dimension) };
                self.spread(cell, &mut next);
                self.cells.push(cell);
            }
            front = next;
        }
    }

    /// A smallest cell on the boundary for each edge of the start cells whose ends differ.
    fn crossed_cells(&mut self) -> Vec<Node> {
        let corners: Vec<Node> = self.start_corners().collect();
        corners.iter().for_each(|&node| self.ask(node));
        self.judge();
        let mut edges: Vec<Edge> = Vec::new();
        for node in corners {
            for axis in 0..self.dimension {
                let end = further(node, axis, self.start);
                if end[axis] <= self.counts[axis] && self.nodes.holds(end) != self.nodes.holds(node) {
                    edges.push(Edge { node, axis, length: self.start });
                }
            }
        }
        self.cells_at(edges)
    }

    /// A smallest cell on the boundary for each edge whose ends differ, found by bisection.
    fn cells_at(&mut self, mut edges: Vec<Edge>) -> Vec<Node> {
        while edges.iter().any(|edge| edge.length > 1) {
            edges.iter().filter(|edge| edge.length > 1).for_each(|edge| self.ask(edge.middle()));
            self.judge();
            for edge in edges.iter_mut().filter(|edge| edge.length > 1) {
                let (middle, half) = (edge.middle(), edge.length / 2);
                *edge = match self.nodes.holds(middle) == self.nodes.holds(edge.node) {
                    true => Edge { node: middle, length: edge.length - half, ..*edge },
                    false => Edge { length: half, ..*edge },
                };
            }
        }
        let mut cells = Vec::new();
        for Edge { node, .. } in edges {
            // edges on the upper faces of the box belong to the cells below
            self.reach([0, 1, 2].map(|axis| node[axis].min(self.counts[axis] - 1)), &mut cells);
        }
        cells
    }

    fn start_corners(&self) -> impl Iterator<Item = Node> + use<> {
        let start = self.start;
        let counts = [0, 1, 2].map(|axis| if axis < self.dimension { self.counts[axis] / start + 1 } else { 1 });
        (0..counts.iter().product()).map(move |index: usize| {
            [index % counts[0], index / counts[0] % counts[1], index / (counts[0] * counts[1])]
                .map(|place| place * start)
        })
    }

    /// Adds the neighbours beyond the faces through which the boundary leaves a cell.
    fn spread(&mut self, cell: Cell, next: &mut Vec<Node>) {
        let whole = if self.dimension == 3 { u8::MAX } else { 0b1111 };
        for axis in 0..self.dimension {
            let [lower, upper] = FACES[axis].map(|face| {
                let (face, holding) = (face & whole, cell.corners & face & whole);
                holding != 0 && holding != face
            });
            if lower && cell.node[axis] > 0 {
                let mut node = cell.node;
                node[axis] -= 1;
                self.reach(node, next);
            }
            if upper && cell.node[axis] + 1 < self.counts[axis] {
                self.reach(further(cell.node, axis, 1), next);
            }
        }
    }

    /// Adds a cell the first time it is reached.
    fn reach(&mut self, node: Node, cells: &mut Vec<Node>) {
        let index = (node[2] * self.counts[1] + node[1]) * self.counts[0] + node[0];
        let (word, bit) = (&mut self.reached[index / 64], 1 << (index % 64));
        if *word & bit == 0 {
            *word |= bit;
            cells.push(node);
        }
    }
}

fn further(mut node: Node, axis: usize, by: usize) -> Node {
    node[axis] += by;
    node
}
