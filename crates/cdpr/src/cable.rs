//! One cable: outlet, law of stretch, span, winch.

#[doc(inline)]
pub use cdpr_model::cable::{CableInput, CableState, CableStateError, Recording};

pub mod law {
    //! Laws of a cable at rest.

    #[doc(inline)]
    pub use cdpr_model::cable::law::{CableLaw, Kind};
}

pub mod outlet {
    //! Outlets, at which cables leave the frame.

    #[doc(inline)]
    pub use cdpr_model::cable::outlet::Outlet;

    pub mod pulley {
        //! Guiding pulleys.

        #[doc(inline)]
        pub use cdpr_model::cable::outlet::pulley::{path_on_side, place};
    }
}

pub mod span {
    //! The cable between frame and platform.

    #[doc(inline)]
    pub use cdpr_model::cable::span::{Shape, SpanState};
}

pub mod stretch {
    //! How a cable stretches under its tension.

    #[doc(inline)]
    pub use cdpr_model::cable::stretch::{Stretch, hysteresis_law, polynomial_law};

    pub mod hysteresis {
        //! Stretch that depends on the past.

        #[doc(inline)]
        pub use cdpr_model::cable::stretch::hysteresis::{Hysteresis, Memory};
    }
}

pub mod winch {
    //! Drums on which cables are wound.

    #[doc(inline)]
    pub use cdpr_model::cable::winch::{Drum, DrumError, GrooveError, Mounting, Parameters};
}
