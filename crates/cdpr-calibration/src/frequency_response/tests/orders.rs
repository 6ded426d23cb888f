//! Orders of machines of other kinds, and their delay.

use super::machine::{Drive, Linear, R, chirp, multisine, noisy};
use crate::frequency_response::{Method, Orders, Record, Settings, Solution, identify};

fn found(record: &Record) -> (Solution, Orders) {
    let solution = identify(record, &Settings::default()).unwrap();
    let orders = solution.model.as_ref().unwrap().transfer.orders();
    (solution, orders)
}

/// Output that is the input, times three: it has no cut-off, which is told.
#[test]
fn a_pure_gain_has_no_poles_and_no_cutoff() {
    let drive = Drive::seconds(4000, 0.005);
    let mut record = drive.record(&Linear::drum(147e3), multisine(0.5, 100), 0);
    record.output = record.input.iter().map(|input| 3.0 * input).collect();
    let (solution, orders) = found(&noisy(&record, 0.1, 3));
    assert_eq!(orders, Orders { poles: 0, zeros: 0, has_delay: false });
    assert!((solution.model.as_ref().unwrap().gain.value - 3.0).abs() < 0.01);
    assert!(solution.verdict().is_negative() && solution.cutoff.is_none());
    assert!(solution.doubts[0].words().contains("no cut-off"), "{:?}", solution.doubts);
}

/// 1/(1 + s/30): its cut-off is 30/2π Hz against zero frequency.
#[test]
fn a_lag_has_one_pole() {
    let lag = Linear::rational(2.0, &[], &[1.0 / 30.0]);
    let record = Drive::seconds(6000, 0.005).record(&lag, chirp(0.2, 40.0, 30.0), 0);
    let (solution, orders) = found(&noisy(&record, 0.02, 5));
    assert_eq!(orders, Orders { poles: 1, zeros: 0, has_delay: false });
    let pole = solution.model.unwrap().poles[0];
    assert!((pole.value.re + 30.0).abs() < 4.0 * pole.sigma[0] && pole.sigma[0] < 0.3, "{pole:?}");
    // no peak: the gain is largest at the edge of the band
    assert!(solution.peak.unwrap().frequency.is_none());
}

/// Two resonances with an anti-resonance between them, as a drum with a platform behind its cable has.
#[test]
fn a_resonance_with_zeros_has_them() {
    let pair = |hertz: f64, damping: f64| {
        let omega = std::f64::consts::TAU * hertz;
        [2.0 * damping / omega, 1.0 / (omega * omega)]
    };
    let (first, second, zero) = (pair(5.0, 0.08), pair(14.0, 0.06), pair(9.0, 0.05));
    // (1 + a s + b s²)(1 + c s + d s²)
    let below = [
        first[0] + second[0],
        first[1] + second[1] + first[0] * second[0],
        first[0] * second[1] + first[1] * second[0],
        first[1] * second[1],
    ];
    let record = Drive::seconds(12_000, 0.005).record(&Linear::rational(1.0, &zero, &below), chirp(0.5, 45.0, 60.0), 0);
    let (solution, orders) = found(&noisy(&record, 0.02, 9));
    assert_eq!(orders, Orders { poles: 4, zeros: 2, has_delay: false }, "{:?}", solution.doubts);
    let model = solution.model.unwrap();
    for (root, hertz, damping) in
        [(&model.poles[0], 5.0, 0.08), (&model.poles[2], 14.0, 0.06), (&model.zeros[0], 9.0, 0.05)]
    {
        assert!((root.frequency() / hertz - 1.0).abs() < 0.01, "{root:?}");
        assert!((root.damping() / damping - 1.0).abs() < 0.05, "{root:?}");
    }
}

/// A delay of 5 ms: 8 inner steps of 0.625 ms.
#[test]
fn a_delay_is_found() {
    let drive = Drive::seconds(8000, 0.005);
    let record = drive.record(&Linear::drum(147e3), chirp(0.5, 40.0, 40.0), 8);
    let (solution, orders) = found(&noisy(&record, 0.3, 1));
    assert_eq!(orders, Orders { poles: 2, zeros: 0, has_delay: true });
    let delay = solution.model.unwrap().delay.unwrap();
    assert!((delay.value - 5e-3).abs() < 4.0 * delay.sigma && delay.sigma < 2e-4, "{delay:?}");
}

/// A zero on the right is a remark; a stepped sine is recognised, and its points are those of the closed form.
#[test]
fn a_stepped_sine_is_recognised_and_a_zero_on_the_right_is_told() {
    let frequencies: Vec<f64> = (0..24).map(|k| 0.8 * 1.18_f64.powi(k)).collect();
    let turned = |time: f64| {
        let (mut turns, mut left) = (0.0, time);
        for frequency in &frequencies {
            // 2 s, in whole cycles
            let length = (2.0 * frequency).ceil().max(7.0) / frequency;
            turns += frequency * left.min(length);
            left -= length;
            if left <= 0.0 {
                break;
            }
        }
        turns
    };
    let length: f64 = frequencies.iter().map(|frequency| (2.0 * frequency).ceil().max(7.0) / frequency).sum();
    let torque = |time: f64| (std::f64::consts::TAU * turned(time)).sin();
    let drive = Drive { samples: (length / 0.004) as usize, step: 0.004, inside: 4 };
    // (1 − s/60)/((1 + s/40)(1 + s/90))
    let machine = Linear::rational(1.0 / R, &[-1.0 / 60.0], &[1.0 / 40.0 + 1.0 / 90.0, 1.0 / 3600.0]);
    let (solution, orders) = found(&noisy(&drive.record(&machine, torque, 0), 0.1, 2));
    assert_eq!((solution.method, solution.points.len()), (Method::Sine, 24));
    assert_eq!(orders, Orders { poles: 2, zeros: 1, has_delay: false });
    assert!(solution.remarks.iter().any(|remark| remark.contains("not of minimum phase")), "{:?}", solution.remarks);
    let transfer = solution.model.unwrap().transfer;
    for point in &solution.points {
        let s = nalgebra::Complex::new(0.0, std::f64::consts::TAU * point.frequency);
        let expected = (1.0 - s / 60.0) / ((1.0 + s / 40.0) * (1.0 + s / 90.0)) / R;
        let off = (point.response - expected).norm();
        assert!(off < 6.0 * point.sigma + 3e-3 * expected.norm(), "{} Hz: {off} of {}", point.frequency, point.sigma);
        assert!((transfer.response(point.frequency) - expected).norm() < 0.01 * expected.norm().max(1.0));
    }
}
