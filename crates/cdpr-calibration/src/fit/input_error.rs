//! Data and settings that no fit can accept.

use thiserror::Error;

use crate::loss::Loss;
use crate::objective::Minimize;
use crate::progress::Stopped;
use cdpr_model::cable::GeometryError;
use cdpr_model::measurement::KnownError;
use cdpr_model::model::{ModelError, ParameterError, WinchError};
use cdpr_model::reading::Keyword;
use cdpr_model::robot::ParameterKind;
use cdpr_model::statics::LoadError;

/// Data or settings that no fit can accept.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum InputError {
    /// The caller's progress asked to stop.
    #[error("the work was stopped before its end, as its caller asked")]
    Stopped,
    /// No offset of the clocks that fits best.
    #[error(
        "`clock-offset` is free, but the samples tell none: it takes 30 samples with times (column t_s) of a platform that moves between them"
    )]
    NoClockOffset,
    /// Too few poses that the lengths determine.
    #[error(
        "a frame is free, but the recorded lengths determine only {poses} poses of the robot as its file has it, and {needed} are needed to start \
         from: are lengths and robot file right, and are there as many cables as degrees of freedom?"
    )]
    NoFrames {
        /// Poses found.
        poses: usize,
        /// Poses needed.
        needed: usize,
    },
    /// A free frame beside a record without any component of a pose.
    #[error(
        "`{name}` is free, but the record has no component of a pose in which it shows: leave it out, or record positions (x_m, y_m, z_m) or orientations"
    )]
    FramesOfNothing {
        /// The frame.
        name: &'static str,
    },
    /// The marker of a platform without orientation.
    #[error(
        "`marker-frame` is free, but a point platform does not turn, so that its marker is nowhere else than the tracker's world is: free \
         `tracker-frame` alone"
    )]
    MarkerOfPoint,
    /// The free parameters do not fit the model.
    #[error(transparent)]
    Parameters(#[from] ParameterError),
    /// The calibrated robot is not a model.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// Motor angles that the robot's winches cannot have.
    #[error(transparent)]
    Winch(#[from] WinchError),
    /// A recorded tension that the model's cable cannot have.
    #[error("sample {sample}, cable {cable}: {reason}; is the recorded tension right, or the cable's weight?")]
    CableState {
        /// Number of the sample, from 1.
        sample: usize,
        /// Number of the cable, from 1.
        cable: usize,
        /// Reason why the cable has no state.
        reason: cdpr_model::cable::CableStateError,
    },
    /// No samples.
    #[error("the data set has no samples")]
    NoSamples,
    /// Data of another robot.
    #[error("the robot has {robot} cables, the data have {data}")]
    CableCount {
        /// Cables of the robot.
        robot: usize,
        /// Cables in the data.
        data: usize,
    },
    /// Fewer rows than parameters.
    #[error(
        "cable {cable} has {parameters} free parameters, but there are only {samples} samples: measure more poses, free fewer parameters, or give every kind a prior"
    )]
    TooFewSamples {
        /// Number of the cable, from 1.
        cable: usize,
        /// Its free parameters.
        parameters: usize,
        /// Samples.
        samples: usize,
    },
    /// Fewer rows than parameters of an elastic model.
    #[error(
        "{parameters} parameters are free, but {samples} samples give only {rows} rows of wrenches and lengths: measure more poses, \
         free fewer parameters, or give every kind a prior"
    )]
    TooFewRows {
        /// Free parameters without prior.
        parameters: usize,
        /// Rows.
        rows: usize,
        /// Samples.
        samples: usize,
    },
    /// A measured pose at which the model has no length.
    #[error("sample {sample}: {reason}")]
    Degenerate {
        /// Number of the sample, from 1.
        sample: usize,
        /// Reason why the cable has no path there.
        reason: GeometryError,
    },
    /// A prior that cannot be read.
    #[error(
        "cannot read the prior `{text}`: write NAME=SIGMA with a standard deviation above 0, e.g. platform-anchor=0.02"
    )]
    PriorSyntax {
        /// The text.
        text: String,
    },
    /// Parameters of drums without recorded motor angles.
    #[error(
        "`{kind}` is free, but the data record lengths: give the columns motor_angle_rad_1, motor_angle_rad_2, … in their place, or \
         free `length-offset` or `length-scale` instead"
    )]
    NoMotorAngles {
        /// The parameter.
        kind: ParameterKind,
    },
    /// An elastic model without recorded tensions.
    #[error(
        "identifying an elastic model needs tensions, which statics tells only of a known load on no more cables than degrees of freedom: add the columns tension_N_1, tension_N_2, … to the data, or choose a \
         model without `elastic`"
    )]
    NoTensions,
    /// Poses of an elastic model without recorded tensions.
    #[error(
        "the poses that an elastic model predicts do not tell its stiffness and load apart: recorded tensions are needed beside them, so \
         add the columns tension_N_1, tension_N_2, … to the data, or choose a model without `elastic`"
    )]
    PosesWithoutTensions,
    /// Poses of a task without a task.
    #[error("poses count by a task, and no task is given")]
    NoTask,
    /// Poses as unknowns of an elastic model.
    #[error(
        "wrenches and lengths of an elastic model are weighed by the accuracy of the measured poses already, so that poses are no unknowns of theirs: \
         take the objective `length`"
    )]
    UnknownPosesOfElastic,
    /// Poses as unknowns without accuracies.
    #[error(
        "poses are unknowns beside lengths where the accuracies of both are known: state length_m and position_m (and rotation_rad), in the sidecar file \
         DATA.meta.toml or by --sigma"
    )]
    NoAccuracies,
    /// Measurements that poses and tensions of their samples explain whole.
    #[error(
        "without measured poses the {rows} equations of a sample ({sensors}) tell its {unknowns} unknowns ({of}) and nothing else: no equation is left for the parameters. \
         Calibration without poses needs more cables than degrees of freedom, recorded tensions of a known load, swivel angles, an inclinometer, or a part of every pose measured"
    )]
    NoEquationLeft {
        /// Equations of a sample.
        rows: usize,
        /// Their sources in words.
        sensors: String,
        /// Unknowns of a sample.
        unknowns: usize,
        /// Their names in words.
        of: &'static str,
    },
    /// Changes of lengths beside other sensors.
    #[error(
        "lengths that count from an unknown pose, beside tensions, swivels or an inclinometer, are lengths with an unknown offset of each cable: free `length-offset` \
         (a calibrated file then has the winches' zeros), or leave the other columns out"
    )]
    ChangesBesideSensors,
    /// Swivel angles without what they count from.
    #[error(
        "swivel angles count about `pulley_swivel_axis` from gravity's part across it: cable {cable} of the robot file lacks this axis, or the file lacks `gravity_m_s2`, or both are parallel"
    )]
    NoSwivel {
        /// Number of the cable, from 1.
        cable: usize,
    },
    /// A thing known of another robot.
    #[error(transparent)]
    Known(#[from] KnownError),
    /// Motions that nothing fixes, where something is to.
    #[error(
        "the gauge `known` takes the frame from what is measured, known or held, but nothing measured changes by: {motions}. Hold that many coordinates, give known \
         positions or things, or choose the gauge `anchors` or `least-change`"
    )]
    GaugeOpen {
        /// The motions.
        motions: String,
    },
    /// Fewer equations than parameters where poses are unknown.
    #[error(
        "{parameters} free parameters and {equations} equations: each of {samples} samples at an unknown pose leaves as many as it has more measurements than unknowns. Record more \
         poses, free less, or state priors (--prior)"
    )]
    TooFewEquations {
        /// Free parameters that the gauge does not hold.
        parameters: usize,
        /// Equations.
        equations: usize,
        /// Samples.
        samples: usize,
    },
    /// Lengths that no poses belong to.
    #[error(
        "no poses are found at which the recorded lengths fit the robot at its file's values: are these the lengths of this robot, in metres, in the order of its cables?"
    )]
    NoPoses,
    /// A robust loss of what has no square.
    #[error(
        "the loss `{}` says what squares count, and the {minimize} of norms has none: minimise squares, or leave the loss out (single outliers hardly move the \
         mean of norms)",
        .loss.name()
    )]
    RobustCost {
        /// The loss.
        loss: Loss,
        /// The cost.
        minimize: Minimize,
    },
    /// Priors beside a cost that is no sum of squares.
    #[error(
        "priors add squares in units of standard deviations, which the {minimize} of norms has not: minimise squares, or give no prior"
    )]
    PriorCost {
        /// The cost.
        minimize: Minimize,
    },
    /// Row weights beside what has no rows to weigh.
    #[error(
        "row weights are of the squares of lengths and wrenches of an elastic model, not of {words}: leave them or that out"
    )]
    RowWeightCost {
        /// The other cost in words.
        words: String,
    },
    /// Row weights that cannot be read.
    #[error(
        "cannot read the row weights `{text}`: write length=W, wrench=W or both with numbers above 0, e.g. length=1e4,wrench=1"
    )]
    RowWeightSyntax {
        /// The text.
        text: String,
    },
    /// A scale that cannot be read.
    #[error(
        "cannot read the scale `{text}`: write NAME=UNIT with a number above 0, e.g. compliance=1e-6, or two names A,B for a map"
    )]
    ScaleSyntax {
        /// The text.
        text: String,
    },
    /// Scales of parameters that are not free.
    #[error("a map over the scales of {names} needs both of them free and different from each other")]
    ScaledTwice {
        /// The kinds.
        names: String,
    },
    /// A penalty beside another cost than squares.
    #[error("a path of penalties is one of squared lengths and wrenches, not of {words}: leave that out")]
    PenaltyCost {
        /// The other cost in words.
        words: String,
    },
    /// Profiles of a cost that is no sum of squares.
    #[error(
        "a profile's interval follows from a sum of squares, which the {minimize} of norms is not: a bootstrap tells deviations of this cost"
    )]
    ProfileCost {
        /// The cost.
        minimize: Minimize,
    },
    /// Frames or clocks beside another cost than squared lengths.
    #[error("`{name}` is found by squares of lengths: identify it so first, and hold it then")]
    RecordingCost {
        /// The parameter of the recording.
        name: &'static str,
    },
    /// A change of recorded lengths that the samples do not determine.
    #[error(
        "`{name}` is free, but the samples do not tell it: it takes rows of the fit before and after, and lengths or poses that do not change with it alike"
    )]
    ShiftUntold {
        /// Name of the change.
        name: String,
    },
    /// A change of recorded lengths beside drums that are identified from motor angles.
    #[error(
        "`{shift}` and `{kind}` are both free: recorded are motor angles, and lengths follow from them by the drum; identify one and hold the other"
    )]
    ShiftOfAngles {
        /// Name of the change.
        shift: String,
        /// The parameter of the drum.
        kind: ParameterKind,
    },
    /// Zeros of swivels without recorded angles of them.
    #[error(
        "`swivel-offset` is free, but no swivel angles are rows: it takes the columns swivel_rad_1 … of a record without measured poses"
    )]
    NoSwivelAngles,
    /// A start that predicts no pose.
    #[error(
        "sample {sample}: the model as given predicts no pose from the recorded lengths ({reason}): identify by lengths first, or mend the \
         robot file"
    )]
    NoPrediction {
        /// Number of the sample, from 1.
        sample: usize,
        /// Reason of the forward problem.
        reason: String,
    },
    /// Recorded tensions of cables that push.
    #[error(
        "negative tensions: cable {cable} is recorded with {tension} N in sample {}{}; cables can only pull, so check the sign and \
         the zero of the force sensors (tension_offset_N), or remove the samples", .samples[0], others(.samples)
    )]
    NegativeTension {
        /// Samples concerned, from 1.
        samples: Vec<usize>,
        /// Cable of the first one, from 1.
        cable: usize,
        /// Its recorded tension (N).
        tension: f64,
    },
    /// The load on the platform is unknown.
    #[error("{0}; or free `wrench`")]
    Load(#[from] LoadError),
    /// Numbers that overflow.
    #[error(
        "the residuals are not finite numbers: check the units of poses, lengths, tensions and of the robot's file"
    )]
    NotFinite,
    /// A setting that means nothing.
    #[error("the setting `{name}` is {value}; it must be a number above 0")]
    Setting {
        /// Field of [`super::Settings`].
        name: &'static str,
        /// Its value.
        value: f64,
    },
}

/// Words for the samples after the first.
fn others(samples: &[usize]) -> String {
    let listed: Vec<String> = samples.iter().skip(1).take(8).map(usize::to_string).collect();
    match samples.len() {
        0 | 1 => String::new(),
        count if count <= 9 => format!(", and others in {}", listed.join(", ")),
        count => format!(", and others in {} and {} more", listed.join(", "), count - 9),
    }
}

impl From<Stopped> for InputError {
    fn from(_: Stopped) -> Self {
        Self::Stopped
    }
}
