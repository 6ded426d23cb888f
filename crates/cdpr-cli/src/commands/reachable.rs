//! `cdpr reachable`: which part of its workspace a robot really reaches under its control model.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_model::model::Model;
use cdpr_reports::reachable::{Change, Picture, ReachableAnswer, Searched, differential};
use cdpr_study::reachable::{ByCensus, Image, Reachable, image_of};
use cdpr_study::sensitivity::{Offsets, ParameterDeviation};
use cdpr_workspace::grid::{self, Grid};
use cdpr_workspace::hull::Hull;
use cdpr_workspace::mesh::Mesh;
use cdpr_workspace::refine::{Goal, RegionSearch, refine};
use cdpr_workspace::{Bounds, Cells, Point, Region, hull};
use clap::{Args, ValueEnum};

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::inputs::pose_of;
use crate::meshes::{check_mesh_file, write_mesh};
use crate::numbers::{NumberList, finite_number};
use crate::progress::Progress;
use crate::sensitivities::place_of;
use crate::study_file::StudyFile;
use crate::tension_method::TensionMethodArgument;

const EXAMPLES: &str = "\
Examples:
  cdpr reachable studies/planar-wide-grid.toml
  cdpr reachable study.toml --method hull --rays 642
  cdpr reachable study.toml --accuracy 0.001,0.002,0.005,0.01
  cdpr reachable study.toml --method hull --mesh reached.glb --emerging-mesh emerging.glb
  cdpr reachable study.toml --method hull --vary \"machine frame-anchor[1].x\" --change 0.01
  cdpr reachable studies/planar-wide-grid.toml --method hull --center 0,3 --svg outlines.svg
  cdpr reachable studies/planar-wide-grid.toml --linear
  cdpr reachable study.toml --bounds=-4,4,0,7 --step 0.05 --format json";

/// Which part of its workspace a robot really reaches under its control model.
///
/// A commanded pose counts as reached when the machine comes to rest there with tensions within the limits and a position
/// error of at most [limits] position_error_max_m (eq. 3.33), and, under force control, tensions no farther than [limits]
/// tension_error_max_N from the commanded ones. Beside it: the physical workspace, in which the machine is
/// wrench-feasible, and the model workspace, in which the control model is. The answer is negative (exit code 1) when no
/// pose is reached.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Study file (TOML); `cdpr schema study` describes it. It needs no poses.
    #[arg(value_name = "STUDY")]
    study: PathBuf,

    /// How the workspaces are found.
    #[arg(long, value_enum, default_value_t = Method::Grid, value_name = "grid|hull", hide_possible_values = true)]
    method: Method,

    #[command(flatten)]
    choice: TensionMethodArgument,

    /// Box to look in, ends along each translation x0,x1,y0,y1(,z0,z1) (m); a box around the robot when left out.
    #[arg(long, value_name = "BOUNDS", allow_hyphen_values = true)]
    bounds: Option<NumberList>,

    /// Largest side of a cell of the grid (m); when left out a hundredth of the longest side of the box in a plane, a fiftieth in space, and finer until
    /// the size is known to 1 % or a second of work is done.
    #[arg(long, value_name = "STEP", value_parser = finite_number, allow_hyphen_values = true)]
    step: Option<f64>,

    /// Rays of a hull, at least: 360 in a plane; in space 2562, the corners of an icosahedron refined four times.
    #[arg(long, value_name = "N")]
    rays: Option<usize>,

    /// Pose from which the rays of a hull start, whose orientation counts; the initial pose when left out.
    #[arg(long, value_name = "POSE", allow_hyphen_values = true)]
    center: Option<NumberList>,

    /// Position errors to judge by in turn (m), beside that of the study; with --method grid.
    #[arg(long, value_name = "M,…", allow_hyphen_values = true)]
    accuracy: Option<NumberList>,

    /// Tells what would be reached if the machine answered by one linear step (eq. 3.34, 3.35), beside the exact answer.
    #[arg(long)]
    linear: bool,

    /// Writes the surface of what is reached, by commanded poses, with margin and limiting cable at its vertices: .stl, .glb, .ply,
    /// .vtk or .csv.
    #[arg(long, value_name = "FILE")]
    mesh: Option<PathBuf>,

    /// Writes the same surface where the platform comes to rest; with --method hull.
    #[arg(long, value_name = "FILE")]
    emerging_mesh: Option<PathBuf>,

    /// Draws the outlines: of a planar robot what is physically possible and what is reached, by commanded and by emerging poses; of a
    /// spatial one level with the centre; with --vary how they move. With --method hull.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,

    /// Number of control model, machine or winches whose change moves the hull, by its name in `cdpr sensitivity`, as
    /// "machine frame-anchor[1].x"; with --method hull.
    #[arg(long, value_name = "NAME", requires = "change")]
    vary: Option<String>,

    #[arg(help = "How much it changes, in its unit; stiffness and length scale as a share")]
    #[arg(long, value_name = "AMOUNT", value_parser = finite_number, allow_hyphen_values = true, requires = "vary")]
    change: Option<f64>,
}

