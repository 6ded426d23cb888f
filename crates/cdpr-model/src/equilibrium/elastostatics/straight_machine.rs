//! A model with straight cables whose equilibrium is near that of others: the search for these starts there.

use crate::cable::stretch::Stretch;
use crate::model::{Composition, Model, SpanEffect, StretchEffect};
use crate::robot::CableStiffness;

/// First compliance in the search for cables that do not stretch (1/N).
pub(super) const FIRST_COMPLIANCE: f64 = 1e-7;

/// The model with straight cables that stretch linearly, as compliant as the model's own at half their largest tension;
/// `None` if the robot has no such model.
pub(super) fn straight_model(model: &Model) -> Option<Model> {
    let mut robot = model.robot().clone();
    for (cable, data) in robot.cables.iter_mut().enumerate() {
        let law = model.law(cable);
        let tension = 0.5 * data.tension_max.unwrap_or(1e3);
        let compliance = match &law.stretch {
            Stretch::Rigid if law.series_compliance == 0.0 => FIRST_COMPLIANCE,
            stretch => stretch.secant_compliance(tension).0,
        };
        data.stiffness = Some(CableStiffness::Compliance(compliance));
        data.series_compliance = Some(law.series_compliance);
    }
    let composition =
        Composition { stretch: StretchEffect::Linear, span: SpanEffect::Straight, drum: false, ..model.composition() };
    Model::new(robot, composition).ok()
}
