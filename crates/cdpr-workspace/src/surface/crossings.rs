//! Crossings of the boundary with edges of the lattice.

use crate::{Point, Region};

/// Halvings of an edge, which locate the boundary to less than a thousandth of its length.
const HALVINGS: u32 = 10;

/// A vertex before its position is computed.
#[derive(Clone, Copy, Debug)]
pub(super) enum VertexPosition {
    At(Point),
    /// On the boundary between a point inside and one outside.
    Between(Point, Point),
}

/// The position of every vertex (m); between two points, the last point inside.
pub(super) fn places(region: &Region<'_>, vertices: &[VertexPosition]) -> Vec<Point> {
    let mut open: Vec<(usize, Point)> = Vec::new();
    let mut points: Vec<Point> = Vec::with_capacity(vertices.len());
    for (index, vertex) in vertices.iter().enumerate() {
        points.push(match vertex {
            VertexPosition::At(point) => *point,
            VertexPosition::Between(inside, outside) => {
                open.push((index, *outside));
                *inside
            }
        });
    }
    let (mut middles, mut holds) = (Vec::with_capacity(open.len()), vec![false; open.len()]);
    for _ in 0..HALVINGS {
        middles.clear();
        middles.extend(
            open.iter().map(|(index, outside)| [0, 1, 2].map(|axis| 0.5 * (points[*index][axis] + outside[axis]))),
        );
        region.holds_all(&middles, &mut holds);
        for (((index, outside), middle), &holds) in open.iter_mut().zip(&middles).zip(&holds) {
            *(if holds { &mut points[*index] } else { outside }) = *middle;
        }
    }
    points
}
