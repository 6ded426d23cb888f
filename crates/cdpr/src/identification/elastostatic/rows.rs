//! Residuals of one sample and their derivatives by parameters and by what is measured.

use nalgebra::{Matrix3, Vector3};

use crate::cable::Course;
use crate::cable::elasticity::Elasticity;
use crate::geometry::Pose;
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
}

impl<'a> RowModel<'a> {
    pub(super) fn new(model: &'a Model, load: Load, parameters: &'a [Parameter]) -> Self {
        let is_wrench = |p: &Parameter| p.kind == ParameterKind::Wrench;
        let before = |cable: usize| parameters.iter().filter(|p| !is_wrench(p) && p.cable < cable).count();
        Self { model, load, parameters, first: (0..=model.cable_count()).map(before).collect() }
    }

    fn cable(&self, cable: usize, pose: &Pose, recorded_tension: f64) -> CableRows {
        let data = &self.model.robot().cables[cable];
        let (course, lever) = self.model.course_or_nan(cable, pose);
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

    /// Writes residuals and Jacobian of a sample.
    pub(super) fn write(&self, samples: &Samples, tensions: &[f64], sample: usize, rows: &mut SampleRows) {
        rows.entries.fill(0.0);
        let pose = &samples.poses[sample];
        let rotation = pose.rotation_matrix();
        let (m, n) = (self.model.cable_count(), self.model.dof());
        let (stride, residual) = (rows.stride, rows.parameter_count);
        let wrench = self.load.wrench(pose);
        for (row, basis) in self.model.twist_basis().iter().enumerate() {
            rows.entries[row * stride + residual] = basis.dot(&wrench);
        }
        let recorded = samples.lengths_of(sample);
        for cable in 0..m {
            let data = self.cable(cable, pose, tensions[sample * m + cable]);
            for (row, basis) in self.model.twist_basis().iter().enumerate() {
                rows.entries[row * stride + residual] += data.tension * data.column().dot(basis);
            }
            let expected = self.model.recorded_length(cable, data.controlled.value);
            let length_row = (n + cable) * stride;
            rows.entries[length_row + residual] = expected - recorded[cable];
            for column in self.first[cable]..self.first[cable + 1] {
                let (wrench_change, length_change) = data.by(&self.parameters[column], self.model, &rotation);
                for (row, basis) in self.model.twist_basis().iter().enumerate() {
                    rows.entries[row * stride + column] = basis.dot(&wrench_change);
                }
                rows.entries[length_row + column] = length_change;
            }
        }
        for column in self.first[m]..self.parameters.len() {
            rows.entries[self.parameters[column].axis * stride + column] = 1.0;
        }
    }

    /// Adds N diag(σ²) Nᵀ of a sample to `covariance` (row-major, n + m).
    pub(super) fn add_covariance(
        &self,
        samples: &Samples,
        tensions: &[f64],
        sample: usize,
        sigmas: &Sigmas,
        covariance: &mut [f64],
    ) {
        let pose = &samples.poses[sample];
        let (m, n) = (self.model.cable_count(), self.model.dof());
        let count = n + m;
        // rows' derivatives by the pose's n directions, to be scaled by their σ
        let mut by_pose = nalgebra::DMatrix::zeros(count, n);
        let gravity = self.load.gradient(pose);
        let basis = self.model.twist_basis();
        for column in 0..n {
            let change = gravity * basis[column];
            (0..n).for_each(|row| by_pose[(row, column)] = basis[row].dot(&change));
        }
        for cable in 0..m {
            let data = self.cable(cable, pose, tensions[sample * m + cable]);
            let by_twist = data.column_by_pose();
            for column in 0..n {
                let change = by_twist * basis[column] * data.tension;
                (0..n).for_each(|row| by_pose[(row, column)] += basis[row].dot(&change));
                let length_change = -data.column().dot(&basis[column]);
                by_pose[(n + cable, column)] = data.length_scale * data.controlled.by_length * length_change;
            }
            // the recorded tension enters n wrench rows and one length row
            let real_sigma = sigmas.tension / data.tension_scale;
            let place = |k: usize| if k < n { k } else { n + cable };
            let by_tension = |k: usize| match k < n {
                true => basis[k].dot(&data.column()) * real_sigma,
                false => data.length_scale * data.controlled.by_tension * real_sigma,
            };
            for i in 0..=n {
                for j in 0..=n {
                    covariance[place(i) * count + place(j)] += by_tension(i) * by_tension(j);
                }
            }
            covariance[(n + cable) * count + n + cable] += sigmas.length * sigmas.length;
        }
        for (column, twist) in basis.iter().enumerate() {
            let turns = twist.fixed_rows::<3>(3).norm() > 0.0;
            by_pose.column_mut(column).scale_mut(if turns { sigmas.rotation } else { sigmas.position });
        }
        for i in 0..count {
            for j in 0..count {
                covariance[i * count + j] += by_pose.row(i).dot(&by_pose.row(j));
            }
        }
    }
}

/// Standard deviations of everything measured, as the weights use them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sigmas {
    /// Per axis (m).
    pub(super) position: f64,
    /// Per axis (rad).
    pub(super) rotation: f64,
    /// (m)
    pub(super) length: f64,
    /// (N)
    pub(super) tension: f64,
}

impl CableRows {
    /// Column of the structure matrix in the world, \[u; b × u\].
    fn column(&self) -> nalgebra::Vector6<f64> {
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
    fn by(&self, parameter: &Parameter, model: &Model, rotation: &Matrix3<f64>) -> (nalgebra::Vector6<f64>, f64) {
        let u = Vector3::from(self.course.direction);
        let gradient = Matrix3::from(self.course.direction_gradient).transpose();
        let by_length = self.length_scale * self.controlled.by_length;
        // a change of the direction and of the lever
        let wrench = |direction: Vector3<f64>, lever: Vector3<f64>| {
            stacked(direction, lever.cross(&u) + self.lever.cross(&direction)) * self.tension
        };
        let none = nalgebra::Vector6::zeros();
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
            ParameterKind::LengthScale => (none, self.controlled.value),
            ParameterKind::Compliance => (none, self.length_scale * self.controlled.by_compliance),
            ParameterKind::HiddenLength => (none, self.length_scale * self.controlled.by_hidden_length),
            ParameterKind::TensionScale => self.by_tension(-self.tension / self.tension_scale),
            ParameterKind::TensionOffset => self.by_tension(-1.0 / self.tension_scale),
            ParameterKind::Wrench => (none, 0.0),
        }
    }

    fn by_tension(&self, change: f64) -> (nalgebra::Vector6<f64>, f64) {
        (self.column() * change, self.length_scale * self.controlled.by_tension * change)
    }
}

fn stacked(force: Vector3<f64>, moment: Vector3<f64>) -> nalgebra::Vector6<f64> {
    nalgebra::Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
}
