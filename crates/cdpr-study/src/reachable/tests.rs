use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::sensitivity::{Kind, ParameterDeviation, Side};
use cdpr_model::control::Initial;
use cdpr_model::control::winch_offsets;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{ParameterKind, Robot};
use cdpr_model::statics::Load;
use cdpr_workspace::criterion::WrenchFeasible;
use cdpr_workspace::grid::{self, Grid};
use cdpr_workspace::{Archetype, Bounds, components, hull};

/// The planar example of sec. 3.6 with the initial tensions of eq. 3.41.
struct Planar {
    control: Model,
    machine: Model,
    offsets: Vec<f64>,
    limits: Limits,
}

impl Planar {
    fn new() -> Self {
        let robot = Robot::builtin("planar-example").unwrap();
        let control = Model::new(robot.clone(), Composition::STANDARD).unwrap();
        let machine = Model::new(robot.clone(), Composition::ELASTIC).unwrap();
        let initial: Initial = toml::from_str("pose = [0, 5.2]\ntension_method = \"closed-form\"").unwrap();
        let pose = robot.motion_pattern.pose(robot.plane, &initial.pose).unwrap();
        let offsets = winch_offsets(&initial, &control, &machine, &pose).unwrap();
        let limits = Limits::of(&robot, Some(1000.0), Some(8000.0)).unwrap();
        Self { control, machine, offsets, limits }
    }

    fn reachable(&self, position_error_max: Option<f64>) -> Reachable {
        let requirements =
            Requirements { tensions: Some(self.limits.clone()), position_error_max, ..Requirements::default() };
        Reachable::new(self.driving(&self.machine), requirements).unwrap()
    }

    fn driving<'m>(&'m self, machine: &'m Model) -> Driving {
        Driving::new(&self.control, machine, &self.offsets).unwrap()
    }

    fn region<'c>(&self, criterion: &'c dyn Criterion) -> Region<'c> {
        let upright = Archetype::ConstantOrientation(nalgebra::UnitQuaternion::identity());
        Region::new(&self.machine, criterion, &upright).unwrap()
    }
}

fn box_of_the_example() -> Bounds {
    Bounds::new(2, &[-6.0, 6.0, -1.0, 9.0]).unwrap()
}

/// maths.md, sec. 4: 71.15 m² physical, 51.8 m² reachable (72.8 %) without a limit of the error.
///
/// Cells of 5 cm: the boundary is 30 m long, so that chance alone causes about 0.02 m²; the reference has three digits.
#[test]
fn the_planar_example_reaches_less_than_three_quarters_of_its_physical_workspace() {
    let planar = Planar::new();
    let grid = Grid::new(&box_of_the_example(), 0.05).unwrap();
    let reachable = planar.reachable(None);
    let physical =
        WrenchFeasible::new(&planar.machine, &Load::of(planar.machine.robot()).unwrap(), &planar.limits).unwrap();
    let size = |criterion: &dyn Criterion| grid::count(&planar.region(criterion), &grid).outcome(&grid).size;
    let (reached, whole) = (size(&reachable), size(&physical));
    assert!((whole - 71.15).abs() < 0.1, "{whole}");
    assert!((reached - 51.8).abs() < 0.1, "{reached}");
    assert!((reached / whole - 0.728).abs() < 2e-3);
}

