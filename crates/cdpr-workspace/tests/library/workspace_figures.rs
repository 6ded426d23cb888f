//! Areas and volumes that were published, by every method.

use super::support::builtin;
use cdpr_model::geometry::Wrench;
use cdpr_model::model::{Composition, Model};
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_workspace::criterion::WrenchFeasible;
use cdpr_workspace::grid::{self, Count, Grid};
use cdpr_workspace::{Archetype, Bounds, Region, hull, octree};
use nalgebra::UnitQuaternion;

const UPRIGHT: Archetype =
    Archetype::ConstantOrientation(UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(1.0, 0.0, 0.0, 0.0)));

fn planar() -> (Model, Load, Limits) {
    let model = Model::new(builtin("planar-example"), Composition::STANDARD).unwrap();
    let load = Load::of(model.robot()).unwrap();
    (model, load, Limits::uniform(4, 1000.0, 8000.0).unwrap())
}

/// The CableRobot Simulator with its icosahedron and 500 kg.
fn simulator(largest: f64) -> (Model, Load, Limits) {
    let model = Model::new(builtin("cablerobot-simulator-icosahedron"), Composition::STANDARD).unwrap();
    let load = Load::constant(Wrench::new(0.0, 0.0, -500.0 * 9.81, 0.0, 0.0, 0.0));
    (model, load, Limits::uniform(8, 1000.0, largest).unwrap())
}

/// 71.15 m² within the bounds that each method states, and 69.6 m² inside a polygon of 36 rays (Miermeister 2021, sec. 3.6,
/// as verified).
#[test]
fn grid_octree_and_hull_agree_on_the_area_of_the_planar_example() {
    let (model, load, limits) = planar();
    let criterion = WrenchFeasible::new(&model, &load, &limits).unwrap();
    let region = Region::new(&model, &criterion, &UPRIGHT).unwrap();
    let bounds = Bounds::new(2, &[-6.4, 5.5, -0.5, 8.5]).unwrap();

    let cells = Grid::new(&bounds, 0.05).unwrap();
    let by_grid = grid::count(&region, &cells).outcome(&cells);
    let by_octree = octree::solve(&region, &bounds, &octree::Settings::new(0.02)).unwrap();
    let center = region.point(&model.robot().home.unwrap().position);
    let hull_of = |rays: usize| {
        hull::solve(&region, &bounds, &center, &hull::Settings { rays, ..hull::Settings::new(&bounds) }).unwrap()
    };
    let by_rays = hull_of(360).measure().unwrap();
    println!("{by_grid:?}\n{by_octree:?}\n{by_rays:?}");
    for (size, bound) in [
        (by_grid.size, by_grid.error_bound),
        (by_octree.size, by_octree.error_bound),
        (by_rays.size, by_rays.error_bound),
    ] {
        assert!((size - 71.15).abs() < bound + 0.005, "{size} ± {bound}"); // 71.15 is rounded
        assert!((size - 71.15).abs() < 0.05, "{size}");
    }
    let coarse = hull_of(36);
    let area = coarse.measure().unwrap();
    println!("36 rays: {area:?}");
    assert!((area.size - 69.6).abs() < 0.05 && (area.size - 71.15).abs() < area.error_bound, "{area:?}");
    // the shoelace formula over the outline, which has the hull's corners in order
    let corners = coarse.vertices();
    let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
    let parts: Vec<f64> = edges().map(|(p, q)| 0.5 * (p[0] * q[1] - p[1] * q[0])).collect();
    let outline: f64 = edges().map(|(p, q)| (q[0] - p[0]).hypot(q[1] - p[1])).sum();
    assert!((parts.iter().sum::<f64>() - area.size).abs() < 1e-12 * area.size);
    assert!((outline - area.surface).abs() < 1e-12 * area.surface);
    for axis in 0..2 {
        let moment: f64 = edges().zip(&parts).map(|((p, q), part)| part * (p[axis] + q[axis]) / 3.0).sum();
        assert!((moment / area.size - area.centroid[axis]).abs() < 1e-12);
    }
}

