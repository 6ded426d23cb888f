//! The corners of a zonotope, with the limit of each cable there.

use std::collections::HashSet;

use super::facets::{Rows, dot, hyperplanes, moved};
use super::zonotope::{Zonotope, unit};

/// A corner of the available wrench set, with the tensions that give it.
#[derive(Clone, Debug, PartialEq)]
pub struct Vertex {
    /// The wrench (N, N·m).
    pub wrench: Vec<f64>,
    /// Tension per cable (N), each at one of its limits.
    pub tensions: Vec<f64>,
}

impl Zonotope {
    /// All corners, each once.
    ///
    /// A facet with no more generators than dimensions is a parallelotope, whose corners are all choices of limits of
    /// its cables; others are zonotopes of one dimension less.
    pub fn vertices(&self) -> Vec<Vertex> {
        let units: Vec<Rows> = self.generators.iter().map(|generator| unit(&self.along_axes(generator))).collect();
        let numbered: Vec<(u64, Rows)> = units.iter().enumerate().map(|(index, unit)| (1 << index, *unit)).collect();
        let mut signs: Vec<u64> = corners(&numbered, self.dimension).into_iter().collect();
        signs.sort_unstable();
        signs.into_iter().map(|plus| self.vertex(plus)).collect()
    }

    fn vertex(&self, plus: u64) -> Vertex {
        let mut wrench = self.center;
        let mut tensions: Vec<f64> = (0..self.limits.cable_count()).map(|cable| self.limits.middle(cable)).collect();
        for (index, (generator, &cable)) in self.generators.iter().zip(&self.cables).enumerate() {
            let is_plus = plus & (1 << index) != 0;
            wrench = moved(wrench, if is_plus { 1.0 } else { -1.0 }, generator);
            tensions[cable] = if is_plus { self.limits.maximum()[cable] } else { self.limits.minimum()[cable] };
        }
        Vertex { wrench: self.unscaled(&wrench), tensions }
    }
}

/// The generators with sign + in each corner, as sums of their bits; unit generators span the first `dimension` rows.
fn corners(generators: &[(u64, Rows)], dimension: usize) -> HashSet<u64> {
    let mut found = HashSet::new();
    if dimension == 0 {
        // parts of a facet too small to have a direction: their cables may have any tension
        found.insert(0);
        return found;
    }
    let units: Vec<Rows> = generators.iter().map(|(_, unit)| *unit).collect();
    let all: u64 = generators.iter().map(|(bit, _)| bit).sum();
    for hyperplane in hyperplanes(&units, dimension) {
        let (mut fixed, mut inside) = (0, Vec::new());
        for (index, (bit, unit)) in generators.iter().enumerate() {
            if hyperplane.contained & (1 << index) != 0 {
                let mut components = [0.0; 6];
                for (component, axis) in components.iter_mut().zip(&hyperplane.basis[..dimension - 1]) {
                    *component = dot(unit, axis);
                }
                inside.push((*bit, components));
            } else if dot(&hyperplane.normal, unit) > 0.0 {
                fixed |= bit;
            }
        }
        // the opposite facet has the opposite corners
        for plus in inner_corners(&inside, dimension - 1) {
            found.insert(fixed | plus);
            found.insert(all & !(fixed | plus));
        }
    }
    found
}

fn inner_corners(inside: &[(u64, Rows)], dimension: usize) -> HashSet<u64> {
    if inside.len() > dimension {
        return corners(inside, dimension);
    }
    (0..1_u64 << inside.len())
        .map(|choice| (0..inside.len()).filter(|index| choice & (1 << index) != 0).map(|index| inside[index].0).sum())
        .collect()
}
