//! Laws that areas, volumes and boundaries obey, on shapes of known size and on robots.

use std::f64::consts::PI;

use super::shape::Shape;
use super::support::builtin;
use cdpr_model::geometry::Wrench;
use cdpr_model::model::{Composition, Model};
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_workspace::criterion::WrenchFeasible;
use cdpr_workspace::differential::{Differences, motion};
use cdpr_workspace::grid::{self, Count, Grid};
use cdpr_workspace::refine::{ByGrid, ByOctree, Goal, refine};
use cdpr_workspace::{Archetype, Audit, Bounds, Point, Region, WorkspaceError, hull, octree};
use nalgebra::{UnitQuaternion, Vector3};

pub(super) fn standard(name: &str) -> Model {
    Model::new(builtin(name), Composition::STANDARD).unwrap()
}

pub(super) fn feasible(model: &Model) -> WrenchFeasible<'_> {
    let (load, limits) = (Load::of(model.robot()).unwrap(), Limits::of(model.robot(), None, None).unwrap());
    WrenchFeasible::new(model, &load, &limits).unwrap()
}

pub(super) fn upright() -> Archetype {
    Archetype::ConstantOrientation(UnitQuaternion::identity())
}

fn cube() -> Bounds {
    Bounds::new(3, &[-1.0, 1.0, -1.1, 1.0, -1.0, 1.2]).unwrap()
}

/// A ball of 0.8 m is as large as each method says, within the bound that it states.
#[test]
fn every_method_finds_the_volume_of_a_ball_within_its_own_bound() {
    let model = standard("cablerobot-simulator-icosahedron");
    let shape = Shape(|r: &Vector3<f64>| 0.8 - r.norm());
    let region = Region::new(&model, &shape, &upright()).unwrap();
    let exact = 4.0 / 3.0 * PI * 0.8_f64.powi(3);
    let cells = Grid::new(&cube(), 0.05).unwrap();
    let by_grid = grid::count(&region, &cells).outcome(&cells);
    let by_octree = octree::solve(&region, &cube(), &octree::Settings::new(0.05)).unwrap();
    let rays = hull::solve(&region, &cube(), &[0.1, -0.2, 0.1], &hull::Settings::new(&cube())).unwrap();
    let by_rays = rays.measure().unwrap();
    for (size, bound) in [
        (by_grid.size, by_grid.error_bound),
        (by_octree.size, by_octree.error_bound),
        (by_rays.size, by_rays.error_bound),
    ] {
        println!("{size} ± {bound}");
        assert!((size - exact).abs() < bound, "{size} ± {bound}, {exact}");
        assert!((size - exact).abs() < 0.01 * exact, "{size} {exact}");
    }
    assert!((by_rays.surface / (4.0 * PI * 0.64) - 1.0).abs() < 0.01, "{by_rays:?}");
    // the polyhedron is a little flatter far from its centre than near to it
    assert!(by_rays.centroid.iter().all(|part| part.abs() < 2e-3), "{by_rays:?}");
    let mesh = rays.mesh(&region);
    assert!(mesh.is_closed() && (mesh.volume() / by_rays.size - 1.0).abs() < 1e-12);
}

/// A tenth of the points of a grid of the same cells, for a set that fills most of its box: the less favourable case, since a
/// grid also counts what lies around a set.
#[test]
fn an_octree_judges_a_tenth_of_the_points_of_the_grid_of_its_smallest_cells() {
    let model = standard("cablerobot-simulator-icosahedron");
    let shape = Shape(|r: &Vector3<f64>| 1.0 - r.norm());
    let region = Region::new(&model, &shape, &upright()).unwrap();
    let bounds = Bounds::new(3, &[-1.04, 1.04, -1.04, 1.04, -1.04, 1.04]).unwrap();
    let found = octree::solve(&region, &bounds, &octree::Settings::new(2.08 / 100.0)).unwrap();
    println!("{found:?}");
    assert!(10 * found.points < found.grid_points, "{} of {}", found.points, found.grid_points);
    assert!((found.size / (4.0 / 3.0 * PI) - 1.0).abs() < 1e-3, "{found:?}");
}

/// A bar thinner than a start cell hangs on a ball: the boundary is followed into it.
#[test]
fn an_octree_follows_the_boundary_into_parts_thinner_than_its_start_cells() {
    let model = standard("cablerobot-simulator-icosahedron");
    let bar = |r: &Vector3<f64>| (0.06 - (r.y - 0.013).abs().max((r.z - 0.017).abs())).min(0.9 - r.x).min(r.x);
    let shape = Shape(move |r: &Vector3<f64>| (0.3 - r.norm()).max(bar(r)));
    let region = Region::new(&model, &shape, &upright()).unwrap();
    let found = octree::solve(&region, &cube(), &octree::Settings::new(0.02)).unwrap();
    let ball = 4.0 / 3.0 * PI * 0.3_f64.powi(3);
    let outside_the_ball = 0.12 * 0.12 * 0.6;
    assert!(found.start_cell[1] > 0.12, "{found:?}");
    assert!((found.size / (ball + outside_the_ball) - 1.0).abs() < 0.05, "{found:?}");
}

