//! Figures of results: values in, drawings out, each as an SVG file that stands alone and prints well, or as a part of a page.
//!
//! Our own writer of lines, discs and texts: a plotting crate would bring more code than these figures are, and another
//! look than the report.

mod arrow;
mod axis;
mod bode;
mod box_map;
pub mod colour;
mod colour_bar;
mod condition_cells;
mod convergence;
mod correlations;
mod cost_curves;
mod course;
mod difference_map;
mod drawing;
mod end_names;
mod error_rows;
mod figure;
mod frame;
mod ladder;
mod map;
mod markup;
mod outlines;
mod page_style;
mod penalty_path;
mod profiles;
mod residuals;
mod shares;
mod spectrum;
mod timeline;
mod tracking;

pub use bode::{Bode, BodeCurve, BodePoint};
pub use box_map::{BoxCell, BoxMap};
pub use condition_cells::ConditionCells;
pub use convergence::convergence;
pub use correlations::correlations;
pub use cost_curves::{CostCurve, CostCurves};
pub use course::{CourseHeight, CoursePanel, course, rounds};
pub use difference_map::{DifferenceMap, DifferencePoint};
pub use error_rows::{ErrorPanel, ErrorRows};
pub use figure::Figure;
pub use ladder::{Ladder, NamedError, Rung};
pub use map::{Map, MapPoint};
pub use outlines::{Look, Outline, Outlines};
pub use page_style::page_style;
pub use penalty_path::PathCurves;
pub use profiles::{ProfileCurves, profiles};
pub use residuals::residuals;
pub use shares::{ShareCurve, Shares};
pub use spectrum::spectrum;
pub use timeline::{TimePanel, Timeline};
pub use tracking::{TrackedCable, tension_tracking};
