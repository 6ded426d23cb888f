//! The drum on a cable of the dissertation (sec. 5.1): cut-offs of 12 and 19 Hz.

use super::machine::{C, ClosedForm, Drive, J, Linear, R, chirp, multisine, noisy};
use crate::frequency_response::{Method, Orders, Record, Settings, Solution, identify};

/// Part of cut-off and peak that the task allows an estimate to miss.
const ALLOWED: f64 = 0.02;

pub(super) fn records() -> Vec<(f64, &'static str, Record)> {
    let mut all = Vec::new();
    for stiffness in [147e3, 368e3] {
        let machine = Linear::drum(stiffness);
        let drive = Drive::seconds(8000, 1.0 / 200.0);
        all.push((stiffness, "chirp", drive.record(&machine, chirp(0.5, 50.0, 40.0), 0)));
        all.push((stiffness, "multisine", drive.record(&machine, multisine(0.2, 250), 0)));
    }
    all
}

fn check(solution: &Solution, stiffness: f64, what: &str) {
    let closed = ClosedForm { stiffness };
    let [first, _] = solution.band.unwrap();
    let (cutoff, peak) = (solution.cutoff.unwrap(), solution.peak.unwrap());
    let off = |found: f64, expected: f64, name: &str| {
        let error = (found / expected - 1.0).abs();
        assert!(error < ALLOWED, "{what} {stiffness}: {name} {found} instead of {expected}");
    };
    off(cutoff.value, closed.cutoff(first), "cut-off");
    off(cutoff.value, closed.cutoff(0.0), "cut-off against zero frequency");
    off(peak.gain.value, closed.peak().1, "peak");
    off(peak.frequency.unwrap().value, closed.peak().0, "frequency of the peak");
}

#[test]
fn closed_forms_are_the_printed_ones() {
    for (stiffness, cutoff, zeta) in [(147e3, 12.00, 0.20), (368e3, 19.32, 0.126)] {
        let found = ClosedForm { stiffness }.cutoff(0.0);
        assert!((found - cutoff).abs() < 0.005, "{found}");
        let pole = ClosedForm { stiffness }.pole();
        assert!((-pole.re / pole.norm() - zeta).abs() < 0.001);
    }
    assert!((1.0 / R - 6.557).abs() < 0.001 && J > 0.0 && C > 0.0);
}

/// With noise of a fiftieth of the largest tension: within 2 % of the closed form, with two poles and no zero.
#[test]
fn cutoff_and_peak_are_those_of_the_closed_form() {
    for (stiffness, what, record) in records() {
        let solution = identify(&noisy(&record, 0.3, 7), &Settings::default()).unwrap();
        assert!(solution.doubts.is_empty(), "{:?}", solution.doubts);
        assert_eq!(solution.method, Method::H1);
        check(&solution, stiffness, what);
        let model = solution.model.unwrap();
        assert_eq!(model.transfer.orders(), Orders { poles: 2, zeros: 0, has_delay: false }, "{what} {stiffness}");
        assert!((model.gain.value * R - 1.0).abs() < ALLOWED);
        let pole = ClosedForm { stiffness }.pole();
        assert!((model.poles[0].value - pole).norm() < ALLOWED * pole.norm(), "{:?}", model.poles);
    }
}

/// Without noise only sampling is left: the input is a straight line between 1 600 samples a second, (π f/1600)²/3 of the gain at 20 Hz is 0.05 %.
#[test]
fn without_noise_windows_leave_a_thousandth() {
    for (stiffness, what, record) in records() {
        let solution = identify(&record, &Settings::default()).unwrap();
        let closed = ClosedForm { stiffness };
        let cutoff = solution.cutoff.unwrap().value / closed.cutoff(solution.band.unwrap()[0]) - 1.0;
        let peak = solution.peak.unwrap().gain.value / closed.peak().1 - 1.0;
        assert!(cutoff.abs() < 1e-3 && peak.abs() < 2e-3, "{what} {stiffness}: {cutoff:.2e} {peak:.2e}");
    }
}
