"""Models on arrays: inverse and forward problems, tensions, structure matrices, stiffness."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _cdpr
from ._arrays import Array, Numbers, Path
from ._errors import Error
from ._robot import Robot


class Status(IntEnum):
    """How a forward problem ended."""

    CONVERGED = 0
    """The pose is the solution."""
    NOT_CONVERGED = 1
    """No solution was found; the pose is the best one."""
    SINGULAR = 2
    """Lengths and load do not determine the pose."""
    UNSTABLE = 3
    """An equilibrium that the smallest disturbance ends."""


class TensionStatus(IntEnum):
    """Whether tensions within limits balance the load."""

    FEASIBLE = 0
    """They do."""
    INFEASIBLE = 1
    """No tensions do: proved."""
    NOT_FOUND = 2
    """Some do, but the method, which is no exact search, did not find them."""
    UNDECIDED = 3
    """Rounding or overflow prevented a verdict."""


@dataclass(frozen=True, eq=False)
class Forward:
    """Poses that emerge from controlled lengths; N problems, or one without the first dimension."""

    poses: Array
    """Poses (N, 7): x, y, z (m), qx, qy, qz, qw, in the world; the best ones found where a problem did not converge."""
    status: npt.NDArray[np.uint8]
    """Status (N,) of each problem, as :class:`Status`."""
    residual_rms: Array
    """Root mean square of the length residuals (N,) (m)."""
    iterations: npt.NDArray[np.uint32]
    """Steps of each search (N,)."""
    tensions: Array | None
    """Tensions (N, m) (N); ``None`` if lengths alone are fitted, from which no tensions follow."""

    @property
    def converged(self) -> npt.NDArray[np.bool_]:
        """True (N,) where the pose is the solution."""
        return np.equal(self.status, Status.CONVERGED)

    def raise_for_status(self) -> Forward:
        """Returns itself if all problems converged; raises :class:`cdpr.Error` otherwise."""
        wrong = np.flatnonzero(~self.converged)
        if wrong.size:
            name = Status(int(self.status[wrong[0]])).name.lower().replace("_", "-")
            message = f"{wrong.size} of {self.status.size} forward problems have no solution, first row {wrong[0]}: {name}"
            raise Error("forward::no-solution", message, "`model.reason(lengths[row])` says why")
        return self

    def __repr__(self) -> str:
        return f"<cdpr.Forward: {int(self.converged.sum())} of {self.status.size} converged>"


@dataclass(frozen=True, eq=False)
class Tensions:
    """Tensions that balance the load; N poses, or one without the first dimension."""

    tensions: Array
    """Tensions (N, m) (N); NaN where there are none (``closed-form`` and ``nearest-wrench`` give theirs in every case)."""
    status: npt.NDArray[np.uint8]
    """Status (N,) of each pose, as :class:`TensionStatus`."""

    @property
    def feasible(self) -> npt.NDArray[np.bool_]:
        """True (N,) where the tensions balance the load within the limits."""
        return np.equal(self.status, TensionStatus.FEASIBLE)

    def __repr__(self) -> str:
        return f"<cdpr.Tensions: {int(self.feasible.sum())} of {self.status.size} feasible>"


@dataclass(frozen=True, eq=False)
class Margins:
    """By how much a criterion holds at N poses."""

    margin: Array
    """Signed margins (N,) in ``unit``: at least 0 where it holds, below 0 where it fails, -inf if no change of the quantity would help."""
    cable: npt.NDArray[np.int64]
    """Limiting cables (N,), from 0; -1 where there is none."""
    unit: str
    """Unit of the margins; ``1`` without a dimension."""

    def __repr__(self) -> str:
        return f"<cdpr.Margins: {int((self.margin >= 0).sum())} of {self.margin.size} hold, unit {self.unit}>"


_ANSWERS_ALWAYS = ("closed-form", "nearest-wrench")
"""Methods whose tensions mean something where they balance no load within limits."""


class State:
    """What a robot's cables remember (hysteresis), and the pose at which it settled last.

    Passed to :meth:`Model.inverse` or :meth:`Model.forward`, the rows are a course in time: each settles the robot, and the next goes on from
    there. A copy is a snapshot.
    """

    __slots__ = ("_data",)

    def __init__(self, model: Model, pose: Numbers | None = None) -> None:
        self._data = model._data.state(pose)

    @property
    def pose(self) -> Array:
        """The pose at which the robot settled last (7,)."""
        return self._data.pose

    def copy(self) -> State:
        """Returns a snapshot."""
        state = object.__new__(State)
        state._data = self._data.copy()
        return state

    __copy__ = copy

    def __deepcopy__(self, _memo: object) -> State:
        return self.copy()


class Model:
    """A robot with chosen effects of its cables. Immutable; any number of threads may use it.

    ``composition`` is ``standard`` or effects joined by ``+``: ``pulley``, ``drum``, ``elastic``, ``polynomial``, ``hysteresis``,
    ``catenary``, ``finite-element``. Raises :class:`cdpr.Error` for an effect whose numbers the robot lacks.

    Poses are rows (N, 7) x, y, z, qx, qy, qz, qw, or (N, 6) x, y, z, rx, ry, rz with R = Rx Ry Rz, or the components of the motion
    pattern, (N, 3) x, y, angle for planar robots; one pose may be an array of one dimension, and the answer then has none for N.
    Arrays have numbers of double precision; strided ones are read without a copy of the whole. The global interpreter lock is released
    while many poses are computed.

    >>> model = Model("planar-example", "standard")
    >>> model.inverse([0.5, 4.0, 0.0]).round(3)
    array([4.072, 3.813, 1.826, 1.185])
    """

    __slots__ = ("_data", "_robot")

    _data: _cdpr.Model
    _robot: Robot

    def __init__(self, robot: Robot | Path, composition: str = "standard") -> None:
        own = robot if isinstance(robot, Robot) else Robot(robot)
        object.__setattr__(self, "_robot", own)
        object.__setattr__(self, "_data", _cdpr.Model(own._data, composition))

    def __setattr__(self, name: str, _value: object) -> None:
        raise AttributeError(f"models are immutable: make another one instead of setting `{name}`")

    @property
    def robot(self) -> Robot:
        """The robot."""
        return self._robot

    @property
    def composition(self) -> str:
        """Effects of the model, as they are written."""
        return self._data.composition

    @property
    def needs_tensions(self) -> bool:
        """True if controlled lengths depend on tensions."""
        return self._data.needs_tensions

    def inverse(
        self,
        poses: Numbers,
        tensions: Numbers | None = None,
        *,
        out: Array | None = None,
        state: State | None = None,
        wrench: Numbers | None = None,
        limits: tuple[Any, Any] | None = None,
    ) -> Array:
        """Returns the controlled lengths (N, m) in metres with which cables hold the poses.

        ``tensions`` (N, m) or (m,) in newtons, for models whose lengths depend on them; if left out, those nearest to the middle of the
        limits that balance the load (exact quadratic programme, as ``cdpr ik``). NaN where a cable has no path, or where no tensions
        within the limits balance the load. ``out`` (N, m): array to write into, which is returned. ``state``: cables remember the rows
        before.
        """
        data = self._data
        if tensions is None:
            if not data.needs_tensions:
                return data.lengths(poses, out)
            tensions = self._balanced(poses, wrench, limits)
        return data.lengths_under(poses, tensions, None if state is None else state._data, out)

    def lengths(self, poses: Numbers, out: Array | None = None) -> Array:
        """Returns the geometric lengths (N, m) in metres, from the anchor or the drum's side of the pulley to the platform anchor.

        They depend on no tensions: of elastic models they are the lengths of the stretched cables. NaN where a cable has no path.
        """
        return self._data.lengths(poses, out)

    def forward(
        self,
        lengths: Numbers,
        guess: Numbers | None = None,
        *,
        wrench: Numbers | None = None,
        state: State | None = None,
    ) -> Forward:
        """Returns the poses that emerge from controlled lengths (N, m) in metres; see :class:`Forward`.

        ``guess``: a pose for each row or one for all, the home pose if left out. ``wrench``: load in the components of the motion
        pattern (N, N·m; world axes, moment about the platform origin), in place of the robot's own.
        """
        poses, status, residual_rms, iterations, tensions = self._data.forward(
            lengths, guess, wrench, None if state is None else state._data
        )
        return Forward(poses, status, residual_rms, iterations, tensions)

    def reason(self, lengths: Numbers, guess: Numbers | None = None, *, wrench: Numbers | None = None) -> str | None:
        """Returns the reason for which the forward problem of one row has no solution, in words; ``None`` if it has one."""
        return self._data.forward_reason(lengths, guess, wrench)

    def tensions(
        self,
        poses: Numbers,
        method: str = "qp",
        *,
        limits: tuple[Any, Any] | None = None,
        wrench: Numbers | None = None,
        out: Array | None = None,
    ) -> Tensions:
        """Returns tensions (N, m) in newtons that balance the load at the poses; see :class:`Tensions`.

        ``method``: ``qp`` (nearest to the middle of the limits, exact), ``closed-form``, ``improved-closed-form``, ``puncture``,
        ``dykstra``, ``centroid``, ``minimum``, ``maximum``, ``barrier``, ``smooth`` or ``nearest-wrench``. ``limits``: lower and upper one, each a
        number or one per cable (N); those of the robot if left out. ``wrench``: as in :meth:`forward`.
        """
        tensions, status = self._data.tensions(poses, method, limits, wrench, out)
        if method not in _ANSWERS_ALWAYS:
            tensions[np.broadcast_to(status != TensionStatus.FEASIBLE, tensions.T.shape).T] = np.nan
        return Tensions(tensions, status)

    def feasible(
        self, poses: Numbers, *, limits: tuple[Any, Any] | None = None, wrench: Numbers | None = None
    ) -> npt.NDArray[np.bool_]:
        """Returns true (N,) where tensions within the limits balance the load: the wrench-feasible poses."""
        return self._data.feasible(poses, limits, wrench)

    def satisfies(
        self,
        poses: Numbers,
        criteria: str | Sequence[str],
        *,
        limits: tuple[Any, Any] | None = None,
        wrench: Numbers | None = None,
    ) -> npt.NDArray[np.bool_]:
        """Returns true (N,) where criteria hold, by the names that :func:`cdpr.workspace` knows: ``wrench-feasible``, ``wrench-closure``,
        ``stiffness:…``, ``clearance:…``, … A mask over poses of one's own."""
        return self._data.satisfies(poses, [criteria] if isinstance(criteria, str) else list(criteria), limits, wrench)

    def margins(
        self, poses: Numbers, criterion: str, *, limits: tuple[Any, Any] | None = None, wrench: Numbers | None = None
    ) -> Margins:
        """Returns by how much a criterion holds or fails at the poses; see :class:`Margins`."""
        return Margins(*self._data.margins(poses, criterion, limits, wrench))

    def structure_matrix(self, poses: Numbers, out: Array | None = None) -> Array:
        """Returns the structure matrices Aᵀ (N, n, m): column i is the wrench of a unit tension in cable i (world axes, moment about the
        platform origin), in the components of the motion pattern. NaN where a cable has no path."""
        return self._data.structure_matrix(poses, out)

    def stiffness(
        self,
        poses: Numbers,
        tensions: Numbers | None = None,
        *,
        wrench: Numbers | None = None,
        limits: tuple[Any, Any] | None = None,
        out: Array | None = None,
    ) -> Array:
        """Returns the stiffness matrices (N, n, n): wrench by displacement (N/m, N/rad, N·m/rad), with fixed winches.

        ``tensions`` as in :meth:`inverse`. NaN where there is no equilibrium.
        """
        if tensions is None:
            tensions = self._balanced(poses, wrench, limits)
        return self._data.stiffness(poses, tensions, wrench, out)

    def _balanced(self, poses: Numbers, wrench: Numbers | None, limits: tuple[Any, Any] | None) -> Array:
        """Returns the tensions nearest to the middle of the limits that balance the load; NaN where none do."""
        return self.tensions(poses, limits=limits, wrench=wrench).tensions

    def __repr__(self) -> str:
        return f"<cdpr.Model {self.composition!r} of {self._robot.name!r}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Model) and (self.composition, self.robot) == (other.composition, other.robot)

    def __hash__(self) -> int:
        return hash((self.composition, self._robot))

    def __reduce__(self) -> tuple[type[Model], tuple[Robot, str]]:
        return Model, (self._robot, self.composition)

    def __copy__(self) -> Model:
        return self

    def __deepcopy__(self, _memo: object) -> Model:
        return self


