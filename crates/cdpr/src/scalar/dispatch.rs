//! Running a computation on the widest vector unit of the machine, found at run time.

use std::sync::atomic::{AtomicU8, Ordering};

#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
use pulp::NullaryFnOnce;
#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
use pulp::x86::{V3, V4};

use super::{LANES, Lanes, Portable};
#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
use super::{avx2::Avx2, avx512::Avx512};

/// The widest unit that may be used, as a number in the order of [`Unit`].
static WIDEST: AtomicU8 = AtomicU8::new(Unit::Avx512 as u8);

/// A computation over [`Lanes`]: its inputs are its fields, so that it can be handed to any vector unit.
///
/// `run` and everything below it must be `#[inline(always)]`, otherwise every operation becomes a call (thirty
/// times slower). Closures cannot be marked so: write loops, and keep operations on lanes out of `map`,
/// `array::from_fn` and the like.
///
/// ```
/// use cdpr::scalar::{Kernel, LANES, Lanes, Real, dispatch};
///
/// /// Distances from the origin to points in the plane (m); whole eights of points.
/// struct Distances<'a> {
///     x: &'a [f64],
///     y: &'a [f64],
///     distances: &'a mut [f64],
/// }
///
/// impl Kernel for Distances<'_> {
///     type Output = ();
///
///     #[inline(always)]
///     fn run<L: Lanes>(self, lanes: L) {
///         for start in (0..self.distances.len()).step_by(LANES) {
///             let (x, y) = (lanes.load(&self.x[start..]), lanes.load(&self.y[start..]));
///             (x * x + y * y).sqrt().store(&mut self.distances[start..]);
///         }
///     }
/// }
///
/// let mut distances = [0.0; 16];
/// dispatch(Distances { x: &[3.0; 16], y: &[4.0; 16], distances: &mut distances });
/// assert_eq!(distances, [5.0; 16]);
/// ```
pub trait Kernel {
    /// What the computation returns.
    type Output;

    /// The computation; `lanes` is the source of further numbers (`constant`, `load`), its value does not matter.
    fn run<L: Lanes>(self, lanes: L) -> Self::Output;
}

/// A vector unit that a [`Kernel`] can run on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Arrays, for the vector instructions that every machine of the target has.
    Portable,
    /// Two registers of four numbers (x86-64).
    Avx2,
    /// One register of eight numbers (x86-64).
    Avx512,
}

impl Unit {
    /// The units of this machine, narrowest first.
    pub fn available() -> Vec<Self> {
        [Self::Portable, Self::Avx2, Self::Avx512].into_iter().filter(|unit| unit.is_available()).collect()
    }

    /// The widest unit of this machine.
    #[inline]
    pub fn widest() -> Self {
        match (Self::Avx512.is_available(), Self::Avx2.is_available()) {
            (true, _) => Self::Avx512,
            (_, true) => Self::Avx2,
            _ => Self::Portable,
        }
    }

    /// From now on this process uses no wider unit, as on a machine that has none: to measure it, or to rule a unit out. Results do not
    /// depend on it.
    pub fn limit(widest: Self) {
        WIDEST.store(widest as u8, Ordering::Relaxed);
    }

    #[cfg(all(feature = "vectors", target_arch = "x86_64"))]
    #[inline(always)]
    fn is_allowed(self) -> bool {
        WIDEST.load(Ordering::Relaxed) >= self as u8
    }

    /// Whether this machine has the unit, and no [limit](Unit::limit) rules it out.
    pub fn is_available(self) -> bool {
        match self {
            Self::Portable => true,
            #[cfg(all(feature = "vectors", target_arch = "x86_64"))]
            Self::Avx2 => self.is_allowed() && V3::is_available(),
            #[cfg(all(feature = "vectors", target_arch = "x86_64"))]
            Self::Avx512 => self.is_allowed() && V4::is_available(),
            #[cfg(not(all(feature = "vectors", target_arch = "x86_64")))]
            Self::Avx2 | Self::Avx512 => false,
        }
    }
}

