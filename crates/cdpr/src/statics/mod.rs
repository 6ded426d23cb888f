//! Forces at one pose: the load on the platform and what balances it.

mod load;

pub use load::{Load, LoadError};
