//! Friction and loads of a winch from records at constant speeds.

use cdpr_calibration::Verdict;
use cdpr_calibration::friction::{Figure, HangingLoad, Judged, Solution};
use cdpr_calibration::selection::Warnings;
use schemars::JsonSchema;
use serde::Serialize;

use super::Answer;
use super::friction_words::words;
use super::identification_words::reason_of;
use crate::keys::WarningKeys;

/// A number of each quantity; null where the records do not tell it.
#[derive(Serialize, JsonSchema)]
#[expect(non_snake_case, reason = "keys carry their units")]
#[schemars(rename = "Friction{T}")]
struct Quantities<T> {
    /// Of the torque of the load (N·m).
    load_Nm: Option<T>,
    /// Of the fitted load torque per given one.
    load_scale: Option<T>,
    /// Of the fitted torque without load (N·m).
    load_offset_Nm: Option<T>,
    /// Of Coulomb friction (N·m).
    coulomb_Nm: Option<T>,
    /// Of its growth per torque of the load.
    coulomb_by_load: Option<T>,
    /// Of friction per speed (N·m·s/rad).
    viscous_Nm_s_per_rad: Option<T>,
    /// Of static friction (N·m).
    static_Nm: Option<T>,
    /// Of the Stribeck speed (rad/s).
    stribeck_speed_rad_per_s: Option<T>,
}

/// Standard deviation, in the schema.
#[derive(JsonSchema)]
#[schemars(inline, rename = "Sigmas")]
#[expect(dead_code, reason = "names the numbers in the schema")]
struct Sigma(f64);

/// Ends of an interval, in the schema.
#[derive(JsonSchema)]
#[schemars(inline, rename = "Intervals")]
#[expect(dead_code, reason = "names the numbers in the schema")]
struct Interval([f64; 2]);

impl<T> Quantities<T> {
    fn of(solution: &Solution, told: impl Fn(&Figure) -> Option<T>) -> Self {
        let told = |figure: Option<Figure>| figure.and_then(|figure| told(&figure));
        Self {
            load_Nm: told(only_load(solution)),
            load_scale: told(solution.load_scale),
            load_offset_Nm: told(solution.load_offset),
            coulomb_Nm: told(solution.coulomb),
            coulomb_by_load: told(solution.coulomb_by_load),
            viscous_Nm_s_per_rad: told(solution.viscous),
            static_Nm: told(solution.standing),
            stribeck_speed_rad_per_s: told(solution.stribeck_speed),
        }
    }
}

/// Torque of the load where there is one alone.
fn only_load(solution: &Solution) -> Option<Figure> {
    match solution.loads.as_slice() {
        [load] => load.torque,
        _ => None,
    }
}

/// One load that hung from the winch.
#[derive(Serialize, JsonSchema)]
#[expect(non_snake_case, reason = "keys carry their units")]
#[schemars(rename = "HangingLoad")]
struct LoadAnswer {
    /// First record with it, counted from 1.
    record: usize,
    /// Its mass in a column `load_kg`, which tells loads apart (kg).
    mass_kg: Option<f64>,
    /// Its torque as the records give it (N·m).
    given_Nm: Option<f64>,
    /// Its torque by the fit (N·m); null where it cannot be told from friction.
    load_Nm: Option<f64>,
    /// Standard deviation of it (N·m).
    load_sigma_Nm: Option<f64>,
    /// Coulomb friction under it, the mean of both directions (N·m).
    coulomb_Nm: Option<f64>,
    /// Standard deviation of it (N·m).
    coulomb_sigma_Nm: Option<f64>,
    /// Coulomb friction while lifting, if the given torque is exact (N·m).
    coulomb_lifting_if_exact_Nm: Option<f64>,
    /// Coulomb friction while lowering, if the given torque is exact (N·m).
    coulomb_lowering_if_exact_Nm: Option<f64>,
    /// Plateaus with it.
    plateaus: usize,
}

impl LoadAnswer {
    fn of(load: &HangingLoad) -> Self {
        Self {
            record: load.record + 1,
            mass_kg: load.mass,
            given_Nm: load.given,
            load_Nm: load.torque.map(|own| own.value),
            load_sigma_Nm: load.torque.and_then(|own| own.sigma),
            coulomb_Nm: load.coulomb.map(|own| own.value),
            coulomb_sigma_Nm: load.coulomb.and_then(|own| own.sigma),
            coulomb_lifting_if_exact_Nm: load.if_exact.map(|[lifting, _]| lifting.value),
            coulomb_lowering_if_exact_Nm: load.if_exact.map(|[_, lowering]| lowering.value),
            plateaus: load.plateaus,
        }
    }
}

