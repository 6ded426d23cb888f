//! The data that the program of the page draws from: one JSON block. `viewer/src/workspace/data.ts` is its reader.
//!
//! SI units, named in the keys. No physics is left to the program.

use cdpr_workspace::mesh::{Field, Mesh};
use serde::{Deserialize, Serialize};

use super::grid::Grid;
use super::sentences::Sentences;
use super::{Finding, Shape, WorkspacePage};
use crate::html_page::{CableData, Nodes, digits, inside_script, plain, vector};

/// The whole block.
#[derive(Serialize)]
struct PageData {
    /// Kind of page.
    page: &'static str,
    robot: RobotData,
    criterion: CriterionData,
    start: StartData,
    grid: GridData,
    regions: Vec<RegionData>,
}

#[derive(Serialize)]
struct RobotData {
    name: String,
    planar: bool,
    cables: Vec<CableData>,
}

#[derive(Serialize)]
struct CriterionData {
    name: String,
    /// Of the margin; empty where it has none.
    unit: String,
}

#[derive(Serialize)]
struct StartData {
    position_m: [f64; 3],
    quaternion_xyzw: [f64; 4],
}

#[derive(Serialize)]
struct AxisData {
    name: String,
    direction: [f64; 3],
    #[serde(flatten)]
    nodes: Nodes,
}

/// Lists have an entry per node, the first axis running fastest.
#[derive(Serialize)]
struct GridData {
    axes: Vec<AxisData>,
    base_m: [f64; 3],
    /// Null for −∞.
    margin: Vec<Option<f64>>,
    /// From 0; −1 for none.
    cable: Vec<i64>,
    /// Index among the sentences; −1 where the criterion holds.
    reason: Vec<i64>,
    sentences: Vec<String>,
    numbers: Vec<String>,
    #[serde(rename = "tensions_N")]
    tensions: Vec<Option<Vec<f64>>>,
    interpolation: Option<InterpolationData>,
}

#[derive(Serialize)]
struct InterpolationData {
    cells: usize,
    #[serde(rename = "mean_N")]
    mean: f64,
    #[serde(rename = "largest_N")]
    largest: f64,
}

/// A result; also what is read from an earlier page.
#[derive(Deserialize, Serialize)]
pub(super) struct RegionData {
    name: String,
    measure: f64,
    error_bound: Option<f64>,
    unit: String,
    /// How a surface was found.
    #[serde(default = "hull")]
    method: String,
    vertices_m: Vec<f64>,
    triangles: Vec<u32>,
    /// At the vertices of a surface, in `margin_unit`; empty where it is not known, as in pages of earlier versions.
    #[serde(default)]
    margin: Vec<f64>,
    #[serde(default)]
    margin_unit: String,
    /// At the vertices of a surface: its number from 1, or 0 for none.
    #[serde(default)]
    limiting_cable: Vec<u32>,
    outlines_m: Vec<Vec<[f64; 2]>>,
}

/// Method of pages of earlier versions, which did not say it: most of them held hulls.
fn hull() -> String {
    "hull".to_owned()
}

const MARGIN: &str = "margin";
const LIMITING_CABLE: &str = "limiting cable";

/// The block as text that may stand inside a `script` element.
pub(super) fn json(page: &WorkspacePage<'_>, grid: &Grid) -> String {
    let robot = page.model.robot();
    let is_planar = robot.motion_pattern.is_planar();
    let [x, y, z, w]: [f64; 4] = page.start.rotation.coords.into();
    let unit = page.unit;
    let data = PageData {
        page: "workspace",
        robot: RobotData { name: plain(&robot.name), planar: is_planar, cables: cables(page) },
        criterion: CriterionData {
            name: plain(page.criterion),
            unit: if unit == "1" { String::new() } else { plain(unit) },
        },
        start: StartData {
            position_m: vector(&page.start.position, 7),
            quaternion_xyzw: [x, y, z, w].map(|value| digits(value, 9)),
        },
        grid: grid_data(grid),
        regions: page.findings.iter().map(|finding| RegionData::new(finding, is_planar)).collect(),
    };
    let text = serde_json::to_string(&data).expect("strings and numbers only");
    inside_script(&text)
}

fn cables(page: &WorkspacePage<'_>) -> Vec<CableData> {
    let limits = page.statics.map(|(_, limits)| limits);
    let limits = |cable: usize| limits.map(|limits| (limits.minimum()[cable], limits.maximum()[cable]));
    page.model.robot().cables.iter().enumerate().map(|(index, cable)| CableData::of(cable, limits(index))).collect()
}

fn grid_data(grid: &Grid) -> GridData {
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
        axes: grid.axes.iter().map(axis_data).collect(),
        base_m: vector(&grid.base, 7),
        margin: grid.nodes.iter().map(|node| margin(node.verdict.margin)).collect(),
        cable: grid.nodes.iter().map(|node| node.verdict.cable.map_or(-1, |cable| cable as i64)).collect(),
        reason,
        sentences: sentences.list,
        numbers,
        tensions: grid.nodes.iter().map(|node| node.tensions.as_ref().map(rounded)).collect(),
        interpolation: grid.interpolation.map(|found| InterpolationData {
            cells: found.cells,
            mean: digits(found.mean, 3),
            largest: digits(found.largest, 3),
        }),
    }
}

fn axis_data(axis: &super::grid::Axis) -> AxisData {
    AxisData { name: axis.name.clone(), direction: axis.direction.into(), nodes: axis.nodes }
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
