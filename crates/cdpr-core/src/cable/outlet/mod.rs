//! Outlets: the points or pulleys where cables leave the frame.

pub mod bent;
mod contact;
pub mod point;
pub mod pulley;

pub use contact::{Contact, ContactByPose};

use super::path::{CablePath, GeometryError};
use crate::scalar::{LANES, Lanes, Real, dot, scale, sub};

/// Outlet of one cable by numbers T, or of several cables if T holds lanes or arrays of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outlet<T> {
    /// The cable runs straight from the frame anchor.
    Point {
        /// a (world, m).
        frame_anchor: [T; 3],
    },
    /// The cable wraps a pulley whose plane turns with the platform anchor about the swivel axis.
    Swivel {
        /// D, where the cable enters the pulley (world, m).
        frame_anchor: [T; 3],
        /// z_A (unit vector, world).
        swivel_axis: [T; 3],
        /// r_p (m).
        radius: T,
    },
    /// The cable wraps a pulley that does not swivel (planar robots).
    Sided {
        /// D, where the cable enters the pulley (world, m).
        frame_anchor: [T; 3],
        /// z_A (unit vector, world).
        swivel_axis: [T; 3],
        /// x_A, from D to the centre of the pulley (unit vector, world).
        side: [T; 3],
        /// r_p (m).
        radius: T,
    },
}

impl<T> Outlet<T> {
    /// Frame anchor a of a point, or D where the cable enters the pulley (world, m).
    #[inline]
    pub fn frame_anchor(&self) -> &[T; 3] {
        match self {
            Self::Point { frame_anchor } | Self::Swivel { frame_anchor, .. } | Self::Sided { frame_anchor, .. } => {
                frame_anchor
            }
        }
    }

    /// Mutable access to [`Outlet::frame_anchor`].
    #[inline]
    pub fn frame_anchor_mut(&mut self) -> &mut [T; 3] {
        match self {
            Self::Point { frame_anchor } | Self::Swivel { frame_anchor, .. } | Self::Sided { frame_anchor, .. } => {
                frame_anchor
            }
        }
    }

    /// Mutable access to the radius r_p of the pulley (m); `None` for a point outlet.
    #[inline]
    pub fn radius_mut(&mut self) -> Option<&mut T> {
        match self {
            Self::Point { .. } => None,
            Self::Swivel { radius, .. } | Self::Sided { radius, .. } => Some(radius),
        }
    }

    /// Swivel axis z_A and radius r_p of the pulley (m); `None` for a point outlet.
    #[inline]
    pub fn pulley(&self) -> Option<(&[T; 3], &T)> {
        match self {
            Self::Point { .. } => None,
            Self::Swivel { swivel_axis, radius, .. } | Self::Sided { swivel_axis, radius, .. } => {
                Some((swivel_axis, radius))
            }
        }
    }

    /// The outlet with each number converted by `of`.
    #[inline(always)]
    pub fn map<U>(&self, of: impl Fn(&T) -> U + Copy) -> Outlet<U> {
        let vector = |[x, y, z]: &[T; 3]| [of(x), of(y), of(z)];
        match self {
            Self::Point { frame_anchor } => Outlet::Point { frame_anchor: vector(frame_anchor) },
            Self::Swivel { frame_anchor, swivel_axis, radius } => Outlet::Swivel {
                frame_anchor: vector(frame_anchor),
                swivel_axis: vector(swivel_axis),
                radius: of(radius),
            },
            Self::Sided { frame_anchor, swivel_axis, side, radius } => Outlet::Sided {
                frame_anchor: vector(frame_anchor),
                swivel_axis: vector(swivel_axis),
                side: vector(side),
                radius: of(radius),
            },
        }
    }
}

impl<T: Real> Outlet<T> {
    /// Path of the straight, rigid cable to a platform anchor (world, m); its numbers are not finite if there is no
    /// path.
    #[inline(always)]
    pub fn path(&self, platform_anchor: [T; 3]) -> CablePath<T> {
        match *self {
            Self::Point { frame_anchor } => point::path(frame_anchor, platform_anchor),
            Self::Swivel { frame_anchor, swivel_axis, radius } => {
                pulley::path(frame_anchor, swivel_axis, radius, platform_anchor)
            }
            Self::Sided { frame_anchor, swivel_axis, side, radius } => {
                pulley::path_on_side(frame_anchor, swivel_axis, side, radius, platform_anchor)
            }
        }
    }
}

