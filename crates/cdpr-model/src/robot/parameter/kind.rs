//! Kinds of parameters: the one list of a robot's numbers, with their names, keys in files, units and ranges.

use std::fmt;

use super::{Owner, Range};
use crate::robot::stretch::registry::StretchNumber;

/// Kind of a parameter; numbers of cables exist once per cable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum ParameterKind {
    /// Frame anchor a (world, m); entry point D of a pulley.
    FrameAnchor,
    /// Platform anchor b (platform frame, m).
    PlatformAnchor,
    /// Pulley radius r_p (m).
    PulleyRadius,
    /// q_recorded = length_scale · q_θ + length_offset (m).
    LengthOffset,
    /// See [`ParameterKind::LengthOffset`]; without unit.
    LengthScale,
    /// Radius of the winch's drum to the cable's centre line (m); identified from motor angles.
    DrumRadius,
    /// Controlled length at the drum's start angle (m); identified from motor angles. It shifts lengths as the length
    /// offset does, so that at most one of the two is free.
    StartLength,
    /// Specific stiffness EA (N).
    AxialStiffness,
    /// Strained length between winch and outlet q_h (m).
    HiddenLength,
    /// Constant external force on the platform (world, N).
    Force,
    /// Constant external moment about the platform origin (world, N·m).
    Moment,
    /// Mass of the platform (kg).
    Mass,
    /// Centre of mass (platform frame, m).
    CenterOfMass,
    /// Specific compliance 1/EA (1/N): its inverse, the stiffness, would diverge for data with little information on it
    /// (see the book).
    Compliance,
    /// f_recorded = tension_scale · f + tension_offset; without unit.
    TensionScale,
    /// See [`ParameterKind::TensionScale`] (N).
    TensionOffset,
    /// Constant external wrench in world axes, weight included (N, N·m).
    Wrench,
    /// Spring constant that does not depend on the length (N/m).
    SpringConstant,
    /// Further compliance in series with the cable (m/N).
    SeriesCompliance,
    /// Mass per length of the unstrained cable (kg/m).
    LinearDensity,
    /// Diameter of the cable (m).
    Diameter,
    /// Least tension allowed (N).
    TensionMin,
    /// Largest tension allowed (N).
    TensionMax,
    /// Least geometric length allowed (m).
    LengthMin,
    /// Largest geometric length allowed (m).
    LengthMax,
    /// Largest speed of the cable (m/s).
    SpeedMax,
    /// Least wrap angle on the pulley (rad).
    WrapMin,
    /// Largest wrap angle on the pulley (rad).
    WrapMax,
    /// Pitch of the drum's groove (m per turn).
    DrumPitch,
    /// Drum angle at which the controlled length is the start length (rad).
    StartAngle,
    /// Length of the groove along the drum's axis (m).
    GrooveLength,
    /// Increase of the radius with each further layer of cable (m).
    LayerHeight,
    /// Motor angle = gear ratio · drum angle; without unit.
    GearRatio,
    /// Counts of the motor's encoder in one turn of the motor; without unit.
    EncoderCounts,
    /// Largest speed of the motor (rad/s).
    MotorSpeedMax,
    /// Gravity (world, m/s²).
    Gravity,
    /// Increase of a spool's squared radius per metre wound (m); identified from motor angles.
    SpoolBuildUp,
    /// Length on the drum over length of the cable, with a tackle; without unit.
    MechanicalAdvantage,
    /// Damping force of the cable per rate of its elongation (N·s/m).
    CableDamping,
    /// Damping time η of the cable: damping over stiffness (s).
    CableDampingTime,
    /// Inertia of the drum about its axis (kg·m²).
    DrumInertia,
    /// Inertia of the motor's rotor about its axis (kg·m²).
    RotorInertia,
    /// Dry friction at the drum (N·m).
    CoulombFriction,
    /// Viscous friction at the drum (N·m·s/rad).
    ViscousFriction,
    /// Static friction of the drum (N·m).
    StaticFriction,
    /// Speed over which a drum's dry friction falls from the static one to Coulomb's (rad/s).
    StribeckSpeed,
    /// Friction coefficient of the pulley, its bearing included; without unit.
    PulleyFriction,
    /// Inertia of the pulley about its axis (kg·m²).
    PulleyInertia,
    /// Damping of the platform's velocity D_lin (N·s/m).
    PlatformDamping,
    /// Damping of its angular velocity D_rot (N·m·s/rad).
    RotationalDamping,
    /// Turn of the drum's axis from the given direction, about two directions perpendicular to it (rad).
    DrumAxis,
    /// Turn of the pulley's swivel axis from the given direction, about two directions perpendicular to it; for planar
    /// robots about the plane's normal (rad).
    SwivelAxis,
    /// Zero of the encoder at a pulley's swivel: swivel_recorded = swivel angle + swivel_offset (rad).
    SwivelOffset,
    /// Frame of the tracker's world in the robot's frame: its origin (m), then its rotation vector (rad). It belongs to a recording, and no file states it.
    TrackerFrame,
    /// Frame of the tracked marker on the platform, as [`ParameterKind::TrackerFrame`].
    MarkerFrame,
    /// Number of a law of stretch, from the list of all laws.
    Stretch(StretchNumber),
}

