//! Spoilt set-ups: poses measured, and numbers of robot file and sidecar.

use crate::kinds::Place;
use crate::random::Random;
use crate::robots::weight;
use crate::scene::{SIGMAS, Scene, Sigmas};

/// A record as it shall be.
pub(crate) fn nothing(_: &mut Scene, _: &mut Random) -> Place {
    Place::default()
}

/// A record to validate by, of the same machine.
pub(crate) fn validation(scene: &mut Scene, random: &mut Random) -> Place {
    scene.validate_by(&scene.machine.clone(), random);
    Place::default()
}

/// A robot file that is right.
pub(crate) fn exact_file(scene: &mut Scene, random: &mut Random) -> Place {
    scene.machine = scene.file.geometry.clone();
    scene.measure_again(random);
    Place::default()
}

/// The winches were set anew before the validation: all read 10 mm more.
pub(crate) fn other_day_offsets(scene: &mut Scene, random: &mut Random) -> Place {
    let mut machine = scene.machine.clone();
    machine.offsets.iter_mut().for_each(|offset| *offset += 0.01);
    scene.validate_by(&machine, random);
    Place::default()
}

/// Three times the mass in the validation.
pub(crate) fn tripled_payload(scene: &mut Scene, random: &mut Random) -> Place {
    let mut machine = scene.machine.clone();
    machine.force = weight(3.0 * scene.file.mass);
    scene.validate_by(&machine, random);
    Place::default()
}

/// The file says four times the stiffness.
pub(crate) fn wrong_stiffness(scene: &mut Scene, _: &mut Random) -> Place {
    scene.file.geometry.compliances.iter_mut().for_each(|compliance| *compliance *= 0.25);
    Place::default()
}

/// One coordinate of one anchor is 1 m off in the file.
pub(crate) fn mistyped_anchor(scene: &mut Scene, random: &mut Random) -> Place {
    let cable = random.below(scene.cables());
    scene.file.geometry.frame_anchors[cable][0] += random.signed(1.0, 1.0);
    Place { cable: Some(cable + 1), lines: Vec::new() }
}

/// Sensors five times worse than stated.
pub(crate) fn small_sigmas(scene: &mut Scene, _: &mut Random) -> Place {
    let Sigmas { position, rotation, length, tension } = SIGMAS;
    scene.stated = Some(Sigmas {
        position: position / 5.0,
        rotation: rotation / 5.0,
        length: length / 5.0,
        tension: tension / 5.0,
    });
    Place::default()
}
