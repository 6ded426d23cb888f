//! Random numbers that are the same for the same words and seed (SplitMix64).

/// The state.
pub(crate) struct Random(u64);

impl Random {
    /// Numbers of a seed for one purpose: other words, other numbers.
    pub(crate) fn of(words: &str, seed: u64) -> Self {
        let hash = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        let mut random = Self(words.bytes().fold(0xcbf2_9ce4_8422_2325, hash) ^ seed.wrapping_mul(0x9e37_79b9));
        random.next();
        random
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// 0 to 1, without 1.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.unit()
    }

    /// A size between two bounds, above or below zero.
    pub(crate) fn signed(&mut self, least: f64, most: f64) -> f64 {
        self.between(least, most) * if self.unit() < 0.5 { -1.0 } else { 1.0 }
    }

    /// 0 to `count` − 1.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        usize::try_from(self.next() % count.max(1) as u64).unwrap_or(0)
    }

    /// `least` to `most` − 1.
    pub(crate) fn row(&mut self, least: usize, most: usize) -> usize {
        least + self.below(most.saturating_sub(least))
    }

    /// Normal with a standard deviation (Box and Muller).
    pub(crate) fn normal(&mut self, sigma: f64) -> f64 {
        let (radius, angle) = ((-2.0 * (1.0 - self.unit()).ln()).sqrt(), std::f64::consts::TAU * self.unit());
        sigma * radius * angle.cos()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_numbers_have_their_mean_and_deviation() {
        let mut random = Random::of("test", 1);
        let numbers: Vec<f64> = (0..20_000).map(|_| random.normal(2.0)).collect();
        let mean = numbers.iter().sum::<f64>() / 20_000.0;
        let variance = numbers.iter().map(|number| (number - mean).powi(2)).sum::<f64>() / 20_000.0;
        // 4 standard errors
        assert!(mean.abs() < 4.0 * 2.0 / 20_000_f64.sqrt(), "{mean}");
        assert!((variance.sqrt() - 2.0).abs() < 4.0 * 2.0 / 40_000_f64.sqrt(), "{variance}");
    }
}
