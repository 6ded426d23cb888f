"""Machines in time: a plant and its state, stepped by anybody, and controllers for runs of scenarios."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from . import _cdpr
from ._arrays import Array, Numbers
from ._model import Model

Measured = _cdpr.Measured
Setpoint = _cdpr.Setpoint


class Controller(Protocol):
    """A controller of a machine in time, for :func:`cdpr.run`: any object with this method.

    Optional besides: ``kind``, the quantity of its commands (``lengths``, ``speeds``, ``torques`` or ``tensions``; lengths if left out);
    ``period`` (s), the time between two calls, every step of the integrator if left out; ``reset()``, called before the first.
    """

    def command(self, time: float, wanted: Setpoint, measured: Measured) -> Numbers:
        """Returns a command for each cable (m), (m/s), (N·m) or (N).

        ``wanted`` has ``pose`` (7,), ``twist`` and ``acceleration`` (6,), ``lengths`` (m,); ``measured`` has ``time``, ``pose``, ``twist``,
        ``lengths``, ``length_rates``, ``tensions``, and ``sensor(file)`` with the last row of ``measurements.csv``, ``imu.csv`` or
        ``tracker.csv``. Twists are [v; ω] of the platform origin in world axes (m/s, rad/s).
        """
        ...


class PlantState:
    """State of a machine in time. :meth:`Plant.step` changes it; a copy is a snapshot, from which steps give the same bits again."""

    __slots__ = ("_data",)

    _data: _cdpr.PlantState

    def __init__(self) -> None:
        raise TypeError("states come from `plant.at_rest(…)` and `plant.with_lengths(…)`")

    @classmethod
    def _of(cls, data: _cdpr.PlantState) -> PlantState:
        state = object.__new__(cls)
        state._data = data
        return state

    @property
    def time(self) -> float:
        """Time since the start (s)."""
        return self._data.time

    @property
    def pose(self) -> Array:
        """Pose of the platform (7,): x, y, z (m), qx, qy, qz, qw, in the world."""
        return self._data.pose

    @property
    def twist(self) -> Array:
        """Twist [v; ω] of the platform origin (6,), world axes (m/s, rad/s)."""
        return self._data.twist

    @property
    def tensions(self) -> Array:
        """Tensions at the outlets (m,) (N)."""
        return self._data.tensions

    @property
    def lengths(self) -> Array:
        """Controlled lengths (m,) (m)."""
        return self._data.lengths

    @property
    def length_rates(self) -> Array:
        """Rates of the controlled lengths (m,) (m/s), positive if cable is paid out."""
        return self._data.length_rates

    def observe(self, out: Array) -> Array:
        """Writes pose (7), twist (6) and tensions (m) into ``out`` and returns it; makes no new array."""
        self._data.observe(out)
        return out

    def copy(self) -> PlantState:
        """Returns a snapshot."""
        return PlantState._of(self._data.copy())

    __copy__ = copy

    def __deepcopy__(self, _memo: object) -> PlantState:
        return self.copy()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, PlantState) and self._data == other._data

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        x, y, z = (round(float(number), 4) for number in self.pose[:3])
        return f"<cdpr.PlantState at {self.time:.4g} s: position ({x}, {y}, {z}) m>"


@dataclass(frozen=True, eq=False)
class Motion:
    """Recorded states of a run, K rows."""

    times: Array
    """Times since the start (K,) (s)."""
    poses: Array
    """Poses (K, 7): x, y, z (m), qx, qy, qz, qw."""
    twists: Array
    """Twists [v; ω] of the platform origin (K, 6), world axes (m/s, rad/s)."""
    tensions: Array
    """Tensions (K, m) (N)."""
    lengths: Array
    """Controlled lengths (K, m) (m)."""
    reason: str | None
    """Reason for which the run ended early, in words; ``None`` if all steps were taken."""

    def __repr__(self) -> str:
        end = "" if self.reason is None else f", ended early: {self.reason}"
        return f"<cdpr.Motion: {self.times.size} states{end}>"


class Plant:
    """A machine in time: elastic cables hold a platform with mass and inertia. Immutable.

    ``winches`` are ``ideal``, whose lengths are what is commanded, or ``drums`` with inertia and friction, which torques command. Raises
    :class:`cdpr.Error` where the robot states no mass, centre of mass or inertia, or its cables do not stretch.

    >>> plant = Plant(Model("planar-example", "elastic"))  # doctest: +SKIP
    >>> state = plant.at_rest([0.5, 4.0, 0.0], [3000.0] * 4)  # doctest: +SKIP
    >>> plant.step(state, state.lengths, dt=0.001)  # doctest: +SKIP
    """

    __slots__ = ("_data", "_model", "_winches")

    _data: _cdpr.Plant
    _model: Model
    _winches: str

    def __init__(self, model: Model, winches: str = "ideal") -> None:
        data = _cdpr.Plant(model._data, winches)
        for slot, value in (("_data", data), ("_model", model), ("_winches", winches)):
            object.__setattr__(self, slot, value)

    def __setattr__(self, name: str, _value: object) -> None:
        raise AttributeError(f"plants are immutable: make another one instead of setting `{name}`")

    @property
    def model(self) -> Model:
        """The model of the machine."""
        return self._model

    @property
    def winches(self) -> str:
        """Kind of the winches."""
        return self._winches

    def at_rest(self, pose: Numbers, tensions: Numbers) -> PlantState:
        """Returns the state at rest at a pose with tensions (m,) (N), whether they balance the load or not."""
        return PlantState._of(self._data.at_rest(pose, tensions))

    def with_lengths(self, pose: Numbers, lengths: Numbers) -> PlantState:
        """Returns the state at rest at a pose with controlled lengths (m,) (m)."""
        return PlantState._of(self._data.with_lengths(pose, lengths))

    def step(self, state: PlantState, commands: Numbers, dt: float, kind: str = "lengths") -> None:
        """Advances a state by ``dt`` seconds under commands (m,), one per cable.

        ``kind``: ``lengths`` (m) that are reached at the end of the step, ``speeds`` (m/s) of paid-out length, ``torques`` of motors (N·m,
        drums) or ``tensions`` (N). Raises :class:`cdpr.Error` for a step that cannot be taken.
        """
        self._data.step(state._data, commands, dt, kind)

    def run(
        self, state: PlantState, commands: Numbers, dt: float, every: int = 1, kind: str = "lengths"
    ) -> Motion:
        """Takes a step for each row of commands (T, m), and returns the state at the start and after every ``every`` steps.

        A step that cannot be taken ends the run; :attr:`Motion.reason` says why. The global interpreter lock is released.
        """
        return Motion(*self._data.run(state._data, commands, dt, every, kind))

    def __reduce__(self) -> tuple[Any, tuple[Model, str]]:
        return Plant, (self._model, self._winches)

    def __repr__(self) -> str:
        return f"<cdpr.Plant {self._winches!r} of {self._model!r}>"