/// Runs the kernel on the widest unit of the machine. Costs a few nanoseconds: call it once per batch.
#[inline]
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(all(feature = "vectors", target_arch = "x86_64"))]
    if Unit::Avx512.is_allowed()
        && let Some(token) = V4::try_new()
    {
        return on_avx512(token, kernel);
    }
    dispatch_narrow(kernel)
}

/// Runs the kernel on the widest unit up to AVX2: the better choice for the few operations of a single pose, whose
/// divisions and roots take longer in the widest registers.
#[inline]
pub fn dispatch_narrow<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(all(feature = "vectors", target_arch = "x86_64"))]
    if Unit::Avx2.is_allowed()
        && let Some(token) = V3::try_new()
    {
        return on_avx2(token, kernel);
    }
    on_portable(kernel)
}

/// Runs the kernel on one unit; `None` when the machine does not have it.
#[inline]
pub fn dispatch_on<K: Kernel>(unit: Unit, kernel: K) -> Option<K::Output> {
    match unit {
        Unit::Portable => Some(on_portable(kernel)),
        #[cfg(all(feature = "vectors", target_arch = "x86_64"))]
        Unit::Avx2 => V3::try_new().map(|token| on_avx2(token, kernel)),
        #[cfg(all(feature = "vectors", target_arch = "x86_64"))]
        Unit::Avx512 => V4::try_new().map(|token| on_avx512(token, kernel)),
        #[cfg(not(all(feature = "vectors", target_arch = "x86_64")))]
        Unit::Avx2 | Unit::Avx512 => None,
    }
}

#[inline(always)]
fn on_portable<K: Kernel>(kernel: K) -> K::Output {
    kernel.run(Portable::new([0.0; LANES]))
}

/// A kernel with the proof of its unit. A closure would do, but closures cannot be told to inline.
#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
struct OnUnit<T, K> {
    token: T,
    kernel: K,
}

#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
impl<K: Kernel> NullaryFnOnce for OnUnit<V3, K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.kernel.run(Avx2::new(self.token))
    }
}

#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
impl<K: Kernel> NullaryFnOnce for OnUnit<V4, K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.kernel.run(Avx512::new(self.token))
    }
}

#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
#[inline(always)]
pub(super) fn on_avx2<K: Kernel>(token: V3, kernel: K) -> K::Output {
    token.vectorize(OnUnit { token, kernel })
}

