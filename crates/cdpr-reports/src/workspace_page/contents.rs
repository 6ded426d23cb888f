//! Contents of a page: the robot, its criterion and the workspaces that were found.

use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_workspace::Verdict;
use cdpr_workspace::mesh::Mesh;

use crate::answers::WorkspaceAnswer;
use crate::number_format::significant;

/// Contents of a page.
pub struct WorkspacePage<'a> {
    /// Robot and effects.
    pub model: &'a Model,
    /// Answer that the page shows.
    pub answer: &'a WorkspaceAnswer,
    /// Name of what has to hold at a pose.
    pub criterion: &'a str,
    /// Unit of its margin; `1` for none.
    pub unit: &'a str,
    /// The full answer at a pose; of a set of orientations whatever the set says of the position.
    pub judge: &'a (dyn Fn(&Pose) -> Verdict + Sync),
    /// Load and limits of the tensions that are shown; `None` shows none.
    pub statics: Option<(&'a Load, &'a Limits)>,
    /// Pose of the platform when the page is opened, and how it is turned at every pose of the grid.
    pub start: &'a Pose,
    /// Box of the grid, least and largest coordinate (m): along x, y and z, or along the two axes of a planar robot.
    pub bounds: &'a [[f64; 2]],
    /// Results: the one that the command found first, if it found one, then those to compare it with.
    pub findings: &'a [Finding],
    /// True where the first result is the command's own: its size is the headline.
    pub is_found: bool,
    /// Facts that the results depend on, as pairs of words.
    pub facts: &'a [(&'a str, String)],
    /// Warnings; text between backticks is shown as code.
    pub warnings: &'a [String],
    /// The command that makes the same page again.
    pub command: &'a str,
    /// Version of the program.
    pub version: &'a str,
}

/// A workspace that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Name that tells it from others: criterion and limits, say.
    pub name: String,
    /// Its volume (m³) or area (m²).
    pub measure: f64,
    /// The measure is known to ± this (m³, m²).
    pub error_bound: Option<f64>,
    /// Its form.
    pub shape: Shape,
}

/// The form of a finding.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The surface of a volume, with margin and limiting cable at its vertices where they are known.
    Surface {
        /// The surface.
        mesh: Mesh,
        /// The method that found it: a hull, or the cells of a grid or an octree.
        method: String,
    },
    /// Closed lines in the coordinates of the plane's axes (m); a point belongs to the area when an odd number encloses it.
    Areas(Vec<Vec<[f64; 2]>>),
    /// Only the measure is known: from a grid, say.
    Unknown,
}

impl Finding {
    pub(super) fn unit(&self, is_planar: bool) -> &'static str {
        match (&self.shape, is_planar) {
            (Shape::Areas(_), _) | (Shape::Unknown, true) => "m²",
            _ => "m³",
        }
    }

    /// E.g. "243.1 ± 0.8 m³".
    pub(super) fn words(&self, is_planar: bool) -> String {
        let bound = self.error_bound.map(|bound| format!(" ± {}", significant(bound, 2))).unwrap_or_default();
        format!("{}{bound} {}", significant(self.measure, 4), self.unit(is_planar))
    }
}
