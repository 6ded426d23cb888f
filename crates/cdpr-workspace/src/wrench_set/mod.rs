//! The wrenches that cables can balance within their limits, and those that a task requires.
//!
//! With tensions in f_min ≤ f ≤ f_max a pose has the *available* external wrenches W = {−Aᵀ f}: the image of a box, a
//! [`Zonotope`]. Its half-spaces come from shifting hyperplanes (Bouchard, Gosselin, Moore 2010; Gouttefarde, Krut
//! 2010): each facet is parallel to n − 1 independent columns of Aᵀ, and on it all other cables are at one of their
//! limits. A [`RequiredSet`] lies in W if its furthest point along each facet's normal does; the least remaining
//! distance is the *capacity margin* (Guay, Cardou, Cruz-Ruiz, Caro 2014). It compares forces with moments, so moments
//! are divided by a length.

mod facets;
mod margin;
mod payload;
mod required;
#[cfg(test)]
mod tests;
mod vertices;
mod zonotope;

pub(crate) use margin::FacetView;
pub use margin::{HalfSpace, Margin};
pub use payload::{Payload, PayloadError};
pub use required::{Parallelotope, RequiredSet};
pub use vertices::Vertex;
pub(crate) use zonotope::most_hyperplanes;
pub use zonotope::{CABLE_LIMIT, row_lengths};
pub use zonotope::{WrenchSetError, Zonotope};
