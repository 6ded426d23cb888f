//! Friction of winches: intervals against the truth of simulated records, and a measured winch.

use cdpr_calibration::friction::{Figure, Record, Solution, identify};
use cdpr_testing::{property, shared};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

/// Torque by a, b, c₀, c₁, d, excess and Stribeck speed.
fn torque(truth: &[f64; 7], speed: f64, load: f64) -> f64 {
    let [a, b, dry, growth, viscous, excess, slow] = *truth;
    let friction = dry + growth * load + viscous * speed.abs() + excess * (-(speed / slow).powi(2)).exp();
    a * load + b + speed.signum() * friction
}

/// Plateaus of both directions under loads, with normal noise.
fn plateaus(truth: &[f64; 7], speeds: &[f64], loads: &[f64], noise: f64, seed: u64) -> Record {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let normal = Normal::new(0.0, noise).unwrap();
    let (mut all, mut torques, mut given) = (Vec::new(), Vec::new(), Vec::new());
    for load in loads {
        for speed in speeds.iter().flat_map(|speed| [*speed, -speed]) {
            all.push(speed);
            torques.push(torque(truth, speed, *load) + normal.sample(&mut random));
            given.push(*load);
        }
    }
    Record::of_plateaus(all, torques, Some(given))
}

type Told = fn(&Solution) -> Option<Figure>;

/// Asserts that intervals hold the truth as often as they say, of those records that tell the number.
fn assert_coverage(quantities: &[(&str, Told, f64)], record: impl Fn(u64) -> Record) {
    let mut held = vec![[0_u32; 2]; quantities.len()];
    for seed in property::seeds(300) {
        let found = identify(&[record(seed)]).unwrap();
        for ((_, told, truth), [holds, all]) in quantities.iter().zip(&mut held) {
            let Some([low, high]) = told(&found).and_then(|figure| found.interval(&figure)) else { continue };
            *all += 1;
            *holds += u32::from((low..=high).contains(truth));
        }
    }
    for ((name, ..), [holds, all]) in quantities.iter().zip(held) {
        let (share, count) = (f64::from(holds) / f64::from(all), f64::from(all));
        println!("{name}: {share:.4} of {all}");
        // one of 2000 right programs is outside, one of 10 000 below; more draws narrow the band
        let [low, high] = if all <= 300 {
            [0.90, 0.987]
        } else {
            [-1.0, 1.0].map(|sign| 0.95 + sign * 3.3 * (0.0475 / count).sqrt())
        };
        assert!((low..=high).contains(&share), "{name}: {share} of {all} intervals hold the truth");
        assert!(count >= 0.97 * property::sample(300) as f64, "{name} is told by {all} records only");
    }
}

const SMOOTH: [f64; 7] = [0.93, 0.045, 0.039, 0.039, 6.4e-4, 0.0, 1.0];
const FALLING: [f64; 7] = [0.93, 0.045, 0.039, 0.039, 6.4e-4, 0.03, 1.2];

/// The speeds and the noise of the measured winch.
#[test]
fn intervals_of_friction_hold_the_truth() {
    let quantities: [(&str, Told, f64); 5] = [
        ("scale", |found| found.load_scale, SMOOTH[0]),
        ("offset", |found| found.load_offset, SMOOTH[1]),
        ("Coulomb", |found| found.coulomb, SMOOTH[2]),
        ("growth", |found| found.coulomb_by_load, SMOOTH[3]),
        ("viscous", |found| found.viscous, SMOOTH[4]),
    ];
    assert_coverage(&quantities, |seed| plateaus(&SMOOTH, &[3.1, 6.2, 15.4, 24.8], &[0.196, 0.981], 5e-3, seed));
}

/// Friction that falls with speed is found in every record; its law is not linear, and intervals are those of its linearization.
#[test]
fn intervals_of_friction_that_falls_with_speed_hold_the_truth() {
    let quantities: [(&str, Told, f64); 6] = [
        ("Coulomb", |found| found.coulomb, FALLING[2]),
        ("growth", |found| found.coulomb_by_load, FALLING[3]),
        ("viscous", |found| found.viscous, FALLING[4]),
        ("static", |found| found.standing, FALLING[2] + FALLING[5]),
        ("Stribeck speed", |found| found.stribeck_speed, FALLING[6]),
        ("scale", |found| found.load_scale, FALLING[0]),
    ];
    let speeds = [0.2, 0.4, 0.7, 1.0, 1.4, 1.8, 2.4, 4.0, 8.0, 14.0, 20.0];
    assert_coverage(&quantities, |seed| plateaus(&FALLING, &speeds, &[0.196, 0.981], 1.5e-3, seed));
}

