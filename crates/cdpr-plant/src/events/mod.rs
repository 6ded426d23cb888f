//! Events: instantaneous changes of a machine. One file each, and a row in one table.

mod cable_break;
mod entries;
mod entry;
mod friction_change;
mod happening;
mod load_change;
mod slip;
mod winch_stop;
mod wrench_change;

pub use cable_break::CableBreak;
pub use entry::EventTable;
pub use friction_change::FrictionChange;
pub use happening::{Event, Happening, LoadChange};
pub use slip::Slip;
pub use winch_stop::WinchStop;
pub use wrench_change::WrenchChange;
