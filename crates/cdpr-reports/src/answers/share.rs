//! Shares of the physical workspace.

/// Reason why a share of the physical workspace may be above 100 %.
pub const BEYOND_THE_WHOLE: &str = "more than 100 % of the physical workspace: a pose counts where it is commanded, and \
    judged is what emerges; from some poses at which the machine could not be held the platform comes to rest beside them, where it can, and a \
    rigid machine has no tensions that could break a limit";

/// True for a share above 100 %.
pub fn is_beyond_the_whole(share: Option<f64>) -> bool {
    share.is_some_and(|share| share > 1.0 + 1e-9)
}

/// Key of a workspace's size with its unit.
pub(crate) fn size_key(name: &str, is_planar: bool) -> String {
    format!("{name}_{}", if is_planar { "area_m2" } else { "volume_m3" })
}
