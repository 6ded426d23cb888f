//! Workspaces by grid, octree and hull, in sets of orientations, and their first-order motion.
//!
//! `cargo run -p examples --bin workspace_figures [FOLDER]` prints the sizes of the book's chapter “Workspaces”; with a folder it
//! also draws the chapter's figures there.

#![expect(clippy::print_stdout, reason = "the sizes are what it is for")]

use std::error::Error;
use std::path::Path;

use cdpr::geometry::Wrench;
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::UnitQuaternion;
use cdpr::robot::Robot;
use cdpr::statics::Load;
use cdpr::tension::Limits;
use cdpr::workspace::criterion::WrenchFeasible;
use cdpr::workspace::differential::{Differences, motion};
use cdpr::workspace::hull::{self, Hull};
use cdpr::workspace::{Archetype, Bounds, Region, WorkspaceError, octree};
use examples::drawing::{Grid, Panel, Picture};

/// Dark, orange and blue: apart in grey too, by their dashes.
const STYLES: [&str; 4] = [
    r##"stroke="#1b1f24" stroke-width="2""##,
    r##"stroke="#bc4c00" stroke-width="2" stroke-dasharray="7 3""##,
    r##"stroke="#0969da" stroke-width="2" stroke-dasharray="2 3""##,
    r##"stroke="#8250df" stroke-width="2" stroke-dasharray="10 3 2 3""##,
];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1);
    let figures = [("methods", methods()?), ("archetypes", archetypes()?), ("motion", moving()?)];
    if let Some(folder) = folder {
        for (name, figure) in figures {
            std::fs::write(Path::new(&folder).join(format!("workspace-{name}.svg")), figure)?;
        }
    }
    Ok(())
}

fn standard(name: &str) -> Result<Model, Box<dyn Error>> {
    Ok(Model::new(Robot::builtin(name).ok_or("not built in")?, Composition::STANDARD)?)
}

fn upright() -> Archetype {
    Archetype::ConstantOrientation(UnitQuaternion::identity())
}

/// The planar example with a force downwards (N).
fn pulled(model: &Model, force: f64) -> Result<WrenchFeasible<'_>, Box<dyn Error>> {
    let load = Load::constant(Wrench::new(0.0, -force, 0.0, 0.0, 0.0, 0.0));
    Ok(WrenchFeasible::new(model, &load, &Limits::uniform(4, 1000.0, 8000.0)?)?)
}

fn hull_of(region: &Region<'_>, bounds: &Bounds, center: [f64; 2], rays: usize) -> Result<Hull, WorkspaceError> {
    let settings = hull::Settings { rays, ..hull::Settings::new(bounds) };
    hull::solve(region, bounds, &[center[0], center[1], 0.0], &settings)
}

/// The outline as a closed line.
fn outline(hull: &Hull) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = hull.vertices().iter().map(|point| (point[0], point[1])).collect();
    points.extend(points.first().copied());
    points
}

fn panel(left: f64, width: f64, x: (f64, f64), y: (f64, f64)) -> Panel {
    let height = width * (y.1 - y.0) / (x.1 - x.0);
    Panel { corner: (left, 30.0), size: (width, height), x, y, is_logarithmic: false }
}

/// Lines of the legend below a panel.
fn legend(picture: &mut Picture, panel: &Panel, names: &[String]) {
    let (left, top) = (panel.corner.0, panel.corner.1 + panel.size.1 + 56.0);
    for (index, (name, style)) in names.iter().zip(STYLES).enumerate() {
        let y = top + 18.0 * index as f64;
        let row =
            Panel { corner: (left, y - 8.0), size: (30.0, 8.0), x: (0.0, 1.0), y: (0.0, 1.0), is_logarithmic: false };
        picture.curve(&row, style, &[(0.0, 0.5), (1.0, 0.5)]);
        picture.text("start", (left + 38.0, y), name);
    }
}

