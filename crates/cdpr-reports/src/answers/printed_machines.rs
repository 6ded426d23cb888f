//! Errors that were measured of real machines, as printed.

use serde::Serialize;

/// Measured of a real machine, as printed.
#[derive(Clone, Copy, Serialize)]
pub(super) struct PrintedMachine {
    pub(super) machine: &'static str,
    pub(super) position_mean_m: f64,
    pub(super) rotation_mean_rad: Option<f64>,
    pub(super) length_mean_abs_m: Option<f64>,
    #[serde(rename = "tension_mean_norm_N")]
    pub(super) tension: Option<f64>,
    pub(super) source: &'static str,
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Reference rows (sec. 6.1, 6.2, 6.5).
pub(super) const PRINTED: [PrintedMachine; 5] = [
    PrintedMachine {
        machine: "CableRobot Simulator, nominal standard model",
        position_mean_m: 0.03980,
        rotation_mean_rad: Some(1.19 * DEGREE),
        length_mean_abs_m: Some(0.02352),
        tension: None,
        source: "Miermeister 2021, eq. 6.4 to 6.6",
    },
    PrintedMachine {
        machine: "IPAnema, unladen, standard model",
        position_mean_m: 0.0414,
        rotation_mean_rad: Some(1.9 * DEGREE),
        length_mean_abs_m: None,
        tension: None,
        source: "Kraus 2016, in Miermeister 2021, sec. 6.1",
    },
    PrintedMachine {
        machine: "CableRobot Simulator, standard model identified and driven",
        position_mean_m: 0.00670,
        rotation_mean_rad: Some(0.31 * DEGREE),
        length_mean_abs_m: Some(0.00415),
        tension: None,
        source: "Miermeister 2021, sec. 6.2",
    },
    PrintedMachine {
        machine: "CableRobot Simulator, nominal elastostatic model, predicted",
        position_mean_m: 0.0345,
        rotation_mean_rad: Some(1.03 * DEGREE),
        length_mean_abs_m: None,
        tension: Some(2426.84),
        source: "Miermeister 2021, sec. 6.4",
    },
    PrintedMachine {
        machine: "CableRobot Simulator, elastostatic model identified, predicted",
        position_mean_m: 0.00273,
        rotation_mean_rad: Some(0.11 * DEGREE),
        length_mean_abs_m: None,
        tension: Some(582.0),
        source: "Miermeister 2021, sec. 6.5",
    },
];
