//! The immutable part of the machine: model, platform, damping and winches.

use nalgebra::Vector3;

use super::error::PlantError;
use super::friction::Friction;
use super::momentum::Inertia;
use cdpr_model::cable::law::Kind;
use cdpr_model::model::{Cables, Model};
use cdpr_model::robot::{Assumption, Body, Cable};
use cdpr_model::statics::Load;

/// A machine in time. Immutable: its changing quantities are in a [`PlantState`](super::PlantState).
#[derive(Clone, Debug)]
pub struct Plant {
    pub(super) model: Model,
    pub(super) load: Load,
    /// Gravity (world, m/s²); zero if the file states none.
    pub(super) gravity: Vector3<f64>,
    pub(super) inertia: Inertia,
    pub(super) damping: Vec<Damping>,
    /// Drums, one per cable; empty for ideal winches.
    pub(super) drums: Vec<Drum>,
    /// True if cables have weight.
    pub(super) sags: bool,
    /// True if all laws are straight and linear.
    pub(super) is_linear: bool,
    /// True if forces depend on speeds.
    pub(super) dissipates: bool,
    /// True if the pulley of a drum has friction, so that wrap angles are needed.
    pub(super) asks_wraps: bool,
    /// True if directions of single cables are needed, not only the sum of their wrenches.
    pub(super) asks_columns: bool,
}

/// Damping of a cable along its elongation rate: d = constant + time · ∂f/∂q (Kelvin and Voigt).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Damping {
    /// Part that is independent of the cable's length (N·s/m).
    pub constant: f64,
    /// η (s): for a cable that obeys Hooke's law, d = η EA/q.
    pub time: f64,
}

impl Damping {
    /// Damping coefficient d of a cable with the stiffness ∂f/∂q (N/m → N·s/m).
    #[inline]
    pub(super) fn coefficient(&self, stiffness: f64) -> f64 {
        self.constant + self.time * stiffness
    }

    /// Damping of a cable in the robot file; zero if the file states none.
    pub(super) fn of(cable: &Cable) -> Self {
        let constant = cable.damping.unwrap_or(0.0);
        Self { constant, time: cable.damping_time.unwrap_or(0.0) }
    }
}

/// Holders of the cables at the frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Winches {
    /// Lengths follow the commands exactly.
    #[default]
    Ideal,
    /// Drums with inertia and friction, which torques command.
    Drums,
}

impl Winches {
    /// Word in scenario files.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Ideal => "ideal",
            Self::Drums => "drums",
        }
    }
}

/// A drum with the parts that turn with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Drum {
    /// Inertia at the drum (kg·m²), including rotor and pulley with the squares of their ratios.
    pub(super) inertia: f64,
    /// Friction at the start; the current one is in the state.
    pub(super) friction: Friction,
    /// Torque at the drum per torque of the motor.
    pub(super) gear: f64,
}

impl Plant {
    /// The machine of a model, with the damping of its robot file.
    pub fn new(model: Model, winches: Winches) -> Result<Self, PlantError> {
        let damping = model.robot().cables.iter().map(Damping::of).collect();
        Self::with_damping(model, winches, damping)
    }

    /// [`Plant::new`] with given damping, one entry per cable.
    pub(crate) fn with_damping(model: Model, winches: Winches, damping: Vec<Damping>) -> Result<Self, PlantError> {
        let stretches = |cable: &usize| match model.law(*cable).kind {
            Kind::Rigid => false,
            Kind::Linear(law, _) => !law.is_rigid(),
            Kind::Stretching => !model.law(*cable).stretch.is_rigid(),
            Kind::Sagging(_) => true,
        };
        if let Some(cable) = (0..model.cable_count()).find(|cable| !stretches(cable)) {
            return Err(PlantError::RigidCable { cable: cable + 1, composition: model.composition().to_string() });
        }
        let body = Body::of(model.robot())?;
        let load = Load::of(model.robot())?;
        let drums = match winches {
            Winches::Ideal => Vec::new(),
            Winches::Drums => drums_of(&model)?,
        };
        let has_friction = drums.iter().any(|drum| drum.friction.viscous > 0.0 || drum.friction.is_dry());
        let inertia = Inertia::new(&model, body);
        let has_damping = inertia.is_damped() || damping.iter().any(|damping| *damping != Damping::default());
        Ok(Self {
            inertia,
            gravity: model.robot().gravity.unwrap_or_else(Vector3::zeros),
            sags: model.cables() == Cables::Sagging,
            is_linear: model.cables() == Cables::Linear,
            dissipates: has_friction || has_damping,
            asks_wraps: drums.iter().any(|drum| drum.friction.pulley > 0.0),
            // other laws than linear ones are evaluated cable by cable
            asks_columns: has_damping || !drums.is_empty() || model.cables() != Cables::Linear,
            load,
            damping,
            drums,
            model,
        })
    }

