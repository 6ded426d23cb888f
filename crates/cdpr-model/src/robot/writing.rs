//! From a [`Robot`] to a robot file: the keys in the order of the layout, one per line.

use std::collections::BTreeMap;

use nalgebra::{UnitQuaternion, Vector3};
use serde::Serialize;

use super::file::{CableSection, HomeSection, Inertia, Moment, PlatformSection, WorkspaceSection, WrenchSection};
use super::home_reading::{planar_angle, planar_rotation};
use super::reading::LAYOUT_VERSION;
use super::stretch::registry::law_numbers;
use super::{Cable, ExternalWrench, Platform, Robot};
use crate::geometry::{MotionPattern, Plane, Pose};

/// First line of every written file.
const HEADING: &str = "# Cable robot description, layout version 1. Units are in the key names.\n";

/// The keys above the first table, without the notes.
#[derive(Serialize)]
struct TopKeys<'a> {
    layout_version: u32,
    name: &'a str,
    title: Option<&'a str>,
    motion_pattern: MotionPattern,
    kind: Option<&'a str>,
    cable_count: usize,
    axes: Option<String>,
    gravity_m_s2: Option<Vec<f64>>,
}

impl Robot {
    /// The robot as a file that [`Robot::from_toml`] reads back to the same robot.
    ///
    /// The vectors of a planar robot are written by their components in the plane, a point platform without
    /// orientation. Every cable states its own keys, including those from `[cable_defaults]`: after a calibration they
    /// may differ.
    pub fn to_toml(&self) -> String {
        let mut text = HEADING.to_owned() + &lines(&self.top_keys());
        if !self.notes.is_empty() {
            let quoted = self.notes.iter().map(|note| format!("  {},\n", toml::Value::String(note.clone())));
            text.push_str(&format!("notes = [\n{}]\n", quoted.collect::<String>()));
        }
        let mut section = |header: &str, body: String| text.push_str(&format!("\n{header}\n{body}"));
        if let Some(source) = &self.source {
            section("[source]", lines(source));
            source.published.iter().for_each(|errors| section("[[source.published]]", lines(errors)));
        }
        if let Some(calibration) = &self.calibration {
            section("[calibration]", lines(calibration));
        }
        self.assumptions.iter().for_each(|assumption| section("[[assumption]]", lines(assumption)));
        section("[platform]", lines(&self.platform_section(&self.platform)));
        if let Some(home) = &self.home {
            section("[home_pose]", lines(&self.home_section(home)));
        }
        if let Some(wrench) = &self.external_wrench {
            section("[external_wrench]", lines(&self.wrench_section(wrench)));
        }
        if let Some(travel) = &self.travel {
            let (min, max) = (self.components(&travel.min), self.components(&travel.max));
            let body = WorkspaceSection { position_min_m: min, position_max_m: max, note: travel.note.clone() };
            section("[workspace]", lines(&body));
        }
        self.obstacles.iter().for_each(|obstacle| section("[[obstacle]]", lines(&self.obstacle_section(obstacle))));
        for cable in &self.cables {
            section("[[cable]]", lines(&self.cable_section(cable)) + &law_lines(cable));
            if let Some(table) = &cable.hysteresis {
                section("[cable.hysteresis]", lines(table));
            }
        }
        self.reference_checks.iter().for_each(|check| section("[[reference_check]]", lines(check)));
        text
    }

