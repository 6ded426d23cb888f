//! Equations of parameters alone: what is known of a robot, and what fixes a gauge without holding a parameter.

use nalgebra::Vector3;

use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Fact, Known};
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, ParameterKind};
use cdpr_model::statics::cable_state;

/// An equation, as residuals in standard deviations.
#[derive(Clone, Debug)]
pub(super) enum Equation {
    /// A known fact.
    Known(Known),
    /// Σ c (p − p₀) = 0 over coefficients c with their parameters and values p₀.
    Still {
        coefficients: Vec<(Parameter, f64, f64)>,
        /// 1/σ.
        weight: f64,
    },
}

/// A residual with its derivatives.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub(super) residual: f64,
    pub(super) derivatives: Vec<f64>,
}

impl Equation {
    /// True for one that fixes a gauge and says nothing of the robot; such equations stand behind the others.
    pub(super) fn is_convention(&self) -> bool {
        matches!(self, Self::Still { .. })
    }

    /// Number of its rows.
    pub(super) fn count(&self) -> usize {
        match self {
            Self::Still { .. } => 1,
            Self::Known(Known { fact, .. }) => match fact {
                Fact::Distance { .. } | Fact::Length { .. } => 1,
                Fact::Wall { cables, .. } | Fact::EqualDrums { cables } => cables.len() - 1,
                Fact::Plane { cables } => cables.len() - 3,
            },
        }
    }

    /// Rows at a model's values; `None` if a cable has no path.
    pub(super) fn rows(&self, model: &Model, parameters: &[Parameter]) -> Option<Vec<Row>> {
        let Self::Known(Known { fact, sigma }) = self else { return Some(vec![self.still(model, parameters)]) };
        let rows = match fact {
            Fact::Distance { cables: [first, second], metres } => {
                let [a, b] = [first, second].map(|cable| model.robot().cables[*cable].frame_anchor);
                let along = (a - b).normalize();
                let by_anchors = [(*first, along), (*second, -along)];
                vec![of_anchors((a - b).norm() - metres, &by_anchors, (model, parameters))]
            }
            Fact::Wall { axis, cables } => walled(*axis, cables, (model, parameters)),
            Fact::Plane { cables } => flat(cables, (model, parameters)),
            Fact::EqualDrums { cables } => equal_drums(cables, (model, parameters)),
            Fact::Length { cable, metres } => vec![of_length(*cable, *metres, (model, parameters))?],
        };
        Some(rows.into_iter().map(|row| row.scaled(1.0 / sigma)).collect())
    }

    fn still(&self, model: &Model, parameters: &[Parameter]) -> Row {
        let Self::Still { coefficients, weight } = self else {
            return Row { residual: 0.0, derivatives: vec![0.0; parameters.len()] };
        };
        let moved = |(parameter, coefficient, start): &(Parameter, f64, f64)| {
            coefficient * (parameter.value(model.robot()) - start)
        };
        let own = |parameter: &Parameter| {
            coefficients.iter().find(|(other, ..)| other == parameter).map_or(0.0, |(_, coefficient, _)| *coefficient)
        };
        let row =
            Row { residual: coefficients.iter().map(moved).sum(), derivatives: parameters.iter().map(own).collect() };
        row.scaled(*weight)
    }
}

impl Row {
    fn scaled(mut self, factor: f64) -> Self {
        self.residual *= factor;
        self.derivatives.iter_mut().for_each(|derivative| *derivative *= factor);
        self
    }
}

/// A residual that hangs on frame anchors, with its derivative by each of them (world).
fn of_anchors(residual: f64, by_anchors: &[(usize, Vector3<f64>)], (model, parameters): (&Model, &[Parameter])) -> Row {
    let own = |parameter: &Parameter| match parameter.kind {
        ParameterKind::FrameAnchor => {
            let of_cable = by_anchors.iter().filter(|(cable, _)| *cable == parameter.cable);
            of_cable.map(|(_, by_anchor)| by_anchor.dot(&model.axes()[parameter.axis])).sum()
        }
        _ => 0.0,
    };
    Row { residual, derivatives: parameters.iter().map(own).collect() }
}

/// Coordinates along an axis minus that of the first anchor.
fn walled(axis: usize, cables: &[usize], of: (&Model, &[Parameter])) -> Vec<Row> {
    let along = Vector3::ith(axis, 1.0);
    let height = |cable: usize| of.0.robot().cables[cable].frame_anchor[axis];
    let first = cables[0];
    let row = |&cable: &usize| of_anchors(height(cable) - height(first), &[(cable, along), (first, -along)], of);
    cables[1..].iter().map(row).collect()
}

