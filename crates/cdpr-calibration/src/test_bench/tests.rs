//! Records of a cable whose law is none of ours come back within what the bench's noise leaves.

use super::*;
use cdpr_model::cable::stretch::polynomial_law;

/// A rope by Bouc's and Wen's equation: stiffening as in Fig. 5.7 (500 N to 12 kN over 45 mm of a sample of 20 m, 38 to
/// 600 kN/m), with friction that grows with the tension.
fn bouc_wen(elongations: &[f64], noise: f64) -> Record {
    let mut record = Record::default();
    let (mut before, mut z) = (elongations[0], -1.0_f64);
    for (row, &elongation) in elongations.iter().enumerate() {
        let (x, step) = (elongation / 0.045, elongation - before);
        // z′ = (1 − sgn(Δe) z)/3 mm, exactly over the step
        z = step.signum() + (z - step.signum()) * (-step.abs() / 0.003).exp();
        before = elongation;
        let elastic = 500.0 + 1700.0 * x + 3000.0 * x.powi(2) + 6800.0 * x.powi(5);
        // noise that repeats, so that the test does
        let shake = (((row * 7919 + 13) % 101) as f64 / 50.0 - 1.0) * noise;
        record.elongations.push(elongation + 1e-8 * shake);
        record.tensions.push(elastic + z * (60.0 + 0.06 * elastic) + shake);
    }
    record
}

/// Cycles between 0 and 45 mm in steps of 0.1 mm.
fn cycles(count: usize) -> Vec<f64> {
    let stroke: Vec<f64> = (0..=450).map(|k| 1e-4 * f64::from(k)).collect();
    let cycle: Vec<f64> = stroke.iter().copied().chain(stroke.iter().rev().copied()).collect();
    std::iter::repeat_n(cycle, count).flatten().collect()
}

fn settings() -> Settings {
    Settings::of_length(20.0)
}

#[test]
fn both_branches_of_a_foreign_law_come_back_within_half_a_percent_of_the_range() {
    let solution = identify(&bouc_wen(&cycles(2), 10.0), &settings()).unwrap();
    let range = solution.tensions[1] - solution.tensions[0];
    // the aim of the dissertation's fit; its straight line was off by up to 600 N of 12 kN, 5 %
    assert!(solution.loading.rms < 0.005 * range && solution.unloading.rms < 0.005 * range, "{solution:?}");
    assert!(solution.hysteresis.max < 0.015 * range, "{:?}", solution.hysteresis);
    assert!(solution.linear.misfit.rms > 0.04 * range && solution.linear.misfit.rms < 0.2 * range);
    let polynomial = solution.polynomial.as_ref().unwrap();
    assert!(polynomial.misfit.rms < solution.linear.misfit.rms && solution.hysteresis.rms < polynomial.misfit.rms);
    assert!(polynomial_law(&polynomial.coefficients, Some(solution.tensions[1])).is_ok());
    // the areas of loop and of record
    assert!(
        (solution.loss / solution.measured_loss - 1.0).abs() < 0.05,
        "{} {}",
        solution.loss,
        solution.measured_loss
    );
    assert_eq!(solution.strokes, [2, 2]);
}

/// The law was fitted to large cycles; small ones inside, of another record, are predicted.
#[test]
fn small_cycles_inside_a_large_one_are_predicted() {
    let solution = identify(&bouc_wen(&cycles(2), 0.0), &settings()).unwrap();
    let law = hysteresis_law(&solution.table).unwrap();
    let small = (0..=100).map(|k| 0.03 - 4e-5 * f64::from(k)).chain((0..=100).map(|k| 0.026 + 4e-5 * f64::from(k)));
    let path: Vec<f64> = cycles(1).into_iter().take(301).chain(small).collect();
    let record = bouc_wen(&path, 0.0);
    let strain = |elongation: f64| (elongation - solution.zero) / 20.0;
    let start = cdpr_model::cable::stretch::hysteresis::Memory::on_unloading_branch(strain(0.0));
    let residuals = residuals(&law, start, &record.elongations, &record.tensions, strain);
    // below 1 % of the range of 12 kN; Bouc's and Wen's own small loops drift, ours close
    let misfit = Misfit::of(residuals[301..].iter().copied());
    assert!(misfit.rms < 115.0, "{misfit:?}");
}

#[test]
fn a_cable_without_hysteresis_gets_branches_that_lie_together() {
    let record = Record { tensions: cycles(1).iter().map(|e| 500.0 + 2e5 * e).collect(), ..bouc_wen(&cycles(1), 0.0) };
    let solution = identify(&record, &settings()).unwrap();
    assert!(solution.linear.misfit.max < 1e-6 && (solution.linear.axial_stiffness / 4e6 - 1.0).abs() < 1e-9);
    // the least width that keeps the branches apart is 1e-5 of the range
    assert!(solution.hysteresis.max < 2.0 && solution.loss < 0.01 * 0.045 * 9000.0, "{solution:?}");
}

