//! Motions of everything together that the rows do not see, and parameters that fix them.

use nalgebra::{DMatrix, DVector, Vector3};

use super::equations::Equation;
use crate::gauge_convention::GaugeConvention;
use crate::residual::rows::Rows;
use cdpr_model::geometry::Twist;
use cdpr_model::measurement::InternalSamples;
use cdpr_model::model::Model;
use cdpr_model::reading::Keyword;
use cdpr_model::robot::{Component, Frame, Parameter, ParameterKind};
use cdpr_model::scalar::decomposition::svd;

/// Change of the rows below which a motion changes none, beside the sizes that add up to it.
const UNSEEN: f64 = 1e-7;
/// Change of the rows with the size, beside the changes that add up to it, below which the rows do not tell it: where poses are known or radii held it is above 0.1.
const HAIR: f64 = 0.02;
/// Name of the change of everything by one factor.
const SIZE: &str = "size";
/// Name of the change of all forces by one factor.
const FORCES: &str = "size of all forces";
/// Share of the largest motion of an anchor that tells motions apart.
const APART: f64 = 1e-3;
/// Share of a motion that is another one.
const SAME: f64 = 1e-6;

/// Motions of everything together that no length sees, and the convention that fixes them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct GaugeFixing {
    /// `anchors`: parameters held at the file's values; `least-change`: anchors as near to the file's as the data let them be; `known`: measurements leave nothing
    /// to fix.
    pub kind: &'static str,
    /// Freedom that the data leave: `translation`, `rotation`, `mirror`, `scale`.
    pub free: Vec<&'static str>,
    /// The motions that no row sees, and the size where the lengths leave it open.
    pub motions: Vec<String>,
    /// Parameters that stay at the file's values to fix them.
    pub held: Vec<String>,
    /// True where lengths count from their values at the world's origin.
    pub at_origin: bool,
}

/// A shift and a turn about an origin.
struct Rigid {
    shift: Vector3<f64>,
    turn: Vector3<f64>,
}

/// Gauge of free parameters.
pub(super) struct Gauge {
    /// Names of the motions.
    motions: Vec<String>,
    /// Places of the parameters that fix them.
    pub(super) held: Vec<usize>,
    /// Changes of the parameters by the motions, a column each.
    pub(super) moves: DMatrix<f64>,
    /// Change of the rows with the size, beside the changes that add up to it; `None` if no free parameter changes it, or it is not seen at all.
    size: Option<f64>,
}

/// A motion of everything together, with the change of every parameter by it.
struct Motion {
    name: String,
    changes: DVector<f64>,
    /// True where the residuals grow with everything else, since the recorded lengths do.
    grows_residuals: bool,
}

impl Gauge {
    /// Gauge at a model's values, where these are the rows.
    pub(super) fn of(model: &Model, parameters: &[Parameter], rows: &Rows, lengths: &DVector<f64>) -> Self {
        let motions = motions(model, parameters);
        let mut seen = DMatrix::zeros(rows.jacobian.nrows(), motions.len());
        for (mut column, motion) in seen.column_iter_mut().zip(&motions) {
            let sizes = rows.jacobian.column_iter().zip(motion.changes.iter());
            let size: f64 = sizes.map(|(column, change)| column.norm() * change.abs()).sum();
            let mut change = &rows.jacobian * &motion.changes;
            if motion.grows_residuals {
                change -= lengths;
            }
            column.copy_from(&(change / size.max(f64::MIN_POSITIVE)));
        }
        let unseen = unseen(seen.clone());
        let is_named = |k: &usize| unseen.row(*k).norm() > 1.0 - SAME;
        let is_size = |motion: &Motion| motion.name == SIZE;
        let size = motions.iter().position(is_size).map(|k| seen.column(k).norm()).filter(|size| *size > UNSEEN);
        let mut names: Vec<String> = (0..motions.len()).filter(is_named).map(|k| motions[k].name.clone()).collect();
        let others = unseen.ncols() - names.len();
        if others > 0 {
            names.push(format!("{others} further motions, each a shift and a turn together"));
        }
        let mut moved = DMatrix::zeros(parameters.len(), motions.len());
        motions.iter().enumerate().for_each(|(k, motion)| moved.set_column(k, &motion.changes));
        let moves = moved * unseen;
        let held = held(moves.clone(), model, parameters);
        Self { motions: names, held, moves, size }
    }

