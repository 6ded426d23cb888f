//! Winches whose friction is known, and records that cannot tell it.

use super::*;

/// Shakes that repeat, from −1 to 1.
fn shake(row: usize) -> f64 {
    ((row * 7919 + 13) % 101) as f64 / 50.0 - 1.0
}

/// A law of a winch: a, b, c₀, c₁, d, and excess and speed of its Stribeck part.
#[derive(Clone, Copy)]
struct Truth {
    load: [f64; 2],
    coulomb: [f64; 2],
    viscous: f64,
    stribeck: Option<[f64; 2]>,
}

const TRUTH: Truth = Truth { load: [0.95, 0.04], coulomb: [0.04, 0.05], viscous: 8e-4, stribeck: None };

impl Truth {
    fn torque(&self, speed: f64, load: f64) -> f64 {
        let excess = self.stribeck.map_or(0.0, |[excess, own]| excess * (-(speed / own).powi(2)).exp());
        let friction = self.coulomb[0] + self.coulomb[1] * load + excess + self.viscous * speed.abs();
        self.load[0] * load + self.load[1] + speed.signum() * friction
    }

    fn record(&self, speeds: &[f64], loads: &[f64], noise: f64) -> Record {
        let rows: Vec<(f64, f64)> =
            loads.iter().flat_map(|load| speeds.iter().flat_map(|v| [(*v, *load), (-*v, *load)])).collect();
        let torques =
            rows.iter().enumerate().map(|(row, (v, load))| self.torque(*v, *load) + noise * shake(row)).collect();
        let loads = rows.iter().map(|(_, load)| *load).collect();
        Record::of_plateaus(rows.iter().map(|(v, _)| *v).collect(), torques, Some(loads))
    }
}

const SPEEDS: [f64; 5] = [3.0, 6.0, 12.0, 18.0, 25.0];

fn assert_near(figure: Option<Figure>, expected: f64, tolerance: f64) {
    let value = figure.unwrap().value;
    assert!((value - expected).abs() <= tolerance, "{value} instead of {expected}");
}

#[test]
fn a_law_without_noise_comes_back_with_all_its_numbers() {
    let truth = Truth { stribeck: Some([0.03, 1.5]), ..TRUTH };
    let speeds = [0.4, 0.8, 1.2, 1.8, 2.5, 4.0, 8.0, 16.0];
    let found = identify(&[truth.record(&speeds, &[0.2, 1.0], 0.0)]).unwrap();
    // rounding of sums of numbers near 1; the search ends at a relative gain of 1e-14 of squares
    for (figure, expected) in [
        (found.load_scale, 0.95),
        (found.load_offset, 0.04),
        (found.coulomb, 0.04),
        (found.coulomb_by_load, 0.05),
        (found.viscous, 8e-4),
        (found.standing, 0.07),
    ] {
        assert_near(figure, expected, 1e-8);
    }
    assert_near(found.stribeck_speed, 1.5, 1e-6);
    assert!(found.rms < 1e-9 && found.doubts().is_empty(), "{found:?}");
}

/// Values of every branch: the law's derivatives against central differences; truncation ~ h², rounding ~ ε/h.
#[test]
fn derivatives_of_the_law_are_those_of_differences() {
    let plateaus = |speed, group| Plateau { speed, group, load: Some(0.7), ..plateau() };
    for (is_scaled, by_load, stribeck, by_direction) in
        [(true, true, true, true), (false, true, true, false), (false, false, false, true), (true, false, true, false)]
    {
        let law = law::Law { loads: 2, is_scaled, by_load, stribeck, by_direction };
        let parameters: Vec<f64> = (0..law.count()).map(|k| 0.3 + 0.17 * k as f64).collect();
        for plateau in [plateaus(1.3, 0), plateaus(-2.1, 1), plateaus(-0.2, 0)] {
            let mut gradient = vec![0.0; law.count()];
            law.torque(&plateau, &parameters, &mut gradient);
            for k in 0..law.count() {
                let at = |step: f64| {
                    let mut moved = parameters.clone();
                    moved[k] += step;
                    law.torque(&plateau, &moved, &mut vec![0.0; law.count()])
                };
                let slope = (at(1e-6) - at(-1e-6)) / 2e-6;
                assert!((slope - gradient[k]).abs() < 1e-8, "{k} of {law:?}: {slope} and {}", gradient[k]);
            }
        }
    }
}

fn plateau() -> Plateau {
    Plateau {
        record: 0,
        lines: [1, 1],
        samples: 1,
        speed: 1.0,
        torque: 0.0,
        load: None,
        group: 0,
        standard_error: None,
        speed_ratio: None,
    }
}

fn open(found: &Solution) -> Vec<&'static str> {
    found.undetermined.iter().map(|open| open.quantity.key()).collect()
}

