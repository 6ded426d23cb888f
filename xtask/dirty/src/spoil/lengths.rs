//! Recorded lengths that are not those of the cables.

use crate::kinds::Place;
use crate::random::Random;
use crate::record::Record;
use crate::scene::{SIGMAS, Scene};

/// A cable, counted from 0.
fn any_cable(scene: &Scene, random: &mut Random) -> usize {
    random.below(scene.cables())
}

fn of_cable(cable: usize, lines: Vec<usize>) -> Place {
    Place { cable: Some(cable + 1), lines }
}

/// Two cables stand in each other's columns: opposite ones, which no mirror exchanges alone.
pub(crate) fn permuted(scene: &mut Scene, random: &mut Random) -> Place {
    let first = random.below(2);
    scene.data.rows.iter_mut().for_each(|row| row.lengths.swap(first, first + 2));
    Place::default()
}

/// A cable is clamped anew, 20 mm longer or shorter, at a row.
pub(crate) fn reclamped(scene: &mut Scene, random: &mut Random) -> Place {
    let (cable, count) = (any_cable(scene, random), scene.data.rows.len());
    let (row, by) = (random.row(count / 4, 3 * count / 4), random.signed(0.018, 0.022));
    scene.data.rows[row..].iter_mut().for_each(|row| row.lengths[cable] += by);
    of_cable(cable, vec![Record::line(row)])
}

/// A cable creeps by 15 to 25 mm over the record.
pub(crate) fn drift(scene: &mut Scene, random: &mut Random) -> Place {
    let (cable, by, count) = (any_cable(scene, random), random.signed(0.015, 0.025), scene.data.rows.len());
    let rows = scene.data.rows.iter_mut().enumerate();
    rows.for_each(|(index, row)| row.lengths[cable] += by * index as f64 / count as f64);
    of_cable(cable, Vec::new())
}

/// An encoder repeats one value for a third of the rows.
pub(crate) fn stuck(scene: &mut Scene, random: &mut Random) -> Place {
    let (cable, count) = (any_cable(scene, random), scene.data.rows.len());
    let row = random.row(count / 4, count / 2);
    let value = scene.data.rows[row].lengths[cable];
    scene.data.rows[row..row + count / 3].iter_mut().for_each(|row| row.lengths[cable] = value);
    of_cable(cable, vec![Record::line(row)])
}

/// A recorded length stays behind after every reversal, by 15 to 25 mm (an operator of play).
pub(crate) fn dead_band(scene: &mut Scene, random: &mut Random) -> Place {
    let (cable, half) = (any_cable(scene, random), random.between(0.0075, 0.0125));
    let mut behind = scene.data.rows[0].lengths[cable];
    for row in &mut scene.data.rows {
        let length = row.lengths[cable];
        behind = behind.clamp(length - half, length + half);
        row.lengths[cable] = behind + random.normal(SIGMAS.length);
    }
    of_cable(cable, Vec::new())
}

/// A winch reports 12 to 18 mm more when it paid out than when it wound.
pub(crate) fn backlash(scene: &mut Scene, random: &mut Random) -> Place {
    let (cable, half) = (any_cable(scene, random), random.between(0.006, 0.009));
    let lengths: Vec<f64> = scene.data.rows.iter().map(|row| row.lengths[cable]).collect();
    for (index, row) in scene.data.rows.iter_mut().enumerate() {
        let paid_out = index > 0 && lengths[index] > lengths[index - 1];
        row.lengths[cable] += if paid_out { half } else { -half };
    }
    of_cable(cable, Vec::new())
}

/// A cable hangs through: 10 to 60 mm more than the straight line, at random.
pub(crate) fn slack(scene: &mut Scene, random: &mut Random) -> Place {
    let cable = any_cable(scene, random);
    scene.data.rows.iter_mut().for_each(|row| row.lengths[cable] += random.between(0.01, 0.06));
    of_cable(cable, Vec::new())
}

/// A drum is 6 % thicker than the controller knows; so is the machine that the written robot shall drive.
pub(crate) fn one_winch_scale(scene: &mut Scene, random: &mut Random) -> Place {
    let cable = any_cable(scene, random);
    scene.machine.scales[cable] = if random.unit() < 0.5 { 1.06 } else { 0.94 };
    scene.measure_again(random);
    of_cable(cable, Vec::new())
}

/// All lengths are 5 % too large, and no pose says so.
pub(crate) fn gear_without_poses(scene: &mut Scene, random: &mut Random) -> Place {
    scene.machine.scales.iter_mut().for_each(|scale| *scale = 1.05);
    scene.measure_again(random);
    scene.data.style.with_poses = false;
    Place::default()
}
