//! Known answers at the corners of the smallest cells.

/// A corner of the smallest cells, counted along each axis.
pub(super) type Node = [usize; 3];

/// Two bits for each corner: whether it was judged, and the answer.
pub(super) struct Nodes {
    counts: [usize; 3],
    states: Vec<u8>,
}

const UNKNOWN: u8 = 0;
const FAILS: u8 = 1;
const HOLDS: u8 = 2;
/// Requested for the next batch.
const ASKED: u8 = 3;

impl Nodes {
    /// Nodes with this number of corners along each axis, none judged.
    pub(super) fn new(counts: [usize; 3]) -> Self {
        let total: usize = counts.iter().product();
        Self { counts, states: vec![0; total.div_ceil(4)] }
    }

    fn index(&self, node: Node) -> usize {
        (node[2] * self.counts[1] + node[1]) * self.counts[0] + node[0]
    }

    fn state(&self, index: usize) -> u8 {
        self.states[index / 4] >> (2 * (index % 4)) & 3
    }

    fn set(&mut self, node: Node, state: u8) {
        let index = self.index(node);
        let (byte, shift) = (&mut self.states[index / 4], 2 * (index % 4));
        *byte = *byte & !(3 << shift) | state << shift;
    }

    /// Requests a corner; true the first time.
    pub(super) fn ask(&mut self, node: Node) -> bool {
        let is_new = self.state(self.index(node)) == UNKNOWN;
        if is_new {
            self.set(node, ASKED);
        }
        is_new
    }

    pub(super) fn answer(&mut self, node: Node, holds: bool) {
        self.set(node, if holds { HOLDS } else { FAILS });
    }

    /// Bits of the feasible corners of a cell whose corners were judged: corner k lies at (k & 1, k >> 1 & 1, k >> 2).
    pub(super) fn corners(&self, cell: Node, dimension: usize) -> u8 {
        let (first, row, layer) = (self.index(cell), self.counts[0], self.counts[0] * self.counts[1]);
        let offsets = [0, 1, row, row + 1, layer, layer + 1, layer + row, layer + row + 1];
        let corners = offsets.iter().take(1 << dimension).enumerate();
        corners.map(|(corner, offset)| u8::from(self.state(first + offset) == HOLDS) << corner).sum()
    }

    /// The answer at a corner; if it was not judged that of its neighbours, since both ends of every edge that the
    /// boundary crosses were judged.
    pub(super) fn holds(&self, node: Node) -> bool {
        self.state(self.index(self.known_below(node))) == HOLDS
    }

    /// The first judged corner on the path down the first axis to its end, then down the next one.
    pub(super) fn known_below(&self, mut node: Node) -> Node {
        while !matches!(self.state(self.index(node)), HOLDS | FAILS) {
            match node.iter_mut().find(|place| **place > 0) {
                Some(place) => *place -= 1,
                None => break,
            }
        }
        node
    }
}
