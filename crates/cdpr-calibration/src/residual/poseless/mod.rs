//! Vectors of lengths at poses that nobody measured: every sample takes the pose at which its lengths fit best.
//!
//! r = ρ/σ_q at the pose x that makes ‖r‖² least, in the directions that are not known. Poses are eliminated sample by sample (variable projection), the
//! derivative is that of Kaufman (1975), J_p without what J_x explains: exact for the gradient, since nothing of r is along J_x at the best pose.

mod search;
mod seek;

use nalgebra::DMatrix;

use super::lengths::LengthRows;
use super::rows::{Layout, Rows};
use super::{Latent, Poseless, Residual};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::{InternalSamples, Samples};
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use search::{DOF, Length, Search};

/// Length of a column that is none beside the part of it that others explain.
const WITHIN: f64 = 1e-13;

/// Length residuals at the best poses, m a sample.
pub(crate) struct PoselessResidual<'a> {
    model: Model,
    parameters: &'a [Parameter],
    is_stated: bool,
    /// Degrees of freedom of each sample that are not known.
    directions: Vec<Vec<Twist>>,
    /// Lengths at the poses; of changes those at the common pose follow as a last sample.
    lengths: LengthRows,
    /// Recorded lengths or changes (m).
    recorded: Vec<f64>,
    are_changes: bool,
    /// 1/σ_q (1/m).
    per_length: f64,
    at: Rows,
    /// Memory for the derivatives of a sample's lengths by its pose.
    by_pose: DMatrix<f64>,
    /// Memory for the projector on what the pose of a sample does not explain, I − E Eᵀ.
    left: DMatrix<f64>,
    /// Poses as known, what is not known of them as at home; the common pose last.
    guesses: Vec<Pose>,
    /// Components of each sample's pose that are known.
    known: Vec<Vec<bool>>,
    /// Poses found last.
    poses: Vec<Pose>,
    /// Poses where the squares were least since the descent began: searches begin there, not where a trial that did not help has led.
    base: Vec<Pose>,
    /// The least squares.
    least: f64,
    /// True once these are no guesses.
    are_sought: bool,
    samples: usize,
}

impl<'a> PoselessResidual<'a> {
    /// Vectors of samples whose unknown components are guessed; σ in metres.
    pub(crate) fn new(model: &Model, internal: &InternalSamples, parameters: &'a [Parameter], sigma: f64) -> Self {
        let samples = internal.samples.len();
        let home = model.robot().home_or_middle();
        let guess = |sample: usize| guess(model, &internal.samples.poses[sample], &internal.known[sample], &home);
        let mut guesses: Vec<Pose> = (0..samples).map(guess).collect();
        let mut recorded = internal.samples.lengths.clone();
        if internal.are_changes {
            guesses.push(Pose::identity());
            recorded.extend(std::iter::repeat_n(0.0, model.cable_count()));
        }
        let mut motor_angles = internal.samples.motor_angles.clone();
        if let Some(angles) = motor_angles.as_mut().filter(|_| internal.are_changes) {
            angles.extend(std::iter::repeat_n(0.0, model.cable_count()));
        }
        let with_origin =
            Samples { poses: guesses.clone(), lengths: recorded, motor_angles, ..internal.samples.clone() };
        let lengths = LengthRows::even(model, &with_origin, parameters, sigma);
        let free = |known: &Vec<bool>| {
            model.twist_basis().iter().zip(known).filter(|(_, known)| !**known).map(|(twist, _)| *twist).collect()
        };
        Self {
            at: Rows::new(Layout::of(lengths.samples(), model.cable_count()), parameters.len()),
            by_pose: DMatrix::zeros(model.cable_count(), DOF),
            left: DMatrix::zeros(model.cable_count(), model.cable_count()),
            directions: internal.known.iter().map(free).collect(),
            known: internal.known.clone(),
            are_sought: false,
            are_changes: internal.are_changes,
            per_length: sigma.recip(),
            poses: guesses.clone(),
            base: guesses.clone(),
            least: f64::INFINITY,
            model: model.clone(),
            parameters,
            is_stated: internal.samples.sigmas.length.is_some_and(|sigma| sigma > 0.0),
            recorded: with_origin.lengths,
            lengths,
            guesses,
            samples,
        }
    }

