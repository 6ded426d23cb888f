//! The number type of every formula.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number that cable geometry can be computed with.
///
/// There is no fused multiply-add, so that every width gives the same bits.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The constant `x` in the number type (and vector unit) of `self`, whose value does not matter.
    fn constant(self, x: f64) -> Self;

    /// Square root; NaN below zero.
    fn sqrt(self) -> Self;

    /// Angle of the vector (`x`, `self`), counted from the first axis, in [0, 2π) (rad).
    fn full_angle(self, x: Self) -> Self;
}
