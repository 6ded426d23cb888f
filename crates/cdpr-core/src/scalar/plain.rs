//! Plain numbers.

use super::angle;
use super::real::Real;

impl Real for f64 {
    #[inline]
    fn constant(self, x: f64) -> Self {
        x
    }

    #[inline]
    fn sqrt(self) -> Self {
        num_traits::Float::sqrt(self)
    }

    #[inline]
    fn full_angle(self, x: Self) -> Self {
        angle::full_angle(self, x)
    }
}