    /// Rows of one sample.
    fn size(&self) -> usize {
        self.model.cable_count()
    }

    fn try_write(&mut self, values: &[f64], rows: &mut Rows) -> Option<()> {
        let model = self.model.with_parameters(self.parameters, values)?;
        let found = self.are_sought.then(|| self.find(&model, values)).flatten();
        self.poses = match found {
            Some(poses) => poses,
            None => self.seek(&model, values)?,
        };
        self.look(values, &self.poses.clone())?;
        self.are_sought = true;
        (0..self.samples).for_each(|sample| self.write_sample(&model, sample, rows));
        let square = rows.residuals.rows(0, self.size() * self.samples).norm_squared();
        if !(square > self.least) {
            self.take_for_base();
            self.least = square;
        }
        Some(())
    }

    /// Further searches begin at the poses found last.
    fn take_for_base(&mut self) {
        self.base.clone_from(&self.poses);
        self.least = f64::INFINITY;
    }

    /// Poses near those that searches begin at; `None` if a search does not settle.
    fn find(&mut self, model: &Model, values: &[f64]) -> Option<Vec<Pose>> {
        let recorded = self.recorded(model, values)?;
        let mut poses = self.base.clone();
        for (sample, pose) in poses.iter_mut().enumerate().take(self.samples) {
            *pose = self.search(model, &recorded, sample).find(pose, &self.directions[sample])?.pose;
        }
        Some(poses)
    }

    fn search<'b>(&self, model: &'b Model, recorded: &'b [f64], sample: usize) -> Search<'b> {
        let m = model.cable_count();
        Search { model, per_length: self.per_length, recorded: &recorded[sample * m..][..m] }
    }

    /// Lengths that the poses are to have, sample by sample (m).
    fn recorded(&mut self, model: &Model, values: &[f64]) -> Option<Vec<f64>> {
        let (m, poses) = (model.cable_count(), self.poses.clone());
        let modelled =
            |pose: &Pose, cable: usize| model.recorded_length(cable, model.path_or_nan(cable, pose).0.length);
        if !self.parameters.iter().any(|parameter| parameter.kind.needs_motor_angles()) {
            let mut recorded = self.recorded[..self.samples * m].to_vec();
            if self.are_changes {
                let origin: Vec<f64> = (0..m).map(|cable| modelled(&poses[self.samples], cable)).collect();
                recorded.iter_mut().zip(origin.iter().cycle()).for_each(|(length, origin)| *length += origin);
            }
            return Some(recorded);
        }
        // winches make other lengths of the angles
        self.look(values, &poses)?;
        let of = |k: usize| modelled(&poses[k / m], k % m) - self.residual(k / m, k % m) / self.per_length;
        Some((0..self.samples * m).map(of).collect())
    }

    /// Rows at poses.
    fn look(&mut self, values: &[f64], poses: &[Pose]) -> Option<()> {
        self.lengths.move_to(poses);
        self.lengths.write(values, &mut self.at).then_some(())
    }

    /// Residual of a sample's cable where was looked last.
    fn residual(&self, sample: usize, cable: usize) -> f64 {
        let (m, at) = (self.model.cable_count(), &self.at.residuals);
        at[sample * m + cable] - if self.are_changes { at[self.samples * m + cable] } else { 0.0 }
    }

