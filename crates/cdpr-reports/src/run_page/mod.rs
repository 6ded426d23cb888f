//! The page of a run: playback of the machine with its tensions, and pose and tensions over time as drawings.

pub(crate) mod page_data;
#[cfg(test)]
mod tests;

use cdpr_model::geometry::Pose;
use minijinja::{Value, context};

use crate::answers::{RunAnswer, axis_names, components};
use crate::figures::{Figure, TimePanel, Timeline};
use crate::html_page::{Page, PageError, PageKind, plain, prose};
use crate::number_format::significant;
use crate::recording::{Moment, OTHERS, Recording, Violation, sentence, stretches_of_limits};

const TEMPLATE: &str = include_str!("run.html");

/// Rows of a table on the page, at most.
const MOST_ROWS: usize = 200;

/// Contents of a page.
pub struct RunPage<'a> {
    /// Record of the run.
    pub recording: &'a Recording<'a>,
    /// Its broken limits; slack cables that break none are not shown, but by warnings.
    pub violations: &'a [Violation],
    /// Answer that the page shows; text between backticks in its warnings is shown as code.
    pub answer: &'a RunAnswer,
    /// Name of the scenario.
    pub name: &'a str,
    /// Facts on machine, winches and time: terms with their text.
    pub facts: &'a [(&'static str, String)],
    /// The command that makes the same page again.
    pub command: &'a str,
    /// Version of the program.
    pub version: &'a str,
}

impl RunPage<'_> {
    /// HTML of the page.
    pub fn render(&self) -> Result<String, PageError> {
        let Self { recording, violations, answer, .. } = *self;
        let broken: Vec<&Violation> = self.broken().collect();
        let title = format!("Run of {}", self.name);
        let figure = |figure: Option<Figure>| figure.map(|figure| Value::from_safe_string(figure.inline()));
        let verdict = match (answer.status(), !broken.is_empty()) {
            ("completed", false) if answer.warnings().is_empty() => "good",
            ("completed", false) => "warned",
            _ => "bad",
        };
        let values = context! {
            verdict,
            headline => self.headline(),
            outcome => plain(&self.outcome()),
            facts => self.facts.iter().map(|(term, text)| context! { term => *term, text => plain(text) }).collect::<Value>(),
            pose_figure => figure(recording.pose_figure(violations)),
            tension_figure => figure(recording.tension_figure(violations)),
            events => self.events(),
            violations => broken.iter().take(MOST_ROWS).map(|one| context! {
                first => seconds(one.first), duration => seconds(one.duration), words => plain(&one.words),
            }).collect::<Value>(),
            more_violations => broken.len().saturating_sub(MOST_ROWS),
            warnings => answer.warnings().iter().map(|warning| prose(warning)).collect::<Vec<_>>(),
            command => plain(self.command),
        };
        let data = Some(page_data::json(answer, recording, violations));
        Page {
            kind: PageKind::Run,
            title: &title,
            class: "wide",
            template: TEMPLATE,
            values,
            data,
            version: self.version,
        }
        .render()
    }

    fn broken(&self) -> impl Iterator<Item = &Violation> {
        self.violations.iter().filter(|one| one.is_broken_limit())
    }

    fn headline(&self) -> String {
        let end = self.recording.moments.last().map_or(0.0, |moment| moment.time);
        let limits = if self.broken().next().is_some() { ", limits are broken" } else { "" };
        format!("{} after {} s{limits}", capital(self.answer.status()), significant(end, 4))
    }

    /// Sentence below the headline: reason first, then limits and tensions.
    fn outcome(&self) -> String {
        let (least, largest) = self.answer.tensions();
        let tensions = match least.is_finite() {
            true => format!(" Tensions from {} to {} N.", significant(least, 4), significant(largest, 4)),
            false => String::new(),
        };
        let limits = match (sentence(self.broken(), OTHERS), self.recording.limits.is_empty()) {
            (Some(_), _) if self.answer.status() == "completed" => String::new(),
            (Some(broken), _) => format!(" Limits are broken: {broken}."),
            (None, true) => " The limits of the tensions are not known.".to_owned(),
            (None, false) => " All tensions stay within their limits at every step.".to_owned(),
        };
        let reason = self.answer.reason().map(|reason| format!("{}.", capital(reason))).unwrap_or_default();
        format!("{reason}{limits}{tensions}").trim_start().to_owned()
    }

    fn events(&self) -> Value {
        let row = |(index, event): (usize, &crate::recording::Occurrence)| {
            context! { number => index + 1, time => seconds(event.time), words => plain(&event.words) }
        };
        self.recording.events.iter().enumerate().take(MOST_ROWS).map(row).collect()
    }
}