/// Properties of a kind.
struct Entry {
    name: &'static str,
    owner: Owner,
    key: &'static str,
    unit: &'static str,
    range: Range,
}

/// Kinds, followed by the numbers of all laws of stretch.
const fn with_stretch<const N: usize, const M: usize>(kinds: [ParameterKind; N]) -> [ParameterKind; M] {
    let mut all = [ParameterKind::FrameAnchor; M];
    let mut k = 0;
    while k < M {
        all[k] = if k < N { kinds[k] } else { ParameterKind::Stretch(StretchNumber::at(k - N)) };
        k += 1;
    }
    all
}

const fn of(owner: Owner, name: &'static str, key: &'static str, unit: &'static str, range: Range) -> Entry {
    Entry { name, owner, key, unit, range }
}

impl ParameterKind {
    /// Every kind.
    pub(crate) const ALL: [Self; 53 + StretchNumber::COUNT] = with_stretch([
        Self::FrameAnchor,
        Self::PlatformAnchor,
        Self::PulleyRadius,
        Self::LengthOffset,
        Self::LengthScale,
        Self::DrumRadius,
        Self::StartLength,
        Self::AxialStiffness,
        Self::HiddenLength,
        Self::Force,
        Self::Moment,
        Self::Mass,
        Self::CenterOfMass,
        Self::Compliance,
        Self::TensionScale,
        Self::TensionOffset,
        Self::Wrench,
        Self::SpringConstant,
        Self::SeriesCompliance,
        Self::LinearDensity,
        Self::Diameter,
        Self::TensionMin,
        Self::TensionMax,
        Self::LengthMin,
        Self::LengthMax,
        Self::SpeedMax,
        Self::WrapMin,
        Self::WrapMax,
        Self::DrumPitch,
        Self::StartAngle,
        Self::GrooveLength,
        Self::LayerHeight,
        Self::GearRatio,
        Self::EncoderCounts,
        Self::MotorSpeedMax,
        Self::Gravity,
        Self::DrumAxis,
        Self::SwivelAxis,
        Self::SpoolBuildUp,
        Self::MechanicalAdvantage,
        Self::CableDamping,
        Self::CableDampingTime,
        Self::DrumInertia,
        Self::RotorInertia,
        Self::CoulombFriction,
        Self::ViscousFriction,
        Self::StaticFriction,
        Self::StribeckSpeed,
        Self::PulleyFriction,
        Self::PulleyInertia,
        Self::PlatformDamping,
        Self::RotationalDamping,
        Self::SwivelOffset,
    ]);

    /// Kinds that identification may free, in the order of a parameter vector.
    pub const IDENTIFIED: [Self; 21 + StretchNumber::COUNT] = with_stretch([
        Self::FrameAnchor,
        Self::PlatformAnchor,
        Self::LengthOffset,
        Self::LengthScale,
        Self::PulleyRadius,
        Self::SwivelAxis,
        Self::SwivelOffset,
        Self::DrumRadius,
        Self::SpoolBuildUp,
        Self::DrumPitch,
        Self::DrumAxis,
        Self::StartLength,
        Self::StartAngle,
        Self::Compliance,
        Self::HiddenLength,
        Self::LinearDensity,
        Self::TensionScale,
        Self::TensionOffset,
        Self::Mass,
        Self::CenterOfMass,
        Self::Wrench,
    ]);

