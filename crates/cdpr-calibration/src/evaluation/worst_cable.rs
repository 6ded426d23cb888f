//! The cable whose lengths a model gets worst.

use super::Evaluation;

/// Cable with the largest length error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstCable {
    /// The cable, from 0.
    pub cable: usize,
    /// Root mean square of its modelled minus recorded lengths (m).
    pub rms: f64,
    /// Root mean square of all other cables (m); NaN of a robot with one cable.
    pub others_rms: f64,
}

impl Evaluation {
    /// The cable with the largest root mean square of its length errors, over the samples that have them; `None` where no length is modelled.
    pub fn worst_cable(&self) -> Option<WorstCable> {
        let squares = |is_asked: &dyn Fn(usize) -> bool| {
            let places = self
                .length
                .iter()
                .enumerate()
                .filter(|(place, error)| is_asked(place % self.cable_count) && error.is_finite());
            let (count, sum) = places.fold((0_usize, 0.0), |(count, sum), (_, error)| (count + 1, sum + error * error));
            (sum / count as f64).sqrt()
        };
        let of_cable = |cable: usize| (cable, squares(&|other| other == cable));
        let judged = (0..self.cable_count).map(of_cable).filter(|(_, rms)| rms.is_finite());
        let (cable, rms) = judged.max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(WorstCable { cable, rms, others_rms: squares(&|other| other != cable) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cable_with_the_largest_errors_is_the_worst_whatever_their_sign() {
        let nothing = f64::NAN;
        let length = vec![1e-3, -4e-3, 2e-3, -1e-3, nothing, nothing, 1e-3, 4e-3, -2e-3];
        let errors = Evaluation { length, cable_count: 3, ..Evaluation::default() };
        let worst = errors.worst_cable().unwrap();
        assert_eq!(worst.cable, 1);
        assert!((worst.rms - 4e-3).abs() < 1e-12, "{worst:?}");
        // three errors of 1 mm and two of 2 mm
        assert!((worst.others_rms - (11e-6_f64 / 5.0).sqrt()).abs() < 1e-12, "{worst:?}");
        assert_eq!(Evaluation { cable_count: 3, ..Evaluation::default() }.worst_cable(), None);
    }
}
