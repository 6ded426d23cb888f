//! Controllers that a scenario selects by a word: one file each, and a row in one table.

mod entries;
mod entry;
mod length_changes;
mod lengths;
mod torques;

pub use entry::Control;

pub(super) use entry::ControlSetting;