    fn entry(self) -> Entry {
        use Owner::{Cable, ExternalWrench, Platform};
        use Range::{NotNegative, NotZero, Positive, Real};
        match self {
            Self::FrameAnchor => of(Cable, "frame-anchor", "frame_anchor_m", "m", Real),
            Self::PlatformAnchor => of(Cable, "platform-anchor", "platform_anchor_m", "m", Real),
            Self::PulleyRadius => of(Cable, "pulley-radius", "pulley_radius_m", "m", NotNegative),
            Self::LengthOffset => of(Cable, "length-offset", "length_offset_m", "m", Real),
            Self::LengthScale => of(Cable, "length-scale", "length_scale", "", Positive),
            Self::DrumRadius => of(Cable, "drum-radius", "drum_radius_m", "m", Positive),
            Self::StartLength => of(Cable, "start-length", "drum_start_length_m", "m", Real),
            Self::AxialStiffness => of(Cable, "axial-stiffness", "axial_stiffness_EA_N", "N", Positive),
            Self::HiddenLength => of(Cable, "hidden-length", "hidden_length_m", "m", NotNegative),
            Self::Force => of(ExternalWrench, "force", "force_N", "N", Real),
            Self::Moment => of(ExternalWrench, "moment", "moment_Nm", "N·m", Real),
            Self::Mass => of(Platform, "mass", "mass_kg", "kg", NotNegative),
            Self::PlatformDamping => of(Platform, "platform-damping", "damping_N_s_per_m", "N·s/m", NotNegative),
            Self::RotationalDamping => {
                of(Platform, "rotational-damping", "rotational_damping_Nm_s_per_rad", "N·m·s/rad", NotNegative)
            }
            Self::CenterOfMass => of(Platform, "center-of-mass", "center_of_mass_m", "m", Real),
            Self::Compliance => of(Cable, "compliance", "axial_compliance_per_N", "1/N", NotNegative),
            Self::TensionScale => of(Cable, "tension-scale", "tension_scale", "", Positive),
            Self::TensionOffset => of(Cable, "tension-offset", "tension_offset_N", "N", Real),
            // force and moment are its keys
            Self::Wrench => of(ExternalWrench, "wrench", "", "N", Real),
            Self::SpringConstant => of(Cable, "spring-constant", "spring_constant_N_per_m", "N/m", Positive),
            Self::SeriesCompliance => of(Cable, "series-compliance", "series_compliance_m_per_N", "m/N", NotNegative),
            Self::LinearDensity => of(Cable, "linear-density", "linear_density_kg_per_m", "kg/m", NotNegative),
            Self::Diameter => of(Cable, "diameter", "diameter_m", "m", Positive),
            Self::TensionMin => of(Cable, "tension-min", "tension_min_N", "N", NotNegative),
            Self::TensionMax => of(Cable, "tension-max", "tension_max_N", "N", NotNegative),
            Self::LengthMin => of(Cable, "length-min", "length_min_m", "m", NotNegative),
            Self::LengthMax => of(Cable, "length-max", "length_max_m", "m", NotNegative),
            Self::SpeedMax => of(Cable, "speed-max", "speed_max_m_s", "m/s", Positive),
            Self::WrapMin => of(Cable, "wrap-min", "pulley_wrap_min_rad", "rad", NotNegative),
            Self::WrapMax => of(Cable, "wrap-max", "pulley_wrap_max_rad", "rad", NotNegative),
            Self::DrumPitch => of(Cable, "drum-pitch", "drum_pitch_m", "m", NotNegative),
            Self::StartAngle => of(Cable, "start-angle", "drum_start_angle_rad", "rad", Real),
            Self::GrooveLength => of(Cable, "groove-length", "drum_groove_length_m", "m", Positive),
            Self::LayerHeight => of(Cable, "layer-height", "drum_layer_height_m", "m", Positive),
            Self::GearRatio => of(Cable, "gear-ratio", "gear_ratio", "", NotZero),
            Self::SpoolBuildUp => of(Cable, "spool-build-up", "spool_build_up_m", "m", NotNegative),
            Self::MechanicalAdvantage => of(Cable, "mechanical-advantage", "mechanical_advantage", "", Positive),
            Self::CableDamping => of(Cable, "cable-damping", "cable_damping_N_s_per_m", "N·s/m", NotNegative),
            Self::CableDampingTime => of(Cable, "cable-damping-time", "cable_damping_time_s", "s", NotNegative),
            Self::DrumInertia => of(Cable, "drum-inertia", "drum_inertia_kg_m2", "kg·m²", Positive),
            Self::RotorInertia => of(Cable, "rotor-inertia", "rotor_inertia_kg_m2", "kg·m²", NotNegative),
            Self::CoulombFriction => of(Cable, "coulomb-friction", "drum_coulomb_friction_Nm", "N·m", NotNegative),
            Self::ViscousFriction => {
                of(Cable, "viscous-friction", "drum_viscous_friction_Nm_s_per_rad", "N·m·s/rad", NotNegative)
            }
            Self::StaticFriction => of(Cable, "static-friction", "drum_static_friction_Nm", "N·m", NotNegative),
            Self::StribeckSpeed => of(Cable, "stribeck-speed", "drum_stribeck_speed_rad_per_s", "rad/s", Positive),
            Self::PulleyFriction => of(Cable, "pulley-friction", "pulley_friction", "", NotNegative),
            Self::PulleyInertia => of(Cable, "pulley-inertia", "pulley_inertia_kg_m2", "kg·m²", NotNegative),
            Self::EncoderCounts => of(Cable, "encoder-counts", "encoder_counts_per_turn", "", Positive),
            Self::MotorSpeedMax => of(Cable, "motor-speed-max", "motor_speed_max_rad_per_s", "rad/s", Positive),
            // the file states unit vectors, drum_axis and pulley_swivel_axis
            Self::DrumAxis => of(Cable, "drum-axis", "", "rad", Real),
            Self::SwivelAxis => of(Cable, "swivel-axis", "", "rad", Real),
            Self::SwivelOffset => of(Cable, "swivel-offset", "swivel_offset_rad", "rad", Real),
            Self::Stretch(number) => {
                let number = number.entry();
                of(Cable, number.name, number.key, number.unit, Positive)
            }
            Self::TrackerFrame => of(Owner::Recording, "tracker-frame", "", "m", Real),
            Self::MarkerFrame => of(Owner::Recording, "marker-frame", "", "m", Real),
            Self::Gravity => of(Owner::Robot, "gravity", "gravity_m_s2", "m/s²", Real),
        }
    }

