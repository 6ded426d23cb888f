//! Numbers of a robot that were neither published nor measured: assumptions, each with its reason.

use serde::{Deserialize, Serialize};

/// Assumed number of a robot file: no source states it and nobody measured it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Assumption {
    /// Key with its table: `platform.mass_kg`; `cable.drum_inertia_kg_m2` of every cable that states it, `cable[1,3].drum_inertia_kg_m2` of these (from 1); `gravity_m_s2`.
    pub key: String,
    /// Reason for the value, in a line.
    pub reason: String,
}

impl Assumption {
    /// Key without table and cables: `mass_kg`.
    pub fn plain_key(&self) -> &str {
        self.key.rsplit('.').next().unwrap_or_default()
    }
}
