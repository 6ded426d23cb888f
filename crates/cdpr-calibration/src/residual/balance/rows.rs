//! Residuals of one sample and their derivatives by parameters and by what is measured.

use nalgebra::Matrix6;

use super::linear_rows::{At, LinearRows};
use super::noise::{Noise, SLACK_SIGMA, Sigmas};
use crate::recorded::Recorded;
use cdpr_model::cable::CableState;
use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::LANES;
use cdpr_model::statics::Load;

/// Most cables whose rows are written in lanes.
const MOST_IN_LANES: usize = 32;

/// Rows of one sample: n + m rows of the padded Jacobian, its last used column the residual.
#[derive(Clone, Debug)]
pub(crate) struct SampleRows {
    /// Wrench rows, then length rows.
    pub(crate) count: usize,
    /// Parameters, without the residual.
    pub(super) parameter_count: usize,
    /// Columns with the residual and the padding to whole lanes.
    pub(crate) stride: usize,
    /// Row-major.
    pub(crate) entries: Vec<f64>,
    /// True where more than the entries of the rows themselves may not be zero.
    pub(super) is_full: bool,
}

/// A model at given parameter values with what its rows need again and again.
pub(crate) struct RowModel<'a> {
    pub(crate) model: &'a Model,
    pub(crate) load: Load,
    parameters: &'a [Parameter],
    /// First parameter of each cable; the last entry is the first of the load.
    first: Vec<usize>,
    /// Way of straight, linear cables.
    pub(super) linear: Option<LinearRows>,
}

/// First column of each cable's parameters; the last entry is that of the load.
pub(super) fn first_columns(model: &Model, parameters: &[Parameter]) -> Vec<usize> {
    let before = |cable: usize| parameters.iter().filter(|p| p.kind.is_of_cable() && p.cable < cable).count();
    (0..=model.cable_count()).map(before).collect()
}

impl SampleRows {
    pub(crate) fn new(model: &Model, parameter_count: usize) -> Self {
        let count = model.dof() + model.cable_count();
        let stride = (parameter_count + 1).next_multiple_of(LANES);
        Self { count, parameter_count, stride, entries: vec![0.0; count * stride], is_full: false }
    }

    pub(crate) fn residual(&self, row: usize) -> f64 {
        self.entries[row * self.stride + self.parameter_count]
    }

    /// Derivatives of every row by the parameters.
    pub(crate) fn derivatives(&self) -> impl Iterator<Item = &[f64]> {
        self.entries.chunks_exact(self.stride).map(|row| &row[..self.parameter_count])
    }

    /// rᵀ W r for a symmetric weight whose rows are rounded up to whole lanes.
    pub(super) fn square(&self, weight: &[f64]) -> f64 {
        let stride = self.count.next_multiple_of(LANES);
        let product = |row: usize| (0..self.count).map(|k| weight[row * stride + k] * self.residual(k)).sum::<f64>();
        (0..self.count).map(|row| self.residual(row) * product(row)).sum()
    }

    /// Multiplies residuals and derivatives.
    pub(super) fn scale(&mut self, factor: f64) {
        if factor != 1.0 {
            self.entries.iter_mut().for_each(|entry| *entry *= factor);
        }
    }

    pub(super) fn add_to_residual(&mut self, row: usize, amount: f64) {
        self.entries[row * self.stride + self.parameter_count] += amount;
    }
}

impl<'a> RowModel<'a> {
    pub(crate) fn new(model: &'a Model, load: Load, parameters: &'a [Parameter]) -> Self {
        let linear = LinearRows::of(model, parameters);
        Self { model, load, parameters, first: first_columns(model, parameters), linear }
    }

    /// Writes residuals and Jacobian of a sample at a pose and recorded tensions near the measured ones.
    pub(crate) fn write(&self, pose: &Pose, tensions: &[f64], recorded: Recorded<'_>, rows: &mut SampleRows) {
        if rows.is_full {
            rows.entries.fill(0.0);
            rows.is_full = false;
        }
        if self.write_linear(pose, tensions, recorded, rows).is_some() {
            return;
        }
        let (rotation_rows, rotation) = (pose.rotation_rows(), pose.rotation_matrix());
        let (m, n) = (self.model.cable_count(), self.model.dof());
        let (stride, residual) = (rows.stride, rows.parameter_count);
        let mut wrench = self.load.wrench(pose);
        for cable in 0..m {
            let length_row = (n + cable) * stride;
            let Some(state) = recorded_state(self.model, cable, pose, &rotation_rows, tensions[cable]) else {
                rows.entries[length_row + residual] = f64::NAN;
                wrench = Wrench::repeat(f64::NAN);
                continue;
            };
            wrench += state.wrench();
            let expected = state.recording.length(state.controlled_length);
            let wound = recorded.wound(self.model, cable);
            rows.entries[length_row + residual] = expected - recorded.length_of(cable, wound.as_ref());
            for column in self.first[cable]..self.first[cable + 1] {
                let parameter = &self.parameters[column];
                let (wrench_change, length_change) = self.model.by_parameter(cable, &state, parameter, &rotation);
                self.write_wrench(&wrench_change, column, rows);
                let by_winch = wound.as_ref().map_or(0.0, |w| self.model.by_winch_parameter(w, parameter));
                rows.entries[length_row + column] = length_change - by_winch;
            }
        }
        self.write_wrench(&wrench, residual, rows);
        self.write_load(pose, rows);
    }

