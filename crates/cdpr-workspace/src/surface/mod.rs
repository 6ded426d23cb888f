//! The boundary of a region that was sampled on a lattice, as a mesh.
//!
//! Between neighbouring nodes of which one lies inside, the boundary is found by bisection of the verdict itself, which
//! is exact at jumps of the margin and cheaper than a margin. Positions outside the box count as outside: where the
//! region reaches the faces of the box, the surface is the face.

mod cases;
mod cells;
mod crossings;

use crossings::VertexPosition;
use std::collections::HashMap;

use cases::{Corner, Edge, Piece};
pub use cells::Cells;

use super::mesh::{Field, Mesh};
use super::{Bounds, Point, Region, Verdict};

/// A node counted along each axis.
pub(super) type Node = [usize; 3];

/// Samples at the nodes of a lattice, surrounded by a layer of outside nodes.
pub(super) struct Lattice<'a> {
    pub(super) region: &'a Region<'a>,
    pub(super) bounds: &'a Bounds,
    /// Nodes along each axis; 1 across a plane.
    pub(super) counts: [usize; 3],
    /// Distance of the first node from the lower face of the box, in steps: half a step for middles of cells, 0 for
    /// corners.
    pub(super) inset: f64,
    /// Returns whether a node belongs to the region.
    pub(super) holds: &'a dyn Fn(Node) -> bool,
}

impl Lattice<'_> {
    /// True if a node belongs to the region; nodes are counted from the layer around the lattice.
    fn is_inside(&self, node: Node) -> bool {
        let mut place = node;
        for axis in 0..self.bounds.dimension() {
            if node[axis] == 0 || node[axis] > self.counts[axis] {
                return false;
            }
            place[axis] -= 1;
        }
        (self.holds)(place)
    }

    /// Position of a node (m); nodes of the layer lie on the faces of the box.
    fn point(&self, node: Node) -> Point {
        let mut point = [0.0; 3];
        for axis in 0..self.bounds.dimension() {
            let steps = self.counts[axis] as f64 - 1.0 + 2.0 * self.inset;
            let fraction = ((node[axis] as f64 - 1.0 + self.inset) / steps).clamp(0.0, 1.0);
            point[axis] = self.bounds.least()[axis] + fraction * self.bounds.extent(axis);
        }
        point
    }

    fn index(&self, node: Node) -> u64 {
        let [columns, rows, _] = self.counts.map(|count| count as u64 + 2);
        (node[2] as u64 * rows + node[1] as u64) * columns + node[0] as u64
    }

    /// Lower corners of all cubes (squares in a plane) that have a corner on the lattice.
    pub(super) fn cubes(&self) -> impl Iterator<Item = Node> + use<> {
        let [columns, rows, layers] = self.counts;
        let layers = if self.bounds.dimension() == 3 { 0..=layers } else { 0..=0 };
        layers.flat_map(move |z| (0..=rows).flat_map(move |y| (0..=columns).map(move |x| [x, y, z])))
    }

    /// The cubes of [`Self::cubes`] outside the box or across its faces.
    pub(super) fn cubes_at_faces(&self) -> impl Iterator<Item = Node> + use<'_> {
        let dimension = self.bounds.dimension();
        let (axes, rest) = (0..dimension, move |axis: usize| [(axis + 1) % dimension, (axis + 2) % dimension]);
        axes.flat_map(move |axis| {
            let [second, third] = rest(axis);
            let thirds = if dimension == 3 { 0..=self.counts[third] } else { 0..=0 };
            [0, self.counts[axis]].into_iter().flat_map(move |end| {
                let thirds = thirds.clone();
                thirds.flat_map(move |c| {
                    (0..=self.counts[second]).map(move |b| {
                        let mut cube = [0; 3];
                        cube[second] = b;
                        if dimension == 3 {
                            cube[third] = c;
                        }
                        cube[axis] = end;
                        cube
                    })
                })
            })
        })
    }
}

/// The boundary of the region through these cubes; in a plane the area itself.
///
/// A cube may occur more than once.
pub(super) fn of(lattice: &Lattice<'_>, cubes: impl Iterator<Item = Node>) -> Mesh {
    let mut drawing = Drawing { lattice, vertices: HashMap::new(), crossings: Vec::new(), triangles: Vec::new() };
    let middles = match lattice.bounds.dimension() {
        2 => drawing.area(cubes),
        _ => drawing.surface(cubes),
    };
    drawing.finish(middles)
}

struct Drawing<'a> {
    lattice: &'a Lattice<'a>,
    /// Vertices by the edges and nodes on which they lie.
    vertices: HashMap<(u64, usize), u32>,
    crossings: Vec<VertexPosition>,
    triangles: Vec<[u32; 3]>,
}

/// Stands for the axis in [`Drawing::vertices`] if a vertex lies on a node.
const AT_NODE: usize = 3;

