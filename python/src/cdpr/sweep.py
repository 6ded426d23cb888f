"""Sweeps, benchmarks, drawn robots and repeated campaigns in three steps, for any scheduler: a plan, a row for each point, and the rows merged.

>>> plan = cdpr.sweep.plan("sweep.toml")  # doctest: +SKIP
>>> rows = [cdpr.sweep.row(plan.data, point) for point in range(len(plan))]  # doctest: +SKIP
>>> result = cdpr.sweep.merge(plan, rows)  # doctest: +SKIP

>>> plan = cdpr.sweep.plan_of(cdpr.benchmark, seed=3)  # a part for each robot  # doctest: +SKIP

A row is a function of the plan's bytes and a number: it may be computed anywhere, by any process, any number of times, in any order, and
is the same bytes. :mod:`cdpr.dask` hands rows out to a cluster.
"""

from __future__ import annotations

import os
import shlex
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from pathlib import Path as FilePath
from typing import Any, TypeAlias

import numpy as np

from . import _cdpr
from . import _results as results
from ._arrays import Array, Path, Progress
from ._ask import PLANNING, Call, ask, observer
from ._documents import Sweep
from ._errors import Error
from ._result import Result
from ._robot import save

Merged: TypeAlias = "results.SweepResult | results.CalibrationCosts | results.Benchmark | results.Sensitivity | results.Campaign"

__all__ = ["Plan", "merge", "plan", "plan_of", "row", "run"]


class Plan:
    """Everything that decides the result of a sweep. Immutable, pickled by its bytes."""

    __slots__ = ("_prepared", "data")

    data: bytes
    """The file ``plan.json``."""
    _prepared: _cdpr.PreparedSweep

    def __init__(self, data: bytes) -> None:
        object.__setattr__(self, "data", data)
        object.__setattr__(self, "_prepared", _prepared(data))

    def __setattr__(self, name: str, _value: object) -> None:
        raise AttributeError(f"plans are immutable: `{name}` cannot be set")

    @classmethod
    def from_folder(cls, folder: Path) -> Plan:
        """Returns the plan in a folder of ``cdpr sweep plan``."""
        return cls((FilePath(folder) / "plan.json").read_bytes())

    @property
    def fingerprint(self) -> str:
        """SHA-256 of the plan, by which rows know it."""
        return self._prepared.fingerprint

    @property
    def points(self) -> Array:
        """Values of the parameters (P, k), point by point, in the units of the sweep file; (P, 0) for the parts of a question."""
        points = self._prepared.points
        return np.empty((len(self), 0)) if points is None else np.array(points)

    @property
    def question(self) -> str | None:
        """The command whose parts are planned, as a shell takes it; ``None`` for a sweep."""
        command = self._prepared.command
        return None if command is None else shlex.join(["cdpr", *command])

    def row_name(self, point: int) -> str:
        """Returns the name of the file of a point's row, in the folder ``rows`` beside the plan."""
        name = self._prepared.row_name(point) if point >= 0 else None
        if name is None:
            raise _no_point(point, len(self))
        return name

    def save(self, folder: Path) -> None:
        """Writes ``plan.json`` into a folder, as ``cdpr sweep plan --out`` does."""
        FilePath(folder).mkdir(parents=True, exist_ok=True)
        save(FilePath(folder) / "plan.json", self.data)

    def __len__(self) -> int:
        return len(self._prepared)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Plan) and self.data == other.data

    def __hash__(self) -> int:
        return hash(self.data)

    def __repr__(self) -> str:
        return f"<cdpr.sweep.Plan {self.fingerprint[:12]}: {len(self)} points>"

    def __reduce__(self) -> tuple[type[Plan], tuple[bytes]]:
        return Plan, (self.data,)


@lru_cache(maxsize=4)
def _prepared(data: bytes) -> _cdpr.PreparedSweep:
    """Returns a plan prepared to compute rows; the last ones are kept, so that many rows of a plan in a process prepare it once."""
    return _cdpr.PreparedSweep(data)


def _no_point(point: int, count: int) -> Error:
    return Error("sweep::no-point", f"there is no point {point}", f"the plan has the points 0 to {count - 1}")


def plan(sweep: Sweep | Path) -> Plan:
    """Returns the plan of a sweep, or of the path of a sweep file."""
    result = ask(results.SweepProgress, "sweep plan", [sweep], {}, outputs={"out": "sweep"})
    return Plan(result.attached["sweep/plan.json"])


