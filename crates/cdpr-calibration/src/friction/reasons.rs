//! Reasons why records leave quantities open.

use super::grouping::Grouping;
use super::grouping::Hanging;
use super::plateaus::Plateau;
use super::quantity::{Quantity, Undetermined};
use super::solution::{Figure, Solution};
use super::stribeck;
use super::weighed::Weighed;

/// Coulomb friction where it cannot be told from its growth or from friction by speed: that under the load with most plateaus, or friction at
/// their mean speed.
pub(super) fn mean_coulomb(weighed: &Weighed<'_>, grouping: &Grouping, plateaus: &[&Plateau]) -> Option<Figure> {
    let mut groups: Vec<usize> = (0..grouping.loads.len()).collect();
    let of = |group: usize| plateaus.iter().filter(move |plateau| plateau.group == group);
    groups.sort_by_key(|&group| std::cmp::Reverse(of(group).count()));
    groups.retain(|&group| of(group).count() > 0);
    let under = |&group: &usize| {
        let (value, gradient) = weighed.coulomb(grouping.hung(group));
        weighed.figure(value, &gradient)
    };
    let at = |&group: &usize| {
        let mean = of(group).map(|plateau| plateau.speed.abs()).sum::<f64>() / of(group).count() as f64;
        weighed.friction(grouping.hung(group), mean)
    };
    groups.iter().find_map(under).or_else(|| groups.iter().find_map(at))
}

/// A fit of which is asked what it leaves open.
pub(super) struct Asked<'a> {
    pub(super) solution: &'a Solution,
    pub(super) weighed: &'a Weighed<'a>,
    pub(super) grouping: &'a Grouping,
    pub(super) plateaus: &'a [&'a Plateau],
    pub(super) judged: &'a stribeck::Judged,
}

impl Asked<'_> {
    /// All quantities that are open.
    pub(super) fn reasons(&self) -> Vec<Undetermined> {
        let Self { solution, weighed, grouping, .. } = *self;
        let mut all = Vec::new();
        let mut open = |quantity: Quantity, reason: String| all.push(Undetermined { quantity, reason });
        let law = weighed.fit.law;
        if let Some(reason) = no_load(self) {
            if solution.loads.iter().any(|load| load.torque.is_none()) {
                open(Quantity::Load, reason.clone());
            }
            if solution.coulomb.is_none() {
                open(Quantity::Coulomb, reason);
            }
        }
        let speeds = solution.speeds.unwrap_or_default();
        let range = match speeds {
            [0.0, 0.0] => "no row moves".to_owned(),
            [low, high] if high - low <= super::least_squares::SAME * high => {
                format!("all plateaus have one speed, {high:.4} rad/s")
            }
            [low, high] => {
                format!("speeds of {low:.4} to {high:.4} rad/s stand with directions and loads that differ as they do")
            }
        };
        let coulomb_is_open = law_open(weighed, law.coulomb());
        if solution.viscous.is_none() {
            let whole =
                if solution.coulomb.is_some() { "; coulomb_Nm is the whole friction at this speed" } else { "" };
            open(
                Quantity::Viscous,
                format!(
                    "{range}: friction by speed cannot be told from dry friction{whole}. Record each direction at two speeds or more, one of them three times the other"
                ),
            );
            if coulomb_is_open && solution.coulomb.is_some() {
                open(
                    Quantity::Coulomb,
                    format!("{range}: what coulomb_Nm tells is dry friction and friction by speed together"),
                );
            }
        }
        if solution.coulomb_by_load.is_none() {
            let reason = match (grouping.loads.len(), law.by_load) {
                (1, _) => "the records have one load: coulomb_Nm is that under this load. Record another one, three times as heavy or a third".to_owned(),
                (_, false) => "the loads of the records do not differ: coulomb_Nm is that under them. Record loads that differ by a factor of two or more".to_owned(),
                (_, true) => "not each of two loads was lifted and lowered at speeds that they share: growth with the load cannot be told from the rest".to_owned(),
            };
            open(Quantity::CoulombByLoad, reason);
        }
        if grouping.is_given && solution.load_scale.is_none() {
            let reason = "load torques are fitted by scale and offset where two given loads or more were lifted and lowered; of one load their sum is told, load_Nm";
            open(Quantity::LoadScale, reason.to_owned());
            open(Quantity::LoadOffset, reason.to_owned());
        }
        let differ = "Coulomb friction that is larger by d while lifting and smaller by d while lowering is a load torque larger by d: the fitted load takes it, coulomb_Nm is the mean of both directions";
        let differ = if grouping.is_given {
            format!("{differ}; loads[] tells both directions as they are if load_Nm is exact")
        } else {
            differ.to_owned()
        };
        open(Quantity::CoulombByDirection, differ);
        if solution.standing.is_none() {
            let reason = no_stribeck(solution, self.judged);
            open(Quantity::Static, reason.clone());
            open(Quantity::StribeckSpeed, reason);
        }
        all
    }
}

