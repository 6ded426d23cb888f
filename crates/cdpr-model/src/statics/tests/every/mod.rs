//! Every composition of effects on random robots and poses: a new effect is covered once `Composition::all` lists it.

mod derivatives;
mod switching_off;

use nalgebra::{UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::robot::{CableStiffness, HysteresisTable, TensionPlace, WrapSide};

/// A random number between −1 and 1 times the extent.
fn within(rng: &mut ChaCha8Rng, extent: f64) -> f64 {
    rng.random_range(-extent..extent)
}

/// A robot with the keys of every effect, its numbers drawn at random: in space with six to nine cables, or in a plane
/// with four and pulleys that do not swivel.
fn random_robot(seed: u64) -> Robot {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let is_planar = seed.is_multiple_of(4);
    let mut robot = Robot::builtin(if is_planar { "planar-example" } else { "cogiro" }).expect("built in");
    if !is_planar {
        let count = 6 + usize::try_from(seed % 4).expect("below 4");
        let first = robot.cables[0].clone();
        robot.cables.resize(count, first);
    }
    robot.gravity = Some(Vector3::new(0.0, if is_planar { -9.81 } else { 0.0 }, if is_planar { 0.0 } else { -9.81 }));
    for (index, cable) in robot.cables.iter_mut().enumerate() {
        if !is_planar {
            let angle = 2.4 * index as f64;
            cable.frame_anchor = Vector3::new(6.0 * angle.cos(), 6.0 * angle.sin(), 4.0 + within(&mut rng, 3.5));
            cable.platform_anchor = Vector3::from_fn(|_, _| within(&mut rng, 0.5));
            let tilt = Vector3::new(within(&mut rng, 0.3), within(&mut rng, 0.3), 1.0);
            cable.set_pulley_swivel_axis(tilt.normalize());
        } else {
            cable.set_pulley_swivel_axis(Vector3::new(0.0, 1.0, 0.0));
            let is_left = cable.frame_anchor.x < 0.0;
            cable.pulley_wrap_side = Some(if is_left { WrapSide::Right } else { WrapSide::Left });
        }
        cable.set_pulley_radius(0.15 + within(&mut rng, 0.1));
        let specific = 1e6 * (1.5 + within(&mut rng, 1.0));
        crate::robot::LAWS.iter().for_each(|law| law.exemplify(cable, specific));
        cable.stiffness = Some(match index % 3 {
            0 => CableStiffness::Axial(specific),
            1 => CableStiffness::Compliance(1.0 / specific),
            _ => CableStiffness::Spring(specific / 8.0),
        });
        cable.stiffness_by = Some(if index % 2 == 0 { StiffnessBasis::Actual } else { StiffnessBasis::Unstrained });
        cable.hidden_length = (index % 3 != 2).then_some(1.0 + within(&mut rng, 1.0));
        cable.series_compliance = Some(1e-7 * (1.0 + within(&mut rng, 1.0)));
        cable.linear_density = Some(0.5 + within(&mut rng, 0.4));
        cable.finite_elements = Some(3 + index);
        cable.tension_of_strain = Some(vec![specific, 60.0 * specific, 800.0 * specific]);
        cable.hysteresis = Some(loop_of(specific, 0.2));
        cable.tension_at = Some(if index % 2 == 0 { TensionPlace::Outlet } else { TensionPlace::Platform });
        cable.tension_max = Some(2e4);
        cable.winch.radius = Some(0.1 + within(&mut rng, 0.03));
        cable.winch.set_pitch(0.012);
        cable.winch.axis = Some(Vector3::x().into());
        cable.winch.position = Some(cable.frame_anchor + Vector3::new(0.1, 1.5, -2.0));
        cable.winch.gear_ratio = Some(5.0);
    }
    robot
}

/// Branches that stiffen; the lower one lies below the upper by `width` of it in the middle.
fn loop_of(stiffness: f64, width: f64) -> HysteresisTable {
    let strain = vec![0.0, 0.004, 0.02];
    let loading: Vec<f64> = strain.iter().map(|e| stiffness * e * (1.0 + 20.0 * e)).collect();
    let unloading = vec![0.0, loading[1] * (1.0 - width), loading[2]];
    HysteresisTable {
        strain,
        loading_N: loading,
        unloading_N: unloading,
        loading_slope_N: None,
        unloading_slope_N: None,
        transition_strain: vec![4e-4, 2e-3],
        transition_share: None,
    }
}

/// Poses near the middle of a robot, with rotations of up to 20° in space, and a tension for every cable.
fn random_states(model: &Model, seed: u64, count: usize) -> Vec<(Pose, Vec<f64>)> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let home = model.robot().home_or_middle().position;
    (0..count)
        .map(|_| {
            let twist =
                model.twist_basis().iter().fold(Twist::zeros(), |sum, axis| sum + axis * within(&mut rng, 0.35));
            let level = Pose { position: home, rotation: UnitQuaternion::identity() };
            let tensions = (0..model.cable_count()).map(|_| 3000.0 + within(&mut rng, 2000.0)).collect();
            (level.displaced(&twist), tensions)
        })
        .collect()
}

/// All compositions that the robot supports; no composition is left out.
fn models(robot: &Robot) -> impl Iterator<Item = Model> + '_ {
    Composition::all().map(|composition| Model::new(robot.clone(), composition).expect("the robot has every key"))
}