def plan_of(question: Callable[..., Result], /, *arguments: Any, **options: Any) -> Plan:
    """Returns the plan of a question whose work has parts: ``plan_of(cdpr.benchmark, robots=[…])`` is what ``cdpr.benchmark(robots=[…])`` would
    compute.

    :func:`cdpr.benchmark` has a part for each robot, :func:`cdpr.sensitivity` of a study with ``[tolerances]`` for sixteen drawn robots,
    :func:`cdpr.campaign` with ``repeats`` for each repetition. The merged result is the question's own.
    """

    class _Planned(BaseException):
        pass

    calls: list[Call] = []

    def take(call: Call) -> None:
        calls.append(call)
        raise _Planned

    token = PLANNING.set(take)
    try:
        question(*arguments, **options)
    except _Planned:
        pass
    finally:
        PLANNING.reset(token)
    result = ask(results.SweepProgress, "sweep plan", [], {}, outputs={"out": "sweep"}, behind=calls[0])
    return Plan(result.attached["sweep/plan.json"])


def row(plan: bytes, point: int) -> bytes:
    """Returns the row of a point of a plan, as the content of its file.

    The primitive for any scheduler: a pure function of the bytes of a plan (:attr:`Plan.data`) and the number of a point, from 0. The
    plan is prepared once in a process. The global interpreter lock is released.
    """
    prepared = _prepared(plan)
    found = prepared.row(point) if point >= 0 else None
    if found is None:
        raise _no_point(point, len(prepared))
    return found


def merge(plan: Plan, rows: Iterable[bytes] | Mapping[int, bytes] | None = None, folder: Path | None = None) -> Merged:
    """Returns the result of the rows of all points, in any order: of a mapping by point, or of the folder in which they stand.

    Raises :class:`cdpr.Error` where rows are missing or belong to another plan.
    """
    files = {"sweep/plan.json": plan.data}
    if folder is not None:
        place = FilePath(folder) / "rows"
        files.update({f"sweep/rows/{file.name}": file.read_bytes() for file in sorted(place.glob("*.json"))})
    if isinstance(rows, Mapping):
        files.update({f"sweep/rows/{plan.row_name(point)}": own for point, own in rows.items()})
    elif rows is not None:
        files.update({f"sweep/rows/{plan.row_name(point_of(own))}": own for own in rows})
    command = plan._prepared.command
    classes: Any = (results.SweepResult, results.CalibrationCosts) if command is None else results.of_command(command[0])
    merged: Merged = ask(classes, "sweep merge", [_Files(files)], {})
    return merged


def point_of(row: bytes) -> int:
    """Returns the number of the point that a row belongs to."""
    import json

    return int(json.loads(row)["row"]["point"])


class _Files:
    """Files of a folder of a sweep."""

    def __init__(self, files: Mapping[str, bytes]) -> None:
        self.files = files

    def _put(self, call: Call) -> str:
        call.files.update(self.files)
        return "sweep"


def run(
    sweep: Sweep | Plan | Path,
    *,
    folder: Path | None = None,
    workers: int | None = None,
    progress: Progress = None,
    compute: Callable[[bytes, int], bytes] = row,
) -> Merged:
    """Plans, computes and merges a sweep in this process, with ``workers`` threads (all processors if left out), and returns its result.

    ``folder``: keeps plan and rows there, and goes on where an earlier run ended. The result is the same for any number of workers.
    """
    own = sweep if isinstance(sweep, Plan) else plan(sweep)
    rows = kept(own, folder) if folder is not None else {}
    missing = [point for point in range(len(own)) if point not in rows]
    observe, close = observer(progress)
    count = workers or os.cpu_count() or 1
    try:
        with ThreadPoolExecutor(count) as pool:
            futures = {pool.submit(compute, own.data, point): point for point in missing}
            try:
                for done, (future, point) in enumerate(futures.items()):
                    rows[point] = future.result()
                    if folder is not None:
                        keep(own, folder, point, rows[point])
                    if observe is not None:
                        observe("sweeping", done + 1, len(missing))
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise
    finally:
        close()
    return merge(own, rows)


def kept(plan: Plan, folder: Path) -> dict[int, bytes]:
    """Returns the rows of a plan that stand in a folder, by point; writes the plan into the folder if there is none.

    Raises :class:`cdpr.Error` if the folder has another plan.
    """
    place = FilePath(folder)
    there = place / "plan.json"
    if there.is_file() and there.read_bytes() != plan.data and Plan(there.read_bytes()) != plan:
        raise Error("sweep::plan-changed", f"{folder} holds another plan", "give another folder, or remove this one")
    plan.save(folder)
    (place / "rows").mkdir(exist_ok=True)
    files = {point: place / "rows" / plan.row_name(point) for point in range(len(plan))}
    return {point: file.read_bytes() for point, file in files.items() if file.is_file()}


def keep(plan: Plan, folder: Path, point: int, row: bytes) -> None:
    """Writes a row into a folder."""
    save(FilePath(folder) / "rows" / plan.row_name(point), row)
