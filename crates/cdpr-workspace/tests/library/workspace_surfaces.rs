//! Surfaces of grids and octrees are closed and as large as what they bound, on shapes of known size and on a robot.

use std::f64::consts::PI;

use super::shape::Shape;
use super::support::builtin;
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{Obstacle, ObstacleShape};
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_workspace::criterion::{All, LengthLimits, PlatformObstacles, WrenchClosure, WrenchFeasible};
use cdpr_workspace::grid::{Count, Grid, Outcome};
use cdpr_workspace::mesh::Mesh;
use cdpr_workspace::{Archetype, Bounds, Cells, Criterion, Region, Verdict, hull, octree};
use nalgebra::{UnitQuaternion, Vector3};

fn standard(name: &str) -> Model {
    Model::new(builtin(name), Composition::STANDARD).unwrap()
}

fn upright() -> Archetype {
    Archetype::ConstantOrientation(UnitQuaternion::identity())
}

fn by_grid(region: &Region<'_>, bounds: &Bounds, step: f64) -> (Outcome, Mesh) {
    let grid = Grid::new(bounds, step).unwrap();
    let (mut count, mut cells) = (Count::new(), Cells::new(&grid).unwrap());
    while count.advance(region, &grid, &mut |slab, answers| cells.see(slab, answers)) {}
    (count.outcome(&grid), cells.surface(region))
}

/// Size, bound and surface of grid and octree.
fn both(region: &Region<'_>, bounds: &Bounds, step: f64) -> [(f64, f64, Mesh); 2] {
    let (grid, of_grid) = by_grid(region, bounds, step);
    let searched = octree::search(region, bounds, &octree::Settings::new(step)).unwrap();
    let (octree, of_octree) = (searched.outcome(), searched.surface());
    [(grid.size, grid.error_bound, of_grid), (octree.size, octree.error_bound, of_octree)]
}

fn cube() -> Bounds {
    Bounds::new(3, &[-1.0, 1.0, -1.1, 1.0, -1.0, 1.2]).unwrap()
}

/// Vertices between nodes lie in the set and within a thousandth of a step of its boundary; the few in the middles of pieces lie
/// off it by what the surface bends within a cell: 0.05²/(8 · 0.8) m.
#[test]
fn the_surface_of_a_ball_is_closed_lies_on_it_and_holds_its_volume() {
    let model = standard("cablerobot-simulator-icosahedron");
    let shape = Shape(|r: &Vector3<f64>| 0.8 - r.norm());
    let region = Region::new(&model, &shape, &upright()).unwrap();
    let exact = 4.0 / 3.0 * PI * 0.8_f64.powi(3);
    for (size, bound, mesh) in both(&region, &cube(), 0.05) {
        println!("{size} ± {bound}, mesh {}, {} triangles", mesh.volume(), mesh.triangles.len());
        assert!(mesh.is_closed());
        assert!((mesh.volume() - size).abs() < bound);
        assert!((mesh.volume() / exact - 1.0).abs() < 2e-3, "{} {exact}", mesh.volume());
        assert!((mesh.area() / (4.0 * PI * 0.64) - 1.0).abs() < 0.01, "{}", mesh.area());
        let off = mesh.vertices.iter().map(|vertex| 0.8 - Vector3::from(*vertex).norm());
        assert!(off.clone().all(|off| (0.0..0.05 / 1000.0).contains(&off)), "{:?}", off.reduce(f64::max));
        // Euler: a closed surface without holes
        assert_eq!(mesh.vertices.len() * 2, mesh.triangles.len() + 4);
        assert_eq!(mesh.fields.len(), 2);
        assert!(mesh.fields[1].values.iter().all(|cable| *cable == 4.0));
    }
}

/// Two balls and one around a cavity; noise has every way in which the corners of a cube can differ.
#[test]
fn several_parts_cavities_and_noise_have_closed_surfaces() {
    let model = standard("cablerobot-simulator-icosahedron");
    let parts = Shape(|r: &Vector3<f64>| {
        let shell = (0.45 - (r - Vector3::x() * 0.5).norm()).min((r - Vector3::x() * 0.5).norm() - 0.2);
        shell.max(0.3 - (r + Vector3::x() * 0.6).norm())
    });
    let region = Region::new(&model, &parts, &upright()).unwrap();
    let exact = 4.0 / 3.0 * PI * (0.45_f64.powi(3) - 0.2_f64.powi(3) + 0.3_f64.powi(3));
    for (size, bound, mesh) in both(&region, &cube(), 0.04) {
        assert!(mesh.is_closed() && (mesh.volume() - size).abs() < bound);
        assert!((mesh.volume() / exact - 1.0).abs() < 0.01, "{} {exact}", mesh.volume());
        assert_eq!(mesh.vertices.len() * 2, mesh.triangles.len() + 3 * 4); // three surfaces of a ball
    }
    let noise = Shape(|r: &Vector3<f64>| {
        let bits = (r.x * 7919.0 + r.y * 104_729.0 + r.z * 1_299_709.0).sin() * 43_758.547;
        bits - bits.floor() - 0.5
    });
    let region = Region::new(&model, &noise, &upright()).unwrap();
    for (_, _, mesh) in both(&region, &cube(), 0.15) {
        assert!(mesh.is_closed() && mesh.triangles.len() > 1000, "{}", mesh.triangles.len());
    }
}

