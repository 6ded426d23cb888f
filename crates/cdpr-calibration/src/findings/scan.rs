//! One search of the residuals by cable, time and place, and the explanation that beats the others.

use nalgebra::{DMatrix, DVector};

use super::cause::{Cause, Explained, Explanation, Spread};
use super::examined::Examined;
use super::residual_table::{CableResiduals, ResidualTable};
use crate::autocorrelation::correlation_time;
use cdpr_model::finding::Finding;
use cdpr_model::scalar::decomposition::symmetric_eigen;

/// Least score of an explanation in an answer: the logarithm of its likelihood ratio less the price of its parameters and of the places tried.
const SURE: f64 = 15.0;
/// The same by which it has to beat the runner-up to be told as the cause.
const CLEARLY: f64 = 6.0;
/// Least fraction of the residuals' squares that an explanation has to account for: what depends on the pose looks a little like anything.
const LEAST_EXPLAINED: f64 = 0.5;
/// Root mean square residual of a cable beside the others from which on its sensor is suspicious.
const LOUDER: f64 = 3.0;
/// Fewest rows on either side of a step, and most places at which one is tried before it is refined.
const LEAST_SIDE: usize = 6;
const PLACES: usize = 100;
/// Dead bands that are tried, each √2 times as wide as the one before, and half the width of the first (m).
const DEAD_BANDS: i32 = 16;
const NARROWEST: f64 = 2e-4;
/// Residuals below this are rounding (m).
const ROUNDING: f64 = 1e-6;

/// The explanation that beats the others for the residuals of the richest fit; `None` where they look like noise.
pub(super) fn finding(examined: &Examined<'_>) -> Option<Finding> {
    Search { examined, table: ResidualTable::of(examined)? }.finding()
}

/// Search of the residuals of the richest fit.
pub(super) struct Search<'a> {
    pub(super) examined: &'a Examined<'a>,
    pub(super) table: ResidualTable,
}

