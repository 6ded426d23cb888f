//! Search for the points at which rays leave a region.

use super::Settings;
use crate::criterion::Spans;
use crate::{Point, Region};

/// Rays from a centre.
pub(super) struct Rays<'a> {
    pub(super) region: &'a Region<'a>,
    pub(super) center: &'a Point,
    pub(super) directions: &'a [Point],
    /// Length to which each ray is followed (m).
    pub(super) lengths: &'a [f64],
}

pub(super) struct Exits {
    pub(super) radii: Vec<f64>,
    pub(super) rays_at_bounds: usize,
    pub(super) points: u64,
    pub(super) feasible_points: u64,
    pub(super) reentry: Reentry,
}

/// Parts of the region that rays met after leaving it.
#[derive(Clone, Debug, Default)]
pub(super) struct Reentry {
    /// Number of rays that entered it again.
    pub(super) rays: usize,
    /// Direction of the ray that did over the longest distance.
    pub(super) direction: Point,
    /// Size of these parts, each weighted with the ray's fraction of all directions (m², m³).
    pub(super) size: f64,
}

impl Rays<'_> {
    /// Reads the closed form if the criterion has one; else probes every ray, then bisects between the last probe in
    /// the region before the first one outside, and that one.
    pub(super) fn search(&self, settings: &Settings) -> Exits {
        let rays = self.directions.iter().zip(self.lengths);
        let spans = rays.map(|(direction, length)| self.region.holds_along(self.center, direction, *length));
        match spans.collect::<Option<Vec<Spans>>>() {
            Some(spans) => self.read(&spans, settings.tolerance),
            None => self.look(settings),
        }
    }

    /// Reads the spans of all rays. Each end is judged once: the point at a ray's end must lie in the region in
    /// spite of rounding.
    fn read(&self, spans: &[Spans], tolerance: f64) -> Exits {
        let (mut radii, mut rays_at_bounds, mut reentry, mut longest) = (Vec::new(), 0, Reentry::default(), 0.0);
        for (ray, spans) in spans.iter().enumerate() {
            // the centre belongs to the region
            let end = spans.parts().first().filter(|part| part[0] <= tolerance).map_or(0.0, |part| part[1]);
            rays_at_bounds += usize::from(end >= self.lengths[ray]);
            radii.push(end);
            let beyond: Vec<&[f64; 2]> = spans.parts().iter().filter(|part| part[0] > end).collect();
            let way: f64 = beyond.iter().map(|[from, to]| to - from).sum();
            reentry.rays += usize::from(way > tolerance);
            reentry.size += beyond.iter().map(|part| self.part(**part)).sum::<f64>();
            if way > longest {
                (longest, reentry.direction) = (way, self.directions[ray]);
            }
        }
        let points: Vec<Point> = radii.iter().enumerate().map(|(ray, radius)| self.point(ray, *radius)).collect();
        let mut holds = vec![false; points.len()];
        self.region.holds_all(&points, &mut holds);
        radii
            .iter_mut()
            .zip(&holds)
            .filter(|(_, holds)| !**holds)
            .for_each(|(radius, _)| *radius -= (0.5 * tolerance).min(*radius));
        let feasible_points = holds.iter().filter(|holds| **holds).count() as u64;
        Exits { radii, rays_at_bounds, points: points.len() as u64, feasible_points, reentry }
    }

    fn look(&self, settings: &Settings) -> Exits {
        let probes = settings.probes.max(1);
        let holds = self.probe(probes);
        let mut brackets = Vec::with_capacity(self.lengths.len());
        let (mut rays_at_bounds, mut reentry, mut longest) = (0, Reentry::default(), 0.0);
        for (ray, holds) in holds.chunks_exact(probes).enumerate() {
            let at = |probe: usize| self.lengths[ray] * probe as f64 / probes as f64;
            let left = holds.iter().position(|holds| !holds);
            rays_at_bounds += usize::from(left.is_none());
            brackets.push(left.map_or([self.lengths[ray]; 2], |left| [at(left), at(left + 1)]));
            let beyond: Vec<usize> = (left.unwrap_or(probes)..probes).filter(|&probe| holds[probe]).collect();
            let way = beyond.len() as f64 * at(1);
            reentry.rays += usize::from(!beyond.is_empty());
            reentry.size += beyond.iter().map(|&probe| self.part([at(probe), at(probe + 1)])).sum::<f64>();
            if way > longest {
                (longest, reentry.direction) = (way, self.directions[ray]);
            }
        }
        let [judged, feasible] = self.bisect(&mut brackets, settings.tolerance);
        Exits {
            radii: brackets.iter().map(|bracket| bracket[0]).collect(),
            rays_at_bounds,
            points: judged + holds.len() as u64,
            feasible_points: feasible + holds.iter().filter(|holds| **holds).count() as u64,
            reentry,
        }
    }

    /// A ray's fraction of the ring or shell between two radii (m², m³).
    fn part(&self, [from, to]: [f64; 2]) -> f64 {
        let whole = match self.region.dimension() {
            2 => std::f64::consts::PI * (to * to - from * from),
            _ => 4.0 / 3.0 * std::f64::consts::PI * (to * to * to - from * from * from),
        };
        whole / self.directions.len() as f64
    }

    fn point(&self, ray: usize, radius: f64) -> Point {
        [0, 1, 2].map(|axis| self.center[axis] + radius * self.directions[ray][axis])
    }

    /// True for each probe that lies in the region, the outermost at the end of its ray.
    fn probe(&self, probes: usize) -> Vec<bool> {
        let mut points = Vec::with_capacity(self.lengths.len() * probes);
        for (ray, length) in self.lengths.iter().enumerate() {
            points.extend((1..=probes).map(|probe| self.point(ray, length * probe as f64 / probes as f64)));
        }
        let mut holds = vec![false; points.len()];
        self.region.holds_all(&points, &mut holds);
        holds
    }

    /// Halves all brackets that are longer than the tolerance; returns the counts of points judged and of those that
    /// hold.
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
