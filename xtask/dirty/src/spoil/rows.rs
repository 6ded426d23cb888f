//! Rows that repeat others, and rows that nothing explains.

use crate::kinds::Place;
use crate::random::Random;
use crate::record::Record;
use crate::scene::Scene;

/// Forty rows, pasted six times.
pub(crate) fn pasted(scene: &mut Scene, _: &mut Random) -> Place {
    let count = 40;
    scene.data.rows.truncate(count);
    scene.data.rows = vec![scene.data.rows.clone(); 6].concat();
    Place { lines: vec![Record::line(count)], ..Place::default() }
}

/// The file to validate by is the one that was fitted to.
pub(crate) fn validation_is_training(scene: &mut Scene, _: &mut Random) -> Place {
    scene.validation = Some(scene.data.clone());
    Place::default()
}

/// Four poses are decimetres off.
pub(crate) fn outliers(scene: &mut Scene, random: &mut Random) -> Place {
    let axes = scene.robot().freedom().axes;
    let count = scene.data.rows.len();
    // one in each quarter
    let rows: Vec<usize> = (0..4).map(|part| random.row(part * count / 4, (part + 1) * count / 4)).collect();
    for &row in &rows {
        scene.data.rows[row].pose.position[axes[random.below(axes.len())]] += random.signed(0.2, 0.6);
    }
    Place { lines: rows.into_iter().map(Record::line).collect(), ..Place::default() }
}
