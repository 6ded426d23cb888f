//! Options of an identification that ask for more than a fit.

use std::path::PathBuf;

use cdpr_calibration::fit::{RowWeights, Settings};
use cdpr_calibration::{GaugeConvention, Penalty, Towards};
use cdpr_model::measurement::Known;
use cdpr_model::model::FreeParameters;
use cdpr_model::reading::Keyword;
use clap::Args;

use crate::keyword::keyword;

/// Convention for the frame of a robot whose poses nobody measured, facts known of it, and a robot to compare with.
#[derive(Debug, Args)]
pub(super) struct FrameArguments {
    /// Convention that fixes what data without poses leave free: anchors holds coordinates at the file's values, least-change keeps all anchors as near to the
    /// file's as the data let them be, known refuses data that leave a motion free.
    #[arg(long, value_name = "GAUGE", default_value = GaugeConvention::default().name(), value_parser = keyword::<GaugeConvention>())]
    pub(super) gauge: GaugeConvention,

    /// Fact known besides samples without poses: distance[1,2]=2.412, length[1]=1.597 (where changes count from), plane[1,2,3,4], wall-x[1,2], wall-y[1,2],
    /// level[1,2,3], equal-drum-radius[1,2]; each with a standard deviation in metres, e.g. distance[1,2]=2.412+-0.002 (without: 1 mm). May be repeated.
    #[arg(long, value_name = "FACT")]
    pub(super) known: Vec<Known>,

    /// Robot whose frame anchors the calibrated ones are compared with, after the motion that brings them together best (Procrustes).
    #[arg(long, value_name = "ROBOT")]
    pub(super) compare: Option<String>,
}

impl FrameArguments {
    /// The first of them that is asked for.
    pub(super) fn asked(&self) -> Option<&'static str> {
        [
            ("--gauge", self.gauge != GaugeConvention::default()),
            ("--known", !self.known.is_empty()),
            ("--compare", self.compare.is_some()),
        ]
        .into_iter()
        .find_map(|(option, is_asked)| is_asked.then_some(option))
    }
}

/// Options of a path.
#[derive(Clone, Debug, Args)]
pub(super) struct PathArguments {
    /// Follow a penalty on the free parameters from one that holds them all down to none: ridge, lasso (parameters leave one by one) or group-lasso
    /// (whole anchors leave). λ is the largest that is as good as the best on the same samples held out, by --split, --validation or five blocks.
    #[arg(long, value_name = "PENALTY", value_parser = keyword::<Penalty>())]
    pub(super) path: Option<Penalty>,

    /// Values from which changes are penalised: those of the file, or zero (ratios: one).
    #[arg(long, value_name = "CENTRE", default_value = Towards::default().name(), value_parser = keyword::<Towards>(), requires = "path")]
    pub(super) towards: Towards,

    /// Free parameters that the penalty acts on, e.g. platform-anchor. Default: all.
    #[arg(long, value_name = "LIST", default_value = "", hide_default_value = true, requires = "path")]
    pub(super) shrink: FreeParameters,

    /// Figure of the path to write (SVG): parameters and held-out error over λ.
    #[arg(long, value_name = "FILE", requires = "path")]
    pub(super) path_figure: Option<PathBuf>,

    /// Robot file at the chosen λ to write; `--out` is that of λ = 0, the fit.
    #[arg(long, value_name = "FILE", requires = "path")]
    pub(super) out_path: Option<PathBuf>,

    /// Robot file of the smaller model to write that the rank, the noise of orientations or the path show.
    #[arg(long, value_name = "FILE")]
    pub(super) out_reduced: Option<PathBuf>,
}

impl PathArguments {
    pub(super) fn is_asked(&self) -> bool {
        self.path.is_some() || self.out_reduced.is_some()
    }
}

/// Options of scales and weights.
#[derive(Clone, Debug, Args)]
pub(super) struct ScalingArguments {
    /// Tell the condition of the Jacobian with parameters counted in these units (SI), e.g. compliance=1e-6,wrench=1e3, or in those of the least condition
    /// (auto), and what makes it large. axial-stiffness counts compliances by 1/compliance. The fit does not depend on it.
    #[arg(long, value_name = "NAME=UNIT,…|auto", value_delimiter = ',')]
    pub(super) scale: Vec<String>,

    /// Weights of the rows of an elastic model in place of accuracies: length=W (1/m), wrench=W (1/N). Poses and tensions count as exact.
    #[arg(long, value_name = "NAME=WEIGHT,…")]
    pub(super) row_weight: Option<RowWeights>,

    /// Map of the condition over the units of two kinds (SVG), e.g. compliance,wrench map.svg.
    #[arg(long, value_names = ["A,B", "FILE"], num_args = 2)]
    pub(super) condition_map: Option<Vec<String>>,
}

impl ScalingArguments {
    pub(super) fn is_asked(&self) -> bool {
        !self.scale.is_empty() || self.row_weight.is_some() || self.condition_map.is_some()
    }

    /// Settings of a fit with these weights.
    pub(super) fn of(&self, settings: Settings) -> Settings {
        Settings { row_weights: self.row_weight, ..settings }
    }
}

/// Options of profiles and bootstrap.
#[derive(Clone, Debug, Args)]
pub(super) struct UncertaintyArguments {
    /// Profiles over these parameters, the others held and refitted, with 95 % intervals of the profile likelihood: a kind
    /// (`compliance`), a cable's (`frame-anchor[1]`), one number (`frame-anchor[1].x`), or `all`.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', conflicts_with = "split")]
    pub(super) profile: Vec<String>,

    /// Standard deviations by a bootstrap of so many data sets of blocks of consecutive samples, beside the linear ones.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(10..=100_000), conflicts_with = "split")]
    pub(super) bootstrap: Option<u32>,

    /// Folder for tables and figures: profiles, bootstrap, and maps of the deviation of the pose that the calibrated model drives to.
    #[arg(long, value_name = "DIR", conflicts_with = "split")]
    pub(super) uncertainty: Option<PathBuf>,
}

impl UncertaintyArguments {
    pub(super) fn is_asked(&self) -> bool {
        !self.profile.is_empty() || self.bootstrap.is_some() || self.uncertainty.is_some()
    }
}
