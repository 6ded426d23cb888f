//! Reachable workspaces in words.

use super::{Differential, ReachableAnswer};
use crate::answers::{Answer, Size};
use crate::number_format::{cell, significant};
use crate::table::Table;

impl ReachableAnswer {
    /// Workspaces that the box cuts, in words; empty without any.
    fn cut_words(&self) -> String {
        let (list, ends) = match self.at_bounds.as_slice() {
            [] => return String::new(),
            [one] => (format!("the {one} workspace"), "reaches"),
            [rest @ .., last] => (format!("the {} and the {last} workspace", rest.join(", the ")), "reach"),
        };
        let them = if ends == "reaches" { "it" } else { "them" };
        let share = match self.at_bounds.contains(&"physical") && !self.reaches_bounds {
            true => "; the shares are those of the part inside",
            false => "",
        };
        format!("{list} {ends} the faces of the box, so that more of {them} may lie outside{share}: see --bounds\n")
    }
}

impl Answer for ReachableAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let Self { control, machine, .. } = self;
        let unit = self.reachable.unit();
        let mut text = format!("{control} drives {machine}\n");
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}\n"));
        }
        let mut table = Table::new(["workspace", unit, "of the physical one"]);
        let mut row = |name: String, size: Size| {
            let share = self.share_of(size.value).map(|share| 100.0 * share);
            let share = share.map_or_else(String::new, |share| format!("{share:.1} %"));
            table.row(vec![name, cell(size.value, 3), share]);
        };
        row("physical: the machine is wrench-feasible".to_owned(), self.physical);
        row("model: the control model is".to_owned(), self.model);
        row("reachable, by commanded poses".to_owned(), self.reachable);
        self.compensation.iter().for_each(|map| row("the same without the map".to_owned(), map.without.size));
        row("reachable, by emerging poses".to_owned(), self.emerging);
        self.linear.iter().for_each(|size| row("reachable, as one linear step tells".to_owned(), *size));
        for one in &self.by_accuracy {
            row(format!("reachable to {} mm", significant(1e3 * one.position_error_max_m, 3)), one.reached.size);
        }
        text.push_str(&format!("\n{}", table.text(width)));
        if self.linear.and_then(|size| size.value).is_some_and(f64::is_nan) {
            text.push_str("\nwhat one linear step reaches is not star-shaped: --method grid counts it\n");
        }
        if let Some(remark) = &self.remark {
            text.push_str(&format!("\n{remark}\n"));
        }
        if let Some(bound) = self.error_bound {
            let sure = self.confidence.map(|share| format!("; {} % sure", significant(100.0 * share, 3)));
            text.push_str(&format!(
                "\nthe reachable one is known to ± {bound:.3} {unit} ({} points, {}{})\n",
                self.points,
                self.method,
                sure.unwrap_or_default()
            ));
        }
        if let Some(Differential {
            parameter, unit: of, change, size_rate, first_order_size, recomputed_size, ..
        }) = &self.differential
        {
            let anew = recomputed_size.map_or_else(|| "has no hull".to_owned(), |size| format!("is {size:.3} {unit}"));
            let of = if *of == "1" { String::new() } else { format!(" {of}") };
            text.push_str(&format!(
                "\nwith {parameter} changed by {change}{of} it is {first_order_size:.3} {unit} to first order ({size_rate:.3} {unit} per{}), found \
                 anew it {anew}\n",
                if of.is_empty() { " 1".to_owned() } else { of.clone() }
            ));
        }
        if let Some(parts) = self.parts.as_ref().filter(|parts| parts.len() > 1) {
            let small: f64 = parts[1..].iter().map(|part| part.size.value).sum();
            text.push_str(&format!(
                "it has {} parts that do not touch; the largest has {:.3} {unit}, the others together {small:.3} {unit}\n",
                parts.len(),
                parts[0].size.value
            ));
        }
        text.push_str(&self.cut_words());
        text
    }
}
