//! Sizes of the workspaces of random robots lie within the bounds that grid, octree and hull state, thin sets and empty ones too.

use cdpr_model::geometry::{MotionPattern, Wrench};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{Cable, Robot};
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_workspace::criterion::WrenchFeasible;
use cdpr_workspace::hull::{self, Center};
use cdpr_workspace::refine::{ByGrid, ByHull, ByOctree, Goal, RegionSearch, refine};
use cdpr_workspace::{Archetype, Bounds, Point, Region};
use nalgebra::{UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::support::{builtin, random_direction};
use cdpr_testing::property::seeds;

/// A robot with anchors anywhere on or in a box, and a load and limits that may leave much or nothing.
struct Random {
    model: Model,
    load: Load,
    limits: Limits,
    rotation: UnitQuaternion<f64>,
}

impl Random {
    fn draw(rng: &mut ChaCha8Rng) -> Self {
        let patterns = [
            (MotionPattern::PlanarPoint, 3..=5),
            (MotionPattern::Planar, 3..=6),
            (MotionPattern::SpatialPoint, 3..=6),
            (MotionPattern::Spatial, 6..=9),
        ];
        let (pattern, counts) = patterns[rng.random_range(0..4)].clone();
        let cables = rng.random_range(counts);
        let sides = Vector3::from_fn(|_, _| rng.random_range(1.0..12.0));
        let is_hanging = rng.random_bool(0.3);
        let is_planar = matches!(pattern, MotionPattern::PlanarPoint | MotionPattern::Planar);
        let top = if is_planar { 1 } else { 2 };
        let mut robot: Robot = builtin(if is_planar { "planar-example" } else { "cablerobot-simulator-icosahedron" });
        let size = rng.random_range(0.02..0.2) * sides.min();
        let cable = |rng: &mut ChaCha8Rng| {
            let mut a = Vector3::from_fn(|axis, _| {
                let fraction = if rng.random_bool(0.7) { rng.random_range(0..2) as f64 } else { rng.random::<f64>() };
                sides[axis] * fraction
            });
            if is_hanging {
                a[top] = sides[top] * rng.random_range(0.9..1.0);
            }
            let mut b = random_direction(rng) * size;
            if pattern == MotionPattern::PlanarPoint || pattern == MotionPattern::SpatialPoint {
                b = Vector3::zeros();
            }
            if is_planar {
                (a.z, b.z) = (0.0, 0.0);
            }
            Cable { frame_anchor: a, platform_anchor: b, ..Cable::default() }
        };
        robot.cables = loop {
            let drawn: Vec<Cable> = (0..cables).map(|_| cable(rng)).collect();
            // frame anchors that are one point have no box around them
            if drawn.iter().any(|cable| cable.frame_anchor != drawn[0].frame_anchor) {
                break drawn;
            }
        };
        robot.motion_pattern = pattern;
        (robot.home, robot.travel) = (None, None);
        let mut down = Vector3::zeros();
        down[top] = -9.81;
        robot.gravity = Some(down);
        let model = Model::new(robot, Composition::STANDARD).unwrap();
        let mut wrench = Wrench::zeros();
        (0..3).for_each(|axis| wrench[axis] = 100.0 * down[axis] / 9.81);
        wrench[0] += rng.random_range(-30.0..30.0);
        let least = [0.0, 1.0, 10.0, 50.0][rng.random_range(0..4)];
        let limits = Limits::uniform(cables, least, least + 10_f64.powf(rng.random_range(1.5..3.5))).unwrap();
        let rotation = match pattern {
            MotionPattern::Planar => UnitQuaternion::new(Vector3::z() * rng.random_range(-0.3..0.3)),
            MotionPattern::Spatial => UnitQuaternion::new(random_direction(rng) * rng.random_range(0.0..0.3)),
            _ => UnitQuaternion::identity(),
        };
        Self { model, load: Load::constant(wrench), limits, rotation }
    }
}

/// Size by independent points, and how far that may be off: five standard deviations and eight points.
fn oracle(region: &Region<'_>, bounds: &Bounds, rng: &mut ChaCha8Rng, points: usize) -> [f64; 2] {
    let draw = |rng: &mut ChaCha8Rng| -> Point {
        [0, 1, 2].map(|axis| bounds.least()[axis] + rng.random::<f64>() * bounds.extent(axis))
    };
    let drawn: Vec<Point> = (0..points).map(|_| draw(rng)).collect();
    let mut answers = vec![false; points];
    region.holds_all(&drawn, &mut answers);
    let (count, all) = (answers.iter().filter(|holds| **holds).count() as f64, points as f64);
    let away = 5.0 * (count * (1.0 - count / all)).sqrt() + 8.0;
    [count, away].map(|number| number / all * bounds.size())
}

#[derive(Debug, Default)]
struct Tally {
    robots: usize,
    without: usize,
    small: usize,
    outside: Vec<String>,
}

/// Measures random robots by one method and compares with the oracle.
fn measure<S: RegionSearch>(
    region: &Region<'_>,
    bounds: &Bounds,
    goal: &Goal,
    (mut search, tally): (S, &mut Tally),
    [truth, away]: [f64; 2],
) where
    S::Error: std::fmt::Debug,
{
    tally.robots += 1;
    let refined = refine(region, bounds, goal, &mut search).unwrap();
    let Some(size) = search.judged(&refined.found).1 else {
        tally.without += 1;
        return;
    };
    let bound = refined.audit.error_bound();
    tally.small += usize::from(bound <= goal.fraction * size);
    if (size - truth).abs() > bound + away {
        tally.outside.push(format!("{size} ± {bound}, by independent points {truth} ± {away}"));
    }
}

/// Grid, octree and hull of so many robots, with the defaults of the command but for so much effort.
fn tallies(seed: u64, robots: usize, effort: f64, points: usize) -> [Tally; 3] {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let [mut grids, mut octrees, mut hulls] = [(); 3].map(|()| Tally::default());
    for _ in 0..robots {
        let random = Random::draw(&mut rng);
        let criterion = WrenchFeasible::new(&random.model, &random.load, &random.limits).unwrap();
        let archetype = Archetype::ConstantOrientation(random.rotation);
        let region = &Region::new(&random.model, &criterion, &archetype).unwrap();
        let bounds = &Bounds::around(&random.model).unwrap();
        let truth = oracle(region, bounds, &mut rng, points);
        let (goal, step) = (Goal { effort, ..Goal::usual() }, bounds.usual_step());
        measure(region, bounds, &goal, (ByGrid { region, bounds, step }, &mut grids), truth);
        measure(region, bounds, &goal, (ByOctree { region, bounds, step }, &mut octrees), truth);
        match hull::find_center(region, bounds, (0.5 * goal.poses(region)) as u64).unwrap() {
            Center::At(center) => {
                let settings = hull::Settings::within(bounds, goal.poses(region));
                measure(region, bounds, &goal, (ByHull { region, bounds, center, settings }, &mut hulls), truth);
            }
            Center::Nowhere(audit) if truth[0] - truth[1] > audit.error_bound() => {
                hulls.outside.push(format!("nothing ± {}, by independent points {truth:?}", audit.error_bound()));
            }
            Center::Nowhere(_) => hulls.without += 1,
        }
    }
    println!("seed {seed}");
    for (name, tally) in [("grid", &grids), ("octree", &octrees), ("hull", &hulls)] {
        println!("{name}: {tally:?}");
    }
    [grids, octrees, hulls]
}

/// Bounds hold with 99.9 %: of fewer than fifty robots none may lie outside; of the many of a soak one in fifty, which chance gives to
/// one round in some hundred at most.
#[test]
fn sizes_of_random_robots_lie_within_their_bounds() {
    let seeds = seeds(16);
    let robots = (seeds.end - seeds.start) as usize;
    for tally in tallies(15 + seeds.start, robots, 6e4, 30_000) {
        assert!(tally.outside.len() <= robots / 50, "{:?}", tally.outside);
    }
}
