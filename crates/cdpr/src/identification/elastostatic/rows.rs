//! Residuals of one sample and their derivatives by parameters and by what is measured.

use nalgebra::{Matrix3, Vector3};

use super::general_rows::GeneralCable;
use super::noise::{Noise, Sigmas};
use crate::cable::Course;
use crate::cable::elasticity::Elasticity;
use crate::cable::winch::DrumLength;
use crate::geometry::{Pose, Wrench};
use crate::measurement::Samples;
use crate::model::{Model, Parameter, ParameterKind, specific_compliance};
use crate::robot::StiffnessBasis;
use crate::scalar::LANES;
use crate::statics::Load;

/// Where the rows of one sample are written: n + m rows of the padded Jacobian, its last used column the residual.
#[derive(Clone, Debug)]
pub(super) struct SampleRows {
    /// Wrench rows, then length rows.
    pub(super) count: usize,
    /// Parameters, without the residual.
    pub(super) parameter_count: usize,
    /// Columns with the residual and the padding to whole lanes.
    pub(super) stride: usize,
    /// Row-major.
    pub(super) entries: Vec<f64>,
}

/// A model at given parameter values with what its rows need again and again.
pub(super) struct RowModel<'a> {
    pub(super) model: &'a Model,
    pub(super) load: Load,
    parameters: &'a [Parameter],
    /// First parameter of each cable; the last entry is the first of the wrench.
    first: Vec<usize>,
}

/// First column of each cable's parameters; the last entry is that of the wrench.
pub(super) fn first_columns(model: &Model, parameters: &[Parameter]) -> Vec<usize> {
    let is_wrench = |p: &Parameter| p.kind == ParameterKind::Wrench;
    let before = |cable: usize| parameters.iter().filter(|p| !is_wrench(p) && p.cable < cable).count();
    (0..=model.cable_count()).map(before).collect()
}

/// What one sample records of its cables.
#[derive(Clone, Copy)]
pub(super) struct Recorded<'a> {
    /// Lengths (m).
    lengths: &'a [f64],
    /// Motor angles that the lengths come from (rad).
    motor_angles: Option<&'a [f64]>,
}

impl<'a> Recorded<'a> {
    pub(super) fn of(samples: &'a Samples, sample: usize) -> Self {
        let row = |angles: &'a Vec<f64>| &angles[sample * samples.cable_count..][..samples.cable_count];
        Self { lengths: samples.lengths_of(sample), motor_angles: samples.motor_angles.as_ref().map(row) }
    }

    #[cfg(test)]
    pub(super) fn lengths(lengths: &'a [f64]) -> Self {
        Self { lengths, motor_angles: None }
    }

    /// The length that a model's drum has at the recorded angle, not a number where it has none; `None` where lengths are
    /// recorded.
    #[inline]
    fn wound(&self, model: &Model, cable: usize) -> Option<DrumLength> {
        let angle = self.motor_angles?[cable];
        Some(model.motor_angle_gradient(cable, angle).unwrap_or(DrumLength::NAN))
    }
}

/// Derivative of the recorded length by a parameter of the cable.
fn by_winch(wound: &DrumLength, parameter: &Parameter, model: &Model) -> f64 {
    let cable = &model.robot().cables[parameter.cable];
    match parameter.kind {
        ParameterKind::DrumRadius => wound.by_radius,
        ParameterKind::StartLength => wound.by_start_length,
        // the first pulley moves with the anchor
        ParameterKind::FrameAnchor if cable.drum_pulley.is_none() => wound.by_pulley.dot(&model.axes()[parameter.axis]),
        _ => 0.0,
    }
}

/// What one cable contributes to the rows of a sample.
struct CableRows {
    course: Course<f64>,
    /// b = R b_P (world, m).
    lever: Vector3<f64>,
    /// Real tension behind the recorded one (N).
    tension: f64,
    tension_scale: f64,
    length_scale: f64,
    /// ∂q_θ/∂q, ∂q_θ/∂f, ∂q_θ/∂κ, ∂q_θ/∂q_h and q_θ itself.
    controlled: crate::cable::elasticity::ControlledLength<f64>,
}

impl SampleRows {
    pub(super) fn new(model: &Model, parameter_count: usize) -> Self {
        let count = model.dof() + model.cable_count();
        let stride = (parameter_count + 1).next_multiple_of(LANES);
        Self { count, parameter_count, stride, entries: vec![0.0; count * stride] }
    }

    pub(super) fn residual(&self, row: usize) -> f64 {
        self.entries[row * self.stride + self.parameter_count]
    }

    pub(super) fn add_to_residual(&mut self, row: usize, amount: f64) {
        self.entries[row * self.stride + self.parameter_count] += amount;
    }
}

