//! Fits: blocks of every size that has sums of its own or many parameters, elastostatic, without poses.

use cdpr::calibration::unobserved;
use std::hint::black_box;

use cdpr::calibration::fit::{Prior, Settings, Status, fit, optimal_parameters};
use cdpr::calibration::{Loss, self_calibrate};
use cdpr::geometry::Pose;
use cdpr::measurement::{InternalSamples, Samples};
use cdpr::model::{Composition, FreeParameters, Model};
use cdpr::nalgebra::DVector;
use cdpr::robot::ParameterKind;
use cdpr::statics::{Load, controlled_lengths};

use crate::counting;
use crate::robots::{ELASTIC, RIGID, model, moved, poses, spread, with_pulleys};

/// Parameters of a cable, and which.
const BLOCKS: [(usize, &str); 5] = [
    (3, "frame-anchor"),
    (4, "frame-anchor,length-offset"),
    (6, "frame-anchor,platform-anchor"),
    (8, "frame-anchor,platform-anchor,length-offset,length-scale"),
    (11, "frame-anchor,platform-anchor,length-offset,length-scale,pulley-radius,swivel-axis"),
];

pub(crate) fn count() {
    kinematic();
    blocks();
    elastostatic();
    without_poses();
}

fn settings() -> Settings {
    Settings { loss: Loss::Squared, ..Settings::default() }
}

fn free(names: &str) -> FreeParameters {
    names.parse().expect("parameters")
}

/// Half a millimetre to either side, another for each sample and cable (m).
fn noise(step: u32, cable: u32) -> f64 {
    1e-3 * spread(step + 1, 20 + cable) - 5e-4
}

/// Lengths of a machine at all poses, half a millimetre wrong.
fn measured(machine: &Model) -> Samples {
    let poses = poses();
    let lengths = (0..).zip(&poses).flat_map(|(step, pose)| {
        let lengths = machine.cable_lengths(pose).expect("lengths");
        (0..).zip(lengths).map(move |(cable, length)| length + noise(step, cable))
    });
    Samples { lengths: lengths.collect(), poses, cable_count: 8, ..Samples::default() }
}

/// 48 parameters from the lengths that anchors up to 5 mm elsewhere give.
fn kinematic() {
    let nominal = model(RIGID, Composition::STANDARD);
    let (samples, free) = (measured(&moved(&nominal)), free("frame-anchor,platform-anchor"));
    counting::count("identification, kinematic", &mut || {
        let fit = fit(&nominal, black_box(&samples), &free, &settings()).expect("enough samples");
        usize::from(fit.status == Status::Converged)
    });
}

/// Optima alone, over pulleys: four steps, with which all but the largest blocks converge.
fn blocks() {
    let nominal = with_pulleys();
    let (samples, settings) = (measured(&moved(&nominal)), Settings { max_iterations: 4, ..settings() });
    for (parameters, names) in BLOCKS {
        let free = free(names);
        counting::count(&format!("identification, blocks of {parameters}"), &mut || {
            let found = optimal_parameters(&nominal, black_box(&samples), &free, &settings).expect("enough samples");
            assert_eq!(found.parameters.len(), 8 * parameters, "{names}");
            found.history.len()
        });
    }
}

/// Lengths and tensions of a machine in equilibrium with its load at all poses, lengths half a millimetre wrong.
fn tensed(machine: &Model) -> Samples {
    let (poses, load) = (poses(), Load::of(machine.robot()).expect("a load"));
    let (mut lengths, mut tensions) = (Vec::new(), Vec::new());
    for (step, pose) in (0..).zip(&poses) {
        let matrix = machine.structure_matrix(pose).expect("courses");
        let wished = DVector::from_fn(8, |cable, _| 2000.0 + 2000.0 * spread(step + 1, 11 + cable as u32));
        let missing = &matrix * &wished + load.in_pattern(machine, pose);
        let balanced = wished - matrix.pseudo_inverse(1e-12).expect("finite") * missing;
        let exact = controlled_lengths(machine, pose, balanced.as_slice()).expect("tensions that pull");
        lengths.extend((0..).zip(exact).map(|(cable, length)| length + noise(step, cable)));
        tensions.extend_from_slice(balanced.as_slice());
    }
    Samples { lengths, tensions: Some(tensions), poses, cable_count: 8, ..Samples::default() }
}

/// 62 parameters: anchors, compliances and the wrench.
fn elastostatic() {
    let nominal = model(ELASTIC, Composition::ELASTIC);
    let (samples, free) = (tensed(&moved(&nominal)), free("frame-anchor,platform-anchor,compliance,wrench"));
    let prior = Prior { kind: ParameterKind::PlatformAnchor, sigma: 0.02 };
    let settings = Settings { priors: vec![prior], ..settings() };
    counting::count("identification, elastostatic", &mut || {
        let fit = fit(&nominal, black_box(&samples), &free, &settings).expect("enough samples");
        usize::from(fit.status == Status::Converged)
    });
}

/// Frame anchors from lengths alone.
fn without_poses() {
    let nominal = model(RIGID, Composition::STANDARD);
    let mut samples = measured(&moved(&nominal));
    samples.poses.fill(Pose::identity());
    let internal = InternalSamples::without_poses(samples, nominal.dof(), false);
    let (free, settings) = (free("frame-anchor"), Settings { starts: 1, ..settings() });
    counting::count("identification, without poses", &mut || {
        let found =
            self_calibrate(&nominal, black_box(&internal), &free, &settings, &unobserved).expect("enough samples");
        usize::from(found.fit.status == Status::Converged)
    });
}