#[test]
fn lifting_alone_tells_friction_by_speed_but_neither_load_nor_dry_friction() {
    for sign in [1.0, -1.0] {
        let speeds: Vec<f64> = SPEEDS.iter().map(|v| sign * v).collect();
        let torques = speeds.iter().map(|v| TRUTH.torque(*v, 1.0)).collect();
        let found = identify(&[Record::of_plateaus(speeds, torques, None)]).unwrap();
        assert!(found.coulomb.is_none() && found.loads[0].torque.is_none() && !found.is_determined());
        assert_near(found.viscous, 8e-4, 1e-9);
        let doubt = &found.doubts()[0];
        let (have, lack) = if sign > 0.0 { ("lifting", "lowering") } else { ("lowering", "lifting") };
        assert!(doubt.words().contains(&format!("{have} alone cannot tell friction from the load")), "{doubt:?}");
        assert!(doubt.words().contains(&format!("Record {lack}, too")), "{doubt:?}");
        assert_eq!(crate::Verdict::of_fit(&found.doubts()), crate::Verdict::NotIdentifiable);
    }
}

#[test]
fn one_speed_tells_the_whole_friction_and_not_its_parts() {
    // noise of speed is no second speed
    let speeds = [5.0, 5.01, 4.99, 5.02, 5.03, 4.98];
    let found = identify(&[TRUTH.record(&speeds, &[0.8], 1e-4)]).unwrap();
    assert!(found.viscous.is_none() && open(&found).contains(&"viscous_Nm_s_per_rad"), "{found:?}");
    // c₀ + c₁ load + d v
    assert_near(found.coulomb, 0.04 + 0.04 + 8e-4 * 5.0, 1e-4);
    assert!(found.doubts().iter().any(|doubt| doubt.words().contains("one speed")), "{:?}", found.doubts());
    // two loads, each at a speed of its own: growth with the load and friction by speed are one
    let (one, other) = (TRUTH.record(&[5.0, 5.01], &[0.2], 0.0), TRUTH.record(&[15.0, 15.02], &[1.0], 0.0));
    let found = identify(&[one, other]).unwrap();
    assert!(found.viscous.is_none() && found.coulomb_by_load.is_none(), "{found:?}");
    assert_near(found.load_scale, 0.95, 1e-9);
}

#[test]
fn one_load_tells_the_mean_coulomb_friction_and_its_own_torque() {
    let found = identify(&[TRUTH.record(&SPEEDS, &[0.8], 0.0)]).unwrap();
    assert_near(found.coulomb, 0.04 + 0.05 * 0.8, 1e-9);
    assert_near(found.loads[0].torque, 0.95 * 0.8 + 0.04, 1e-9);
    // a load that is exact makes directions differ by twice what it lacks
    let [lifting, lowering] = found.loads[0].if_exact.unwrap();
    assert!((lifting.value - lowering.value + 2.0 * (0.8 - 0.8 * 0.95 - 0.04)).abs() < 1e-9, "{found:?}");
    for key in ["coulomb_by_load", "load_scale", "load_offset_Nm", "static_Nm", "coulomb_by_direction"] {
        assert!(open(&found).contains(&key), "{key}: {:?}", open(&found));
    }
}

/// Without given torques each record has a load of its own: c₁ is then per fitted torque, c₀ + c₁ (L − b)/a.
#[test]
fn records_of_two_loads_tell_growth_with_the_fitted_load() {
    let bare = |load: f64| Record { loads: None, ..TRUTH.record(&SPEEDS, &[load], 0.0) };
    let found = identify(&[bare(0.2), bare(1.0)]).unwrap();
    assert_near(found.loads[0].torque, 0.95 * 0.2 + 0.04, 1e-9);
    assert_near(found.loads[1].torque, 0.95 + 0.04, 1e-9);
    assert_near(found.coulomb_by_load, 0.05 / 0.95, 1e-8);
    assert_near(found.coulomb, 0.04 - 0.05 * 0.04 / 0.95, 1e-8);
    assert_near(found.loads[1].coulomb, 0.09, 1e-9);
    // the second load only lifted: the first is told as if it were alone
    let lifted = bare(1.0);
    let rows: Vec<usize> = (0..lifted.len()).filter(|row| lifted.speeds[*row] > 0.0).collect();
    let pick = |from: &[f64]| rows.iter().map(|&row| from[row]).collect();
    let lifted = Record::of_plateaus(pick(&lifted.speeds), pick(&lifted.torques), None);
    let found = identify(&[bare(0.2), lifted]).unwrap();
    assert_near(found.loads[0].torque, 0.95 * 0.2 + 0.04, 1e-9);
    assert_near(found.coulomb, 0.05, 1e-9);
    assert!(found.loads[1].torque.is_none() && found.coulomb_by_load.is_none(), "{found:?}");
    assert!(found.undetermined[0].reason.contains("record 2"), "{:?}", found.undetermined);
}

#[test]
fn three_rows_have_numbers_but_nothing_that_tells_their_errors() {
    let (speeds, load) = (vec![3.0, 20.0, -3.0], vec![0.5; 3]);
    let torques = speeds.iter().map(|v| TRUTH.torque(*v, 0.5)).collect();
    let found = identify(&[Record::of_plateaus(speeds, torques, Some(load))]).unwrap();
    assert_near(found.coulomb, 0.04 + 0.05 * 0.5, 1e-9);
    assert_eq!((found.coulomb.unwrap().sigma, found.freedom), (None, 0));
    assert!(found.doubts().iter().any(|doubt| doubt.words().contains("nothing is left")), "{:?}", found.doubts());
}

