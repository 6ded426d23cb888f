//! The boundary that an octree followed, as a mesh.

use super::Octree;
use crate::mesh::Mesh;
use crate::surface::{self, Lattice};

impl Octree<'_> {
    /// The boundary through the smallest cells, closed; in a plane the area.
    pub fn surface(&self) -> Mesh {
        let holds = |node| self.nodes.holds(node);
        let counts = [0, 1, 2].map(|axis| self.counts[axis] + usize::from(axis < self.dimension));
        let lattice = Lattice { region: self.region, bounds: &self.bounds, counts, inset: 0.0, holds: &holds };
        if self.dimension == 2 {
            return surface::of(&lattice, lattice.cubes());
        }
        // the lattice counts from the layer around it
        let inside = self.cells.iter().map(|cell| cell.node.map(|place| place + 1));
        surface::of(&lattice, inside.chain(lattice.cubes_at_faces()))
    }
}
