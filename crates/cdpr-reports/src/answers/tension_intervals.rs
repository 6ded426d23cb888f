//! Tensions that statics alone does not determine, in words.

use cdpr_model::model::Model;
use cdpr_model::tension::Intervals;

use crate::number_format::significant;

/// Remark on cables that would each have one tension, were their pulls independent of each other: fewer than degrees of freedom, or as many.
/// More cables than that leave a choice by design, and get none.
pub fn undetermined_words(model: &Model, intervals: &Intervals) -> Option<String> {
    if intervals.freedom == 0 || model.cable_count() > model.dof() {
        return None;
    }
    let of_cable = |(index, [least, largest]): (usize, &[f64; 2])| {
        let (cable, least) = (index + 1, newtons(*least));
        match largest.is_finite() {
            true => format!("cable {cable} {least} to {} N", newtons(*largest)),
            false => format!("cable {cable} {least} N or more"),
        }
    };
    let ranges: Vec<String> = intervals.ranges.iter().enumerate().map(of_cable).collect();
    let free = match intervals.freedom {
        1 => "one tension is".to_owned(),
        count => format!("{count} tensions are"),
    };
    Some(format!(
        "statics alone does not determine the tensions: {free} free, and all of these balance the load: {}; which ones a machine has is \
         decided by lengths and stiffness that a rigid model does not know, so take the answer's for one of many",
        ranges.join(", ")
    ))
}

/// Four digits, and 0 for rounding.
fn newtons(value: f64) -> String {
    if value.abs() < 1e-9 { "0".to_owned() } else { significant(value, 4) }
}
