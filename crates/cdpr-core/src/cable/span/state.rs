//! State of a span and its changes.

/// State of a span: the force at the outlet and the unstrained length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpanState<T> {
    /// F, the force of the span on its outlet (world, N).
    pub force: [T; 3],
    /// L (m).
    pub length: T,
}

/// A change of state or weight, along which a derivative is taken.
#[derive(Clone, Copy, Debug)]
pub struct Change {
    /// δF (N).
    pub force: [f64; 3],
    /// δL (m).
    pub length: f64,
    /// δp (N/m).
    pub weight: [f64; 3],
}

impl Change {
    const NONE: Self = Self { force: [0.0; 3], length: 0.0, weight: [0.0; 3] };

    /// Unit changes of the state: the three components of the force, and the length.
    pub const OF_STATE: [Self; 4] = [
        Self { force: [1.0, 0.0, 0.0], ..Self::NONE },
        Self { force: [0.0, 1.0, 0.0], ..Self::NONE },
        Self { force: [0.0, 0.0, 1.0], ..Self::NONE },
        Self { length: 1.0, ..Self::NONE },
    ];

    /// A change of the weight.
    pub fn of_weight(weight: [f64; 3]) -> Self {
        Self { weight, ..Self::NONE }
    }
}
