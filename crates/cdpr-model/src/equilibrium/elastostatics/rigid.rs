//! Cables that do not stretch.

/// Flags of the cables that do not stretch, and the largest lengths that they allow (m).
#[derive(Clone, Copy, Debug)]
pub(super) struct Rigid<'a> {
    pub(super) lengths: &'a [f64],
    pub(super) is_rigid: &'a [bool],
}

impl Rigid<'_> {
    pub(super) fn any(&self) -> bool {
        self.is_rigid.contains(&true)
    }

    /// Numbers of the rigid cables, from 0.
    pub(super) fn cables(&self) -> impl Iterator<Item = usize> {
        (0..self.lengths.len()).filter(|&cable| self.is_rigid[cable])
    }
}
