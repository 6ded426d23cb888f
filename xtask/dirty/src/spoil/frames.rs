//! Poses in other frames, by other conventions, at other times, and with other noise.

use crate::kinds::Place;
use crate::pose::{Pose, rotation_of};
use crate::random::Random;
use crate::record::{Record, Turns};
use crate::scene::{SIGMAS, Scene};

/// z counts downwards.
pub(crate) fn mirrored_height(scene: &mut Scene, _: &mut Random) -> Place {
    for row in &mut scene.data.rows {
        let Pose { position, rotation } = &mut row.pose;
        position[2] = -position[2];
        // M R M with M = diag(1, 1, −1): what a left-handed tracker sees of a turned body
        (0..2).for_each(|index| (rotation[2][index], rotation[index][2]) = (-rotation[2][index], -rotation[index][2]));
    }
    Place::default()
}

pub(crate) fn scalar_first(scene: &mut Scene, _: &mut Random) -> Place {
    scene.data.style.turns = Turns::ScalarFirst;
    Place::default()
}

pub(crate) fn inverted(scene: &mut Scene, _: &mut Random) -> Place {
    scene.data.style.turns = Turns::Inverted;
    Place::default()
}

pub(crate) fn roll_pitch_yaw(scene: &mut Scene, _: &mut Random) -> Place {
    scene.data.style.turns = Turns::RollPitchYaw;
    Place::default()
}

/// A reflector above the platform is measured instead of its origin.
pub(crate) fn marker_offset(scene: &mut Scene, random: &mut Random) -> Place {
    let marker = [random.signed(0.05, 0.15), random.signed(0.05, 0.15), random.between(0.15, 0.3)];
    scene.data.rows.iter_mut().for_each(|row| row.pose = row.pose.then(&Pose::shifted(marker)));
    scene.marker = Some(marker);
    Place::default()
}

/// The tracker's frame lies some decimetres and degrees off the robot's.
pub(crate) fn tracker_turned(scene: &mut Scene, random: &mut Random) -> Place {
    let distances = [(); 3].map(|()| random.signed(0.2, 0.5));
    let angle = random.signed(0.08, 0.17);
    in_frame(scene, tracker(scene, distances, angle))
}

/// The tracker stands 50 m away: a frame as any other.
pub(crate) fn tracker_far(scene: &mut Scene, random: &mut Random) -> Place {
    let distances = [random.signed(30.0, 40.0), random.signed(25.0, 35.0), random.signed(2.0, 6.0)];
    let angle = random.signed(0.3, 1.2);
    in_frame(scene, tracker(scene, distances, angle))
}

/// A frame displaced along the axes that the robot has, and turned about the normal of its plane, or about z.
fn tracker(scene: &Scene, distances: [f64; 3], angle: f64) -> Pose {
    let axes = scene.robot().freedom().axes;
    let position = std::array::from_fn(|axis| if axes.contains(&axis) { distances[axis] } else { 0.0 });
    let turn = if axes.len() == 2 { [0.0, angle, 0.0] } else { [0.0, 0.0, angle] };
    Pose { position, rotation: rotation_of(turn) }
}

fn in_frame(scene: &mut Scene, tracker: Pose) -> Place {
    scene.data.rows.iter_mut().for_each(|row| row.pose = tracker.then(&row.pose));
    scene.tracker = Some(tracker);
    Place::default()
}

/// Somebody walks against the tracker at a row.
pub(crate) fn tracker_bumped(scene: &mut Scene, random: &mut Random) -> Place {
    let count = scene.data.rows.len();
    let (row, angle) = (random.row(count / 3, 2 * count / 3), random.signed(0.003, 0.006));
    let distances = [(); 3].map(|()| random.signed(0.02, 0.05));
    let tracker = tracker(scene, distances, angle);
    scene.data.rows[row..].iter_mut().for_each(|row| row.pose = tracker.then(&row.pose));
    Place { lines: vec![Record::line(row)], ..Place::default() }
}

/// Poses that are one row, 0.1 s, older than the lengths beside them.
pub(crate) fn late_clock(scene: &mut Scene, _: &mut Random) -> Place {
    let rows = &mut scene.data.rows;
    (1..rows.len()).rev().for_each(|index| rows[index].pose = rows[index - 1].pose);
    rows.remove(0);
    Place::default()
}

/// Noise of poses that lasts for tens of rows, 3 mm and 3 mrad, which is stated.
pub(crate) fn correlated_noise(scene: &mut Scene, random: &mut Random) -> Place {
    let (kept, size): (f64, f64) = (0.93, 3.0);
    let fresh = size * (1.0 - kept * kept).sqrt();
    let freedom = scene.robot().freedom();
    let mut state = [(); 6].map(|()| random.normal(size));
    for row in &mut scene.data.rows {
        state = state.map(|number| kept * number + random.normal(fresh));
        let (mut translation, mut turn) = ([0.0; 3], [0.0; 3]);
        freedom.axes.iter().for_each(|&axis| translation[axis] = state[axis] * SIGMAS.position);
        if freedom.turns {
            turn = [state[3], state[4], state[5]].map(|number| number * SIGMAS.rotation);
        }
        row.pose = row.pose.moved(translation, turn);
    }
    if let Some(stated) = &mut scene.stated {
        let whole = (1.0 + size * size).sqrt();
        (stated.position, stated.rotation) = (whole * stated.position, whole * stated.rotation);
    }
    Place::default()
}
