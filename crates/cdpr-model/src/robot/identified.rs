//! Updates a robot after identification: identified numbers are no longer assumptions.

use super::parameter::Head;
use super::{Assumption, Calibration, Parameter, ParameterKind, Robot};

/// Forms of a cable's stiffness: an identified one replaces the others.
const STRETCH: [ParameterKind; 3] =
    [ParameterKind::AxialStiffness, ParameterKind::Compliance, ParameterKind::SpringConstant];

impl Robot {
    /// The robot with the status of the calibration that produced its numbers.
    #[must_use]
    pub fn with_calibration(&self, status: &str) -> Self {
        Self { calibration: Some(Calibration { status: status.to_owned() }), ..self.clone() }
    }

    /// Removes identified numbers from the assumptions, lists only if all their entries were identified, and an earlier
    /// calibration from the robot.
    pub fn forget_assumptions(&mut self, identified: impl IntoIterator<Item = Parameter>) {
        let mut identified = identified.into_iter().peekable();
        if identified.peek().is_some() {
            self.calibration = None;
        }
        if self.assumptions.is_empty() {
            return;
        }
        let identified: Vec<Parameter> = identified.collect();
        let left =
            self.assumptions.iter().filter_map(|assumption| self.still_assumed(assumption, &identified)).collect();
        self.assumptions = left;
    }

    /// Remaining part of an assumption: for a number of every cable, the cables for which it was not identified.
    fn still_assumed(&self, assumption: &Assumption, identified: &[Parameter]) -> Option<Assumption> {
        let as_it_is = || Some(assumption.clone());
        let Some(kind) = ParameterKind::ALL.into_iter().find(|kind| kind.key() == assumption.plain_key()) else {
            return as_it_is();
        };
        let is_identified = |cable: usize| {
            let is_own = |parameter: &&Parameter| parameter.cable == cable && says(parameter.kind, kind);
            let own: Vec<&Parameter> = identified.iter().filter(is_own).collect();
            own.first().is_some_and(|first| own.len() == first.kind.components(self))
        };
        let head = Head::read(&assumption.key)?;
        if head.word != "cable" {
            return if is_identified(0) { None } else { as_it_is() };
        }
        let states = |cable: &usize| Parameter { cable: *cable, kind, axis: 0 }.get(self).is_some();
        let all = || (0..self.cable_count()).filter(states).collect();
        let cables: Vec<usize> = head.cables.unwrap_or_else(all);
        let left: Vec<String> =
            cables.iter().filter(|cable| !is_identified(**cable)).map(|cable| (cable + 1).to_string()).collect();
        if left.len() == cables.len() {
            return as_it_is();
        }
        let key = format!("cable[{}].{}", left.join(","), assumption.plain_key());
        (!left.is_empty()).then(|| Assumption { key, ..assumption.clone() })
    }
}

/// True if numbers of one kind replace those of the other.
fn says(one: ParameterKind, other: ParameterKind) -> bool {
    let is_wrench = one == ParameterKind::Wrench && matches!(other, ParameterKind::Force | ParameterKind::Moment);
    one == other || is_wrench || (STRETCH.contains(&one) && STRETCH.contains(&other))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assumed(keys: &[&str], identified: &str) -> Vec<String> {
        let mut robot = Robot::builtin("planar-example").unwrap();
        robot.assumptions =
            keys.iter().map(|key| Assumption { key: (*key).to_owned(), reason: "a guess".to_owned() }).collect();
        let parameters: Vec<Parameter> =
            identified.split(';').flat_map(|name| Parameter::named(name, &robot).unwrap()).collect();
        robot.forget_assumptions(parameters);
        robot.assumptions.into_iter().map(|assumption| assumption.key).collect()
    }

    #[test]
    fn identified_numbers_are_assumptions_no_more() {
        let stretch = "cable.axial_stiffness_EA_N";
        assert_eq!(assumed(&[stretch, "platform.mass_kg"], "compliance"), ["platform.mass_kg"]);
        assert_eq!(assumed(&[stretch], "compliance[1];spring-constant[3]"), ["cable[2,4].axial_stiffness_EA_N"]);
        assert_eq!(assumed(&["cable[2,3].axial_stiffness_EA_N"], "compliance[3]"), ["cable[2].axial_stiffness_EA_N"]);
        assert_eq!(assumed(&[stretch], "frame-anchor.x"), [stretch]);
        assert_eq!(assumed(&["platform.mass_kg", "gravity_m_s2"], "mass"), ["gravity_m_s2"]);
    }

    /// An identified coordinate of an anchor leaves the other one assumed.
    #[test]
    fn a_list_is_assumed_until_all_of_it_is_identified() {
        let key = "cable.frame_anchor_m";
        assert_eq!(assumed(&[key], "frame-anchor.x"), [key]);
        let others = ["cable[1,3,4].frame_anchor_m"];
        assert_eq!(assumed(&[key], "frame-anchor[2].x;frame-anchor[2].y;frame-anchor[1].x"), others);
    }
}