/// No more records than chance allows show friction that falls with speed where there is none.
#[test]
fn friction_that_does_not_fall_is_hardly_ever_told_to_fall() {
    let speeds = [0.2, 0.4, 0.7, 1.0, 1.4, 1.8, 2.4, 4.0, 8.0, 14.0, 20.0];
    let told = property::seeds(300)
        .filter(|seed| {
            let record = plateaus(&SMOOTH, &speeds, &[0.196, 0.981], 1.5e-3, *seed);
            identify(&[record]).unwrap().standing.is_some()
        })
        .count();
    // a gain of 6 by two numbers: χ² beyond 10, with a search over speeds about 1 %
    assert!(told as f64 <= 0.03 * property::sample(300) as f64, "{told}");
}

/// Samples of a motor with cogging, encoder noise, ramps and rests: one run up and down at each speed.
fn samples(load: f64, seed: u64) -> Record {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let noise = Normal::new(0.0, 1.0).unwrap();
    let mut record = Record::default();
    let (mut times, mut position, mut time) = (Vec::new(), 0.0, 0.0);
    let step = 0.03;
    for level in [3.0_f64, -3.0, 6.0, -6.0, 12.0, -12.0, 20.0, -20.0] {
        // rest, ramp, turns, ramp
        let (ramp, turning) = (level.abs() / 25.0, (40.0 / level.abs()).max(2.0));
        let mut since = 0.0;
        while since < 1.0 + 2.0 * ramp + turning {
            let (speed, acceleration) = match since {
                s if s < 1.0 => (0.0, 0.0),
                s if s < 1.0 + ramp => (level * (s - 1.0) / ramp, 25.0 * level.signum()),
                s if s < 1.0 + ramp + turning => (level, 0.0),
                s => (level * (1.0 - (s - 1.0 - ramp - turning) / ramp).max(0.0), -25.0 * level.signum()),
            };
            position += speed * step;
            let sliding = if speed == 0.0 { load + 0.01 } else { torque(&SMOOTH, speed, load) };
            let cogging = 0.06 * (7.0 * position).sin();
            record.lines.push(record.lines.len() + 2);
            record.speeds.push(speed + 0.03 * level.abs() * noise.sample(&mut random));
            record.torques.push(sliding + 3e-3 * acceleration + cogging + 5e-3 * noise.sample(&mut random));
            times.push(time);
            (since, time) = (since + step, time + step);
        }
    }
    Record { loads: Some(vec![load; times.len()]), times: Some(times), ..record }
}

#[test]
fn plateaus_are_found_in_samples_with_cogging_and_ramps() {
    let mut held = 0;
    for seed in property::seeds(40) {
        let found = identify(&[samples(0.196, 2 * seed), samples(0.981, 2 * seed + 1)]).unwrap();
        assert_eq!(found.directions, [8, 8], "{seed}: {:?}", found.left_out);
        // of 530 rows at rest many are too noisy to be told from ramps: neither is used
        assert!(found.left_out.at_rest > 20 && found.left_out.accelerating > 100, "{:?}", found.left_out);
        let truths = [SMOOTH[0], SMOOTH[1], SMOOTH[2], SMOOTH[3], SMOOTH[4]];
        let told = [found.load_scale, found.load_offset, found.coulomb, found.coulomb_by_load, found.viscous];
        for (figure, truth) in told.into_iter().zip(truths) {
            let [low, high] = found.interval(&figure.unwrap()).unwrap();
            held += usize::from((low..=high).contains(&truth));
        }
    }
    let share = held as f64 / property::sample(200) as f64;
    println!("{share}");
    // ripple that does not end with the plateau is no normal noise: intervals are at least as wide as they say, less chance of 200
    assert!(share >= 0.90, "{share}");
}

/// Means of constant speeds of a mass (kg) that the speed controller held, lowering negative; and the torque of that mass.
fn measured(mass: &str) -> Option<Record> {
    let text = String::from_utf8(shared("measurements/ttk4900-winch/plateaus.csv")?).unwrap();
    let rows = text.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    let rows: Vec<_> = rows.filter(|row| row[2] == mass && row[4] == "speed").collect();
    let number = |text: &str| text.parse::<f64>().unwrap();
    let sign = |direction: &str| if direction == "up" { 1.0 } else { -1.0 };
    let load = number(mass) * 9.81 * 0.02;
    Some(Record::of_plateaus(
        rows.iter().map(|row| sign(row[3]) * number(row[6])).collect(),
        rows.iter().map(|row| number(row[7])).collect(),
        Some(vec![load; rows.len()]),
    ))
}

