//! Sensitivities and tolerances for people.

use super::{AllowedAnswer, ParameterAnswer, SensitivityAnswer, ToleranceAnswer, step};
use cdpr_model::reading::Keyword;
use cdpr_study::sensitivity::{Kind, KindInfluence, Offsets, Side};
use cdpr_study::study::AccuracyOf;
use cdpr_study::tolerance::Quantiles;

use crate::answers::Answer;
use crate::number_format::{NONE, significant};
use crate::table::Table;

/// A deviation in the unit that people think in.
pub(crate) fn amount(value: f64, unit: &str) -> String {
    let (factor, unit) = match unit {
        "m" => (1e3, "mm"),
        "1" => (1e2, "%"),
        "rad" => (180.0 / std::f64::consts::PI, "°"),
        other => (1.0, other),
    };
    match value.is_finite() {
        true => format!("{} {unit}", significant(factor * value, 3)),
        false => "any".to_owned(),
    }
}

impl Answer for SensitivityAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let offsets = match self.offsets {
            Offsets::Kept => "kept",
            Offsets::SetAnew => "set anew",
        };
        let mut text = format!(
            "{} drives {} to {} poses; winch offsets are {offsets} when something deviates\n",
            self.control, self.machine, self.samples
        );
        text.push_str(&self.differentiation());
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}\n"));
        }
        text.push_str(&format!("\n{}\n{}", self.by_kind(width), self.by_parameter(width)));
        text.push_str(&self.other_names());
        if let Some(tolerance) = &self.tolerance {
            text.push_str(&tolerance_words(tolerance, width));
        }
        if let Some(allowed) = &self.allowed {
            text.push_str(&allowed_words(self, allowed, width));
        }
        text
    }
}

impl SensitivityAnswer {
    /// Way in which the derivatives of a machine that remembers are taken; empty for others.
    fn differentiation(&self) -> String {
        let poses = &self.difference_poses;
        match (poses.first(), self.difference_error) {
            (Some(first), Some(error)) => format!(
                "the machine remembers: {} of {} poses have central differences along its path, good to {} of the largest, since no \
                 derivative leads there (first pose {}: {})\n",
                poses.len(),
                self.samples,
                significant(error, 1),
                first.pose,
                first.reason
            ),
            _ if self.remembers => "the machine remembers: derivatives are exact along its path\n".to_owned(),
            _ => String::new(),
        }
    }

    /// True of kinds that are no other names of an error.
    fn counts(&self, side: Side, kind: Kind) -> bool {
        !self.same_errors.iter().any(|same| (same.side, same.kind) == (side, kind))
    }

    /// Names of errors that are left out, each behind the one that counts; empty where none is.
    fn other_names(&self) -> String {
        let mut counted: Vec<&str> = self.same_errors.iter().map(|same| same.counted_as.as_str()).collect();
        counted.sort_unstable();
        counted.dedup();
        let of = |first: &&str| {
            let others = self.same_errors.iter().filter(|same| same.counted_as == **first);
            format!("{first} ({})", others.map(|same| same.name.as_str()).collect::<Vec<_>>().join(", "))
        };
        match counted.is_empty() {
            true => String::new(),
            false => format!(
                "\nan error of several names counts once, as its other names are left out here: {}; [tolerances] states what deviates, and --format json has all\n",
                counted.iter().map(of).collect::<Vec<_>>().join(", ")
            ),
        }
    }

    /// Kinds, the most influential step first.
    fn by_kind(&self, width: Option<usize>) -> String {
        let mut rows: Vec<_> = self.kinds.iter().filter(|kind| self.counts(kind.side, kind.kind)).collect();
        rows.sort_by(|a, b| {
            let moved = |kind: &KindInfluence| step(kind.kind).0 * kind.position_rms;
            moved(b).total_cmp(&moved(a))
        });
        let mut table = Table::new(["all of a kind deviate", "count", "each by (σ)", "moves rms mm", "worst pose mm"])
            .left_column(2);
        for kind in rows {
            let (factor, each) = step(kind.kind);
            let moved = |way: f64| significant(1e3 * factor * way, 3);
            table.row(vec![
                format!("{} {}", kind.side.name(), kind.kind),
                kind.count.to_string(),
                each.to_owned(),
                moved(kind.position_rms),
                moved(kind.position_max),
            ]);
        }
        table.text(width)
    }

