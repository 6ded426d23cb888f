//! The robot that the command writes, and how far it misses.

use toml::{Table, Value};

use crate::geometry::Geometry;
use crate::pose::{Pose, Vector, angle_between, minus, norm};
use crate::robots::RobotName;
use crate::scene::{Asked, Scene};

/// Mean errors of positions (m) and orientations (rad).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Errors {
    pub(crate) position: f64,
    pub(crate) rotation: f64,
}

/// Least compliance that is solved as one (1/N).
const RIGID: f64 = 1e-10;

/// Reads a calibrated robot; `elastic` says whether its cables stretch in the model that was chosen.
pub(crate) fn robot(text: &str, robot: RobotName, elastic: bool) -> Result<Geometry, String> {
    let table: Table = text.parse().map_err(|error| format!("the written robot: {error}"))?;
    let cables = table.get("cable").and_then(Value::as_array).ok_or("the written robot has no cables")?;
    let defaults = table.get("cable_defaults");
    let of_cable = |cable: &Value, key: &str| number(cable.get(key).or_else(|| defaults?.get(key)));
    let point = |cable: &Value, key: &str| cable.get(key).and_then(|value| vector(robot, value));
    let frame_anchors: Option<Vec<Vector>> = cables.iter().map(|cable| point(cable, "frame_anchor_m")).collect();
    let compliance = |cable: &Value| {
        of_cable(cable, "axial_compliance_per_N")
            .or_else(|| of_cable(cable, "axial_stiffness_EA_N").map(|stiffness| 1.0 / stiffness))
            .map(|compliance| compliance.max(RIGID))
    };
    let compliances: Option<Vec<f64>> = if elastic { cables.iter().map(compliance).collect() } else { None };
    Ok(Geometry {
        freedom: robot.freedom(),
        frame_anchors: frame_anchors.ok_or("a cable of the written robot has no frame anchor")?,
        platform_anchors: cables.iter().map(|cable| point(cable, "platform_anchor_m").unwrap_or_default()).collect(),
        scales: cables.iter().map(|cable| of_cable(cable, "length_scale").unwrap_or(1.0)).collect(),
        offsets: cables.iter().map(|cable| of_cable(cable, "length_offset_m").unwrap_or(0.0)).collect(),
        compliances: compliances.unwrap_or_default(),
        force: force(&table, robot),
    })
}

/// Force on the platform: the wrench that was identified, on top of the weight unless it holds that.
fn force(table: &Table, robot: RobotName) -> Vector {
    let mass = table.get("platform").and_then(|platform| number(platform.get("mass_kg"))).unwrap_or(0.0);
    let mut force = crate::robots::weight(mass);
    if let Some(wrench) = table.get("external_wrench") {
        let external = wrench.get("force_N").and_then(|value| vector(robot, value)).unwrap_or_default();
        let includes_gravity = wrench.get("includes_gravity").and_then(Value::as_bool).unwrap_or(false);
        force = if includes_gravity { external } else { crate::pose::plus(force, external) };
    }
    force
}

fn number(value: Option<&Value>) -> Option<f64> {
    value.and_then(|value| value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64)))
}

/// Components of the robot's axes in space.
fn vector(robot: RobotName, value: &Value) -> Option<Vector> {
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(|value| number(Some(value))).collect();
    let (numbers, axes) = (numbers?, robot.freedom().axes);
    let mut vector = [0.0; 3];
    axes.iter().zip(&numbers).for_each(|(&axis, number)| vector[axis] = *number);
    (numbers.len() == axes.len()).then_some(vector)
}

/// Mean errors at poses all over the workspace of the undisturbed machine: of the pose that the written robot has at the lengths that the
/// machine reports. Poses of a tracker's own frame or of a marker are right, too, if they are nearer: a robot may be written in them.
pub(crate) fn errors(written: &Geometry, scene: &Scene, asked: &[Asked]) -> Errors {
    let poses: Vec<Pose> = asked.iter().map(|asked| written.pose_of(&asked.recorded, &asked.pose)).collect();
    let own = mean_errors(&poses, asked, |pose| *pose);
    if scene.tracker.is_none() && scene.marker.is_none() {
        return own;
    }
    let near: Vec<Pose> =
        asked.iter().map(|asked| written.pose_of(&asked.recorded, &scene.seen(&asked.pose))).collect();
    let seen = mean_errors(&near, asked, |pose| scene.seen(pose));
    if seen.position < own.position { seen } else { own }
}

fn mean_errors(found: &[Pose], asked: &[Asked], truth: impl Fn(&Pose) -> Pose) -> Errors {
    let (mut errors, count) = (Errors { position: 0.0, rotation: 0.0 }, asked.len() as f64);
    for (found, asked) in found.iter().zip(asked) {
        let right = truth(&asked.pose);
        errors.position += norm(minus(found.position, right.position)) / count;
        errors.rotation += angle_between(&found.rotation, &right.rotation) / count;
    }
    errors
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use crate::scene::Layout;

    /// The file of the machine itself, read as a written robot, misses nothing; that of the deviating machine misses centimetres.
    #[test]
    fn a_robot_file_is_as_good_as_its_numbers() {
        for &name in RobotName::ALL {
            let mut scene = Scene::of(name, 1, Layout::Few(3), "test");
            let mut random = Random::of("asked", 1);
            let deviating = scene.asked(&mut random);
            scene.machine = scene.file.geometry.clone();
            let exact = scene.asked(&mut random);
            let written = robot(&scene.file.text(), name, name.stretches()).unwrap();
            let none = errors(&written, &scene, &exact);
            assert!(none.position < 1e-7 && none.rotation < 1e-7, "{name:?}: {none:?}");
            assert!(errors(&written, &scene, &deviating).position > 5e-3, "{name:?}");
        }
    }
}