#[test]
fn hull_and_grid_agree_and_the_image_of_the_hull_has_the_size_that_stretches_give() {
    let planar = Planar::new();
    let reachable = planar.reachable(None);
    let region = planar.region(&reachable);
    let bounds = box_of_the_example();
    let found = hull::solve(&region, &bounds, &[0.0, 5.2, 0.0], &hull::Settings::new(&bounds)).unwrap();
    assert!(found.is_star_shaped());
    let size = found.measure().unwrap().size;
    let grid = Grid::new(&bounds, 0.05).unwrap();
    let answers = Census::take(&reachable, &region, &grid).reached(None);
    let reached = answers.iter().enumerate().filter(|(_, held)| **held);
    let cells: Vec<_> = reached.map(|(cell, _)| (cell / grid.slab_points(), cell % grid.slab_points())).collect();
    let outcome = grid::outcome(&grid, &answers);
    assert_eq!(outcome, grid::count(&region, &grid).outcome(&grid));
    let counted = outcome.size;
    // 360 chords of a boundary with corners, and cells of 5 cm
    assert!((size / counted - 1.0).abs() < 3e-3, "{size} {counted}");
    // near the anchors lie slivers of a few cells
    let parts = components(&grid, &answers);
    assert!(parts[0].size > 0.99 * counted && parts.len() > 1, "{parts:?}");
    let image = image_of(&reachable, &region, &found).unwrap();
    let emerging = emerging_size(&reachable, &region, &grid, &cells);
    // determinants from differences over 2.5 cm of fields that vary over metres
    assert!((image.size - size - (emerging - counted)).abs() < 0.05, "{} {size} {emerging} {counted}", image.size);
    assert!((image.size - size).abs() > 0.01, "emerging and commanded poses shall differ");
}

/// A tighter error bound only removes poses, and each reason names the broken requirement.
#[test]
fn reasons_name_the_requirement_that_is_broken() {
    let planar = Planar::new();
    let at = |x: f64, y: f64| planar.region(&planar.reachable(Some(0.005))).judge(&[x, y, 0.0]);
    assert!(at(0.0, 5.2).holds());
    let verdict = at(1.5, 4.0);
    assert!(
        verdict.reason.as_ref().unwrap().contains("mm beside the commanded position, 5.000 mm are allowed"),
        "{verdict:?}"
    );
    let verdict = planar.region(&planar.reachable(None)).judge(&[-4.5, 6.9, 0.0]);
    assert!(verdict.reason.as_ref().is_some_and(|reason| reason.contains("tension of")), "{verdict:?}");
    assert!(verdict.cable.is_some());
}

/// The rates of the planar example's hull by an anchor of the machine, by one of the control model, by a stiffness and
/// by a winch offset, against hulls computed again with a change that moves the boundary by about a millimetre: the
/// second order is below a hundredth of that.
#[test]
fn the_differential_hull_is_that_of_small_changes() {
    let planar = Planar::new();
    let reachable = planar.reachable(None);
    let region = planar.region(&reachable);
    let bounds = box_of_the_example();
    let settings = hull::Settings { rays: 60, tolerance: 1e-9, ..hull::Settings::new(&bounds) };
    let center = [0.0, 5.2, 0.0];
    let nominal = hull::solve(&region, &bounds, &center, &settings).unwrap();
    for (side, kind, change) in [
        (Side::Machine, Kind::Parameter(ParameterKind::FrameAnchor), 1e-4),
        (Side::Control, Kind::Parameter(ParameterKind::FrameAnchor), 1e-4),
        (Side::Machine, Kind::Parameter(ParameterKind::AxialStiffness), 1e-3),
        (Side::Winches, Kind::WinchOffset, 1e-4),
    ] {
        let cause = ParameterDeviation { side, kind, cable: 0, axis: 0 };
        let moved = differential_hull(&reachable, &region, &nominal, &cause).unwrap();
        let by = |change: f64| {
            let varied = Varied::new(&reachable, &cause, change).unwrap();
            let criterion = varied.reachable().unwrap();
            hull::solve(&region.with_criterion(&criterion), &bounds, &center, &settings).unwrap().radii
        };
        let (less, more) = (by(-change), by(change));
        let mut compared = 0;
        for (ray, rate) in moved.rates.iter().enumerate().filter_map(|(ray, rate)| Some((ray, (*rate)?))) {
            let slope = (more[ray] - less[ray]) / (2.0 * change);
            // where another cable becomes the limiting one within the change, the boundary has a corner
            compared += usize::from((slope - rate).abs() < 0.01 * (1.0 + rate.abs()));
        }
        assert!(compared >= 57, "{side:?} {kind:?}: {compared}");
        assert!(moved.rates.iter().flatten().any(|rate| rate.abs() > 0.01), "{side:?} {kind:?}");
    }
    let cause = ParameterDeviation { side: Side::Winches, kind: Kind::InitialTension, cable: 0, axis: 0 };
    let refused = differential_hull(&reachable, &region, &nominal, &cause);
    assert_eq!(refused.err(), Some(InputError::TensionsVaryTogether));
}

