//! The main job in code: virtual measurements, candidates, one recommendation.

use cdpr::calibration::candidate;
use cdpr::calibration::selection::{Settings, select};
use cdpr::calibration::unobserved;
use cdpr::control::CommandedPose;
use cdpr::control::simulate::simulate;
use cdpr::measurement::{SensorSigmas, Split};
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::Vector3;
use cdpr::robot::Robot;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // ANCHOR: measure
    // a machine whose winches read a few millimetres too much, driven by the model of its drawing
    let drawing = Robot::builtin("cablerobot-simulator-helicopter").ok_or("not built in")?;
    let mut real = drawing.clone();
    for (cable, offset) in real.cables.iter_mut().zip([4.0, -3.0, 5.0, 2.0, -6.0, 3.0, -4.0, 5.0]) {
        cable.length_offset = Some(1e-3 * offset);
    }
    let control = Model::new(drawing.clone(), Composition::STANDARD)?;
    let machine = Model::new(real, Composition::STANDARD)?;
    let home = drawing.home.ok_or("no home pose")?;
    let poses: Vec<CommandedPose> = (0..125)
        .map(|k| {
            let mut pose = home;
            pose.position +=
                Vector3::new(f64::from(k % 5) - 2.0, f64::from(k / 5 % 5) - 2.0, f64::from(k / 25) - 2.0) * 0.4;
            CommandedPose::at(pose)
        })
        .collect();
    let noise =
        SensorSigmas { position: Some(1e-3), rotation: Some(1e-3), length: Some(2e-4), ..SensorSigmas::default() };
    let samples = simulate(&control, &machine, &[0.0; 8], &poses, &noise, 1)?.samples;
    // ANCHOR_END: measure

    // ANCHOR: choose
    let folds = Split::KFold(5).folds(&samples, 1)?;
    let candidates = candidate::defaults(&drawing, candidate::Ladder::default());
    let selection = select(&drawing, &candidates, &samples, &folds, &Settings::default(), &unobserved)?;
    let recommended = &selection.candidates[selection.recommended.ok_or("none is good enough")?];
    assert_eq!(recommended.name, "standard:length-offset");
    // ANCHOR_END: choose
    for parameter in
        recommended.outcome.as_ref().map(|judgement| judgement.fit.parameters.as_slice()).unwrap_or_default()
    {
        assert!(parameter.sigma.is_some_and(|sigma| sigma < 1e-3), "{} is known to a millimetre", parameter.name);
    }
    Ok(())
}
