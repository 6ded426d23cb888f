use nalgebra::{UnitQuaternion, Vector3};

use super::demand::Demand;
use super::face::Place;
use super::*;
use crate::{Bounds, Point, WorkspaceError};
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;

const G: f64 = 10.0;

fn asked<'a>(model: &'a Model, place: f64) -> Capability<'a> {
    let (load, limits) = (Load::of(model.robot()).unwrap(), Limits::of(model.robot(), None, None).unwrap());
    let rotation = model.robot().home_or_middle().rotation;
    Capability::new(model, &load, &limits, rotation, place).unwrap()
}

fn found(solution: &Solution, quantity: Quantity) -> &Found {
    solution.found.iter().find(|found| found.quantity == quantity).unwrap()
}

fn model(text: &str) -> Model {
    Model::new(Robot::from_toml(text, "test.toml").unwrap(), "standard".parse().unwrap()).unwrap()
}

/// A mass of 10 kg in a plane on two cables from (∓2, 3), that hold 0 to 1000 N.
const TWO_CABLES: &str = r#"
layout_version = 1
name = "two"
motion_pattern = "2T"
axes = "xz"
gravity_m_s2 = [0.0, -10.0]
[platform]
mass_kg = 10.0
[cable_defaults]
tension_min_N = 0.0
tension_max_N = 1000.0
speed_max_m_s = 2.0
[[cable]]
name = "left"
frame_anchor_m = [-2.0, 3.0]
[[cable]]
name = "right"
frame_anchor_m = [2.0, 3.0]
motor_speed_max_rad_per_s = 150.0
gear_ratio = 10.0
drum_radius_m = 0.1
"#;

/// With two cables the balance has one solution, f₁ = m g sin β/sin(α + β) by the angles to the vertical: the payload is
/// what the larger one reaches, the acceleration the least distance of the load to the sides of the parallelogram.
#[test]
fn two_cables_in_a_plane_have_closed_forms() {
    let model = model(TWO_CABLES);
    let asked = asked(&model, 0.0);
    let at = |x: f64, z: f64| {
        let normals =
            [(-2.0 - x, 3.0 - z), (2.0 - x, 3.0 - z)].map(|(a, b)| (a / f64::hypot(a, b), b / f64::hypot(a, b)));
        let [(ax, az), (bx, bz)] = normals;
        let turn = ax * bz - az * bx;
        // tensions of a force (fx, fz) that the cables give
        let tensions = |fx: f64, fz: f64| [(fx * bz - fz * bx) / turn, (ax * fz - az * fx) / turn];
        let per_kg = tensions(0.0, G);
        let payload = per_kg.iter().map(|f| 1000.0 / f).fold(f64::INFINITY, f64::min) - 10.0;
        let own = per_kg.map(|f| 10.0 * f);
        // distance of a side from the load: the change of a tension by the other cable's direction
        let room = own.iter().map(|f| f.min(1000.0 - f)).fold(f64::INFINITY, f64::min);
        (payload, room * turn.abs() / 10.0)
    };
    for (x, z) in [(0.0, 0.0), (0.7, 1.2), (-1.1, -2.0)] {
        let values = asked.values(&[x, z, 0.0]).unwrap();
        let (payload, ball) = at(x, z);
        assert!((values[0] - payload).abs() < 1e-9 * payload, "{values:?} {payload}");
        assert!((values[1] - ball).abs() < 1e-9 * ball, "{values:?} {ball}");
        assert!(values[1] <= values[2] + 1e-12 && values[1] <= values[3] + 1e-12, "{values:?}");
    }
    // the payload is least where the cables are flattest or steepest: a corner of the box
    let solution = asked.solve(&Bounds::new(2, &[-1.0, 1.0, 0.0, 2.0]).unwrap(), &Settings::default()).unwrap();
    assert_eq!(solution.status, Status::Found);
    let least = |of: &dyn Fn(f64, f64) -> f64| {
        let grid = (0..=200).flat_map(|i| (0..=200).map(move |j| (i, j)));
        grid.map(|(i, j)| of(-1.0 + f64::from(i) * 0.01, f64::from(j) * 0.01)).fold(f64::INFINITY, f64::min)
    };
    for (quantity, dense) in
        [(Quantity::Payload, least(&|x, z| at(x, z).0)), (Quantity::Acceleration, least(&|x, z| at(x, z).1))]
    {
        let found = found(&solution, quantity);
        assert!(found.at_least <= dense && dense <= found.value * (1.0 + 1e-3), "{found:?} {dense}");
        assert!(found.gap() <= 0.01 && found.value <= dense * (1.0 + 1e-9), "{found:?} {dense}");
    }
    // 150 rad/s through the gear on the drum are 1.5 m/s, of any direction the one along the cable first
    let speed = found(&solution, Quantity::Speed);
    assert!((speed.value - 1.5).abs() < 1e-12 && speed.gap() < 1e-12);
    assert_eq!((speed.limited_by.limit, speed.limited_by.cable), (Limit::DriveSpeed, Some(1)));
}

