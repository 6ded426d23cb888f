//! The document of a robot file while its sections are read.

use nalgebra::Vector3;

use super::file::RobotFile;
use crate::geometry::{MotionPattern, Plane};
use crate::reading::{ReadError, Step, TomlDocument};

/// The document with the motion pattern and plane on which every vector depends.
pub(super) struct Reader<'a> {
    pub(super) document: &'a TomlDocument<'a>,
    pub(super) pattern: MotionPattern,
    pub(super) plane: Plane,
}

impl<'a> Reader<'a> {
    pub(super) fn new(document: &'a TomlDocument<'a>, file: &RobotFile) -> Result<Self, ReadError> {
        let pattern = file.motion_pattern;
        let error = |path: &[Step<'_>], message: String, help: &str| {
            Err(document.error_at(path, "robot::axes", message).with_help(help))
        };
        let plane = match (pattern.is_planar(), file.axes.as_deref()) {
            (true, Some(axes)) => Plane::from_axes(axes),
            (true, None) => {
                let message = format!("motion pattern {} needs the key `axes`", pattern.name());
                return error(
                    &[Step::Key("motion_pattern")],
                    message,
                    "add e.g. `axes = \"xz\"`: first axis x, second z",
                );
            }
            (false, Some(_)) => {
                let message = format!("`axes` belongs to planar robots, not to motion pattern {}", pattern.name());
                return error(&[Step::Key("axes")], message, "leave `axes` out, or use motion_pattern 2T or 1R2T");
            }
            (false, None) => Some(Plane::default()),
        };
        match plane {
            Some(plane) => Ok(Self { document, pattern, plane }),
            None => {
                let message = format!("`{}` does not name a plane", file.axes.as_deref().unwrap_or_default());
                error(&[Step::Key("axes")], message, "two different letters out of x, y, z, e.g. \"xy\" or \"xz\"")
            }
        }
    }

    /// A vector of the file: two components in the plane for planar robots, otherwise three.
    pub(super) fn vector(&self, path: &[Step<'_>], values: &[f64]) -> Result<Vector3<f64>, ReadError> {
        match (self.pattern.is_planar(), values) {
            (true, &[first, second]) => Ok(self.plane.embed([first, second])),
            (false, &[x, y, z]) => Ok(Vector3::new(x, y, z)),
            _ => {
                let (expected, pattern) = (self.pattern.translations(), self.pattern.name());
                let message =
                    format!("{expected} components expected (motion pattern {pattern}), found {}", values.len());
                let help = match self.pattern.is_planar() {
                    _ if values.len() == 2 * expected => {
                        "are these decimal commas? numbers are written with a decimal point".to_owned()
                    }
                    true => format!("vectors of planar robots have the components {}", self.plane.axes()),
                    false => "vectors of spatial robots have the components x, y, z".to_owned(),
                };
                Err(self.document.error_at(path, "robot::component-count", message).with_help(help))
            }
        }
    }

    /// Refuses a number below zero.
    pub(super) fn not_negative(&self, path: &[Step<'_>], number: Option<f64>) -> Result<Option<f64>, ReadError> {
        match number {
            Some(below) if below < 0.0 => {
                let message = format!("{} is {below}; it cannot be negative", key_name(path));
                Err(self.document.error_at(path, "robot::negative", message).with_help("leave the key out if unknown"))
            }
            fine => Ok(fine),
        }
    }
}

/// The last key of a path.
pub(super) fn key_name<'s>(path: &[Step<'s>]) -> &'s str {
    match path.last() {
        Some(Step::Key(name)) => name,
        _ => "the number",
    }
}

/// Three rows of three numbers.
pub(super) fn square(rows: &[Vec<f64>]) -> Option<[[f64; 3]; 3]> {
    let rows: Vec<[f64; 3]> = rows.iter().map(|row| row.as_slice().try_into().ok()).collect::<Option<_>>()?;
    rows.try_into().ok()
}
