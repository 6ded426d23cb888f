//! Corners drawn at random, from which the boundary is followed too.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::{Edge, Node, Octree};
use crate::Point;
use crate::audit::strata;

/// Approximate number of seeds: one from each cell of a grid of 64 by 64 in a plane, of 16 by 16 by 16 in space.
const SEEDS: u64 = 4096;
/// Seed of the random numbers.
const SEED: u64 = 0x5eed;

impl Octree<'_> {
    /// A smallest cell on the boundary between each seed whose answer differs from the answer known for it so far, and
    /// the corner that gave that answer.
    pub(super) fn seeded_cells(&mut self) -> Vec<Node> {
        let ways: Vec<[Node; 4]> = self.seeds().into_iter().map(|seed| self.way_to(seed)).collect();
        ways.iter().for_each(|way| self.ask(way[3]));
        self.judge();
        let ways: Vec<[Node; 4]> =
            ways.into_iter().filter(|way| self.nodes.holds(way[0]) != self.nodes.holds(way[3])).collect();
        ways.iter().flatten().for_each(|node| self.ask(*node));
        self.judge();
        let mut edges = Vec::new();
        for way in &ways {
            for (step, axis) in [2, 1, 0].into_iter().enumerate() {
                let (node, end) = (way[step], way[step + 1]);
                if self.nodes.holds(node) != self.nodes.holds(end) {
                    edges.push(Edge { node, axis, length: end[axis] - node[axis] });
                }
            }
        }
        self.cells_at(edges)
    }

    /// The corner whose answer a seed has so far, and the path from there along the axes to the seed.
    fn way_to(&self, seed: Node) -> [Node; 4] {
        let known = self.nodes.known_below(seed);
        [3, 2, 1, 0].map(|kept| [0, 1, 2].map(|axis| if axis < kept { known[axis] } else { seed[axis] }))
    }

    fn seeds(&self) -> Vec<Node> {
        let mut random = ChaCha8Rng::seed_from_u64(SEED);
        let counts = strata(&self.bounds, SEEDS);
        let mut seeds = Vec::with_capacity(counts.iter().product());
        for index in 0..counts.iter().product::<usize>() {
            let cell = [index % counts[0], index / counts[0] % counts[1], index / (counts[0] * counts[1])];
            let fraction = [0, 1, 2].map(|axis| (cell[axis] as f64 + random.random::<f64>()) / counts[axis] as f64);
            let place = |axis: usize| (fraction[axis] * self.counts[axis] as f64).round() as usize;
            seeds.push([0, 1, 2].map(|axis| if axis < self.dimension { place(axis) } else { 0 }));
        }
        seeds
    }

    /// True if a point in the box counts as part of the region: the answer of the corner nearest to it.
    ///
    /// In a cell that the boundary passes, the fraction of these points equals the fraction of its corners that hold.
    pub(crate) fn contains(&self, point: &Point) -> bool {
        self.nodes.holds([0, 1, 2].map(|axis| {
            if axis >= self.dimension {
                return 0;
            }
            let fraction = (point[axis] - self.bounds.least()[axis]) / self.bounds.extent(axis);
            ((fraction * self.counts[axis] as f64).round().max(0.0) as usize).min(self.counts[axis])
        }))
    }
}
