//! Eight lanes on whatever the compiler makes of an array: the reference that the vector units must match bit for bit.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::angle::full_angle;
use super::{Kernel, LANES, Lanes, Real, Select};

/// Eight numbers in an array.
#[derive(Clone, Copy, Debug)]
pub struct Portable(pub [f64; LANES]);

macro_rules! elementwise {
    ($trait:ident, $method:ident, $operator:tt) => {
        impl $trait for Portable {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, other: Self) -> Self {
                for lane in 0..LANES {
                    self.0[lane] $operator other.0[lane];
                }
                self
            }
        }
    };
}
elementwise!(Add, add, +=);
elementwise!(Sub, sub, -=);
elementwise!(Mul, mul, *=);
elementwise!(Div, div, /=);

impl Neg for Portable {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for lane in &mut self.0 {
            *lane = -*lane;
        }
        self
    }
}

impl Real for Portable {
    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        Self([x; LANES])
    }

    #[inline(always)]
    fn sqrt(mut self) -> Self {
        for lane in &mut self.0 {
            *lane = lane.sqrt();
        }
        self
    }

    #[inline(always)]
    fn full_angle(self, x: Self) -> Self {
        full_angle(self, x)
    }
}

impl Select for Portable {
    /// All bits set where the statement holds, none elsewhere: the shape that compilers turn into vector code.
    type Mask = [u64; LANES];

    #[inline(always)]
    fn is_less(self, other: Self) -> Self::Mask {
        let mut mask = [0; LANES];
        for lane in 0..LANES {
            mask[lane] = if self.0[lane] < other.0[lane] { u64::MAX } else { 0 };
        }
        mask
    }

    #[inline(always)]
    fn select(mut self, mask: Self::Mask, otherwise: Self) -> Self {
        for lane in 0..LANES {
            let bits = (self.0[lane].to_bits() & mask[lane]) | (otherwise.0[lane].to_bits() & !mask[lane]);
            self.0[lane] = f64::from_bits(bits);
        }
        self
    }

    #[inline(always)]
    fn any(self, mask: Self::Mask) -> bool {
        mask.iter().fold(0, |either, lane| either | lane) != 0
    }

    #[inline(always)]
    fn abs(mut self) -> Self {
        for lane in &mut self.0 {
            *lane = lane.abs();
        }
        self
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
        Self(lanes)
    }

    #[inline(always)]
    fn to_array(self) -> [f64; LANES] {
        self.0
    }
}