/// A ball that fits between the corners of the start cells and touches nothing: seeds meet it.
#[test]
fn an_octree_finds_a_part_between_the_corners_of_its_start_cells() {
    let model = standard("cablerobot-simulator-icosahedron");
    let middle_of_a_cell = Vector3::new(0.2222, 0.1833, 0.21);
    let shape = Shape(move |r: &Vector3<f64>| 0.13 - (r - middle_of_a_cell).norm());
    let region = Region::new(&model, &shape, &upright()).unwrap();
    let found = octree::solve(&region, &cube(), &octree::Settings::new(0.03)).unwrap();
    let exact = 4.0 / 3.0 * PI * 0.13_f64.powi(3);
    assert!(found.start_cell.iter().all(|side| *side > 0.21), "{found:?}");
    assert!((found.size / exact - 1.0).abs() < 0.05, "{found:?} {exact}");
}

/// A sheet of two millimetres has no cell and no seed to itself: the bound of the error knows it all the same.
#[test]
fn what_no_cell_sees_lies_within_the_bound_of_the_error() {
    let model = standard("cablerobot-simulator-icosahedron");
    let shape = Shape(|r: &Vector3<f64>| 1e-3 - (r.x - 0.513).abs());
    let region = &Region::new(&model, &shape, &upright()).unwrap();
    let (bounds, goal) = (&cube(), Goal { refines: false, ..Goal::usual() });
    let exact = 2e-3 * 2.1 * 2.2;
    let grid = refine(region, bounds, &goal, &mut ByGrid { region, bounds, step: 0.1 }).unwrap();
    let tree = refine(region, bounds, &goal, &mut ByOctree { region, bounds, step: 0.1 }).unwrap();
    let (by_grid, by_tree) = (grid.found.1.outcome(&grid.found.0), tree.found.outcome());
    for (size, cells, audit) in
        [(by_grid.size, by_grid.error_bound, &grid.audit), (by_tree.size, by_tree.error_bound, &tree.audit)]
    {
        println!("{size} ± {}, {exact}", audit.error_bound());
        assert!((size - exact).abs() > cells, "the cells at the boundary say ± {cells}");
        assert!((size - exact).abs() < audit.error_bound(), "{size} {audit:?} {exact}");
    }
}

/// A ball between the rays, 10° from the nearest of 162 and 5° wide, is left out of the hull of another.
#[test]
fn a_part_between_the_rays_is_no_hull() {
    let model = standard("cablerobot-simulator-icosahedron");
    let aside = Vector3::repeat(0.8);
    let shape = Shape(move |r: &Vector3<f64>| (0.15 - r.norm()).max(0.12 - (r - aside).norm()));
    let region = Region::new(&model, &shape, &upright()).unwrap();
    let settings = hull::Settings { rays: 162, ..hull::Settings::new(&cube()) };
    let mut hull = hull::solve(&region, &cube(), &[0.0; 3], &settings).unwrap();
    let measure = hull.measure().unwrap();
    let locator = hull::Locator::new(&hull);
    let contains = &mut |points: &[Point], answers: &mut [bool]| {
        points.iter().zip(answers).for_each(|(point, answer)| *answer = locator.contains(point));
    };
    let audit = Audit::of(&region, &cube(), [100_000, 1], contains);
    let size = |radius: f64| 4.0 / 3.0 * PI * radius.powi(3);
    let exact = size(0.15) + size(0.12);
    println!("{measure:?}, {} within {}", exact, audit.error_bound());
    assert!((measure.size - exact).abs() < audit.error_bound());
    hull.doubt(&audit);
    let hull::Status::LeavesOut { size: left_out } = hull.status else { panic!("{:?}", hull.status) };
    assert!(left_out > 0.0 && left_out < exact - measure.size, "{left_out}");
    assert_eq!(hull.measure(), None);
    // a ball alone is not doubted, however few its rays
    let shape = Shape(|r: &Vector3<f64>| 0.15 - r.norm());
    let region = Region::new(&model, &shape, &upright()).unwrap();
    let mut hull = hull::solve(&region, &cube(), &[0.0; 3], &settings).unwrap();
    let locator = hull::Locator::new(&hull);
    let contains = &mut |points: &[Point], answers: &mut [bool]| {
        points.iter().zip(answers).for_each(|(point, answer)| *answer = locator.contains(point));
    };
    let audit = Audit::of(&region, &cube(), [100_000, 1], contains);
    hull.doubt(&audit);
    assert!(hull.is_star_shaped(), "{:?}", hull.status);
}

