"""Studies, scenarios and sweeps: the files that put robots, models and poses together, from disk or made here."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from ._arrays import Numbers, Path, plain
from ._model import Model
from ._robot import Robot, read, save
from ._samples import Sigmas, _csv

if TYPE_CHECKING:
    from ._ask import Call

D = TypeVar("D", bound="Document")


class Document:
    """A file (TOML) that names other files. Immutable."""

    __slots__ = ("_files", "_name", "_path", "_text")

    _name: str
    _text: bytes
    _files: dict[str, bytes]
    _path: str | None
    _default = "document.toml"

    def __init__(self, path: Path) -> None:
        name = os.fspath(path)
        self._set(name, read(name), {}, name)

    def _set(self, name: str, text: bytes, files: dict[str, bytes], path: str | None) -> None:
        for slot, value in (("_name", name), ("_text", text), ("_files", files), ("_path", path)):
            object.__setattr__(self, slot, value)

    def __setattr__(self, name: str, _value: object) -> None:
        raise AttributeError(f"{type(self).__name__} objects are immutable: make another one instead of setting `{name}`")

    @classmethod
    def from_toml(cls: type[D], text: str | bytes, files: Mapping[str, Robot | str | bytes] | None = None) -> D:
        """Returns the document of a TOML text. ``files``: robots and tables that it names, by these names; others are on the disk, relative to
        the working folder."""
        document = object.__new__(cls)
        content = text.encode() if isinstance(text, str) else text
        document._set(cls._default, content, {name: _bytes(own) for name, own in (files or {}).items()}, None)
        return document

    @classmethod
    def from_dict(cls: type[D], tables: Mapping[str, Any], files: Mapping[str, Robot | str | bytes] | None = None) -> D:
        """Returns the document with these tables and keys, named as in its file; ``files`` as in :meth:`from_toml`."""
        return cls.from_toml(toml(tables), files)

    def to_toml(self) -> str:
        """Returns the file."""
        return self._text.decode()

    def save(self, path: Path) -> None:
        """Writes the file, and beside it those that it names, if it was made here."""
        for name, content in self._files.items():
            save(FilePath(path).parent / name, content)
        save(path, self._text)

    def _put(self, call: Call) -> str:
        if self._path is not None:
            return self._path
        for name, content in self._files.items():
            call.file(name, content)
        return call.file(self._name, self._text)

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._state() == other._state()

    def __hash__(self) -> int:
        return hash((type(self), self._text))

    def _state(self) -> tuple[str, bytes, dict[str, bytes], str | None]:
        return self._name, self._text, self._files, self._path

    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]:
        return _made, (type(self), *self._state())

    def __repr__(self) -> str:
        return f"<cdpr.{type(self).__name__} {self._name!r}>"


def _made(cls: type[D], name: str, text: bytes, files: dict[str, bytes], path: str | None) -> D:
    document = object.__new__(cls)
    document._set(name, text, files, path)
    return document


class Study(Document):
    """A control model on a machine: robots, models, how winches were set, limits, poses, noise.

    ``Study(path)`` is a study file; its paths are relative to its folder. :meth:`of` makes one of models.
    """

    __slots__ = ()
    _default = "study.toml"

    @classmethod
    def of(
        cls,
        control: Model,
        machine: Model | None = None,
        *,
        initial_pose: Numbers,
        initial_tensions: Numbers | None = None,
        tension_method: str | None = None,
        offset: str | None = None,
        limits: tuple[float, float] | None = None,
        position_error_max: float | None = None,
        grid: tuple[Numbers, Numbers, Numbers] | None = None,
        poses: Numbers | None = None,
        random: tuple[int, Numbers] | None = None,
        noise: Sigmas | None = None,
        tables: Mapping[str, Any] | None = None,
    ) -> Study:
        """Returns the study of a control model on a machine (itself if left out).

        ``initial_pose``: where winch offsets are set, in the components of the motion pattern (m, rad), with ``initial_tensions`` (N) or a
        ``tension_method``; or ``offset="none"``. ``limits``: least and largest tension (N). ``position_error_max`` (m): for the reachable
        workspace. ``grid``: least and largest components and counts of a grid of poses; ``random``: number of poses in its box and largest
        rotations (rad); ``poses``: rows of components. ``noise``: of sensors, for :func:`cdpr.simulate`. ``tables``: any further tables and
        keys of a study file, e.g. ``{"tolerances": {…}}``.
        """
        machine = machine or control
        files: dict[str, Robot | str | bytes] = {"control.toml": control.robot, "machine.toml": machine.robot}
        stated: dict[str, Any] = {
            "control": {"robot": "control.toml", "model": control.composition},
            "machine": {"robot": "machine.toml", "model": machine.composition},
        }
        if initial_tensions is None and tension_method is None and offset is None:
            tension_method = "closed-form"
        stated["initial"] = _stated(
            pose=initial_pose, tensions_N=initial_tensions, tension_method=tension_method, offset=offset
        )
        low, high = limits if limits is not None else (None, None)
        stated["limits"] = _stated(tension_min_N=low, tension_max_N=high, position_error_max_m=position_error_max)
        ways: dict[str, Any] = {}
        if grid is not None:
            ways["grid"] = _stated(min=grid[0], max=grid[1], count=grid[2])
        if random is not None:
            ways["random"] = _stated(count=random[0], rotation_rad=random[1])
        if poses is not None:
            rows = np.atleast_2d(np.asarray(poses, dtype=float))
            names = _component_columns(control.robot)
            files["poses.csv"] = _csv(dict(zip(names, rows.T, strict=True)))
            ways["file"] = {"path": "poses.csv"}
        stated["poses"] = ways
        stated["noise"] = noise._option() if noise else {}
        for name, table in (tables or {}).items():
            stated[name] = {**stated.get(name, {}), **table} if isinstance(table, Mapping) else table
        kept = {name: table for name, table in stated.items() if table != {}}
        return cls.from_dict(kept, files)


class Scenario(Document):
    """A machine in time: its start, its controller, events, sensors, and how long it runs.

    ``Scenario(path)`` is a scenario file; the path of its robot is relative to its folder. :meth:`of` makes one of a model.
    """

    __slots__ = ()
    _default = "scenario.toml"

    @classmethod
    def of(
        cls,
        machine: Model,
        *,
        pose: Numbers,
        duration: float,
        tensions: Numbers | None = None,
        tension_method: str | None = None,
        displacement: Numbers | None = None,
        twist: Numbers | None = None,
        step: float = 0.001,
        record: float | None = None,
        winches: str = "ideal",
        damping: float | None = None,
        events: list[Mapping[str, Any]] | None = None,
        tables: Mapping[str, Any] | None = None,
    ) -> Scenario:
        """Returns the scenario of a machine that starts in equilibrium at a pose, then displaced, and runs for ``duration`` seconds.

        ``pose``, ``displacement``, ``twist`` in the components of the motion pattern (m, rad; m/s, rad/s), ``tensions`` (N) or a
        ``tension_method`` (closed-form if both are left out). ``step``, ``record`` (s): of the integrator and of the log. ``damping``
        (N·s/m) of each cable on its elongation rate. ``events``: tables ``[[event]]`` of a scenario file, e.g.
        ``{"time_s": 1.0, "kind": "cable-break", "cable": 3}``. ``tables``: any further tables, e.g. ``{"sensors": {…}}``.
        """
        if tensions is None and tension_method is None:
            tension_method = "closed-form"
        stated: dict[str, Any] = {
            "machine": _stated(
                robot="machine.toml", model=machine.composition, winches=winches, cable_damping_N_s_per_m=damping
            ),
            "start": _stated(
                pose=pose,
                tensions_N=tensions,
                tension_method=tension_method,
                displacement=displacement,
                twist=twist,
            ),
            "event": [dict(event) for event in events or []],
            "time": _stated(duration_s=duration, step_s=step, record_s=record),
        }
        for name, table in (tables or {}).items():
            stated[name] = {**stated.get(name, {}), **table} if isinstance(table, Mapping) else table
        return cls.from_dict({name: table for name, table in stated.items() if table}, {"machine.toml": machine.robot})


class Sweep(Document):
    """A study over ranges of numbers. ``Sweep(path)`` is a sweep file; the path of its study is relative to its folder. :meth:`of` makes one
    of a study."""

    __slots__ = ()
    _default = "sweep.toml"

    @classmethod
    def of(
        cls,
        study: Study,
        parameters: Mapping[str, Any],
        *,
        bounds: Numbers | None = None,
        step: float | None = None,
        position_error_max: Numbers | None = None,
        tables: Mapping[str, Any] | None = None,
    ) -> Sweep:
        """Returns the sweep of a study over parameters.

        ``parameters``: values by key, e.g. ``{"machine.axial-stiffness": [1e5, 1e6]}``, or the keys of a table ``[[parameter]]``, e.g.
        ``{"from": 1e5, "to": 1e7, "count": 16, "spacing": "logarithmic"}``; every value meets every value of the others. ``bounds``: box
        x least, x largest, y least, … (m) in which the reachable workspace is sought; ``step`` (m): edge of its cells.
        ``position_error_max`` (m): accuracies for which it is told besides. ``tables``: any further tables and keys of a sweep file.
        """
        stated: dict[str, Any] = _stated(
            study=study._path or "study.toml", position_error_max_m=position_error_max, bounds_m=bounds, step_m=step
        )
        stated["parameter"] = [
            {"key": key, **(own if isinstance(own, Mapping) else {"values": plain(own)})} for key, own in parameters.items()
        ]
        files: dict[str, Robot | str | bytes] = {}
        if study._path is None:
            files = {"study.toml": study._text, **study._files}
        return cls.from_dict({**stated, **(tables or {})}, files)


def _bytes(content: Robot | str | bytes) -> bytes:
    if isinstance(content, Robot):
        return content._text
    return content.encode() if isinstance(content, str) else content


def _component_columns(robot: Robot) -> list[str]:
    if robot.dof == 6:
        return ["x_m", "y_m", "z_m", "rx_rad", "ry_rad", "rz_rad"]
    return [f"{name}_rad" if name == "angle" else f"{name}_m" for name in robot.component_names]


def _stated(**keys: Any) -> dict[str, Any]:
    return {key: plain(value) for key, value in keys.items() if value is not None}


def toml(tables: Mapping[str, Any]) -> str:
    """Returns a TOML text: keys first, then tables; tables in tables are written inline."""
    heads = {name: own for name, own in tables.items() if isinstance(own, Mapping)}
    lists = {
        name: own
        for name, own in tables.items()
        if isinstance(own, (list, tuple)) and own and all(isinstance(entry, Mapping) for entry in own)
    }
    lines = [f"{name} = {_inline(own)}" for name, own in tables.items() if name not in heads and name not in lists]
    for name, own in heads.items():
        lines += [f"[{name}]", *(f"{key} = {_inline(value)}" for key, value in own.items())]
    for name, entries in lists.items():
        for own in entries:
            lines += [f"[[{name}]]", *(f"{key} = {_inline(value)}" for key, value in own.items())]
    return "\n".join(lines) + "\n"


def _inline(value: Any) -> str:
    value = plain(value)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {_inline(own)}" for key, own in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_inline(own) for own in value) + "]"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        # shortest text that is read back to the same bits; TOML has a point or an exponent in every float
        return repr(value)
    if isinstance(value, int):
        return str(value)
    return json.dumps(str(value), ensure_ascii=False)
