//! Sets known by hand, and laws of all sets; the comparison with another solver is in
//! `tests/library/wrench_set_oracle.rs`.

use nalgebra::{DMatrix, DVector};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use cdpr_model::tension::Limits;

fn random_set(rng: &mut ChaCha8Rng) -> (DMatrix<f64>, Limits, Vec<f64>) {
    let rows = rng.random_range(1..=6);
    let cables = rows + rng.random_range(0..=6);
    random_set_of(rows, cables, rng)
}

fn random_set_of(rows: usize, cables: usize, rng: &mut ChaCha8Rng) -> (DMatrix<f64>, Limits, Vec<f64>) {
    let matrix = DMatrix::from_fn(rows, cables, |_, _| rng.random_range(-1.0..1.0));
    let least: Vec<f64> = (0..cables).map(|_| rng.random_range(0.0..100.0)).collect();
    let largest = least.iter().map(|least| least + rng.random_range(10.0..1000.0)).collect();
    let lengths = (0..rows).map(|_| rng.random_range(0.3..3.0)).collect();
    (matrix, Limits::new(least, largest).unwrap(), lengths)
}

fn wrench_of(matrix: &DMatrix<f64>, tensions: &[f64]) -> Vec<f64> {
    (-(matrix * DVector::from_column_slice(tensions))).as_slice().to_vec()
}

fn binomial(n: usize, k: usize) -> usize {
    (0..k).fold(1, |product, i| product * (n - i) / (i + 1))
}

/// Cables up, left and right with 0 to 10 N: loads −f₁ down and f₃ − f₂ across.
#[test]
fn the_set_of_three_cables_in_a_plane_is_a_rectangle() {
    let matrix = DMatrix::from_row_slice(2, 3, &[0.0, -1.0, 1.0, 1.0, 0.0, 0.0]);
    let set = Zonotope::available(&matrix, &Limits::uniform(3, 0.0, 10.0).unwrap(), &[1.0, 1.0]).unwrap();
    // the two collinear cables make one pair of facets
    assert_eq!((set.dimension(), set.facet_count(), set.vertices().len()), (2, 4, 4));
    assert_eq!(set.center(), [0.0, -5.0]);
    for (load, distance) in [([0.0, -5.0], 5.0), ([7.0, -5.0], 3.0), ([7.0, -8.0], 2.0), ([12.0, -5.0], -2.0)] {
        let margin = set.margin(&RequiredSet::Single(load.to_vec())).unwrap();
        assert!((margin.distance - distance).abs() < 1e-12, "{load:?}: {margin:?}");
    }
    let beyond = set.margin(&RequiredSet::Single(vec![0.0, -13.0])).unwrap();
    assert_eq!((beyond.half_space.normal.as_slice(), beyond.cable), ([0.0, -1.0].as_slice(), Some(0)));
    assert_eq!((beyond.half_space.at_largest, beyond.half_space.at_least), (vec![0], vec![]));
    let side = set.margin(&RequiredSet::Single(vec![11.0, -5.0])).unwrap();
    assert_eq!((side.half_space.at_largest, side.half_space.at_least), (vec![1], vec![2]));
}

#[test]
fn required_sets_reach_as_far_as_their_furthest_point() {
    let matrix = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 1.0]);
    let set = Zonotope::available(&matrix, &Limits::uniform(2, 0.0, 10.0).unwrap(), &[1.0, 1.0]).unwrap();
    let center = vec![-5.0, -4.0];
    let reaching = |required: &RequiredSet| set.distance(required);
    assert!((reaching(&RequiredSet::Single(center.clone())) - 4.0).abs() < 1e-12);
    let half_extent = vec![3.0, 1.5];
    assert!((reaching(&RequiredSet::Box { center: center.clone(), half_extent }) - 2.0).abs() < 1e-12);
    let radius = vec![4.5, 1.0];
    assert!((reaching(&RequiredSet::Ball { center: center.clone(), radius }) - 0.5).abs() < 1e-12);
    let corners = RequiredSet::Polytope(vec![center.clone(), vec![-9.0, -9.5]]);
    let margin = set.margin(&corners).unwrap();
    assert!((margin.distance - 0.5).abs() < 1e-12 && margin.wrench == [-9.0, -9.5]);
    let part = Parallelotope { center: center.clone(), edges: vec![vec![1.0, 1.0], vec![0.0, -2.5]] };
    let margin = set.margin(&RequiredSet::Parallelotopes(vec![part])).unwrap();
    assert!((margin.distance - 0.5).abs() < 1e-12 && margin.wrench[1] == -0.5, "{margin:?}");
    for odd in [vec![1.0], vec![f64::NAN, 0.0]] {
        assert!(set.margin(&RequiredSet::Single(odd.clone())).is_none() && !set.contains(&odd));
    }
}