/// True for a parameter that the data leave open.
fn law_open(weighed: &Weighed<'_>, place: usize) -> bool {
    let mut gradient = vec![0.0; weighed.fit.law.count()];
    gradient[place] = 1.0;
    weighed.fit.variance(&gradient).is_none()
}

/// Why load or Coulomb friction cannot be told; `None` if both can.
fn no_load(asked: &Asked<'_>) -> Option<String> {
    let Asked { solution, weighed, grouping, plateaus, .. } = *asked;
    let [lifting, lowering] = solution.directions;
    if solution.coulomb.is_some() && solution.loads.iter().all(|load| load.torque.is_some()) {
        return None;
    }
    if lifting + lowering == 0 {
        let left_out = solution.left_out;
        return Some(format!(
            "no row slides at constant speed: {} rows are at rest, {} accelerate, {} belong to no settled stretch. Record stretches of constant speed, each of several turns, lifting and lowering",
            left_out.at_rest, left_out.accelerating, left_out.unsettled
        ));
    }
    let word =
        |is_lifting: bool| if is_lifting { ("lifting", "lowering", "+") } else { ("lowering", "lifting", "−") };
    if lifting == 0 || lowering == 0 {
        let (have, lack, sign) = word(lowering == 0);
        let known = sum(weighed, grouping, plateaus).map_or_else(String::new, |(at, figure)| {
            format!(" (load {sign} friction at {at:.4} rad/s are {} N·m together)", shown(&figure))
        });
        return Some(format!(
            "all {} plateaus are {have}: {have} alone cannot tell friction from the load{known}; the torque of a load that is wrong by 3 % looks like friction of 3 % of it. Record {lack}, too",
            lifting + lowering
        ));
    }
    let alone: Vec<String> = (0..grouping.loads.len())
        .filter(|&group| solution.loads[group].torque.is_none())
        .map(|group| match grouping.loads[group] {
            Hanging { torque: Some(torque), .. } => format!("of {torque:.4} N·m"),
            Hanging { mass: Some(mass), .. } => format!("of {mass} kg"),
            Hanging { record, .. } => format!("of record {}", record + 1),
        })
        .collect();
    Some(format!(
        "the load {} was not lifted and lowered at speeds that tell its torque from its friction: {} plateaus lift and {} lower. Record both directions of each load",
        alone.join(" and "),
        lifting,
        lowering
    ))
}

/// Sum that one direction tells: load with friction at the mean speed of the first load that has plateaus.
fn sum(weighed: &Weighed<'_>, grouping: &Grouping, plateaus: &[&Plateau]) -> Option<(f64, Figure)> {
    let first = plateaus.first()?;
    let own: Vec<f64> =
        plateaus.iter().filter(|plateau| plateau.group == first.group).map(|plateau| plateau.speed).collect();
    let speed = own.iter().sum::<f64>() / own.len() as f64;
    let load = grouping.loads[first.group].torque.or(first.load);
    let plateau = Plateau { speed, load, ..(*first).clone() };
    let mut gradient = vec![0.0; weighed.fit.law.count()];
    let torque = weighed.fit.law.torque(&plateau, &weighed.fit.parameters, &mut gradient);
    Some((speed.abs(), weighed.figure(torque, &gradient)?))
}

/// A number with its standard deviation in words.
pub(super) fn shown(figure: &Figure) -> String {
    match figure.sigma {
        Some(sigma) => format!("{:.4} ± {sigma:.4}", figure.value),
        None => format!("{:.4}", figure.value),
    }
}

/// Why the Stribeck part is not told.
fn no_stribeck(solution: &Solution, judged: &stribeck::Judged) -> String {
    let Some([lowest, _]) = solution.speeds else { return "no row slides at constant speed".to_owned() };
    let bound = solution.break_away.map_or_else(String::new, |torque| {
        format!("; rows at rest were held {torque:.4} N·m beyond the load, so static_Nm is no less")
    });
    let cure = "record several speeds below it, down to where the motor begins to stick";
    match (judged.gain, &judged.fit) {
        (None, _) => format!(
            "too few plateaus to ask for friction that falls with speed; the lowest speed is {lowest:.4} rad/s: {cure}{bound}"
        ),
        (Some(gain), None) => format!(
            "friction that falls with speed cannot be seen down to the lowest speed, {lowest:.4} rad/s (it gains {gain:.1} in Akaike's corrected criterion, {} would tell it): {cure}{bound}",
            stribeck::LEAST_GAIN
        ),
        (Some(gain), Some(_)) => format!(
            "friction falls with speed (gain {gain:.1}), but {} of the speeds recorded show it, down to {lowest:.4} rad/s, which does not tell how far and how fast: {cure}{bound}",
            judged.speeds
        ),
    }
}
