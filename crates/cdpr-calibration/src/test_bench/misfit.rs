//! Error of a law on a record.

/// Error of a law on the record (N).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Misfit {
    /// Root of the mean square.
    pub rms: f64,
    /// Largest magnitude.
    pub max: f64,
}

impl Misfit {
    pub(super) fn of(residuals: impl Iterator<Item = f64>) -> Self {
        let (mut count, mut squares, mut max) = (0.0_f64, 0.0, 0.0_f64);
        for residual in residuals {
            count += 1.0;
            squares += residual * residual;
            max = max.max(residual.abs());
        }
        Self { rms: (squares / count.max(1.0)).sqrt(), max }
    }
}
