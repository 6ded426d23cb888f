//! The keys, types and order of the robot file, layout version 1. `reading` finds repeated and wrong values.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};

use cdpr_core::cable::elasticity::StiffnessBasis;

use super::stretch::registry::{LawNumber, law_numbers};
use super::{Assumption, Calibration, DrumSide, HysteresisTable, ReferenceCheck, Source, TensionPlace, WrapSide};
use crate::geometry::MotionPattern;

/// Keys of a cable that `[cable_defaults]` cannot state, since they differ from cable to cable.
pub(super) const OWN_KEYS: [&str; 3] = ["name", "frame_anchor_m", "platform_anchor_m"];

/// Description of a cable robot, layout version 1. SI units, named in the keys; a missing key means unknown, never zero. Planar robots (2T, 1R2T) use 2-vectors in the plane named by `axes`, spatial ones 3-vectors.
#[derive(Clone, Debug, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "cdpr robot", transform = require_platform_anchors)]
pub(super) struct RobotFile {
    /// Version of this layout: 1.
    #[schemars(range(min = 1, max = 1))]
    #[expect(dead_code, reason = "looked at before all other keys, which another layout may not have")]
    pub(super) layout_version: u32,
    /// Short name, without spaces.
    pub(super) name: String,
    /// One line for people.
    pub(super) title: Option<String>,
    /// Degrees of freedom of the platform: R rotations, T translations.
    pub(super) motion_pattern: MotionPattern,
    /// Type in the author's own words, e.g. `spatial-suspended`.
    pub(super) kind: Option<String>,
    /// Number of `[[cable]]` tables, to notice a file that was cut off.
    pub(super) cable_count: Option<usize>,
    /// Planar robots only: the two world axes of every 2-vector, e.g. `xz`; angles turn from the first to the second.
    #[schemars(regex(pattern = "^(xy|xz|yx|yz|zx|zy)$"))]
    pub(super) axes: Option<String>,
    /// Gravity (world axes, m/s²).
    pub(super) gravity_m_s2: Option<Vec<f64>>,
    /// Remarks, one paragraph each.
    #[serde(default)]
    pub(super) notes: Vec<String>,
    /// Source of the numbers.
    pub(super) source: Option<Source>,
    /// Calibration that the numbers come from, as `cdpr identify`, `select` and `demo` write it; a file changed by hand should lose it.
    pub(super) calibration: Option<Calibration>,
    /// Assumed numbers of this file, which no source states and nobody measured, each with the reason for its value.
    #[serde(default)]
    pub(super) assumption: Vec<Assumption>,
    /// Mass properties of the platform.
    #[serde(default)]
    pub(super) platform: PlatformSection,
    /// A pose inside the workspace to start from.
    pub(super) home_pose: Option<HomeSection>,
    /// External wrench on the platform, besides the cables.
    pub(super) external_wrench: Option<WrenchSection>,
    /// Box of platform positions for plotting and sampling; not a proven workspace.
    pub(super) workspace: Option<WorkspaceSection>,
    /// Obstacles in the way of cables (world).
    #[serde(default)]
    pub(super) obstacle: Vec<ObstacleSection>,
    /// Keys that hold for every cable that does not state them itself: all of a cable but `name`, `frame_anchor_m` and `platform_anchor_m`. A stiffness that a cable states in one way takes the place of one stated here in another. A file that `cdpr` writes states them at every cable.
    #[serde(default)]
    #[schemars(schema_with = "cable_defaults_schema")]
    #[expect(dead_code, reason = "its keys are those of the cables by the time that the file is read")]
    pub(super) cable_defaults: BTreeMap<String, IgnoredAny>,
    /// The cables, in the order of every per-cable list.
    #[serde(default)]
    #[schemars(length(min = 1))]
    pub(super) cable: Vec<CableSection>,
    /// Published numbers to reproduce.
    #[serde(default)]
    pub(super) reference_check: Vec<ReferenceCheck>,
}