/// Everything holds: the surface is that of the box.
#[test]
fn where_the_region_reaches_the_bounds_the_surface_is_their_face() {
    let model = standard("cablerobot-simulator-icosahedron");
    let everything = Shape(|_: &Vector3<f64>| 1.0);
    let region = Region::new(&model, &everything, &upright()).unwrap();
    for (size, _, mesh) in both(&region, &cube(), 0.1) {
        assert!(mesh.is_closed());
        // the edges of the box are cut off where nodes lie half a cell inside it
        assert!((mesh.volume() / size - 1.0).abs() < 0.01, "{} {size}", mesh.volume());
    }
}

/// The same verdicts without closed forms.
struct Judged<'a>(&'a dyn Criterion);

impl Criterion for Judged<'_> {
    fn name(&self) -> &str {
        self.0.name()
    }

    fn unit(&self) -> &str {
        self.0.unit()
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        self.0.judge(pose)
    }
}

/// Rays end where bisection ends, to its tolerance, and see the same of what lies beyond; the hull needs a point per ray.
#[test]
fn rays_in_closed_form_end_where_bisected_ones_do() {
    let mut robot = builtin("cablerobot-simulator-icosahedron");
    let home = robot.home_or_middle().position;
    let shape =
        ObstacleShape::Box { min: home + Vector3::new(2.5, -1.0, -2.0), max: home + Vector3::new(3.0, 0.5, 2.0) };
    robot.obstacles = vec![Obstacle { name: "crate".to_owned(), shape }];
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let lengths = || Box::new(LengthLimits::new(&model, Some(2.0), Some(9.5)).unwrap()) as Box<dyn Criterion>;
    let platform = || Box::new(PlatformObstacles::new(&model, 0.0).unwrap()) as Box<dyn Criterion>;
    let all = All::new(vec![lengths(), platform()]).unwrap();
    let bounds = Bounds::around(&model).unwrap();
    let closure = WrenchClosure::new(&model).unwrap();
    for (criterion, rays, probes) in
        [(lengths().as_ref(), 162, 500), (platform().as_ref(), 42, 500), (&all, 42, 500), (&closure, 42, 200)]
    {
        let settings = hull::Settings { rays, probes, ..hull::Settings::new(&bounds) };
        let judged = Judged(criterion);
        let solve = |criterion: &dyn Criterion| {
            let region = Region::new(&model, criterion, &upright()).unwrap();
            let center = region.point(&home);
            hull::solve(&region, &bounds, &center, &settings).unwrap()
        };
        let (exact, bisected) = (solve(criterion), solve(&judged));
        assert_eq!(exact.points, rays as u64);
        let apart = exact.radii.iter().zip(&bisected.radii).filter(|(a, b)| (*a - *b).abs() > 2.0 * settings.tolerance);
        // a probe every 5 mm steps over what a ray but grazes
        assert!(apart.count() <= 2, "{}", criterion.name());
        assert!(
            (exact.left_out - bisected.left_out).abs() < 0.02 * bisected.left_out + 0.05,
            "{} {}",
            exact.left_out,
            bisected.left_out
        );
        assert_eq!(exact.is_star_shaped(), bisected.is_star_shaped());
    }
}

/// The simulator with 500 kg and 1 to 9 kN.
#[test]
fn the_surface_of_a_real_workspace_is_closed_and_holds_its_volume() {
    let model = standard("cablerobot-simulator-icosahedron");
    let limits = Limits::of(model.robot(), Some(1000.0), Some(9000.0)).unwrap();
    let criterion = WrenchFeasible::new(&model, &Load::of(model.robot()).unwrap(), &limits).unwrap();
    let region = Region::new(&model, &criterion, &upright()).unwrap();
    let bounds = Bounds::around(&model).unwrap();
    for (size, bound, mesh) in both(&region, &bounds, 0.4) {
        println!("{size} ± {bound}, mesh {}, {} triangles", mesh.volume(), mesh.triangles.len());
        assert!(mesh.is_closed());
        assert!((mesh.volume() - size).abs() < bound, "{} {size} ± {bound}", mesh.volume());
        let cables = &mesh.fields[1].values;
        assert!(cables.iter().filter(|cable| (1.0..=8.0).contains(*cable)).count() * 10 > cables.len() * 9);
        assert!(mesh.fields[0].values.iter().filter(|margin| **margin >= 0.0).count() * 100 > cables.len() * 99);
    }
}

#[test]
fn the_area_of_a_planar_robot_is_a_flat_mesh_of_that_size() {
    let model = standard("planar-example");
    let load = Load::of(model.robot()).unwrap();
    let criterion = WrenchFeasible::new(&model, &load, &Limits::of(model.robot(), None, None).unwrap()).unwrap();
    let region = Region::new(&model, &criterion, &upright()).unwrap();
    let bounds = Bounds::new(2, &[-6.4, 5.5, -0.5, 8.5]).unwrap();
    for (size, bound, mesh) in both(&region, &bounds, 0.1) {
        println!("{size} ± {bound}, mesh {}", mesh.area());
        assert!((mesh.area() - size).abs() < bound && (mesh.area() - 71.15).abs() < 0.05, "{}", mesh.area());
        assert!(mesh.fields[0].values.iter().all(|margin| *margin >= 0.0));
    }
}
