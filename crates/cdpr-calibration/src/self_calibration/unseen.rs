//! Findings about held numbers that the data do not determine: the change of the poses that they allow, and the distance to measure.

use nalgebra::DMatrix;

use super::distances::Distance;
use super::predicted_band::{At, Information, PredictedBand};
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::measurement::three_digits;
use cdpr_model::robot::ParameterKind;
use cdpr_model::scalar::decomposition::symmetric_eigen;

/// Band of predicted poses, as a share of the sampled region's diagonal, beyond which they are not to be trusted.
const LARGEST_SHARE: f64 = 0.01;
/// Change of the poses, as a share of the parameters' own band, below which other held numbers than the scale are not told.
const TOLD: f64 = 0.5;

/// Numbers of one kind that data do not see, and their effect.
struct Unseen {
    /// Directions of the numbers that data tell less than their accuracy does.
    directions: usize,
    numbers: usize,
    /// Change of the sampled positions, as root mean square and at most (m).
    change: [f64; 2],
    /// Change of a residual in units of its noise, as root mean square.
    noise: f64,
}

impl At<'_, '_> {
    /// Bands of predicted poses with what the data cannot see; `None` if poses do not follow the parameters, or there is only one.
    pub(super) fn predicted_band(&self) -> Option<PredictedBand> {
        let information = self.information()?;
        let mut band = information.band(self.poses)?;
        let best = Distance::best(self, &information);
        let mut remedy = best.map_or_else(String::new, |best| format!("; {}", best.words(self, &band)));
        if band.share() > LARGEST_SHARE {
            band.findings.push(band.too_wide(&std::mem::take(&mut remedy)));
        }
        let mut first = information.free;
        for held in &information.held {
            let unseen = information.unseen(first, held.numbers.len());
            first += held.numbers.len();
            let Some(unseen) = unseen else { continue };
            let is_scale = held.kind == ParameterKind::LengthScale;
            let is_told = is_scale || unseen.change[0] > TOLD * band.by_parameters_m;
            // the accuracy of poses that were found
            if !is_told || unseen.change[0] < NOTHING * band.diagonal_m {
                continue;
            }
            let share = unseen.change[0] / band.diagonal_m;
            let severity = if share > LARGEST_SHARE { Severity::Distrust } else { Severity::Caution };
            let which = match unseen.numbers {
                1 => String::new(),
                all => format!("{} of {all} directions of ", unseen.directions),
            };
            let text = format!(
                "these data cannot see {which}{}: it changes residuals by {} of their noise and the sampled poses by {} mm (rms; {} mm at most), {} % of the diagonal of \
                 the sampled region{}; an accuracy of your own: {}",
                held.words(),
                three_digits(unseen.noise),
                three_digits(1e3 * unseen.change[0]),
                three_digits(1e3 * unseen.change[1]),
                three_digits(100.0 * share),
                std::mem::take(&mut remedy),
                held.remedy()
            );
            band.findings.push(Finding::new(FindingKind::Unseen, severity, text).of_size(unseen.change[0], "m"));
        }
        Some(band)
    }
}

impl PredictedBand {
    /// Finding of a band that nobody should work with, and what narrows it.
    fn too_wide(&self, remedy: &str) -> Finding {
        let words = format!(
            "not to be trusted: predicted poses may be {} mm off (rms; {} mm by parameters, {} mm by held numbers), beyond 1 % of the diagonal of the sampled region, {} m{remedy}",
            three_digits(1e3 * self.band_m),
            three_digits(1e3 * self.by_parameters_m),
            three_digits(1e3 * self.by_held_m),
            three_digits(self.diagonal_m)
        );
        Finding::new(FindingKind::Unseen, Severity::Distrust, words).of_size(self.band_m, "m")
    }
}

/// Change of the poses, beside the sampled region's diagonal, that is none.
const NOTHING: f64 = 1e-6;

impl Information {
    /// Unseen directions of some of the columns; `None` if the data tell all of them better than their accuracies do.
    fn unseen(&self, first: usize, count: usize) -> Option<Unseen> {
        let own = self.covariance.view((first, first), (count, count)).into_owned();
        // what data and the other numbers tell of them
        let told = own.try_inverse()? - DMatrix::identity(count, count);
        let found = symmetric_eigen(told)?;
        let places: Vec<usize> = (0..count).filter(|k| found.eigenvalues[*k] < 1.0).collect();
        if places.is_empty() {
            return None;
        }
        let directions = DMatrix::from_fn(count, places.len(), |row, k| found.eigenvectors[(row, places[k])]);
        // parameters follow
        let across = self.matrix.view((0, first), (self.free, count)) * &directions;
        let following = if self.free == 0 { across.clone() } else { self.of_free()?.solve(&across) };
        let fields = self.fields.columns(first, count) * &directions - self.fields.columns(0, self.free) * &following;
        let samples = self.samples();
        let square = |sample: usize| fields.rows(3 * sample, 3).norm_squared();
        let squares: Vec<f64> = (0..samples).map(square).collect();
        let mean = squares.iter().sum::<f64>() / samples as f64;
        let largest = squares.iter().copied().fold(0.0, f64::max);
        let priors = places.len() as f64;
        let seen = (directions.tr_mul(&(self.matrix.view((first, first), (count, count)) * &directions))).trace()
            - priors
            - across.dot(&following);
        Some(Unseen {
            directions: places.len(),
            numbers: count,
            change: [mean.sqrt(), largest.sqrt()],
            noise: (seen.max(0.0) / self.rows as f64).sqrt(),
        })
    }
}
