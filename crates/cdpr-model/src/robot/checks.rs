//! Warnings about a robot that is valid but unusual.

use nalgebra::{DMatrix, Vector3};

use super::{Cable, Pulley, Robot};
use crate::scalar::decomposition::symmetric_eigen;

/// Deviation from a line or plane, as a fraction of their extent, below which anchors count as collinear or coplanar.
const FLATNESS: f64 = 1e-6;

/// Tangent of a fleet angle above which no groove holds a cable.
const STEEP_FLEET: f64 = 0.1;

impl Robot {
    /// Sentences about properties that probably are mistakes, or that some computations need and lack; empty if there
    /// are none.
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        self.warn_about_pairs(&mut warnings);
        self.warn_about_missing_keys(&mut warnings);
        self.warn_about_flat_anchors(&mut warnings);
        if self.cables.len() < self.dof() {
            let (found, needed) = (self.cables.len(), self.dof());
            warnings.push(format!(
                "{found} cables cannot control {needed} degrees of freedom: the robot is under-actuated"
            ));
        }
        warnings
    }

    fn warn_about_pairs(&self, warnings: &mut Vec<String>) {
        for (index, cable) in self.cables.iter().enumerate() {
            for other in &self.cables[index + 1..] {
                let names = format!("cables `{}` and `{}`", cable.name, other.name);
                if cable.name == other.name {
                    warnings.push(format!("two cables are named `{}`", cable.name));
                }
                match (cable.frame_anchor == other.frame_anchor, cable.platform_anchor == other.platform_anchor) {
                    (true, true) => warnings.push(format!("{names} run between the same two points")),
                    (true, false) => warnings.push(format!("{names} share a frame anchor")),
                    _ => {}
                }
            }
        }
    }

    fn warn_about_missing_keys(&self, warnings: &mut Vec<String>) {
        let mut without = |what: &str, lacks: &dyn Fn(&Cable) -> bool| {
            let names: Vec<&str> = self.cables.iter().filter(|cable| lacks(cable)).map(|cable| &*cable.name).collect();
            if !names.is_empty() {
                let which = if names.len() == self.cables.len() { "all cables".to_owned() } else { names.join(", ") };
                warnings.push(format!("{what}: {which}"));
            }
        };
        without("no tension limits (tension_min_N, tension_max_N)", &|cable| {
            cable.tension_min.is_none() || cable.tension_max.is_none()
        });
        without("pulley_radius_m without pulley_swivel_axis, so the effect `pulley` cannot be used", &|cable| {
            matches!(cable.pulley, Some(Pulley::Radius(_)))
        });
        without("pulley_swivel_axis without pulley_radius_m, so the effect `pulley` cannot be used", &|cable| {
            matches!(cable.pulley, Some(Pulley::SwivelAxis(_)))
        });
        without("pulley_wrap_side without pulley_swivel_axis, so it has no effect", &|cable| {
            cable.pulley_wrap_side.is_some() && cable.pulley_swivel_axis().is_none()
        });
        without(
            "the cable leaves its drum at more than 0.1 rad against the groove at the start: are drum_axis and drum_position_m right?",
            &|cable| fleet_tangent(cable).is_some_and(|tangent| tangent.abs() > STEEP_FLEET),
        );
        if self.home.is_none() {
            warnings.push("no [home_pose]: the middle of the frame anchors is used to start from".to_owned());
        }
        let weighed = self.external_wrench.as_ref().is_some_and(|external| external.includes_gravity);
        if self.platform.mass.is_none() && !weighed {
            warnings
                .push("no mass_kg and no external wrench that includes gravity: the platform has no weight".to_owned());
        }
        if self.platform.mass.is_some() && self.gravity.is_none() && !weighed {
            warnings.push("mass_kg without gravity_m_s2: the platform has no weight".to_owned());
        }
    }

    fn warn_about_flat_anchors(&self, warnings: &mut Vec<String>) {
        let dimensions = self.motion_pattern.translations();
        for (what, points) in [
            ("frame anchors", self.cables.iter().map(|cable| cable.frame_anchor).collect::<Vec<_>>()),
            ("platform anchors", self.cables.iter().map(|cable| cable.platform_anchor).collect()),
        ] {
            // the platform of a point robot has no extent
            if what == "platform anchors" && !self.motion_pattern.has_rotation() {
                continue;
            }
            let shape = match extent_dimensions(&points) {
                0 => "are one point",
                1 if dimensions > 1 => "lie on a line",
                2 if dimensions > 2 => "lie in a plane",
                _ => continue,
            };
            warnings.push(format!("all {what} {shape}: some parameters or motions may not be determined"));
        }
    }
}

