//! Numbers of a cable by their kinds: the one place that knows where a cable keeps each.

use super::ParameterKind;
use crate::robot::{Cable, CableStiffness};

/// Number of a cable that is not a vector.
pub(super) fn of_cable(kind: ParameterKind, cable: &Cable) -> Option<f64> {
    use ParameterKind as Kind;
    match kind {
        Kind::PulleyRadius => cable.pulley_radius(),
        Kind::LengthOffset => cable.length_offset,
        Kind::LengthScale => cable.length_scale,
        Kind::DrumRadius => cable.winch.radius,
        Kind::StartLength => cable.winch.start_length,
        Kind::AxialStiffness => {
            cable.axial_stiffness().or_else(|| cable.axial_compliance().map(|compliance| 1.0 / compliance))
        }
        Kind::HiddenLength => cable.hidden_length,
        Kind::Compliance => cable.specific_compliance(),
        Kind::TensionScale => cable.tension_scale,
        Kind::TensionOffset => cable.tension_offset,
        Kind::SwivelOffset => cable.swivel_offset,
        Kind::SpringConstant => cable.spring_constant(),
        Kind::SeriesCompliance => cable.series_compliance,
        Kind::LinearDensity => cable.linear_density,
        Kind::Diameter => cable.diameter,
        Kind::TensionMin => cable.tension_min,
        Kind::TensionMax => cable.tension_max,
        Kind::LengthMin => cable.length_min,
        Kind::LengthMax => cable.length_max,
        Kind::SpeedMax => cable.speed_max,
        Kind::WrapMin => cable.pulley_wrap_min,
        Kind::WrapMax => cable.pulley_wrap_max,
        Kind::DrumPitch => cable.winch.pitch(),
        Kind::StartAngle => cable.winch.start_angle,
        Kind::GrooveLength => cable.winch.groove_length(),
        Kind::LayerHeight => cable.winch.layer_height(),
        Kind::GearRatio => cable.winch.gear_ratio,
        Kind::EncoderCounts => cable.winch.encoder_counts_per_turn,
        Kind::MotorSpeedMax => cable.winch.motor_speed_max,
        Kind::SpoolBuildUp => cable.winch.build_up,
        Kind::MechanicalAdvantage => cable.winch.mechanical_advantage,
        Kind::CableDamping => cable.damping,
        Kind::CableDampingTime => cable.damping_time,
        Kind::DrumInertia => cable.winch.drum_inertia,
        Kind::RotorInertia => cable.winch.rotor_inertia,
        Kind::CoulombFriction => cable.winch.coulomb_friction,
        Kind::ViscousFriction => cable.winch.viscous_friction,
        Kind::StaticFriction => cable.winch.static_friction,
        Kind::StribeckSpeed => cable.winch.stribeck_speed,
        Kind::PulleyFriction => cable.pulley_friction,
        Kind::PulleyInertia => cable.pulley_inertia,
        Kind::Stretch(number) => cable.law_numbers.get(number.entry().key).copied(),
        Kind::FrameAnchor | Kind::PlatformAnchor | Kind::DrumAxis | Kind::SwivelAxis => None,
        Kind::Force | Kind::Moment | Kind::Wrench | Kind::Mass | Kind::CenterOfMass | Kind::Gravity => None,
        Kind::PlatformDamping | Kind::RotationalDamping | Kind::TrackerFrame | Kind::MarkerFrame => None,
    }
}

pub(super) fn set_of_cable(kind: ParameterKind, cable: &mut Cable, value: f64) {
    use ParameterKind as Kind;
    let number = match kind {
        Kind::PulleyRadius => return cable.set_pulley_radius(value),
        Kind::AxialStiffness => return cable.stiffness = Some(CableStiffness::Axial(value)),
        Kind::Compliance => return cable.stiffness = Some(CableStiffness::Compliance(value)),
        Kind::SpringConstant => return cable.stiffness = Some(CableStiffness::Spring(value)),
        Kind::Stretch(number) => {
            cable.law_numbers.insert(number.entry().key, value);
            return;
        }
        Kind::LengthOffset => &mut cable.length_offset,
        Kind::LengthScale => &mut cable.length_scale,
        Kind::DrumRadius => &mut cable.winch.radius,
        Kind::StartLength => &mut cable.winch.start_length,
        Kind::HiddenLength => &mut cable.hidden_length,
        Kind::TensionScale => &mut cable.tension_scale,
        Kind::TensionOffset => &mut cable.tension_offset,
        Kind::SwivelOffset => &mut cable.swivel_offset,
        Kind::SeriesCompliance => &mut cable.series_compliance,
        Kind::LinearDensity => &mut cable.linear_density,
        Kind::Diameter => &mut cable.diameter,
        Kind::TensionMin => &mut cable.tension_min,
        Kind::TensionMax => &mut cable.tension_max,
        Kind::LengthMin => &mut cable.length_min,
        Kind::LengthMax => &mut cable.length_max,
        Kind::SpeedMax => &mut cable.speed_max,
        Kind::WrapMin => &mut cable.pulley_wrap_min,
        Kind::WrapMax => &mut cable.pulley_wrap_max,
        Kind::DrumPitch => return cable.winch.set_pitch(value),
        Kind::StartAngle => &mut cable.winch.start_angle,
        Kind::GrooveLength => return cable.winch.set_groove_length(value),
        Kind::LayerHeight => return cable.winch.set_layer_height(value),
        Kind::GearRatio => &mut cable.winch.gear_ratio,
        Kind::EncoderCounts => &mut cable.winch.encoder_counts_per_turn,
        Kind::MotorSpeedMax => &mut cable.winch.motor_speed_max,
        Kind::SpoolBuildUp => &mut cable.winch.build_up,
        Kind::MechanicalAdvantage => &mut cable.winch.mechanical_advantage,
        Kind::CableDamping => &mut cable.damping,
        Kind::CableDampingTime => &mut cable.damping_time,
        Kind::DrumInertia => &mut cable.winch.drum_inertia,
        Kind::RotorInertia => &mut cable.winch.rotor_inertia,
        Kind::CoulombFriction => &mut cable.winch.coulomb_friction,
        Kind::ViscousFriction => &mut cable.winch.viscous_friction,
        Kind::StaticFriction => &mut cable.winch.static_friction,
        Kind::StribeckSpeed => &mut cable.winch.stribeck_speed,
        Kind::PulleyFriction => &mut cable.pulley_friction,
        Kind::PulleyInertia => &mut cable.pulley_inertia,
        Kind::FrameAnchor | Kind::PlatformAnchor | Kind::DrumAxis | Kind::SwivelAxis => return,
        Kind::Force | Kind::Moment | Kind::Wrench | Kind::Mass | Kind::CenterOfMass | Kind::Gravity => return,
        Kind::PlatformDamping | Kind::RotationalDamping | Kind::TrackerFrame | Kind::MarkerFrame => return,
    };
    *number = Some(value);
}