/// Mass properties of the platform.
#[derive(Clone, Debug, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub(super) struct PlatformSection {
    /// Mass (kg).
    #[schemars(range(min = 0))]
    pub(super) mass_kg: Option<f64>,
    /// Centre of mass (platform frame, m).
    pub(super) center_of_mass_m: Option<Vec<f64>>,
    /// Inertia about the centre of mass (platform axes, kg·m²): rows of a 3×3 matrix; of a planar robot one number.
    pub(super) inertia_about_center_of_mass_kg_m2: Option<Inertia>,
    /// Damping of the platform's velocity, as by air (N·s/m): force −this · v at the platform origin, for machines in time.
    #[schemars(range(min = 0))]
    pub(super) damping_N_s_per_m: Option<f64>,
    /// Damping of its angular velocity (N·m·s/rad): moment −this · ω.
    #[schemars(range(min = 0))]
    pub(super) rotational_damping_Nm_s_per_rad: Option<f64>,
    /// Corners of the body (platform frame, m), whose convex hull cables shall not touch; that of the platform anchors when missing.
    #[schemars(length(min = 3, max = 256))]
    pub(super) hull_m: Option<Vec<Vec<f64>>>,
}

/// Inertia as a planar or a spatial robot states it.
#[derive(Clone, Debug, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(untagged, expecting = "inertia is one number (planar) or a 3×3 matrix given by rows (spatial)")]
pub(super) enum Inertia {
    /// About the normal of the plane.
    Planar(f64),
    /// Rows of the matrix.
    Spatial(Vec<Vec<f64>>),
}

/// A platform pose.
#[derive(Clone, Debug, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct HomeSection {
    /// Position of the platform origin (world, m).
    pub(super) position_m: Vec<f64>,
    /// 3R3T: rotation matrix from platform to world, by rows.
    pub(super) rotation: Option<Vec<Vec<f64>>>,
    /// 1R2T: angle from the first to the second of `axes` (rad).
    pub(super) angle_rad: Option<f64>,
}

/// A constant wrench that acts on the platform at its origin; equilibrium is Aᵀ f + w = 0.
#[derive(Clone, Debug, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub(super) struct WrenchSection {
    /// Force (world axes, N).
    pub(super) force_N: Vec<f64>,
    /// Moment about the platform origin (world axes, N·m): 3R3T three numbers, 1R2T one.
    pub(super) moment_Nm: Option<Moment>,
    /// True when the weight is part of it and must not be added again.
    #[serde(default)]
    pub(super) includes_gravity: bool,
    /// Origin of the wrench.
    pub(super) note: Option<String>,
}

/// A moment as a planar or a spatial robot states it.
#[derive(Clone, Debug, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(untagged, expecting = "a moment is one number (planar) or three (spatial)")]
pub(super) enum Moment {
    /// About the normal of the plane.
    Planar(f64),
    /// About the world axes.
    Spatial(Vec<f64>),
}

/// An axis-parallel box of platform positions.
#[derive(Clone, Debug, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WorkspaceSection {
    /// Lower corner (world, m).
    pub(super) position_min_m: Vec<f64>,
    /// Upper corner (world, m).
    pub(super) position_max_m: Vec<f64>,
    /// Origin of the box.
    pub(super) note: Option<String>,
}

