//! Sizes of workspaces, and shares of the physical one.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// Reason why a share of the physical workspace may be above 100 %.
pub const BEYOND_THE_WHOLE: &str = "more than 100 % of the physical workspace: a pose counts where it is commanded, and \
    judged is what emerges; from some poses at which the machine could not be held the platform comes to rest beside them, where it can, and a \
    rigid machine has no tensions that could break a limit";

/// True for a share above 100 %.
pub fn is_beyond_the_whole(share: Option<f64>) -> bool {
    share.is_some_and(|share| share > 1.0 + 1e-9)
}

/// Area (m²) or volume (m³), which stands under a key with its unit: `reachable_area_m2`.
#[derive(Clone, Copy, Debug)]
pub struct Size<T = Option<f64>> {
    /// Name before the unit; empty for none.
    pub name: &'static str,
    /// True for an area.
    pub is_planar: bool,
    /// Number, or several.
    pub value: T,
}

impl<T> Size<T> {
    /// The key.
    pub(crate) fn key(&self) -> String {
        let quantity = if self.is_planar { "area_m2" } else { "volume_m3" };
        if self.name.is_empty() { quantity.to_owned() } else { format!("{}_{quantity}", self.name) }
    }

    /// Unit for people.
    pub(crate) fn unit(&self) -> &'static str {
        if self.is_planar { "m²" } else { "m³" }
    }
}

impl<T: Serialize> Serialize for Size<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(1))?;
        map.serialize_entry(&self.key(), &self.value)?;
        map.end()
    }
}