    /// The motions in words.
    pub(super) fn words(&self) -> String {
        self.motions.join(", ")
    }

    /// Equations that keep anchors as near to a model's as the motions let them be: Gᵀ (p − p₀) = 0, the same with the motions G at p₀ and at p (turns are
    /// antisymmetric). What moves no anchor keeps the other parameters near.
    pub(super) fn stillness(&self, model: &Model, parameters: &[Parameter], weight: f64) -> Vec<Equation> {
        let is_anchor = |parameter: &Parameter| {
            matches!(parameter.kind, ParameterKind::FrameAnchor | ParameterKind::PlatformAnchor)
        };
        let still = |column: usize| {
            let own = |place: usize| if is_anchor(&parameters[place]) { self.moves[(place, column)] } else { 0.0 };
            let of_anchors = DVector::from_fn(parameters.len(), |place, _| own(place));
            let moves = if of_anchors.norm() > SAME { of_anchors } else { self.moves.column(column).into_owned() };
            let start = |place: usize| parameters[place].value(model.robot());
            let moved = moves.normalize();
            let coefficients = moved.iter().enumerate().filter(|(_, amount)| **amount != 0.0);
            let coefficients = coefficients.map(|(place, amount)| (parameters[place], *amount, start(place))).collect();
            Equation::Still { coefficients, weight }
        };
        (0..self.held.len()).map(still).collect()
    }

    /// Warning of a size that the rows see, but do not tell.
    pub(super) fn scale_warning(&self) -> Option<String> {
        let seen = self.size.filter(|size| *size < HAIR)?;
        Some(format!(
            "scale hangs on a hair: a robot of another size, its drums included, changes the lengths by {:.1} % of what its parts change them, so that the size found \
             here is not one to build on; give one known distance (a position in the columns of the pose), or hold a radius that was measured, as with \
             --hold drum-radius[1]",
            100.0 * seen
        ))
    }

    pub(super) fn told(
        self,
        model: &Model,
        parameters: &[Parameter],
        internal: &InternalSamples,
        convention: GaugeConvention,
    ) -> GaugeFixing {
        let is_held = convention == GaugeConvention::Anchors;
        let is_point = model.robot().cables.iter().all(|cable| cable.platform_anchor == Vector3::zeros());
        let has = |word: &str| self.motions.iter().any(|motion| motion.contains(word));
        let is_free_origin = internal.are_changes && internal.known_count() == 0;
        let free = [
            ("translation", is_free_origin || has("shift")),
            ("rotation", has("turn")),
            ("mirror", is_point && internal.known_count() == 0 && !self.motions.is_empty()),
            ("scale", self.motions.iter().any(|motion| motion == SIZE)),
        ];
        GaugeFixing {
            kind: if self.motions.is_empty() && !is_free_origin { "known" } else { convention.name() },
            free: free.into_iter().filter(|(_, is_free)| *is_free).map(|(word, _)| word).collect(),
            at_origin: internal.are_changes,
            motions: self.motions,
            held: self.held.into_iter().filter(|_| is_held).map(|k| parameters[k].name(model.robot())).collect(),
        }
    }
}

/// Combinations of motions that change no row: a column each.
fn unseen(seen: DMatrix<f64>) -> DMatrix<f64> {
    let count = seen.ncols();
    let none = || DMatrix::zeros(count, 0);
    if count == 0 {
        return none();
    }
    // as many rows as motions at least, or the decomposition leaves null directions out
    let rows = seen.nrows().max(count);
    let Some(found) = svd(seen.resize_vertically(rows, 0.0), false, true) else { return none() };
    let Some(right) = found.v_t else { return none() };
    let places: Vec<usize> = (0..count).filter(|&k| found.singular_values[k] < UNSEEN).collect();
    DMatrix::from_fn(count, places.len(), |row, column| right[(places[column], row)])
}

