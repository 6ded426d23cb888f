//! A robot as data: geometry, cables, limits and where the numbers come from.

mod description;

pub use description::{Cable, ExternalWrench, Platform, ReferenceCheck, Robot, Source, StiffnessBasis, TravelBox};
