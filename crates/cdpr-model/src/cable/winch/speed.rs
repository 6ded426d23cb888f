//! The largest speed of a cable: its own, and that of the drive that winds it.

use super::{DrumError, Winch};
use crate::robot::Cable;

/// Largest speed of one cable, from `speed_max_m_s` and `motor_speed_max_rad_per_s` of a robot file.
#[derive(Clone, Debug, PartialEq)]
pub struct SpeedLimit {
    /// Largest speed of the cable itself (m/s).
    own: Option<f64>,
    /// Winch with the largest speed of its motor (rad/s).
    drive: Option<(Winch, f64)>,
}

impl SpeedLimit {
    /// The limit of a robot's cable; `None` if its file states neither key.
    ///
    /// The drive's counts with the layers of the groove or the growth of the spool; where the drum stands has no effect.
    pub fn of(cable: &Cable) -> Result<Option<Self>, DrumError> {
        let drive = match cable.winch.motor_speed_max {
            None => None,
            Some(speed) => {
                let mut unmounted = cable.clone();
                unmounted.winch.guided = Some(true);
                Winch::of(&unmounted).or_else(|| Winch::ideal(&unmounted)).transpose()?.map(|winch| (winch, speed))
            }
        };
        let own = cable.speed_max;
        Ok((own.is_some() || drive.is_some()).then_some(Self { own, drive }))
    }

    /// Largest speed at a controlled length (m → m/s); it does not rise with the length.
    ///
    /// A length that the drum does not hold counts as the nearest one that it holds.
    pub fn at(&self, length: f64) -> f64 {
        self.of_drive(length).min(self.own.unwrap_or(f64::INFINITY))
    }

    /// True if the drive allows less than the cable at a controlled length (m).
    pub fn is_of_drive(&self, length: f64) -> bool {
        self.own.is_none_or(|own| self.of_drive(length) < own)
    }

    fn of_drive(&self, length: f64) -> f64 {
        let Some((winch, motor_speed)) = &self.drive else { return f64::INFINITY };
        let held = winch.drum.lengths().map_or(length, |(least, largest)| length.max(least).min(largest));
        let by_angle = winch.drum.angle(held).and_then(|angle| winch.drum.gradient(angle));
        by_angle.map_or(0.0, |length| length.by_angle.abs() * motor_speed / winch.gear_ratio.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 300 rad/s through a gear of 10 turn a drum of 0.1 m at 3 m/s; a tackle of two halves it, and a spool slows down
    /// as it empties.
    #[test]
    fn a_drive_moves_its_cable_by_gear_radius_and_tackle() {
        let mut cable = Cable::default();
        assert_eq!(SpeedLimit::of(&cable).unwrap(), None);
        cable.winch.motor_speed_max = Some(300.0);
        (cable.winch.radius, cable.winch.gear_ratio) = (Some(0.1), Some(-10.0));
        let at = |cable: &Cable, length: f64| SpeedLimit::of(cable).unwrap().unwrap().at(length);
        assert!((at(&cable, 5.0) - 3.0).abs() < 1e-12);
        cable.speed_max = Some(2.5);
        assert_eq!(at(&cable, 5.0), 2.5);
        assert!(!SpeedLimit::of(&cable).unwrap().unwrap().is_of_drive(5.0));
        cable.winch.mechanical_advantage = Some(2.0);
        assert!((at(&cable, 5.0) - 1.5).abs() < 1e-12);
        cable.winch.build_up = Some(5e-4);
        // 5 m of cable are 10 m of the spool: r² = 0.01 − 0.005
        assert!((at(&cable, 5.0) - 30.0 * 0.005_f64.sqrt() / 2.0).abs() < 1e-9, "{}", at(&cable, 5.0));
    }
}
