//! Scales of parameters: metres of cable for one unit of them.

use std::f64::consts::TAU;

use cdpr_model::model::Model;
use cdpr_model::robot::{Cable, Parameter, ParameterKind};
use cdpr_model::statics::Load;

/// Smallest size that counts (m).
const LEAST: f64 = 1e-3;

/// Sizes of one cable by which its parameters change lengths.
#[derive(Clone, Copy, Debug)]
pub(super) struct UnitScale {
    /// Mean recorded length (m).
    length: f64,
    /// Radius of the drum, no smaller than counts (m).
    drum_radius: f64,
    /// Way of the drum's contact point while the mean length is paid out (m).
    drum_travel: f64,
    /// r_p (m).
    pulley_radius: f64,
}

impl UnitScale {
    pub(super) fn of(cable: &Cable, mean_length: f64) -> Self {
        let drum_radius = cable.winch.radius.unwrap_or(0.0).max(LEAST);
        Self {
            length: mean_length,
            drum_radius,
            drum_travel: cable.winch.pitch().unwrap_or(0.0) * mean_length / (TAU * drum_radius),
            pulley_radius: cable.pulley_radius().unwrap_or(0.0),
        }
    }

    /// Metres of cable for one unit of a parameter of its geometry.
    pub(super) fn metres(&self, kind: ParameterKind) -> f64 {
        match kind {
            ParameterKind::LengthScale => self.length,
            // the radius turns with the whole length
            ParameterKind::DrumRadius => self.length / self.drum_radius,
            // of the squares of the turns
            ParameterKind::SpoolBuildUp => (0.5 * self.length / self.drum_radius).powi(2),
            ParameterKind::StartAngle => self.drum_radius,
            ParameterKind::DrumAxis => self.drum_travel.max(LEAST),
            ParameterKind::SwivelAxis => self.pulley_radius.max(LEAST),
            _ => 1.0,
        }
    }
}

/// Metres that one unit of each parameter is worth, where parameters are identified together from lengths (m) and recorded tensions (N, or none).
pub(super) fn joint_scales(model: &Model, parameters: &[Parameter], lengths: &[f64], tensions: &[f64]) -> Vec<f64> {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
    let (length, tension) = (mean(lengths), mean(tensions).max(1e-9));
    let compliance = parameters.iter().filter(|p| p.kind == ParameterKind::Compliance).map(|p| p.value(model.robot()));
    let compliance = compliance.fold(1e-7, f64::max);
    let gravity = model.robot().gravity.map_or(0.0, |gravity| gravity.norm()).max(LEAST);
    let weight = Load::of(model.robot()).map_or(0.0, |load| load.force()).max(LEAST);
    let metres = |parameter: &Parameter| match parameter.kind {
        ParameterKind::Compliance => tension * length,
        ParameterKind::HiddenLength => 1e-3,
        // a share of a number of the law changes the strain by that share
        ParameterKind::Stretch(_) => {
            let (strain, _) = model.law(parameter.cable).stretch.strain(tension);
            strain * length / parameter.value(model.robot())
        }
        ParameterKind::TensionScale => compliance * tension * length,
        ParameterKind::TensionOffset | ParameterKind::Wrench => compliance * length,
        ParameterKind::Mass => compliance * length * gravity,
        ParameterKind::CenterOfMass => compliance * length * weight,
        // a shallow parabola under ρ g is longer than its chord by L³ (ρ g)² / (24 T²)
        ParameterKind::LinearDensity => {
            let density = parameter.value(model.robot()).max(LEAST);
            density * length * (length * gravity / tension).powi(2) / 12.0
        }
        kind => UnitScale::of(&model.robot().cables[parameter.cable], length).metres(kind),
    };
    parameters.iter().map(metres).collect()
}
