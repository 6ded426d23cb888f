//! Volume and centroid of a polytope that half-spaces enclose, by recursion over its facets (Lasserre 1983).

use super::affine::{add_scaled, dot};

/// Half-spaces a·λ ≤ b with ‖a‖ = 1, with memory for those of its facets, of their facets and so on.
#[derive(Clone, Debug)]
pub(super) struct Polytope {
    /// One level per dimension: level d has half-spaces of dimension d + 1.
    levels: Vec<Level>,
    /// Number of levels in use.
    dimension: usize,
    /// Half-spaces of faces that may still be visited before the recursion gives up.
    work: u64,
}

/// Outcome of the recursion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Centroid<'a> {
    /// The centroid.
    Found(&'a [f64]),
    /// The set has no volume.
    NoVolume,
    /// More faces than can be added up in bounded time.
    TooManyFaces,
}

/// Half-spaces of faces that are visited before giving up: some seconds' work.
const MOST_WORK: u64 = 400_000_000;
/// Largest dimension that is tried: each takes about twenty times as long as the one before.
const MOST_DIMENSIONS: usize = 8;

/// The half-spaces of one face, in coordinates of its own.
#[derive(Clone, Debug, Default)]
struct Level {
    /// Normals of length 1, one after the other.
    normals: Vec<f64>,
    /// Distances of their planes from the origin.
    offsets: Vec<f64>,
    /// Upper bound on the distance of the face's points from the origin.
    reach: f64,
    centre: Vec<f64>,
    sum: Vec<f64>,
    row: Vec<f64>,
    /// Householder vector v and 2/‖v‖² of the reflection that takes the last axis to the normal of the current facet,
    /// up to the sign.
    reflector: Vec<f64>,
    factor: f64,
}

/// Distances below this, relative to the size of the whole set, are rounding.
const ROUNDING: f64 = 1e-12;
/// Normals that differ by less than this angle are parallel.
const PARALLEL: f64 = 1e-9;

impl Polytope {
    /// Memory for this many half-spaces.
    pub(super) fn new(dimension: usize, half_spaces: usize) -> Self {
        let mut polytope = Self { levels: Vec::new(), dimension, work: 0 };
        polytope.claim(dimension);
        for (level, memory) in polytope.levels.iter_mut().enumerate() {
            memory.normals.reserve(half_spaces * (level + 1));
            memory.offsets.reserve(half_spaces);
        }
        polytope
    }

    fn claim(&mut self, dimension: usize) {
        while self.levels.len() < dimension {
            let size = self.levels.len() + 1;
            let [centre, sum, row, reflector] = [(); 4].map(|()| vec![0.0; size]);
            self.levels.push(Level { centre, sum, row, reflector, ..Level::default() });
        }
    }

    /// Starts a polytope around the origin, inside the unit ball.
    pub(super) fn begin(&mut self, dimension: usize) {
        self.claim(dimension);
        self.dimension = dimension;
        self.work = MOST_WORK;
        self.levels[dimension - 1].clear(1.0);
    }

    /// Adds a·λ ≤ b; the normal may have any length, and the origin lies inside.
    pub(super) fn add(&mut self, normal: &[f64], offset: f64) {
        // a shorter normal belongs to a cable whose tension is fixed
        if dot(normal, normal).sqrt() > PARALLEL {
            self.levels[self.dimension - 1].add(normal, offset.max(0.0));
        }
    }

    /// The centroid, if the set has a volume and not too many faces.
    pub(super) fn centroid(&mut self) -> Centroid<'_> {
        let dimension = self.dimension;
        if dimension > MOST_DIMENSIONS {
            return Centroid::TooManyFaces;
        }
        match measure(&mut self.levels[..dimension], &mut self.work) {
            None => Centroid::TooManyFaces,
            Some(volume) if volume > 0.0 => Centroid::Found(&self.levels[dimension - 1].centre),
            Some(_) => Centroid::NoVolume,
        }
    }
}

impl Level {
    fn clear(&mut self, reach: f64) {
        self.normals.clear();
        self.offsets.clear();
        self.reach = reach;
    }

    /// Adds a half-space unless it contains the whole face; false if it contains no point of it.
    fn add(&mut self, normal: &[f64], offset: f64) -> bool {
        let length = dot(normal, normal).sqrt();
        let offset = offset / length;
        if offset < -self.reach {
            return false;
        }
        if offset <= self.reach {
            self.normals.extend(normal.iter().map(|entry| entry / length));
            self.offsets.push(offset);
        }
        true
    }
}

