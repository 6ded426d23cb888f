//! Friction of a drum changes.

use std::sync::Arc;

use super::entry::{CABLE, EventEntry, EventSetting};
use super::happening::Happening;
use crate::error::PlantError;
use crate::keys::{Key, Kind, Shape, Word};
use crate::plant::{Plant, Winches};
use crate::state::PlantState;

const WORD: Word = Word::new("friction", "Friction of a drum changes; numbers that are not stated stay as they were.");
const COULOMB: &str = "coulomb_Nm";
const VISCOUS: &str = "viscous_Nm_s_per_rad";

pub(super) const FRICTION: EventEntry = EventEntry {
    kind: Kind {
        word: WORD,
        keys: &[
            CABLE,
            Key::optional(COULOMB, Shape::NotNegative, "dry friction of its drum from then on (N·m)."),
            Key::optional(VISCOUS, Shape::NotNegative, "friction of its drum per speed from then on (N·m·s/rad)."),
        ],
    },
    make,
};

fn make(setting: &EventSetting<'_>) -> Result<Arc<dyn Happening>, PlantError> {
    if setting.plant.winches() == Winches::Ideal {
        let message = "ideal winches have no friction: say winches = \"drums\" in [machine]".to_owned();
        return Err(setting.refused("kind", message));
    }
    let [coulomb, viscous] = [COULOMB, VISCOUS].map(|key| setting.stated.number(key));
    if coulomb.or(viscous).is_none() {
        return Err(setting.refused("kind", format!("kind = \"friction\" needs {COULOMB}, {VISCOUS} or both")));
    }
    Ok(Arc::new(FrictionChange { cable: setting.cable()?, coulomb, viscous }))
}

/// The friction of a drum changes. Static friction keeps its excess over the dry friction of a turning drum; ideal
/// winches have no friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionChange {
    /// Cable of the drum (0-based).
    pub cable: usize,
    /// Dry friction of a turning drum (N·m); `None` if it does not change.
    pub coulomb: Option<f64>,
    /// Friction per speed (N·m·s/rad); `None` if it does not change.
    pub viscous: Option<f64>,
}