/// Where the boundary is followed everywhere, as it is about a ball and a cavity in it, the cells add up to those of all corners
/// judged, also where the set reaches the faces of the box.
#[test]
fn an_octree_counts_the_cells_that_all_corners_would_give() {
    let model = standard("cablerobot-simulator-icosahedron");
    let shape = Shape(|r: &Vector3<f64>| (1.05 - r.norm()).min((r - Vector3::x() * 0.3).norm() - 0.45));
    let flat = standard("planar-example");
    let plane = Bounds::new(2, &[-1.0, 1.0, -1.1, 1.0]).unwrap();
    for (bounds, model, step) in [(cube(), &model, 0.0999), (plane, &flat, 0.0831)] {
        let region = Region::new(model, &shape, &upright()).unwrap();
        let tree = octree::solve(&region, &bounds, &octree::Settings { step, halvings: 3 }).unwrap();
        let counts = [0, 1, 2].map(|axis| match axis < bounds.dimension() {
            true => ((bounds.extent(axis) / step).ceil() as usize).next_multiple_of(8),
            false => 0,
        });
        let at = |node: [usize; 3]| {
            let along = |axis: usize| match counts[axis] {
                0 => 0.0,
                count => bounds.least()[axis] + node[axis] as f64 / count as f64 * bounds.extent(axis),
            };
            region.holds(&[along(0), along(1), along(2)])
        };
        let (mut size, mut mixed) = (0.0, 0);
        let corners = 1 << bounds.dimension();
        for index in 0..counts.map(|count| count.max(1)).iter().product::<usize>() {
            let (columns, rows) = (counts[0], counts[1]);
            let node = [index % columns, index / columns % rows, index / columns / rows];
            let held = (0..corners).filter(|k| at([0, 1, 2].map(|axis| node[axis] + (k >> axis & 1)))).count();
            mixed += u64::from(held > 0 && held < corners);
            size += held as f64 / corners as f64;
        }
        let cell = bounds.size() / counts.map(|count| count.max(1)).iter().product::<usize>() as f64;
        assert!(tree.reaches_bounds);
        assert_eq!(tree.boundary_cells, mixed);
        assert!((tree.size - size * cell).abs() < 1e-9, "{} {}", tree.size, size * cell);
    }
}

/// A shell is not star-shaped from within its wall: the hull says so and gives no volume.
#[test]
fn a_shell_has_no_hull() {
    let model = standard("cablerobot-simulator-icosahedron");
    let shape = Shape(|r: &Vector3<f64>| (0.9 - r.norm()).min(r.norm() - 0.5));
    let region = Region::new(&model, &shape, &upright()).unwrap();
    let found = hull::solve(&region, &cube(), &[0.7, 0.0, 0.0], &hull::Settings::new(&cube())).unwrap();
    let hull::Status::NotStarShaped { rays, direction } = &found.status else { panic!("{:?}", found.status) };
    assert!(*rays > 100 && direction[0] < -0.7, "{rays} {direction:?}"); // through the hole, which is 46° wide
    assert!(found.measure().is_none());
}

#[test]
fn a_center_outside_too_few_rays_and_a_step_of_zero_are_refused() {
    let model = standard("planar-example");
    let shape = Shape(|r: &Vector3<f64>| 0.5 - r.norm());
    let region = Region::new(&model, &shape, &upright()).unwrap();
    let bounds = Bounds::new(2, &[-1.0, 1.0, -1.0, 1.0]).unwrap();
    let settings = hull::Settings::new(&bounds);
    let from = |center: Point, settings: &hull::Settings| hull::solve(&region, &bounds, &center, settings).unwrap_err();
    assert!(matches!(from([0.9, 0.0, 0.0], &settings), WorkspaceError::CenterOutside { .. }));
    assert!(matches!(from([3.0, 0.0, 0.0], &settings), WorkspaceError::CenterOutsideBounds { .. }));
    let few = hull::Settings { rays: 2, ..settings.clone() };
    assert!(matches!(from([0.0; 3], &few), WorkspaceError::Rays { rays: 2, .. }));
    let endless = hull::Settings { tolerance: 0.0, ..settings };
    assert!(matches!(from([0.0; 3], &endless), WorkspaceError::Tolerance { .. }));
    assert!(matches!(Grid::new(&bounds, 0.0), Err(WorkspaceError::Step { .. })));
    assert!(matches!(Grid::new(&bounds, f64::NAN), Err(WorkspaceError::Step { .. })));
    assert!(matches!(Grid::new(&bounds, 1e-9), Err(WorkspaceError::StepTooFine { .. })));
    let dextrous = Archetype::Dextrous { besides: UnitQuaternion::identity(), orientations: 5 };
    assert!(matches!(Region::new(&model, &shape, &dextrous), Err(WorkspaceError::NoRotation { .. })));
}