/// Samples of the same, by their runs.
fn measured_samples(mass: &str) -> Option<Record> {
    let table = String::from_utf8(shared("measurements/ttk4900-winch/plateaus.csv")?).unwrap();
    let text = String::from_utf8(shared("measurements/ttk4900-winch/runs.csv")?).unwrap();
    let kept: Vec<&str> = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>())
        .filter(|row| row[2] == mass && row[4] == "speed")
        .map(|row| row[0])
        .collect();
    let mut record = Record::default();
    let [mut times, mut runs, mut positions] = [Vec::new(), Vec::new(), Vec::new()];
    for (line, row) in text.lines().enumerate().skip(1) {
        let fields: Vec<&str> = row.split(',').collect();
        let number = |k: usize| fields[k].parse::<f64>().unwrap();
        if !kept.contains(&fields[0]) {
            continue;
        }
        record.lines.push(line + 1);
        runs.push(number(0));
        times.push(number(1));
        positions.push(number(2));
        record.speeds.push(number(3));
        record.torques.push(number(5));
    }
    Some(Record { times: Some(times), runs: Some(runs), positions: Some(positions), ..record })
}

/// Value and standard deviation by ordinary least squares of all rows, copies too: the first run of each copied file counts once here, so that
/// numbers may differ by a third of a deviation.
fn assert_like(figure: Option<Figure>, value: f64, sigma: f64) {
    let figure = figure.unwrap();
    assert!((figure.value - value).abs() < 0.7 * sigma, "{figure:?} instead of {value} ± {sigma}");
    let ratio = figure.sigma.unwrap() / sigma;
    assert!((0.8..1.25).contains(&ratio), "{figure:?} instead of {value} ± {sigma}");
}

const TURN: f64 = std::f64::consts::TAU;

#[test]
fn a_measured_winch_has_the_friction_of_an_independent_fit() {
    let (Some(heavy), Some(light)) = (measured("5"), measured("1")) else { return };
    let found = identify(std::slice::from_ref(&heavy)).unwrap();
    assert_like(found.loads[0].torque, 0.9535, 0.0018);
    assert_like(found.coulomb, 0.0740, 0.0031);
    assert_like(found.viscous, 0.0055 / TURN, 0.0014 / TURN);
    assert!((found.rms - 4.3e-3).abs() < 1e-4, "{}", found.rms);
    assert!(found.standing.is_none() && found.left_out.duplicates == 1, "{found:?}");
    let found = identify(&[light, heavy]).unwrap();
    assert_like(found.load_scale, 0.926, 0.003);
    assert_like(found.load_offset, 0.045, 0.002);
    assert_like(found.coulomb, 0.0387, 0.0030);
    assert_like(found.coulomb_by_load, 0.0388, 0.0032);
    assert_like(found.viscous, 0.0040 / TURN, 0.0010 / TURN);
    assert!((found.rms - 4.5e-3).abs() < 2.5e-4, "{}", found.rms);
    assert!(found.standing.is_none() && found.doubts().is_empty(), "{:?}", found.doubts());
}

/// Plateaus found in the samples give the numbers of their author's means, within two deviations.
#[test]
fn samples_of_a_measured_winch_tell_the_same_as_its_plateaus() {
    for (mass, load, coulomb) in [("5", [0.9535, 0.0018], [0.0740, 0.0031]), ("1", [0.2267, 0.0015], [0.0494, 0.0029])]
    {
        let Some(record) = measured_samples(mass) else { return };
        let found = identify(&[record]).unwrap();
        assert!(found.directions.iter().all(|count| *count >= 4), "{found:?}");
        for (figure, [value, sigma]) in [(found.loads[0].torque, load), (found.coulomb, coulomb)] {
            let figure = figure.unwrap();
            assert!((figure.value - value).abs() < 2.0 * sigma, "{figure:?} instead of {value}");
            assert!(figure.sigma.unwrap() < 1.5 * sigma, "{figure:?} ± {sigma}");
        }
        assert!(found.doubts().is_empty(), "{:?}", found.doubts());
    }
}

#[test]
fn lifting_alone_of_a_measured_winch_tells_no_friction() {
    let Some(heavy) = measured("5") else { return };
    let rows: Vec<usize> = (0..heavy.len()).filter(|row| heavy.speeds[*row] > 0.0).collect();
    let pick = |from: &[f64]| rows.iter().map(|row| from[*row]).collect::<Vec<f64>>();
    let lifting = Record::of_plateaus(pick(&heavy.speeds), pick(&heavy.torques), heavy.loads.as_deref().map(pick));
    let found = identify(&[lifting]).unwrap();
    assert!(!found.is_determined() && found.coulomb.is_none(), "{found:?}");
}