/// Heights over the plane of the first three anchors.
fn flat(cables: &[usize], of: (&Model, &[Parameter])) -> Vec<Row> {
    let anchor = |k: usize| of.0.robot().cables[cables[k]].frame_anchor;
    let (u, v) = (anchor(1) - anchor(0), anchor(2) - anchor(0));
    let product = u.cross(&v);
    let (size, normal) = (product.norm(), product.normalize());
    let row = |k: usize| {
        let e = anchor(k) - anchor(0);
        let height = normal.dot(&e);
        // by the product u × v
        let by_product = (e - normal * height) / size;
        let (by_u, by_v) = (v.cross(&by_product), by_product.cross(&u));
        let by_anchors =
            [(cables[k], normal), (cables[1], by_u), (cables[2], by_v), (cables[0], -(normal + by_u + by_v))];
        of_anchors(height, &by_anchors, of)
    };
    (3..cables.len()).map(row).collect()
}

/// Radii of drums minus that of the first.
fn equal_drums(cables: &[usize], (model, parameters): (&Model, &[Parameter])) -> Vec<Row> {
    let radius = |cable: usize| model.robot().cables[cable].winch.radius.unwrap_or(0.0);
    let row = |&cable: &usize| {
        let own = |parameter: &Parameter| match parameter.kind {
            ParameterKind::DrumRadius if parameter.cable == cable => 1.0,
            ParameterKind::DrumRadius if parameter.cable == cables[0] => -1.0,
            _ => 0.0,
        };
        Row { residual: radius(cable) - radius(cables[0]), derivatives: parameters.iter().map(own).collect() }
    };
    cables[1..].iter().map(row).collect()
}

/// Length of a cable at the world's origin, where changes count from.
fn of_length(cable: usize, metres: f64, (model, parameters): (&Model, &[Parameter])) -> Option<Row> {
    let pose = Pose::identity();
    // the length of a taut, rigid cable hangs on no tension
    let state = cable_state(model, &pose, cable, 1.0).ok()?;
    let rotation = pose.rotation_matrix();
    let own = |parameter: &Parameter| match parameter.kind {
        ParameterKind::FrameAnchor
        | ParameterKind::PlatformAnchor
        | ParameterKind::PulleyRadius
        | ParameterKind::SwivelAxis
            if parameter.cable == cable =>
        {
            model.by_parameter(cable, &state, parameter, &rotation).1 / state.recording.length_scale
        }
        _ => 0.0,
    };
    let derivatives = parameters.iter().map(own).collect();
    Some(Row { residual: model.path(cable, &pose).ok()?.0.length - metres, derivatives })
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_model::model::{Composition, FreeParameters};
    use cdpr_model::robot::Robot;

    /// Derivatives of all rows are their differences.
    #[test]
    fn derivatives_are_differences() {
        let mut robot = Robot::builtin("cogiro").expect("built in");
        for (k, cable) in robot.cables.iter_mut().enumerate() {
            cable.frame_anchor += Vector3::new(0.1, -0.2, 0.3) * (k as f64 * 1.3).sin();
        }
        let model = Model::new(robot, Composition::STANDARD).unwrap();
        let free: FreeParameters = "frame-anchor,platform-anchor".parse().unwrap();
        let parameters = free.parameters(&model, &FreeParameters::default()).unwrap();
        let still =
            Equation::Still { coefficients: vec![(parameters[1], 0.6, 0.1), (parameters[5], -0.8, 0.2)], weight: 3.0 };
        let known = ["distance[1,3]=2", "length[2]=3", "wall-y[1,2,4]", "level[3,5]", "plane[1,2,4,5,7]"];
        let equations = known.map(|text| Equation::Known(text.parse().unwrap())).into_iter().chain([still]);
        for equation in equations {
            let rows = equation.rows(&model, &parameters).unwrap();
            assert_eq!(rows.len(), equation.count());
            for (k, parameter) in parameters.iter().enumerate() {
                let h = 1e-6; // central difference: truncation ~ h² of metres, rounding ~ ε/h, in millimetres
                let at = |change: f64| {
                    let value = parameter.value(model.robot()) + change;
                    equation.rows(&model.with_parameters(&[*parameter], &[value]).unwrap(), &parameters).unwrap()
                };
                for ((row, ahead), behind) in rows.iter().zip(at(h)).zip(at(-h)) {
                    let slope = (ahead.residual - behind.residual) / (2.0 * h);
                    assert!(
                        (slope - row.derivatives[k]).abs() < 1e-5,
                        "{equation:?} {k}: {slope} {}",
                        row.derivatives[k]
                    );
                }
            }
        }
    }
}
