//! Eight lanes in one AVX-512 register.

use core::ops::{Add, Div, Mul, Neg, Sub};

use pulp::x86::V4;
use pulp::{NullaryFnOnce, b8, f64x8};

use super::angle::full_angle;
use super::avx2::sums_of_halves;
use super::{Kernel, LANES, Lanes, Real, Select};

/// Eight numbers in one AVX-512 register; exists only on machines with AVX-512.
///
/// Aligned, so that a value spilled to the stack has a cache line of its own.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Avx512 {
    token: V4,
    value: f64x8,
}

/// A kernel with the proof that the machine has AVX-512. A struct, since a closure cannot be marked for inlining.
struct OnUnit<K> {
    token: V4,
    kernel: K,
}

impl<K: Kernel> NullaryFnOnce for OnUnit<K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.kernel.run(Avx512::new(self.token))
    }
}

/// Runs a kernel with AVX-512.
#[inline(always)]
pub(super) fn on_avx512<K: Kernel>(token: V4, kernel: K) -> K::Output {
    token.vectorize(OnUnit { token, kernel })
}

impl Avx512 {
    /// Zeros; the token proves that the machine has AVX-512.
    #[inline(always)]
    pub(super) fn new(token: V4) -> Self {
        Self { token, value: token.splat_f64x8(0.0) }
    }
}

macro_rules! on_register {
    ($trait:ident, $method:ident, $operation:ident) => {
        impl $trait for Avx512 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self { token: self.token, value: self.token.$operation(self.value, other.value) }
            }
        }
    };
}
on_register!(Add, add, add_f64x8);
on_register!(Sub, sub, sub_f64x8);
on_register!(Mul, mul, mul_f64x8);
on_register!(Div, div, div_f64x8);

impl Neg for Avx512 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { token: self.token, value: self.token.xor_f64x8(self.value, self.token.splat_f64x8(-0.0)) }
    }
}

impl Real for Avx512 {
    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        Self { token: self.token, value: self.token.splat_f64x8(x) }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self { token: self.token, value: self.token.sqrt_f64x8(self.value) }
    }

    #[inline(always)]
    fn full_angle(self, x: Self) -> Self {
        full_angle(self, x)
    }
}

impl Select for Avx512 {
    type Mask = b8;

    #[inline(always)]
    fn is_less(self, other: Self) -> b8 {
        self.token.cmp_lt_f64x8(self.value, other.value)
    }

    #[inline(always)]
    fn select(self, mask: b8, otherwise: Self) -> Self {
        Self { token: self.token, value: self.token.select_f64x8(mask, self.value, otherwise.value) }
    }

    #[inline(always)]
    fn any(self, mask: b8) -> bool {
        mask.0 != 0
    }

    #[inline(always)]
    fn both(self, a: b8, b: b8) -> b8 {
        b8(a.0 & b.0)
    }

    #[inline(always)]
    fn either(self, a: b8, b: b8) -> b8 {
        b8(a.0 | b.0)
    }

    #[inline(always)]
    fn without(self, a: b8, b: b8) -> b8 {
        b8(a.0 & !b.0)
    }

    #[inline(always)]
    fn first(self) -> f64 {
        self.to_array()[0]
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self { token: self.token, value: self.token.abs_f64x8(self.value) }
    }
}

impl Lanes for Avx512 {
    #[inline(always)]
    fn apart<K: Kernel>(self, part: K) -> K::Output {
        on_avx512(self.token, part)
    }

    #[inline(always)]
    fn load(self, source: &[f64]) -> Self {
        let mut lanes = [0.0; LANES];
        lanes.copy_from_slice(&source[..LANES]);
        Self { token: self.token, value: pulp::cast(lanes) }
    }

    #[inline(always)]
    fn to_array(self) -> [f64; LANES] {
        pulp::cast(self.value)
    }

    #[inline(always)]
    fn sums(four: [Self; 4]) -> [f64; 4] {
        let [a, b, c, d] = four;
        let halves = [pulp::cast(a.value), pulp::cast(b.value), pulp::cast(c.value), pulp::cast(d.value)];
        sums_of_halves(*a.token, halves)
    }

    #[inline(always)]
    fn transposed(eight: &[Self; LANES]) -> [Self; LANES] {
        let token = eight[0].token;
        let unit = token.avx512f;
        let mut columns = *eight;
        for side in 0..2 {
            // numbers `side`, `side` + 2, + 4, + 6 of each pair of rows, beside each other
            let mut pairs = [pulp::cast(eight[0].value); 4];
            for pair in 0..4 {
                let (a, b) = (pulp::cast(eight[2 * pair].value), pulp::cast(eight[2 * pair + 1].value));
                pairs[pair] = if side == 0 { unit._mm512_unpacklo_pd(a, b) } else { unit._mm512_unpackhi_pd(a, b) };
            }
            // then of four rows, then of eight
            let even = unit._mm512_shuffle_f64x2::<0x88>(pairs[0], pairs[1]);
            let odd = unit._mm512_shuffle_f64x2::<0xdd>(pairs[0], pairs[1]);
            let lower_even = unit._mm512_shuffle_f64x2::<0x88>(pairs[2], pairs[3]);
            let lower_odd = unit._mm512_shuffle_f64x2::<0xdd>(pairs[2], pairs[3]);
            columns[side].value = pulp::cast(unit._mm512_shuffle_f64x2::<0x88>(even, lower_even));
            columns[side + 4].value = pulp::cast(unit._mm512_shuffle_f64x2::<0xdd>(even, lower_even));
            columns[side + 2].value = pulp::cast(unit._mm512_shuffle_f64x2::<0x88>(odd, lower_odd));
            columns[side + 6].value = pulp::cast(unit._mm512_shuffle_f64x2::<0xdd>(odd, lower_odd));
        }
        columns
    }
}