    /// Name in options and results, e.g. `frame-anchor`.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// Key in the robot file; empty for the wrench, which has the keys of force and moment, and for turns of axes,
    /// which are stated as vectors.
    pub(crate) fn key(self) -> &'static str {
        self.entry().key
    }

    pub(crate) fn owner(self) -> Owner {
        self.entry().owner
    }

    pub(crate) fn range(self) -> Range {
        self.entry().range
    }

    /// Unit of the value, empty for a ratio; a wrench is in N, its moments in N·m.
    pub fn unit(self) -> &'static str {
        self.entry().unit
    }

    /// True for the anchors, which have a component along each axis of the pattern.
    pub fn is_anchor(self) -> bool {
        matches!(self, Self::FrameAnchor | Self::PlatformAnchor)
    }

    /// True for numbers of the load on the platform, which belong to no cable.
    pub fn is_of_load(self) -> bool {
        matches!(self, Self::Mass | Self::CenterOfMass | Self::Wrench)
    }

    /// True for frames of a recording.
    pub fn is_of_recording(self) -> bool {
        matches!(self, Self::TrackerFrame | Self::MarkerFrame)
    }

    /// True for numbers that exist once for each cable; those of load and recording come behind them in parameter vectors.
    pub fn is_of_cable(self) -> bool {
        !self.is_of_load() && !self.is_of_recording()
    }

    /// True for turns of an axis.
    pub(crate) fn is_turn(self) -> bool {
        matches!(self, Self::DrumAxis | Self::SwivelAxis)
    }

    /// Value for a robot that states none: a scale of 1, an offset of 0.
    pub(crate) fn neutral(self) -> f64 {
        match self {
            Self::LengthScale | Self::TensionScale | Self::GearRatio | Self::MechanicalAdvantage => 1.0,
            _ => 0.0,
        }
    }
}

impl fmt::Display for ParameterKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
