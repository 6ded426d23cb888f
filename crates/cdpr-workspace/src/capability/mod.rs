//! Payload, acceleration and speed that a robot has everywhere in a box of positions.
//!
//! At one pose the available wrench set W (see [`wrench_set`](crate::wrench_set)) answers the first two. Each of its
//! half-spaces n · w ≤ d leaves the load w₀ of the robot the room d − n · w₀; a quantity λ asks of it λ s(n), with s(n)
//! the largest n · w of what the unit of the quantity adds: the weight of 1 kg, or −\[m a; R c × m a\] for every
//! acceleration |a| ≤ 1 (Newton at rest: no turning, so no moment about the center of mass). So λ is the least
//! (d − n · w₀)/s(n) over all half-spaces with s(n) > 0, as the linear programme in λ and the tensions has it. The speed
//! is the least limit of a cable over the norm of its row of the length Jacobian by translations, in any direction.
//!
//! Over a box the least value is sought by branch and bound. A cell with the centre c has these bounds: for a corner v of
//! W(c) with the tensions f, W(r) contains −Aᵀ(r) f. A direction n in the normal cone of v is a sum of the normals nₖ of its
//! facets with factors of zero or more, so that W(r) contains w₀ + λ K if for every facet k
//!
//! ```text
//! nₖ · w₀ + λ s(nₖ) ≤ dₖ − sup nₖ · (Aᵀ(r) − Aᵀ(c)) f
//! ```
//!
//! with the supremum over positions r of the cell and tensions f of the facet: those of its cables that stand at a limit, and
//! any within limits of the others. Directions of cables are replaced by their first-order change with a bound of the second
//! derivative (`turning`), and what changes all columns alike is taken out before (`bound`). So the lower bound holds for
//! every position of the box, to rounding, and comes nearer to the value with the square of the size of a cell.

mod bound;
mod demand;
mod face;
mod limit;
mod pose;
mod question;
mod search;
#[cfg(test)]
mod tests;
mod turning;

pub use demand::{Absent, Quantity};
pub use limit::{Limit, LimitedBy, NotHeld};
pub use question::Capability;
pub use search::{Found, Settings, Solution, Status};
