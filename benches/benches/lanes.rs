//! What one formula costs on each vector unit: `cargo bench -p benches --bench lanes`, times are per 1024 poses (so
//! 1 µs means 1 ns per pose) except for the group `dispatch`.

use std::hint::black_box;

use cdpr::scalar::{Kernel, LANES, Lanes, Real, Unit, dispatch, dispatch_narrow, dispatch_on};
use criterion::{BenchmarkGroup, Criterion, measurement::WallTime};

const POSES: usize = 1024;
const CABLES: usize = 8;

/// Eight numbers that start a cache line: no load or store straddles two.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Line([f64; LANES]);

/// One quantity of all poses.
type Column = Vec<Line>;

/// A robot, its poses and room for the answers, quantity by quantity.
struct Batch {
    frame_anchors: [[f64; 3]; CABLES],
    platform_anchors: [[f64; 3]; CABLES],
    /// Position, then the rotation row by row.
    poses: [Column; 12],
    lengths: [Column; CABLES],
}

impl Batch {
    fn new() -> Self {
        let corner = |cable: usize, half: f64| [0, 1, 2].map(|axis| if cable >> axis & 1 == 1 { half } else { -half });
        let mut batch = Self {
            frame_anchors: std::array::from_fn(|cable| corner(cable, 5.0)),
            platform_anchors: std::array::from_fn(|cable| corner(cable, 0.4)),
            poses: std::array::from_fn(|_| vec![Line([0.0; LANES]); POSES / LANES]),
            lengths: std::array::from_fn(|_| vec![Line([0.0; LANES]); POSES / LANES]),
        };
        for pose in 0..POSES {
            let t = pose as f64;
            let (sin, cos) = (0.2 * (0.1 * t).sin()).sin_cos();
            let entries = [t.sin(), (1.3 * t).cos(), (0.7 * t).sin(), cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0];
            for (column, entry) in batch.poses.iter_mut().zip(entries) {
                column[pose / LANES].0[pose % LANES] = entry;
            }
        }
        batch
    }
}

/// `a − r − R b`.
#[inline(always)]
fn cable_vector<T: Real>(pose: &[T; 12], a: [f64; 3], b: [f64; 3]) -> [T; 3] {
    let mut l = [pose[0]; 3];
    for axis in 0..3 {
        let row = &pose[3 + 3 * axis..6 + 3 * axis];
        let rotated = row[0] * l[0].constant(b[0]) + row[1] * l[0].constant(b[1]) + row[2] * l[0].constant(b[2]);
        l[axis] = l[0].constant(a[axis]) - pose[axis] - rotated;
    }
    l
}

/// Length of a straight cable (m).
#[inline(always)]
fn straight<T: Real>(l: [T; 3]) -> T {
    (l[0] * l[0] + l[1] * l[1] + l[2] * l[2]).sqrt()
}

/// Length over a pulley of 0.1 m with a vertical swivel axis (m).
#[inline(always)]
fn over_pulley<T: Real>(l: [T; 3]) -> T {
    let radius = l[0].constant(0.1);
    let height = -l[2];
    let h = (l[0] * l[0] + l[1] * l[1]).sqrt() - radius;
    let free = (h * h + (height * height - radius * radius)).sqrt();
    free + radius * (free * h + radius * height).full_angle(free * height - radius * h)
}

/// Inverse kinematics of the batch with `PULLEYS` or without, in lanes.
struct Lengths<'a, const PULLEYS: bool>(&'a mut Batch);

impl<const PULLEYS: bool> Kernel for Lengths<'_, PULLEYS> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let batch = self.0;
        for chunk in 0..POSES / LANES {
            let mut pose = [lanes; 12];
            for entry in 0..12 {
                pose[entry] = lanes.load(&batch.poses[entry][chunk].0);
            }
            for cable in 0..CABLES {
                let l = cable_vector(&pose, batch.frame_anchors[cable], batch.platform_anchors[cable]);
                let length = if PULLEYS { over_pulley(l) } else { straight(l) };
                length.store(&mut batch.lengths[cable][chunk].0);
            }
        }
    }
}

/// The same in plain numbers, pose by pose.
fn lengths_one_by_one<const PULLEYS: bool>(batch: &mut Batch) {
    for pose in 0..POSES {
        let (chunk, lane) = (pose / LANES, pose % LANES);
        let mut entries = [0.0; 12];
        for entry in 0..12 {
            entries[entry] = batch.poses[entry][chunk].0[lane];
        }
        for cable in 0..CABLES {
            let l = cable_vector(&entries, batch.frame_anchors[cable], batch.platform_anchors[cable]);
            batch.lengths[cable][chunk].0[lane] = if PULLEYS { over_pulley(l) } else { straight(l) };
        }
    }
}

/// One group of inverse kinematics: plain numbers, then every unit of the machine.
fn inverse_kinematics<const PULLEYS: bool>(mut group: BenchmarkGroup<'_, WallTime>) {
    let mut batch = Batch::new();
    group.bench_function("f64", |bencher| bencher.iter(|| lengths_one_by_one::<PULLEYS>(black_box(&mut batch))));
    for unit in Unit::available() {
        group.bench_function(format!("{unit:?}"), |bencher| {
            bencher.iter(|| dispatch_on(unit, Lengths::<PULLEYS>(black_box(&mut batch))));
        });
    }
}

/// Length of one cable vector: next to nothing, so that the dispatch itself is what is measured.
struct Single([f64; 8]);

impl Kernel for Single {
    type Output = f64;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> f64 {
        let values = lanes.load(&self.0);
        (values * values).sum()
    }
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    inverse_kinematics::<false>(criterion.benchmark_group("inverse kinematics"));
    inverse_kinematics::<true>(criterion.benchmark_group("inverse kinematics with pulleys"));
    let mut group = criterion.benchmark_group("dispatch");
    let values = [1.0; LANES];
    group.bench_function("widest", |bencher| bencher.iter(|| dispatch(Single(black_box(values)))));
    group.bench_function("narrow", |bencher| bencher.iter(|| dispatch_narrow(Single(black_box(values)))));
    group.bench_function("none", |bencher| {
        bencher.iter(|| black_box(values).iter().map(|value| value * value).sum::<f64>());
    });
    group.finish();
    criterion.final_summary();
}