#[test]
fn a_record_at_rest_tells_what_it_lacks() {
    let record = Record::of_plateaus(vec![0.0; 5], vec![0.1, 0.2, 0.3, 0.2, 0.1], None);
    let found = identify(&[record]).unwrap();
    assert!(!found.is_determined() && found.left_out.at_rest == 5, "{found:?}");
    assert!(found.doubts()[0].words().contains("no row slides"), "{:?}", found.doubts());
    // beside rows that slide, rest bounds standing friction
    let mut record = TRUTH.record(&SPEEDS, &[0.8], 0.0);
    record.lines.extend([98, 99]);
    record.speeds.extend([0.0, 0.0]);
    record.torques.extend([0.7, 0.9]);
    record.loads.as_mut().unwrap().extend([0.8, 0.8]);
    let found = identify(&[record]).unwrap();
    assert!((found.break_away.unwrap() - 0.1).abs() < 1e-9, "{found:?}");
}

#[test]
fn rows_and_files_that_are_there_twice_count_once() {
    let record = TRUTH.record(&SPEEDS, &[0.2, 1.0], 5e-3);
    let once = identify(std::slice::from_ref(&record)).unwrap();
    let twice = identify(&[record.clone(), record.clone()]).unwrap();
    assert_eq!((twice.coulomb, twice.left_out.duplicates), (once.coulomb, 20));
    let mut copied = record.clone();
    copied.lines.push(99);
    copied.speeds.push(record.speeds[3]);
    copied.torques.push(record.torques[3]);
    copied.loads.as_mut().unwrap().push(record.loads.as_ref().unwrap()[3]);
    let copied = identify(&[copied]).unwrap();
    assert_eq!((copied.coulomb, copied.left_out.duplicates), (once.coulomb, 1));
}

#[test]
fn a_sign_that_is_turned_is_not_trusted() {
    let record = TRUTH.record(&SPEEDS, &[0.2, 1.0], 1e-3);
    let turned = Record { speeds: record.speeds.iter().map(|v| -v).collect(), ..record };
    let doubts = identify(&[turned]).unwrap().doubts();
    assert_eq!(crate::Verdict::of_fit(&doubts), crate::Verdict::NotTrusted, "{doubts:?}");
}

#[test]
fn a_plateau_that_is_none_of_the_others_is_left_out_and_named() {
    let mut record = TRUTH.record(&SPEEDS, &[0.2, 1.0], 2e-3);
    record.torques[7] += 0.1;
    let found = identify(&[record]).unwrap();
    let names: Vec<usize> =
        found.plateaus.iter().filter(|own| own.is_outlier).map(|own| own.plateau.lines[0]).collect();
    assert_eq!(names, [8]);
    assert!(found.doubts()[0].words().contains("line 8"), "{:?}", found.doubts());
    // within noise of 2 mN·m, uniform, of 19 rows
    assert_near(found.coulomb, 0.04, 4e-3);
}

#[test]
fn friction_that_falls_with_speed_at_one_speed_is_said_and_not_named() {
    let truth = Truth { stribeck: Some([0.04, 1.0]), ..TRUTH };
    let speeds = [0.5, 0.51, 5.0, 8.0, 12.0, 18.0, 25.0];
    let found = identify(&[truth.record(&speeds, &[0.2, 1.0], 5e-4)]).unwrap();
    assert!(found.standing.is_none() && open(&found).contains(&"static_Nm"), "{found:?}");
    assert_near(found.coulomb, 0.04, 2e-3);
}

#[test]
fn records_that_are_none_are_refused_with_the_reason() {
    let of = |speeds: Vec<f64>, torques: Vec<f64>| Record::of_plateaus(speeds, torques, None);
    assert_eq!(identify(&[]).unwrap_err(), InputError::Empty);
    let constant = identify(&[of(vec![1.0, 2.0, -1.0, -2.0], vec![0.3; 4])]).unwrap_err();
    assert_eq!(constant, InputError::ConstantTorque { torque: 0.3, rows: 4 });
    let not_a_number = identify(&[of(vec![1.0, f64::NAN], vec![0.3, 0.4])]).unwrap_err();
    assert_eq!(not_a_number, InputError::NotFinite { record: 1, line: 2, what: "speeds" });
    let short = identify(&[of(vec![1.0, 2.0], vec![0.3])]).unwrap_err();
    assert!(matches!(short, InputError::Lengths { what: "torques", found: 1, rows: 2, .. }));
    let mixed = [TRUTH.record(&SPEEDS, &[0.2], 0.0), of(vec![1.0, -1.0], vec![0.3, 0.1])];
    assert_eq!(identify(&mixed).unwrap_err(), InputError::MixedLoads { with: 1, all: 2 });
}
