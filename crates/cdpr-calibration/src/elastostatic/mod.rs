//! Elastostatic identification in inverse form (eq. 4.38): each sample gives n wrench rows Aᵀ(x_M) f_M + w and m length
//! rows, the recorded length that the model expects at the measured pose and tension minus the recorded one.
//!
//! Pose and tension enter several rows of a sample, so their noise is shared: the rows are weighed with their full
//! covariance, to first order Σ = N diag(σ²) Nᵀ with N the rows' derivatives by everything that is measured.

mod adjust;
mod analysis;
mod balance;
mod descent;
mod frozen;
mod linear_rows;
mod linearization;
mod measurement_noise;
mod noise;
mod normal;
mod optimum;
mod pose_rows;
mod robust;
mod row_weights;
mod rows;
#[cfg(test)]
mod tests;

pub(super) use analysis::{length_residuals, report};
pub(super) use balance::{Balance, checked_start};
pub(super) use frozen::FrozenBalance;
pub(super) use noise::Noise;
pub(super) use optimum::with_constant_wrench;
pub(super) use pose_rows::UNITS;
pub(super) use pose_rows::pose_rows;
pub(super) use row_weights::{find, weighted_rows, whitened_rows};
pub(super) use rows::{RowModel, SampleRows};