/// Generic generators: numbers of facets and corners from the hyperplanes through generators and the cells between
/// them.
#[test]
fn facets_and_corners_have_the_numbers_of_combinatorics() {
    let mut rng = ChaCha8Rng::seed_from_u64(61);
    for (rows, cables) in [(1, 4), (2, 2), (2, 7), (3, 5), (4, 8), (5, 7), (6, 6), (6, 8), (6, 12)] {
        let (matrix, limits, lengths) = random_set_of(rows, cables, &mut rng);
        let set = Zonotope::available(&matrix, &limits, &lengths).unwrap();
        assert_eq!(set.facet_count(), 2 * binomial(cables, rows - 1), "{rows} {cables}");
        let cells: usize = 2 * (0..rows).map(|k| binomial(cables - 1, k)).sum::<usize>();
        assert_eq!(set.vertices().len(), cells, "{rows} {cables}");
    }
}

/// Corners from half-spaces and half-spaces from corners, in sets that are generic, flat, with parallel cables and with
/// cables without range.
#[test]
fn corners_and_half_spaces_describe_the_same_set() {
    let mut rng = ChaCha8Rng::seed_from_u64(62);
    for case in 0..300 {
        let (mut matrix, mut limits, lengths) = random_set(&mut rng);
        let (rows, cables) = matrix.shape();
        if case % 3 == 1 {
            // small whole numbers: many generators in common planes, some of them parallel
            matrix.iter_mut().for_each(|entry| *entry = (*entry * 2.5).round());
        }
        if case % 4 == 1 && cables > 1 {
            limits = Limits::new(
                limits.minimum().to_vec(),
                (0..cables).map(|i| if i == 0 { limits.minimum()[0] } else { limits.maximum()[i] }).collect(),
            )
            .unwrap();
        }
        if case % 5 == 1 && rows > 1 {
            let copy = matrix.row(0) * 2.0;
            matrix.row_mut(1).copy_from(&copy);
        }
        let set = Zonotope::available(&matrix, &limits, &lengths).unwrap();
        let (facets, corners) = (set.half_spaces(), set.vertices());
        let along = |normal: &[f64], wrench: &[f64]| normal.iter().zip(wrench).map(|(a, b)| a * b).sum::<f64>();
        let size = 1e4; // 12 cables of 1000 N
        for corner in &corners {
            let again = wrench_of(&matrix, &corner.tensions);
            assert!(corner.wrench.iter().zip(&again).all(|(a, b)| (a - b).abs() < 1e-12 * size), "case {case}");
            assert!(limits.contain(&corner.tensions, 0.0) && set.contains(&corner.wrench), "case {case}");
        }
        for facet in &facets {
            let on = corners.iter().filter(|corner| along(&facet.normal, &corner.wrench) > facet.offset - 1e-9 * size);
            // a facet of dimension k has at least k + 1 corners
            assert!(on.count() >= set.dimension().min(rows - 1).max(1), "case {case}");
            for (list, limit) in [(&facet.at_largest, limits.maximum()), (&facet.at_least, limits.minimum())] {
                let furthest = corners
                    .iter()
                    .max_by(|a, b| along(&facet.normal, &a.wrench).total_cmp(&along(&facet.normal, &b.wrench)));
                let furthest = furthest.unwrap();
                assert!(list.iter().all(|&cable| furthest.tensions[cable] == limit[cable]), "case {case}");
            }
        }
    }
}

/// Also from the outside if a facet is nearest; here along facet normals, and by bisecting the size of an added ball.
#[test]
fn the_margin_is_the_ball_that_can_be_added() {
    let mut rng = ChaCha8Rng::seed_from_u64(63);
    for case in 0..200 {
        let (matrix, limits, lengths) = random_set(&mut rng);
        let set = Zonotope::available(&matrix, &limits, &lengths).unwrap();
        let inside: Vec<f64> = (0..limits.cable_count())
            .map(|i| limits.middle(i) + rng.random_range(-0.3..0.3) * (limits.maximum()[i] - limits.minimum()[i]))
            .collect();
        let center = wrench_of(&matrix, &inside);
        let margin = set.margin(&RequiredSet::Single(center.clone())).unwrap();
        let ball = |size: f64| RequiredSet::Ball {
            center: center.clone(),
            radius: lengths.iter().map(|length| size * length).collect(),
        };
        let (mut holds, mut fails) = (0.0, 1e5);
        while fails - holds > 1e-9 * fails {
            let middle = 0.5 * (holds + fails);
            *(if set.contains_set(&ball(middle)) { &mut holds } else { &mut fails }) = middle;
        }
        assert!((holds - margin.distance).abs() < 1e-7 * (1.0 + margin.distance), "case {case}: {holds} {margin:?}");
        // and the step to the facet ends on the boundary, to the 1e-7 N that are rounding in a set of 10 kN
        let step = |way: f64| -> Vec<f64> {
            let normal = &margin.half_space.normal;
            let scaled = normal.iter().zip(&lengths).map(|(n, length)| n * length * length);
            center.iter().zip(scaled).map(|(w, n)| w + way * n).collect()
        };
        let distance = margin.distance;
        assert!(set.contains(&step(distance - 1e-6)) && !set.contains(&step(distance + 1e-6)), "case {case}");
    }
}