/// A constant speed beside the fit.
#[derive(Serialize, JsonSchema)]
#[expect(non_snake_case, reason = "keys carry their units")]
#[schemars(rename = "SpeedPlateau")]
struct PlateauAnswer {
    /// Its record, counted from 1.
    record: usize,
    /// First line of its rows.
    first_line: usize,
    /// Last line of its rows.
    last_line: usize,
    /// Rows that it is the mean of.
    samples: usize,
    /// Mean speed, lifting positive (rad/s).
    motor_speed_rad_per_s: f64,
    /// Mean torque (N·m).
    motor_torque_Nm: f64,
    /// Recorded minus fitted torque (N·m).
    residual_Nm: f64,
    /// True where it was left out, as none of the others.
    is_outlier: bool,
}

impl PlateauAnswer {
    fn of(judged: &Judged) -> Self {
        let plateau = &judged.plateau;
        Self {
            record: plateau.record + 1,
            first_line: plateau.lines[0],
            last_line: plateau.lines[1],
            samples: plateau.samples,
            motor_speed_rad_per_s: plateau.speed,
            motor_torque_Nm: plateau.torque,
            residual_Nm: judged.residual,
            is_outlier: judged.is_outlier,
        }
    }
}

/// Friction per speed of each direction.
#[derive(Serialize, JsonSchema)]
#[expect(non_snake_case, reason = "keys carry their units")]
#[schemars(rename = "ViscousByDirection")]
struct DirectionsAnswer {
    /// While lifting (N·m·s/rad).
    lifting_Nm_s_per_rad: f64,
    /// While lowering (N·m·s/rad).
    lowering_Nm_s_per_rad: f64,
    /// Standard deviation of the difference (N·m·s/rad).
    difference_sigma_Nm_s_per_rad: Option<f64>,
}

/// Rows that tell nothing about sliding friction.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "RowsLeftOut")]
struct LeftOutAnswer {
    /// Rows at rest.
    at_rest: usize,
    /// Rows of changing speed.
    accelerating: usize,
    /// Rows next to a change of speed, or in stretches too short for a mean.
    unsettled: usize,
    /// Rows or plateaus that are there twice.
    duplicates: usize,
    /// Plateaus that are none of the others.
    outliers: usize,
}

/// Why a quantity is null.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "OpenQuantity")]
struct ReasonAnswer {
    /// Key of the quantity.
    key: &'static str,
    /// The reason, with what to record.
    reason: String,
}

/// Friction and loads of a winch: torque = load + sign(speed)·(coulomb + coulomb_by_load·load + (static − coulomb)·exp(−(speed/stribeck_speed)²) + viscous·|speed|).
#[derive(Serialize, JsonSchema)]
#[expect(non_snake_case, reason = "keys carry their units")]
#[schemars(rename = "Friction")]
pub struct FrictionAnswer {
    status: &'static str,
    /// False where nobody should work with the numbers; the warnings say why.
    trusted: bool,
    #[serde(skip)]
    verdict: Verdict,
    /// Reason why load and friction are not told or not to be trusted.
    reason: Option<String>,
    /// Files of the records.
    records: Vec<String>,
    /// Torque of the load (N·m); null where there are several, see `loads`, and where it cannot be told from friction.
    load_Nm: Option<f64>,
    /// Fitted load torque per given one, where several loads are given.
    load_scale: Option<f64>,
    /// Fitted torque without load (N·m), where several loads are given.
    load_offset_Nm: Option<f64>,
    /// Dry friction while sliding (N·m), the mean of both directions; without load where it grows with the load.
    coulomb_Nm: Option<f64>,
    /// Growth of Coulomb friction per torque of the load (given, or else fitted).
    coulomb_by_load: Option<f64>,
    /// Friction per speed (N·m·s/rad).
    viscous_Nm_s_per_rad: Option<f64>,
    /// Dry friction towards standing still (N·m).
    static_Nm: Option<f64>,
    /// Speed over which dry friction falls from static_Nm to coulomb_Nm (rad/s).
    stribeck_speed_rad_per_s: Option<f64>,
    /// Root mean square of recorded minus fitted torques of plateaus (N·m).
    rms_Nm: f64,
    /// Standard deviations, under the keys of the numbers; null where nothing tells errors.
    #[schemars(with = "Quantities<Sigma>")]
    sigma: Quantities<f64>,
    /// 95 % intervals by Student's t, under the keys of the numbers.
    #[schemars(with = "Quantities<Interval>")]
    interval_95: Quantities<[f64; 2]>,
    /// Degrees of freedom of the intervals: plateaus beyond the numbers fitted, or blocks of samples where these tell the errors.
    degrees_of_freedom: usize,
    /// Keys of what the records do not tell.
    undetermined: Vec<&'static str>,
    /// Why each of them is not told, and what to record.
    undetermined_reasons: Vec<ReasonAnswer>,
    /// Loads that hung from the winch.
    loads: Vec<LoadAnswer>,
    /// Friction per speed of each direction.
    viscous_by_direction: Option<DirectionsAnswer>,
    /// Torque beyond the load at which the motor still stood (N·m): static friction is no less.
    break_away_at_least_Nm: Option<f64>,
    /// Gain of Akaike's corrected criterion by friction that falls with speed; 6 tells it.
    stribeck_gain: Option<f64>,
    /// Lowest speed of the plateaus (rad/s).
    speed_min_rad_per_s: Option<f64>,
    /// Highest speed of the plateaus (rad/s).
    speed_max_rad_per_s: Option<f64>,
    /// Plateaus that lift.
    lifting_plateaus: usize,
    /// Plateaus that lower.
    lowering_plateaus: usize,
    /// Sliding plateaus.
    plateaus: Vec<PlateauAnswer>,
    /// Rows and plateaus that were left out.
    left_out: LeftOutAnswer,
    /// Doubts about the numbers.
    #[serde(flatten, with = "WarningKeys")]
    #[schemars(with = "WarningKeys")]
    warnings: Warnings,
    #[serde(skip)]
    solution: Solution,
}