/// Shifts and turns of the world and of the platform's frame, and a change of size, where they move a free parameter.
fn motions(model: &Model, parameters: &[Parameter]) -> Vec<Motion> {
    let is_scaled = parameters.iter().any(|parameter| parameter.kind == ParameterKind::LengthScale);
    let (mut all, mut apart) = (Vec::new(), Apart::default());
    let mut push = |name: String, change: &dyn Fn(&Parameter) -> f64| {
        let changes = DVector::from_iterator(parameters.len(), parameters.iter().map(change));
        if changes.norm() > 0.0 {
            let grows_residuals = name == SIZE && !is_scaled;
            // a few numbers move alike by several motions: the first of them is enough
            if name != SIZE && !apart.add(&changes) {
                return;
            }
            all.push(Motion { name, changes, grows_residuals });
        }
    };
    let robot = model.robot();
    let frames = robot.tracked.unwrap_or_default();
    let of_frame = |parameter: &Parameter, shift: &Vector3<f64>, turn: &Vector3<f64>| {
        let frame = if parameter.kind == ParameterKind::TrackerFrame { &frames.tracker } else { &frames.marker };
        let motion = Rigid { shift: *shift, turn: *turn };
        robot.frame_component(parameter.axis).map_or(0.0, |component| moved_component(frame, &component, &motion))
    };
    let axis_of = |parameter: &Parameter| model.axes().get(parameter.axis).copied().unwrap_or_else(Vector3::zeros);
    let places: [(&str, ParameterKind); 2] =
        [("", ParameterKind::FrameAnchor), (" of the platform's frame", ParameterKind::PlatformAnchor)];
    for (of, kind) in places {
        let anchor = |parameter: &Parameter| match kind {
            ParameterKind::FrameAnchor => robot.cables[parameter.cable].frame_anchor,
            _ => robot.cables[parameter.cable].platform_anchor,
        };
        for twist in model.twist_basis() {
            let (shift, turn) = (twist.fixed_rows::<3>(0).into_owned(), twist.fixed_rows::<3>(3).into_owned());
            let is_turn = turn.norm() > 0.0;
            let name = axis_name(if is_turn { &turn } else { &shift });
            let name = if is_turn { format!("turn about {name}{of}") } else { format!("shift along {name}{of}") };
            let of_world = kind == ParameterKind::FrameAnchor && is_turn;
            let center = robot.platform.center_of_mass.unwrap_or_else(Vector3::zeros);
            push(name, &|parameter| match parameter.kind {
                ParameterKind::TrackerFrame if kind == ParameterKind::FrameAnchor => of_frame(parameter, &shift, &turn),
                ParameterKind::MarkerFrame if kind == ParameterKind::PlatformAnchor => {
                    of_frame(parameter, &shift, &turn)
                }
                ParameterKind::CenterOfMass if kind == ParameterKind::PlatformAnchor => {
                    (shift + turn.cross(&center)).dot(&axis_of(parameter))
                }
                own if own == kind => (shift + turn.cross(&anchor(parameter))).dot(&axis_of(parameter)),
                ParameterKind::Wrench if of_world => turned_wrench(model, parameter, &turn),
                ParameterKind::SwivelAxis if of_world => {
                    parameter.turned_axis(robot).map_or(0.0, |(_, about)| about.dot(&turn))
                }
                _ => 0.0,
            });
        }
        if kind == ParameterKind::FrameAnchor && model.dof() == model.axes().len() {
            // a point turns with the world
            for (name, turn) in turns_of_points(model) {
                push(format!("turn about {name}"), &|parameter| match parameter.kind {
                    own if own == kind => turn.cross(&anchor(parameter)).dot(&axis_of(parameter)),
                    ParameterKind::TrackerFrame => of_frame(parameter, &Vector3::zeros(), &turn),
                    _ => 0.0,
                });
            }
        }
    }
    push(SIZE.to_owned(), &|parameter| match parameter.kind {
        ParameterKind::FrameAnchor => robot.cables[parameter.cable].frame_anchor.dot(&axis_of(parameter)),
        ParameterKind::PlatformAnchor => robot.cables[parameter.cable].platform_anchor.dot(&axis_of(parameter)),
        ParameterKind::LengthScale => -parameter.value(robot),
        ParameterKind::Wrench if is_turn(&model.twist_basis()[parameter.axis]) => parameter.value(robot),
        ParameterKind::CenterOfMass => parameter.value(robot),
        kind if kind.is_of_ideal_winch() && !is_scaled => parameter.value(robot),
        _ => 0.0,
    });
    push(FORCES.to_owned(), &|parameter| match parameter.kind {
        ParameterKind::Wrench | ParameterKind::Mass => parameter.value(robot),
        ParameterKind::TensionScale | ParameterKind::Compliance => -parameter.value(robot),
        ParameterKind::Stretch(number) if number.entry().unit == "N" => parameter.value(robot),
        _ => 0.0,
    });
    all
}