/// Batches agree with single poses, in a box far larger than the frame, where most cables hang slack.
#[test]
fn many_poses_are_reached_where_each_is() {
    let control =
        Model::new(Robot::builtin("cablerobot-simulator-helicopter").unwrap(), Composition::STANDARD).unwrap();
    let elastic = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let machine = Model::new(elastic, Composition::ELASTIC).unwrap();
    let limits = Limits::of(machine.robot(), None, None).unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(93);
    let poses: Vec<Pose> = (0..1500)
        .map(|_| {
            let position = Vector3::new(6.0, 6.0, 4.0).map(|half: f64| rng.random_range(-half..half));
            Pose { position: position + Vector3::new(0.0, 0.0, 2.5), ..Pose::identity() }
        })
        .collect();
    for tensions in [None, Some(limits)] {
        let requirements = Requirements { tensions, position_error_max: Some(0.05), ..Requirements::default() };
        let driving = Driving::new(&control, &machine, &[0.0; 8]).unwrap();
        let reachable = Reachable::new(driving, requirements).unwrap();
        let mut answers = vec![false; poses.len()];
        reachable.holds_all(&poses, &mut answers);
        for (pose, answer) in poses.iter().zip(&answers) {
            assert_eq!(reachable.judge(pose).holds(), *answer, "{pose:?}");
        }
        let reached = answers.iter().filter(|answer| **answer).count();
        assert!((5..1000).contains(&reached), "{reached}");
    }
}

/// Batches against poses commanded one by one: the same cells, and errors equal to the pose tolerance of the forward
/// problem.
#[test]
fn a_census_says_of_every_cell_what_its_pose_says_alone() {
    let nominal = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let elastic = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let control = Model::new(nominal, Composition::STANDARD).unwrap();
    let machine = Model::new(elastic, Composition::ELASTIC).unwrap();
    let limits = Limits::of(machine.robot(), None, None).unwrap();
    let grid = Grid::new(&Bounds::new(3, &[-6.0, 6.0, -6.0, 6.0, 0.0, 6.0]).unwrap(), 1.0).unwrap();
    for tensions in [None, Some(limits)] {
        let requirements = Requirements { tensions, position_error_max: Some(0.06), ..Requirements::default() };
        let driving = Driving::new(&control, &machine, &[0.0; 8]).unwrap();
        let reachable = Reachable::new(driving, requirements).unwrap();
        let level = Archetype::ConstantOrientation(nalgebra::UnitQuaternion::identity());
        let region = Region::new(&machine, &reachable, &level).unwrap();
        let census = Census::take(&reachable, &region, &grid);
        let mut reached = 0;
        for (cell, is_reached) in census.reached(Some(0.06)).into_iter().enumerate() {
            let point = grid.point(cell / grid.slab_points(), cell % grid.slab_points());
            let pose = Pose { position: region.position(&point), ..Pose::identity() };
            assert_eq!(reachable.judge(&pose).holds(), is_reached, "{point:?}");
            reached += usize::from(is_reached);
            let outcome = reachable.driving().outcome(&pose);
            let (error, found) = ((outcome.pose.position - pose.position).norm(), census.cells[cell].position_error);
            let is_skipped = reachable.needs_all_taut() && found.is_infinite() && !is_reached;
            let is_lost = outcome.status != Status::Converged && found.is_infinite();
            assert!(is_lost || is_skipped || (found - error).abs() < 1e-9, "{point:?}: {found} {error}");
        }
        assert!((5..800).contains(&reached), "{reached}");
    }
}

#[test]
fn requirements_that_ask_for_nothing_are_refused() {
    let planar = Planar::new();
    let new = |machine, requirements| Reachable::new(planar.driving(machine), requirements).err();
    assert_eq!(new(&planar.machine, Requirements::default()), Some(InputError::NoRequirement { is_elastic: true }));
    let tensions = Requirements { tensions: Some(planar.limits.clone()), ..Requirements::default() };
    assert_eq!(new(&planar.control, tensions), Some(InputError::NoRequirement { is_elastic: false }));
}
