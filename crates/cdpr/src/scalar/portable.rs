//! Eight lanes on whatever the compiler makes of an array: the reference that the vector units must match bit for bit.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{LANES, Lanes, Real};

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
                    self.0[lane] = self.0[lane] $operator other.0[lane];
                }
                self
            }
        }
    };
}
elementwise!(Add, add, +);
elementwise!(Sub, sub, -);
elementwise!(Mul, mul, *);
elementwise!(Div, div, /);

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
    fn full_angle(mut self, x: Self) -> Self {
        for lane in 0..LANES {
            self.0[lane] = self.0[lane].full_angle(x.0[lane]);
        }
        self
    }
}

impl Lanes for Portable {
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