/// One cable, from its frame anchor to its platform anchor.
#[derive(Clone, Debug, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = add_law_numbers)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub(super) struct CableSection {
    /// Name for people, best unique in the robot.
    pub(super) name: String,
    /// Frame anchor (world, m); with a pulley the point where the cable enters the swivelling pulley on its swivel axis.
    pub(super) frame_anchor_m: Vec<f64>,
    /// Platform anchor (platform frame, m). Cables of point platforms (2T, 3T) end at the origin when it is missing; other platforms need it.
    pub(super) platform_anchor_m: Option<Vec<f64>>,
    /// Radius of the pulley at the frame (m).
    #[schemars(range(min = 0))]
    pub(super) pulley_radius_m: Option<f64>,
    /// Least wrap angle on the pulley (rad), for the criterion `pulley-wrap`.
    #[schemars(range(min = 0))]
    pub(super) pulley_wrap_min_rad: Option<f64>,
    /// Largest wrap angle on the pulley (rad), for the criterion `pulley-wrap`.
    #[schemars(range(min = 0))]
    pub(super) pulley_wrap_max_rad: Option<f64>,
    /// Diameter of the cable (m), for criteria of interference.
    pub(super) diameter_m: Option<f64>,
    /// Least geometric length allowed, wrapped part included (m), for the criterion `cable-length`.
    #[schemars(range(min = 0))]
    pub(super) length_min_m: Option<f64>,
    /// Largest geometric length allowed, wrapped part included (m), for the criterion `cable-length`.
    #[schemars(range(min = 0))]
    pub(super) length_max_m: Option<f64>,
    /// Largest speed at which the cable may be wound or paid out (m/s), for `cdpr capability`; what the drive allows (`motor_speed_max_rad_per_s`) limits it, too.
    pub(super) speed_max_m_s: Option<f64>,
    /// Least tension allowed (N).
    #[schemars(range(min = 0))]
    pub(super) tension_min_N: Option<f64>,
    /// Largest tension allowed (N).
    #[schemars(range(min = 0))]
    pub(super) tension_max_N: Option<f64>,
    /// Specific stiffness E·A (N): spring constant times length. Instead of it: `axial_compliance_per_N` or `spring_constant_N_per_m`.
    pub(super) axial_stiffness_EA_N: Option<f64>,
    /// 1/(E·A) (1/N); 0 is a rigid cable.
    #[schemars(range(min = 0))]
    pub(super) axial_compliance_per_N: Option<f64>,
    /// Spring constant that does not depend on the length (N/m).
    pub(super) spring_constant_N_per_m: Option<f64>,
    /// Unit vector along the swivel axis, from the winch into the pulley (world).
    pub(super) pulley_swivel_axis: Option<Vec<f64>>,
    /// Planar robots only: the pulley does not swivel and stands on this side of the cable that runs into it along `pulley_swivel_axis`: `left` or `right`, seen with the first of `axes` turning counterclockwise to the second. The cable turns to that side.
    pub(super) pulley_wrap_side: Option<WrapSide>,
    /// Which length divides E·A: `actual` (k = EA/q, the default) or `unstrained` (k = EA/q_θ).
    pub(super) stiffness_by: Option<StiffnessBasis>,
    /// Strained length between winch and outlet that the geometry does not see (m).
    #[schemars(range(min = 0))]
    pub(super) hidden_length_m: Option<f64>,
    /// Further compliance in series with the cable (m/N).
    #[schemars(range(min = 0))]
    pub(super) series_compliance_m_per_N: Option<f64>,
    /// Tension as a polynomial of the strain, f = c1 ε + c2 ε² + … (N), which the effect `polynomial` reads: rising up to tension_max_N. The strain is counted from the unstrained length.
    #[schemars(length(min = 1))]
    pub(super) tension_of_strain_N: Option<Vec<f64>>,
    /// Loading and unloading branch, which the effect `hysteresis` reads.
    pub(super) hysteresis: Option<HysteresisTable>,
    /// Radius of the winch's drum to the cable's centre line (m): bottom of the groove plus half a cable diameter.
    pub(super) drum_radius_m: Option<f64>,
    /// Pitch of the drum's groove (m per turn).
    #[schemars(range(min = 0))]
    pub(super) drum_pitch_m: Option<f64>,
    /// Unit vector along the drum's axis, the way the contact point travels while cable is paid out (world; three components also in a planar robot).
    pub(super) drum_axis: Option<Vec<f64>>,
    /// Point of the drum's axis level with the contact point at the start angle (world, m; three components also in a planar robot).
    pub(super) drum_position_m: Option<Vec<f64>>,
    /// Side on which the cable leaves the drum, seen along `drum_axis` with the first pulley above: `left` (the default, turning right-handed about the axis pays out) or `right`.
    pub(super) drum_side: Option<DrumSide>,
    /// True when a guide travels with the contact point, so that the free length behind the drum stays the same.
    pub(super) drum_guided: Option<bool>,
    /// Point at which the cable from the drum enters its first pulley (world, m); `frame_anchor_m` when missing.
    pub(super) drum_pulley_m: Option<Vec<f64>>,
    /// Drum angle at which the controlled length is `drum_start_length_m` (rad, paying out is positive); 0 when missing.
    pub(super) drum_start_angle_rad: Option<f64>,
    /// Controlled length at `drum_start_angle_rad` (m); 0 when missing. With a groove of finite length it is where the first layer is full.
    pub(super) drum_start_length_m: Option<f64>,
    /// Length of the groove along the axis (m); without ends when missing.
    pub(super) drum_groove_length_m: Option<f64>,
    /// Radius that each further layer of cable adds (m); one layer when missing.
    pub(super) drum_layer_height_m: Option<f64>,
    /// Motor angle = gear_ratio · drum angle; 1 when missing.
    pub(super) gear_ratio: Option<f64>,
    /// Squared radius that a spool gains with every metre wound on it (m): r² = drum_radius_m² − spool_build_up_m · length paid out by the spool. Not beside a groove (`drum_pitch_m`).
    #[schemars(range(min = 0))]
    pub(super) spool_build_up_m: Option<f64>,
    /// Length on the drum over length of the cable, as tackle makes it: 2 where the cable runs to the platform and back; 1 when missing.
    pub(super) mechanical_advantage: Option<f64>,
    /// Counts of the motor's encoder in one turn of the motor.
    pub(super) encoder_counts_per_turn: Option<f64>,
    /// Largest speed of the motor (rad/s), for `cdpr capability`: the cable's is this / gear_ratio · drum radius / mechanical_advantage. Needs `drum_radius_m`.
    pub(super) motor_speed_max_rad_per_s: Option<f64>,
    /// Damping of the cable along the rate of its elongation (N·s/m), for `cdpr run`.
    #[schemars(range(min = 0))]
    pub(super) cable_damping_N_s_per_m: Option<f64>,
    /// Damping time η (s): the cable's damping is η times its stiffness, E·A over its length. Adds to `cable_damping_N_s_per_m`.
    #[schemars(range(min = 0))]
    pub(super) cable_damping_time_s: Option<f64>,
    /// Inertia of the drum about its axis (kg·m²), for winches in motion.
    pub(super) drum_inertia_kg_m2: Option<f64>,
    /// Inertia of the motor's rotor about its axis (kg·m²); it counts at the drum with the square of `gear_ratio`.
    #[schemars(range(min = 0))]
    pub(super) rotor_inertia_kg_m2: Option<f64>,
    /// Torque of dry friction at the drum (N·m).
    #[schemars(range(min = 0))]
    pub(super) drum_coulomb_friction_Nm: Option<f64>,
    /// Torque of dry friction at the drum that has to be overcome before it turns (N·m), no less than `drum_coulomb_friction_Nm`, which is that of a turning drum; the same when missing.
    #[schemars(range(min = 0))]
    pub(super) drum_static_friction_Nm: Option<f64>,
    /// Stribeck speed of the drum (rad/s): with speed φ̇ dry friction falls from the static one to Coulomb's by exp(−(φ̇/this)²). Needed beside `drum_static_friction_Nm`.
    pub(super) drum_stribeck_speed_rad_per_s: Option<f64>,
    /// Torque of friction at the drum per speed (N·m·s/rad).
    #[schemars(range(min = 0))]
    pub(super) drum_viscous_friction_Nm_s_per_rad: Option<f64>,
    /// Friction coefficient of the pulley, its bearing included, for the effect `pulley` with drums in motion: tension at the drum = tension at the outlet · exp(±this · wrap angle).
    #[schemars(range(min = 0))]
    pub(super) pulley_friction: Option<f64>,
    /// Inertia of the pulley about its axis (kg·m²), for drums in motion, with whose rim it turns: it counts at the drum with (drum radius / pulley radius)².
    #[schemars(range(min = 0))]
    pub(super) pulley_inertia_kg_m2: Option<f64>,
    /// Recorded length = length_scale · controlled length + length_offset_m.
    pub(super) length_scale: Option<f64>,
    /// See `length_scale` (m).
    pub(super) length_offset_m: Option<f64>,
    /// Recorded tension = tension_scale · tension + tension_offset_N.
    pub(super) tension_scale: Option<f64>,
    /// See `tension_scale` (N).
    pub(super) tension_offset_N: Option<f64>,
    /// Recorded swivel angle of the pulley = swivel angle + swivel_offset_rad: the encoder's zero (rad).
    pub(super) swivel_offset_rad: Option<f64>,
    /// Place at which recorded and given tensions act: `outlet` (the default) or `platform`. Matters with sag.
    pub(super) tension_at: Option<TensionPlace>,
    /// Mass per length of the unstrained cable (kg/m), for the effects `catenary` and `finite-element`.
    #[schemars(range(min = 0))]
    pub(super) linear_density_kg_per_m: Option<f64>,
    /// Elements of the effect `finite-element`: 1 to 1000, 10 when left out.
    #[schemars(range(min = 1, max = 1000))]
    pub(super) finite_elements: Option<usize>,
    /// Numbers of laws of stretch, by their keys.
    #[serde(default, rename = "gathered keys", skip_serializing)]
    #[schemars(skip)]
    pub(super) law_numbers: BTreeMap<String, f64>,
}

