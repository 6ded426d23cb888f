//! Numbers that a calibration without poses holds, with their accuracies: what they are off by moves the poses, and no residual may tell it.

use super::question::Question;
use crate::fit::{Settings, prior_sigma};
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, ParameterKind};

/// Accuracy of a common scale of lengths where none is stated.
const SCALE: f64 = 0.005;
/// Accuracy of a coordinate of a held anchor where none is stated (m).
const ANCHOR: f64 = 0.005;
/// Accuracy of the radius of a held pulley where none is stated (m).
const RADIUS: f64 = 0.001;

/// Held numbers of one kind.
#[derive(Clone, Debug)]
pub(super) struct Held {
    pub(super) kind: ParameterKind,
    /// Changes of the robot's parameters by each of the numbers.
    pub(super) numbers: Vec<Vec<(Parameter, f64)>>,
    /// Standard deviation of each.
    pub(super) sigma: f64,
    /// True where somebody stated it.
    pub(super) is_stated: bool,
}

impl Held {
    /// The numbers and their accuracy in words.
    pub(super) fn words(&self) -> String {
        let origin = if self.is_stated { "stated" } else { "assumed" };
        match self.kind {
            ParameterKind::LengthScale => {
                format!(
                    "a common scale of the recorded lengths (gear, spool, tape; {origin}: {} %)",
                    100.0 * self.sigma
                )
            }
            kind => format!(
                "the {kind} values that are held ({origin}: {} mm{})",
                1e3 * self.sigma,
                if kind.is_anchor() { " a coordinate" } else { "" }
            ),
        }
    }

    /// How to state another accuracy.
    pub(super) fn remedy(&self) -> String {
        match self.kind {
            ParameterKind::LengthScale => "[sigmas] length_scale of the data's .meta.toml".to_owned(),
            kind => format!("--prior {kind}=…"),
        }
    }

    /// Kinds of held numbers of a question that move poses; the scale of lengths comes first.
    ///
    /// Anchors of platforms that do not turn change what frame anchors do, and drums what the scale does. Parameters that fix the gauge are among them: rigid motions, which
    /// they fix by convention, displace nothing that counts, and a size that they fix is no better than they are.
    pub(super) fn of(question: &Question<'_>, model: &Model, kept: &[Parameter]) -> Vec<Self> {
        let robot = model.robot();
        let has_rotation = robot.motion_pattern.has_rotation();
        let mut kinds = vec![ParameterKind::FrameAnchor];
        kinds.extend(has_rotation.then_some(ParameterKind::PlatformAnchor));
        kinds.extend(model.composition().pulley.then_some(ParameterKind::PulleyRadius));
        let numbers = |kind: ParameterKind| -> Vec<Parameter> {
            let of_cable = |cable: usize| (0..kind.components(robot)).map(move |axis| Parameter { cable, kind, axis });
            let is_held = |parameter: &Parameter| !kept.contains(parameter);
            (0..model.cable_count()).flat_map(of_cable).filter(is_held).collect()
        };
        let of_kind = |kind: ParameterKind| {
            let (sigma, is_stated) = accuracy(kind, question.settings, &question.internal.samples.sigmas);
            let numbers = numbers(kind).into_iter().map(|parameter| vec![(parameter, 1.0)]).collect();
            Self { kind, numbers, sigma, is_stated }
        };
        let scales = numbers(ParameterKind::LengthScale);
        let scale = scales.into_iter().map(|parameter| (parameter, parameter.value(robot))).collect();
        let scale = Self { numbers: vec![scale], ..of_kind(ParameterKind::LengthScale) };
        let is_there = |held: &Self| held.sigma > 0.0 && held.numbers.iter().any(|number| !number.is_empty());
        std::iter::once(scale).chain(kinds.into_iter().map(of_kind)).filter(is_there).collect()
    }
}

/// Accuracy of numbers of a kind, and whether it is stated.
fn accuracy(kind: ParameterKind, settings: &Settings, sigmas: &SensorSigmas) -> (f64, bool) {
    let (stated, assumed) = match kind {
        ParameterKind::LengthScale => (sigmas.length_scale, SCALE),
        ParameterKind::PulleyRadius => (prior_sigma(settings, kind), RADIUS),
        kind => (prior_sigma(settings, kind), ANCHOR),
    };
    (stated.unwrap_or(assumed), stated.is_some())
}