/// 243 m³ with 1 to 9 kN and 338 m³ with 1 to 14 kN, both to 1 %; hulls of 642 rays are 238 and 331 m³.
#[test]
fn the_volumes_of_the_cablerobot_simulator_are_those_published() {
    for (largest, published, coarse) in [(9000.0, 243.0, 238.0), (14000.0, 338.0, 331.0)] {
        let (model, load, limits) = simulator(largest);
        let criterion = WrenchFeasible::new(&model, &load, &limits).unwrap();
        let region = Region::new(&model, &criterion, &UPRIGHT).unwrap();
        let bounds = Bounds::around(&model).unwrap();
        let cells = Grid::new(&bounds, 0.125).unwrap();
        let by_grid = grid::count(&region, &cells).outcome(&cells);
        let center = [0.0, 0.0, 2.5];
        let hull_of = |rays: usize| {
            let settings = hull::Settings { rays, ..hull::Settings::new(&bounds) };
            hull::solve(&region, &bounds, &center, &settings).unwrap().measure().unwrap()
        };
        let (fine, rough) = (hull_of(2562), hull_of(642));
        println!("{largest} N: {by_grid:?}\n{fine:?}\n{rough:?}");
        assert!((by_grid.size / published - 1.0).abs() < 0.01, "{}", by_grid.size);
        assert!((fine.size / by_grid.size - 1.0).abs() < 0.01, "{} {}", fine.size, by_grid.size);
        assert!((fine.size - by_grid.size).abs() < fine.error_bound + by_grid.error_bound);
        // the published center and the turn of its icosphere are not known
        assert!((rough.size / coarse - 1.0).abs() < 0.005, "{}", rough.size);
        assert!(!by_grid.reaches_bounds);
    }
}

/// The data sheet's box of 4 × 5 × 5 m fits into the part above z = −1.3 m to more than 99 %.
#[test]
fn the_box_of_the_data_sheet_fits_into_the_simulator() {
    let (model, load, limits) = simulator(14000.0);
    let criterion = WrenchFeasible::new(&model, &load, &limits).unwrap();
    let region = Region::new(&model, &criterion, &UPRIGHT).unwrap();
    let bounds = Bounds::new(3, &[-5.5, 5.5, -7.0, 8.0, -1.3, 6.7]).unwrap();
    let cells = Grid::new(&bounds, 0.1).unwrap();
    let sums = Sums::of(&region, &cells);
    let sizes = [[40, 50, 50], [50, 40, 50], [50, 50, 40]];
    let best = sizes.map(|size| sums.best_share(size));
    println!("{best:?}");
    assert!(best.into_iter().fold(0.0, f64::max) > 0.99, "{best:?}");
}

/// Numbers of cells that hold between the lower corner of a grid and each of its corners.
struct Sums {
    counts: [usize; 3],
    sums: Vec<u32>,
}

impl Sums {
    fn of(region: &Region<'_>, cells: &Grid) -> Self {
        let counts = cells.counts().map(|count| count + 1);
        let mut sums = Self { counts, sums: vec![0; counts.iter().product()] };
        let row = cells.counts()[0];
        let mut count = Count::new();
        let mut add = |slab: usize, answers: &[bool]| {
            for (index, &holds) in answers.iter().enumerate() {
                let (x, y, z) = (index % row, index / row, slab);
                let before = sums.at([x, y + 1, z + 1])
                    + sums.at([x + 1, y, z + 1])
                    + sums.at([x + 1, y + 1, z])
                    + sums.at([x, y, z]);
                let twice = sums.at([x, y, z + 1]) + sums.at([x, y + 1, z]) + sums.at([x + 1, y, z]);
                let place = sums.place([x + 1, y + 1, z + 1]);
                sums.sums[place] = before + u32::from(holds) - twice;
            }
        };
        while count.advance(region, cells, &mut add) {}
        sums
    }

    fn place(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.counts[1] + y) * self.counts[0] + x
    }

    fn at(&self, node: [usize; 3]) -> u32 {
        self.sums[self.place(node)]
    }

    /// The largest share of a box of so many cells that holds, wherever the box is put.
    fn best_share(&self, size: [usize; 3]) -> f64 {
        let mut most = 0;
        for z in 0..self.counts[2] - size[2] {
            for y in 0..self.counts[1] - size[1] {
                for x in 0..self.counts[0] - size[0] {
                    let [u, v, w] = [x + size[0], y + size[1], z + size[2]];
                    let added = self.at([u, v, w]) + self.at([x, y, w]) + self.at([x, v, z]) + self.at([u, y, z]);
                    let taken = self.at([x, v, w]) + self.at([u, y, w]) + self.at([u, v, z]) + self.at([x, y, z]);
                    most = most.max(added - taken);
                }
            }
        }
        f64::from(most) / size.iter().product::<usize>() as f64
    }
}