/// Volume of the last level's face, `None` if the work is used up; writes its centroid to `centre`.
fn measure(levels: &mut [Level], work: &mut u64) -> Option<f64> {
    let Some((face, below)) = levels.split_last_mut() else { return Some(0.0) };
    let Some(next) = below.len().checked_sub(1) else { return Some(face.measure_segment()) };
    let dimension = face.centre.len() as f64;
    let mut volume = 0.0;
    face.sum.fill(0.0);
    for facet in 0..face.offsets.len() {
        *work = work.checked_sub(face.offsets.len() as u64)?;
        if !face.write_facet(facet, &mut below[next]) {
            continue;
        }
        let part = face.offsets[facet] * measure(below, work)? / dimension;
        volume += part;
        // the centroid of a cone from the origin lies at d/(d + 1) of the way to that of its base
        face.add_place(facet, &below[next].centre, part * dimension / (dimension + 1.0));
    }
    if volume > 0.0 {
        face.centre.iter_mut().zip(&face.sum).for_each(|(centre, sum)| *centre = sum / volume);
    }
    Some(volume.max(0.0))
}

impl Level {
    fn measure_segment(&mut self) -> f64 {
        let (mut low, mut high) = (-self.reach, self.reach);
        for (normal, offset) in self.normals.iter().zip(&self.offsets) {
            if *normal > 0.0 {
                high = high.min(*offset);
            } else {
                low = low.max(-offset);
            }
        }
        self.centre[0] = 0.5 * (low + high);
        (high - low).max(0.0)
    }

    /// Writes the half-spaces of a facet around the foot of the perpendicular from the origin; false if the facet is
    /// empty, or the same as an earlier one.
    fn write_facet(&mut self, facet: usize, target: &mut Level) -> bool {
        let dimension = self.centre.len();
        let offset = self.offsets[facet];
        let square = self.reach * self.reach - offset * offset;
        if !(square > 0.0) {
            return false;
        }
        target.clear(square.sqrt());
        let normal = &self.normals[facet * dimension..][..dimension];
        self.reflector.copy_from_slice(normal);
        let head = normal[dimension - 1];
        self.reflector[dimension - 1] += 1.0_f64.copysign(head);
        self.factor = 1.0 / (1.0 + head.abs());
        for other in (0..self.offsets.len()).filter(|other| *other != facet) {
            let a = &self.normals[other * dimension..][..dimension];
            let cos = dot(a, normal);
            let remainder = self.offsets[other] - cos * offset;
            self.row.copy_from_slice(a);
            add_scaled(&mut self.row, -self.factor * dot(a, &self.reflector), &self.reflector);
            let row = &self.row[..dimension - 1];
            if dot(row, row).sqrt() < PARALLEL {
                let is_same = cos > 0.0 && remainder.abs() <= ROUNDING;
                if remainder < -ROUNDING || (is_same && other < facet) {
                    return false;
                }
            } else if !target.add(row, remainder) {
                return false;
            }
        }
        true
    }

    /// Adds a point of the current facet, given in the facet's coordinates, to the weighted sum.
    fn add_place(&mut self, facet: usize, coordinates: &[f64], weight: f64) {
        let dimension = self.centre.len();
        add_scaled(&mut self.sum, weight * self.offsets[facet], &self.normals[facet * dimension..][..dimension]);
        add_scaled(&mut self.sum, weight, coordinates);
        let along = dot(coordinates, &self.reflector);
        add_scaled(&mut self.sum, -weight * self.factor * along, &self.reflector);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cube of three dimensions has 6 facets with 4 edges each.
    #[test]
    fn a_set_whose_work_is_used_up_has_no_centroid() {
        let cube = |work: Option<u64>| {
            let mut polytope = Polytope::new(3, 6);
            polytope.begin(3);
            for axis in 0..3 {
                let unit = |sign: f64| [0, 1, 2].map(|k| if k == axis { sign } else { 0.0 });
                polytope.add(&unit(1.0), 0.5);
                polytope.add(&unit(-1.0), 0.25);
            }
            polytope.work = work.unwrap_or(polytope.work);
            match polytope.centroid() {
                Centroid::Found(centre) => centre.iter().all(|entry| (entry - 0.125).abs() < 1e-15),
                _ => false,
            }
        };
        assert!(cube(None) && !cube(Some(100)));
    }
}