/// Margins on a grid with the outline, and polygons of 36 and 360 rays.
fn methods() -> Result<String, Box<dyn Error>> {
    let model = standard("planar-example")?;
    let criterion = pulled(&model, 1962.0)?;
    let region = Region::new(&model, &criterion, &upright())?;
    let bounds = Bounds::new(2, &[-6.5, 6.0, -1.5, 9.0])?;
    let [coarse, fine] = [36, 360].map(|rays| hull_of(&region, &bounds, [0.0, 5.2], rays));
    let (coarse, fine) = (coarse?, fine?);
    let tree = octree::solve(&region, &bounds, &octree::Settings::new(0.02))?;
    let area = |hull: &Hull| hull.measure().map_or(f64::NAN, |measure| measure.size);
    println!("octree {:.2} m², 36 rays {:.2} m², 360 rays {:.2} m²", tree.size, area(&coarse), area(&fine));
    assert!((area(&fine) - tree.size).abs() < tree.error_bound);

    let mut picture = Picture::new(760.0, 420.0, "Wrench feasibility of the planar example: margins and outlines");
    let along =
        |from: f64, to: f64| -> Vec<f64> { (0..=60).map(|k| from + (to - from) * f64::from(k) / 60.0).collect() };
    let (x, y) = (along(-6.5, 6.0), along(-1.5, 9.0));
    let margin = |x: f64, y: f64| 1e-3 * region.judge(&[x, y, 0.0]).margin;
    let values = y.iter().flat_map(|y| x.iter().map(move |x| margin(*x, *y))).collect();
    let left = panel(58.0, 270.0, (-6.5, 6.0), (-1.5, 9.0));
    picture.text("start", (58.0, 18.0), "margin at the points of a grid, kN");
    picture.map(&left, &Grid { x, y, values }, &[0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0]);
    let right = panel(456.0, 270.0, (-6.5, 6.0), (-1.5, 9.0));
    picture.text("start", (456.0, 18.0), "outlines by rays from (0, 5.2)");
    let ticks: (&[f64], &[f64]) = (&[-6.0, -3.0, 0.0, 3.0, 6.0], &[0.0, 2.0, 4.0, 6.0, 8.0]);
    for panel in [&left, &right] {
        picture.axes(panel, ticks, ("x, m", "y, m"));
    }
    picture.curve(&left, STYLES[0], &outline(&fine));
    for (hull, style) in [(&fine, STYLES[0]), (&coarse, STYLES[1])] {
        picture.curve(&right, style, &outline(hull));
    }
    let names = [("360 rays", &fine), ("36 rays", &coarse)].map(|(name, hull)| format!("{name}: {:.2} m²", area(hull)));
    legend(&mut picture, &right, &names);
    Ok(picture.finish())
}

/// One orientation, every one of a set, and some one of it.
fn archetypes() -> Result<String, Box<dyn Error>> {
    let model = standard("cucablerobot-planar")?;
    let robot = model.robot();
    let criterion = WrenchFeasible::new(&model, &Load::of(robot)?, &Limits::of(robot, None, None)?)?;
    let bounds = Bounds::new(2, &[0.0, 2.3, 0.0, 2.1])?;
    let set = || (-5..=5).map(|k| UnitQuaternion::new(robot.plane.normal() * (0.02 * f64::from(k)))).collect();
    let archetypes = [upright(), Archetype::TotalOrientation(set()), Archetype::InclusionOrientation(set())];
    let mut picture = Picture::new(560.0, 560.0, "Archetypes of the workspace of a planar robot that turns");
    let only = panel(58.0, 440.0, (0.0, 2.3), (0.0, 2.1));
    picture.axes(&only, (&[0.0, 0.5, 1.0, 1.5, 2.0], &[0.0, 0.5, 1.0, 1.5, 2.0]), ("x, m", "z, m"));
    let mut names = Vec::new();
    for (archetype, style) in archetypes.iter().zip(STYLES) {
        let region = Region::new(&model, &criterion, archetype)?;
        let found = hull_of(&region, &bounds, [1.14, 1.0], 360)?;
        let area = octree::solve(&region, &bounds, &octree::Settings::new(0.01))?.size;
        println!("{}: {area:.3} m², {:?}", archetype.name(), found.status);
        picture.curve(&only, style, &outline(&found));
        names.push(format!("{}: {area:.2} m²", archetype.name()));
    }
    legend(&mut picture, &only, &names);
    Ok(picture.finish())
}

/// The outline with a tenth of the load more, to first order and searched anew.
fn moving() -> Result<String, Box<dyn Error>> {
    let model = standard("planar-example")?;
    let bounds = Bounds::new(2, &[-6.5, 6.0, -1.5, 9.0])?;
    let criteria = [1962.0, 1961.0, 1963.0, 2158.2].map(|force| pulled(&model, force));
    let [here, below, above, there] = criteria;
    let (here, below, above, there) = (here?, below?, above?, there?);
    let region = Region::new(&model, &here, &upright())?;
    let [below, above, there] = [&below, &above, &there].map(|criterion| region.with_criterion(criterion));
    let now = hull_of(&region, &bounds, [0.0, 5.2], 360)?;
    let moves = motion(&now, &region, [&below, &above], Differences { parameter: 1.0, radius: 1e-4 });
    let predicted = moves.moved(&now, 196.2);
    let anew = hull_of(&there, &bounds, [0.0, 5.2], 360)?;
    let area = |hull: &Hull| hull.measure().map_or(f64::NAN, |measure| measure.size);
    println!("moved {:.2} m², anew {:.2} m²", area(&predicted), area(&anew));
    let mut picture = Picture::new(560.0, 500.0, "First-order motion of a workspace against recomputation");
    let only = panel(58.0, 440.0, (-6.5, 6.0), (-1.5, 9.0));
    picture.axes(&only, (&[-6.0, -3.0, 0.0, 3.0, 6.0], &[0.0, 2.0, 4.0, 6.0, 8.0]), ("x, m", "y, m"));
    let names = [(&now, "200 kg"), (&predicted, "220 kg, to first order"), (&anew, "220 kg, searched anew")];
    for ((hull, _), style) in names.iter().zip(STYLES) {
        picture.curve(&only, style, &outline(hull));
    }
    let names = names.map(|(hull, name)| format!("{name}: {:.2} m²", area(hull)));
    legend(&mut picture, &only, &names);
    Ok(picture.finish())
}
