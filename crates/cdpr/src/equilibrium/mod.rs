//! Forward problems: which pose follows from the cables.

pub mod forward_kinematics;
