//! Elastic and sagging models without recorded tensions (m ≤ n, known load), on records computed without the library.

use cdpr_calibration::candidate::{KnownTensions, parse_list};
use cdpr_calibration::fit::{Settings as Fitting, fit};
use cdpr_calibration::selection::{Settings, Warnings, select};
use cdpr_calibration::{Doubt, unobserved};
use cdpr_model::finding::{FindingKind, Severity};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas, Split};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// Weight of the platform (N), and accuracies of positions and lengths (m).
const WEIGHT: f64 = 40.0 * 9.81;
const POSITION: f64 = 5e-4;
const LENGTH: f64 = 2e-4;
/// Offsets of the recorded lengths, cable by cable (m).
const OFFSETS: [f64; 3] = [0.012, -0.008, 0.005];
/// Stiffness EA of the cables (N), and their weight per length (N/m).
const STIFFNESS: f64 = 4e4;
const CABLE_WEIGHT: f64 = 0.8 * 9.81;

/// A point platform on cables from these places.
fn robot(anchors: &[Vector3<f64>], pattern: &str, stiffness: f64) -> Robot {
    let cable = |(index, anchor): (usize, &Vector3<f64>)| {
        let place = if pattern == "2T" {
            format!("[{:?}, {:?}]", anchor.x, anchor.z)
        } else {
            format!("[{:?}, {:?}, {:?}]", anchor.x, anchor.y, anchor.z)
        };
        format!(
            "[[cable]]\nname = \"{index}\"\nframe_anchor_m = {place}\naxial_stiffness_EA_N = {stiffness:?}\nlinear_density_kg_per_m = 0.8\n"
        )
    };
    let cables: String = anchors.iter().enumerate().map(cable).collect();
    let (axes, gravity, home) = match pattern {
        "2T" => ("axes = \"xz\"\n", "[0.0, -9.81]", "[2.0, 1.0]"),
        _ => ("", "[0.0, 0.0, -9.81]", "[0.0, 0.0, 1.0]"),
    };
    let text = format!(
        "layout_version = 1\nname = \"own\"\nmotion_pattern = \"{pattern}\"\n{axes}cable_count = {}\ngravity_m_s2 = {gravity}\n[platform]\nmass_kg = 40.0\n\
         [home_pose]\nposition_m = {home}\n{cables}",
        anchors.len()
    );
    Robot::from_toml(&text, "own.toml").unwrap()
}

fn noisy(places: &[Vector3<f64>], lengths: &[f64], cables: usize, seed: u64) -> Samples {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut noise = |sigma: f64| {
        let unit: f64 = StandardNormal.sample(&mut rng);
        sigma * unit
    };
    let planar = cables == 2;
    let poses = places.iter().map(|place| {
        let off = Vector3::new(noise(POSITION), if planar { 0.0 } else { noise(POSITION) }, noise(POSITION));
        Pose::from_xyz_angles(place + off, [0.0; 3])
    });
    let poses: Vec<Pose> = poses.collect();
    let sigmas = SensorSigmas { position: Some(POSITION), length: Some(LENGTH), ..SensorSigmas::default() };
    let lengths = lengths.iter().enumerate().map(|(k, length)| length + OFFSETS[k % cables] + noise(LENGTH)).collect();
    Samples { poses, lengths, cable_count: cables, sigmas, ..Samples::default() }
}

/// Three straight elastic cables hold a point: tensions by three equations, unstrained lengths ℓ/(1 + f/EA).
fn elastic_record(seed: u64) -> (Robot, Samples) {
    let anchors = [(3.0, 0.0), (-1.5, 2.6), (-1.5, -2.6)].map(|(x, y)| Vector3::new(x, y, 4.0));
    let (mut places, mut lengths) = (Vec::new(), Vec::new());
    for k in 0..30 {
        let angle = 0.7 * f64::from(k);
        let radius = 0.25 + 1.0 * f64::from(k % 5) / 5.0;
        let place = Vector3::new(radius * angle.cos(), radius * angle.sin(), 0.5 + 0.1 * f64::from(k % 7));
        let ways = anchors.map(|anchor| anchor - place);
        let directions = Matrix3::from_columns(&ways.map(|way| way.normalize()));
        let tensions = directions.lu().solve(&Vector3::new(0.0, 0.0, WEIGHT)).unwrap();
        places.push(place);
        lengths.extend(ways.iter().zip(&tensions).map(|(way, tension)| way.norm() / (1.0 + tension / STIFFNESS)));
    }
    (robot(&anchors, "3T", STIFFNESS), noisy(&places, &lengths, 3, seed))
}

/// Way across and up of a cable of an unstrained length from the platform, which it pulls by h across and v up (Irvine 1981).
fn catenary(h: f64, v: f64, length: f64) -> [f64; 2] {
    let (top, w) = (v + CABLE_WEIGHT * length, CABLE_WEIGHT);
    let across = h * length / STIFFNESS + h / w * ((top / h).asinh() - (v / h).asinh());
    let up = length / STIFFNESS * (v + 0.5 * w * length) + ((h * h + top * top).sqrt() - (h * h + v * v).sqrt()) / w;
    [across, up]
}

