//! Rows of cables in lanes.

use super::super::rows::{RowModel, SampleRows};
use super::*;
use crate::recorded::Recorded;
use cdpr_model::model::{Composition, FreeParameters, place_pulleys};
use cdpr_model::robot::Robot;
use cdpr_model::statics::Load;
use nalgebra::Vector3;

/// Rows of lanes are those of single cables to rounding, whose derivatives are held against dual numbers.
#[test]
fn rows_in_lanes_are_those_of_single_cables() {
    for basis in [StiffnessBasis::Actual, StiffnessBasis::Unstrained] {
        let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
        let mut robot = place_pulleys(&robot, &[(0.1, Vector3::z()); 8], &robot.home_or_middle()).unwrap();
        for (index, cable) in robot.cables.iter_mut().enumerate() {
            cable.stiffness = Some(cdpr_model::robot::CableStiffness::Axial(2e5 + 1e4 * index as f64));
            cable.stiffness_by = Some(basis);
            cable.hidden_length = Some(2.0);
            (cable.length_scale, cable.length_offset) = (Some(1.01), Some(0.02));
            (cable.tension_scale, cable.tension_offset) = (Some(0.98), Some(3.0));
        }
        let model = Model::new(robot, Composition::PULLEY_ELASTIC).unwrap();
        let free = "frame-anchor,platform-anchor,length-offset,length-scale,compliance,hidden-length,wrench";
        let free: FreeParameters = free.parse().unwrap();
        let parameters = free.parameters(&model, &FreeParameters::default()).unwrap();
        let load = Load::of(model.robot()).unwrap();
        let pose = model
            .robot()
            .home_or_middle()
            .displaced(&cdpr_model::geometry::Twist::new(0.2, 0.1, -0.2, 0.1, 0.05, -0.1));
        let tensions: Vec<f64> = (0..8).map(|cable| 1500.0 + 100.0 * cable as f64).collect();
        let write = |rows_of: &RowModel<'_>| {
            let mut rows = SampleRows::new(&model, parameters.len());
            rows_of.write(&pose, &tensions, Recorded::lengths(&[8.0; 8]), &mut rows);
            rows.entries
        };
        let mut of_model = RowModel::new(&model, load, &parameters);
        let found = write(&of_model);
        assert!(of_model.linear.take().is_some());
        let expected = write(&of_model);
        for (place, (found, expected)) in found.iter().zip(&expected).enumerate() {
            // terms of thousands of newtons cancel
            assert!(
                (found - expected).abs() <= 1e-10 * expected.abs().max(1.0),
                "{basis:?} {place}: {found} {expected}"
            );
        }
    }
}
