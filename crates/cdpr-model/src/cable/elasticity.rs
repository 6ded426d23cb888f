//! Linear elasticity of a robot's cable.

pub use cdpr_core::cable::elasticity::{ControlledLength, Elasticity, StiffnessBasis, Tension};

use crate::robot::{Cable, CableStiffness};

/// The linear law of a robot's cable; `None` if its file states no stiffness.
pub fn linear_elasticity(cable: &Cable) -> Option<Elasticity<f64>> {
    let series = cable.series_compliance.unwrap_or(0.0);
    let compliance = match cable.stiffness {
        Some(CableStiffness::Spring(spring)) => return Some(Elasticity::spring(spring, series)),
        Some(CableStiffness::Axial(stiffness)) => 1.0 / stiffness,
        Some(CableStiffness::Compliance(compliance)) => compliance,
        None => cable.series_compliance.map(|_| 0.0)?,
    };
    let basis = cable.stiffness_by.unwrap_or(StiffnessBasis::Actual);
    Some(Elasticity::specific(compliance, basis, cable.hidden_length.unwrap_or(0.0), series))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_says_nothing_of_stiffness_has_no_law() {
        assert_eq!(linear_elasticity(&Cable::default()), None);
        let rigid = Cable { stiffness: Some(CableStiffness::Compliance(0.0)), ..Cable::default() };
        assert!(linear_elasticity(&rigid).unwrap().is_rigid());
    }
}