impl FrictionAnswer {
    /// Friction and loads from records of these names.
    pub fn new(solution: Solution, records: Vec<String>) -> Self {
        let warnings = Warnings { doubts: solution.doubts(), remarks: solution.remarks() };
        let verdict = Verdict::of_fit(&warnings.doubts);
        let value = Quantities::of(&solution, |figure| Some(figure.value));
        let left_out = solution.left_out;
        Self {
            status: verdict.fit_status(),
            trusted: verdict.is_trusted() && !verdict.is_negative(),
            verdict,
            reason: reason_of(verdict, &warnings.doubts),
            records,
            load_Nm: value.load_Nm,
            load_scale: value.load_scale,
            load_offset_Nm: value.load_offset_Nm,
            coulomb_Nm: value.coulomb_Nm,
            coulomb_by_load: value.coulomb_by_load,
            viscous_Nm_s_per_rad: value.viscous_Nm_s_per_rad,
            static_Nm: value.static_Nm,
            stribeck_speed_rad_per_s: value.stribeck_speed_rad_per_s,
            rms_Nm: solution.rms,
            sigma: Quantities::of(&solution, |figure| figure.sigma),
            interval_95: Quantities::of(&solution, |figure| solution.interval(figure)),
            degrees_of_freedom: solution.freedom,
            undetermined: solution.undetermined.iter().map(|open| open.quantity.key()).collect(),
            undetermined_reasons: solution
                .undetermined
                .iter()
                .map(|open| ReasonAnswer { key: open.quantity.key(), reason: open.reason.clone() })
                .collect(),
            loads: solution.loads.iter().map(LoadAnswer::of).collect(),
            viscous_by_direction: solution.viscous_by_direction.map(|own| DirectionsAnswer {
                lifting_Nm_s_per_rad: own.lifting.value,
                lowering_Nm_s_per_rad: own.lowering.value,
                difference_sigma_Nm_s_per_rad: own.difference.sigma,
            }),
            break_away_at_least_Nm: solution.break_away,
            stribeck_gain: solution.stribeck_gain.filter(|gain| gain.is_finite()),
            speed_min_rad_per_s: solution.speeds.map(|[low, _]| low),
            speed_max_rad_per_s: solution.speeds.map(|[_, high]| high),
            lifting_plateaus: solution.directions[0],
            lowering_plateaus: solution.directions[1],
            plateaus: solution.plateaus.iter().map(PlateauAnswer::of).collect(),
            left_out: LeftOutAnswer {
                at_rest: left_out.at_rest,
                accelerating: left_out.accelerating,
                unsettled: left_out.unsettled,
                duplicates: left_out.duplicates,
                outliers: solution.plateaus.iter().filter(|own| own.is_outlier).count(),
            },
            warnings,
            solution,
        }
    }
}

impl Answer for FrictionAnswer {
    fn is_negative(&self) -> bool {
        self.verdict.is_negative()
    }

    fn may_be_accepted(&self) -> bool {
        self.verdict.may_be_accepted()
    }

    fn words(&self, width: Option<usize>) -> String {
        words(&self.solution, &self.records, &self.warnings, width)
    }
}
