//! Eight lanes in two AVX2 registers.

use core::ops::{Add, Div, Mul, Neg, Sub};

use pulp::x86::V3;
use pulp::{NullaryFnOnce, f64x4, m64x4};

use super::angle::full_angle;
use super::{Kernel, LANES, Lanes, Real, Select};

/// Eight numbers in two AVX2 registers; exists only on machines with AVX2.
///
/// Aligned, so that values spilled to the stack do not straddle two cache lines.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub struct Avx2 {
    token: V3,
    halves: [f64x4; 2],
}

/// A kernel with the proof that the machine has AVX2. A struct, since a closure cannot be marked for inlining.
struct OnUnit<K> {
    token: V3,
    kernel: K,
}

impl<K: Kernel> NullaryFnOnce for OnUnit<K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.kernel.run(Avx2::new(self.token))
    }
}

/// Runs a kernel with AVX2.
#[inline(always)]
pub(super) fn on_avx2<K: Kernel>(token: V3, kernel: K) -> K::Output {
    token.vectorize(OnUnit { token, kernel })
}

impl Avx2 {
    /// Zeros; the token proves that the machine has AVX2.
    #[inline(always)]
    pub(super) fn new(token: V3) -> Self {
        Self { token, halves: [token.splat_f64x4(0.0); 2] }
    }
}

macro_rules! on_halves {
    ($trait:ident, $method:ident, $operation:ident) => {
        impl $trait for Avx2 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let (token, [a, b], [c, d]) = (self.token, self.halves, other.halves);
                Self { token, halves: [token.$operation(a, c), token.$operation(b, d)] }
            }
        }
    };
}
on_halves!(Add, add, add_f64x4);
on_halves!(Sub, sub, sub_f64x4);
on_halves!(Mul, mul, mul_f64x4);
on_halves!(Div, div, div_f64x4);

impl Neg for Avx2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let (token, [a, b]) = (self.token, self.halves);
        let sign = token.splat_f64x4(-0.0);
        Self { token, halves: [token.xor_f64x4(a, sign), token.xor_f64x4(b, sign)] }
    }
}

impl Real for Avx2 {
    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        Self { token: self.token, halves: [self.token.splat_f64x4(x); 2] }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let (token, [a, b]) = (self.token, self.halves);
        Self { token, halves: [token.sqrt_f64x4(a), token.sqrt_f64x4(b)] }
    }

    #[inline(always)]
    fn full_angle(self, x: Self) -> Self {
        full_angle(self, x)
    }
}

impl Select for Avx2 {
    type Mask = [m64x4; 2];

    #[inline(always)]
    fn is_less(self, other: Self) -> Self::Mask {
        let ([a, b], [c, d]) = (self.halves, other.halves);
        [self.token.cmp_lt_f64x4(a, c), self.token.cmp_lt_f64x4(b, d)]
    }

    #[inline(always)]
    fn select(self, mask: Self::Mask, otherwise: Self) -> Self {
        let (token, [a, b], [c, d]) = (self.token, self.halves, otherwise.halves);
        Self { token, halves: [token.select_f64x4(mask[0], a, c), token.select_f64x4(mask[1], b, d)] }
    }

    #[inline(always)]
    fn any(self, mask: Self::Mask) -> bool {
        let either = self.token.or_m64x4(mask[0], mask[1]);
        self.token.avx._mm256_movemask_pd(pulp::cast(either)) != 0
    }

    #[inline(always)]
    fn both(self, a: Self::Mask, b: Self::Mask) -> Self::Mask {
        [self.token.and_m64x4(a[0], b[0]), self.token.and_m64x4(a[1], b[1])]
    }

    #[inline(always)]
    fn either(self, a: Self::Mask, b: Self::Mask) -> Self::Mask {
        [self.token.or_m64x4(a[0], b[0]), self.token.or_m64x4(a[1], b[1])]
    }

    #[inline(always)]
    fn without(self, a: Self::Mask, b: Self::Mask) -> Self::Mask {
        let not_b = [self.token.not_m64x4(b[0]), self.token.not_m64x4(b[1])];
        [self.token.and_m64x4(a[0], not_b[0]), self.token.and_m64x4(a[1], not_b[1])]
    }

    #[inline(always)]
    fn first(self) -> f64 {
        self.to_array()[0]
    }

    #[inline(always)]
    fn abs(self) -> Self {
        let (token, [a, b]) = (self.token, self.halves);
        Self { token, halves: [token.abs_f64x4(a), token.abs_f64x4(b)] }
    }
}

impl Lanes for Avx2 {
    #[inline(always)]
    fn apart<K: Kernel>(self, part: K) -> K::Output {
        on_avx2(self.token, part)
    }

    #[inline(always)]
    fn load(self, source: &[f64]) -> Self {
        let mut lanes = [0.0; LANES];
        lanes.copy_from_slice(&source[..LANES]);
        Self { token: self.token, halves: pulp::cast(lanes) }
    }

    #[inline(always)]
    fn to_array(self) -> [f64; LANES] {
        pulp::cast(self.halves)
    }

    #[inline(always)]
    fn sums(four: [Self; 4]) -> [f64; 4] {
        sums_of_halves(four[0].token, [four[0].halves, four[1].halves, four[2].halves, four[3].halves])
    }

    #[inline(always)]
    fn transposed(eight: &[Self; LANES]) -> [Self; LANES] {
        let avx = eight[0].token.avx;
        let mut columns = *eight;
        for half in 0..2 {
            for rows in 0..2 {
                // a block of four rows and four columns
                let mut block = [pulp::cast(eight[0].halves[0]); 4];
                for row in 0..4 {
                    block[row] = pulp::cast(eight[4 * rows + row].halves[half]);
                }
                let low = [avx._mm256_unpacklo_pd(block[0], block[1]), avx._mm256_unpacklo_pd(block[2], block[3])];
                let high = [avx._mm256_unpackhi_pd(block[0], block[1]), avx._mm256_unpackhi_pd(block[2], block[3])];
                let first = 4 * half;
                columns[first].halves[rows] = pulp::cast(avx._mm256_permute2f128_pd::<0x20>(low[0], low[1]));
                columns[first + 1].halves[rows] = pulp::cast(avx._mm256_permute2f128_pd::<0x20>(high[0], high[1]));
                columns[first + 2].halves[rows] = pulp::cast(avx._mm256_permute2f128_pd::<0x31>(low[0], low[1]));
                columns[first + 3].halves[rows] = pulp::cast(avx._mm256_permute2f128_pd::<0x31>(high[0], high[1]));
            }
        }
        columns
    }
}

/// [`Lanes::sums`] of eight lanes in two halves each.
#[inline(always)]
pub(super) fn sums_of_halves(token: V3, four: [[f64x4; 2]; 4]) -> [f64; 4] {
    let [[a, b], [c, d], [e, f], [g, h]] = four;
    let avx = token.avx;
    // adds neighbours: sums 0 and 1 alternate in `first`, 2 and 3 in `second`
    let first = avx._mm256_hadd_pd(pulp::cast(token.add_f64x4(a, b)), pulp::cast(token.add_f64x4(c, d)));
    let second = avx._mm256_hadd_pd(pulp::cast(token.add_f64x4(e, f)), pulp::cast(token.add_f64x4(g, h)));
    let low = avx._mm256_permute2f128_pd::<0x20>(first, second);
    let high = avx._mm256_permute2f128_pd::<0x31>(first, second);
    pulp::cast(avx._mm256_add_pd(low, high))
}
