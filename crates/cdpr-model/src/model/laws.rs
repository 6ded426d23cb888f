//! The laws of a robot's cables under a composition of effects.

use nalgebra::Vector3;

use super::error::{Need, require};
use super::{Cables, Composition, ModelError, SpanEffect, StretchEffect};
use crate::cable::Recording;
use crate::cable::elasticity::Elasticity;
use crate::cable::law::{CableLaw, Kind};
use crate::cable::outlet::Outlet;
use crate::cable::span::Shape;
use crate::cable::stretch::Stretch;
use crate::robot::{Cable, Pulley, Robot, StiffnessBasis};

/// Number of elements of a cable if its file does not state it.
pub(crate) const FINITE_ELEMENTS: usize = 10;

/// The law of every cable; `elasticity` has the linear laws of the composition.
pub(super) fn laws(
    robot: &Robot,
    composition: Composition,
    elasticity: &[Elasticity<f64>],
) -> Result<Vec<CableLaw>, ModelError> {
    let gravity = match (composition.cables() == Cables::Sagging, robot.gravity) {
        (true, None) => return Err(ModelError::NoGravity { robot: robot.name.clone() }),
        (_, gravity) => gravity.unwrap_or_else(Vector3::zeros),
    };
    let law = |(index, (cable, linear)): (usize, (&Cable, &Elasticity<f64>))| {
        if composition.cables() == Cables::Sagging {
            let effect = composition.effects().last().unwrap_or("catenary");
            require(
                cable.linear_density.is_some(),
                Need { effect, key: "linear_density_kg_per_m", hint: "" },
                index,
                cable,
            )?;
        }
        let stretch = stretch(composition, index, cable)?;
        Ok(CableLaw {
            outlet: outlet(robot, composition, cable),
            series_compliance: match composition.is_elastic() {
                true => cable.series_compliance.unwrap_or(0.0) + cable.spring_constant().map_or(0.0, |k| 1.0 / k),
                false => 0.0,
            },
            stretch,
            hidden_length: cable.hidden_length.unwrap_or(0.0),
            weight: (gravity * cable.linear_density.unwrap_or(0.0)).into(),
            recording: recording(cable),
            kind: match (composition.span, composition.stretch) {
                (SpanEffect::Catenary, _) => Kind::Sagging(Shape::Catenary),
                (SpanEffect::FiniteElement, _) => {
                    Kind::Sagging(Shape::FiniteElements(cable.finite_elements.unwrap_or(FINITE_ELEMENTS)))
                }
                (SpanEffect::Straight, StretchEffect::Rigid) => Kind::Rigid,
                (SpanEffect::Straight, StretchEffect::Linear) => Kind::Linear(*linear, stiffness_basis(cable)),
                (SpanEffect::Straight, _) => Kind::Stretching,
            },
        })
    };
    robot.cables.iter().zip(elasticity).enumerate().map(law).collect()
}

/// Reference length of a cable's stiffness; `None` for a constant spring.
fn stiffness_basis(cable: &Cable) -> Option<StiffnessBasis> {
    cable.spring_constant().is_none().then(|| cable.stiffness_by.unwrap_or(StiffnessBasis::Actual))
}

/// Calibration of a cable's recorded length and tension.
fn recording(cable: &Cable) -> Recording {
    Recording {
        length_scale: cable.length_scale.unwrap_or(1.0),
        length_offset: cable.length_offset.unwrap_or(0.0),
        tension_scale: cable.tension_scale.unwrap_or(1.0),
        tension_offset: cable.tension_offset.unwrap_or(0.0),
    }
}

/// Outlet of a cable: a point, or a pulley if the composition has pulleys.
fn outlet(robot: &Robot, composition: Composition, cable: &Cable) -> Outlet<f64> {
    let frame_anchor = cable.frame_anchor.into();
    match (composition.pulley, cable.pulley) {
        (true, Some(Pulley::Whole { radius, swivel_axis: axis })) => match robot.pulley_side(cable) {
            None => Outlet::Swivel { frame_anchor, swivel_axis: (*axis).into(), radius },
            Some(side) => Outlet::Sided { frame_anchor, swivel_axis: (*axis).into(), side: side.into(), radius },
        },
        _ => Outlet::Point { frame_anchor },
    }
}

/// Law of stretch of a cable, by its unstrained length.
fn stretch(composition: Composition, index: usize, cable: &Cable) -> Result<Stretch, ModelError> {
    let Some(law) = composition.stretch.law() else { return Ok(Stretch::Rigid) };
    let refused = |reason| ModelError::Stretch { cable: index + 1, name: cable.name.clone(), reason };
    let stretch = law.of(cable).map_err(refused)?;
    require(stretch.is_some(), Need { effect: law.word, key: law.keys[0], hint: law.hint }, index, cable)?;
    Ok(stretch.unwrap_or(Stretch::Rigid))
}
