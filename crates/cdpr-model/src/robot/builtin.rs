//! Robots that come with the library; sources and licences are in `robots/NOTICE.md`.

use super::Robot;

/// Name and file of each built-in robot.
macro_rules! built_in {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("../../robots/", $name, ".toml")))),*]
    };
}

/// The seven of the dissertation, then those of CASPR: spatial and constrained, suspended, planar.
const ROBOTS: &[(&str, &str)] = built_in![
    "planar-example",
    "planar-example-calibrated",
    "cablerobot-simulator-icosahedron",
    "cablerobot-simulator-helicopter",
    "cablerobot-simulator-helicopter-design",
    "cablerobot-simulator-helicopter-kinematic-calibrated",
    "cablerobot-simulator-helicopter-elastostatic-calibrated",
    "ipanema-1",
    "ipanema-2",
    "macarm",
    "spatial-7-cable",
    "cu-brick",
    "xl-laser",
    "cucablerobot",
    "cogiro",
    "caroca",
    "caroca-pulleys",
    "fast",
    "nist-robocrane",
    "swinburne-suspended",
    "kntu-planar",
    "two-dof-vsd",
    "cucablerobot-planar",
];

/// Names of all built-in robots, always in the same order.
pub fn names() -> impl Iterator<Item = &'static str> {
    ROBOTS.iter().map(|(name, _)| *name)
}

/// The file of a built-in robot.
pub fn find(name: &str) -> Option<&'static str> {
    ROBOTS.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}

impl Robot {
    /// The built-in robot of this name; see [`names`].
    pub fn builtin(name: &str) -> Option<Self> {
        let text = find(name)?;
        Some(Self::from_toml(text, name).expect("every built-in robot is read in a test"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_built_in_robot_loads_under_its_own_name_and_is_written_back_unchanged() {
        for name in names() {
            let robot = Robot::builtin(name).unwrap();
            assert_eq!(robot.name, name);
            assert_eq!(Robot::from_toml(&robot.to_toml(), name).unwrap(), robot);
        }
        assert_eq!(names().count(), 23);
    }
}
