//! The wrenches that cables can balance within their limits, and the ones that a task asks for.
//!
//! With tensions in f_min ≤ f ≤ f_max a pose has the *available* external wrenches W = {−Aᵀ f}: the image of a box, a
//! [`Zonotope`]. Its half-spaces come from shifting hyperplanes (Bouchard, Gosselin, Moore 2010; Gouttefarde, Krut 2010): each
//! facet is parallel to n − 1 independent columns of Aᵀ, and its place is where all other cables stand at one of their limits. A
//! [`RequiredSet`] lies in W when its furthest point along each facet's normal does; the least distance left is the *capacity
//! margin* (Guay, Cardou, Cruz-Ruiz, Caro 2014). It compares forces with moments, so it needs a length: moments are divided by it.

mod facets;
mod margin;
mod payload;
mod required;
#[cfg(test)]
mod tests;
mod vertices;
mod zonotope;

pub use margin::{HalfSpace, Margin};
pub use payload::{Payload, PayloadError};
pub use required::{Parallelotope, RequiredSet};
pub use vertices::Vertex;
pub(crate) use zonotope::most_hyperplanes;
pub use zonotope::{CABLE_LIMIT, row_lengths};
pub use zonotope::{WrenchSetError, Zonotope};
