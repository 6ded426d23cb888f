//! Laws that workspaces of robots obey when sizes, limits and orientations change.

use super::support::random_direction;
use super::workspace_properties::{feasible, standard, upright};
use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{Cable, Robot};
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_workspace::criterion::WrenchFeasible;
use cdpr_workspace::grid::{self, Count, Grid};
use cdpr_workspace::{Archetype, Bounds, Criterion, Region};
use nalgebra::{UnitQuaternion, Vector3};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Twice the robot with four times the tensions and load: the same set of twice the size, cell by cell.
#[test]
fn scaling_robot_limits_and_load_scales_the_answer() {
    for name in ["planar-example", "cablerobot-simulator-icosahedron"] {
        let model = standard(name);
        let mut robot = model.robot().clone();
        for cable in &mut robot.cables {
            cable.frame_anchor *= 2.0;
            cable.platform_anchor *= 2.0;
        }
        let large = Model::new(robot, Composition::STANDARD).unwrap();
        let m = model.cable_count();
        let wrench = Wrench::new(100.0, -1962.0, -2000.0, 300.0, 0.0, 0.0);
        let mut larger = wrench * 4.0;
        (3..6).for_each(|row| larger[row] *= 2.0);
        let [small, large] =
            [(&model, 1.0, wrench, 1000.0), (&large, 2.0, larger, 4000.0)].map(|(model, scale, wrench, force)| {
                let limits = Limits::uniform(m, force, 8.0 * force).unwrap();
                let criterion = WrenchFeasible::new(model, &Load::constant(wrench), &limits).unwrap();
                let region = Region::new(model, &criterion, &upright()).unwrap();
                let ends: Vec<f64> =
                    Bounds::around(&standard(name)).unwrap().ends().iter().map(|end| end * scale).collect();
                let bounds = Bounds::new(region.dimension(), &ends).unwrap();
                let cells = Grid::new(&bounds, 0.5 * scale).unwrap();
                let count = grid::count(&region, &cells);
                let margin =
                    criterion.judge(&Pose { position: model.robot().cables[0].frame_anchor * 0.3, ..Pose::identity() });
                (count.points, count.feasible_points, count.outcome(&cells).size, margin.margin)
            });
        println!("{name}: {small:?} {large:?}");
        assert!(small.1 > 0);
        // a power of two changes no bit of a mantissa
        assert_eq!((small.0, small.1), (large.0, large.1));
        let factor = if name == "planar-example" { 4.0 } else { 8.0 };
        assert_eq!(small.2 * factor, large.2);
        assert!((small.3 * 4.0 / large.3 - 1.0).abs() < 1e-9, "{} {}", small.3, large.3);
    }
}

/// A cable that may be slack can only help: whatever was feasible without it is so with it.
#[test]
fn a_cable_with_zero_minimum_tension_never_shrinks_the_workspace() {
    let mut rng = ChaCha8Rng::seed_from_u64(6);
    for name in ["planar-example", "cablerobot-simulator-icosahedron", "cogiro"] {
        let model = standard(name);
        let load = Load::of(model.robot()).unwrap();
        let limits = Limits::of(model.robot(), None, None).unwrap();
        for _ in 0..5 {
            let mut robot: Robot = model.robot().clone();
            let anchor = &robot.cables[0];
            let added =
                Cable { frame_anchor: anchor.frame_anchor + random_direction(&mut rng) * 3.0, ..anchor.clone() };
            robot.cables.push(added);
            let more = Model::new(robot, Composition::STANDARD).unwrap();
            let with = |list: &[f64], last: f64| [list, &[last]].concat();
            let wider = Limits::new(with(limits.minimum(), 0.0), with(limits.maximum(), 5000.0)).unwrap();
            let before = WrenchFeasible::new(&model, &load, &limits).unwrap();
            let after = WrenchFeasible::new(&more, &load, &wider).unwrap();
            let home = model.robot().home.unwrap().position;
            for _ in 0..200 {
                let position = home + random_direction(&mut rng) * 4.0;
                // planar robots stay in their plane
                let position = model.axes().iter().map(|axis| axis * axis.dot(&position)).sum();
                let pose = Pose { position, ..Pose::identity() };
                assert!(!before.holds(&pose) || after.holds(&pose), "{name} {pose:?}");
            }
        }
    }
}

/// Every orientation is harder than one of them, and one of them than some one.
#[test]
fn total_orientation_lies_in_constant_orientation_and_that_in_inclusion_orientation() {
    let model = standard("cablerobot-simulator-icosahedron");
    let criterion = feasible(&model);
    let turn = |angle: f64| UnitQuaternion::new(Vector3::y() * angle);
    let set: Vec<_> = [-0.2, 0.0, 0.2].map(turn).to_vec();
    let archetypes = [
        Archetype::Dextrous { besides: UnitQuaternion::identity(), orientations: 20 },
        Archetype::TotalOrientation(set.clone()),
        upright(),
        Archetype::InclusionOrientation(set),
    ];
    let cells = Grid::new(&Bounds::around(&model).unwrap(), 0.8).unwrap();
    let counts = archetypes.map(|archetype| {
        let region = Region::new(&model, &criterion, &archetype).unwrap();
        let mut answers = Vec::new();
        let mut count = Count::new();
        while count.advance(&region, &cells, &mut |_, slab| answers.extend_from_slice(slab)) {}
        answers
    });
    let sum = |answers: &[bool]| answers.iter().filter(|holds| **holds).count();
    println!("{:?}", counts.each_ref().map(|answers| sum(answers)));
    for pair in counts.windows(2).skip(1) {
        assert!(pair[0].iter().zip(&pair[1]).all(|(less, more)| !less || *more));
        assert!(sum(&pair[0]) < sum(&pair[1]));
    }
    assert_eq!(sum(&counts[0]), 0, "no platform of this kind turns all the way round");
}