/// Orthonormal directions of the changes so far.
#[derive(Default)]
struct Apart(Vec<DVector<f64>>);

impl Apart {
    /// Adds changes; false where those before them add up to them.
    fn add(&mut self, changes: &DVector<f64>) -> bool {
        let mut left = changes.clone();
        // twice is enough for right angles to rounding
        for direction in self.0.iter().chain(&self.0) {
            left -= direction * direction.dot(&left);
        }
        let is_new = left.norm() > SAME * changes.norm();
        if is_new {
            self.0.push(left.normalize());
        }
        is_new
    }
}

/// Change of a component of a frame where everything that it stands in moves by a shift and a turn about the origin.
fn moved_component(frame: &Frame, component: &Component, motion: &Rigid) -> f64 {
    match component {
        Component::Shift(axis) => axis.dot(&(motion.shift + motion.turn.cross(&frame.position))),
        Component::Turn(axis) => {
            frame.turn_by_vector().try_inverse().map_or(0.0, |by_turn| axis.dot(&(by_turn * motion.turn)))
        }
    }
}

fn is_turn(twist: &Twist) -> bool {
    twist.fixed_rows::<3>(3).norm_squared() > 0.0
}

/// Change of a component of the constant wrench with a turn of the world.
fn turned_wrench(model: &Model, parameter: &Parameter, turn: &Vector3<f64>) -> f64 {
    let Some(external) = &model.robot().external_wrench else { return 0.0 };
    let [force, moment] = [0, 3].map(|first| turn.cross(&external.wrench.fixed_rows::<3>(first).into_owned()));
    let twist = &model.twist_basis()[parameter.axis];
    twist.fixed_rows::<3>(0).dot(&force) + twist.fixed_rows::<3>(3).dot(&moment)
}

/// Shifts and turns of the world in which a robot moves.
pub(super) fn rigid_motions(model: &Model) -> Vec<(Vector3<f64>, Vector3<f64>)> {
    let own = model
        .twist_basis()
        .iter()
        .map(|twist| (twist.fixed_rows::<3>(0).into_owned(), twist.fixed_rows::<3>(3).into_owned()));
    let has_points = model.dof() == model.axes().len();
    let of_points = if has_points { turns_of_points(model) } else { Vec::new() };
    own.chain(of_points.into_iter().map(|(_, turn)| (Vector3::zeros(), turn))).collect()
}

/// Axes about which the world of a robot without turns can be turned.
fn turns_of_points(model: &Model) -> Vec<(String, Vector3<f64>)> {
    let turns = match model.axes() {
        [first, second] => vec![first.cross(second)],
        axes => axes.to_vec(),
    };
    turns.into_iter().map(|turn| (axis_name(&turn).to_owned(), turn)).collect()
}

fn axis_name(axis: &Vector3<f64>) -> &'static str {
    ["x", "y", "z"][axis.iamax()]
}

/// Parameters that the motions move most, one for each: anchors while these tell the motions apart, since a newton is no metre; at equal sizes one whose value is zero, then the first.
fn held(mut moved: DMatrix<f64>, model: &Model, parameters: &[Parameter]) -> Vec<usize> {
    let mut held = Vec::new();
    let largest_of = |moved: &DMatrix<f64>, anchors: bool| {
        let own = (0..parameters.len()).filter(|&k| !anchors || parameters[k].kind.is_anchor());
        own.map(|k| moved.row(k).norm()).fold(0.0, f64::max)
    };
    let whole = largest_of(&moved, true);
    for _ in 0..moved.ncols() {
        let size = |k: usize| moved.row(k).norm();
        let anchors = largest_of(&moved, true) > APART * whole;
        let largest = largest_of(&moved, anchors);
        let near = |k: &usize| (!anchors || parameters[*k].kind.is_anchor()) && size(*k) > (1.0 - SAME) * largest;
        let is_zero = |k: &usize| parameters[*k].value(model.robot()) == 0.0;
        let first = |mut places: Box<dyn Iterator<Item = usize> + '_>| places.next();
        let all = || (0..parameters.len()).filter(near);
        let Some(place) = first(Box::new(all().filter(is_zero))).or_else(|| first(Box::new(all()))) else { break };
        let row = moved.row(place).transpose();
        let left = &moved * &row * (row.transpose() / row.norm_squared());
        moved -= left;
        held.push(place);
    }
    held.sort_unstable();
    held
}