impl<'a> RowModel<'a> {
    pub(super) fn new(model: &'a Model, load: Load, parameters: &'a [Parameter]) -> Self {
        Self { model, load, parameters, first: first_columns(model, parameters) }
    }

    fn cable(&self, cable: usize, position: [f64; 3], rotation: &[[f64; 3]; 3], recorded_tension: f64) -> CableRows {
        let data = &self.model.robot().cables[cable];
        let (course, lever) = self.model.course_at(cable, position, rotation);
        let tension = self.model.real_tension(cable, recorded_tension);
        let law: &Elasticity<f64> = self.model.elasticity(cable);
        let controlled = law.controlled_length_gradient(
            course.length,
            tension,
            data.hidden_length.unwrap_or(0.0),
            specific_compliance(data),
            data.stiffness_by == Some(StiffnessBasis::Unstrained),
        );
        let (tension_scale, length_scale) = (data.tension_scale.unwrap_or(1.0), data.length_scale.unwrap_or(1.0));
        CableRows { course, lever, tension, tension_scale, length_scale, controlled }
    }

    /// Writes residuals and Jacobian of a sample at a pose and recorded tensions near the measured ones.
    pub(super) fn write(&self, pose: &Pose, tensions: &[f64], recorded: Recorded<'_>, rows: &mut SampleRows) {
        rows.entries.fill(0.0);
        let (position, rotation_rows, rotation) = (pose.position.into(), pose.rotation_rows(), pose.rotation_matrix());
        let (m, n) = (self.model.cable_count(), self.model.dof());
        let (stride, residual) = (rows.stride, rows.parameter_count);
        let mut wrench = self.load.wrench(pose);
        for cable in 0..m {
            if !self.model.composition().has_closed_form() {
                wrench += self.write_general(cable, pose, tensions[cable], recorded, rows);
                continue;
            }
            let data = self.cable(cable, position, &rotation_rows, tensions[cable]);
            wrench += data.column() * data.tension;
            let expected = self.model.recorded_length(cable, data.controlled.value);
            let length_row = (n + cable) * stride;
            let wound = recorded.wound(self.model, cable);
            rows.entries[length_row + residual] =
                expected - wound.as_ref().map_or(recorded.lengths[cable], |w| w.value);
            for column in self.first[cable]..self.first[cable + 1] {
                let (wrench_change, length_change) = data.by(&self.parameters[column], self.model, &rotation);
                self.write_wrench(&wrench_change, column, rows);
                let by_winch = wound.as_ref().map_or(0.0, |w| by_winch(w, &self.parameters[column], self.model));
                rows.entries[length_row + column] = length_change - by_winch;
            }
        }
        self.write_wrench(&wrench, residual, rows);
        for column in self.first[m]..self.parameters.len() {
            rows.entries[self.parameters[column].axis * stride + column] = 1.0;
        }
    }

    /// Writes the rows of a cable whose law has no closed form; the answer is its wrench. Rows are NaN where it has no shape.
    fn write_general(
        &self,
        cable: usize,
        pose: &Pose,
        tension: f64,
        recorded: Recorded<'_>,
        rows: &mut SampleRows,
    ) -> Wrench {
        let length_row = (self.model.dof() + cable) * rows.stride;
        let Some(data) = GeneralCable::at(self.model, cable, pose, tension) else {
            rows.entries[length_row + rows.parameter_count] = f64::NAN;
            return Wrench::repeat(f64::NAN);
        };
        let expected = self.model.recorded_length(cable, data.controlled_length());
        let wound = recorded.wound(self.model, cable);
        rows.entries[length_row + rows.parameter_count] =
            expected - wound.as_ref().map_or(recorded.lengths[cable], |w| w.value);
        let rotation = pose.rotation_matrix();
        for column in self.first[cable]..self.first[cable + 1] {
            let (wrench_change, length_change) = data.by(&self.parameters[column], &rotation);
            self.write_wrench(&wrench_change, column, rows);
            let by_winch = wound.as_ref().map_or(0.0, |w| by_winch(w, &self.parameters[column], self.model));
            rows.entries[length_row + column] = length_change - by_winch;
        }
        data.wrench()
    }

