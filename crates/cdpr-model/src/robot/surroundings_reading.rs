//! Obstacles and the platform's body: read from a robot file and written to it.

use nalgebra::Vector3;

use super::file::{ObstacleSection, RobotFile};
use super::reader::Reader;
use super::{Obstacle, ObstacleShape, Robot};
use crate::reading::{ReadError, Step};

/// Largest number of corners of a platform's body, and of obstacles: criteria check every pair.
const LIMIT: usize = 256;

/// The obstacles of a file.
pub(super) fn read_obstacles(reader: &Reader<'_>, file: &RobotFile) -> Result<Vec<Obstacle>, ReadError> {
    let sections = &file.obstacle;
    if sections.len() > LIMIT {
        let message = format!("{} obstacles; at most {LIMIT} are read", sections.len());
        return Err(reader.document.error_at(&[Step::Key("obstacle")], "robot::obstacle", message));
    }
    sections.iter().enumerate().map(|(index, section)| obstacle(reader, index, section)).collect()
}

fn obstacle(reader: &Reader<'_>, index: usize, section: &ObstacleSection) -> Result<Obstacle, ReadError> {
    let path = |key| [Step::Key("obstacle"), Step::Index(index), Step::Key(key)];
    let point = |key, values: &[f64]| reader.vector(&path(key), values);
    let refuse = |key, message: &str| {
        let message = format!("obstacle {} (`{}`): {message}", index + 1, section.name);
        Err(reader
            .document
            .error_at(&path(key), "robot::obstacle", message)
            .with_help("a box has position_min_m and position_max_m, a strut has from_m, to_m and radius_m"))
    };
    let shape = match section {
        ObstacleSection {
            position_min_m: Some(min),
            position_max_m: Some(max),
            from_m: None,
            to_m: None,
            radius_m: None,
            ..
        } => {
            let (min, max) = (point("position_min_m", min)?, point("position_max_m", max)?);
            if min.iter().zip(max.iter()).any(|(min, max)| min > max) {
                return refuse("position_min_m", "a component of position_min_m is above that of position_max_m");
            }
            ObstacleShape::Box { min, max }
        }
        ObstacleSection {
            position_min_m: None,
            position_max_m: None,
            from_m: Some(from),
            to_m: Some(to),
            radius_m: Some(_),
            ..
        } => {
            let radius = reader.not_negative(&path("radius_m"), section.radius_m)?.unwrap_or_default();
            ObstacleShape::Strut { from: point("from_m", from)?, to: point("to_m", to)?, radius }
        }
        _ => return refuse("name", "it is neither a whole box nor a whole strut"),
    };
    Ok(Obstacle { name: section.name.clone(), shape })
}

/// The corners of the platform's body; they must span a volume, or an area in a plane.
pub(super) fn read_hull(reader: &Reader<'_>, points: &[Vec<f64>]) -> Result<Vec<Vector3<f64>>, ReadError> {
    let path = [Step::Key("platform"), Step::Key("hull_m")];
    let least = reader.pattern.translations() + 1;
    if points.len() < least || points.len() > LIMIT {
        let message = format!("hull_m has {} points; a body has {least} to {LIMIT} corners", points.len());
        return Err(reader.document.error_at(&path, "robot::hull", message));
    }
    points
        .iter()
        .enumerate()
        .map(|(index, point)| reader.vector(&[path[0], path[1], Step::Index(index)], point))
        .collect()
}

impl Robot {
    pub(super) fn obstacle_section(&self, obstacle: &Obstacle) -> ObstacleSection {
        let point = |point: &Vector3<f64>| Some(self.components(point));
        let nothing = ObstacleSection {
            name: obstacle.name.clone(),
            position_min_m: None,
            position_max_m: None,
            from_m: None,
            to_m: None,
            radius_m: None,
        };
        match &obstacle.shape {
            ObstacleShape::Box { min, max } => {
                ObstacleSection { position_min_m: point(min), position_max_m: point(max), ..nothing }
            }
            ObstacleShape::Strut { from, to, radius } => {
                ObstacleSection { from_m: point(from), to_m: point(to), radius_m: Some(*radius), ..nothing }
            }
        }
    }
}
