//! What one straight cable of linear law pulls and how long it is, with the derivatives by pose, tension and parameters.

use nalgebra::{Matrix3, Matrix6, Vector3};

use crate::cable::Course;
use crate::cable::elasticity::{ControlledLength, Elasticity};
use crate::geometry::Wrench;
use crate::model::{Model, Parameter, ParameterKind, specific_compliance};
use crate::robot::StiffnessBasis;

/// A straight cable at a pose with a tension.
pub(crate) struct StraightCable {
    /// Length and direction.
    pub(crate) course: Course<f64>,
    /// b = R b_P (world, m).
    pub(crate) lever: Vector3<f64>,
    /// Tension (N).
    pub(crate) tension: f64,
    /// f_recorded = tension_scale · f + …
    pub(crate) tension_scale: f64,
    /// q_recorded = length_scale · q_θ + …
    pub(crate) length_scale: f64,
    /// ∂q_θ/∂q, ∂q_θ/∂f, ∂q_θ/∂κ, ∂q_θ/∂q_h and q_θ itself.
    pub(crate) controlled: ControlledLength<f64>,
}

impl StraightCable {
    /// A cable of a model at a pose given by position and rotation rows.
    #[inline]
    pub(crate) fn at(model: &Model, cable: usize, position: [f64; 3], rotation: &[[f64; 3]; 3], tension: f64) -> Self {
        let data = &model.robot().cables[cable];
        let (course, lever) = model.course_at(cable, position, rotation);
        let controlled = model.elasticity(cable).controlled_length_gradient(
            course.length,
            tension,
            data.hidden_length.unwrap_or(0.0),
            specific_compliance(data),
            data.stiffness_by == Some(StiffnessBasis::Unstrained),
        );
        let (tension_scale, length_scale) = (data.tension_scale.unwrap_or(1.0), data.length_scale.unwrap_or(1.0));
        Self { course, lever, tension, tension_scale, length_scale, controlled }
    }

    /// The same course with another law in the place of the model's, of which compliance and hidden length are no parameters;
    /// its tension may be that of a spring that pushes.
    pub(crate) fn with_law(mut self, law: &Elasticity<f64>) -> Self {
        self.controlled = law.controlled_length_gradient(self.course.length, self.tension, 0.0, 0.0, false);
        (self.controlled.by_compliance, self.controlled.by_hidden_length) = (0.0, 0.0);
        self
    }

    /// Column of the structure matrix in the world, \[u; b × u\].
    #[inline]
    pub(crate) fn column(&self) -> Wrench {
        let u = Vector3::from(self.course.direction);
        stacked(u, self.lever.cross(&u))
    }

    /// ∂\[u; b × u\]/∂\[δr; δφ\], the lever's turn included.
    #[inline]
    pub(crate) fn column_by_pose(&self) -> Matrix6<f64> {
        let (_, by_pose) = self.course.by_pose(self.lever.into());
        let u = Vector3::from(self.course.direction);
        let mut matrix = Matrix6::zeros();
        for k in 0..6 {
            let direction = Vector3::new(by_pose[0][k], by_pose[1][k], by_pose[2][k]);
            let lever = if k < 3 { Vector3::zeros() } else { Vector3::ith(k - 3, 1.0).cross(&self.lever) };
            matrix.set_column(k, &stacked(direction, lever.cross(&u) + self.lever.cross(&direction)));
        }
        matrix
    }

    /// Change of the wrench (world) and of the length row by one of the cable's parameters.
    #[inline]
    pub(crate) fn by(&self, parameter: &Parameter, model: &Model, rotation: &Matrix3<f64>) -> (Wrench, f64) {
        let u = Vector3::from(self.course.direction);
        let gradient = Matrix3::from(self.course.direction_gradient).transpose();
        let by_length = self.length_scale * self.controlled.by_length;
        // a change of the direction and of the lever
        let wrench = |direction: Vector3<f64>, lever: Vector3<f64>| {
            stacked(direction, lever.cross(&u) + self.lever.cross(&direction)) * self.tension
        };
        let none = Wrench::zeros();
        match parameter.kind {
            ParameterKind::FrameAnchor => {
                let axis = model.axes()[parameter.axis];
                (wrench(-(gradient * axis), Vector3::zeros()), by_length * u.dot(&axis))
            }
            ParameterKind::PlatformAnchor => {
                let axis = rotation * model.axes()[parameter.axis];
                (wrench(gradient * axis, axis), -by_length * u.dot(&axis))
            }
            ParameterKind::PulleyRadius => {
                let direction = Vector3::from(self.course.direction_by_radius);
                (wrench(direction, Vector3::zeros()), by_length * self.course.length_by_radius)
            }
            ParameterKind::LengthOffset => (none, 1.0),
            // they change what is recorded, not what is expected
            ParameterKind::DrumRadius | ParameterKind::StartLength => (none, 0.0),
            ParameterKind::LengthScale => (none, self.controlled.value),
            ParameterKind::Compliance => (none, self.length_scale * self.controlled.by_compliance),
            ParameterKind::HiddenLength => (none, self.length_scale * self.controlled.by_hidden_length),
            ParameterKind::TensionScale => self.by_tension(-self.tension / self.tension_scale),
            ParameterKind::TensionOffset => self.by_tension(-1.0 / self.tension_scale),
            ParameterKind::Wrench => (none, 0.0),
        }
    }

    /// Change of wrench and recorded length with a change of the tension.
    #[inline]
    pub(crate) fn by_tension(&self, change: f64) -> (Wrench, f64) {
        (self.column() * change, self.length_scale * self.controlled.by_tension * change)
    }
}

fn stacked(force: Vector3<f64>, moment: Vector3<f64>) -> Wrench {
    Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
}
