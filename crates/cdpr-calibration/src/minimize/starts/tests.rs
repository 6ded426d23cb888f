use super::drawing::Drawing;
use super::*;
use crate::progress::unobserved;
use cdpr_model::robot::{Parameter, ParameterKind};

/// One parameter with two wells, a flat valley of a second one, and a plateau from which no descent converges.
struct Wells {
    lower: f64,
}

#[derive(Clone)]
struct Bottom {
    place: [f64; 2],
    cost: f64,
    converged: bool,
}

impl Ending for Bottom {
    fn cost(&self) -> f64 {
        self.cost
    }

    fn converged(&self) -> bool {
        self.converged
    }

    fn place(&self) -> &[f64] {
        &self.place
    }
}

impl Landscape for Wells {
    type End = Bottom;

    fn descend(&mut self, _: usize, change: &[f64]) -> Bottom {
        let bottom = if change[0] < 0.1 { -0.2 } else { 0.3 };
        let place = [bottom, change[1]];
        Bottom { place, cost: self.height(&place), converged: change[0] < 0.4 }
    }

    fn cost(&mut self, _: usize, place: &[f64], _: &Bottom) -> f64 {
        self.height(place)
    }
}

impl Wells {
    fn height(&self, place: &[f64]) -> f64 {
        let to = |bottom: f64| (place[0] - bottom).powi(2);
        5.0 + 1e4 * to(-0.2) * to(0.3) + if place[0] < 0.1 { 0.0 } else { self.lower }
    }
}

fn anchors(count: usize) -> Part {
    let parameter = |axis| Parameter { kind: ParameterKind::FrameAnchor, cable: 0, axis };
    Part { parameters: (0..count).map(parameter).collect(), start: vec![1.0; count], scale: vec![1.0; count] }
}

fn settings(starts: u32, seed: u64) -> Settings {
    Settings { starts, seed, ..Settings::default() }
}

fn found(lower: f64, starts: u32) -> (Starts, Bottom) {
    let (parts, settings) = ([anchors(2)], settings(starts, 7));
    let search = Search { parts: &parts, settings: &settings, samples: 10, tension: 0.0 };
    let mut wells = Wells { lower };
    let mut best = [wells.descend(0, &[0.0, 0.0])];
    let starts = search.run(&mut wells, &mut best, &unobserved).unwrap();
    let [best] = best;
    (starts, best)
}

/// A scrambled Sobol sequence puts one of 2ᵏ points into each 2⁻ᵏ of every dimension, in any of its blocks that begin at a multiple of 2ᵏ; random
/// numbers leave a third of these empty.
#[test]
fn starts_fill_the_range_of_every_parameter_evenly() {
    let settings = settings(65, 3);
    let (drawing, part) = (Drawing::new(&settings, 0.0), anchors(3));
    for parameter in 0..3 {
        let mut cells: Vec<usize> = (1..=64)
            .map(|start| {
                let change = drawing.change(start, &part, 300)[parameter];
                assert!(change.abs() <= 0.5, "{change}");
                (64.0 * (change + 0.5)) as usize
            })
            .collect();
        cells.sort_unstable();
        assert_eq!(cells, (0..64).collect::<Vec<_>>());
    }
}

#[test]
fn starts_are_those_of_their_seed_and_do_not_depend_on_how_many_are_asked_for() {
    let part = anchors(3);
    let change = |starts, seed, start| Drawing::new(&settings(starts, seed), 0.0).change(start, &part, 0);
    assert_eq!(change(10, 1, 4), change(1000, 1, 4));
    assert_ne!(change(10, 1, 4), change(10, 2, 4));
    assert_ne!(change(10, 1, 4), change(10, 1 << 40, 4));
    // beyond 256 dimensions another scramble begins
    let drawing = |first| Drawing::new(&settings(10, 1), 0.0).change(4, &part, first);
    assert_ne!(drawing(0), drawing(256));
}

#[test]
fn starts_stay_within_bounds() {
    let radius = Parameter { kind: ParameterKind::PulleyRadius, cable: 0, axis: 0 };
    let part = Part { parameters: vec![radius], start: vec![1.2e-3], scale: vec![1.0] };
    let low = radius.bounds().0;
    let settings = settings(40, 0);
    let values: Vec<f64> =
        (1..40).map(|start| 1.2e-3 + Drawing::new(&settings, 0.0).change(start, &part, 0)[0]).collect();
    assert!(values.iter().all(|value| *value >= low - 1e-18 && *value <= 1.5 * 1.2e-3 + 1e-18), "{values:?}");
}

#[test]
fn optima_are_told_with_the_share_of_starts_that_ended_there() {
    let (starts, best) = found(-1.0, 201);
    assert_eq!(starts.ranges, ["frame-anchor ± 0.5 m"]);
    let [first, second] = &starts.optima[..] else { panic!("{starts:?}") };
    assert_eq!((best.place[0], first.cost, second.cost), (0.3, 4.0, 5.0));
    // of a range of 1 m: 0.6 m lead to the one, 0.3 m to the other, 0.1 m nowhere; a Sobol sequence misses such shares by a few points
    for (fraction, expected) in
        [(first.fraction, 0.3), (second.fraction, 0.6), (starts.unconverged as f64 / 201.0, 0.1)]
    {
        assert!((fraction - expected).abs() < 0.02, "{fraction} {expected}");
    }
    assert_eq!(first.starts + second.starts + starts.unconverged, starts.count);
    // the flat valley is no optimum for every start
    assert!(second.spread_m > 0.4 && (0.5..1.0).contains(&second.distance_m), "{second:?}");
    let doubts = starts.doubts(0.1);
    assert!(doubts.len() == 1 && doubts[0].contains("reached by"), "{doubts:?}");
}

#[test]
fn an_optimum_that_noise_does_not_tell_from_the_best_is_a_doubt() {
    let (starts, best) = found(1.0, 101);
    assert_eq!(best.place[0], -0.2);
    assert_eq!(starts.doubts(0.1), Vec::<String>::new());
    let doubts = starts.doubts(1.0);
    assert!(doubts.len() == 1 && doubts[0].contains("fits the data as well"), "{doubts:?}");
}

#[test]
fn one_start_is_that_of_the_file() {
    let (starts, best) = found(-1.0, 1);
    assert_eq!((starts.count, starts.unconverged, best.place[0]), (1, 0, -0.2));
    assert!(starts.optima.len() == 1 && starts.optima[0].fraction == 1.0 && starts.ranges.is_empty());
}