/// A point mass below the middle of four ceiling cables: by symmetry all four pull alike, m g = 4 f_max cos γ.
#[test]
fn a_point_on_four_ceiling_cables_lifts_what_symmetry_says() {
    let mut text = r#"
layout_version = 1
name = "four"
motion_pattern = "3T"
gravity_m_s2 = [0.0, 0.0, -10.0]
[platform]
mass_kg = 5.0
[cable_defaults]
tension_min_N = 0.0
tension_max_N = 500.0
"#
    .to_owned();
    for (index, (x, y)) in [(-3, -4), (3, -4), (3, 4), (-3, 4)].into_iter().enumerate() {
        text += &format!("[[cable]]\nname = \"{index}\"\nframe_anchor_m = [{x}.0, {y}.0, 5.0]\n");
    }
    let model = model(&text);
    let asked = asked(&model, 0.0);
    // the anchors are 5 m aside and 5 m above: cos γ = 1/√2
    let values = asked.values(&[0.0; 3]).unwrap();
    assert!((values[0] - (2000.0 / 2.0_f64.sqrt() / G - 5.0)).abs() < 1e-9, "{values:?}");
    // down: gravity alone; that is also the least of the axis z
    assert!((values[4] - G).abs() < 1e-9, "{values:?}");
    let limited = asked.limited_by(4, &[0.0; 3]).unwrap();
    assert!(limited.limit == Limit::Gravity || limited.at_largest.is_empty(), "{limited:?}");
    assert!(asked.absent().iter().map(|absent| absent.quantity).eq([Quantity::Speed]));
    let solution = asked.solve(&Bounds::new(3, &[-1.0, 1.0, -1.0, 1.0, 0.0, 2.0]).unwrap(), &Settings::default());
    let solution = solution.unwrap();
    assert_eq!(solution.status, Status::Found, "{solution:?}");
    // beside a cable's plane nothing holds
    let outside = asked.solve(&Bounds::new(3, &[-4.0, 1.0, -1.0, 1.0, 0.0, 2.0]).unwrap(), &Settings::default());
    let outside = outside.unwrap();
    assert_eq!(outside.status, Status::NotHeld);
    assert_eq!(outside.not_held.unwrap().limited_by.limit, Limit::NoWrenchClosure);
}

/// Of every quantity the value is available at its pose and a little more is not, and the bound holds at random poses.
#[test]
fn at_the_value_tensions_exist_and_a_little_above_they_do_not() {
    use crate::wrench_set::Zonotope;
    use rand::{RngExt, SeedableRng};
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(42);
    let robot = Robot::builtin("cogiro").unwrap();
    let model = Model::new(robot, "standard".parse().unwrap()).unwrap();
    let asked = asked(&model, 0.2);
    let bounds = Bounds::new(3, &[-3.0, 3.0, -2.0, 2.0, 1.0, 3.0]).unwrap();
    let solution = asked.solve(&bounds, &Settings::default()).unwrap();
    assert_eq!(solution.status, Status::Found, "{} poses", solution.poses);
    for (index, found) in solution.found.iter().enumerate() {
        for _ in 0..200 {
            let point = std::array::from_fn(|axis| {
                rng.random_range(bounds.least()[axis]..bounds.least()[axis] + bounds.extent(axis))
            });
            assert!(asked.values(&point).unwrap()[index] >= found.at_least);
        }
        let pose = asked.pose(&found.at);
        let matrix = model.structure_matrix(&pose).unwrap();
        let set = Zonotope::available(&matrix, &asked.limits, &asked.row_lengths).unwrap();
        let demand = &asked.demands[index];
        let wrenches = |size: f64| -> Vec<Vec<f64>> {
            let load = asked.load.wrench(&pose);
            let all: Vec<cdpr_model::geometry::Wrench> = match demand {
                Demand::Payload(weights) => weights.iter().map(|weight| load + weight * size).collect(),
                Demand::Ball { mass, arm, .. } | Demand::Axis { mass, arm, .. } => {
                    let direction: Vector3<f64> = found.limited_by.direction.unwrap();
                    let force = direction * (-mass * size);
                    let moment = arm.cross(&force);
                    let added =
                        cdpr_model::geometry::Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
                    vec![load + added]
                }
                Demand::Speed => Vec::new(),
            };
            all.iter().map(|w| model.twist_basis().iter().map(|twist| twist.dot(w)).collect()).collect()
        };
        let are_available = |size: f64| wrenches(size).iter().all(|wrench| set.contains(wrench));
        assert!(are_available(found.value * (1.0 - 1e-9)) && !are_available(found.value * (1.0 + 1e-6)), "{found:?}");
    }
}

