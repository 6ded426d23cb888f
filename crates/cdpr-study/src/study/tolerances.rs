//! Tolerances of a study's numbers: standard deviations by side and kind.

use serde::Deserialize;

use crate::sensitivity::{Kind, Offsets, ParameterDeviation, Side};
use cdpr_model::robot::ParameterKind;

/// Deviations of the numbers of control model, machine and winches, and the accuracy that is required.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Tolerances {
    /// Deviations of the control model's numbers: errors of the controller's file.
    pub control: ModelTolerances,
    /// Deviations of the machine's numbers: errors of manufacture and mounting.
    pub machine: ModelTolerances,
    /// Deviations of the winches as they were set at the initial pose.
    pub winches: WinchTolerances,
    /// Effect of deviations on the winch offsets; `kept` when missing.
    pub offsets: Offsets,
    /// How deviations are spread; `normal` when missing.
    pub distribution: Distribution,
    /// Robots drawn; 10 000 when missing.
    #[schemars(range(min = 1, max = 1000000))]
    pub robots: usize,
    /// Required accuracy of the position (m); that of the study's limits counts when missing.
    pub accuracy_m: Option<f64>,
    /// Distance that has to keep the required accuracy; `error` when missing.
    pub accuracy_of: AccuracyOf,
    /// Standard deviations that count: an allowed tolerance keeps so many times the root mean square within the accuracy, and the worst
    /// case of normal deviations takes so many of each. 2 when missing.
    #[schemars(range(min = 0.1, max = 10.0))]
    pub sigmas: f64,
}

impl Default for Tolerances {
    fn default() -> Self {
        Self {
            control: ModelTolerances::default(),
            machine: ModelTolerances::default(),
            winches: WinchTolerances::default(),
            offsets: Offsets::Kept,
            distribution: Distribution::Normal,
            robots: 10_000,
            accuracy_m: None,
            accuracy_of: AccuracyOf::Error,
            sigmas: 2.0,
        }
    }
}

/// How deviations are spread about zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Distribution {
    /// Normal.
    #[default]
    Normal,
    /// Uniform within ±√3 standard deviations.
    Uniform,
}

/// Distance that a required accuracy is about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum AccuracyOf {
    /// The distance from the commanded position, which includes errors by effects that the control model leaves out.
    #[default]
    Error,
    /// The distance from the position that the robot without deviations reaches.
    Deviation,
}

/// Standard deviations of a model's numbers, each independent of the others; 0 when missing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct ModelTolerances {
    /// Frame anchors, per axis (m).
    #[schemars(range(min = 0.0))]
    pub frame_anchor_m: f64,
    /// Platform anchors, per axis (m).
    #[schemars(range(min = 0.0))]
    pub platform_anchor_m: f64,
    /// Pulley radii (m).
    #[schemars(range(min = 0.0))]
    pub pulley_radius_m: f64,
    /// Swivel axes of the pulleys, turn about each of two directions perpendicular to them; of planar robots about the plane's normal (rad).
    #[schemars(range(min = 0.0))]
    pub swivel_axis_rad: f64,
    /// Offsets of the recorded lengths (m).
    #[schemars(range(min = 0.0))]
    pub length_offset_m: f64,
    /// Scales of the recorded lengths (1).
    #[schemars(range(min = 0.0))]
    pub length_scale_relative: f64,
    /// Radii of the drums (m).
    #[schemars(range(min = 0.0))]
    pub drum_radius_m: f64,
    /// Pitches of the drums' grooves (m per turn).
    #[schemars(range(min = 0.0))]
    pub drum_pitch_m: f64,
    /// Axes of the drums, turn about each of two directions perpendicular to them (rad).
    #[schemars(range(min = 0.0))]
    pub drum_axis_rad: f64,
    /// Start lengths of the drums (m).
    #[schemars(range(min = 0.0))]
    pub start_length_m: f64,
    /// Start angles of the drums (rad).
    #[schemars(range(min = 0.0))]
    pub start_angle_rad: f64,
    /// Axial stiffness EA, relative to its value (1).
    #[schemars(range(min = 0.0))]
    pub axial_stiffness_relative: f64,
    /// Hidden lengths (m).
    #[schemars(range(min = 0.0))]
    pub hidden_length_m: f64,
    /// Force on the platform, per axis (N).
    #[schemars(range(min = 0.0))]
    pub force_N: f64,
    /// Moment on the platform, per axis (N·m).
    #[schemars(range(min = 0.0))]
    pub moment_Nm: f64,
    /// Mass of the platform (kg).
    #[schemars(range(min = 0.0))]
    pub mass_kg: f64,
    /// Centre of mass, per axis (m).
    #[schemars(range(min = 0.0))]
    pub center_of_mass_m: f64,
}

