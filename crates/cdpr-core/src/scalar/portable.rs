//! Eight lanes in four pairs, for the vector instructions that every machine of the target has.
//!
//! Pairs, not an array: operations on an array are loops, which the compiler would unroll at every call site.

use core::ops::{Add, Div, Mul, Neg, Sub};

use wide::{bytemuck, f64x2};

use super::angle::full_angle;
use super::{Kernel, LANES, Lanes, Real, Select};

/// Eight numbers in pairs.
#[derive(Clone, Copy, Debug)]
pub struct Portable([f64x2; LANES / 2]);

impl Portable {
    /// Lanes that hold these eight numbers.
    #[inline(always)]
    pub fn new(numbers: [f64; LANES]) -> Self {
        Self(bytemuck::cast(numbers))
    }

    #[inline(always)]
    fn each(self, operation: impl Fn(f64x2) -> f64x2) -> Self {
        let [a, b, c, d] = self.0;
        Self([operation(a), operation(b), operation(c), operation(d)])
    }
}

macro_rules! pairwise {
    ($trait:ident, $method:ident) => {
        impl $trait for Portable {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
                Self([a.$method(e), b.$method(f), c.$method(g), d.$method(h)])
            }
        }
    };
}
pairwise!(Add, add);
pairwise!(Sub, sub);
pairwise!(Mul, mul);
pairwise!(Div, div);

impl Neg for Portable {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|pair| pair ^ f64x2::splat(-0.0))
    }
}

impl Real for Portable {
    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        Self([f64x2::splat(x); LANES / 2])
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.each(f64x2::sqrt)
    }

    #[inline(always)]
    fn full_angle(self, x: Self) -> Self {
        full_angle(self, x)
    }
}

impl Select for Portable {
    /// All bits set in lanes where the statement holds, none elsewhere.
    type Mask = [f64x2; LANES / 2];

    #[inline(always)]
    fn is_less(self, other: Self) -> Self::Mask {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        [a.simd_lt(e), b.simd_lt(f), c.simd_lt(g), d.simd_lt(h)]
    }

    #[inline(always)]
    fn select(self, mask: Self::Mask, otherwise: Self) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, otherwise.0);
        Self([mask[0].bitselect(a, e), mask[1].bitselect(b, f), mask[2].bitselect(c, g), mask[3].bitselect(d, h)])
    }

    #[inline(always)]
    fn any(self, mask: Self::Mask) -> bool {
        ((mask[0] | mask[1]) | (mask[2] | mask[3])).any()
    }

    #[inline(always)]
    fn both(self, a: Self::Mask, b: Self::Mask) -> Self::Mask {
        [a[0] & b[0], a[1] & b[1], a[2] & b[2], a[3] & b[3]]
    }

    #[inline(always)]
    fn either(self, a: Self::Mask, b: Self::Mask) -> Self::Mask {
        [a[0] | b[0], a[1] | b[1], a[2] | b[2], a[3] | b[3]]
    }

    #[inline(always)]
    fn without(self, a: Self::Mask, b: Self::Mask) -> Self::Mask {
        [a[0] & !b[0], a[1] & !b[1], a[2] & !b[2], a[3] & !b[3]]
    }

    #[inline(always)]
    fn first(self) -> f64 {
        self.to_array()[0]
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.each(f64x2::abs)
    }
}

impl Lanes for Portable {
    #[inline(never)]
    fn apart<K: Kernel>(self, part: K) -> K::Output {
        part.run(self)
    }

    #[inline(always)]
    fn load(self, source: &[f64]) -> Self {
        let mut lanes = [0.0; LANES];
        lanes.copy_from_slice(&source[..LANES]);
        Self::new(lanes)
    }

    #[inline(always)]
    fn to_array(self) -> [f64; LANES] {
        bytemuck::cast(self.0)
    }
}
