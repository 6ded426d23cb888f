//! What is known of the corners of the smallest cells.

/// A corner of the smallest cells, counted along each axis.
pub(super) type Node = [usize; 3];

/// Two bits for each corner: judged or not, and with which answer.
pub(super) struct Nodes {
    counts: [usize; 3],
    states: Vec<u8>,
}

const UNKNOWN: u8 = 0;
const FAILS: u8 = 1;
const HOLDS: u8 = 2;
/// Marked for the next batch.
const ASKED: u8 = 3;

impl Nodes {
    /// So many corners along each axis, none judged.
    pub(super) fn new(counts: [usize; 3]) -> Self {
        let total: usize = counts.iter().product();
        Self { counts, states: vec![0; total.div_ceil(4)] }
    }

    fn index(&self, node: Node) -> usize {
        (node[2] * self.counts[1] + node[1]) * self.counts[0] + node[0]
    }

    fn state(&self, node: Node) -> u8 {
        let index = self.index(node);
        self.states[index / 4] >> (2 * (index % 4)) & 3
    }

    fn set(&mut self, node: Node, state: u8) {
        let index = self.index(node);
        let (byte, shift) = (&mut self.states[index / 4], 2 * (index % 4));
        *byte = *byte & !(3 << shift) | state << shift;
    }

    /// True once for each corner: it is to be judged now.
    pub(super) fn ask(&mut self, node: Node) -> bool {
        let is_new = self.state(node) == UNKNOWN;
        if is_new {
            self.set(node, ASKED);
        }
        is_new
    }

    pub(super) fn answer(&mut self, node: Node, holds: bool) {
        self.set(node, if holds { HOLDS } else { FAILS });
    }

    /// The answer at a corner, if it was judged.
    pub(super) fn known(&self, node: Node) -> Option<bool> {
        match self.state(node) {
            HOLDS => Some(true),
            FAILS => Some(false),
            _ => None,
        }
    }

    /// The answer at a corner; where it was not judged that of the end of the edge or face on whose middle it lies.
    pub(super) fn holds(&self, mut node: Node) -> bool {
        loop {
            if let Some(holds) = self.known(node) {
                return holds;
            }
            // the middle of something: one step of its level back along the axis in which it is one
            let finest = node.iter().filter(|place| **place > 0).map(|place| place.trailing_zeros()).min();
            let axis = node.iter().position(|place| *place > 0 && Some(place.trailing_zeros()) == finest);
            let (Some(axis), Some(finest)) = (axis, finest) else { return false };
            node[axis] -= 1 << finest;
        }
    }
}
