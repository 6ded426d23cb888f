//! The data that the program of the page draws from: one JSON block, which `viewer/src/data.ts` describes.
//!
//! No physics is left to the program.

use cdpr_model::tension::Limits;
use cdpr_workspace::mesh::{Field, Mesh};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::grid::{Axis, Grid, InterpolationError};
use super::sentences::Sentences;
use super::{Finding, Shape, WorkspacePage};
use crate::answers::WorkspaceAnswer;
use crate::html_page::{PageKind, PosePicture, RobotPicture, data_block, digits, plain, vector};

/// Data of a workspace: the answer, and what its pictures need besides.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "WorkspaceData")]
pub(crate) struct PageData<'a> {
    /// Kind of the page.
    #[schemars(extend("const" = "workspace"))]
    page: &'static str,
    result: &'a WorkspaceAnswer,
    /// Unit of the margin; empty where it has none.
    margin_unit: String,
    robot: RobotPicture,
    /// Pose at which the platform starts; its orientation is that of every pose of the grid.
    start: PosePicture,
    grid: GridData<'a>,
    regions: Vec<RegionData>,
}

/// Verdicts at the nodes of a grid. Lists have an entry per node, the first axis running fastest.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Grid")]
struct GridData<'a> {
    axes: &'a [Axis],
    /// Position that all nodes share across the axes: zero but for planar robots beside the origin.
    base_m: [f64; 3],
    /// Null for −∞: nothing could mend it.
    margin: Vec<Option<f64>>,
    /// The cable that limits, from 0; −1 for none.
    cable: Vec<i64>,
    /// Index of the reason among the sentences; −1 where the criterion holds.
    reason: Vec<i64>,
    /// Reasons with § for each number.
    sentences: Vec<String>,
    /// The numbers of every node's reason, joined by spaces.
    numbers: Vec<String>,
    /// Null where no tensions keep the limits.
    #[serde(rename = "tensions_N")]
    tensions: Vec<Option<Vec<f64>>>,
    /// Largest difference of interpolated from computed tensions in the middle of the cells.
    interpolation: Option<InterpolationError>,
}

/// Workspace that was found, on this page or an earlier one: a surface of triangles, or areas of a plane.
#[derive(Deserialize, Serialize, JsonSchema)]
#[schemars(rename = "WorkspaceRegion")]
pub(super) struct RegionData {
    name: String,
    /// Its size, in `unit`.
    measure: f64,
    error_bound: Option<f64>,
    unit: String,
    /// How a surface was found.
    #[serde(default = "hull")]
    method: String,
    /// World, three numbers each.
    vertices_m: Vec<f64>,
    /// Three vertices each.
    triangles: Vec<u32>,
    /// At the vertices of a surface, in `margin_unit`; empty where it is not known, as in pages of earlier versions.
    #[serde(default)]
    margin: Vec<f64>,
    #[serde(default)]
    margin_unit: String,
    /// At the vertices of a surface: its number from 1, or 0 for none.
    #[serde(default)]
    limiting_cable: Vec<u32>,
    /// Closed lines in the coordinates of the grid's two axes, of which an odd number encloses what belongs to the area.
    outlines_m: Vec<Vec<[f64; 2]>>,
}

/// Method of pages of earlier versions, which did not say it: most of them held hulls.
fn hull() -> String {
    "hull".to_owned()
}

const MARGIN: &str = "margin";
const LIMITING_CABLE: &str = "limiting cable";

/// The block.
pub(super) fn json(page: &WorkspacePage<'_>, grid: &Grid) -> String {
    let robot = page.model.robot();
    let pairs = |limits: &Limits| limits.minimum().iter().copied().zip(limits.maximum().iter().copied()).collect();
    let limits: Vec<(f64, f64)> = page.statics.map_or_else(Vec::new, |(_, limits)| pairs(limits));
    data_block(&PageData {
        page: PageKind::Workspace.name(),
        result: page.answer,
        margin_unit: if page.unit == "1" { String::new() } else { plain(page.unit) },
        robot: RobotPicture::of(robot, &limits),
        start: PosePicture::of(page.start),
        grid: grid_data(grid),
        regions: page
            .findings
            .iter()
            .map(|finding| RegionData::new(finding, robot.motion_pattern.is_planar()))
            .collect(),
    })
}

