"""Robots: anchors, cables, platform and limits, as one immutable value."""

from __future__ import annotations

import difflib
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from . import _cdpr
from ._arrays import Array, Numbers, Path
from ._errors import Error, Place

if TYPE_CHECKING:
    import pandas


@dataclass(frozen=True)
class Parameter:
    """A single number of a robot."""

    name: str
    """Name, e.g. ``frame-anchor[3].x``; cables count from 1."""
    value: float | None
    """Value in ``unit``; ``None`` if the robot's file states none."""
    unit: str
    """Unit, in SI; empty for a ratio."""


class Robot:
    """A cable-driven parallel robot. Immutable; equal robots have the same file.

    ``Robot(path_or_name)`` reads a robot file (TOML) or takes a built-in robot by its name (:func:`robots`). A word with a dot or a
    separator is a path. Raises :class:`cdpr.ReadError` with file, line and column where the file is at fault.

    >>> robot = Robot("cablerobot-simulator-helicopter")
    >>> robot.cable_count, robot.motion_pattern
    (8, '3R3T')
    """

    __slots__ = ("_data", "_name", "_text")

    _data: _cdpr.Robot
    _name: str
    _text: bytes

    def __init__(self, path_or_name: Path) -> None:
        word = os.fspath(path_or_name)
        looks_like_path = any(sign in word for sign in "/\\.")
        data = None if looks_like_path else _cdpr.Robot.builtin(word)
        if data is not None:
            self._set(data, f"{word}.toml", data.to_toml().encode())
            return
        if not looks_like_path and not FilePath(word).is_file():
            message = f"there is neither a built-in robot nor a file named `{word}`"
            help = f"{meant(word, robots())}`cdpr.robots()` lists the built-in robots"
            raise Error("robot::unknown-name", message, help)
        text = read(word)
        self._set(_cdpr.Robot.from_toml(text, word), word, text)

    def _set(self, data: _cdpr.Robot, name: str, text: bytes) -> None:
        for slot, value in (("_data", data), ("_name", name), ("_text", text)):
            object.__setattr__(self, slot, value)

    @classmethod
    def _of(cls, data: _cdpr.Robot, name: str, text: bytes) -> Robot:
        robot = object.__new__(cls)
        robot._set(data, name, text)
        return robot

    @classmethod
    def from_toml(cls, text: str | bytes, name: str = "robot.toml") -> Robot:
        """Returns the robot of a TOML text; ``name`` stands for the file in errors."""
        content = text.encode() if isinstance(text, str) else text
        return cls._of(_cdpr.Robot.from_toml(content, name), name, content)

    def __setattr__(self, name: str, _value: object) -> None:
        raise AttributeError(f"robots are immutable: use `robot.replace(…)` instead of setting `{name}`")

    def to_toml(self) -> str:
        """Returns the robot file, with the comments of the file that it comes from."""
        return self._text.decode()

    def save(self, path: Path) -> None:
        """Writes the robot file."""
        save(path, self._text)

    @property
    def name(self) -> str:
        """Name of the robot."""
        return self._data.name

    @property
    def title(self) -> str | None:
        """What the robot is, in words."""
        return self._data.title

    @property
    def motion_pattern(self) -> str:
        """Motions of the platform: ``2T``, ``1R2T``, ``3T``, ``2R3T`` or ``3R3T``."""
        return self._data.motion_pattern

    @property
    def cable_count(self) -> int:
        """Number of cables, m."""
        return self._data.cable_count

    @property
    def dof(self) -> int:
        """Degrees of freedom of the platform, n."""
        return self._data.dof

    @property
    def cable_names(self) -> list[str]:
        """Names of the cables."""
        return self._data.cable_names

    @property
    def component_names(self) -> list[str]:
        """Names of the components of a pose in the motion pattern, e.g. ``x, y, angle``."""
        return self._data.component_names

    @property
    def frame_anchors(self) -> Array:
        """Frame anchors (m, 3) in world coordinates (m)."""
        return self._data.frame_anchors

    @property
    def platform_anchors(self) -> Array:
        """Platform anchors (m, 3) in platform coordinates (m)."""
        return self._data.platform_anchors

    @property
    def home(self) -> Array:
        """Home pose x, y, z, qx, qy, qz, qw (m), or the middle of the frame if the file states none."""
        return self._data.home

    @property
    def warnings(self) -> list[str]:
        """Remarks on the numbers of the file; :func:`cdpr.check` says more."""
        return self._data.warnings

    @property
    def parameters(self) -> list[Parameter]:
        """All numbers of the robot by name."""
        return [Parameter(*named) for named in self._data.parameters()]

    def parameters_to_pandas(self) -> pandas.DataFrame:
        """Returns the numbers as a table with the columns name, value and unit."""
        from ._result import pandas_of

        return pandas_of([{"name": p.name, "value": p.value, "unit": p.unit} for p in self.parameters])

    def __getitem__(self, name: str) -> Parameter:
        """Returns a number by its name, e.g. ``robot["frame-anchor[3].x"]``."""
        found = self._data.parameter(name)
        if not found:
            raise KeyError(f"{name}: {meant(name, [own.name for own in self.parameters])}`robot.parameters` lists all names")
        if len(found) > 1:
            raise KeyError(f"{name} stands for {len(found)} numbers, from {found[0][0]} to {found[-1][0]}")
        return Parameter(*found[0])

    def replace(self, changes: Mapping[str, float]) -> Robot:
        """Returns a robot with other numbers, by name; this one stays as it is.

        >>> robot = Robot("planar-example")
        >>> robot.replace({"frame-anchor[1].x": -2.1})["frame-anchor[1].x"].value
        -2.1
        """
        data = self._data.replaced([(name, float(value)) for name, value in changes.items()])
        return Robot._of(data, f"{self.name}.toml", data.to_toml().encode())

    def components(self, poses: Numbers) -> Array:
        """Returns poses in the components of the motion pattern, (N, n)."""
        return self._data.components(poses)

    def quaternions(self, poses: Numbers) -> Array:
        """Returns poses as rows x, y, z, qx, qy, qz, qw."""
        return self._data.quaternions(poses)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Robot) and self._data.to_toml() == other._data.to_toml()

    def __hash__(self) -> int:
        return hash(self._data.to_toml())

    def __repr__(self) -> str:
        return f"<cdpr.Robot {self.name!r}: {self.cable_count} cables, {self.motion_pattern}>"

    def _repr_html_(self) -> str:
        from ._html import of_robot

        return of_robot(self)

    def __reduce__(self) -> tuple[Any, tuple[bytes, str]]:
        return Robot.from_toml, (self._text, self._name)

    def __copy__(self) -> Robot:
        return self

    def __deepcopy__(self, _memo: object) -> Robot:
        return self


def robots() -> list[str]:
    """Returns the names of the built-in robots."""
    return _cdpr.builtin_names()


def meant(word: str, names: Iterable[str]) -> str:
    """Returns a question for the name that a word is nearest to; nothing if none is near."""
    near = difflib.get_close_matches(word, list(names), 1)
    return f"did you mean `{near[0]}`? " if near else ""


def read(path: Path) -> bytes:
    """Returns the content of a file."""
    try:
        return FilePath(path).read_bytes()
    except OSError as error:
        raise Error("io::read", f"cannot be read: {error.strerror}", None, Place(os.fspath(path))) from None


def save(path: Path, content: bytes) -> None:
    """Writes a file whole: it is there completely or as it was before."""
    target = FilePath(path)
    beside = target.with_name(f".{target.name}.{os.getpid()}")
    try:
        beside.write_bytes(content)
        beside.replace(target)
    except OSError as error:
        beside.unlink(missing_ok=True)
        raise Error("io::write", f"cannot be written: {error.strerror}", None, Place(str(target))) from None
