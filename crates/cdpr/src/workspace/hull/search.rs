//! Where rays leave a region.

use super::{Settings, Status};
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
    pub(super) status: Status,
}

impl Rays<'_> {
    /// Probes along every ray, then bisection between the last probe in the region before the first one outside, and that.
    pub(super) fn search(&self, settings: &Settings) -> Found {
        let probes = settings.probes.max(1);
        let holds = self.probe(probes);
        let mut brackets = Vec::with_capacity(self.lengths.len());
        let (mut rays_at_bounds, mut not_star_shaped) = (0, 0);
        let mut longest: (usize, Option<Point>) = (0, None);
        for (ray, holds) in holds.chunks_exact(probes).enumerate() {
            let at = |probe: usize| self.lengths[ray] * probe as f64 / probes as f64;
            let left = holds.iter().position(|holds| !holds);
            rays_at_bounds += usize::from(left.is_none());
            brackets.push(left.map_or([self.lengths[ray]; 2], |left| [at(left), at(left + 1)]));
            let again = left.map_or(0, |left| holds[left..].iter().filter(|holds| **holds).count());
            not_star_shaped += usize::from(again > 0);
            if again > longest.0 {
                longest = (again, Some(self.directions[ray]));
            }
        }
        let [judged, feasible] = self.bisect(&mut brackets, settings.tolerance);
        let status = match longest.1 {
            Some(direction) => Status::NotStarShaped { rays: not_star_shaped, direction },
            None => Status::StarShaped,
        };
        Found {
            radii: brackets.iter().map(|bracket| bracket[0]).collect(),
            rays_at_bounds,
            points: judged + holds.len() as u64,
            feasible_points: feasible + holds.iter().filter(|holds| **holds).count() as u64,
            status,
        }
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
