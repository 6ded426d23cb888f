//! Known facts about a robot besides its samples: distances, tape-measured lengths, anchors on a plane or a wall, equal
//! drums.

use std::str::FromStr;

use thiserror::Error;

/// Standard deviation of a fact without a stated one (m).
const ASSUMED: f64 = 1e-3;

/// A known fact about a robot, with its standard deviation; cables count from 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Known {
    /// The fact.
    pub fact: Fact,
    /// Standard deviation (m).
    pub sigma: f64,
}

/// A fact about a robot.
#[derive(Clone, Debug, PartialEq)]
pub enum Fact {
    /// Distance of two frame anchors (m).
    Distance {
        /// The two cables.
        cables: [usize; 2],
        /// Distance (m).
        metres: f64,
    },
    /// Length of a cable from its frame anchor, arc included, at the pose from which lengths count (m).
    Length {
        /// The cable.
        cable: usize,
        /// Length (m).
        metres: f64,
    },
    /// Frame anchors with the same coordinate along an axis of the world (0, 1, 2 for x, y, z): on a wall, or level.
    Wall {
        /// The axis.
        axis: usize,
        /// The cables.
        cables: Vec<usize>,
    },
    /// Frame anchors on one plane of any orientation.
    Plane {
        /// The cables, four at least; the first three span it.
        cables: Vec<usize>,
    },
    /// Drums of the same radius.
    EqualDrums {
        /// The cables.
        cables: Vec<usize>,
    },
}

/// A fact that cannot be read, or does not fit the robot or its data.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum KnownError {
    /// Text that cannot be read as a fact.
    #[error(
        "cannot read `{text}`: write distance[1,2]=2.412, length[1]=1.597, plane[1,2,3,4], wall-x[1,2], wall-y[1,2], level[1,2,3] or equal-drum-radius[1,2], each with \
         a standard deviation in metres if you know it, e.g. distance[1,2]=2.412+-0.002"
    )]
    Syntax {
        /// The text.
        text: String,
    },
    /// A cable that the robot does not have, or too few cables.
    #[error("`{text}`: the robot has cables 1 to {cable_count}, and {needed} different ones are needed here at least")]
    Cables {
        /// The text.
        text: String,
        /// Cables of the robot.
        cable_count: usize,
        /// Cables needed.
        needed: usize,
    },
    /// A length at the common pose, for data with absolute lengths.
    #[error(
        "`{text}`: the data have absolute lengths, so that there is no pose where they count from; this is known of length changes only"
    )]
    NoCommonPose {
        /// The text.
        text: String,
    },
}

impl Known {
    /// Names of the facts, which cables in brackets follow.
    pub const NAMES: [&'static str; 7] =
        ["distance", "length", "plane", "wall-x", "wall-y", "level", "equal-drum-radius"];

    /// Cables in the fact.
    pub(crate) fn cables(&self) -> &[usize] {
        match &self.fact {
            Fact::Distance { cables, .. } => cables,
            Fact::Length { cable, .. } => std::slice::from_ref(cable),
            Fact::Wall { cables, .. } | Fact::Plane { cables } | Fact::EqualDrums { cables } => cables,
        }
    }

    /// Checks that the fact fits a robot with this many cables, and that a length comes with length changes.
    pub fn check(&self, cable_count: usize, are_changes: bool) -> Result<(), KnownError> {
        let needed = match self.fact {
            Fact::Length { .. } => 1,
            Fact::Plane { .. } => 4,
            _ => 2,
        };
        let mut cables = self.cables().to_vec();
        cables.sort_unstable();
        cables.dedup();
        if cables.len() != self.cables().len() || cables.len() < needed || cables.iter().any(|k| *k >= cable_count) {
            return Err(KnownError::Cables { text: self.to_string(), cable_count, needed });
        }
        if matches!(self.fact, Fact::Length { .. }) && !are_changes {
            return Err(KnownError::NoCommonPose { text: self.to_string() });
        }
        Ok(())
    }
}

impl FromStr for Known {
    type Err = KnownError;

    /// Reads `distance[1,2]=2.412+-0.002`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        parsed(text.trim()).ok_or_else(|| KnownError::Syntax { text: text.trim().to_owned() })
    }
}

