//! The winch keys of a `[[cable]]` table.

use nalgebra::Vector3;

use super::cable_reading::CableReader;
use super::parameter::ParameterKind as Kind;
use super::winch::{CableWinch, Groove, GrooveEnds};
use crate::geometry::MotionPattern;
use crate::reading::ReadError;

impl CableReader<'_> {
    pub(super) fn winch(&self) -> Result<CableWinch, ReadError> {
        let section = self.section;
        let radius = self.number(Kind::DrumRadius, section.drum_radius_m)?;
        let pitch = self.number(Kind::DrumPitch, section.drum_pitch_m)?;
        let axis = self.spatial_direction("drum_axis", section.drum_axis.as_deref())?;
        let position = self.spatial("drum_position_m", section.drum_position_m.as_deref())?;
        let first_pulley = self.spatial("drum_pulley_m", section.drum_pulley_m.as_deref())?;
        let length = self.number(Kind::GrooveLength, section.drum_groove_length_m)?;
        let layer_height = self.number(Kind::LayerHeight, section.drum_layer_height_m)?;
        let build_up = self.number(Kind::SpoolBuildUp, section.spool_build_up_m)?;
        let mechanical_advantage = self.number(Kind::MechanicalAdvantage, section.mechanical_advantage)?;
        let encoder_counts_per_turn = self.number(Kind::EncoderCounts, section.encoder_counts_per_turn)?;
        let winch = CableWinch {
            radius,
            groove: self.groove(pitch, length, layer_height)?,
            axis: axis.map(Into::into),
            position,
            side: section.drum_side,
            guided: section.drum_guided,
            first_pulley,
            start_angle: section.drum_start_angle_rad,
            start_length: section.drum_start_length_m,
            gear_ratio: section.gear_ratio,
            build_up,
            mechanical_advantage,
            encoder_counts_per_turn,
            motor_speed_max: self.number(Kind::MotorSpeedMax, section.motor_speed_max_rad_per_s)?,
            drum_inertia: self.number(Kind::DrumInertia, section.drum_inertia_kg_m2)?,
            rotor_inertia: self.number(Kind::RotorInertia, section.rotor_inertia_kg_m2)?,
            coulomb_friction: self.number(Kind::CoulombFriction, section.drum_coulomb_friction_Nm)?,
            static_friction: self.number(Kind::StaticFriction, section.drum_static_friction_Nm)?,
            stribeck_speed: self.number(Kind::StribeckSpeed, section.drum_stribeck_speed_rad_per_s)?,
            viscous_friction: self.number(Kind::ViscousFriction, section.drum_viscous_friction_Nm_s_per_rad)?,
        };
        self.check_first_pulley(&winch)?;
        self.check_friction(&winch)?;
        if winch.motor_speed_max.is_some() && winch.radius.is_none() {
            let message = "motor_speed_max_rad_per_s is given, but no drum_radius_m";
            let help = "a motor moves its cable by the drum's radius: add drum_radius_m, or state the cable's own speed_max_m_s";
            return Err(self.error("motor_speed_max_rad_per_s", "robot::motor-speed", message).with_help(help));
        }
        if winch.gear_ratio == Some(0.0) {
            return Err(self
                .error("gear_ratio", "robot::gear-ratio", "gear_ratio is 0, so its motor could not move the drum")
                .with_help("motor angle = gear_ratio · drum angle; it is negative where the motor turns backwards"));
        }
        if winch.build_up.is_some_and(|build_up| build_up > 0.0) && winch.groove.is_some() {
            let message = "spool_build_up_m is given beside drum_pitch_m: a groove keeps the radius, cable that piles up changes it";
            let help = "leave drum_pitch_m out for a spool, or spool_build_up_m for a grooved drum, whose layers have drum_layer_height_m";
            return Err(self.error("spool_build_up_m", "robot::spool", message).with_help(help));
        }
        Ok(winch)
    }

    /// Checks that static friction is not below sliding friction, and that it comes with a Stribeck speed.
    fn check_friction(&self, winch: &CableWinch) -> Result<(), ReadError> {
        let sliding = winch.coulomb_friction.unwrap_or(0.0);
        match (winch.static_friction, winch.stribeck_speed) {
            (Some(standing), _) if standing < sliding => {
                let message =
                    format!("drum_static_friction_Nm is {standing}, less than the {sliding} of a drum that turns");
                let help = "a drum that stands takes more torque than one that turns: enlarge it, or lessen drum_coulomb_friction_Nm";
                Err(self.error("drum_static_friction_Nm", "robot::friction", &message).with_help(help))
            }
            (Some(_), None) => {
                let message = "drum_static_friction_Nm is given without drum_stribeck_speed_rad_per_s";
                let help = "add the speed over which friction falls from the static one to Coulomb's, e.g. 0.1";
                Err(self.error("drum_static_friction_Nm", "robot::friction", message).with_help(help))
            }
            (None, Some(_)) => {
                let message = "drum_stribeck_speed_rad_per_s is given without drum_static_friction_Nm";
                let help = "add the friction of a drum that stands, or leave the speed out";
                Err(self.error("drum_stribeck_speed_rad_per_s", "robot::friction", message).with_help(help))
            }
            _ => Ok(()),
        }
    }

    /// A vector with three components, or with two in the plane of a planar robot: the axis of a drum need not lie in
    /// that plane.
    fn spatial(&self, key: &str, values: Option<&[f64]>) -> Result<Option<Vector3<f64>>, ReadError> {
        match values {
            None => Ok(None),
            Some(&[x, y, z]) if self.reader.pattern != MotionPattern::Spatial => Ok(Some(Vector3::new(x, y, z))),
            Some(values) => self.vector(key, values).map(Some),
        }
    }

    fn spatial_direction(&self, key: &str, values: Option<&[f64]>) -> Result<Option<Vector3<f64>>, ReadError> {
        let hint = "it is the unit vector along the drum's axis, the way the contact point travels when paid out, e.g. [0.0, 1.0, 0.0]";
        self.spatial(key, values)?.map(|axis| self.unit(key, axis, "robot::drum-axis", hint)).transpose()
    }

    fn groove(
        &self,
        pitch: Option<f64>,
        length: Option<f64>,
        layer_height: Option<f64>,
    ) -> Result<Option<Groove>, ReadError> {
        let refuse = |key: &str, message: &str, help: &str| {
            Err(self.error(key, "robot::groove", message).with_help(help.to_owned()))
        };
        if length.is_some() && !pitch.is_some_and(|pitch| pitch > 0.0) {
            let message = "drum_groove_length_m is given, but there is no drum_pitch_m above zero";
            return refuse("drum_groove_length_m", message, "its turns are groove length over pitch: add drum_pitch_m");
        }
        if layer_height.is_some() && length.is_none() {
            let message = "drum_layer_height_m is given, but no drum_groove_length_m";
            return refuse(
                "drum_layer_height_m",
                message,
                "a further layer begins where the groove is full: add its length",
            );
        }
        let ends = length.map(|length| GrooveEnds { length, layer_height });
        Ok(pitch.map(|pitch| Groove { pitch, ends }))
    }

    fn check_first_pulley(&self, winch: &CableWinch) -> Result<(), ReadError> {
        let frame_anchor = self.vector("frame_anchor_m", &self.section.frame_anchor_m)?;
        let (Some(axis), Some(position), Some(radius)) = (winch.axis, winch.position, winch.radius) else {
            return Ok(());
        };
        let distance = axis.cross(&(winch.first_pulley.unwrap_or(frame_anchor) - position)).norm();
        if winch.guided == Some(true) || distance > radius {
            return Ok(());
        }
        let point = if winch.first_pulley.is_some() { "drum_pulley_m" } else { "frame_anchor_m" };
        let message = format!(
            "{point}, where the cable from the drum enters its first pulley, is {distance:.4} m from the drum's axis, inside the drum of radius {radius} m"
        );
        Err(self.error("drum_position_m", "robot::drum-place", &message).with_help(
            "mend drum_position_m, drum_axis or drum_radius_m; with a travelling guide set drum_guided = true",
        ))
    }
}
