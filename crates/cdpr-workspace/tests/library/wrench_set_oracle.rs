//! Available wrench sets against clarabel: containment by linear programmes, margins by their supports.
//!
//! How near a wrench is to the boundary is measured by [`Problem::margin`]: by how much of the largest limit all limits could be
//! narrower, or would have to be wider. Nearer than 1e-6 either verdict counts as right.

use super::distribution::Problem;
use super::support::{builtin as robot, random_pose, within_pattern};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::builtin;
use cdpr_model::tension::Limits;
use cdpr_model::tension::quadratic::{self, Status};
use cdpr_workspace::wrench_set::{RequiredSet, Zonotope, row_lengths};
use nalgebra::{DMatrix, DVector};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const BOUNDARY: f64 = 1e-6;

/// A structure matrix, limits and lengths; every third with few directions, so that many cables lie in common planes.
fn random_set(redundancy: usize, case: usize, rng: &mut ChaCha8Rng) -> (DMatrix<f64>, Limits, Vec<f64>) {
    let rows = [2, 3, 6][case % 3];
    let cables = rows + redundancy;
    let mut matrix = DMatrix::from_fn(rows, cables, |_, _| rng.random_range(-1.0..1.0));
    if case % 4 == 1 {
        matrix.iter_mut().for_each(|entry| *entry = f64::round(*entry * 2.0));
    }
    let size = 10_f64.powf(rng.random_range(1.0..5.0));
    let largest: Vec<f64> = (0..cables).map(|_| size * rng.random_range(0.3..1.0)).collect();
    let least = largest.iter().map(|largest| largest * rng.random_range(0.0..0.8)).collect();
    (matrix, Limits::new(least, largest).expect("in order"), (0..rows).map(|_| rng.random_range(0.2..4.0)).collect())
}

/// A wrench of tensions within or beyond the limits.
fn random_wrench(matrix: &DMatrix<f64>, limits: &Limits, rng: &mut ChaCha8Rng) -> Vec<f64> {
    let reach = rng.random_range(0.0..2.0);
    let tensions = DVector::from_fn(limits.cable_count(), |cable, _| {
        let half = 0.5 * (limits.maximum()[cable] - limits.minimum()[cable]);
        limits.middle(cable) + reach * half * rng.random_range(-1.0..1.0)
    });
    (-(matrix * tensions)).as_slice().to_vec()
}

#[test]
fn a_wrench_is_in_the_set_exactly_when_tensions_balance_it() {
    let mut rng = ChaCha8Rng::seed_from_u64(71);
    for redundancy in 0..=6 {
        let (mut inside, mut outside, mut boundary) = (0, 0, 0);
        for case in 0..600 {
            let (matrix, limits, lengths) = random_set(redundancy, case, &mut rng);
            let set = Zonotope::available(&matrix, &limits, &lengths).expect("a set");
            for _ in 0..5 {
                let wrench = random_wrench(&matrix, &limits, &mut rng);
                let contained = set.contains(&wrench);
                let found = quadratic::solve(&matrix, &wrench, &limits, None).expect("fits").status == Status::Feasible;
                let problem = Problem { matrix: matrix.clone(), wrench: wrench.clone(), limits: limits.clone() };
                // columns of whole numbers may have lost rows, which the programme of the margin divides by
                let has_rows = matrix.row_iter().all(|row| row.norm() > 0.0);
                let margin = if has_rows { problem.margin() } else { f64::from(u8::from(found)) - 0.5 };
                *(if margin.abs() < BOUNDARY {
                    &mut boundary
                } else if margin > 0.0 {
                    &mut inside
                } else {
                    &mut outside
                }) += 1;
                if margin.abs() >= BOUNDARY {
                    assert_eq!(contained, margin > 0.0, "redundancy {redundancy}, case {case}: {margin:e}");
                    assert_eq!(contained, found, "redundancy {redundancy}, case {case}: {margin:e}");
                }
            }
        }
        assert!(inside > 300 && outside > 100 && boundary < 60, "{redundancy}: {inside} {outside} {boundary}");
    }
}

/// The robots of the collection at random poses, with their own limits where the file states them.
#[test]
fn sets_of_built_in_robots_agree_with_the_programme() {
    let mut rng = ChaCha8Rng::seed_from_u64(72);
    for name in builtin::names() {
        let model = Model::new(robot(name), Composition::STANDARD).expect("a model");
        let home = model.robot().home.expect("has a home pose");
        let limits = Limits::of(model.robot(), None, None)
            .unwrap_or_else(|_| Limits::uniform(model.cable_count(), 10.0, 1000.0).expect("in order"));
        let lengths = row_lengths(&model, model.platform_radius());
        let mut differences = 0;
        for _ in 0..200 {
            let pose = within_pattern(&model, &home, &random_pose(model.robot(), 0.3, &mut rng));
            let Ok(matrix) = model.structure_matrix(&pose) else { continue };
            let set = Zonotope::available(&matrix, &limits, &lengths).expect("a set");
            let wrench = random_wrench(&matrix, &limits, &mut rng);
            let found = quadratic::solve(&matrix, &wrench, &limits, None).expect("fits").status == Status::Feasible;
            let problem = Problem { matrix, wrench: wrench.clone(), limits: limits.clone() };
            if found != set.contains(&wrench) && problem.margin().abs() > BOUNDARY {
                differences += 1;
            }
        }
        assert_eq!(differences, 0, "{name}");
    }
}

/// From inside: bisecting along many directions never finds the boundary nearer than the margin, and along the normal at it.
#[test]
fn no_direction_reaches_the_boundary_before_the_margin() {
    let mut rng = ChaCha8Rng::seed_from_u64(73);
    for case in 0..120 {
        let (matrix, limits, lengths) = random_set(case % 7, case, &mut rng);
        let set = Zonotope::available(&matrix, &limits, &lengths).expect("a set");
        let center = set.center();
        let Some(margin) = set.margin(&RequiredSet::Single(center.clone())) else { continue };
        if margin.distance <= 0.0 {
            continue;
        }
        let feasible = |direction: &[f64], way: f64| {
            let wrench: Vec<f64> =
                (0..center.len()).map(|row| center[row] + way * direction[row] * lengths[row]).collect();
            quadratic::solve(&matrix, &wrench, &limits, None).expect("fits").status == Status::Feasible
        };
        for attempt in 0..20 {
            let mut direction: Vec<f64> = (0..center.len()).map(|_| rng.random_range(-1.0..1.0)).collect();
            if attempt == 0 {
                direction = margin.half_space.normal.iter().zip(&lengths).map(|(n, length)| n * length).collect();
            }
            let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
            direction.iter_mut().for_each(|x| *x /= length);
            let tolerance = 1e-7 * set.half_spaces().iter().map(|facet| facet.offset.abs()).fold(1.0, f64::max);
            assert!(feasible(&direction, margin.distance - tolerance), "case {case}");
            if attempt == 0 {
                assert!(!feasible(&direction, margin.distance + tolerance), "case {case}");
            }
        }
    }
}
