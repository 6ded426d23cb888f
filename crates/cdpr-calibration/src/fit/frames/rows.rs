//! Whitened rows of a model at its optimum, by its parameters and by the motion of the platform.

use crate::progress::unobserved;
use nalgebra::{DMatrix, DVector};

use crate::blocks::Block;
use crate::elastostatic;
use crate::fit::checks::explains_tensions;
use crate::fit::descent::End;
use crate::fit::optimum::{Optimum, find};
use crate::fit::{InputError, Settings};
use crate::identifiability::prior_weights;
use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Whitened rows that share parameters.
pub(crate) struct RowBlock {
    /// Places of the parameters in the list of all.
    pub(crate) parameters: Vec<usize>,
    /// Rows by these parameters.
    pub(crate) by_parameters: DMatrix<f64>,
    /// Rows by the motion of the platform along the degrees of freedom of the pattern.
    pub(crate) by_pose: DMatrix<f64>,
    pub(crate) residuals: DVector<f64>,
    /// Rows of one sample, which follow each other.
    pub(crate) rows_of_sample: usize,
    /// Poses at which the rows hold: the measured ones, or where the model and they agree best.
    pub(crate) poses: Vec<Pose>,
    /// Wrenches among the rows.
    pub(crate) wrenches: Option<Wrenches>,
}

/// Wrenches that the rows of a sample balance, for the part of a row's change that only its axes make: a motion of everything together turns them,
/// or moves the point that they are about, and changes no balance.
pub(crate) struct Wrenches {
    /// Imbalance of each sample (world, about the platform's origin).
    pub(crate) residuals: Vec<Wrench>,
    /// Whitened rows by wrenches along the degrees of freedom of the pattern.
    pub(crate) whitened: DMatrix<f64>,
}

/// A model at its optimum for given frames.
pub(super) struct Fitted {
    pub(super) blocks: Vec<RowBlock>,
    /// Values of the parameters, and those of the file.
    pub(super) values: Vec<f64>,
    pub(super) start: Vec<f64>,
    pub(super) basis: Vec<Twist>,
    /// 1/σ² of the parameters' priors, 0 without one.
    pub(super) priors: Vec<f64>,
}

impl Fitted {
    pub(super) fn of(
        model: &Model,
        samples: &Samples,
        parameters: &[Parameter],
        settings: &Settings,
    ) -> Result<Self, InputError> {
        let (calibrated, blocks) = match explains_tensions(model) {
            true => {
                let optimum = elastostatic::find(model, samples, parameters, settings, &unobserved)?;
                let rows = elastostatic::pose_rows(&optimum, samples, parameters)?;
                (optimum.calibrated().clone(), vec![rows])
            }
            false => {
                let (optimum, _) = find(model, samples, parameters, settings, &unobserved)?;
                let calibrated = optimum.calibrated(model)?;
                let blocks = cables(&calibrated, samples, parameters, &optimum);
                (calibrated, blocks)
            }
        };
        let values = |model: &Model| parameters.iter().map(|parameter| parameter.value(model.robot())).collect();
        Ok(Self {
            blocks,
            values: values(&calibrated),
            start: values(model),
            basis: model.twist_basis().to_vec(),
            priors: prior_weights(parameters, settings),
        })
    }
}

/// Rows of recorded lengths, cable by cable.
fn cables(model: &Model, samples: &Samples, parameters: &[Parameter], optimum: &Optimum) -> Vec<RowBlock> {
    let basis = model.twist_basis();
    let of_block = |(block, end): (&Block, &End)| {
        let (mut residuals, columns) = block.rows(&optimum.poses, &end.values, samples.len());
        let roots: Vec<f64> = (0..samples.len()).map(|sample| optimum.norms.weight(sample).sqrt()).collect();
        residuals.iter_mut().zip(&roots).for_each(|(residual, root)| *residual *= root);
        let scale = model.recorded_length(block.cable, 1.0) - model.recorded_length(block.cable, 0.0);
        let mut by_pose = DMatrix::zeros(samples.len(), basis.len());
        for (sample, pose) in samples.poses.iter().enumerate() {
            let (path, arm) = model.path_or_nan(block.cable, pose);
            let direction = nalgebra::Vector3::from(path.direction);
            let moment = arm.cross(&direction);
            let weight = -roots[sample] * block.weights()[sample] * scale;
            for (k, twist) in basis.iter().enumerate() {
                let along = direction.dot(&twist.fixed_rows::<3>(0)) + moment.dot(&twist.fixed_rows::<3>(3));
                by_pose[(sample, k)] = weight * along;
            }
        }
        let place = |own: &Parameter| parameters.iter().position(|parameter| parameter == own);
        RowBlock {
            parameters: block.parameters.iter().filter_map(place).collect(),
            by_parameters: DMatrix::from_fn(samples.len(), columns.len(), |row, k| roots[row] * columns[k][row]),
            by_pose,
            residuals: DVector::from_vec(residuals),
            rows_of_sample: 1,
            poses: samples.poses.clone(),
            wrenches: None,
        }
    };
    optimum.blocks.iter().zip(&optimum.ends).map(of_block).collect()
}
