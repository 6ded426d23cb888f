//! Configuration of firmware that cable robots run on, as lines of its own files.
//!
//! Both know straight cables from anchors to one point and lengths in millimetres; what else the robot's file states is left out aloud.

use std::f64::consts::TAU;

use cdpr_model::geometry::MotionPattern;
use cdpr_model::robot::{Cable, Robot};
use thiserror::Error;

/// A firmware.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Firmware {
    /// RepRapFirmware 3 from 3.4 on, Hangprinter kinematics: `M669` with the anchors and `M666` with the spools.
    RepRapFirmware,
    /// Klipper, winch kinematics: a section for each stepper.
    Klipper,
}

/// Lines of a configuration file, and what they leave out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Configuration {
    /// Lines without their ends.
    pub lines: Vec<String>,
    /// Properties of the robot that the firmware does not know.
    pub left_out: Vec<String>,
}

/// A robot that the firmware cannot run.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum FirmwareError {
    /// A platform that turns, or cables that do not meet in its origin.
    #[error(
        "the firmware knows point platforms in space (3T, all platform anchors in the origin), and this robot is none: {0}"
    )]
    Platform(&'static str),
    /// Another number of cables.
    #[error("the firmware takes {needed}, and the robot has {found}")]
    CableCount {
        /// Number that it takes, in words.
        needed: &'static str,
        /// Cables of the robot.
        found: usize,
    },
}

/// Letters of RepRapFirmware's anchors.
const LETTERS: [char; 4] = ['A', 'B', 'C', 'D'];

/// Configuration of a firmware for a robot.
pub fn configuration(robot: &Robot, firmware: Firmware) -> Result<Configuration, FirmwareError> {
    if robot.motion_pattern != MotionPattern::SpatialPoint {
        return Err(FirmwareError::Platform("its motion pattern is another one"));
    }
    if robot.cables.iter().any(|cable| cable.platform_anchor.norm() > 0.0) {
        return Err(FirmwareError::Platform("a platform anchor lies beside the origin"));
    }
    let mut configuration = match firmware {
        Firmware::RepRapFirmware => reprap(robot)?,
        Firmware::Klipper => klipper(robot)?,
    };
    let is_any = |of: fn(&Cable) -> bool| robot.cables.iter().any(of);
    let others = [
        (is_any(|cable| cable.pulley_radius().is_some_and(|radius| radius > 0.0)), "pulleys"),
        (is_any(|cable| cable.length_scale.is_some_and(|scale| scale != 1.0)), "length scales"),
        (is_any(|cable| cable.length_offset.is_some_and(|offset| offset != 0.0)), "length offsets"),
        (is_any(|cable| cable.stiffness.is_some()), "elasticity of cables"),
    ];
    configuration.left_out.extend(others.into_iter().filter(|(has, _)| *has).map(|(_, words)| words.to_owned()));
    Ok(configuration)
}

fn millimetres(metres: f64) -> String {
    format!("{:.3}", 1e3 * metres + 0.0)
}

fn reprap(robot: &Robot) -> Result<Configuration, FirmwareError> {
    let cables = &robot.cables;
    if cables.len() != LETTERS.len() {
        return Err(FirmwareError::CableCount { needed: "four anchors, A to D", found: cables.len() });
    }
    let joined = |of: &dyn Fn(&Cable) -> String| cables.iter().map(of).collect::<Vec<_>>().join(":");
    let anchor = |(letter, cable): (&char, &Cable)| {
        let coordinates: Vec<String> = cable.frame_anchor.iter().map(|metres| millimetres(*metres)).collect();
        format!("{letter}{}", coordinates.join(":"))
    };
    let anchors: Vec<String> = LETTERS.iter().zip(cables).map(anchor).collect();
    let mut lines = vec![format!("M669 K6 {}", anchors.join(" "))];
    let mut left_out = Vec::new();
    let radii: Option<Vec<f64>> = cables.iter().map(|cable| cable.winch.radius).collect();
    if let Some(radii) = radii {
        let build_ups: Vec<f64> = cables.iter().map(|cable| cable.winch.build_up.unwrap_or(0.0)).collect();
        let mean = build_ups.iter().sum::<f64>() / build_ups.len() as f64;
        if build_ups.iter().any(|build_up| (build_up - mean).abs() > 1e-9) {
            left_out.push("differences of spool_build_up_m between cables: Q is their mean".to_owned());
        }
        let radii: Vec<String> = radii.into_iter().map(millimetres).collect();
        let advantage = joined(&|cable| cable.winch.mechanical_advantage.unwrap_or(1.0).to_string());
        // each millimetre on the spool adds to one squared radius: one line per spool
        lines.push(format!("M666 Q{:.6} R{} U{advantage} O1:1:1:1", 1e3 * mean, radii.join(":")));
        if cables.iter().any(|cable| cable.winch.gear_ratio.is_some()) {
            left_out.push(format!(
                "gear_ratio {}: M666 has it as teeth of motor (L) and spool (H)",
                joined(&|cable| cable.winch.gear_ratio.unwrap_or(1.0).to_string())
            ));
        }
    }
    Ok(Configuration { lines, left_out })
}

fn klipper(robot: &Robot) -> Result<Configuration, FirmwareError> {
    if robot.cables.len() > 26 {
        return Err(FirmwareError::CableCount { needed: "at most 26 steppers, a to z", found: robot.cables.len() });
    }
    let mut lines = vec!["[printer]".to_owned(), "kinematics: winch".to_owned()];
    for (letter, cable) in ('a'..='z').zip(&robot.cables) {
        lines.push(String::new());
        lines.push(format!("[stepper_{letter}]"));
        if let Some(radius) = cable.winch.radius {
            let reduction =
                cable.winch.gear_ratio.unwrap_or(1.0).abs() * cable.winch.mechanical_advantage.unwrap_or(1.0);
            lines.push(format!("rotation_distance: {:.6}", 1e3 * TAU * radius / reduction));
        }
        let axes = ['x', 'y', 'z'].into_iter().zip(cable.frame_anchor.iter());
        lines.extend(axes.map(|(axis, metres)| format!("anchor_{axis}: {}", millimetres(*metres))));
    }
    let grows = robot.cables.iter().any(|cable| cable.winch.build_up.is_some_and(|build_up| build_up > 0.0));
    let left_out = grows.then(|| "spool_build_up_m: a turn of the motor is the same length everywhere".to_owned());
    Ok(Configuration { lines, left_out: left_out.into_iter().collect() })
}
