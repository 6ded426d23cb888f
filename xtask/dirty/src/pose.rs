//! Points, rotations and poses: this program's own, so that the product's are not what judges the product.

/// Point or vector (m).
pub(crate) type Vector = [f64; 3];

/// Rotation matrix, by rows.
pub(crate) type Rotation = [Vector; 3];

pub(crate) const UNTURNED: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Place and orientation: platform to world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose {
    pub(crate) position: Vector,
    pub(crate) rotation: Rotation,
}

pub(crate) fn plus(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|axis| a[axis] + b[axis])
}

pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

pub(crate) fn times(a: Vector, factor: f64) -> Vector {
    a.map(|number| number * factor)
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

pub(crate) fn turned(rotation: &Rotation, a: Vector) -> Vector {
    rotation.map(|row| dot(row, a))
}

pub(crate) fn transposed(rotation: &Rotation) -> Rotation {
    std::array::from_fn(|row| std::array::from_fn(|column| rotation[column][row]))
}

/// `first` behind `second`: R₁ R₂.
pub(crate) fn product(first: &Rotation, second: &Rotation) -> Rotation {
    let columns = transposed(second);
    std::array::from_fn(|row| std::array::from_fn(|column| dot(first[row], columns[column])))
}

/// Rotation about a vector by its length (Rodrigues).
pub(crate) fn rotation_of(vector: Vector) -> Rotation {
    let angle = norm(vector);
    if angle < 1e-12 {
        return UNTURNED;
    }
    let axis = times(vector, 1.0 / angle);
    let column = |index: usize| {
        let unit = UNTURNED[index];
        let (along, across) =
            (times(axis, dot(axis, unit) * (1.0 - angle.cos())), times(cross(axis, unit), angle.sin()));
        plus(plus(times(unit, angle.cos()), along), across)
    };
    transposed(&[column(0), column(1), column(2)])
}

/// Angle between two orientations (rad).
pub(crate) fn angle_between(a: &Rotation, b: &Rotation) -> f64 {
    let difference = product(a, &transposed(b));
    // sin and cos: acos alone has no accuracy near zero
    let axis =
        [difference[2][1] - difference[1][2], difference[0][2] - difference[2][0], difference[1][0] - difference[0][1]];
    let trace = difference[0][0] + difference[1][1] + difference[2][2];
    norm(axis).atan2(trace - 1.0)
}

/// Unit quaternion x, y, z, w of a rotation by less than half a turn.
pub(crate) fn quaternion(r: &Rotation) -> [f64; 4] {
    let w = 0.5 * (1.0 + r[0][0] + r[1][1] + r[2][2]).max(1e-12).sqrt();
    let part = 0.25 / w;
    [(r[2][1] - r[1][2]) * part, (r[0][2] - r[2][0]) * part, (r[1][0] - r[0][1]) * part, w]
}

/// Angles about z, y, x of R = Rz Ry Rx, given as x, y, z (roll, pitch, yaw).
pub(crate) fn roll_pitch_yaw(r: &Rotation) -> Vector {
    [r[2][1].atan2(r[2][2]), (-r[2][0]).asin(), r[1][0].atan2(r[0][0])]
}

impl Pose {
    /// The pose of what is fixed at `inner` in the moving frame of this pose.
    pub(crate) fn then(&self, inner: &Self) -> Self {
        Self {
            position: plus(self.position, turned(&self.rotation, inner.position)),
            rotation: product(&self.rotation, &inner.rotation),
        }
    }

    pub(crate) fn shifted(position: Vector) -> Self {
        Self { position, rotation: UNTURNED }
    }

    /// Moved by a translation, and turned by a vector in the world's axes about its own origin.
    pub(crate) fn moved(&self, translation: Vector, rotation: Vector) -> Self {
        Self { position: plus(self.position, translation), rotation: product(&rotation_of(rotation), &self.rotation) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TURN: Vector = [0.2, -0.3, 0.4];

    #[test]
    fn a_turn_has_its_angle_and_leaves_its_axis() {
        let rotation = rotation_of(TURN);
        assert!((angle_between(&rotation, &UNTURNED) - norm(TURN)).abs() < 1e-12);
        assert!(norm(minus(turned(&rotation, TURN), TURN)) < 1e-12);
        assert!(angle_between(&product(&rotation, &transposed(&rotation)), &UNTURNED) < 1e-12);
    }

    #[test]
    fn angles_and_quaternions_are_those_of_their_matrix() {
        let [roll, pitch, yaw] = roll_pitch_yaw(&rotation_of(TURN));
        let [about_x, about_y, about_z] = [[roll, 0.0, 0.0], [0.0, pitch, 0.0], [0.0, 0.0, yaw]].map(rotation_of);
        let again = product(&about_z, &product(&about_y, &about_x));
        assert!(angle_between(&again, &rotation_of(TURN)) < 1e-12);
        let [x, y, z, w] = quaternion(&rotation_of(TURN));
        let half = norm(TURN) / 2.0;
        assert!((w - half.cos()).abs() < 1e-12);
        assert!(norm(minus([x, y, z], times(TURN, half.sin() / norm(TURN)))) < 1e-12);
    }
}