impl Search<'_> {
    fn finding(&self) -> Option<Finding> {
        if (self.table.squares / self.table.freedom).sqrt() < ROUNDING {
            return None;
        }
        let mut all = self.explanations();
        all.retain(|one| one.score > SURE && one.explained > LEAST_EXPLAINED);
        all.sort_by(|a, b| b.score.total_cmp(&a.score));
        let best = all.first()?.clone();
        let redundant = self.is_redundant();
        let is_other = |other: &Explanation| {
            let is_same =
                other.cause.is_form_of(best.cause) || other.cause.kind(redundant) == best.cause.kind(redundant);
            !is_same || other.cable != best.cable
        };
        let rivals: Vec<&Explanation> =
            all[1..].iter().filter(|other| other.score > best.score - CLEARLY && is_other(other)).collect();
        Some(self.told(&best, &rivals))
    }

    fn explanations(&self) -> Vec<Explanation> {
        let mut all = Vec::new();
        let steps = self.best_steps();
        all.extend(steps);
        all.extend(self.held_out());
        let clock = self.clock();
        for (cable, own) in self.table.cables.iter().enumerate() {
            all.extend(self.of_cable(Cause::Drift, cable, own, &clock, 1.0));
            all.extend(self.of_cable(Cause::Backlash, cable, own, &own.travel(), 1.0));
            all.extend(self.dead_band(cable, own));
            all.extend(self.loud(cable, own));
        }
        all.extend(self.of_each(Cause::Drifts, None, &|_| clock.clone()));
        all.extend(self.of_each(Cause::Backlashes, None, &CableResiduals::travel));
        all.extend(self.late());
        all
    }

    /// Times of the rows (s) where the samples have them, else their numbers.
    fn clock(&self) -> DVector<f64> {
        let samples = self.examined.samples;
        let at = |&row: &usize| samples.time.as_ref().map_or(row as f64, |time| time[row]);
        DVector::from_iterator(self.table.rows.len(), self.table.rows.iter().map(at))
    }

    pub(super) fn duration(&self) -> f64 {
        let clock = self.clock();
        clock.max() - clock.min()
    }

    /// The best step of one cable, of all of them, and of the tracker.
    fn best_steps(&self) -> Vec<Explanation> {
        let rows = self.table.rows.len();
        let side = LEAST_SIDE.max(rows / 50);
        if rows < 2 * side + 2 {
            return Vec::new();
        }
        let stride = (rows / PLACES).max(1);
        let coarse: Vec<usize> = (side..rows - side).step_by(stride).collect();
        let tried = (rows - 2 * side) as f64;
        let column = |first: usize| DVector::from_fn(rows, |row, _| f64::from(u8::from(row >= first)));
        let at = |first: usize| -> Vec<Explanation> {
            let own = column(first);
            let cables = self.table.cables.iter().enumerate();
            let mut found: Vec<Explanation> =
                cables.filter_map(|(cable, data)| self.of_cable(Cause::Step, cable, data, &own, tried)).collect();
            found.extend(self.of_each(Cause::Offsets, Some(tried), &|_| own.clone()));
            found.extend(self.tracker(first, tried));
            found.iter_mut().for_each(|one| one.first = Some(first));
            found
        };
        let best_of = |places: &[usize]| -> Vec<Explanation> {
            let mut best: Vec<Explanation> = Vec::new();
            for one in places.iter().flat_map(|&first| at(first)) {
                match best.iter_mut().find(|other| (other.cause, other.cable) == (one.cause, one.cable)) {
                    Some(other) if one.score > other.score => *other = one,
                    Some(_) => {}
                    None => best.push(one),
                }
            }
            best
        };
        let best = best_of(&coarse);
        if stride == 1 {
            return best;
        }
        let mut near: Vec<usize> = best
            .iter()
            .filter(|one| one.score > SURE)
            .filter_map(|one| one.first)
            .flat_map(|first| first.saturating_sub(stride).max(side)..(first + stride).min(rows - side))
            .collect();
        near.sort_unstable();
        near.dedup();
        best_of(&[coarse, near].concat())
    }

    /// A constant of every cable in the data that are held out.
    fn held_out(&self) -> Option<Explanation> {
        if self.examined.held_out.is_empty() {
            return None;
        }
        let is_held = |row: &usize| self.examined.held_out.binary_search(row).is_ok();
        let column = DVector::from_iterator(
            self.table.rows.len(),
            self.table.rows.iter().map(|row| f64::from(u8::from(is_held(row)))),
        );
        let first = self.table.rows.iter().position(is_held)?;
        let found = self.of_each(Cause::HeldOut, None, &|_| column.clone())?;
        Some(Explanation { first: Some(first), ..found })
    }

    /// One column explains one cable.
    fn of_cable(
        &self,
        cause: Cause,
        cable: usize,
        own: &CableResiduals,
        column: &DVector<f64>,
        tried: f64,
    ) -> Option<Explanation> {
        let part = own.own_part(column.clone())?;
        let size = part.dot(&own.residuals) / part.norm_squared();
        let gain = size * size * part.norm_squared();
        let left: DVector<f64> = &own.residuals - &part * size;
        let explained =
            Explained { gain, of: own.squares, parameters: 1.0, tried: tried * self.table.cables.len() as f64 };
        let spread =
            Spread { part: (gain / own.freedom).sqrt(), left: ((own.squares - gain).max(0.0) / own.freedom).sqrt() };
        let told = part.dot(&own.unclipped) / part.norm_squared();
        Some(self.explanation(cause, Some(cable), told, explained, spread, correlation_time(left.as_slice())))
    }

    /// A dead band of the width that explains one cable best.
    fn dead_band(&self, cable: usize, own: &CableResiduals) -> Option<Explanation> {
        let widths = (0..DEAD_BANDS).map(|step| NARROWEST * 2.0_f64.powf(f64::from(step) / 2.0));
        let of_width = |half: f64| self.of_cable(Cause::DeadBand, cable, own, &own.behind(half), f64::from(DEAD_BANDS));
        widths.filter_map(of_width).max_by(|a, b| a.score.total_cmp(&b.score))
    }

    /// A column of each cable with a size of its own explains all of them.
    fn of_each(
        &self,
        cause: Cause,
        tried: Option<f64>,
        column: &dyn Fn(&CableResiduals) -> DVector<f64>,
    ) -> Option<Explanation> {
        let (mut gain, mut sizes, mut count, mut time) = (0.0, 0.0, 0.0, 1.0_f64);
        for own in &self.table.cables {
            let Some(part) = own.own_part(column(own)) else { continue };
            let size = part.dot(&own.residuals) / part.norm_squared();
            let left: DVector<f64> = &own.residuals - &part * size;
            time = time.max(correlation_time(left.as_slice()));
            gain += size * size * part.norm_squared();
            sizes += size * size;
            count += 1.0;
        }
        if count < 2.0 {
            return None;
        }
        let size = f64::sqrt(sizes / count);
        let explained = Explained { gain, of: self.table.squares, parameters: count, tried: tried.unwrap_or(1.0) };
        Some(self.explanation(cause, None, size, explained, self.spread(gain), time))
    }

    /// A motion of the tracker's frame from a row on explains all cables.
    fn tracker(&self, first: usize, tried: f64) -> Option<Explanation> {
        let rows = self.table.rows.len();
        let (mut normal, mut right) = (DMatrix::zeros(6, 6), DVector::zeros(6));
        for own in &self.table.cables {
            let parts: Vec<DVector<f64>> = (0..6)
                .map(|component| {
                    let column = DVector::from_fn(rows, |row, _| match (row >= first, component) {
                        (false, _) => 0.0,
                        (true, axis @ 0..3) => own.directions[row][axis],
                        (true, turn) => own.arms[row].cross(&own.directions[row])[turn - 3],
                    });
                    own.own_part(column).unwrap_or_else(|| DVector::zeros(rows))
                })
                .collect();
            for (i, one) in parts.iter().enumerate() {
                right[i] += one.dot(&own.residuals);
                for (j, other) in parts.iter().enumerate() {
                    normal[(i, j)] += one.dot(other);
                }
            }
        }
        let scale = normal.trace() / 6.0;
        let decomposition = symmetric_eigen(normal)?;
        let (mut gain, mut parameters) = (0.0, 0.0);
        for (place, value) in decomposition.eigenvalues.iter().enumerate() {
            if *value > 1e-6 * scale {
                gain += decomposition.eigenvectors.column(place).dot(&right).powi(2) / value;
                parameters += 1.0;
            }
        }
        let explained = Explained { gain, of: self.table.squares, parameters, tried };
        let size = (gain / self.table.freedom).sqrt() * 2.0;
        Some(self.explanation(Cause::Tracker, None, size, explained, self.spread(gain), 1.0))
    }

    /// Lengths and poses are of different times.
    fn late(&self) -> Option<Explanation> {
        let samples = self.examined.samples;
        let time = samples.time.as_ref()?;
        let rows = &self.table.rows;
        let speed = |own: &CableResiduals| {
            DVector::from_fn(rows.len(), |row, _| {
                let (before, after) = (row.saturating_sub(1), (row + 1).min(rows.len() - 1));
                let span = time[rows[after]] - time[rows[before]];
                if span > 0.0 { (own.lengths[after] - own.lengths[before]) / span } else { 0.0 }
            })
        };
        let (mut right, mut normal) = (0.0, 0.0);
        for own in &self.table.cables {
            let Some(part) = own.own_part(speed(own)) else { continue };
            right += part.dot(&own.residuals);
            normal += part.norm_squared();
        }
        if normal <= 0.0 {
            return None;
        }
        let gain = right * right / normal;
        let explained = Explained { gain, of: self.table.squares, parameters: 1.0, tried: 1.0 };
        Some(self.explanation(Cause::Clock, None, right / normal, explained, self.spread(gain), 1.0))
    }

    /// One cable's residuals are larger than those of the others.
    fn loud(&self, cable: usize, own: &CableResiduals) -> Option<Explanation> {
        let (rest, freedom) = (self.table.squares - own.squares, self.table.freedom - own.freedom);
        if self.table.cables.len() < 3 || rest <= 0.0 {
            return None;
        }
        let variance = |squares: f64, freedom: f64| (squares / freedom).ln();
        let ratio = 0.5
            * (self.table.freedom * variance(self.table.squares, self.table.freedom)
                - own.freedom * variance(own.squares, own.freedom)
                - freedom * variance(rest, freedom));
        let (loud, quiet) = (own.rms(), (rest / freedom).sqrt());
        let is_louder = loud > LOUDER * quiet;
        is_louder.then(|| Explanation {
            cause: Cause::Loud,
            cable: Some(cable),
            first: None,
            score: ratio - 0.5 * self.table.freedom.ln() - (self.table.cables.len() as f64).ln(),
            explained: own.squares / self.table.squares,
            size: loud,
            part: loud,
            left: quiet,
        })
    }

    fn spread(&self, gain: f64) -> Spread {
        let of = |squares: f64| (squares.max(0.0) / self.table.freedom).sqrt();
        Spread { part: of(gain), left: of(self.table.squares - gain) }
    }

    fn explanation(
        &self,
        cause: Cause,
        cable: Option<usize>,
        size: f64,
        own: Explained,
        spread: Spread,
        time: f64,
    ) -> Explanation {
        let left = (1.0 - own.gain / self.table.squares).max(1e-12);
        let ratio = -0.5 * self.table.freedom * left.ln() / time;
        let price = 0.5 * own.parameters * self.table.freedom.ln() + own.tried.max(1.0).ln();
        Explanation {
            cause,
            cable,
            first: None,
            score: ratio - price,
            explained: own.gain / own.of.max(f64::MIN_POSITIVE),
            size,
            part: spread.part,
            left: spread.left,
        }
    }
}