    /// [`RowModel::noise`] of a cable whose law has no closed form; the answer is the change of its wrench by the pose.
    fn general_noise(
        &self,
        cable: usize,
        pose: &Pose,
        tension: f64,
        sigmas: &Sigmas,
        noise: &mut Noise,
    ) -> nalgebra::Matrix6<f64> {
        let Some(data) = GeneralCable::at(self.model, cable, pose, tension) else {
            return nalgebra::Matrix6::repeat(f64::NAN);
        };
        let basis = self.model.twist_basis();
        let n = basis.len();
        let (wrench, length) = data.by_recorded_tension();
        for (k, twist) in basis.iter().enumerate() {
            noise.by_tension[cable][k] = twist.dot(&wrench) * sigmas.tension;
            noise.by_pose[n + cable][k] = data.length_by_twist(twist) * sigmas.along(twist);
        }
        noise.by_tension[cable][n] = length * sigmas.tension;
        let is_slack = data.tension <= SLACK_SIGMAS * sigmas.tension && !self.model.composition().is_sagging();
        noise.length[cable] = if is_slack { SLACK_SIGMA } else { sigmas.length };
        data.wrench_by_pose()
    }

    /// Writes a wrench (world) to the wrench rows of a column, in the degrees of freedom of the pattern.
    #[inline]
    fn write_wrench(&self, wrench: &Wrench, column: usize, rows: &mut SampleRows) {
        let basis = self.model.twist_basis();
        for row in 0..basis.len() {
            // the directions of a spatial pattern are the world's own
            rows.entries[row * rows.stride + column] =
                if basis.len() == 6 { wrench[row] } else { basis[row].dot(wrench) };
        }
    }

    /// The rows' derivatives by what is measured, at a pose and recorded tensions near the measured ones, each times the
    /// standard deviation of what it is by.
    pub(super) fn noise(&self, pose: &Pose, tensions: &[f64], sigmas: &Sigmas, noise: &mut Noise) {
        let (position, rotation) = (pose.position.into(), pose.rotation_rows());
        let basis = self.model.twist_basis();
        let n = basis.len();
        // ∂(wrench)/∂\[δr; δφ\] of load and cables together
        let mut by_twist = self.load.gradient(pose);
        for (cable, &recorded) in tensions.iter().enumerate() {
            if !self.model.composition().has_closed_form() {
                by_twist += self.general_noise(cable, pose, recorded, sigmas, noise);
                continue;
            }
            let data = self.cable(cable, position, &rotation, recorded);
            by_twist += data.column_by_pose() * data.tension;
            let column = data.column();
            let real_sigma = sigmas.tension / data.tension_scale;
            let slope = -data.length_scale * data.controlled.by_length;
            let (by_tension, by_pose) = (&mut noise.by_tension[cable], &mut noise.by_pose[n + cable]);
            for k in 0..n {
                let along = basis[k].dot(&column);
                by_tension[k] = along * real_sigma;
                by_pose[k] = slope * along * sigmas.along(&basis[k]);
            }
            by_tension[n] = data.length_scale * data.controlled.by_tension * real_sigma;
            // the law says nothing of the length of a slack cable
            let is_slack = data.tension <= SLACK_SIGMAS * real_sigma;
            noise.length[cable] = if is_slack { SLACK_SIGMA } else { sigmas.length };
        }
        for k in 0..n {
            let change = by_twist * basis[k] * sigmas.along(&basis[k]);
            (0..n).for_each(|row| noise.by_pose[row][k] = basis[row].dot(&change));
        }
    }
}

/// Tensions below this many standard deviations of the force sensor may be those of a slack cable.
const SLACK_SIGMAS: f64 = 4.0;
/// Standard deviation of a length row that says nothing (m).
const SLACK_SIGMA: f64 = 1e3;

impl CableRows {
    /// Column of the structure matrix in the world, \[u; b × u\].
    fn column(&self) -> Wrench {
        let u = Vector3::from(self.course.direction);
        stacked(u, self.lever.cross(&u))
    }

    /// ∂\[u; b × u\]/∂\[δr; δφ\], the lever's turn included.
    fn column_by_pose(&self) -> nalgebra::Matrix6<f64> {
        let (_, by_pose) = self.course.by_pose(self.lever.into());
        let u = Vector3::from(self.course.direction);
        let mut matrix = nalgebra::Matrix6::zeros();
        for k in 0..6 {
            let direction = Vector3::new(by_pose[0][k], by_pose[1][k], by_pose[2][k]);
            let lever = if k < 3 { Vector3::zeros() } else { Vector3::ith(k - 3, 1.0).cross(&self.lever) };
            matrix.set_column(k, &stacked(direction, lever.cross(&u) + self.lever.cross(&direction)));
        }
        matrix
    }

    /// Change of the wrench (world) and of the length row by one of the cable's parameters.
    fn by(&self, parameter: &Parameter, model: &Model, rotation: &Matrix3<f64>) -> (Wrench, f64) {
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

    fn by_tension(&self, change: f64) -> (Wrench, f64) {
        (self.column() * change, self.length_scale * self.controlled.by_tension * change)
    }
}

fn stacked(force: Vector3<f64>, moment: Vector3<f64>) -> Wrench {
    Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
}