    fn top_keys(&self) -> TopKeys<'_> {
        TopKeys {
            layout_version: LAYOUT_VERSION,
            name: &self.name,
            title: self.title.as_deref(),
            motion_pattern: self.motion_pattern,
            kind: self.kind.as_deref(),
            cable_count: self.cables.len(),
            axes: self.motion_pattern.is_planar().then(|| self.plane.axes()),
            gravity_m_s2: self.gravity.as_ref().map(|gravity| self.components(gravity)),
        }
    }

    /// Components of a vector as the file states it.
    pub(super) fn components(&self, vector: &Vector3<f64>) -> Vec<f64> {
        match self.motion_pattern.is_planar() {
            true => self.plane.components(vector).to_vec(),
            false => vector.as_slice().to_vec(),
        }
    }

    /// Components of a vector that may leave the plane of a planar robot.
    fn spatial_components(&self, vector: &Vector3<f64>) -> Vec<f64> {
        match self.motion_pattern.is_planar() && self.plane.normal().dot(vector) == 0.0 {
            true => self.components(vector),
            false => vector.as_slice().to_vec(),
        }
    }

    fn platform_section(&self, platform: &Platform) -> PlatformSection {
        let normal = self.plane.normal();
        let inertia = platform.inertia.map(|inertia| match self.motion_pattern.is_planar() {
            true => Inertia::Planar(normal.dot(&(inertia * normal))),
            false => Inertia::Spatial(inertia.row_iter().map(|row| row.iter().copied().collect()).collect()),
        });
        PlatformSection {
            mass_kg: platform.mass,
            center_of_mass_m: platform.center_of_mass.as_ref().map(|center| self.components(center)),
            inertia_about_center_of_mass_kg_m2: inertia,
            damping_N_s_per_m: platform.damping,
            rotational_damping_Nm_s_per_rad: platform.rotational_damping,
            hull_m: platform.hull.as_ref().map(|hull| hull.iter().map(|point| self.components(point)).collect()),
        }
    }

    fn home_section(&self, home: &Pose) -> HomeSection {
        let rows = || home.rotation_rows().iter().map(|row| row.to_vec()).collect();
        let angle = || exact_angle(self.plane, &home.rotation);
        HomeSection {
            position_m: self.components(&home.position),
            rotation: (self.motion_pattern == MotionPattern::Spatial).then(rows),
            angle_rad: (self.motion_pattern == MotionPattern::Planar).then(angle),
        }
    }

    fn wrench_section(&self, external: &ExternalWrench) -> WrenchSection {
        let moment: Vector3<f64> = external.wrench.fixed_rows::<3>(3).into_owned();
        WrenchSection {
            force_N: self.components(&external.wrench.fixed_rows::<3>(0).into_owned()),
            moment_Nm: match self.motion_pattern {
                MotionPattern::Planar => Some(Moment::Planar(self.plane.normal().dot(&moment))),
                MotionPattern::Spatial => Some(Moment::Spatial(moment.as_slice().to_vec())),
                MotionPattern::PlanarPoint | MotionPattern::SpatialPoint => None,
            },
            includes_gravity: external.includes_gravity,
            note: external.note.clone(),
        }
    }

    fn cable_section(&self, cable: &Cable) -> CableSection {
        CableSection {
            name: cable.name.clone(),
            frame_anchor_m: self.components(&cable.frame_anchor),
            platform_anchor_m: Some(self.components(&cable.platform_anchor)),
            pulley_radius_m: cable.pulley_radius(),
            pulley_wrap_min_rad: cable.pulley_wrap_min,
            pulley_wrap_max_rad: cable.pulley_wrap_max,
            diameter_m: cable.diameter,
            length_min_m: cable.length_min,
            length_max_m: cable.length_max,
            speed_max_m_s: cable.speed_max,
            tension_min_N: cable.tension_min,
            tension_max_N: cable.tension_max,
            axial_stiffness_EA_N: cable.axial_stiffness(),
            axial_compliance_per_N: cable.axial_compliance(),
            spring_constant_N_per_m: cable.spring_constant(),
            pulley_swivel_axis: cable.pulley_swivel_axis().map(|axis| self.components(&axis)),
            pulley_wrap_side: cable.pulley_wrap_side,
            stiffness_by: cable.stiffness_by,
            hidden_length_m: cable.hidden_length,
            series_compliance_m_per_N: cable.series_compliance,
            tension_of_strain_N: cable.tension_of_strain.clone(),
            // a table of its own, written after the keys of the cable
            hysteresis: None,
            drum_radius_m: cable.winch.radius,
            drum_pitch_m: cable.winch.pitch(),
            drum_axis: cable.winch.axis.as_ref().map(|axis| self.spatial_components(axis)),
            drum_position_m: cable.winch.position.as_ref().map(|point| self.spatial_components(point)),
            drum_side: cable.winch.side,
            drum_guided: cable.winch.guided,
            drum_pulley_m: cable.winch.first_pulley.as_ref().map(|point| self.spatial_components(point)),
            drum_start_angle_rad: cable.winch.start_angle,
            drum_start_length_m: cable.winch.start_length,
            drum_groove_length_m: cable.winch.groove_length(),
            drum_layer_height_m: cable.winch.layer_height(),
            gear_ratio: cable.winch.gear_ratio,
            spool_build_up_m: cable.winch.build_up,
            mechanical_advantage: cable.winch.mechanical_advantage,
            encoder_counts_per_turn: cable.winch.encoder_counts_per_turn,
            motor_speed_max_rad_per_s: cable.winch.motor_speed_max,
            cable_damping_N_s_per_m: cable.damping,
            cable_damping_time_s: cable.damping_time,
            drum_inertia_kg_m2: cable.winch.drum_inertia,
            rotor_inertia_kg_m2: cable.winch.rotor_inertia,
            drum_coulomb_friction_Nm: cable.winch.coulomb_friction,
            drum_static_friction_Nm: cable.winch.static_friction,
            drum_stribeck_speed_rad_per_s: cable.winch.stribeck_speed,
            drum_viscous_friction_Nm_s_per_rad: cable.winch.viscous_friction,
            pulley_friction: cable.pulley_friction,
            pulley_inertia_kg_m2: cable.pulley_inertia,
            length_scale: cable.length_scale,
            length_offset_m: cable.length_offset,
            tension_scale: cable.tension_scale,
            tension_offset_N: cable.tension_offset,
            swivel_offset_rad: cable.swivel_offset,
            tension_at: cable.tension_at,
            linear_density_kg_per_m: cable.linear_density,
            finite_elements: cable.finite_elements,
            // written as lines of their own, by the keys of their laws
            law_numbers: BTreeMap::new(),
        }
    }
}

/// Numbers of laws of stretch that a cable states, one per line.
fn law_lines(cable: &Cable) -> String {
    let stated = law_numbers().filter_map(|number| Some((number.key, cable.law_numbers.get(number.key)?)));
    stated.map(|entry| lines(&BTreeMap::from([entry]))).collect()
}

/// The keys of a section without tables, one per line.
fn lines(section: &impl Serialize) -> String {
    toml::to_string(section).expect("text, numbers and lists of them are TOML")
}

/// The angle of a planar rotation (rad) that is read back to the same bits, if there is one near the computed angle.
fn exact_angle(plane: Plane, rotation: &UnitQuaternion<f64>) -> f64 {
    let computed = planar_angle(plane, rotation);
    let neighbours =
        |next: fn(f64) -> f64| std::iter::successors(Some(computed), move |angle| Some(next(*angle))).take(16);
    let is_exact = |angle: &f64| planar_rotation(plane, *angle).coords == rotation.coords;
    neighbours(f64::next_up).chain(neighbours(f64::next_down)).find(is_exact).unwrap_or(computed)
}
