//! Arguments of a workspace.

use std::path::PathBuf;

use cdpr_workspace::criterion::registry;
use clap::{Args, ValueEnum};

use super::orientations::OrientationArguments;
use crate::inputs::ModelArguments;
use crate::numbers::{NumberList, finite_number, number_from_zero};

const EXAMPLES: &str = "\
Examples:
  cdpr workspace planar-example
  cdpr workspace planar-example --method hull --rays 36
  cdpr workspace cablerobot-simulator-icosahedron --wrench 0,0,-4905,0,0,0 --min 1000 --max 9000 --method hull --mesh hull.glb
  cdpr workspace cablerobot-simulator-helicopter --method hull --page workspace.html
  cdpr workspace cogiro --criterion wrench-feasible --method octree --step 0.1
  cdpr workspace ipanema-1 --archetype total-orientation --angles -0.2,0.2,3,-0.2,0.2,3,0,0,1";

const ABOUT: &str = "Where the platform can be: area or volume of the poses at which criteria hold";

const LONG_ABOUT: &str = "\
Where the platform can be: area or volume of the poses at which criteria hold.\n\n\
`grid` judges the middle of every cell of a box; `octree` refines only the cells that the boundary passes; `hull` follows \
rays from a center to the boundary and gives a surface (`--mesh`). What each finds is compared with the workspace at points \
drawn at random, which gives a bound of its error; it is refined until the bound is below 1 %, unless --step or --rays is \
given. The answer is negative (exit code 1) when the criteria hold nowhere, and when a hull would be wrong because rays enter \
the workspace again or parts of it lie outside.";

#[derive(Debug, Args)]
#[command(about = ABOUT, long_about = LONG_ABOUT, after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    pub(super) model: ModelArguments,

    /// External wrench fx,fy | fx,fy,m | fx,fy,fz | fx,fy,fz,mx,my,mz (N, N·m; world axes, moment about the platform
    /// origin), instead of the robot's external wrench and weight.
    #[arg(long, value_name = "WRENCH", allow_hyphen_values = true)]
    pub(super) wrench: Option<NumberList>,

    /// Least tension of every cable (N), instead of the robot's.
    #[arg(long, value_name = "N", value_parser = number_from_zero, allow_hyphen_values = true)]
    pub(super) min: Option<f64>,

    /// Largest tension of every cable (N), instead of the robot's.
    #[arg(long, value_name = "N", value_parser = finite_number, allow_hyphen_values = true)]
    pub(super) max: Option<f64>,

    #[arg(long, value_name = "CRITERION", default_value = "wrench-feasible")]
    #[arg(help = criteria_help(false), long_help = criteria_help(true))]
    pub(super) criterion: Vec<String>,

    /// How the workspace is found.
    #[arg(long, value_enum, default_value_t = Method::Grid, value_name = "grid|octree|hull")]
    #[arg(hide_possible_values = true)]
    pub(super) method: Method,

    #[command(flatten)]
    pub(super) orientations: OrientationArguments,

    /// Box to look in, ends along each translation x0,x1,y0,y1(,z0,z1) (m); when left out that of the frame anchors, the home
    /// position and the [workspace] of the robot's file, wider where a coarse grid finds more, but not below a floor at height 0.
    #[arg(long, value_name = "BOUNDS", allow_hyphen_values = true)]
    pub(super) bounds: Option<NumberList>,

    /// Largest side of a cell of grid or octree (m). When left out a hundredth of the longest side of the box in a plane, a
    /// fiftieth in space, halved until the bound of the error is below 1 % or about a second of work is done.
    #[arg(long, value_name = "STEP", value_parser = finite_number, allow_hyphen_values = true)]
    pub(super) step: Option<f64>,

    /// Rays of a hull, at least. When left out 360 in a plane; in space 2562, the corners of an icosahedron refined four times;
    /// more until the bound of the error is below 1 % or about a second of work is done.
    #[arg(long, value_name = "N")]
    pub(super) rays: Option<usize>,

    /// Rays are bisected until the boundary is known to this (m); a millionth of the box when left out.
    #[arg(long, value_name = "M", value_parser = finite_number, allow_hyphen_values = true)]
    pub(super) tolerance: Option<f64>,

    /// Pose from which the rays of a hull start, components as in `cdpr ik --pose`; its orientation counts unless --rotation
    /// is given. When left out the home pose, or the middle of what a coarse grid finds.
    #[arg(long, value_name = "POSE", allow_hyphen_values = true)]
    pub(super) center: Option<NumberList>,

    /// Write the boundary as a closed surface (of a planar robot the area): .stl, .glb, .ply, .vtk, or .csv for its vertices,
    /// with margin and limiting cable.
    #[arg(long, value_name = "FILE")]
    pub(super) mesh: Option<PathBuf>,

    /// Write a page in which the platform can be dragged: tensions, limits and reasons, and what was found; one HTML file that
    /// needs no network.
    #[arg(long, value_name = "FILE")]
    pub(super) page: Option<PathBuf>,

    /// Lay the results of this earlier page over the new one; repeated, those of several.
    #[arg(long, value_name = "FILE")]
    pub(super) overlay: Vec<PathBuf>,

    /// Keep the state of a long count in this file and go on from it when the same command runs again.
    #[arg(long, value_name = "FILE")]
    pub(super) resume: Option<PathBuf>,
}

/// Ways to find a workspace.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Method {
    /// Every cell of a box.
    Grid,
    /// Cells refined at the boundary.
    Octree,
    /// Rays from a centre.
    Hull,
}

/// Criteria to ask for: names in the short help, their numbers too in the long one.
fn criteria_help(is_long: bool) -> String {
    let criteria = registry::ENTRIES.iter().map(|entry| {
        let numbers: Vec<&str> = entry.numbers.iter().map(|number| number.name).collect();
        let numbers = if is_long && !numbers.is_empty() { format!(":{}", numbers.join(",")) } else { String::new() };
        format!("{}{numbers}", entry.name)
    });
    let criteria: Vec<String> = criteria.collect();
    let intent = "What has to hold at a pose, NAME or NAME:NUMBER=VALUE,…; repeated, all of them.";
    let more = "The chapter \"Criteria\" of the book says what each asks.";
    match is_long {
        true => format!("{intent} Names, with the numbers that they take: {}. {more}", criteria.join("; ")),
        false => format!("{intent} {}", criteria.join(", ")),
    }
}