/// Tangent of the angle between the cable from a drum at its start and the plane across the drum's axis; `None` with a
/// guide.
fn fleet_tangent(cable: &Cable) -> Option<f64> {
    let (axis, way) = (cable.winch.axis?, cable.way_to_first_pulley().filter(|_| cable.winch.guided != Some(true))?);
    let along = axis.dot(&way);
    Some(along / (way - *axis * along).norm())
}

/// Number of dimensions in which points extend: 0 one point, 1 a line, 2 a plane, 3 space.
fn extent_dimensions(points: &[Vector3<f64>]) -> usize {
    let middle: Vector3<f64> = points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64;
    let scatter = DMatrix::from_fn(3, points.len(), |row, column| points[column][row] - middle[row]);
    let Some(gram) = symmetric_eigen(&scatter * scatter.transpose()).map(|gram| gram.eigenvalues) else { return 3 };
    // eigenvalues are squares of extents
    let limit = (FLATNESS * FLATNESS) * gram.amax();
    gram.iter().filter(|&&extent| extent > limit.max(f64::MIN_POSITIVE)).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_complete_robot_gives_no_warning() {
        assert_eq!(Robot::builtin("cucablerobot").unwrap().warnings(), Vec::<String>::new());
    }

    #[test]
    fn what_is_missing_or_flat_is_said() {
        let mut robot = Robot::builtin("cucablerobot").unwrap();
        robot.cables[1].frame_anchor = robot.cables[0].frame_anchor;
        robot.cables[2].pulley = robot.cables[2].pulley_radius().map(Pulley::Radius);
        robot.cables[3].tension_max = None;
        robot.cables.iter_mut().for_each(|cable| cable.platform_anchor.z = 0.0);
        robot.home = None;
        robot.platform.mass = None;
        let said = robot.warnings().join("\n");
        for part in ["share a frame anchor", "pulley_swivel_axis", "tension limits", "plane", "home_pose", "mass_kg"] {
            assert!(said.contains(part), "{part} is not in\n{said}");
        }
    }

    #[test]
    fn a_drum_that_stands_askew_is_noticed() {
        let mut robot = Robot::builtin("cucablerobot").unwrap();
        let cable = &mut robot.cables[0];
        cable.winch.axis = Some(Vector3::x().into());
        cable.winch.position = Some(cable.frame_anchor - Vector3::new(0.1, 0.0, 2.0));
        assert_eq!(robot.warnings(), Vec::<String>::new());
        robot.cables[0].winch.axis = Some(Vector3::z().into());
        assert!(robot.warnings().join("\n").contains("drum_position_m"));
    }

    #[test]
    fn two_cables_of_one_name_are_noticed() {
        let warnings = Robot::builtin("macarm").unwrap().warnings();
        assert!(warnings.contains(&"two cables are named `1`".to_owned()), "{warnings:?}");
    }

    #[test]
    fn fewer_cables_than_degrees_of_freedom_are_noticed() {
        let mut robot = Robot::builtin("cogiro").unwrap();
        robot.cables.truncate(4);
        assert!(robot.warnings().iter().any(|warning| warning.contains("under-actuated")));
    }
}