impl Outlet<f64> {
    /// Reason why the cable with this path to a platform anchor (world, m) has no unique path, `None` if it has one;
    /// `cable` is its number, from 1.
    #[inline]
    pub fn degeneracy(&self, cable: usize, platform_anchor: [f64; 3], path: &CablePath<f64>) -> Option<GeometryError> {
        let d = sub(platform_anchor, *self.frame_anchor());
        let distance = dot(d, d).sqrt();
        if !distance.is_finite() {
            return Some(GeometryError::NotFinite { cable });
        }
        let radius = match *self {
            Self::Point { .. } => {
                // one of the two may round to zero without the other
                let is_zero = distance == 0.0 || !(path.length > 0.0);
                return is_zero.then_some(GeometryError::ZeroLength { cable });
            }
            Self::Sided { swivel_axis, side, radius, .. } => {
                if dot(side, d) < 0.0 && dot(swivel_axis, d) > 0.0 {
                    return Some(GeometryError::OpenSide { cable });
                }
                radius
            }
            Self::Swivel { swivel_axis, radius, .. } => {
                let across = sub(d, scale(dot(swivel_axis, d), swivel_axis));
                // so near the axis that rounding hides on which side the anchor lies
                if radius > 0.0 && dot(across, across).sqrt() <= pulley::ON_AXIS * (distance + radius) {
                    return Some(GeometryError::OnSwivelAxis { cable });
                }
                radius
            }
        };
        match path.length.is_finite() && path.free_length > 0.0 {
            true => None,
            false if radius == 0.0 => Some(GeometryError::ZeroLength { cable }),
            false => Some(GeometryError::InsidePulley { cable, radius }),
        }
    }
}

/// Bounds of distances that are certainly neither zero nor too large (m).
const SHORTEST: f64 = 1e-100;
const LONGEST: f64 = 1e100;
/// Sine of the angle from the swivel axis, or from the edge of the open side, that is far above rounding.
const CLEAR: f64 = 1e-6;

impl<L: Lanes> Outlet<L> {
    /// 0 if a path certainly exists, 1 if [`Outlet::degeneracy`] of the single cable must decide.
    #[inline(always)]
    pub fn needs_scalar(&self, platform_anchor: [L; 3], path: &CablePath<L>) -> L {
        let l = path.length;
        let (zero, one) = (l.constant(0.0), l.constant(1.0));
        let is_clear = |least: L, distance: L| zero.select(least.is_less(distance), one);
        // the outlet computes the same terms, so the compiler shares them
        let needs_scalar = match *self {
            Self::Point { .. } => zero,
            Self::Swivel { frame_anchor, swivel_axis, radius } => {
                let d = sub(platform_anchor, frame_anchor);
                let across = sub(d, scale(dot(d, swivel_axis), swivel_axis));
                is_clear((dot(d, d) + radius * radius) * l.constant(CLEAR * CLEAR), dot(across, across))
            }
            Self::Sided { frame_anchor, swivel_axis, side, .. } => {
                let d = sub(platform_anchor, frame_anchor);
                // on the closed side, or below the edge
                is_clear(dot(d, d).sqrt() * l.constant(CLEAR), dot(d, side).max(-dot(d, swivel_axis)))
            }
        };
        // NaN fails both comparisons
        let needs_scalar = needs_scalar.select(l.constant(SHORTEST).is_less(path.free_length), one);
        needs_scalar.select(path.length.is_less(l.constant(LONGEST)), one)
    }
}

impl Outlet<[f64; LANES]> {
    /// Outlets of one kind packed into lanes; lanes beyond the last outlet repeat it.
    #[inline]
    pub fn pack(outlets: &[Outlet<f64>]) -> Self {
        let at = |lane: usize| &outlets[lane.min(outlets.len() - 1)];
        let vectors = |of: &dyn Fn(&Outlet<f64>) -> [f64; 3]| {
            [0, 1, 2].map(|axis| core::array::from_fn(|lane| of(at(lane))[axis]))
        };
        let frame_anchor = vectors(&|outlet| *outlet.frame_anchor());
        let swivel_axis = || vectors(&|outlet| outlet.pulley().map_or([0.0; 3], |(axis, _)| *axis));
        let radius = || core::array::from_fn(|lane| at(lane).pulley().map_or(0.0, |(_, radius)| *radius));
        match *at(0) {
            Outlet::Point { .. } => Self::Point { frame_anchor },
            Outlet::Swivel { .. } => Self::Swivel { frame_anchor, swivel_axis: swivel_axis(), radius: radius() },
            Outlet::Sided { side: first, .. } => Self::Sided {
                frame_anchor,
                swivel_axis: swivel_axis(),
                side: vectors(&|outlet| if let Outlet::Sided { side, .. } = outlet { *side } else { first }),
                radius: radius(),
            },
        }
    }

    /// The packed outlets in lanes.
    #[inline(always)]
    pub fn load<L: Lanes>(&self, l: L) -> Outlet<L> {
        self.map(|lanes| l.load(lanes))
    }

    /// One of the packed outlets in all lanes.
    #[inline(always)]
    pub fn spread<L: Lanes>(&self, l: L, lane: usize) -> Outlet<L> {
        self.map(|lanes| l.constant(lanes[lane]))
    }
}