    /// The model of the machine.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The load in the robot file.
    pub fn load(&self) -> &Load {
        &self.load
    }

    /// Assumed numbers of the robot file that the motion depends on, without those of drums, pulleys, weight or damping
    /// that the machine does not have.
    pub fn assumptions(&self) -> impl Iterator<Item = &Assumption> {
        self.model.robot().assumptions.iter().filter(|assumption| self.reads(assumption.plain_key()))
    }

    /// True for keys of the robot file on which the motion may depend.
    fn reads(&self, key: &str) -> bool {
        let composition = self.model.composition();
        let own_damping =
            || self.damping.iter().zip(&self.model.robot().cables).any(|(d, cable)| *d == Damping::of(cable));
        let begins = |words: &[&str]| words.iter().any(|word| key.starts_with(word));
        match key {
            _ if begins(&["drum_", "rotor_", "gear_ratio"]) => !self.drums.is_empty() || composition.drum,
            "pulley_friction" | "pulley_inertia_kg_m2" => !self.drums.is_empty() && composition.pulley,
            _ if begins(&["pulley_"]) => composition.pulley,
            _ if begins(&["cable_damping_"]) => own_damping(),
            _ if begins(&["linear_density_", "finite_elements"]) => self.sags,
            // limits, starting positions, and calibrations of sensors
            _ => !begins(&["position_", "angle_", "rotation", "diameter_", "length_", "encoder_"]),
        }
    }

    /// Kind of the winches.
    pub fn winches(&self) -> Winches {
        if self.drums.is_empty() { Winches::Ideal } else { Winches::Drums }
    }
}

/// Assumed numbers of a robot file that the motion under given tensions depends on: those of platform, load, anchors
/// and limits, and of pulleys and the cables' weight if the model has them; not those of stretch, damping and drums.
pub fn assumptions_under_tensions(model: &Model) -> impl Iterator<Item = &Assumption> {
    let reads = |assumption: &&Assumption| {
        let (table, key) = assumption.key.split_once('.').unwrap_or((assumption.key.as_str(), ""));
        match table {
            "platform" | "external_wrench" | "gravity_m_s2" => true,
            _ if !table.starts_with("cable") => false,
            _ if key.starts_with("pulley_") => {
                model.composition().pulley && !["pulley_friction", "pulley_inertia_kg_m2"].contains(&key)
            }
            _ if key.starts_with("linear_density_") => model.cables() == Cables::Sagging,
            _ => key.ends_with("anchor_m") || key.starts_with("tension_m"),
        }
    };
    model.robot().assumptions.iter().filter(reads)
}

/// Drums of a robot: radius and inertia are needed, friction is zero if the file has none.
fn drums_of(model: &Model) -> Result<Vec<Drum>, PlantError> {
    let drum = |(index, cable): (usize, &Cable)| {
        let missing = |key| PlantError::NoDrum { key, cable: index + 1, name: cable.name.clone() };
        model.winch(index).ok_or_else(|| missing("drum_radius_m"))?;
        let gear = cable.winch.gear_ratio.unwrap_or(1.0).abs();
        let inertia = cable.winch.drum_inertia.unwrap_or(0.0) + gear * gear * cable.winch.rotor_inertia.unwrap_or(0.0);
        if !(inertia > 0.0) {
            return Err(missing("drum_inertia_kg_m2"));
        }
        let has_pulley = model.composition().pulley;
        let pulley = if has_pulley { pulley_inertia(cable) } else { None };
        Ok(Drum { inertia: inertia + pulley.unwrap_or(0.0), friction: Friction::of(cable, has_pulley), gear })
    };
    model.robot().cables.iter().enumerate().map(drum).collect()
}

/// Inertia of a pulley (kg·m²), reduced to the drum by the ratio of their radii.
fn pulley_inertia(cable: &Cable) -> Option<f64> {
    let ratio = cable.winch.radius? / cable.pulley_radius()?;
    Some(cable.pulley_inertia? * ratio * ratio)
}
