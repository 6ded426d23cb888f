//! Surface through a cube of which some corners are inside: marching cubes (Lorensen, Cline 1987), with its table made
//! from one rule.
//!
//! On every face the surface cuts off each run of inside corners separately. Both cubes at a face see the same runs, so
//! that their pieces meet, and every edge of a piece on a face has its other triangle in the other cube.

/// Corner k of a cube lies at (k & 1, k >> 1 & 1, k >> 2) from its lower corner; an edge is its lower corner and its
/// axis.
pub(super) type Edge = (usize, usize);

/// One piece of surface: the edges whose crossings it joins, in order, counter-clockwise seen from outside.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Piece {
    pub(super) edges: Vec<Edge>,
    /// True if triangles from the first crossing are enough: none of their sides between crossings lies in a face of
    /// the cube, where the next cube might have the same side. Else the piece needs a vertex in its middle.
    pub(super) is_fan: bool,
}

/// Corners of each face, counter-clockwise seen from outside the cube.
const FACES: [[usize; 4]; 6] = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// Corners of a square, counter-clockwise.
const SQUARE: [usize; 4] = [0, 1, 3, 2];

/// The edge between two corners that differ in one coordinate.
fn edge(a: usize, b: usize) -> Edge {
    (a & b, (a ^ b).trailing_zeros() as usize)
}

/// Crossings of the edges of a face: the edge at which a run of inside corners begins, and the edge at which it ends.
fn runs(corners: &[usize; 4], is_inside: impl Fn(usize) -> bool) -> Vec<(Edge, Edge)> {
    let at = |place: usize| corners[place % 4];
    let begins = (0..4).filter(|&place| is_inside(at(place)) && !is_inside(at(place + 3)));
    let run = |place: usize| {
        let end = (place..place + 4).find(|&end| !is_inside(at(end + 1))).unwrap_or(place);
        (edge(at(place + 3), at(place)), edge(at(end), at(end + 1)))
    };
    begins.map(run).collect()
}

/// Pieces of every cube, by the bits of its inside corners.
pub(super) fn cubes() -> Vec<Vec<Piece>> {
    (0..256).map(pieces).collect()
}

fn pieces(inside: usize) -> Vec<Piece> {
    // each crossed edge lies on two faces, and begins a run on one of them
    let steps: Vec<(Edge, Edge)> =
        FACES.iter().flat_map(|face| runs(face, |corner| inside >> corner & 1 == 1)).collect();
    let mut open = steps.clone();
    let mut pieces = Vec::new();
    while let Some((first, mut next)) = open.pop() {
        let mut edges = vec![first];
        while next != first {
            edges.push(next);
            let Some(place) = open.iter().position(|(from, _)| *from == next) else { break };
            next = open.swap_remove(place).1;
        }
        pieces.push(piece(edges));
    }
    pieces
}

/// Rotates the edges so that triangles from the first one are enough, if possible.
fn piece(mut edges: Vec<Edge>) -> Piece {
    let count = edges.len();
    let is_on =
        |face: &[usize; 4], (corner, axis): Edge| face.contains(&corner) && face.contains(&(corner | 1 << axis));
    for _ in 0..count {
        let is_in_a_face = |other: &Edge| FACES.iter().any(|face| is_on(face, edges[0]) && is_on(face, *other));
        if !edges[2..count - 1].iter().any(is_in_a_face) {
            return Piece { edges, is_fan: true };
        }
        edges.rotate_left(1);
    }
    Piece { edges, is_fan: false }
}

/// A corner of the inside part of a square: one of its own corners, or a crossing of an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Corner {
    Node(usize),
    Crossing(Edge),
}

/// The inside part of a square, as convex parts counter-clockwise, by the bits of its inside corners.
pub(super) fn squares() -> Vec<Vec<Vec<Corner>>> {
    (0..16).map(parts).collect()
}

fn parts(inside: usize) -> Vec<Vec<Corner>> {
    if inside == 15 {
        return vec![SQUARE.map(Corner::Node).to_vec()];
    }
    let is_inside = |corner: usize| inside >> corner & 1 == 1;
    let part = |(begin, end): (Edge, Edge)| {
        let place = |(corner, axis): Edge| {
            let corners = [corner, corner | 1 << axis];
            let inner = if is_inside(corners[0]) { corners[0] } else { corners[1] };
            SQUARE.iter().position(|&corner| corner == inner).unwrap_or_default()
        };
        let (from, to) = (place(begin), place(end));
        let nodes = (0..=(to + 4 - from) % 4).map(|step| Corner::Node(SQUARE[(from + step) % 4]));
        [Corner::Crossing(begin)].into_iter().chain(nodes).chain([Corner::Crossing(end)]).collect()
    };
    runs(&SQUARE, is_inside).into_iter().map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every crossed edge is in one piece, every side of a piece lies in a face, and no side of a fan does.
    #[test]
    fn pieces_use_every_crossed_edge_once_and_go_round_by_faces() {
        let all: Vec<Edge> =
            (0..8).flat_map(|corner| (0..3).map(move |axis| (corner, axis))).filter(|(c, a)| c >> a & 1 == 0).collect();
        let (mut fans, mut stars) = (0, 0);
        for (inside, pieces) in cubes().iter().enumerate() {
            for &(corner, axis) in &all {
                let is_crossed = (inside >> corner ^ inside >> (corner | 1 << axis)) & 1 == 1;
                let uses = pieces.iter().flat_map(|piece| &piece.edges).filter(|edge| **edge == (corner, axis)).count();
                assert_eq!(uses, usize::from(is_crossed), "{inside:08b} {corner} {axis}");
            }
            for piece in pieces {
                assert!((3..=12).contains(&piece.edges.len()), "{piece:?}");
                *(if piece.is_fan { &mut fans } else { &mut stars }) += 1;
            }
        }
        assert!(fans > 250, "{fans} {stars}");
    }

    /// One corner inside: the triangle across it is seen counter-clockwise from the other seven.
    #[test]
    fn a_corner_is_cut_off_by_one_triangle() {
        let piece = &cubes()[1][0];
        let first = piece.edges.iter().position(|edge| *edge == (0, 0)).unwrap();
        let turned: Vec<usize> = (0..3).map(|step| piece.edges[(first + step) % 3].1).collect();
        assert_eq!(turned, [0, 1, 2]);
    }
}
