//! The differential hull: how what is reached changes with one number.

use cdpr::metamodel::reachable::{Reachable, Varied, differential_hull};
use cdpr::metamodel::sensitivity::{Cause, Offsets};
use cdpr::workspace::hull::{self, Hull};
use cdpr::workspace::{Bounds, Region};
use serde::Serialize;

use crate::failure::Failure;
use crate::sensitivities::place_of;
use crate::study_file::StudyFile;

/// A change of one number, and the hull with it.
#[derive(Serialize)]
pub(super) struct Differential {
    /// Name of the number.
    pub(super) parameter: String,
    /// Its unit; `1` for a share.
    pub(super) unit: &'static str,
    /// How much it changes.
    pub(super) change: f64,
    /// How fast each ray's end moves (m per unit); null where the box cuts the ray.
    rates_m_per_unit: Vec<Option<f64>>,
    /// How fast the area or volume changes (m² or m³ per unit).
    pub(super) size_rate: f64,
    /// Area or volume after the change (m², m³), to first order.
    pub(super) first_order_size: f64,
    /// The same from a hull found anew; nothing where it has none.
    pub(super) recomputed_size: Option<f64>,
    /// The hull after the change, to first order.
    #[serde(skip)]
    pub(super) moved: Hull,
    /// The hull found anew.
    #[serde(skip)]
    pub(super) anew: Option<Hull>,
}

/// The number of this name; near ones are told.
pub(super) fn cause_named(study_file: &StudyFile, name: &str) -> Result<Cause, Failure> {
    let all = study_file.causes(Offsets::Kept);
    place_of(&all, &study_file.machine, name, "--vary").map(|place| all[place])
}

/// The hull of a changed robot, to first order and anew.
pub(super) fn differential(
    study_file: &StudyFile,
    reachable: &Reachable<'_>,
    region: &Region<'_>,
    (nominal, bounds, settings): (&Hull, &Bounds, &hull::Settings),
    (cause, change): (&Cause, f64),
) -> Result<Differential, Failure> {
    let refused = |error: cdpr::metamodel::InputError| study_file.refused(&error);
    let motion = differential_hull(reachable, region, nominal, cause).map_err(refused)?;
    let varied = Varied::new(reachable, cause, change).map_err(refused)?;
    let criterion = varied.reachable().map_err(refused)?;
    // a centre that is no longer reached has no hull
    let anew = hull::solve(&region.with_criterion(&criterion), bounds, &nominal.center, settings).ok();
    let anew = anew.filter(Hull::is_star_shaped);
    let moved = motion.moved(nominal, change);
    let size = |hull: &Hull| hull.measure().map(|measure| measure.size);
    Ok(Differential {
        parameter: cause.name(&study_file.machine),
        unit: cause.kind.unit(),
        change,
        size_rate: motion.size_rate(nominal),
        first_order_size: size(&moved).unwrap_or(0.0),
        recomputed_size: anew.as_ref().and_then(size),
        rates_m_per_unit: motion.rates,
        moved,
        anew,
    })
}
