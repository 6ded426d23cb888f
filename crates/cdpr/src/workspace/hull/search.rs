//! Where rays leave a region.

use super::Settings;
use crate::workspace::{Point, Region};

/// Rays from a centre.
pub(super) struct Rays<'a> {
    pub(super) region: &'a Region<'a>,
    pub(super) center: &'a Point,
    pub(super) directions: &'a [Point],
    /// How far each ray is followed (m).
    pub(super) lengths: &'a [f64],
}

pub(super) struct Found {
    pub(super) radii: Vec<f64>,
    pub(super) rays_at_bounds: usize,
    pub(super) points: u64,
    pub(super) feasible_points: u64,
    pub(super) again: Again,
}

/// What rays saw of the region after they had left it.
#[derive(Clone, Debug, Default)]
pub(super) struct Again {
    /// Number of rays that entered it again.
    pub(super) rays: usize,
    /// Direction of the one that did over the longest way.
    pub(super) direction: Point,
    /// Size of what they saw there, each for its part of all directions (m², m³).
    pub(super) size: f64,
}

impl Rays<'_> {
    /// Probes along every ray, then bisection between the last probe in the region before the first one outside, and that.
    pub(super) fn search(&self, settings: &Settings) -> Found {
        let probes = settings.probes.max(1);
        let holds = self.probe(probes);
        let mut brackets = Vec::with_capacity(self.lengths.len());
        let (mut rays_at_bounds, mut again, mut longest) = (0, Again::default(), 0.0);
        for (ray, holds) in holds.chunks_exact(probes).enumerate() {
            let at = |probe: usize| self.lengths[ray] * probe as f64 / probes as f64;
            let left = holds.iter().position(|holds| !holds);
            rays_at_bounds += usize::from(left.is_none());
            brackets.push(left.map_or([self.lengths[ray]; 2], |left| [at(left), at(left + 1)]));
            let beyond: Vec<usize> = (left.unwrap_or(probes)..probes).filter(|&probe| holds[probe]).collect();
            let way = beyond.len() as f64 * at(1);
            again.rays += usize::from(!beyond.is_empty());
            again.size += beyond.iter().map(|&probe| self.part(at(probe + 1)) * at(1)).sum::<f64>();
            if way > longest {
                (longest, again.direction) = (way, self.directions[ray]);
            }
        }
        let [judged, feasible] = self.bisect(&mut brackets, settings.tolerance);
        Found {
            radii: brackets.iter().map(|bracket| bracket[0]).collect(),
            rays_at_bounds,
            points: judged + holds.len() as u64,
            feasible_points: feasible + holds.iter().filter(|holds| **holds).count() as u64,
            again,
        }
    }

    /// A ray's part of the circle or sphere of a radius (m, m²).
    fn part(&self, radius: f64) -> f64 {
        let whole = match self.region.dimension() {
            2 => std::f64::consts::TAU * radius,
            _ => 2.0 * std::f64::consts::TAU * radius * radius,
        };
        whole / self.directions.len() as f64
    }

    fn point(&self, ray: usize, radius: f64) -> Point {
        [0, 1, 2].map(|axis| self.center[axis] + radius * self.directions[ray][axis])
    }

    /// Whether each probe lies in the region, the outermost at the end of its ray.
    fn probe(&self, probes: usize) -> Vec<bool> {
        let mut points = Vec::with_capacity(self.lengths.len() * probes);
        for (ray, length) in self.lengths.iter().enumerate() {
            points.extend((1..=probes).map(|probe| self.point(ray, length * probe as f64 / probes as f64)));
        }
        let mut holds = vec![false; points.len()];
        self.region.holds_all(&points, &mut holds);
        holds
    }

    /// Halves all brackets that are longer than the tolerance; tells how many points that took, and how many of them hold.
    fn bisect(&self, brackets: &mut [[f64; 2]], tolerance: f64) -> [u64; 2] {
        let (mut judged, mut feasible) = (0, 0);
        let (mut open, mut points, mut holds) = (Vec::new(), Vec::new(), Vec::new());
        loop {
            open.clear();
            open.extend((0..brackets.len()).filter(|&ray| {
                let [inside, outside] = brackets[ray];
                let middle = 0.5 * (inside + outside);
                // neighbouring numbers have no middle
                outside - inside > tolerance && inside < middle && middle < outside
            }));
            if open.is_empty() {
                return [judged, feasible];
            }
            points.clear();
            points.extend(open.iter().map(|&ray| self.point(ray, 0.5 * (brackets[ray][0] + brackets[ray][1]))));
            holds.clear();
            holds.resize(points.len(), false);
            self.region.holds_all(&points, &mut holds);
            judged += points.len() as u64;
            for (&ray, &holds) in open.iter().zip(&holds) {
                feasible += u64::from(holds);
                let middle = 0.5 * (brackets[ray][0] + brackets[ray][1]);
                brackets[ray][usize::from(!holds)] = middle;
            }
        }
    }
}
