"""Types of arguments, and poses between forms."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

Array: TypeAlias = npt.NDArray[np.float64]
Numbers: TypeAlias = "npt.NDArray[np.float64] | Sequence[float] | Sequence[Sequence[float]]"
Value: TypeAlias = "str | float | Sequence[Any] | Mapping[str, Any] | npt.NDArray[np.float64]"
Path: TypeAlias = "str | os.PathLike[str]"
Progress: TypeAlias = "Callable[[str, int, int | None], object] | bool | None"


def poses_of(positions: Numbers, rotations: Rotation) -> Array:
    """Returns poses of positions (N, 3) in metres and a ``scipy`` rotation of N, or of one each.

    Rotations turn platform coordinates into world coordinates. Rows are x, y, z, qx, qy, qz, qw.

    >>> from scipy.spatial.transform import Rotation
    >>> poses_of([0.0, 0.0, 1.5], Rotation.identity())
    array([0. , 0. , 1.5, 0. , 0. , 0. , 1. ])
    """
    places: Array = np.asarray(positions, dtype=float)
    quaternions: Array = np.asarray(rotations.as_quat(), dtype=float)
    shape = np.broadcast_shapes(places.shape[:-1], quaternions.shape[:-1])
    return np.concatenate(
        [np.broadcast_to(places, (*shape, 3)), np.broadcast_to(quaternions, (*shape, 4))], axis=-1
    )


def rotations_of(poses: Array) -> Rotation:
    """Returns the ``scipy`` rotations of poses (N, 7), from platform into world coordinates."""
    from scipy.spatial.transform import Rotation

    return Rotation.from_quat(np.asarray(poses)[..., 3:])


def plain(value: Any) -> Any:
    """Returns a value of numpy as one of Python."""
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value