fn parsed(text: &str) -> Option<Known> {
    let (fact, sigma) = match text.split_once("+-").or_else(|| text.split_once('±')) {
        Some((fact, sigma)) => (fact.trim(), sigma.trim().parse().ok()?),
        None => (text, ASSUMED),
    };
    let (name, rest) = fact.split_once('[')?;
    let (cables, value) = rest.split_once(']')?;
    let number = |text: &str| text.trim().parse::<usize>().ok()?.checked_sub(1);
    let cables: Vec<usize> = cables.split(',').map(number).collect::<Option<_>>()?;
    let metres = match value.trim().strip_prefix('=') {
        Some(value) => Some(value.trim().parse::<f64>().ok().filter(|value| value.is_finite() && *value > 0.0)?),
        None if value.trim().is_empty() => None,
        None => return None,
    };
    let fact = match (name.trim(), metres, cables.as_slice()) {
        ("distance", Some(metres), &[first, second]) => Fact::Distance { cables: [first, second], metres },
        ("length", Some(metres), &[cable]) => Fact::Length { cable, metres },
        ("plane", None, _) => Fact::Plane { cables },
        ("wall-x", None, _) => Fact::Wall { axis: 0, cables },
        ("wall-y", None, _) => Fact::Wall { axis: 1, cables },
        ("level", None, _) => Fact::Wall { axis: 2, cables },
        ("equal-drum-radius", None, _) => Fact::EqualDrums { cables },
        _ => return None,
    };
    (sigma > 0.0 && f64::is_finite(sigma)).then_some(Known { fact, sigma })
}

impl std::fmt::Display for Known {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (name, metres) = match &self.fact {
            Fact::Distance { metres, .. } => ("distance", Some(metres)),
            Fact::Length { metres, .. } => ("length", Some(metres)),
            Fact::Plane { .. } => ("plane", None),
            Fact::Wall { axis, .. } => (["wall-x", "wall-y", "level"][*axis], None),
            Fact::EqualDrums { .. } => ("equal-drum-radius", None),
        };
        let cables: Vec<String> = self.cables().iter().map(|cable| (cable + 1).to_string()).collect();
        write!(formatter, "{name}[{}]", cables.join(","))?;
        metres.map_or(Ok(()), |metres| write!(formatter, "={metres}"))?;
        write!(formatter, "+-{}", self.sigma)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_that_of_a_fact() {
        for name in Known::NAMES {
            let written = ["[1]=2", "[1,2]=2", "[1,2]", "[1,2,3,4]"].map(|rest| format!("{name}{rest}"));
            assert!(written.iter().any(|text| text.parse::<Known>().is_ok()), "{name}");
        }
        let refusal = "none[1]".parse::<Known>().unwrap_err().to_string();
        assert!(Known::NAMES.iter().all(|name| refusal.contains(&format!("{name}["))), "{refusal}");
    }

    #[test]
    fn known_things_survive_the_round_trip() {
        for text in ["distance[1,2]=2.412+-0.002", "length[3]=1.5+-0.02", "plane[1,2,3,4]+-0.001", "level[1,2]+-0.001"]
        {
            assert_eq!(text.parse::<Known>().unwrap().to_string(), text);
        }
        assert_eq!("wall-x[1,2]".parse::<Known>().unwrap().sigma, ASSUMED);
        for text in [
            "distance[1,2]",
            "distance[1]=2",
            "distance[0,1]=2",
            "length[1]=-2",
            "level[1,2]=3",
            "plane",
            "height[1,2]",
            "level[1,2]+-0",
        ] {
            assert!(matches!(text.parse::<Known>(), Err(KnownError::Syntax { .. })), "{text}");
        }
    }

    #[test]
    fn what_is_not_of_the_robot_is_refused() {
        let refused = |text: &str, are_changes| text.parse::<Known>().unwrap().check(4, are_changes).unwrap_err();
        for text in ["distance[1,5]=2", "distance[2,2]=2", "plane[1,2,3]", "level[1,1]"] {
            assert!(matches!(refused(text, true), KnownError::Cables { .. }), "{text}");
        }
        assert!(matches!(refused("length[1]=2", false), KnownError::NoCommonPose { .. }));
    }
}