/// A rope recorded from 1 kN on, where its stiffness is small: the polynomial became a line without a word, with 826 N rms.
#[test]
fn a_record_that_begins_under_tension_has_a_polynomial_with_a_preload() {
    let friction = bouc_wen(&cycles(2), 0.0);
    let mut record = friction.clone();
    let mut z = -1.0_f64;
    let mut before = 0.0;
    for (row, &elongation) in friction.elongations.iter().enumerate() {
        let (x, step) = (elongation / 0.045, elongation - before);
        z = step.signum() + (z - step.signum()) * (-step.abs() / 0.003).exp();
        before = elongation;
        record.tensions[row] = 1000.0 + 1000.0 * x + 10_820.0 * x * x + 175.0 * z;
    }
    let solution = identify(&record, &settings()).unwrap();
    let (free, law) = (solution.with_intercept.unwrap(), solution.polynomial.unwrap());
    assert!((solution.linear.misfit.rms - 826.0).abs() < 2.0, "{:?}", solution.linear);
    // its own quadratic errs by 159 N, half the width of the loop
    assert!((free.misfit.rms - 159.0).abs() < 3.0 && (free.intercept - 1000.0).abs() < 175.0, "{free:?}");
    assert!(law.misfit.rms < 160.0, "{law:?}");
    let stretch = polynomial_law(&law.coefficients, Some(solution.tensions[1])).unwrap();
    assert!((stretch.tension(law.preload_strain).0 / law.preload - 1.0).abs() < 1e-12 && stretch.tension(0.0).0 == 0.0);
    assert!((law.preload - 1000.0).abs() < 200.0 && law.preload_strain > 1e-4, "{law:?}");
}

#[test]
fn a_column_of_directions_gives_the_same() {
    let record = bouc_wen(&cycles(2), 0.0);
    let directions = (0..record.elongations.len()).map(|row| if row % 902 < 451 { 1.0 } else { -1.0 }).collect();
    let with = identify(&Record { directions: Some(directions), ..record.clone() }, &settings()).unwrap();
    let without = identify(&record, &settings()).unwrap();
    assert!((with.hysteresis.rms - without.hysteresis.rms).abs() < 1.0);
}

#[test]
fn records_that_determine_no_law_are_refused_with_the_reason() {
    let refused = |record: &Record| identify(record, &settings()).unwrap_err();
    let half: Vec<f64> = cycles(1).into_iter().take(451).collect();
    assert_eq!(refused(&bouc_wen(&half, 0.0)), InputError::TooFewCycles { loading: 1, unloading: 0, percent: 80 });
    assert!(matches!(refused(&bouc_wen(&half[..20], 0.0)), InputError::TooFewRows { needed: 56, .. }));
    let mut reversed = bouc_wen(&cycles(1), 0.0);
    reversed.tensions.reverse();
    assert!(matches!(refused(&reversed), InputError::BranchesCross { .. }), "{}", refused(&reversed));
    let mut falling = bouc_wen(&cycles(1), 0.0);
    falling.tensions.iter_mut().for_each(|tension| *tension = 13_000.0 - *tension);
    assert!(matches!(refused(&falling), InputError::NotRising { .. }));
    let still = Record { tensions: vec![5.0; 902], ..bouc_wen(&cycles(1), 0.0) };
    assert_eq!(refused(&still), InputError::NoRange { what: "tension" });
}

#[test]
fn a_record_is_read_in_its_units_and_mistakes_are_told_with_their_place() {
    let text = "t_s,elongation_mm,tension_kN,direction\n0,1.5,0.5,1\n1,2.0,0.6,unloading\n";
    let reading = Record::from_csv(text.as_bytes(), "bench.csv").unwrap();
    assert_eq!(reading.record.elongations, [1.5e-3, 2e-3]);
    assert_eq!(reading.record.tensions, [500.0, 600.0]);
    assert_eq!(reading.record.directions, Some(vec![1.0, -1.0]));
    assert!(reading.notices[0].contains("t_s"));
    for (from, to, place, code) in [
        ("2.0,0.6", "2.0,much", (3, 7), "csv::not-a-number"),
        ("tension_kN", "tension_lbf", (1, 19), "csv::unknown-unit"),
        ("tension_kN", "pull", (1, 1), "csv::missing-column"),
        ("0.5,1\n", "0.5\n", (2, 7), "csv::ragged-row"),
    ] {
        let error = Record::from_csv(text.replacen(from, to, 1).as_bytes(), "bench.csv").unwrap_err();
        assert_eq!((error.line().unwrap(), error.column().unwrap(), error.code), (place.0, place.1, code), "{error}");
        assert!(error.help.is_some());
    }
}
