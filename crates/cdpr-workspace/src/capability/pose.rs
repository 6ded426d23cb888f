//! Values at one pose, and bounds around it.

use nalgebra::Vector3;

use super::bound::Cell;
use super::demand::Demand;
use super::face::{Course, Face, Judged, Place, Rows};
use super::limit::{Limit, LimitedBy, NotHeld};
use super::question::Capability;
use super::turning::Turning;
use crate::Point;
use crate::wrench_set::{FacetView, Zonotope};

impl Capability<'_> {
    /// Value of each quantity at a point (see [`Capability::quantities`]); `None` if the robot does not hold its own
    /// load there.
    pub fn values(&self, point: &Point) -> Option<Vec<f64>> {
        self.judge(&Place::pose(*point)).ok().map(|judged| judged.values)
    }

    /// Judges a cell; one without extent is a pose. An error if the robot does not hold its own load at the centre.
    pub(super) fn judge(&self, place: &Place) -> Result<Judged, Box<NotHeld>> {
        let Place { center, half, bounded } = place;
        let courses = self.courses(center)?;
        let faces = self.faces(center)?;
        let worst = faces.iter().min_by(|a, b| a.room.total_cmp(&b.room));
        if let Some(face) = worst.filter(|face| face.room < 0.0) {
            let limited_by = self.limit_of(face, center, None);
            return Err(Box::new(NotHeld { at: *center, lacking: -face.room, limited_by, reason: None }));
        }
        let reach = half.iter().map(|side| side * side).sum::<f64>().sqrt();
        let position = self.position(center);
        let turnings: Vec<Turning> = courses
            .iter()
            .enumerate()
            .map(|(cable, Course { path, arm })| Turning::of(self.model.outlet(cable), path, &(position + arm), reach))
            .collect();
        let load = self.scaled(&self.load.wrench(&self.pose(center)));
        let cell = Cell { courses: &courses, turnings: &turnings, half, faces: &faces, load };
        let one = |(index, demand): (usize, &Demand)| {
            if matches!(demand, Demand::Speed) {
                return [self.speed(&courses, 0.0).0, self.speed(&courses, reach).0];
            }
            let value = faces.iter().map(|face| face.allows(demand)).fold(f64::INFINITY, f64::min);
            let bound = match bounded & (1 << index) {
                _ if reach == 0.0 => value,
                0 => f64::NEG_INFINITY,
                _ => self.bound(demand, value, &cell),
            };
            [value, bound]
        };
        let (values, at_least) = self.demands.iter().enumerate().map(one).map(|[value, bound]| (value, bound)).unzip();
        Ok(Judged { values, at_least })
    }

    /// Limit of the quantity with this index at a point; `None` if the load is not held there.
    pub(super) fn limited_by(&self, index: usize, point: &Point) -> Option<LimitedBy> {
        let demand = self.demands.get(index)?;
        if matches!(demand, Demand::Speed) {
            let courses = self.courses(point).ok()?;
            let (_, cable) = self.speed(&courses, 0.0);
            let cable = cable?;
            let is_of_drive = self.speeds[cable].as_ref()?.is_of_drive(courses[cable].path.length);
            let limit = if is_of_drive { Limit::DriveSpeed } else { Limit::CableSpeed };
            return Some(LimitedBy::of_cable(limit, cable));
        }
        let faces = self.faces(point).ok()?;
        let face = faces.iter().min_by(|a, b| a.allows(demand).total_cmp(&b.allows(demand)))?;
        Some(self.limit_of(face, point, Some(demand)))
    }

    fn courses(&self, point: &Point) -> Result<Vec<Course>, Box<NotHeld>> {
        let pose = self.pose(point);
        let course = |cable| match self.model.path(cable, &pose) {
            Ok((path, arm)) => Ok(Course { path, arm }),
            Err(error) => Err(lost(point, cable, error.to_string())),
        };
        (0..self.model.cable_count()).map(course).collect()
    }

    /// Half-spaces of the available wrench set at a point.
    fn faces(&self, point: &Point) -> Result<Vec<Face>, Box<NotHeld>> {
        let pose = self.pose(point);
        let matrix =
            self.model.structure_matrix(&pose).map_err(|error| lost(point, error.cable() - 1, error.to_string()))?;
        let set = Zonotope::available(&matrix, &self.limits, &self.row_lengths);
        let set = set.map_err(|error| lost(point, 0, error.to_string()))?;
        let (load, tolerance) = (self.scaled(&self.load.wrench(&pose)), set.tolerance());
        let face = |facet: FacetView| {
            let scaled = Rows::from(facet.normal);
            let room = facet.offset - scaled.dot(&load);
            let FacetView { at_largest, at_least, .. } = facet;
            let room = if room.abs() <= tolerance { 0.0 } else { room };
            Face { normal: self.normal(&scaled), scaled, room, at_largest, at_least }
        };
        Ok(set.facets().map(face).collect())
    }

    /// Largest speed with cables up to `longer` (m) longer than their paths, and the cable that limits it.
    fn speed(&self, courses: &[Course], longer: f64) -> (f64, Option<usize>) {
        let mut least = (f64::INFINITY, None);
        for (cable, (course, limit)) in courses.iter().zip(&self.speeds).enumerate() {
            let Some(limit) = limit else { continue };
            // a length changes by no more than the platform moves
            let direction = Vector3::from(course.path.direction);
            let row = self.model.axes().iter().map(|axis| axis.dot(&direction).powi(2)).sum::<f64>().sqrt();
            let row = if longer > 0.0 { 1.0 } else { row };
            let speed = limit.at(course.path.length + longer) / row;
            if speed < least.0 {
                least = (speed, Some(cable));
            }
        }
        least
    }
}

/// A pose at which a cable has no path.
fn lost(point: &Point, cable: usize, reason: String) -> Box<NotHeld> {
    let limited_by = LimitedBy::of_cable(Limit::NoPath, cable);
    Box::new(NotHeld { at: *point, lacking: f64::INFINITY, limited_by, reason: Some(reason) })
}
