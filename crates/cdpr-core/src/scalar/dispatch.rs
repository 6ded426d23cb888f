//! Runs a computation on the widest vector unit of the machine, found at run time.

use core::sync::atomic::{AtomicU8, Ordering};

#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
use pulp::x86::{V3, V4};

use super::lanes::{Kernel, LANES};
use super::portable::Portable;
#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
use super::{avx2::on_avx2, avx512::on_avx512};

/// The widest unit that may be used, by its index in the order of [`Unit`].
static WIDEST: AtomicU8 = AtomicU8::new(Unit::Avx512 as u8);

/// A vector unit that a [`Kernel`] can run on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Arrays, compiled for the vector instructions of every machine of the target.
    Portable,
    /// Two registers of four numbers (x86-64).
    Avx2,
    /// One register of eight numbers (x86-64).
    Avx512,
}

impl Unit {
    /// The units of this machine that may be used, narrowest first.
    #[inline]
    pub fn available() -> impl Iterator<Item = Self> {
        [Self::Portable, Self::Avx2, Self::Avx512].into_iter().filter(|unit| unit.is_available())
    }

    /// The widest unit of this machine that may be used.
    #[inline]
    pub fn widest() -> Self {
        match (Self::Avx512.is_available(), Self::Avx2.is_available()) {
            (true, _) => Self::Avx512,
            (_, true) => Self::Avx2,
            _ => Self::Portable,
        }
    }

    /// Limits this process to units up to `widest`, as on a machine without wider ones, for measurements or to rule a
    /// unit out. Results do not depend on it.
    pub fn limit(widest: Self) {
        WIDEST.store(widest as u8, Ordering::Relaxed);
    }

    #[cfg(all(feature = "vectors", target_arch = "x86_64"))]
    #[inline]
    fn is_allowed(self) -> bool {
        WIDEST.load(Ordering::Relaxed) >= self as u8
    }

    /// True if this machine has the unit and no [limit](Unit::limit) rules it out.
    #[inline]
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
