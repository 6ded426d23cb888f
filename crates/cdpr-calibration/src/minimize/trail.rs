//! Way of a search for parameters.

/// Costs after the steps of a search, and where they are kept the parameters of all its descents.
#[derive(Clone, Debug, Default)]
pub(crate) struct Trail {
    /// Costs of the last descent.
    pub(crate) costs: Vec<f64>,
    /// Values of the parameters at the places of all descents; `None` where nobody asked.
    pub(crate) places: Option<Vec<Vec<f64>>>,
}

impl Trail {
    /// A way without steps.
    pub(crate) fn new(keeps_places: bool, capacity: usize) -> Self {
        Self { costs: Vec::with_capacity(capacity), places: keeps_places.then(Vec::new) }
    }

    /// Goes on to a place.
    pub(crate) fn push(&mut self, cost: f64, values: impl FnOnce() -> Vec<f64>) {
        self.costs.push(cost);
        if let Some(places) = &mut self.places {
            places.push(values());
        }
    }

    /// A further descent behind this way, by other weights.
    pub(crate) fn then(self, further: Self) -> Self {
        let Some(mut places) = self.places else { return further };
        places.extend(further.places.into_iter().flatten());
        places.dedup();
        Self { costs: further.costs, places: Some(places) }
    }

    /// A further descent behind this way, by the same weights.
    pub(crate) fn joined(mut self, further: Self) -> Self {
        let mut costs = std::mem::take(&mut self.costs);
        costs.extend_from_slice(&further.costs);
        Self { costs, ..self.then(further) }
    }

    /// The places; empty if they are not kept.
    pub(crate) fn places(&self) -> &[Vec<f64>] {
        self.places.as_deref().unwrap_or_default()
    }
}

/// Way of searches that went at the same time, each in its own values; those that are done wait.
pub(crate) fn side_by_side(all: &[&Trail]) -> Trail {
    let at = |costs: &[f64], step: usize| costs.get(step).or(costs.last()).copied().unwrap_or(0.0);
    let most = |count: &dyn Fn(&Trail) -> usize| all.iter().map(|one| count(one)).max().unwrap_or(0);
    let costs =
        (0..most(&|one| one.costs.len())).map(|step| all.iter().map(|one| at(&one.costs, step)).sum()).collect();
    let place = |step: usize| {
        let own = |one: &&Trail| one.places().get(step).or(one.places().last()).cloned().unwrap_or_default();
        all.iter().flat_map(own).collect()
    };
    let is_kept = all.iter().any(|one| one.places.is_some());
    Trail { costs, places: is_kept.then(|| (0..most(&|one| one.places().len())).map(place).collect()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn trail(places: &[(f64, f64)]) -> Trail {
        let mut trail = Trail::new(true, 0);
        places.iter().for_each(|&(cost, value)| trail.push(cost, || vec![value]));
        trail
    }

    #[test]
    fn descents_follow_each_other_and_the_place_between_them_is_told_once() {
        let (first, second) = (trail(&[(4.0, 1.0), (2.0, 2.0)]), trail(&[(3.0, 2.0), (1.0, 2.5)]));
        let joined = first.clone().joined(second.clone());
        let reweighed = first.then(second);
        assert_eq!(reweighed.places(), [[1.0], [2.0], [2.5]]);
        assert_eq!((&reweighed.costs[..], &joined.costs[..]), (&[3.0, 1.0][..], &[4.0, 2.0, 3.0, 1.0][..]));
        assert_eq!(reweighed.places(), joined.places());
    }

    #[test]
    fn searches_side_by_side_wait_for_the_longest() {
        let (long, short) = (trail(&[(4.0, 1.0), (2.0, 2.0), (1.0, 3.0)]), trail(&[(0.5, 7.0)]));
        let both = side_by_side(&[&long, &short]);
        assert_eq!(both.costs, [4.5, 2.5, 1.5]);
        assert_eq!(both.places(), [[1.0, 7.0], [2.0, 7.0], [3.0, 7.0]]);
        assert!(side_by_side(&[&Trail::new(false, 0)]).places().is_empty());
    }
}
