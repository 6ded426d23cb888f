//! Quantities of the answer, and reasons why some are open.

/// Numbers of the answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Quantity {
    /// Torque of the load.
    Load,
    /// a of several given loads.
    LoadScale,
    /// b of several given loads.
    LoadOffset,
    /// Coulomb friction.
    Coulomb,
    /// Its growth with the load.
    CoulombByLoad,
    /// Its difference between lifting and lowering.
    CoulombByDirection,
    /// Friction per speed.
    Viscous,
    /// Standing friction.
    Static,
    /// Stribeck speed.
    StribeckSpeed,
}

impl Quantity {
    /// The key of answers.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Load => "load_Nm",
            Self::LoadScale => "load_scale",
            Self::LoadOffset => "load_offset_Nm",
            Self::Coulomb => "coulomb_Nm",
            Self::CoulombByLoad => "coulomb_by_load",
            Self::CoulombByDirection => "coulomb_by_direction",
            Self::Viscous => "viscous_Nm_s_per_rad",
            Self::Static => "static_Nm",
            Self::StribeckSpeed => "stribeck_speed_rad_per_s",
        }
    }
}

/// A quantity that records do not tell.
#[derive(Clone, Debug, PartialEq)]
pub struct Undetermined {
    /// The quantity.
    pub quantity: Quantity,
    /// Why, with numbers, and what to record.
    pub reason: String,
}
