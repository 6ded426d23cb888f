//! The methods by name, and what can be relied on of each.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::reading::{Keyword, did_you_mean, keywords};

/// How tensions are chosen among those that balance the load. Each has a module of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Method {
    /// The nearest to the reference within the limits (`quadratic`).
    #[default]
    Qp,
    /// Balance nearest to the reference, whatever limits that breaks (eq. 3.41; `closed_form`).
    ClosedForm,
    /// The closed form, with the cable that breaks its limit most put on it, again and again (`improved_closed_form`).
    ImprovedClosedForm,
    /// The first point within the limits on the way from the minimum-norm tensions to the improved closed form (`puncture`).
    Puncture,
    /// Alternating projections on balance and limits (`dykstra`).
    Dykstra,
    /// The centroid of all allowed tensions (`centroid`).
    Centroid,
    /// The least p-norm of the tensions (`norm`).
    Minimum,
    /// The least p-norm of what is missing to the largest tensions (`norm`).
    Maximum,
    /// The largest product of the distances to all limits (`barrier`).
    Barrier,
    /// Tensions within the limits whose wrench is the nearest to what balance asks for (`nearest_wrench`).
    NearestWrench,
}

/// Text that names no method.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownMethod(String);

keywords!(Method: Qp = "qp", ClosedForm = "closed-form", ImprovedClosedForm = "improved-closed-form", Puncture = "puncture", Dykstra = "dykstra", Centroid = "centroid", Minimum = "minimum", Maximum = "maximum", Barrier = "barrier", NearestWrench = "nearest-wrench");

impl Method {
    /// True when the method finds tensions wherever there are any. The others may miss them, and then say so
    /// ([`super::Status::NotFound`]).
    pub(crate) fn is_exact(self) -> bool {
        !matches!(self, Self::ClosedForm | Self::ImprovedClosedForm | Self::Puncture | Self::Dykstra)
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Self::named(text).ok_or_else(|| UnknownMethod(text.to_owned()))
    }
}

impl fmt::Display for UnknownMethod {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "there is no method `{}`; ", self.0)?;
        let names: Vec<_> = Method::ALL.iter().map(|method| method.name()).collect();
        if let Some(meant) = did_you_mean(&self.0, names.iter().copied()) {
            write!(f, "did you mean `{meant}`? ")?;
        }
        write!(f, "there are {}", names.join(", "))
    }
}

impl std::error::Error for UnknownMethod {}