    /// Single parameters, the most influential step first.
    fn by_parameter(&self, width: Option<usize>) -> String {
        let counts = |one: &&ParameterAnswer| self.counts(one.influence.cause.side, one.influence.cause.kind);
        let mut rows: Vec<_> = self.parameters.iter().filter(counts).collect();
        rows.sort_by(|a, b| {
            let moved = |one: &ParameterAnswer| step(one.influence.cause.kind).0 * one.influence.position_mean;
            moved(b).total_cmp(&moved(a))
        });
        let has_tensions = rows.iter().any(|one| one.influence.tension_mean.is_some());
        let mut heading = vec!["parameter", "by", "moves mean mm", "max mm"];
        heading.extend(if self.has_rotation { &["turns max °"][..] } else { &[] });
        heading.extend(if has_tensions { &["tension max N"][..] } else { &[] });
        let mut table = Table::with_heading(heading.into_iter().map(str::to_owned).collect()).left_column(1);
        for ParameterAnswer { name, influence } in rows.into_iter().take(self.told) {
            let (factor, by) = step(influence.cause.kind);
            let told = |value: f64| significant(factor * value, 3);
            let mut row = vec![
                name.clone(),
                by.to_owned(),
                told(1e3 * influence.position_mean),
                told(1e3 * influence.position_max),
            ];
            if self.has_rotation {
                row.push(told(influence.rotation_max.to_degrees()));
            }
            if has_tensions {
                row.push(influence.tension_max.map_or(NONE.to_owned(), told));
            }
            table.row(row);
        }
        table.text(width)
    }
}

fn tolerance_words(tolerance: &ToleranceAnswer, width: Option<usize>) -> String {
    let mm = |value: f64| significant(1e3 * value, 3);
    let linear = &tolerance.linear;
    let mut text = format!(
        "\nto first order the tolerances move the platform by {} mm (rms), by {} mm at the worst pose, and by {} mm at most when \
             all are at their worst\n",
        mm(linear.deviation_rms_m),
        mm(linear.deviation_rms_at_worst_pose_m),
        mm(linear.worst_case_max_m)
    );
    let Some(drawn) = &tolerance.drawn else { return text };
    text.push_str(&format!("\n{} robots drawn\n", drawn.robots));
    let mut table = Table::new(["", "mean mm", "median mm", "95 % mm", "99 % mm", "max mm"]);
    let mut row = |name: &str, q: &Quantiles| {
        let cells = [q.mean, q.median, q.p95, q.p99, q.max].map(mm);
        table.row([vec![name.to_owned()], cells.to_vec()].concat());
    };
    row("error at a pose", &drawn.error);
    row("deviation at a pose", &drawn.deviation);
    row("mean error of a robot", &drawn.mean_of_robot);
    row("largest error of a robot", &drawn.max_of_robot);
    text.push_str(&table.text(width));
    if let Some(reason) = &drawn.reason {
        text.push_str(&format!("{} answers are missing and do not count: {reason}\n", drawn.unanswered));
    }
    text
}

fn allowed_words(answer: &SensitivityAnswer, allowed: &AllowedAnswer, width: Option<usize>) -> String {
    if allowed.kinds.is_empty() {
        return String::new();
    }
    let of = match allowed.accuracy_of {
        AccuracyOf::Error => "of the position",
        AccuracyOf::Deviation => "of the deviation alone",
    };
    let mut text = format!(
        "\nfor {} mm {of} ({} mm are left for deviations at pose {}) each of a kind may deviate by\n",
        significant(1e3 * allowed.accuracy_m, 3),
        significant(1e3 * allowed.least_budget_m, 3),
        allowed.worst_pose
    );
    let mut table = Table::new(["kind", "alone, σ", "alone, at most", "jointly, σ", "jointly, at most"]);
    for kind in allowed.kinds.iter().filter(|kind| answer.counts(kind.side, kind.kind)) {
        let joint = |value: Option<f64>| value.map_or(NONE.to_owned(), |value| amount(value, kind.unit));
        table.row(vec![
            format!("{} {}", kind.side.name(), kind.kind),
            amount(kind.alone, kind.unit),
            amount(kind.alone_worst_case, kind.unit),
            joint(kind.joint),
            joint(kind.joint_worst_case),
        ]);
    }
    text.push_str(&table.text(width));
    text
}
