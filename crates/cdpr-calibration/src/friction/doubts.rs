//! Doubts about friction, and remarks on what was left out.

use cdpr_model::finding::{Finding, FindingKind, Severity};

use super::quantity::Quantity;
use super::reasons::shown;
use super::solution::{Figure, Solution};
use crate::student::t_95;
use crate::verdict::{Doubt, DoubtKind};

/// Ratios of the speed by positions to the recorded speed that are no noise.
const RATIO: [f64; 2] = [0.8, 1.25];

/// Units of speed in rad/s.
const UNITS: [(f64, &str); 4] = [
    (std::f64::consts::TAU, "turns/s"),
    (std::f64::consts::TAU / 60.0, "rpm"),
    (std::f64::consts::PI / 180.0, "deg/s"),
    (1e-3, "mrad/s"),
];

/// Misfit that is not to be trusted: of the standard errors of plateaus, and of Coulomb friction.
const MISFIT: (f64, f64) = (5.0, 0.5);

/// Standard deviations from which on directions differ.
const DIFFER: f64 = 4.0;

impl Solution {
    /// Doubts about load and friction, a sentence each, the worst first.
    pub fn doubts(&self) -> Vec<Doubt> {
        let mut doubts = Vec::new();
        if !self.is_determined() {
            let open =
                self.undetermined.iter().find(|open| matches!(open.quantity, Quantity::Load | Quantity::Coulomb));
            let reason = open.map_or("the records do not tell load and friction", |open| open.reason.as_str());
            doubts.push(Doubt::new(DoubtKind::NotIdentifiable, reason));
        }
        doubts.extend(self.unit());
        doubts.extend(self.sign());
        doubts.extend(self.misfit());
        if self.is_determined() {
            let main = [Quantity::Load, Quantity::Coulomb, Quantity::Viscous];
            for open in self.undetermined.iter().filter(|open| main.contains(&open.quantity)) {
                doubts.push(Doubt::new(DoubtKind::WeakDirection, format!("{}: {}", open.quantity.key(), open.reason)));
            }
            doubts.extend(self.spread());
        }
        doubts.extend(self.outliers());
        doubts.extend(self.directions_differ());
        doubts
    }

    /// Remarks on rows that were left out, and on loads that are not the stated ones.
    pub fn remarks(&self) -> Vec<String> {
        let left_out = self.left_out;
        let mut remarks = Vec::new();
        let mut count = |rows: usize, words: &str| {
            if rows > 0 {
                remarks.push(format!("{rows} rows {words}"));
            }
        };
        count(left_out.accelerating, "were left out: their speed changes");
        count(
            left_out.unsettled,
            "were left out: they lie next to a change of speed, or in stretches too short for a mean",
        );
        let bound = self.break_away.map_or_else(String::new, |torque| {
            format!("; the motor held up to {torque:.4} N·m beyond the load there, so standing friction is no less")
        });
        count(
            left_out.at_rest,
            &format!("were left out: at rest friction takes any value up to that of breaking away{bound}"),
        );
        count(left_out.duplicates, "or plateaus are there twice and count once");
        remarks.extend(self.stated_load());
        remarks
    }

    /// Speeds that the positions contradict.
    fn unit(&self) -> Option<Doubt> {
        let mut ratios: Vec<f64> = self.plateaus.iter().filter_map(|own| own.plateau.speed_ratio).collect();
        if ratios.is_empty() {
            return None;
        }
        let ratio = super::steady::median(&mut ratios);
        if (RATIO[0]..=RATIO[1]).contains(&ratio) {
            return None;
        }
        let unit = UNITS.iter().find(|(factor, _)| (ratio.abs() / factor).ln().abs() < 0.1);
        let unit = unit.map_or_else(String::new, |(_, unit)| format!(", as of speeds in {unit}"));
        let sign = if ratio < 0.0 { ", with the opposite sign" } else { "" };
        let text = format!(
            "not to be trusted: the positions of the motor change by {ratio:.4} of what its recorded speeds say{unit}{sign}: write motor_speed_rad_per_s in rad/s, lifting positive"
        );
        Some(Finding { value: Some(ratio), ..Finding::new(FindingKind::Unit, Severity::Distrust, text) }.into())
    }

    /// Friction that would give energy, and loads that pull upwards.
    fn sign(&self) -> Option<Doubt> {
        let below = |figure: &Figure| figure.value < 0.0 && self.interval(figure).is_none_or(|[_, high]| high < 0.0);
        let open = |quantity: Quantity| self.undetermined.iter().any(|open| open.quantity == quantity);
        let under =
            self.loads.iter().filter_map(|load| load.coulomb).chain(self.coulomb.filter(|_| open(Quantity::Coulomb)));
        if let Some(figure) = under.into_iter().find(below) {
            return Some(Doubt::new(
                DoubtKind::Law,
                format!(
                    "not to be trusted: Coulomb friction is {} N·m, below zero, and would drive the motor: is the sign of motor_speed_rad_per_s (lifting positive) or of motor_torque_Nm (against the load positive) reversed, or lifting taken for lowering?",
                    shown(&figure)
                ),
            ));
        }
        let load = self.loads.iter().filter_map(|load| load.torque).find(below);
        load.map(|figure| {
            let text = format!(
                "the load's torque is {} N·m, below zero: it pulls upwards. Are the signs of both columns reversed, or is there a counterweight?",
                shown(&figure)
            );
            Finding::new(FindingKind::Load, Severity::Caution, text).into()
        })
    }