/// The end of every ray lies in the set, and one tolerance further out does not.
#[test]
fn hull_vertices_lie_in_the_set_and_one_tolerance_further_they_do_not() {
    for (name, rays) in [("planar-example", 100), ("cablerobot-simulator-icosahedron", 642)] {
        let model = standard(name);
        let criterion = feasible(&model);
        let region = Region::new(&model, &criterion, &upright()).unwrap();
        let bounds = Bounds::around(&model).unwrap();
        let center = region.point(&model.robot().home.unwrap().position);
        let found =
            hull::solve(&region, &bounds, &center, &hull::Settings { rays, ..hull::Settings::new(&bounds) }).unwrap();
        assert!(found.is_star_shaped() && found.rays_at_bounds == 0);
        for (ray, direction) in found.directions.iter().enumerate() {
            assert!(region.holds(&found.vertex(ray)), "{name} {ray}");
            let radius = found.radii[ray] + found.tolerance;
            let beyond = [0, 1, 2].map(|axis| center[axis] + radius * direction[axis]);
            assert!(!region.holds(&beyond), "{name} {ray}");
        }
    }
}

/// A count that was written down half-way ends as one that was not; and threads change nothing.
#[test]
fn a_count_that_is_resumed_ends_as_one_in_one_go() {
    let model = standard("cablerobot-simulator-icosahedron");
    let criterion = feasible(&model);
    let region = Region::new(&model, &criterion, &upright()).unwrap();
    let cells = Grid::new(&Bounds::around(&model).unwrap(), 0.25).unwrap();
    let whole = grid::count(&region, &cells);
    let mut first = Count::new();
    assert!(first.advance(&region, &cells, &mut |_, _| {}), "one block is not all of it");
    let mut second: Count = serde_json::from_str(&serde_json::to_string(&first).unwrap()).unwrap();
    assert!(second.fits(&cells) && second == first);
    while second.advance(&region, &cells, &mut |_, _| {}) {}
    assert_eq!(second, whole);
    assert!(!first.fits(&Grid::new(cells.bounds(), 0.2).unwrap()));
    #[cfg(feature = "parallel")]
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        assert_eq!(pool.install(|| grid::count(&region, &cells)), whole);
    }
}

/// First-order motion against a new hull: halving the change quarters what is missed.
#[test]
fn the_first_order_motion_of_a_boundary_is_that_of_a_recomputed_hull() {
    let model = standard("planar-example");
    let limits = Limits::uniform(4, 1000.0, 8000.0).unwrap();
    let pulled = |force: f64| {
        let load = Load::constant(Wrench::new(0.0, -force, 0.0, 0.0, 0.0, 0.0));
        WrenchFeasible::new(&model, &load, &limits).unwrap()
    };
    let bounds = Bounds::around(&model).unwrap();
    let settings = hull::Settings { rays: 90, tolerance: 1e-10, ..hull::Settings::new(&bounds) };
    let hull_of = |force: f64| {
        let criterion = pulled(force);
        let region = Region::new(&model, &criterion, &upright()).unwrap();
        hull::solve(&region, &bounds, &[0.0, 5.0, 0.0], &settings).unwrap()
    };
    let (force, here) = (1962.0, hull_of(1962.0));
    let criteria = [0.0, -1.0, 1.0].map(|change| pulled(force + change));
    let [region, below, above] =
        criteria.each_ref().map(|criterion| Region::new(&model, criterion, &upright()).unwrap());
    let moves = motion(&here, &region, [&below, &above], Differences { parameter: 1.0, radius: 1e-4 });
    assert!(moves.rates.iter().all(Option::is_some));
    let missed = |change: f64| -> Vec<f64> {
        let (predicted, found) = (moves.moved(&here, change), hull_of(force + change));
        predicted.radii.iter().zip(&found.radii).map(|(a, b)| (a - b).abs()).collect()
    };
    let mut errors = [missed(100.0), missed(50.0)];
    errors.iter_mut().for_each(|list| list.sort_by(f64::total_cmp));
    let [whole, half] = errors.each_ref().map(|list| list[list.len() / 2]);
    println!("median {whole:.2e} m after 100 N, {half:.2e} m after 50 N");
    assert!(whole < 2e-3 && half < 0.3 * whole, "{whole} {half}");
    // the area by its rate, against the difference of two areas
    let area = |force: f64| hull_of(force).measure().unwrap().size;
    let (rate, difference) = (moves.size_rate(&here), (area(force + 20.0) - area(force - 20.0)) / 40.0);
    assert!((rate / difference - 1.0).abs() < 1e-2, "{rate} {difference}");
}
