//! The boundary that an octree followed, as a mesh.

use super::{Octree, Outcome, Settings, search};
use crate::workspace::mesh::Mesh;
use crate::workspace::surface::{self, Lattice};
use crate::workspace::{Bounds, Region, WorkspaceError};

/// Measures a region in a box, and gives its boundary as it runs through the smallest cells; in a plane the area.
///
/// The surface is closed, each part of the region has its own, and its vertices between a corner that belongs to the region and
/// one that does not lie in the region, less than a thousandth of a smallest cell from the boundary.
pub fn solve_with_surface(
    region: &Region<'_>,
    bounds: &Bounds,
    settings: &Settings,
) -> Result<(Outcome, Mesh), WorkspaceError> {
    let octree = search(region, bounds, settings)?;
    Ok((octree.outcome(), octree.surface()))
}

impl Octree<'_> {
    /// The boundary as it runs through the smallest cells, closed; in a plane the area.
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