    /// [`RowModel::write`] with cables in lanes; `None` if they are others, or lengths those of drums.
    fn write_linear(&self, pose: &Pose, tensions: &[f64], recorded: Recorded<'_>, rows: &mut SampleRows) -> Option<()> {
        let linear = self.linear.as_ref()?;
        let measured = recorded.measured_lengths()?;
        let mut lengths = [0.0; MOST_IN_LANES];
        let lengths = lengths.get_mut(..measured.len())?;
        let stride = rows.stride;
        let of_cables = linear.write(self.model, At { pose, tensions }, &mut rows.entries, stride, lengths)?;
        let wrench = self.load.wrench(pose) + Wrench::from(of_cables);
        let residual = rows.parameter_count;
        self.write_wrench(&wrench, residual, rows);
        for (cable, (expected, recorded)) in lengths.iter().zip(measured).enumerate() {
            rows.entries[(6 + cable) * stride + residual] = expected - recorded;
        }
        self.write_load(pose, rows);
        Some(())
    }

    /// Writes the derivatives of the wrench rows by the parameters of the load.
    fn write_load(&self, pose: &Pose, rows: &mut SampleRows) {
        for column in self.first[self.model.cable_count()]..self.parameters.len() {
            let change = self.load.by_parameter(self.model.robot(), &self.parameters[column], pose);
            self.write_wrench(&change, column, rows);
        }
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
        self.noise_at(pose, tensions, sigmas, noise, None);
    }

    /// [`RowModel::noise`], and the residuals with what was recorded.
    pub(crate) fn noise_at(
        &self,
        pose: &Pose,
        tensions: &[f64],
        sigmas: &Sigmas,
        noise: &mut Noise,
        mut residuals: Option<(Recorded<'_>, &mut [f64])>,
    ) {
        let rotation = pose.rotation_rows();
        let mut wrench = self.load.wrench(pose);
        let basis = self.model.twist_basis();
        let n = basis.len();
        let along: [f64; 6] = std::array::from_fn(|k| basis.get(k).map_or(0.0, |twist| sigmas.along(twist)));
        // ∂(wrench)/∂\[δr; δφ\] of load and cables together
        let mut by_twist = self.load.gradient(pose);
        for (cable, &recorded) in tensions.iter().enumerate() {
            let Some(state) = recorded_state(self.model, cable, pose, &rotation, recorded) else {
                by_twist = Matrix6::repeat(f64::NAN);
                continue;
            };
            by_twist += state.wrench_by_pose_at_given();
            if let Some((recorded, residuals)) = &mut residuals {
                wrench += state.wrench();
                residuals[n + cable] =
                    state.recording.length(state.controlled_length) - recorded.length(self.model, cable);
            }
            let real_sigma = sigmas.tension / state.recording.tension_scale;
            let (wrench, length) = state.by_given_tension(real_sigma);
            let (by_tension, by_pose) = (&mut noise.by_tension[cable], &mut noise.by_pose[n + cable]);
            for k in 0..n {
                by_tension[k] = basis[k].dot(&wrench);
                by_pose[k] = state.recorded_length_by_twist(&basis[k]) * along[k];
            }
            by_tension[n] = length;
            // the law says nothing of the length of a slack cable
            let limit = sigmas.slack / state.recording.tension_scale;
            let may_be_slack = self.model.law(cable).may_be_slack(state.given_tension(), limit);
            noise.length[cable] = if may_be_slack { SLACK_SIGMA } else { sigmas.length };
        }
        if let Some((_, residuals)) = residuals {
            residuals.iter_mut().zip(basis).for_each(|(residual, twist)| *residual = twist.dot(&wrench));
        }
        for k in 0..n {
            // the directions of a spatial pattern are the world's own
            let change = if n == 6 { by_twist.column(k) * along[k] } else { by_twist * basis[k] * along[k] };
            for row in 0..n {
                noise.by_pose[row][k] = if n == 6 { change[row] } else { basis[row].dot(&change) };
            }
        }
    }
}

/// State of a cable (0-based) with a recorded tension (N) at a pose with these rows of its rotation; `None` if it has none.
#[inline]
pub(super) fn recorded_state(
    model: &Model,
    cable: usize,
    pose: &Pose,
    rotation: &[[f64; 3]; 3],
    recorded_tension: f64,
) -> Option<CableState> {
    let (path, end) = model.path_at(cable, pose.position.into(), rotation);
    let input = model.measured_tension(cable, model.real_tension(cable, recorded_tension));
    model.law(cable).state_on(&path, &end, input, None).ok()
}