impl Happening for FrictionChange {
    fn kind(&self) -> &'static str {
        WORD.name
    }

    fn apply(&self, _plant: &Plant, state: &mut PlantState) {
        let Some(friction) = state.friction.get_mut(self.cable) else { return };
        if let Some(coulomb) = self.coulomb {
            friction.standing = coulomb + (friction.standing - friction.coulomb);
            friction.coulomb = coulomb;
        }
        friction.viscous = self.viscous.unwrap_or(friction.viscous);
    }

    fn words(&self, cable: &str, number: &dyn Fn(f64, i32) -> String) -> String {
        let dry = self.coulomb.map(|torque| format!("{} N·m", number(torque, 4)));
        let viscous = self.viscous.map(|torque| format!("{} N·m·s/rad", number(torque, 4)));
        let parts: Vec<String> = dry.into_iter().chain(viscous).collect();
        format!("the drum of {cable} has friction of {}", parts.join(" and "))
    }

    fn cable(&self) -> Option<usize> {
        Some(self.cable)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::events::CableBreak;
    use crate::tests::{at_home, plate};
    use crate::{Command, Scenario, Simulation};
    use cdpr_model::model::{Composition, Model};
    use cdpr_model::robot::Robot;

    const INERTIA: f64 = 0.6;

    fn robot() -> Robot {
        let mut robot = plate();
        for cable in &mut robot.cables {
            (cable.winch.radius, cable.winch.drum_inertia) = (Some(0.05), Some(INERTIA));
            (cable.winch.coulomb_friction, cable.winch.static_friction) = (Some(1.0), Some(1.5));
            cable.winch.viscous_friction = Some(0.2);
        }
        robot
    }

    /// A drum without its cable that turns at 1 rad/s, after a change of its friction; torques hold the others at rest.
    fn spinning(change: FrictionChange) -> (Plant, PlantState) {
        let plant = Plant::new(Model::new(robot(), Composition::ELASTIC).unwrap(), Winches::Drums).unwrap();
        let mut state = at_home(&plant, 60.0);
        plant.apply(&mut state, &CableBreak { cable: change.cable });
        state.cables[change.cable].drum_speed = 1.0;
        plant.apply(&mut state, &change);
        (plant, state)
    }

    fn run(plant: &Plant, state: &mut PlantState, cable: usize, seconds: f64) {
        let mut torques = plant.holding_torques(state).unwrap();
        torques[cable] = 0.0;
        for _ in 0..(seconds / 1e-3).round() as usize {
            plant.step(state, &Command::torques(&torques), 1e-3).unwrap();
        }
    }

    /// I ω̇ = −d ω: the speed falls by exp(−d t/I), the energy of the drum by its square.
    #[test]
    fn viscous_friction_of_an_event_lets_the_speed_decay_at_its_rate() {
        let (plant, mut state) = spinning(FrictionChange { cable: 2, coulomb: Some(0.0), viscous: Some(3.0) });
        state.friction[2].standing = 0.0;
        run(&plant, &mut state, 2, 0.2);
        let expected = (-3.0 * 0.2 / INERTIA).exp();
        assert!((state.cables[2].drum_speed / expected - 1.0).abs() < 1e-10, "{}", state.cables[2].drum_speed);
    }

    /// I ω̇ = −T_c: the speed falls linearly to zero after I ω/T_c, and stays there.
    #[test]
    fn coulomb_friction_of_an_event_stops_the_drum_after_its_time() {
        let (plant, mut state) = spinning(FrictionChange { cable: 1, coulomb: Some(12.0), viscous: Some(0.0) });
        // static friction counts only for speeds far below 1 rad/s
        state.friction[1].standing = 12.0;
        let start = state.cables[1].drum_angle;
        run(&plant, &mut state, 1, 0.04);
        assert!((state.cables[1].drum_speed - 0.2).abs() < 1e-12, "{}", state.cables[1].drum_speed);
        run(&plant, &mut state, 1, 0.04);
        assert_eq!(state.cables[1].drum_speed, 0.0);
        // I ω²/(2 T_c): the drum stops within a step, which is cut there
        let angle = state.cables[1].drum_angle - start;
        assert!((angle - INERTIA / 24.0).abs() < 1e-12, "{angle}");
    }

    #[test]
    fn numbers_that_are_not_stated_stay_and_static_friction_keeps_its_excess() {
        let (_, state) = spinning(FrictionChange { cable: 0, coulomb: Some(4.0), viscous: None });
        let friction = state.friction[0];
        assert_eq!((friction.coulomb, friction.standing, friction.viscous), (4.0, 4.5, 0.2));
        let (_, state) = spinning(FrictionChange { cable: 0, coulomb: None, viscous: Some(7.0) });
        let friction = state.friction[0];
        assert_eq!((friction.coulomb, friction.standing, friction.viscous), (1.0, 1.5, 7.0));
        assert_eq!(state.friction[3].viscous, 0.2);
    }

    /// In a scenario: from its time on, for drums only, and with numbers that a drum and the step allow.
    #[test]
    fn scenarios_change_friction_of_drums_and_of_nothing_else() {
        let text = |event: &str, time: &str| {
            format!(
                "[machine]\nrobot = \"plate\"\nwinches = \"drums\"\n[start]\npose = [0.6, 0.6, 0]\ntension_method = \"closed-form\"\n\
                 tension_limits_N = [60, 140]\n[control]\nkind = \"torques\"\n[time]\nduration_s = 0.1\n{time}\
                 [[event]]\ntime_s = 0.05\nkind = \"friction\"\ncable = 4\n{event}\n"
            )
        };
        let made = |text: String| {
            let scenario = Scenario::from_toml_bytes(text.as_bytes(), "scenario.toml").unwrap();
            Simulation::new(&scenario, robot())
        };
        let mut simulation = made(text("coulomb_Nm = 9", "")).unwrap();
        let before = simulation.state.friction.clone();
        let end = simulation.run(|_, state| {
            let now = if state.time > 0.0501 { 9.0 } else { 1.0 };
            assert_eq!(state.friction[3].coulomb, now, "{} s", state.time);
            Ok::<_, std::convert::Infallible>(std::ops::ControlFlow::Continue(()))
        });
        let end = end.unwrap();
        assert_eq!((&simulation.state.friction[..3], end.events.len()), (&before[..3], 1));
        let words = end.events[0].happening.words("cable 4", &|number, _| number.to_string());
        assert_eq!(words, "the drum of cable 4 has friction of 9 N·m");
        let ideal = text("coulomb_Nm = 9", "").replace("winches = \"drums\"", "").replace("torques", "lengths");
        for (text, key, words) in [
            (ideal, "kind", "winches = \"drums\""),
            (text("", ""), "kind", "or both"),
            (text("coulomb_Nm = -1", ""), "coulomb_Nm", "0 or more"),
            (text("viscous_Nm_s_per_rad = 1e4", ""), "step_s", "too large"),
        ] {
            let error = made(text).unwrap_err();
            assert!(error.to_string().contains(words), "{error}");
            assert_eq!(error.key().unwrap().key, key, "{error}");
        }
    }
}