/// Standard deviations of how the winches were set; 0 when missing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct WinchTolerances {
    /// Winch offsets (m).
    #[schemars(range(min = 0.0))]
    pub offset_m: f64,
    /// Initial tensions (N).
    #[schemars(range(min = 0.0))]
    pub initial_tension_N: f64,
}

impl Tolerances {
    /// Standard deviation of a cause, in its unit; 0 if the study states none.
    pub(crate) fn sigma(&self, cause: &ParameterDeviation) -> f64 {
        let same = |&(side, kind, ..): &(Side, Kind, &str, f64)| (side, kind) == (cause.side, cause.kind);
        self.entries().find(same).map_or(0.0, |(.., sigma)| sigma)
    }

    /// Largest deviation in the worst case, in standard deviations.
    pub(crate) fn reach(&self) -> f64 {
        match self.distribution {
            Distribution::Normal => self.sigmas,
            Distribution::Uniform => 3.0_f64.sqrt(),
        }
    }

    /// All keys with their kinds and values.
    pub(crate) fn entries(&self) -> impl Iterator<Item = (Side, Kind, &'static str, f64)> {
        let sided = |side: Side, of_model: &ModelTolerances| {
            of_model.entries().into_iter().map(move |(kind, key, sigma)| (side, Kind::Parameter(kind), key, sigma))
        };
        let winches = [
            (Side::Winches, Kind::WinchOffset, "offset_m", self.winches.offset_m),
            (Side::Winches, Kind::InitialTension, "initial_tension_N", self.winches.initial_tension_N),
        ];
        sided(Side::Control, &self.control).chain(sided(Side::Machine, &self.machine)).chain(winches)
    }
}

impl ModelTolerances {
    fn entries(&self) -> [(ParameterKind, &'static str, f64); 17] {
        [
            (ParameterKind::FrameAnchor, "frame_anchor_m", self.frame_anchor_m),
            (ParameterKind::PlatformAnchor, "platform_anchor_m", self.platform_anchor_m),
            (ParameterKind::PulleyRadius, "pulley_radius_m", self.pulley_radius_m),
            (ParameterKind::SwivelAxis, "swivel_axis_rad", self.swivel_axis_rad),
            (ParameterKind::LengthOffset, "length_offset_m", self.length_offset_m),
            (ParameterKind::LengthScale, "length_scale_relative", self.length_scale_relative),
            (ParameterKind::DrumRadius, "drum_radius_m", self.drum_radius_m),
            (ParameterKind::DrumPitch, "drum_pitch_m", self.drum_pitch_m),
            (ParameterKind::DrumAxis, "drum_axis_rad", self.drum_axis_rad),
            (ParameterKind::StartLength, "start_length_m", self.start_length_m),
            (ParameterKind::StartAngle, "start_angle_rad", self.start_angle_rad),
            (ParameterKind::AxialStiffness, "axial_stiffness_relative", self.axial_stiffness_relative),
            (ParameterKind::HiddenLength, "hidden_length_m", self.hidden_length_m),
            (ParameterKind::Force, "force_N", self.force_N),
            (ParameterKind::Moment, "moment_Nm", self.moment_Nm),
            (ParameterKind::Mass, "mass_kg", self.mass_kg),
            (ParameterKind::CenterOfMass, "center_of_mass_m", self.center_of_mass_m),
        ]
    }
}