    /// Plateaus that no law of one load follows, by what their samples say about their means.
    fn misfit(&self) -> Option<Doubt> {
        let used = || self.plateaus.iter().filter(|own| !own.is_outlier);
        let squares: Vec<f64> =
            used().filter_map(|own| own.plateau.standard_error).map(|error| error * error).collect();
        if squares.len() < used().count() || self.freedom == 0 {
            return None;
        }
        let expected = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
        let friction = self.loads.iter().filter_map(|load| load.coulomb).map(|own| own.value.abs()).fold(0.0, f64::max);
        (self.rms > MISFIT.0 * expected && self.rms > MISFIT.1 * friction).then(|| {
            let words = format!(
                "not to be trusted: plateaus are {:.4} N·m (rms) from the law, {:.0} times what their samples let expect, and as much as friction itself ({friction:.4} N·m): rows of different loads without load_Nm, or a load that changes on the way, or torques that are commanded and not needed",
                self.rms, self.rms / expected
            );
            Doubt::new(DoubtKind::Law, words)
        })
    }

    /// Friction that is not told from none, and numbers without a check.
    fn spread(&self) -> Option<Doubt> {
        let figure = self.coulomb?;
        let Some([low, _]) = self.interval(&figure) else {
            let words = format!(
                "{} plateaus determine as many numbers: nothing is left to tell their errors by, and sigma is empty. Record more speeds",
                self.directions[0] + self.directions[1]
            );
            return Some(Doubt::new(DoubtKind::WeakDirection, words));
        };
        let largest =
            self.loads.iter().filter_map(|load| load.coulomb).chain([figure]).filter_map(|own| self.interval(&own));
        if low > 0.0 || largest.fold(low, |most, [low, _]| most.max(low)) > 0.0 {
            return None;
        }
        let words = format!(
            "Coulomb friction, {} N·m, is not told apart from none: 95 % intervals are {:.1} standard deviations wide on both sides ({} degrees of freedom; plateaus are {:.4} N·m rms from the law). Record more plateaus, or longer ones",
            shown(&figure),
            t_95(self.freedom),
            self.freedom,
            self.rms
        );
        Some(Doubt::new(DoubtKind::WeakDirection, words))
    }

    fn outliers(&self) -> Option<Doubt> {
        let names: Vec<String> = self
            .plateaus
            .iter()
            .filter(|own| own.is_outlier)
            .map(|own| {
                let [first, last] = own.plateau.lines;
                let lines = if first == last { format!("line {first}") } else { format!("lines {first} to {last}") };
                format!(
                    "record {}, {lines} ({:+.4} N·m at {:.3} rad/s)",
                    own.plateau.record + 1,
                    own.residual,
                    own.plateau.speed
                )
            })
            .collect();
        (!names.is_empty()).then(|| {
            let words = format!(
                "{} of {} plateaus were left out, since they lie far off the law of all others: {}. Was the motor commanded a torque there, or touched, or not at constant speed?",
                names.len(), self.plateaus.len(), names.join("; ")
            );
            Doubt::new(DoubtKind::OutliersLeftOut, words)
        })
    }

    fn directions_differ(&self) -> Option<Doubt> {
        let own = self.viscous_by_direction?;
        let sigma = own.difference.sigma.filter(|sigma| *sigma > 0.0)?;
        // as rare as so many standard deviations of many degrees of freedom
        let least = DIFFER * t_95(self.freedom) / t_95(usize::MAX);
        let scale = self.speeds.map_or(0.0, |[_, high]| high) * own.difference.value.abs();
        (own.difference.value.abs() > least * sigma && scale > 1e-6 * self.coulomb?.value.abs()).then(|| {
            let words = format!(
                "friction by speed differs between lifting, {:.3e}, and lowering, {:.3e} N·m·s/rad, by {:.1} standard deviations: one law for both is a mean; do the loads change with the cable's length, or is a torque not settled?",
                own.lifting.value, own.lowering.value, (own.difference.value / sigma).abs()
            );
            Finding::new(FindingKind::LackOfFit, Severity::Caution, words).into()
        })
    }

    /// A load that is not the stated one.
    fn stated_load(&self) -> Option<String> {
        if let (Some(scale), Some(offset)) = (self.load_scale, self.load_offset) {
            return Some(format!(
                "fitted load torques are {} of the given ones and {} N·m: torque constant, drum radius and weights explain a scale, a sensor's zero an offset; Coulomb friction that differs between lifting and lowering does both and cannot be told from them",
                shown(&scale),
                shown(&offset)
            ));
        }
        let [load] = self.loads.as_slice() else { return None };
        let (given, torque) = (load.given?, load.torque?);
        let half = self.interval(&torque).map_or(0.0, |[low, high]| 0.5 * (high - low));
        ((torque.value - given).abs() > half.max(1e-6 * given.abs())).then(|| {
            format!(
                "the fitted load is {} N·m, the given one {given:.4} N·m ({:+.1} %): torque constant, drum radius or weights, or Coulomb friction that is {:.4} N·m larger in one direction than in the other; one load cannot tell which",
                shown(&torque), 100.0 * (torque.value / given - 1.0), 2.0 * (torque.value - given).abs()
            )
        })
    }
}