/// Ways to find the workspaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Method {
    /// Every cell of a box.
    Grid,
    /// Rays from a centre.
    Hull,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let study_file = StudyFile::read(&arguments.study)?.with_tension_method(arguments.choice.tension_method);
    study_file.introduce(output);
    let thresholds = thresholds(&arguments)?;
    check_options(&arguments)?;
    let change = arguments.vary.as_ref().zip(arguments.change);
    let cause = change.map(|(name, by)| cause_named(&study_file, name).map(|cause| (cause, by))).transpose()?;
    let reachable = study_file.accepted(study_file.reachable())?;
    let machine = &study_file.machine;
    let center = match &arguments.center {
        Some(numbers) => pose_of(machine.robot(), "--center", numbers)?,
        None => study_file.start,
    };
    let bounds = study_file.bounds(arguments.bounds.as_ref().map(|numbers| numbers.0.as_slice()));
    let bounds = bounds.map_err(|error| Failure::refused("--bounds", &error))?;
    let region = study_file.region(&reachable, center.rotation).map_err(|error| study_file.refused(&error))?;
    let search = Search { study_file: &study_file, region: &region, bounds, center: region.point(&center.position) };
    let found = match arguments.method {
        Method::Grid => search.by_grid(&reachable, &arguments, &thresholds)?,
        Method::Hull => search.by_hull(&reachable, &arguments, cause)?,
    };
    output.answer(&found)
}

/// Options that need another method, and files that name no format.
fn check_options(arguments: &Arguments) -> Result<(), Failure> {
    for (option, path) in [("--mesh", &arguments.mesh), ("--emerging-mesh", &arguments.emerging_mesh)] {
        path.as_ref().map_or(Ok(()), |path| check_mesh_file(option, path))?;
    }
    let of_hulls = [
        ("--emerging-mesh", arguments.emerging_mesh.is_some()),
        ("--svg", arguments.svg.is_some()),
        ("--vary", arguments.vary.is_some()),
    ];
    match of_hulls.iter().find(|(_, given)| *given && arguments.method == Method::Grid) {
        Some((option, _)) => {
            let message = format!("{option} needs the rays of a hull");
            Err(Failure::usage("usage::value", message).with_help("add --method hull"))
        }
        None => Ok(()),
    }
}

/// The errors that `--accuracy` asks for.
fn thresholds(arguments: &Arguments) -> Result<Vec<f64>, Failure> {
    let list = arguments.accuracy.as_ref().map_or(&[][..], |numbers| &numbers.0);
    let refused = |message: String, help: &str| Err(Failure::usage("usage::value", message).with_help(help));
    if let Some(wrong) = list.iter().find(|error| !(**error > 0.0 && error.is_finite())) {
        return refused(format!("--accuracy: {wrong} m is no largest error"), "give positive numbers in metres");
    }
    if !list.is_empty() && arguments.method == Method::Hull {
        return refused("--accuracy judges the cells of a grid".to_owned(), "leave --method hull out");
    }
    Ok(list.to_vec())
}

/// Search for the boundary: the region, its box and centre.
struct Search<'a> {
    study_file: &'a StudyFile,
    region: &'a Region<'a>,
    bounds: Bounds,
    center: Point,
}

