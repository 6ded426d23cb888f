//! The differential hull: how what is reached changes with one number.

use cdpr_model::control::InputError;
use cdpr_study::Experiment;
use cdpr_study::reachable::{Reachable, Varied, differential_hull};
use cdpr_study::sensitivity::ParameterDeviation;
use cdpr_workspace::hull::{self, Hull};
use cdpr_workspace::{Bounds, Region};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};
use serde_json::json;

use crate::answers::Size;

/// A change of one number, and the hull with it.
pub struct Differential {
    /// Name of the number.
    pub parameter: String,
    /// Its unit; `1` for a share.
    pub unit: &'static str,
    /// Its change.
    pub change: f64,
    /// Speed of each ray's end (m per unit); null where the box cuts the ray.
    pub rates_m_per_unit: Vec<Option<f64>>,
    /// Rate of the area or volume (m² or m³ per unit).
    pub size_rate: f64,
    /// Area or volume after the change (m², m³), to first order.
    pub first_order_size: f64,
    /// The same from a hull found anew; `None` if it has none.
    pub recomputed_size: Option<f64>,
    /// The hull after the change, to first order.
    pub moved: Hull,
    /// The hull found anew.
    pub anew: Option<Hull>,
}

impl Serialize for Differential {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let key = |name| Size { name, is_planar: self.moved.dimension() == 2, value: () }.key();
        json!({
            "parameter": self.parameter, "unit": self.unit, "change": self.change, "rates_m_per_unit": self.rates_m_per_unit,
            format!("{}_per_unit", key("rate")): self.size_rate, key("first_order"): self.first_order_size,
            key("recomputed"): self.recomputed_size,
        })
        .serialize(serializer)
    }
}

/// Keys of a change, of an area or a volume.
#[derive(JsonSchema)]
#[schemars(rename = "ReachableChange")]
#[expect(dead_code, reason = "only the schema is made of it")]
pub(super) struct DifferentialKeys {
    /// Name of the number that changes.
    parameter: String,
    /// Its unit; `1` for a share.
    unit: String,
    /// Its change, in this unit.
    change: f64,
    /// Speed of each ray's end (m per unit); null where the box cuts the ray.
    rates_m_per_unit: Vec<Option<f64>>,
    /// Rate of the area (m² per unit).
    #[schemars(skip_serializing_if = "Option::is_none")]
    rate_area_m2_per_unit: Option<f64>,
    /// Rate of the volume (m³ per unit).
    #[schemars(skip_serializing_if = "Option::is_none")]
    rate_volume_m3_per_unit: Option<f64>,
    /// Area after the change (m²), to first order.
    #[schemars(skip_serializing_if = "Option::is_none")]
    first_order_area_m2: Option<f64>,
    /// Volume after the change (m³), to first order.
    #[schemars(skip_serializing_if = "Option::is_none")]
    first_order_volume_m3: Option<f64>,
    /// Area from a hull found anew (m²); null where it has none.
    #[schemars(skip_serializing_if = "Option::is_none")]
    recomputed_area_m2: Option<f64>,
    /// Volume from a hull found anew (m³); null where it has none.
    #[schemars(skip_serializing_if = "Option::is_none")]
    recomputed_volume_m3: Option<f64>,
}

/// A parameter and how much it changes, in its unit.
#[derive(Clone, Copy, Debug)]
pub struct Change<'a> {
    /// The parameter.
    pub cause: &'a ParameterDeviation,
    /// By how much.
    pub by: f64,
}

/// The hull of a changed robot, to first order and anew.
pub fn differential(
    experiment: &Experiment,
    reachable: &Reachable,
    region: &Region<'_>,
    nominal: &Hull,
    bounds: &Bounds,
    settings: &hull::Settings,
    change: Change<'_>,
) -> Result<Differential, InputError> {
    let Change { cause, by: change } = change;
    let motion = differential_hull(reachable, region, nominal, cause)?;
    let varied = Varied::new(reachable, cause, change)?;
    let criterion = varied.reachable()?;
    // a centre that is no longer reached has no hull
    let anew = hull::solve(&region.with_criterion(&criterion), bounds, &nominal.center, settings).ok();
    let anew = anew.filter(Hull::is_star_shaped);
    let moved = motion.moved(nominal, change);
    let size = |hull: &Hull| hull.measure().map(|measure| measure.size);
    Ok(Differential {
        parameter: cause.name(&experiment.machine),
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