/// Twice the tensions: twice the set. Other units of moments with their length scale: the same distances.
#[test]
fn sets_scale_with_tensions_and_do_not_depend_on_units() {
    let mut rng = ChaCha8Rng::seed_from_u64(64);
    for case in 0..200 {
        let (matrix, limits, lengths) = random_set(&mut rng);
        let set = Zonotope::available(&matrix, &limits, &lengths).unwrap();
        let wrench: Vec<f64> = (0..lengths.len()).map(|_| rng.random_range(-2000.0..2000.0)).collect();
        let distance = set.distance(&RequiredSet::Single(wrench.clone()));
        let twice = |list: &[f64]| list.iter().map(|value| 2.0 * value).collect::<Vec<f64>>();
        let doubled = Limits::new(twice(limits.minimum()), twice(limits.maximum())).unwrap();
        let larger = Zonotope::available(&matrix, &doubled, &lengths).unwrap();
        let other = larger.distance(&RequiredSet::Single(twice(&wrench)));
        assert!((other - 2.0 * distance).abs() < 1e-8, "case {case}");
        let mut millimetres = matrix.clone();
        let last = lengths.len() - 1;
        millimetres.row_mut(last).scale_mut(1e3);
        let (mut long, mut same) = (lengths.clone(), wrench.clone());
        (long[last], same[last]) = (1e3 * long[last], 1e3 * same[last]);
        let other = Zonotope::available(&millimetres, &limits, &long).unwrap().distance(&RequiredSet::Single(same));
        assert!((other - distance).abs() < 1e-8, "case {case}: {other} {distance}");
    }
}

/// A further cable whose least tension is zero can stay slack: the set does not shrink.
#[test]
fn a_cable_that_may_be_slack_takes_nothing_away() {
    let mut rng = ChaCha8Rng::seed_from_u64(65);
    for case in 0..200 {
        let (matrix, limits, lengths) = random_set(&mut rng);
        let (rows, cables) = matrix.shape();
        let small = Zonotope::available(&matrix, &limits, &lengths).unwrap();
        let more = matrix.clone().insert_column(cables, 0.3 + case as f64 * 0.01);
        let ends = |list: &[f64], end: f64| [list, &[end]].concat();
        let limits = Limits::new(ends(limits.minimum(), 0.0), ends(limits.maximum(), 500.0)).unwrap();
        let large = Zonotope::available(&more, &limits, &lengths).unwrap();
        assert!(small.vertices().iter().all(|corner| large.contains(&corner.wrench)), "case {case}: {rows}");
    }
}

#[test]
fn sets_without_thickness_contain_their_own_wrenches_and_nothing_beside_them() {
    // two cables on a line, in a plane
    let matrix = DMatrix::from_row_slice(2, 2, &[1.0, -1.0, 0.0, 0.0]);
    let limits = Limits::uniform(2, 0.0, 10.0).unwrap();
    let set = Zonotope::available(&matrix, &limits, &[1.0, 1.0]).unwrap();
    assert_eq!((set.dimension(), set.vertices().len()), (1, 2));
    assert!(set.contains(&[9.9, 0.0]) && !set.contains(&[10.1, 0.0]) && !set.contains(&[0.0, 1e-3]));
    assert_eq!(set.distance(&RequiredSet::Single(vec![5.0, 0.0])), 0.0);
    assert!((set.distance(&RequiredSet::Single(vec![5.0, 3.0])) + 3.0).abs() < 1e-12);
    // and cables without any range: a point
    let fixed = Limits::uniform(2, 5.0, 5.0).unwrap();
    let point = Zonotope::available(&matrix, &fixed, &[1.0, 1.0]).unwrap();
    assert_eq!((point.dimension(), point.vertices().len()), (0, 1));
    assert!(point.contains(&[0.0, 0.0]) && !point.contains(&[0.1, 0.0]));
    assert!(point.margin(&RequiredSet::Single(vec![0.1, 0.0])).unwrap().cable.is_none());
}

#[test]
fn what_has_no_set_is_refused() {
    let limits = |count| Limits::uniform(count, 0.0, 1.0).unwrap();
    let matrix = DMatrix::from_element(2, 3, 1.0);
    for (matrix, count, lengths, words) in [
        (DMatrix::from_element(7, 8, 1.0), 8, vec![1.0; 7], "1 to 6 components"),
        (DMatrix::from_element(2, 40, 1.0), 40, vec![1.0; 2], "40 cables"),
        (matrix.clone(), 2, vec![1.0; 2], "expected 3 pairs of tension limits"),
        (matrix.clone(), 3, vec![1.0; 3], "expected 2 row lengths"),
        (matrix.clone(), 3, vec![1.0, 0.0], "length scale is 0"),
        (matrix * f64::NAN, 3, vec![1.0; 2], "NaN"),
    ] {
        let refused = Zonotope::available(&matrix, &limits(count), &lengths).unwrap_err().to_string();
        assert!(refused.contains(words), "{refused}");
    }
}
