//! Residuals of predicted poses that count where a task is.

use super::Given;
use super::poses::PoseResidual;
use super::rows::{Layout, Missing, Rows};
use super::{Outliers, Residual};
use crate::fit::{InputError, TaskBox};
use cdpr_model::model::Model;

/// Weight of poses far from the box.
const FAR: f64 = 0.1;
/// Distance from the box, as a share of its diagonal, over which weights fall to that.
const BORDER: f64 = 0.1;

/// Errors of predicted poses, each sample's square by its weight: 1 in the box of the task, falling to 0.1 over a tenth of its diagonal.
pub(super) struct PoseInTask<'a> {
    poses: PoseResidual<'a>,
    /// √weight of each sample.
    roots: Vec<f64>,
}

impl<'a> PoseInTask<'a> {
    pub(super) fn new(given: &Given<'a, '_>) -> Result<Self, InputError> {
        let task = given.settings.task.ok_or(InputError::NoTask)?;
        let root = |pose: &cdpr_model::geometry::Pose| weight(&task, &pose.position.into()).sqrt();
        Ok(Self { poses: PoseResidual::new(given)?, roots: given.samples.poses.iter().map(root).collect() })
    }
}

/// Weight of a sample at a measured position (m).
fn weight(task: &TaskBox, position: &[f64; 3]) -> f64 {
    let beyond = |k: usize| (task.min[k] - position[k]).max(position[k] - task.max[k]).max(0.0);
    let norm = |part: &dyn Fn(usize) -> f64| (0..3).map(|k| part(k).powi(2)).sum::<f64>().sqrt();
    let (distance, diagonal) = (norm(&beyond), norm(&|k| task.max[k] - task.min[k]));
    (1.0 - (1.0 - FAR) * distance / (BORDER * diagonal)).max(FAR)
}

impl Residual for PoseInTask<'_> {
    fn model(&self) -> &Model {
        self.poses.model()
    }

    fn layout(&self) -> Layout {
        self.poses.layout()
    }

    fn write(&mut self, values: &[f64], rows: &mut Rows) -> bool {
        let is_written = self.poses.write(values, rows);
        self.roots.iter().enumerate().filter(|_| is_written).for_each(|(sample, root)| rows.scale(sample, *root));
        is_written
    }

    /// Returns false for any samples: the weights are chosen, and the residuals give the size of the noise.
    fn is_absolute(&self) -> bool {
        false
    }

    fn unit(&self) -> Option<f64> {
        self.poses.unit()
    }

    fn unpredicted(&self) -> Option<(usize, String)> {
        self.poses.unpredicted()
    }

    fn leave_out_missing(&mut self, values: &[f64]) -> Vec<Missing> {
        self.poses.leave_out_missing(values)
    }

    fn informative_rows(&self) -> usize {
        self.poses.informative_rows()
    }

    fn outliers(&self) -> Option<Outliers> {
        self.poses.outliers()
    }

    fn restart(&mut self) {
        self.poses.restart();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::{Settings, fit};
    use crate::objective::Objective;
    use crate::residual::tests::{crane, of, samples};
    use cdpr_model::model::{Composition, FreeParameters};

    #[test]
    fn weights_fall_over_a_tenth_of_the_diagonal() {
        // a diagonal of 3 m
        let task = TaskBox { min: [0.0, 0.0, 0.0], max: [1.0, 2.0, 2.0] };
        for (position, expected) in
            [([0.5, 0.0, 2.0], 1.0), ([1.15, 1.0, 1.0], 0.55), ([1.3, 1.0, 1.0], 0.1), ([-9.0, 1.0, 1.0], 0.1)]
        {
            assert!((weight(&task, &position) - expected).abs() < 1e-12, "{position:?}: {}", weight(&task, &position));
        }
    }

    /// Rows are those of poses by the roots of the weights, a box around all poses changes nothing, and one around a few makes their errors smaller.
    #[test]
    fn poses_in_the_task_are_fitted_better() {
        let model = crane(Composition::PULLEY);
        let samples = samples(&model);
        let free: FreeParameters = "frame-anchor[1,2]".parse().unwrap();
        let parameters = free.parameters(&model, &FreeParameters::default()).unwrap();
        let of_poses = Settings { objective: Objective::Pose, ..Settings::default() };
        let boxed = |min: [f64; 3], max: [f64; 3]| Settings {
            objective: Objective::PoseInTask,
            task: Some(TaskBox { min, max }),
            ..Settings::default()
        };
        let few = {
            let middle = samples.poses[2].position;
            boxed((middle.add_scalar(-0.01)).into(), (middle.add_scalar(0.01)).into())
        };
        let values: Vec<f64> = parameters.iter().map(|parameter| parameter.value(model.robot())).collect();
        let written = |settings: &Settings, values: &[f64]| {
            let mut residual = of(&model, &samples, &parameters, settings);
            let mut rows = Rows::new(residual.layout(), values.len());
            assert!(residual.write(values, &mut rows));
            rows
        };
        let (all, weighed) = (written(&of_poses, &values), written(&few, &values));
        assert_eq!(all.square(2), weighed.square(2));
        assert!((weighed.square(7) / all.square(7) - FAR).abs() < 1e-12);
        let found = |settings: &Settings| fit(&model, &samples, &free, settings).unwrap();
        let (plain, around) = (found(&of_poses), found(&boxed([-1e3; 3], [1e3; 3])));
        for (one, other) in plain.parameters.iter().zip(&around.parameters) {
            assert!((one.value - other.value).abs() < 1e-8, "{}: {} {}", one.name, one.value, other.value);
        }
        // of one sample with ten times the weight of every other one the optimum has the smaller square
        let square = |fitted: &crate::Fit| {
            let values: Vec<f64> = fitted.parameters.iter().map(|estimate| estimate.value).collect();
            written(&of_poses, &values).square(2)
        };
        assert!(square(&found(&few)) < square(&plain), "{} {}", square(&found(&few)), square(&plain));
        let without = Settings { task: None, ..few };
        assert_eq!(fit(&model, &samples, &free, &without).unwrap_err(), InputError::NoTask);
    }
}