/// The text with a capital letter at its beginning.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn seconds(time: f64) -> String {
    format!("{time:.3}")
}

impl Recording<'_> {
    /// Position and orientation over time; `None` without two moments.
    pub fn pose_figure(&self, violations: &[Violation]) -> Option<Figure> {
        let robot = self.robot;
        let curve = |of: &dyn Fn(&Moment) -> f64| self.moments.iter().map(of).collect::<Vec<f64>>();
        let axes = axis_names(robot);
        let along = |axis: usize| curve(&|moment| components(robot, &moment.pose.position)[axis]);
        let mut panels = vec![TimePanel {
            title: "Position of the platform".to_owned(),
            label: "m".to_owned(),
            curves: axes.iter().enumerate().map(|(axis, name)| (name.clone(), along(axis))).collect(),
            limits: Vec::new(),
        }];
        if robot.motion_pattern.has_rotation() {
            let start = self.moments.first().map_or_else(Pose::identity, |moment| moment.pose);
            let turned = |moment: &Moment| (moment.pose.rotation * start.rotation.inverse()).scaled_axis();
            let names: Vec<(String, Vec<f64>)> = match robot.motion_pattern.is_planar() {
                true => {
                    vec![("angle".to_owned(), curve(&|moment| turned(moment).dot(&robot.plane.normal()).to_degrees()))]
                }
                false => (0..3)
                    .map(|axis| (axes[axis].clone(), curve(&|moment| turned(moment)[axis].to_degrees())))
                    .collect(),
            };
            let title = "Rotation from the first moment (rotation vector, world axes)".to_owned();
            panels.push(TimePanel { title, label: "°".to_owned(), curves: names, limits: Vec::new() });
        }
        self.timeline("Pose of the platform over time", panels, violations)
    }

    /// Tensions over time with their limits; `None` without two moments.
    pub fn tension_figure(&self, violations: &[Violation]) -> Option<Figure> {
        let cables = self.robot.cables.iter().enumerate();
        let curve = |index: usize| self.moments.iter().map(|moment| moment.tensions[index]).collect();
        let curves = cables.map(|(index, cable)| (cable.name.clone(), curve(index))).collect();
        let mut limits: Vec<f64> = self.limits.iter().flat_map(|&(least, largest)| [least, largest]).collect();
        limits.sort_by(f64::total_cmp);
        limits.dedup();
        let panel = TimePanel { title: "Tensions".to_owned(), label: "N".to_owned(), curves, limits };
        self.timeline("Tensions over time", vec![panel], violations)
    }

    fn timeline(&self, label: &str, panels: Vec<TimePanel>, violations: &[Violation]) -> Option<Figure> {
        let times: Vec<f64> = self.moments.iter().map(|moment| moment.time).collect();
        let events: Vec<f64> = self.events.iter().map(|event| event.time).collect();
        let marked = stretches_of_limits(violations).map(|stretch| (stretch.from_s, stretch.to_s));
        let marked = joined(marked.collect());
        Timeline { label, times: &times, panels, events: &events, marked: &marked }.svg()
    }
}

/// Stretches of time, those that touch made one.
fn joined(mut spans: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut all: Vec<(f64, f64)> = Vec::new();
    for span in spans {
        match all.last_mut() {
            Some(last) if span.0 <= last.1 => last.1 = last.1.max(span.1),
            _ => all.push(span),
        }
    }
    all
}
