//! Errors that have several names: a number of the machine that the controller's file has wrong, a zero, a scale, a load.
//!
//! An anchor that is 1 mm beside the one of the file may be called a deviation of the machine or of the control model; it is one error.
//! Without stated tolerances each error counts once, under the name that comes first here: that of the machine before
//! those of winches and control model.

use cdpr_model::robot::ParameterKind;

use super::{Kind, ParameterDeviation, Side};

/// Names of the same error of a cable or load beside each other, the one that counts first.
const SAME: [&[Kind]; 4] = [
    // the zero of a length, wherever it is stored
    &[
        Kind::Parameter(ParameterKind::LengthOffset),
        Kind::WinchOffset,
        Kind::Parameter(ParameterKind::StartLength),
        Kind::Parameter(ParameterKind::StartAngle),
    ],
    // length per turn of a motor, but for a zero
    &[Kind::Parameter(ParameterKind::LengthScale), Kind::Parameter(ParameterKind::DrumRadius)],
    // a weight is a force, a centre of mass its moment
    &[Kind::Parameter(ParameterKind::Force), Kind::Parameter(ParameterKind::Mass)],
    &[Kind::Parameter(ParameterKind::Moment), Kind::Parameter(ParameterKind::CenterOfMass)],
];

/// Place of a name among those of its error, and the error by its first kind.
fn place(side: Side, kind: Kind) -> (Kind, usize, usize) {
    let of_side = match side {
        Side::Machine => 0,
        Side::Winches => 1,
        Side::Control => 2,
    };
    let known = SAME.iter().find_map(|names| Some((names[0], names.iter().position(|name| *name == kind)?)));
    let (error, of_kind) = known.unwrap_or((kind, 0));
    (error, of_side, of_kind)
}

/// Name under which the error of a kind is counted, of those that the causes have; `None` where it is its own name.
pub fn counted_as(side: Side, kind: Kind, causes: &[ParameterDeviation]) -> Option<(Side, Kind)> {
    let (error, ..) = place(side, kind);
    let names = causes.iter().map(|cause| (cause.side, cause.kind));
    let same = names.filter(|&(side, kind)| place(side, kind).0 == error);
    let first = same.min_by_key(|&(side, kind)| (place(side, kind).1, place(side, kind).2))?;
    (first != (side, kind)).then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_error_has_one_name_that_counts() {
        let of = Kind::Parameter;
        let kinds = [
            (Side::Control, of(ParameterKind::FrameAnchor)),
            (Side::Control, of(ParameterKind::LengthOffset)),
            (Side::Control, of(ParameterKind::AxialStiffness)),
            (Side::Machine, of(ParameterKind::FrameAnchor)),
            (Side::Machine, of(ParameterKind::LengthOffset)),
            (Side::Machine, of(ParameterKind::StartAngle)),
            (Side::Machine, of(ParameterKind::DrumRadius)),
            (Side::Machine, of(ParameterKind::LengthScale)),
            (Side::Machine, of(ParameterKind::Mass)),
            (Side::Winches, Kind::WinchOffset),
            (Side::Winches, Kind::InitialTension),
        ];
        let causes = kinds.map(|(side, kind)| ParameterDeviation { side, kind, cable: 0, axis: 0 });
        let counts = |&(side, kind): &(Side, Kind)| counted_as(side, kind, &causes).is_none();
        let counted: Vec<(Side, Kind)> = kinds.into_iter().filter(counts).collect();
        let expected = [
            (Side::Control, of(ParameterKind::AxialStiffness)),
            (Side::Machine, of(ParameterKind::FrameAnchor)),
            (Side::Machine, of(ParameterKind::LengthOffset)),
            (Side::Machine, of(ParameterKind::LengthScale)),
            (Side::Machine, of(ParameterKind::Mass)),
            (Side::Winches, Kind::InitialTension),
        ];
        assert_eq!(counted, expected);
        let zero = counted_as(Side::Winches, Kind::WinchOffset, &causes);
        assert_eq!(zero, Some((Side::Machine, of(ParameterKind::LengthOffset))));
    }
}
