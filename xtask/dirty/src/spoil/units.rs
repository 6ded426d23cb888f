//! Numbers in other units than their columns say, and other words in the header.

use crate::kinds::Place;
use crate::random::Random;
use crate::scene::Scene;

/// Metres under `x_mm`.
pub(crate) fn metres_in_mm(scene: &mut Scene, _: &mut Random) -> Place {
    scene.data.style.position_unit = "mm";
    Place::default()
}

/// Feet under `x_m`.
pub(crate) fn feet(scene: &mut Scene, _: &mut Random) -> Place {
    scene.data.style.position_factors = [1.0 / 0.3048; 3];
    Place::default()
}

/// Inches in one column of positions.
pub(crate) fn inches_in_one_column(scene: &mut Scene, random: &mut Random) -> Place {
    let axes = scene.robot().freedom().axes;
    scene.data.style.position_factors[axes[random.below(axes.len())]] = 1.0 / 0.0254;
    Place::default()
}

/// Kilograms-force under `tension_N`.
pub(crate) fn kilogram_force(scene: &mut Scene, _: &mut Random) -> Place {
    scene.data.style.tension_factor = 1.0 / 9.80665;
    Place::default()
}

/// `cable_length_m_0` is the first.
pub(crate) fn cables_from_0(scene: &mut Scene, _: &mut Random) -> Place {
    scene.data.style.first_cable = 0;
    Place::default()
}

/// Other words in `set` than `train` and `validation`.
pub(crate) fn set_words(scene: &mut Scene, _: &mut Random) -> Place {
    let rows = scene.data.rows.len();
    for (index, row) in scene.data.rows.iter_mut().enumerate() {
        row.set = Some(if 3 * index < 2 * rows { "training" } else { "val" });
    }
    Place::default()
}
