//! The charts, one per file: values in, an SVG element out.

mod axis;
mod colour;
mod convergence;
mod drawing;
mod histogram;
mod ladder;
mod map;
mod residuals;
mod spectrum;

pub(super) use convergence::convergence;
pub(super) use histogram::histogram;
pub(super) use ladder::{Ladder, Rung};
pub(super) use map::{Map, MapPoint};
pub(super) use residuals::residuals;
pub(super) use spectrum::spectrum;

/// Smallest and largest of the finite values.
fn finite_range(values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    let mut finite = values.into_iter().filter(|value| value.is_finite());
    let first = finite.next()?;
    Some(finite.fold((first, first), |(low, high), value| (low.min(value), high.max(value))))
}