@dataclass(frozen=True, eq=False)
class Difference:
    """Two models of the same robot at the same poses."""

    lengths: Array
    """Controlled lengths of the second model minus those of the first (N, m) (m)."""
    position: Array
    """Distances (N,) (m) by which the platform of the second model misses the poses under lengths of the first."""
    rotation: Array
    """Angles (N,) (rad) by which it misses them."""
    poses: Array
    """Poses (N, 7) that emerge from the second model under lengths of the first."""
    status: npt.NDArray[np.uint8]
    """Status (N,) of these forward problems, as :class:`Status`."""

    def __repr__(self) -> str:
        largest = np.nanmax(self.position) if np.isfinite(self.position).any() else np.nan
        return f"<cdpr.Difference at {self.position.size} poses: up to {1e3 * largest:.3g} mm>"


def difference(
    model_a: Model,
    model_b: Model,
    poses: Numbers,
    *,
    tensions: Numbers | None = None,
    wrench: Numbers | None = None,
    limits: tuple[Any, Any] | None = None,
) -> Difference:
    """Returns by how much two models differ at poses: lengths that ``model_a`` sends, and where the machine ``model_b`` goes with them.

    Both have the same ``tensions`` (N, m) in newtons, if one needs some: given, or those nearest to the middle of the limits that
    balance the load. Winch offsets are none: lengths of one model are taken for those of the other. :func:`cdpr.accuracy` sets them at
    an initial pose, as a real robot does.

    >>> rigid, machine = Model("planar-example"), Model("planar-example", "pulley")
    >>> bool(difference(rigid, machine, [[0.5, 4.0, 0.0], [0.0, 3.0, 0.0]]).position.max() > 0.001)
    True
    """
    robot = model_b.robot
    rows = np.atleast_2d(robot.quaternions(poses))
    if tensions is None and (model_a.needs_tensions or model_b.needs_tensions):
        tensions = model_b.tensions(rows, wrench=wrench, limits=limits).tensions
    sent = model_a.inverse(rows, tensions)
    wanted = model_b.inverse(rows, tensions)
    known = np.isfinite(sent).all(axis=1)
    found = np.full(rows.shape, np.nan)
    status = np.full(len(rows), Status.NOT_CONVERGED, dtype=np.uint8)
    if known.any():
        emerged = model_b.forward(np.ascontiguousarray(sent[known]), rows[known], wrench=wrench)
        found[known], status[known] = emerged.poses, emerged.status
    position = np.linalg.norm(found[:, :3] - rows[:, :3], axis=1)
    # the angle between two rotations by their chord, which is exact for small angles
    chord = np.minimum(
        np.linalg.norm(found[:, 3:] - rows[:, 3:], axis=1), np.linalg.norm(found[:, 3:] + rows[:, 3:], axis=1)
    )
    rotation = 4.0 * np.arcsin(np.clip(0.5 * chord, 0.0, 1.0))
    return Difference(wanted - sent, position, rotation, found, status)