/// Two sagging cables hold a point in a plane: h is common, and the two pulls up carry the weight.
fn sagging_record(seed: u64) -> (Robot, Samples) {
    let anchors = [Vector3::new(0.0, 0.0, 5.0), Vector3::new(14.0, 0.0, 6.0)];
    let (mut places, mut lengths) = (Vec::new(), Vec::new());
    for k in 0..30 {
        let place = Vector3::new(3.0 + 8.0 * f64::from(k % 6) / 5.0, 0.0, 1.0 + 0.35 * f64::from(k / 6));
        let missing = |state: &SVector<f64, 4>| {
            let [h, v, first, second] = (*state).into();
            let [left, right] = [catenary(h, v, first), catenary(h, WEIGHT - v, second)];
            SVector::<f64, 4>::new(
                left[0] - place.x,
                left[1] - (anchors[0].z - place.z),
                right[0] - (anchors[1].x - place.x),
                right[1] - (anchors[1].z - place.z),
            )
        };
        let chords = anchors.map(|anchor| (anchor - place).norm());
        let mut state = SVector::<f64, 4>::new(400.0, 0.5 * WEIGHT, chords[0], chords[1]);
        for _ in 0..60 {
            let here = missing(&state);
            let column = |k: usize| {
                let h = 1e-6 * state[k].abs().max(1.0);
                (missing(&(state + SVector::ith(k, h))) - missing(&(state - SVector::ith(k, h)))) / (2.0 * h)
            };
            let jacobian = SMatrix::<f64, 4, 4>::from_columns(&[column(0), column(1), column(2), column(3)]);
            let step = jacobian.lu().solve(&here).unwrap();
            let share = (0.3 * state[0] / step[0].abs()).min(1.0);
            state -= share * step;
        }
        assert!(missing(&state).norm() < 1e-9, "{state}");
        places.push(place);
        lengths.extend([state[2], state[3]]);
    }
    (robot(&anchors, "2T", STIFFNESS), noisy(&places, &lengths, 2, seed))
}

fn chosen(robot: &Robot, samples: &Samples) -> String {
    let list = "standard:length-offset;elastic:length-offset;elastic+catenary:length-offset";
    let folds = Split::Blocks(5).folds(samples, 0).unwrap();
    let candidates = parse_list(list).unwrap();
    let found = select(robot, &candidates, samples, &folds, &Settings::default(), &unobserved).unwrap();
    for candidate in &found.candidates {
        let own = candidate.outcome.as_ref().unwrap_or_else(|error| panic!("{}: {error}", candidate.name));
        println!("{}: {:.3} mm", candidate.name, 1e3 * own.compared_mean);
    }
    found.candidates[found.recommended.unwrap()].name.clone()
}

#[test]
fn the_model_of_the_machine_is_chosen_without_load_cells() {
    for seed in 0..3 {
        let (robot, samples) = elastic_record(seed);
        assert_eq!(KnownTensions::of(&robot, &samples), KnownTensions::ByStatics);
        assert_eq!(chosen(&robot, &samples), "elastic:length-offset");
        let (robot, samples) = sagging_record(seed);
        assert_eq!(chosen(&robot, &samples), "elastic+catenary:length-offset");
    }
}

/// Offsets and compliances of a record without load cells, from a file that is a third too soft: in 93 to 97 % of the records the 95 % intervals hold them.
#[test]
fn intervals_hold_without_load_cells() {
    let (mut held, mut all) = (0, 0);
    for seed in 0..100 {
        let (machine, samples) = elastic_record(seed);
        let anchors: Vec<Vector3<f64>> = machine.cables.iter().map(|cable| cable.frame_anchor).collect();
        let file = Model::new(robot(&anchors, "3T", 0.7 * STIFFNESS), Composition::ELASTIC).unwrap();
        let free = "length-offset,compliance".parse().unwrap();
        let found = fit(&file, &samples, &free, &Fitting::default()).unwrap();
        for estimate in &found.parameters {
            let truth = match estimate.parameter.kind {
                cdpr_model::robot::ParameterKind::LengthOffset => OFFSETS[estimate.parameter.cable],
                _ => 1.0 / STIFFNESS,
            };
            held += u32::from((estimate.value - truth).abs() <= found.analysis.quantile_95 * estimate.sigma.unwrap());
            all += 1;
        }
    }
    let share = f64::from(held) / f64::from(all);
    println!("{all} intervals, {:.2} % hold the truth", 100.0 * share);
    assert!((0.93..=0.97).contains(&share), "{share}");
}

/// A candidate that cannot be judged is a caution of the choice among the others, with its reason.
#[test]
fn a_candidate_that_failed_is_told() {
    let (robot, samples) = elastic_record(1);
    let folds = Split::Blocks(5).folds(&samples, 0).unwrap();
    let candidates = parse_list("standard:length-offset;elastic:length-offset;drum:drum-radius").unwrap();
    let found = select(&robot, &candidates, &samples, &folds, &Settings::default(), &unobserved).unwrap();
    assert_eq!(found.recommended, Some(1));
    let warnings = found.warnings(&samples, &Warnings::default());
    let of_kind = |doubt: &&Doubt| doubt.finding.kind == FindingKind::Unsettled;
    let told: Vec<&Doubt> = warnings.doubts.iter().filter(of_kind).collect();
    assert_eq!(told.len(), 1, "{:?}", warnings.list());
    assert_eq!(told[0].finding.severity, Severity::Caution);
    let text = &told[0].finding.text;
    assert!(text.contains("1 of 3 candidates") && text.contains("`drum:drum-radius`"), "{text}");
}
