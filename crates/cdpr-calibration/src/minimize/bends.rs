//! Second derivatives of residual vectors, each along its vector, by differences of the exact gradients.

use nalgebra::{DMatrix, DVector};

use crate::residual::Residual;
use crate::residual::rows::Rows;
use cdpr_model::robot::Parameter;

/// Step of a difference (m): squares of vectors are smooth over metres, and gradients exact to 1e-9.
const STEP: f64 = 3e-4;

/// Σ r ∂²r of chosen samples, parameters in metres: what JᵀJ lacks of half the second derivative of ‖r‖².
#[derive(Clone, Debug, Default)]
pub(super) struct Bends {
    of_samples: Vec<(usize, DMatrix<f64>)>,
}

impl Bends {
    /// Takes them at values where the vectors are `here`; `None` if vectors beside it do not exist. `memory` is written over.
    pub(super) fn of(
        residual: &mut dyn Residual,
        parameters: &[Parameter],
        scale: &[f64],
        values: &[f64],
        here: &Rows,
        samples: impl Iterator<Item = usize>,
        memory: &mut Rows,
    ) -> Option<Self> {
        let count = values.len();
        let in_metres = |gradient: DVector<f64>| DVector::from_fn(count, |k, _| gradient[k] / scale[k]);
        let start = |sample: usize| (sample, in_metres(here.gradient(sample)));
        let gradients: Vec<(usize, DVector<f64>)> = samples.map(start).collect();
        let mut of_samples: Vec<(usize, DMatrix<f64>)> =
            gradients.iter().map(|(sample, _)| (*sample, DMatrix::zeros(count, count))).collect();
        let mut moved = values.to_vec();
        for (k, parameter) in parameters.iter().enumerate() {
            let (low, high) = parameter.bounds();
            let step = if high - values[k] < STEP / scale[k] && values[k] > low { -STEP } else { STEP };
            moved[k] = values[k] + step / scale[k];
            residual.write(&moved, memory).then_some(())?;
            moved[k] = values[k];
            for ((sample, gradient), (_, bend)) in gradients.iter().zip(&mut of_samples) {
                bend.set_column(k, &((in_metres(memory.gradient(*sample)) - gradient) / step));
            }
        }
        for (sample, bend) in &mut of_samples {
            let jacobian = here.jacobian.rows(*sample * here.size(), here.size());
            let linear = jacobian.tr_mul(&jacobian);
            *bend = (&*bend + bend.transpose()) * 0.5;
            *bend -= DMatrix::from_fn(count, count, |i, j| linear[(i, j)] / (scale[i] * scale[j]));
        }
        Some(Self { of_samples })
    }

    pub(super) fn is_empty(&self) -> bool {
        self.of_samples.is_empty()
    }

    /// Their sum, each with the weight of its sample.
    pub(super) fn sum(&self, count: usize, weight: impl Fn(usize) -> f64) -> DMatrix<f64> {
        let zero = DMatrix::zeros(count, count);
        self.of_samples.iter().fold(zero, |sum, (sample, bend)| sum + bend * weight(*sample))
    }
}