    /// Rows of a sample without what its pose explains.
    fn write_sample(&mut self, model: &Model, sample: usize, rows: &mut Rows) {
        let m = model.cable_count();
        let directions = &self.directions[sample];
        let (first, origin) = (sample * m, self.samples * m);
        let (pose, rotation) = (&self.poses[sample], self.poses[sample].rotation_rows());
        for cable in 0..m {
            rows.residuals[first + cable] = self.residual(sample, cable);
            let row = Length::of(model, cable, pose, &rotation, self.per_length).row(directions);
            (0..directions.len()).for_each(|k| self.by_pose[(cable, k)] = row[k]);
        }
        orthonormalise(&mut self.by_pose, directions.len());
        self.left.fill_with_identity();
        for explained in self.by_pose.column_iter().take(directions.len()) {
            self.left.ger(-1.0, &explained, &explained, 1.0);
        }
        for (column, parameter) in self.parameters.iter().enumerate() {
            // a parameter changes the length of its own cable
            let entries = self.at.jacobian.column(column);
            let origin = if self.are_changes { entries[origin + parameter.cable] } else { 0.0 };
            let entry = entries[first + parameter.cable] - origin;
            let mut target = rows.jacobian.column_mut(column);
            let left = self.left.column(parameter.cable);
            target.as_mut_slice()[first..][..m].iter_mut().zip(&left).for_each(|(row, left)| *row = entry * left);
        }
    }
}

/// Columns of length one at right angles, by the method of Gram and Schmidt; a column within the others becomes zero.
pub(super) fn orthonormalise(columns: &mut DMatrix<f64>, count: usize) {
    for k in 0..count {
        let before = columns.column(k).norm();
        for j in 0..k {
            let (done, mut rest) = columns.columns_range_pair_mut(j..=j, k..);
            let fraction = done.column(0).dot(&rest.column(0));
            rest.column_mut(0).axpy(-fraction, &done.column(0), 1.0);
        }
        let norm = columns.column(k).norm();
        columns.column_mut(k).scale_mut(if norm > WITHIN * before { norm.recip() } else { 0.0 });
    }
}

/// Known components of a pose, the others as at home.
pub(super) fn guess(model: &Model, pose: &Pose, known: &[bool], home: &Pose) -> Pose {
    let mut guess = *home;
    for (twist, _) in model.twist_basis().iter().zip(known).filter(|(_, known)| **known) {
        let axis = twist.fixed_rows::<3>(0).into_owned();
        guess.position += axis * (pose.position - guess.position).dot(&axis);
    }
    let is_turned =
        model.twist_basis().iter().zip(known).any(|(twist, known)| *known && twist.fixed_rows::<3>(3).norm() > 0.0);
    if is_turned { Pose { rotation: pose.rotation, ..guess } } else { guess }
}

impl Poseless for PoselessResidual<'_> {
    fn poses(&self) -> Vec<Pose> {
        self.poses[..self.samples].to_vec()
    }

    fn begin_at(&mut self, poses: &[Pose]) {
        self.poses[..self.samples].copy_from_slice(poses);
        self.take_for_base();
        self.are_sought = true;
    }
}

impl Residual for PoselessResidual<'_> {
    fn layout(&self) -> Layout {
        Layout::of(self.samples, self.size()).eliminating(self.directions.iter().map(Vec::len).sum())
    }

    fn model(&self) -> &Model {
        &self.model
    }

    fn is_absolute(&self) -> bool {
        self.is_stated
    }

    fn unit(&self) -> Option<f64> {
        Some(self.per_length.recip())
    }

    fn restart(&mut self) {
        self.poses.clone_from(&self.guesses);
        self.take_for_base();
        self.are_sought = false;
    }

    fn seek_again(&mut self, values: &[f64]) -> bool {
        self.find_better(values).unwrap_or(false)
    }

    fn latents(&self) -> Vec<Latent> {
        self.poses().into_iter().map(|pose| Latent { pose, tensions: Vec::new() }).collect()
    }

    fn go_on_from(&mut self, latents: &[Latent]) {
        self.begin_at(&latents.iter().map(|latent| latent.pose).collect::<Vec<_>>());
    }

    fn write(&mut self, values: &[f64], rows: &mut Rows) -> bool {
        self.try_write(values, rows).is_some() && rows.is_finite()
    }
}