fn grid_data(grid: &Grid) -> GridData<'_> {
    let mut sentences = Sentences::default();
    let mut reasons = |reason: Option<&String>| match reason {
        Some(reason) => {
            let (index, numbers) = sentences.take(&plain(reason));
            (index as i64, numbers)
        }
        None => (-1, String::new()),
    };
    let (reason, numbers) = grid.nodes.iter().map(|node| reasons(node.verdict.reason.as_ref())).unzip();
    let rounded = |tensions: &Vec<f64>| tensions.iter().map(|tension| digits(*tension, 4)).collect();
    GridData {
        axes: &grid.axes,
        base_m: vector(&grid.base, 7),
        margin: grid.nodes.iter().map(|node| margin(node.verdict.margin)).collect(),
        cable: grid.nodes.iter().map(|node| node.verdict.cable.map_or(-1, |cable| cable as i64)).collect(),
        reason,
        sentences: sentences.list,
        numbers,
        tensions: grid.nodes.iter().map(|node| node.tensions.as_ref().map(rounded)).collect(),
        interpolation: grid.interpolation,
    }
}

/// Four digits; a margin that holds by less than they show still holds.
fn margin(value: f64) -> Option<f64> {
    value.is_finite().then(|| digits(value, 4))
}

impl RegionData {
    fn new(finding: &Finding, is_planar: bool) -> Self {
        let none = (Mesh::default(), "");
        let ((mesh, method), outlines) = match &finding.shape {
            Shape::Surface { mesh, method } => ((mesh.clone(), method.as_str()), Vec::new()),
            Shape::Areas(outlines) => (none, outlines.clone()),
            Shape::Unknown => (none, Vec::new()),
        };
        let field = |name: &str| mesh.fields.iter().find(|field| field.name == name).cloned().unwrap_or_default();
        let margin = field(MARGIN);
        let short = |point: [f64; 2]| point.map(|value| digits(value, 6));
        Self {
            name: plain(&finding.name),
            measure: digits(finding.measure, 6),
            error_bound: finding.error_bound.map(|bound| digits(bound, 3)),
            unit: finding.unit(is_planar).to_owned(),
            vertices_m: mesh.vertices.iter().flatten().map(|value| digits(*value, 6)).collect(),
            method: plain(method),
            margin: margin.values.iter().map(|value| digits(*value, 3)).collect(),
            margin_unit: plain(&margin.unit),
            limiting_cable: field(LIMITING_CABLE).values.iter().map(|number| *number as u32).collect(),
            triangles: mesh.triangles.concat(),
            outlines_m: outlines.into_iter().map(|outline| outline.into_iter().map(short).collect()).collect(),
        }
    }

    /// The finding again; `None` where the lists do not make triangles of vertices.
    pub(super) fn finding(self) -> Option<Finding> {
        let (vertices, [], triangles, []) = (
            self.vertices_m.as_chunks::<3>().0,
            self.vertices_m.as_chunks::<3>().1,
            self.triangles.as_chunks::<3>().0,
            self.triangles.as_chunks::<3>().1,
        ) else {
            return None;
        };
        let cables: Vec<f64> = self.limiting_cable.iter().map(|&number| f64::from(number)).collect();
        let all = [(MARGIN, self.margin_unit, self.margin), (LIMITING_CABLE, String::new(), cables)];
        let known = all.into_iter().filter(|(_, _, values)| !values.is_empty() && values.len() == vertices.len());
        let fields = known.map(|(name, unit, values)| Field { name: name.to_owned(), unit, values }).collect();
        let mesh = Mesh { vertices: vertices.to_vec(), triangles: triangles.to_vec(), fields };
        let is_sound = mesh.triangles.iter().flatten().all(|&corner| (corner as usize) < mesh.vertices.len());
        let shape = match (self.outlines_m.is_empty(), mesh.triangles.is_empty()) {
            (false, _) => Shape::Areas(self.outlines_m),
            (_, false) => Shape::Surface { mesh, method: self.method },
            _ => Shape::Unknown,
        };
        is_sound.then_some(Finding { name: self.name, measure: self.measure, error_bound: self.error_bound, shape })
    }
}
