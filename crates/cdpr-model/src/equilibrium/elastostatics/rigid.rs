//! Cables that do not stretch.

/// Which cables do not stretch, and the lengths they may have at most.
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