impl Search<'_> {
    fn searched(&self) -> Searched<'_> {
        Searched { experiment: self.study_file, region: self.region, bounds: &self.bounds }
    }

    fn by_grid(
        &self,
        reachable: &Reachable,
        arguments: &Arguments,
        thresholds: &[f64],
    ) -> Result<ReachableAnswer, Failure> {
        let step = arguments.step.unwrap_or(self.bounds.usual_step());
        let progress = Progress::spinner("commanding the cells of the grid");
        let mut search = ByCensus { reachable, region: self.region, bounds: &self.bounds, step };
        // who gives a step wants these cells
        let (counted, audit) = match arguments.step {
            Some(_) => search.find(0).map(|counted| (counted, None)),
            None => refine(self.region, &self.bounds, &Goal::usual(), &mut search)
                .map(|refined| (refined.found, Some(refined.audit))),
        }
        .map_err(|error| Failure::refused("--step", &error))?;
        let grid = &counted.grid;
        if let Some(path) = &arguments.mesh {
            write_mesh(path, &self.surface(grid, &counted.answers)?)?;
        }
        let feasible = |model: &Model| self.study_file.feasible_cells(model, self.region, grid);
        let [physical, model] = [&self.study_file.machine, &self.study_file.control].map(feasible);
        let linear = arguments.linear.then(|| {
            let criterion = reachable.by_linear_step();
            grid::count(&self.region.with_criterion(&criterion), grid).outcome(grid).size
        });
        let feasible = [physical, model];
        let answer =
            ReachableAnswer::of_grid(self.searched(), reachable, &counted, audit.as_ref(), feasible, thresholds);
        drop(progress);
        Ok(answer.with_linear(linear).explained(|| self.why_nothing()))
    }

    fn by_hull(
        &self,
        reachable: &Reachable,
        arguments: &Arguments,
        change: Option<(ParameterDeviation, f64)>,
    ) -> Result<ReachableAnswer, Failure> {
        let mut settings = hull::Settings::new(&self.bounds);
        settings.rays = arguments.rays.unwrap_or(settings.rays);
        let progress = Progress::spinner("following rays");
        let solve = |region: &Region<'_>| hull::solve(region, &self.bounds, &self.center, &settings);
        let found = solve(self.region).map_err(|error| Failure::refused("--method hull", &error))?;
        let image = image_of(reachable, self.region, &found);
        self.write_hulls(&found, image.as_ref(), arguments)?;
        let differential = change.map(|(cause, by)| {
            let change = Change { cause: &cause, by };
            let moved = differential(self.study_file, reachable, self.region, &found, &self.bounds, &settings, change);
            self.study_file.accepted(moved)
        });
        let differential = differential.transpose()?;
        let feasible = |model: &Model| -> Option<Hull> {
            let criterion = self.study_file.feasible(model)?;
            solve(&self.region.with_criterion(&criterion)).ok()
        };
        let [physical, model] = [&self.study_file.machine, &self.study_file.control].map(feasible);
        if let Some(path) = &arguments.svg {
            let picture = Picture {
                experiment: self.study_file,
                physical: physical.as_ref(),
                hull: &found,
                image: image.as_ref(),
                differential: differential.as_ref(),
            };
            let svg = picture.svg().ok_or_else(|| {
                let message = "--svg: nothing is reached, so there is no outline to draw".to_owned();
                Failure::input("workspace::mesh", message, "leave --svg out".to_owned())
            })?;
            files::write(path, svg.as_bytes())?;
        }
        let linear = arguments.linear.then(|| self.linear_hull(reachable, &settings).unwrap_or(f64::NAN));
        let size = |region: &Region<'_>| Some(solve(region).ok()?.measure()?.size);
        let compensation = reachable.map_effect(self.region, &found.vertices(), size);
        let feasible = [physical.as_ref(), model.as_ref()];
        let answer = ReachableAnswer::of_hull(self.searched(), &found, feasible, image, compensation);
        drop(progress);
        Ok(answer.with_linear(linear).with_differential(differential))
    }

    /// Size within the rays of what one linear step reaches; `None` if it is not star-shaped.
    fn linear_hull(&self, reachable: &Reachable, settings: &hull::Settings) -> Option<f64> {
        let criterion = reachable.by_linear_step();
        let region = self.region.with_criterion(&criterion);
        let found = hull::solve(&region, &self.bounds, &self.center, settings).ok()?;
        found.measure().filter(|_| found.is_star_shaped()).map(|measure| measure.size)
    }

    /// The boundary between cells that are reached and those that are not.
    fn surface(&self, grid: &Grid, answers: &[bool]) -> Result<Mesh, Failure> {
        let mut cells = Cells::new(grid).map_err(|error| Failure::refused("--step", &error))?;
        let slabs = answers.chunks(grid.slab_points()).enumerate();
        slabs.for_each(|(slab, answers)| cells.see(slab, answers));
        Ok(cells.surface(self.region))
    }

    /// The files of a hull: where poses are commanded, and where the platform comes to rest.
    fn write_hulls(&self, hull: &Hull, image: Option<&Image>, arguments: &Arguments) -> Result<(), Failure> {
        let mesh = hull.mesh(self.region);
        if let Some(path) = &arguments.mesh {
            write_mesh(path, &mesh)?;
        }
        let Some(path) = &arguments.emerging_mesh else { return Ok(()) };
        let Some(image) = image else {
            let message = "--emerging-mesh: at a corner of the hull the platform comes to no rest";
            return Err(Failure::input("workspace::mesh", message.to_owned(), "leave --emerging-mesh out"));
        };
        // the triangles of a planar hull meet in its centre, which is the last vertex
        let points = image.vertices.iter().chain([&hull.center]);
        let vertices = points.map(|point| self.region.position(point).into()).take(mesh.vertices.len()).collect();
        write_mesh(path, &Mesh { vertices, ..mesh })
    }

    /// Reason that stands in the way at the center; where that is reached, the box or its cells are to blame.
    fn why_nothing(&self) -> String {
        let at_center = self.region.judge(&self.center);
        if let Some(why) = at_center.reason {
            return format!("; at the initial pose: {why}");
        }
        if self.bounds.contain(&self.center) {
            return "; the initial pose is, so the cells are too coarse: take a smaller --step".to_owned();
        }
        let in_the_middle = self.region.judge(&self.bounds.middle()).reason;
        let why = in_the_middle.map_or_else(String::new, |why| format!("; in its middle: {why}"));
        format!(": the box lies outside the robot's reach, the initial pose outside the box; move --bounds{why}")
    }
}

/// The number of this name; near ones are told.
fn cause_named(study_file: &StudyFile, name: &str) -> Result<ParameterDeviation, Failure> {
    let all = study_file.causes(Offsets::Kept);
    place_of(&all, &study_file.machine, name, "--vary").map(|place| all[place])
}