/// Bounds of random cells hold at random points and corners of them, for points and pulleys, turned platforms, fewer and
/// more cables than rows and least tensions above zero; in small cells they are near.
#[test]
fn the_bounds_of_a_cell_hold_everywhere_in_it() {
    use cdpr_model::robot::Pulley;
    use rand::{RngExt, SeedableRng};
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(11);
    let cases = [("cogiro", None, 0.0), ("cogiro", Some(0.2), 0.3), ("cablerobot-simulator-helicopter", None, 0.1)];
    for (name, radius, turn) in cases {
        let mut robot = Robot::builtin(name).unwrap();
        for cable in &mut robot.cables {
            if let Some(radius) = radius {
                cable.pulley = Some(Pulley::Whole { radius, swivel_axis: Vector3::z().into() });
            }
            cable.speed_max = Some(3.0);
        }
        robot.platform.mass = robot.platform.mass.or(Some(100.0));
        robot.platform.center_of_mass = robot.platform.center_of_mass.or(Some(Vector3::new(0.05, 0.0, 0.1)));
        robot.gravity = Some(Vector3::new(0.0, 0.0, -9.81));
        let effects = if radius.is_some() { "pulley" } else { "standard" };
        let model = Model::new(robot, effects.parse().unwrap()).unwrap();
        let (load, home) = (Load::of(model.robot()).unwrap(), model.robot().home_or_middle());
        let limits = Limits::of(model.robot(), None, None).unwrap();
        let rotation = home.rotation * UnitQuaternion::from_euler_angles(turn, 0.0, 0.5 * turn);
        let asked = Capability::new(&model, &load, &limits, rotation, 0.1).unwrap();
        let (mut bounded, mut worst) = (0, f64::INFINITY);
        for round in 0..150 {
            let size = [1.0, 0.3, 0.01][round % 3];
            let center: Point = std::array::from_fn(|axis| home.position[axis] + rng.random_range(-1.0..1.0));
            let half: Point = std::array::from_fn(|_| size * rng.random_range(0.2..1.0));
            let Ok(judged) = asked.judge(&Place { center, half, bounded: u32::MAX }) else { continue };
            for (value, bound) in judged.values.iter().zip(&judged.at_least) {
                assert!(*bound <= value * (1.0 + 1e-12), "{judged:?}");
                bounded += u32::from(bound.is_finite());
                worst = if size == 0.01 { worst.min(bound / value) } else { worst };
            }
            for corner in 0..24 {
                let along = |axis: usize| match corner {
                    0..8 => {
                        if corner & (1 << axis) == 0 {
                            1.0
                        } else {
                            -1.0
                        }
                    }
                    _ => rng.random_range(-1.0..1.0),
                };
                let shares = [0, 1, 2].map(along);
                let point = std::array::from_fn(|axis| center[axis] + half[axis] * shares[axis]);
                let Some(values) = asked.values(&point) else {
                    assert!(judged.at_least[0] == f64::NEG_INFINITY, "{name} {point:?} {judged:?}");
                    continue;
                };
                for (index, (value, bound)) in values.iter().zip(&judged.at_least).enumerate() {
                    assert!(value * (1.0 + 1e-9) >= *bound, "{name} {index} {value} {judged:?} {half:?}");
                }
            }
        }
        assert!(bounded > 100 && worst > 0.8, "{name}: {bounded} {worst}");
    }
}

/// Refuses a negative place, a box of another dimension and settings out of range.
#[test]
fn mistakes_are_refused_in_words() {
    let model = model(TWO_CABLES);
    let (load, limits) = (Load::of(model.robot()).unwrap(), Limits::of(model.robot(), None, None).unwrap());
    let new = |place: f64| Capability::new(&model, &load, &limits, UnitQuaternion::identity(), place);
    assert!(new(-1.0).unwrap_err().to_string().contains("place of the payload is -1"));
    let asked = new(0.0).unwrap();
    let solid = Bounds::new(3, &[0.0, 1.0, 0.0, 1.0, 0.0, 1.0]).unwrap();
    assert!(matches!(asked.solve(&solid, &Settings::default()), Err(WorkspaceError::BoundsCount { .. })));
    let flat = Bounds::new(2, &[0.0, 1.0, 0.0, 1.0]).unwrap();
    assert!(asked.solve(&flat, &Settings { gap: 1.0, poses: 9 }).unwrap_err().to_string().contains("gap is 1"));
    let few = asked.solve(&flat, &Settings { gap: 0.01, poses: 30 }).unwrap();
    assert!(few.status == Status::PosesUsedUp && few.found.iter().all(|found| found.gap() > 0.01));
}
