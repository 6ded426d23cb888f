"""Measurements: poses, recorded lengths, tensions and further sensors, with the accuracies of the sensors."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

import numpy as np

from ._arrays import Array, Numbers, Path
from ._errors import Error
from ._robot import Robot, read, save

if TYPE_CHECKING:
    import pandas

    from ._ask import Call


@dataclass(frozen=True)
class Sigmas:
    """Standard deviations of the sensors, per axis; ``None`` if unknown."""

    position: float | None = None
    """Of measured positions (m)."""
    rotation: float | None = None
    """Of measured orientations (rad)."""
    length: float | None = None
    """Of recorded cable lengths (m)."""
    tension: float | None = None
    """Of recorded tensions (N)."""
    swivel: float | None = None
    """Of recorded swivel angles (rad)."""
    length_scale: float | None = None
    """Of a factor that all lengths may have in common (a ratio)."""
    balance_force: float | None = None
    """By which cables and load may miss their equilibrium (N)."""
    balance_moment: float | None = None
    """By which cables and load may miss their equilibrium (N·m)."""

    def _option(self) -> dict[str, float]:
        stated = {_SIGMAS[own.name]: getattr(self, own.name) for own in fields(self)}
        return {name: value for name, value in stated.items() if value is not None}


_SIGMAS = {
    "position": "position_m",
    "rotation": "rotation_rad",
    "length": "length_m",
    "tension": "tension_N",
    "swivel": "swivel_rad",
    "length_scale": "length_scale",
    "balance_force": "balance_N",
    "balance_moment": "balance_Nm",
}


class Samples:
    """A record of measurements. Immutable; made by :meth:`from_csv`, :meth:`from_arrays` or :meth:`from_pandas`.

    The columns have the names of measurement files, which carry units: ``x_m``, ``y_m``, ``z_m``, ``qx``, ``qy``, ``qz``, ``qw`` or
    ``angle_rad``, ``cable_length_m_1``, … ``tension_N_1``, …, ``set``, ``t_s``; ``_mm`` and ``_deg`` are converted. They are read when a
    question is asked, since the robot says which are needed; mistakes raise :class:`cdpr.ReadError` with line and column.
    """

    __slots__ = ("_name", "_options", "_sidecar", "_text")

    _name: str
    _text: bytes
    _sidecar: bytes | None
    _options: dict[str, Any]

    def __init__(self, _name: str, _text: bytes, _sidecar: bytes | None, _options: Mapping[str, Any]) -> None:
        values = (("_name", _name), ("_text", _text), ("_sidecar", _sidecar), ("_options", dict(_options)))
        for slot, value in values:
            object.__setattr__(self, slot, value)

    def __setattr__(self, name: str, _value: object) -> None:
        raise AttributeError(f"samples are immutable: make others instead of setting `{name}`")

    @classmethod
    def from_csv(
        cls,
        path: Path,
        *,
        sigmas: Sigmas | None = None,
        columns: Mapping[str, str] | None = None,
        skip_invalid: bool = False,
        merge: Path | None = None,
        merge_gap: float | None = None,
        static: bool = False,
    ) -> Samples:
        """Returns the measurements of a file (CSV), with the sidecar beside it (``.meta.toml``) if there is one.

        ``sigmas``: accuracies of the sensors, instead of the sidecar's. ``columns``: columns of the file by the names that measurements
        have, e.g. ``{"x_m": "X_world"}``. ``skip_invalid``: leaves out rows with gaps or text. ``merge``: log of a tracker, whose poses
        are interpolated at the times ``t_s``, over gaps of ``merge_gap`` seconds at most. ``static``: averages poses that are held.
        """
        name = os.fspath(path)
        text = read(name)
        beside = FilePath(name).with_suffix(".meta.toml")
        sidecar = read(beside) if beside.is_file() else None
        options: dict[str, Any] = {
            "sigma": sigmas._option() if sigmas else None,
            "columns": columns,
            "skip_invalid": skip_invalid,
            "merge": None if merge is None else os.fspath(merge),
            "merge_gap": merge_gap,
            "static": static,
        }
        return cls(name, text, sidecar, {key: value for key, value in options.items() if value})

    @classmethod
    def from_arrays(
        cls,
        *,
        poses: Numbers | None = None,
        lengths: Numbers | None = None,
        tensions: Numbers | None = None,
        length_changes: Numbers | None = None,
        motor_angles: Numbers | None = None,
        swivels: Numbers | None = None,
        times: Numbers | None = None,
        sets: Sequence[str] | None = None,
        sigmas: Sigmas | None = None,
        robot: Robot | None = None,
    ) -> Samples:
        """Returns the measurements of arrays with N rows.

        ``poses``: (N, 7) x, y, z, qx, qy, qz, qw, (N, 6) x, y, z, rx, ry, rz (R = Rx Ry Rz), (N, 3) x, y, z, or the components of the
        motion pattern of ``robot``, e.g. x, y, angle of a planar one (m, rad); none if nobody measured them. ``lengths`` (N, m): recorded
        cable lengths (m), or ``length_changes`` (m) from a common unknown pose, or ``motor_angles`` (rad). ``tensions`` (N, m) (N),
        ``swivels`` (N, m) (rad), ``times`` (N,) (s). ``sets``: train or validation, a word for each row. NaN is a gap.
        """
        table: dict[str, Any] = {}
        if poses is not None:
            table.update(_pose_columns(np.asarray(poses, dtype=float), robot))
        per_cable = [
            ("cable_length_m", lengths),
            ("cable_length_change_m", length_changes),
            ("motor_angle_rad", motor_angles),
            ("tension_N", tensions),
            ("swivel_rad", swivels),
        ]
        for name, given in per_cable:
            if given is not None:
                rows = np.asarray(given, dtype=float)
                if rows.ndim != 2:
                    raise Error("array::unfit", f"{name}: the shape is {rows.shape}, needed is (N, m)", "one row per sample")
                table.update({f"{name}_{cable + 1}": column for cable, column in enumerate(rows.T)})
        if times is not None:
            table["t_s"] = np.asarray(times, dtype=float)
        if sets is not None:
            table["set"] = list(sets)
        counts = {name: len(column) for name, column in table.items()}
        if len(set(counts.values())) > 1:
            raise Error("array::unfit", f"columns have different numbers of rows: {counts}", "one row per sample in each")
        options = {"sigma": sigmas._option()} if sigmas else {}
        return cls("samples.csv", _csv(table), None, options)

    @classmethod
    def from_pandas(
        cls, table: pandas.DataFrame, *, sigmas: Sigmas | None = None, columns: Mapping[str, str] | None = None
    ) -> Samples:
        """Returns the measurements of a table whose columns have the names of measurement files.

        ``columns``: columns of the table by these names, where it calls them otherwise, e.g. ``{"x_m": "X_world"}``.
        """
        options: dict[str, Any] = {"sigma": sigmas._option() if sigmas else None, "columns": columns}
        text = _csv({str(name): table[name].to_numpy() for name in table.columns})
        return cls("samples.csv", text, None, {key: value for key, value in options.items() if value})

    @property
    def name(self) -> str:
        """Name of the file, as messages have it."""
        return self._name

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        first = self._text.decode("utf-8-sig", "replace").split("\n", 1)[0]
        dialect = ";" if first.count(";") > first.count(",") else "\t" if "\t" in first else ","
        return next(csv.reader([first.strip()], delimiter=dialect), [])

    def to_csv(self) -> str:
        """Returns the measurement file."""
        return self._text.decode("utf-8-sig", "replace")

    def save(self, path: Path) -> None:
        """Writes the measurement file, and the sidecar beside it if there is one."""
        save(path, self._text)
        if self._sidecar is not None:
            save(FilePath(path).with_suffix(".meta.toml"), self._sidecar)

    def to_pandas(self) -> pandas.DataFrame:
        """Returns the columns as a table, with the names of the file."""
        import pandas

        return pandas.read_csv(io.StringIO(self.to_csv()), sep=None, engine="python")

    def _put(self, call: Call) -> str:
        name = call.file(self._name, self._text)
        if self._sidecar is not None:
            call.files[str(FilePath(name).with_suffix(".meta.toml"))] = self._sidecar
        for option, value in self._options.items():
            call.add(option.replace("_", "-"), value)
        return name

    def __len__(self) -> int:
        return max(0, sum(1 for line in self._text.splitlines() if line.strip()) - 1)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Samples) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash((self._text, self._sidecar))

    def _key(self) -> tuple[bytes, bytes | None, dict[str, Any]]:
        return self._text, self._sidecar, self._options

    def __repr__(self) -> str:
        return f"<cdpr.Samples {self._name!r}: {len(self)} rows, {len(self.columns)} columns>"

    def __reduce__(self) -> tuple[type[Samples], tuple[str, bytes, bytes | None, dict[str, Any]]]:
        return Samples, (self._name, self._text, self._sidecar, self._options)


def _pose_columns(poses: Array, robot: Robot | None) -> dict[str, Array]:
    if poses.ndim != 2:
        raise Error("array::unfit", f"poses: the shape is {poses.shape}, needed is (N, 7)", "one row per sample")
    width = poses.shape[1]
    if robot is not None and width == robot.dof and width < 6:
        names = [f"{name}_rad" if name == "angle" else f"{name}_m" for name in robot.component_names]
    elif width == 6:
        names = ["x_m", "y_m", "z_m", "rx_rad", "ry_rad", "rz_rad"]
    elif width == 7:
        names = _FULL
    elif width in (2, 3):
        names = _FULL[:width]
    else:
        raise Error("array::unfit", f"poses: {width} columns are no pose", "pass (N, 7), (N, 6), or `robot=` with its components")
    return dict(zip(names, poses.T, strict=True))


_FULL = ["x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"]


def _csv(table: Mapping[str, Any]) -> bytes:
    """Returns a table as CSV; numbers are read back to the same bits."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(table.keys())
    columns = [_cells(column) for column in table.values()]
    writer.writerows(zip(*columns, strict=True))
    return text.getvalue().encode()


def _cells(column: Any) -> list[str]:
    def cell(value: Any) -> str:
        if isinstance(value, (float, np.floating)):
            return "" if np.isnan(value) else repr(float(value))
        return "" if value is None else str(value)

    return [cell(value) for value in column]
