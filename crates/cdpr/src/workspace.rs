//! Sets of poses at which criteria hold.

#[doc(inline)]
pub use cdpr_workspace::{
    Archetype, Bounds, Criterion, Point, Region, Verdict, Workspace, WorkspaceError, WorkspaceSize,
};

pub mod criterion {
    //! Criteria, which judge one pose.

    #[doc(inline)]
    pub use cdpr_workspace::criterion::{All, Any, WrenchFeasible};

    pub mod registry {
        //! Criteria by name.

        #[doc(inline)]
        pub use cdpr_workspace::criterion::registry::{CriterionRequest, Setting, all};
    }
}

pub mod differential {
    //! Sets that two models share.

    #[doc(inline)]
    pub use cdpr_workspace::differential::{Differences, Motion, motion};
}

pub mod grid {
    //! Sets on regular grids.

    #[doc(inline)]
    pub use cdpr_workspace::grid::{Count, Grid, count};
}

pub mod hull {
    //! Hulls by rays from a centre.

    #[doc(inline)]
    pub use cdpr_workspace::hull::{Hull, Settings, Status, solve};
}

pub mod mesh {
    //! Meshes of a set's boundary, in several formats.

    #[doc(inline)]
    pub use cdpr_workspace::mesh::{Field, Format, Mesh};
}

pub mod octree {
    //! Cells that are refined at the boundary.

    #[doc(inline)]
    pub use cdpr_workspace::octree::{Octree, Settings, solve};
}

pub mod wrench_set {
    //! Sets of wrenches that cables can balance.

    #[doc(inline)]
    pub use cdpr_workspace::wrench_set::{Payload, RequiredSet, Zonotope};
}