impl Drawing<'_> {
    /// The vertex on an edge of a cube.
    fn crossing(&mut self, cube: Node, (corner, axis): Edge) -> u32 {
        let node = corner_of(cube, corner);
        let (lattice, next) = (self.lattice, self.crossings.len() as u32);
        *self.vertices.entry((lattice.index(node), axis)).or_insert_with(|| {
            let mut other = node;
            other[axis] += 1;
            let (inside, outside) = if lattice.is_inside(node) { (node, other) } else { (other, node) };
            let is_beyond = outside[axis] == 0 || outside[axis] > lattice.counts[axis];
            let [from, to] = [inside, outside].map(|node| lattice.point(node));
            self.crossings.push(if is_beyond && lattice.region.holds(&to) {
                VertexPosition::At(to)
            } else {
                VertexPosition::Between(from, to)
            });
            next
        })
    }

    fn node(&mut self, cube: Node, corner: usize) -> u32 {
        let node = corner_of(cube, corner);
        let (lattice, next) = (self.lattice, self.crossings.len() as u32);
        *self.vertices.entry((lattice.index(node), AT_NODE)).or_insert_with(|| {
            self.crossings.push(VertexPosition::At(lattice.point(node)));
            next
        })
    }

    /// Bits of the corners that are inside.
    fn inside(&self, cube: Node) -> usize {
        let corners = 1 << self.lattice.bounds.dimension();
        (0..corners).map(|corner| usize::from(self.lattice.is_inside(corner_of(cube, corner))) << corner).sum()
    }

    /// Adds the triangles of all cubes; returns the pieces with a vertex in the middle, by their corners, after all
    /// crossings.
    fn surface(&mut self, cubes: impl Iterator<Item = Node>) -> Vec<Vec<u32>> {
        let (cases, mut middles, mut seen) = (cases::cubes(), Vec::new(), std::collections::HashSet::new());
        for cube in cubes {
            let pieces: &[Piece] = &cases[self.inside(cube)];
            if pieces.is_empty() || !seen.insert(cube) {
                continue;
            }
            for piece in pieces {
                let corners: Vec<u32> = piece.edges.iter().map(|&edge| self.crossing(cube, edge)).collect();
                match piece.is_fan {
                    true => self.triangles.extend(corners[1..].windows(2).map(|pair| [corners[0], pair[0], pair[1]])),
                    false => middles.push(corners),
                }
            }
        }
        middles
    }

    /// Adds the triangles of the area in all squares.
    fn area(&mut self, squares: impl Iterator<Item = Node>) -> Vec<Vec<u32>> {
        let cases = cases::squares();
        for square in squares {
            for part in &cases[self.inside(square)] {
                let corners = part.iter().map(|corner| match corner {
                    Corner::Node(corner) => self.node(square, *corner),
                    Corner::Crossing(edge) => self.crossing(square, *edge),
                });
                let corners: Vec<u32> = corners.collect();
                self.triangles.extend(corners[1..].windows(2).map(|pair| [corners[0], pair[0], pair[1]]));
            }
        }
        Vec::new()
    }

    /// Computes the positions of all vertices and the fields there.
    fn finish(mut self, middles: Vec<Vec<u32>>) -> Mesh {
        let region = self.lattice.region;
        let mut points = crossings::places(region, &self.crossings);
        for corners in middles {
            let mut middle = [0.0; 3];
            for &corner in &corners {
                (0..3).for_each(|axis| middle[axis] += points[corner as usize][axis] / corners.len() as f64);
            }
            let star = points.len() as u32;
            points.push(middle);
            let next = corners.iter().cycle().skip(1);
            self.triangles.extend(corners.iter().zip(next).map(|(&from, &to)| [star, from, to]));
        }
        let vertices = points.iter().map(|point| region.position(point).into()).collect();
        Mesh { vertices, triangles: self.triangles, fields: fields(region, &points) }
    }
}

fn corner_of(cube: Node, corner: usize) -> Node {
    [0, 1, 2].map(|axis| cube[axis] + (corner >> axis & 1))
}

/// Margin of the criterion at each point, and the number of the limiting cable.
pub(super) fn fields(region: &Region<'_>, points: &[Point]) -> Vec<Field> {
    #[cfg(feature = "parallel")]
    let verdicts: Vec<Verdict> = {
        use rayon::prelude::*;
        points.par_iter().map(|point| region.judge(point)).collect()
    };
    #[cfg(not(feature = "parallel"))]
    let verdicts: Vec<Verdict> = points.iter().map(|point| region.judge(point)).collect();
    // a pose that no change can mend has no finite margin
    let finite = |margin: f64| margin.clamp(-f64::MAX, f64::MAX);
    let cable = |cable: Option<usize>| cable.map_or(0.0, |cable| (cable + 1) as f64);
    vec![
        Field {
            name: "margin".to_owned(),
            unit: region.criterion().unit().to_owned(),
            values: verdicts.iter().map(|verdict| finite(verdict.margin)).collect(),
        },
        Field {
            name: "limiting cable".to_owned(),
            unit: String::new(),
            values: verdicts.iter().map(|verdict| cable(verdict.cable)).collect(),
        },
    ]
}
