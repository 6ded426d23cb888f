//! A drum in both directions against the length of one cable: `cargo bench -p benches --bench winch`; times are per number.

use std::hint::black_box;

use cdpr::cable::winch::{Drum, Mounting, Parameters};
use cdpr::nalgebra::Vector3;
use cdpr::robot::DrumSide;
use criterion::Criterion;

fn drum(mounting: Option<Mounting>, groove_length: Option<f64>, layer_height: Option<f64>) -> Drum {
    let parameters = Parameters {
        radius: 0.1,
        pitch: 0.008,
        start_angle: 0.0,
        start_length: 4.0,
        mounting,
        groove_length,
        layer_height,
        build_up: 0.0,
        advantage: 1.0,
    };
    Drum::new(parameters).expect("a drum")
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group("winch");
    let point = || {
        black_box(cdpr_model::cable::outlet::point::path(black_box([0.1, 0.2, 3.0]), black_box([1.0, 2.0, 0.5])).length)
    };
    group.bench_function("length of a point outlet", |bencher| bencher.iter(point));
    let pulley = Vector3::new(0.064, 0.0, 2.0);
    let mounting = Mounting { position: Vector3::zeros(), axis: Vector3::x(), side: DrumSide::Left, pulley };
    for (name, drum) in [
        ("guided", drum(None, None, None)),
        ("fleeting", drum(Some(mounting), None, None)),
        ("fleeting, second of two layers", drum(Some(mounting), Some(0.016), Some(0.007))),
    ] {
        let (angle, length) = (-7.0, drum.length(-7.0).expect("in the groove"));
        group.bench_function(format!("{name}: length of an angle"), |bencher| {
            bencher.iter(|| drum.length(black_box(angle)))
        });
        group.bench_function(format!("{name}: angle of a length"), |bencher| {
            bencher.iter(|| drum.angle(black_box(length)))
        });
        group
            .bench_function(format!("{name}: derivatives"), |bencher| bencher.iter(|| drum.gradient(black_box(angle))));
    }
    group.finish();
    criterion.final_summary();
}
