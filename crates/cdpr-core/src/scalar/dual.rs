//! Dual numbers of num-dual: exact derivatives of every formula, against which analytic derivatives are tested.

use super::{Real, Select, Smooth};

impl<D: nalgebra::Dim> Real for num_dual::DualVec<f64, D>
where
    nalgebra::DefaultAllocator: nalgebra::allocator::Allocator<D>,
    Self: Copy,
{
    fn constant(self, x: f64) -> Self {
        x.into()
    }

    fn sqrt(self) -> Self {
        num_dual::DualNum::sqrt(&self)
    }

    fn full_angle(self, x: Self) -> Self {
        let mut angle = num_dual::DualNum::atan2(&self, x);
        if angle.re < 0.0 {
            angle.re += core::f64::consts::TAU;
        }
        angle
    }
}

impl<D: nalgebra::Dim> Select for num_dual::DualVec<f64, D>
where
    nalgebra::DefaultAllocator: nalgebra::allocator::Allocator<D>,
    Self: Copy,
{
    type Mask = bool;

    fn is_less(self, other: Self) -> bool {
        self.re < other.re
    }

    fn select(self, mask: bool, otherwise: Self) -> Self {
        if mask { self } else { otherwise }
    }

    fn any(self, mask: bool) -> bool {
        mask
    }

    fn both(self, a: bool, b: bool) -> bool {
        a && b
    }

    fn either(self, a: bool, b: bool) -> bool {
        a || b
    }

    fn without(self, a: bool, b: bool) -> bool {
        a && !b
    }

    #[inline]
    fn first(self) -> f64 {
        self.re
    }

    fn abs(self) -> Self {
        if self.re < 0.0 { -self } else { self }
    }
}

impl<D: nalgebra::Dim> Smooth for num_dual::DualVec<f64, D>
where
    nalgebra::DefaultAllocator: nalgebra::allocator::Allocator<D>,
    Self: Copy,
{
    fn value(self) -> f64 {
        self.re
    }

    fn chain(self, value: f64, derivative: f64) -> Self {
        (self - self.re) * derivative + value
    }
}
