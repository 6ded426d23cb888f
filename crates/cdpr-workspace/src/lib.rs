//! Workspaces: criteria that judge one pose, and methods that find the set of poses at which they hold.
//!
//! A [`Criterion`] answers a pose with a [`Verdict`]: a signed margin and, if it fails, the first reason in words. A
//! [`Region`] applies it to positions, in one orientation or a set of them. [`grid`] counts cells, [`octree`] refines
//! them at the boundary only, and [`hull`] follows rays from a centre to the boundary. An [`Audit`] bounds the error of
//! any of them, and [`refine`](mod@refine) reduces it. A [`capability`] is asked the other way round: what the robot can
//! do everywhere in a given box.

mod audit;
mod bounds;
pub mod capability;
mod closer_bounds;
mod components;
pub mod criterion;
pub mod differential;
mod error;
mod error_code;
pub mod grid;
pub mod hull;
pub mod mesh;
pub mod octree;
mod point;
pub mod refine;
mod region;
mod singular;
mod surface;
mod verdict;
mod workspace;
pub mod wrench_set;

pub use audit::{Audit, CONFIDENCE};
pub use bounds::Bounds;
pub use components::{Component, components};
pub use criterion::Criterion;
pub use error::WorkspaceError;
pub use point::Point;
pub use region::{Archetype, Region, Side};
pub use singular::largest_rank;
pub use surface::Cells;
pub use verdict::Verdict;
pub use workspace::{Workspace, WorkspaceSize};
