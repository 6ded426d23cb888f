//! Records that do not tell all that is asked.

use super::machine::{Drive, Linear, chirp, noisy};
use crate::Verdict;
use crate::frequency_response::{InputError, OrderChoice, Orders, Record, Settings, identify};

fn record() -> Record {
    Drive::seconds(4000, 0.005).record(&Linear::drum(147e3), chirp(0.5, 40.0, 20.0), 0)
}

#[test]
fn noise_alone_is_not_trusted_and_has_no_figures() {
    let mut record = noisy(&record(), 0.0, 1);
    record.output.fill(0.0);
    let solution = identify(&noisy(&record, 1.0, 4), &Settings::default()).unwrap();
    assert_eq!(solution.verdict(), Verdict::NotTrusted);
    assert!(solution.cutoff.is_none() && solution.peak.is_none());
    assert!(solution.doubts[0].words().contains("coherence"));
}

/// A pole and a zero at the same place, asked for by their orders.
#[test]
fn a_pole_that_a_zero_cancels_is_told() {
    let orders = OrderChoice::Given(Orders { poles: 3, zeros: 1, has_delay: false });
    let settings = Settings { orders, ..Settings::default() };
    let solution = identify(&noisy(&record(), 0.3, 8), &settings).unwrap();
    let told = solution.doubts.iter().any(|doubt| doubt.words().contains("cancel"));
    assert!(told || solution.model.is_none(), "{:?} {:?}", solution.doubts, solution.model);
}

/// One pole cannot follow a resonance: misfit is a caution.
#[test]
fn a_model_that_does_not_explain_its_points_is_told() {
    let orders = OrderChoice::Given(Orders { poles: 1, zeros: 0, has_delay: false });
    let settings = Settings { orders, ..Settings::default() };
    let solution = identify(&noisy(&record(), 0.3, 8), &settings).unwrap();
    assert!(solution.doubts.iter().any(|doubt| doubt.words().contains("standard deviations of its points")));
}

/// A window of 8 s and its half fit a resonance of 0.3 Hz badly where windows are half a second.
#[test]
fn a_resonance_that_windows_do_not_resolve_is_told() {
    let sharp = Linear::rational(1.0, &[], &[2.0 * 0.01 / 50.0, 1.0 / 2500.0]);
    let record = Drive::seconds(4000, 0.005).record(&sharp, chirp(0.5, 40.0, 20.0), 0);
    let settings = Settings { window: Some(0.5), ..Settings::default() };
    let solution = identify(&noisy(&record, 0.01, 8), &settings).unwrap();
    assert!(solution.verdict().is_negative() && solution.cutoff.is_none(), "{:?}", solution.doubts);
}

/// Mean and drift are no response; rounded times are interpolated and told.
#[test]
fn mean_drift_and_rounded_times_change_nothing() {
    let clean = noisy(&record(), 0.3, 8);
    let expected = identify(&clean, &Settings::default()).unwrap();
    let mut moved = clean.clone();
    for (k, (input, output)) in moved.input.iter_mut().zip(&mut moved.output).enumerate() {
        *input += 300.0 - 0.001 * k as f64;
        *output += 2000.0 + 0.02 * k as f64;
    }
    let found = identify(&moved, &Settings::default()).unwrap();
    let ratio = found.cutoff.unwrap().value / expected.cutoff.unwrap().value;
    // lines are taken off to rounding of numbers of 2 000
    assert!((ratio - 1.0).abs() < 1e-8, "{ratio}");
    moved.times.iter_mut().enumerate().for_each(|(k, time)| *time += 2e-4 * f64::from((k * 7 % 11) as u32) / 11.0);
    let jittered = identify(&moved, &Settings::default()).unwrap();
    let remark = jittered.remarks.iter().find(|remark| remark.contains("interpolated"));
    assert!(jittered.jitter.is_some() && remark.is_some(), "{:?}", jittered.remarks);
    let ratio = jittered.cutoff.unwrap().value / expected.cutoff.unwrap().value;
    // 4 % of a step of jitter that input and output share
    assert!((ratio - 1.0).abs() < 5e-3, "{ratio}");
}

#[test]
fn records_that_are_none_are_refused() {
    let whole = record();
    let refused = |change: fn(&mut Record)| {
        let mut record = whole.clone();
        change(&mut record);
        identify(&record, &Settings::default()).unwrap_err()
    };
    assert!(matches!(refused(|record| record.input.truncate(7)), InputError::Lengths { input: 7, .. }));
    assert!(matches!(refused(|record| record.output[9] = f64::NAN), InputError::NotFinite { row: 10 }));
    assert!(matches!(refused(|record| record.times.swap(4, 5)), InputError::TimeOrder { row: 6, .. }));
    assert!(matches!(refused(|record| record.input.fill(1.0)), InputError::NoRange { what: "input" }));
    let gap = refused(|record| record.times[100..].iter_mut().for_each(|time| *time += 0.02));
    assert!(matches!(gap, InputError::Uneven { row: 101, gap, .. } if (gap - 0.025).abs() < 1e-9), "{gap}");
}
