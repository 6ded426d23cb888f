//! Running a computation on the widest vector unit of the machine, found at run time.

use core::sync::atomic::{AtomicU8, Ordering};

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
/// use cdpr_core::scalar::{Kernel, LANES, Lanes, Real, dispatch};
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
    /// Type of the result.
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
    pub fn available() -> impl Iterator<Item = Self> {
        [Self::Portable, Self::Avx2, Self::Avx512].into_iter().filter(|unit| unit.is_available())
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