#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
#[inline(always)]
pub(super) fn on_avx512<K: Kernel>(token: V4, kernel: K) -> K::Output {
    token.vectorize(OnUnit { token, kernel })
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::{Kernel, Unit, dispatch, dispatch_narrow, dispatch_on};
    use crate::scalar::{LANES, Lanes, Select};

    /// Every operation on one number type, for two operands.
    #[inline(always)]
    fn every_operation<T: Select>(a: T, b: T) -> [T; 12] {
        let less = a.is_less(b);
        let chosen = (a + b).select(less, a - b);
        [
            a + b,
            a - b,
            a * b,
            a / b,
            -a,
            a.sqrt(),
            a.full_angle(b),
            a.abs(),
            a.min(b),
            a.max(b),
            chosen,
            a.constant(0.1),
        ]
    }

    /// [`every_operation`] on whole slices, its results one after the other, and sum and `any` per eight numbers.
    struct EveryOperation<'a> {
        a: &'a [f64],
        b: &'a [f64],
    }

    impl Kernel for EveryOperation<'_> {
        type Output = (Vec<[[f64; LANES]; 12]>, Vec<(f64, bool)>);

        #[inline(always)]
        fn run<L: Lanes>(self, lanes: L) -> Self::Output {
            let chunks = || self.a.chunks_exact(LANES).zip(self.b.chunks_exact(LANES));
            let results = chunks().map(|(a, b)| every_operation(lanes.load(a), lanes.load(b)).map(Lanes::to_array));
            let reductions = chunks().map(|(a, b)| {
                let (a, b) = (lanes.load(a), lanes.load(b));
                (a.sum(), a.any(a.is_less(b)))
            });
            (results.collect(), reductions.collect())
        }
    }

    /// Two operands: all pairs of special values, then random ones; their number is a multiple of eight.
    fn operands() -> (Vec<f64>, Vec<f64>) {
        let tiny = f64::from_bits(1);
        let special = [0.0, 1.0, 0.5, 1e-310, tiny, 1e200, 1.7e308, f64::MIN_POSITIVE, f64::INFINITY, f64::NAN];
        let special: Vec<f64> = special.iter().flat_map(|&x| [x, -x]).collect();
        let mut pairs: Vec<_> = special.iter().flat_map(|&a| special.iter().map(move |&b| (a, b))).collect();
        let mut generator = ChaCha8Rng::seed_from_u64(2);
        for magnitude in [1.0, 1.0, 1e-12, 1e150] {
            pairs.extend((0..4_000).map(|_| {
                let mut next = |largest: f64| generator.random_range(-largest..largest);
                (next(magnitude), next(1.0))
            }));
        }
        assert_eq!(pairs.len() % LANES, 0);
        pairs.into_iter().unzip()
    }

    /// Equal bits, or NaN on both sides: the sign and payload of a NaN depend on the instruction.
    fn is_same(a: f64, b: f64) -> bool {
        a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
    }

    #[test]
    fn every_unit_gives_the_bits_of_f64() {
        let (a, b) = operands();
        for unit in Unit::available() {
            let (results, _) = dispatch_on(unit, EveryOperation { a: &a, b: &b }).expect("an available unit");
            for (index, (&a, &b)) in a.iter().zip(&b).enumerate() {
                let expected = every_operation(a, b);
                for operation in 0..expected.len() {
                    let found = results[index / LANES][operation][index % LANES];
                    let same = is_same(found, expected[operation]);
                    assert!(same, "operation {operation} of {a:e} and {b:e} on {unit:?}: {found:e}");
                }
            }
        }
    }

    #[test]
    fn every_unit_gives_the_same_sums_and_the_same_any() {
        let (a, b) = operands();
        let (_, expected) = dispatch_on(Unit::Portable, EveryOperation { a: &a, b: &b }).expect("always there");
        for (chunk, &(_, any)) in expected.iter().enumerate() {
            let lanes = chunk * LANES..(chunk + 1) * LANES;
            assert_eq!(any, a[lanes.clone()].iter().zip(&b[lanes]).any(|(a, b)| a < b));
        }
        for unit in Unit::available() {
            let (_, found) = dispatch_on(unit, EveryOperation { a: &a, b: &b }).expect("an available unit");
            let same = found.iter().zip(&expected).all(|(f, e)| is_same(f.0, e.0) && f.1 == e.1);
            assert!(same, "sums or any on {unit:?}");
        }
    }

    #[test]
    fn sum_adds_all_eight_lanes() {
        struct Sum;
        impl Kernel for Sum {
            type Output = f64;
            #[inline(always)]
            fn run<L: Lanes>(self, lanes: L) -> f64 {
                lanes.load(&[1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0]).sum()
            }
        }
        assert_eq!(dispatch(Sum), 255.0);
        assert_eq!(dispatch_narrow(Sum), 255.0);
    }

    #[test]
    fn store_writes_eight_numbers_and_leaves_the_rest() {
        struct Store<'a>(&'a mut [f64]);
        impl Kernel for Store<'_> {
            type Output = ();
            #[inline(always)]
            fn run<L: Lanes>(self, lanes: L) {
                lanes.constant(3.0).store(self.0);
            }
        }
        for unit in Unit::available() {
            let mut target = [1.0; 9];
            dispatch_on(unit, Store(&mut target)).expect("an available unit");
            assert_eq!(target, [3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 1.0]);
        }
    }

    #[test]
    fn a_unit_runs_exactly_when_it_is_available() {
        struct Nothing;
        impl Kernel for Nothing {
            type Output = ();
            #[inline(always)]
            fn run<L: Lanes>(self, _lanes: L) {}
        }
        for unit in [Unit::Portable, Unit::Avx2, Unit::Avx512] {
            assert_eq!(dispatch_on(unit, Nothing).is_some(), unit.is_available());
            assert_eq!(Unit::available().contains(&unit), unit.is_available());
        }
    }
}
