//! Numbers of a size that only another unit explains.

use std::f64::consts::PI;

use crate::finding::{Finding, FindingKind, Severity};
use crate::robot::{Cable, Robot};

/// No cable robot has frame anchors farther apart (m); the largest, FAST, has 600 m.
const LARGEST_FRAME: f64 = 2000.0;

/// Frames above this carry at least so much for each metre (m, kg/m): cameras over stadiums have 0.1 kg/m, FAST 50 kg/m.
const LARGE_FRAME: f64 = 100.0;
const LEAST_MASS: f64 = 0.05;

/// No material is denser (kg/m³).
const DENSEST: f64 = 25_000.0;

/// Sizes that are asked about, each by the number that is out of proportion and the units that would explain it.
const SIZES: [fn(&Robot) -> Option<String>; 10] =
    [frame, platform, home, travel, gravity, weight, stiffness, strain, thickness, radii];

/// Every number that is out of proportion.
pub(super) fn of_another_unit(robot: &Robot) -> Vec<Finding> {
    let finding = |text| Finding::new(FindingKind::Unit, Severity::Caution, text);
    SIZES.iter().filter_map(|size| size(robot)).map(finding).collect()
}

/// Largest of a number of the cables that state it.
fn largest(robot: &Robot, of: impl Fn(&Cable) -> Option<f64>) -> Option<f64> {
    robot.cables.iter().filter_map(of).reduce(f64::max)
}

/// Largest distance between two frame anchors (m).
fn frame_size(robot: &Robot) -> f64 {
    let anchors = || robot.cables.iter().map(|cable| cable.frame_anchor);
    anchors().flat_map(|a| anchors().map(move |other| (a - other).norm())).fold(0.0, f64::max)
}

fn frame(robot: &Robot) -> Option<String> {
    let size = frame_size(robot);
    let light = robot.platform.mass.filter(|mass| size > LARGE_FRAME && *mass < LEAST_MASS * size);
    match light {
        _ if size > LARGEST_FRAME => {
            Some(format!("the frame anchors are up to {size:.0} m apart: are they millimetres? Their key ends in _m"))
        }
        Some(mass) => Some(format!(
            "the frame anchors are up to {size:.0} m apart, and the platform has {mass} kg: are the anchors millimetres? Their key ends in _m"
        )),
        None => None,
    }
}

fn platform(robot: &Robot) -> Option<String> {
    let frame = frame_size(robot);
    let platform = robot.cables.iter().map(|cable| cable.platform_anchor.norm()).fold(0.0, f64::max);
    (frame > 0.0 && platform > frame).then(|| {
        format!(
            "platform anchors are up to {platform:.3} m from the platform's origin, in a frame of {frame:.3} m: are they in \
             millimetres, or in the world frame?"
        )
    })
}

fn home(robot: &Robot) -> Option<String> {
    let (frame, home) = (frame_size(robot), robot.home?);
    let middle = Robot { home: None, ..robot.clone() }.home_or_middle().position;
    let away = (home.position - middle).norm();
    (frame > 0.0 && away > 3.0 * frame).then(|| {
        format!("the home position is {away:.3} m from the middle of a frame of {frame:.3} m: is it in millimetres? Its key ends in _m")
    })
}

fn travel(robot: &Robot) -> Option<String> {
    let (frame, travel) = (frame_size(robot), robot.travel.as_ref()?);
    let size = (travel.max - travel.min).amax();
    (frame > 0.0 && size > 10.0 * frame).then(|| {
        format!("the [workspace] box is {size:.3} m long, in a frame of {frame:.3} m: is it in millimetres? Its keys end in _m")
    })
}

fn gravity(robot: &Robot) -> Option<String> {
    let size = robot.gravity?.norm();
    let unit = match size {
        size if size > 5000.0 => "millimetres per second squared",
        size if size > 30.0 => "centimetres or feet per second squared",
        size if (0.9..=1.1).contains(&size) => "multiples of g",
        _ => return None,
    };
    Some(format!("gravity_m_s2 has the size {size}: are these {unit}? On Earth it is 9.81"))
}

fn weight(robot: &Robot) -> Option<String> {
    let weight = robot.platform.mass? * robot.gravity?.norm();
    let pull: f64 = robot.cables.iter().map(|cable| cable.tension_max).sum::<Option<f64>>()?;
    (weight > pull).then(|| {
        format!(
            "the platform weighs {weight:.1} N, more than all cables together may pull, {pull:.1} N: is mass_kg in grams, or tension_max_N in kilonewtons?"
        )
    })
}

fn stiffness(robot: &Robot) -> Option<String> {
    let stiffness = largest(robot, Cable::axial_stiffness).filter(|stiffness| *stiffness >= 1e10)?;
    Some(format!(
        "axial_stiffness_EA_N of {stiffness:.1e} N is the size of a modulus of elasticity in Pa: it is modulus times cross-section"
    ))
}

fn strain(robot: &Robot) -> Option<String> {
    let of = |cable: &Cable| Some(cable.tension_max? / cable.axial_stiffness()?);
    let strain = largest(robot, of).filter(|strain| *strain > 1.0)?;
    Some(format!(
        "a cable would be {strain:.1} times longer at its tension_max_N: is axial_stiffness_EA_N in kilonewtons?"
    ))
}

fn thickness(robot: &Robot) -> Option<String> {
    let diameter = largest(robot, |cable| cable.diameter);
    if let Some(diameter) = diameter.filter(|diameter| *diameter > 0.3) {
        return Some(format!("diameter_m of {diameter} m: is it in millimetres? Its key ends in _m"));
    }
    let density = |cable: &Cable| Some(cable.linear_density? / (0.25 * PI * cable.diameter?.powi(2)));
    let dense = largest(robot, density).filter(|density| *density > DENSEST && density.is_finite())?;
    Some(format!(
        "a cable of its diameter_m and linear_density_kg_per_m would have {dense:.0} kg/m³, more than any material: is the density in grams per metre?"
    ))
}

fn radii(robot: &Robot) -> Option<String> {
    let frame = frame_size(robot);
    let pulley = ("pulley_radius_m", largest(robot, Cable::pulley_radius));
    let drum = ("drum_radius_m", largest(robot, |cable| cable.winch.radius));
    let (key, radius) =
        [pulley, drum].into_iter().find_map(|(key, radius)| Some((key, radius?)).filter(|(_, r)| 2.0 * r > frame))?;
    (frame > 0.0)
        .then(|| format!("{key} of {radius} m in a frame of {frame:.3} m: is it in millimetres? Its key ends in _m"))
}
