//! Parameters that a fit changed most.

use super::{Estimate, Fit};
use crate::unit_scale::joint_scales;
use cdpr_model::measurement::Samples;
use cdpr_model::robot::Parameter;

impl Fit {
    /// Parameters by their change, the largest first, at most so many; those that did not change are left out.
    ///
    /// Changes of other units than metres count by the metres of cable that they are worth, at the mean recorded length and tension of the samples.
    pub fn largest_changes(&self, samples: &Samples, count: usize) -> Vec<&Estimate> {
        let parameters: Vec<Parameter> = self.parameters.iter().map(|estimate| estimate.parameter).collect();
        // motor angles that are out of the winches' range are no lengths, and scales of them no worse than none
        let read = self.model.with_lengths(samples);
        let lengths = read.as_ref().map_or(&samples.lengths, |read| &read.lengths);
        let scales = joint_scales(&self.model, &parameters, lengths, samples.tensions.as_deref().unwrap_or(&[]));
        let worth = |(estimate, scale): (&'_ Estimate, f64)| (estimate.change * scale).abs();
        let mut changed: Vec<(f64, &Estimate)> =
            self.parameters.iter().zip(scales).map(|(own, scale)| (worth((own, scale)), own)).collect();
        changed.retain(|(worth, _)| *worth > 0.0);
        // the order of the parameters decides between equal ones
        changed.sort_by(|a, b| b.0.total_cmp(&a.0));
        changed.into_iter().take(count).map(|(_, estimate)| estimate).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::{Settings, fit};
    use crate::recorded_curves::curve;
    use cdpr_model::model::{Composition, Model};
    use cdpr_model::robot::Robot;

    /// A scale of 0.1 % on cables of some metres is worth more than an offset of 1 mm, though its number is the same.
    #[test]
    fn changes_of_different_units_are_ordered_by_the_metres_they_are_worth() {
        let model =
            Model::new(Robot::builtin("cablerobot-simulator-helicopter").unwrap(), Composition::STANDARD).unwrap();
        let poses = curve(&model, 30, 1.0);
        let recorded = |(cable, length): (usize, f64)| match cable {
            2 => 1.001 * length,
            5 => length + 1e-3,
            _ => length,
        };
        let lengths = poses.iter().flat_map(|pose| {
            model.cable_lengths(pose).unwrap().into_iter().enumerate().map(recorded).collect::<Vec<_>>()
        });
        let lengths = lengths.collect();
        let samples = Samples { poses, lengths, cable_count: model.cable_count(), ..Samples::default() };
        let free = "length-offset,length-scale".parse().unwrap();
        let found = fit(&model, &samples, &free, &Settings::default()).unwrap();
        let names: Vec<&str> = found.largest_changes(&samples, 2).iter().map(|own| own.name.as_str()).collect();
        assert_eq!(names, ["length-scale[3]", "length-offset[6]"]);
    }
}