/// Body that cables shall not touch: a box along the world's axes (`position_min_m`, `position_max_m`) or a round strut of the frame (`from_m`, `to_m`, `radius_m`).
#[derive(Clone, Debug, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ObstacleSection {
    /// Name for people.
    pub(super) name: String,
    /// Box: lower corner (world, m).
    pub(super) position_min_m: Option<Vec<f64>>,
    /// Box: upper corner (world, m).
    pub(super) position_max_m: Option<Vec<f64>>,
    /// Strut: one end (world, m).
    pub(super) from_m: Option<Vec<f64>>,
    /// Strut: the other end (world, m).
    pub(super) to_m: Option<Vec<f64>>,
    /// Strut: half its diameter (m).
    #[schemars(range(min = 0))]
    pub(super) radius_m: Option<f64>,
}

/// Adds the numbers of laws of stretch to the schema of a cable.
fn add_law_numbers(schema: &mut Schema) {
    let Some(properties) = schema.get_mut("properties").and_then(|properties| properties.as_object_mut()) else {
        return;
    };
    for LawNumber { key, about, .. } in law_numbers() {
        let number = json_schema!({ "description": about, "type": ["number", "null"], "format": "double" });
        properties.insert((*key).to_owned(), number.to_value());
    }
}

/// The schema of `[cable_defaults]`: a cable's without its own keys.
fn cable_defaults_schema(generator: &mut SchemaGenerator) -> Schema {
    let mut schema = CableSection::json_schema(generator);
    schema.remove("required");
    schema.remove("description");
    if let Some(properties) = schema.get_mut("properties").and_then(|properties| properties.as_object_mut()) {
        OWN_KEYS.iter().for_each(|key| drop(properties.remove(*key)));
    }
    schema
}

/// Adds to the schema of the file that the cables of rotating platforms need platform anchors.
fn require_platform_anchors(schema: &mut Schema) {
    let turns = json_schema!({ "properties": { "motion_pattern": { "enum": ["1R2T", "3R3T"] } } });
    let needs = json_schema!({ "properties": { "cable": { "items": { "required": ["platform_anchor_m"] } } } });
    schema.insert("if".to_owned(), turns.to_value());
    schema.insert("then".to_owned(), needs.to_value());
}
