"""Sweeps on a cluster of Dask (extra ``cdpr[dask]``): rows are handed out, the result is the same bytes as of one process.

>>> from dask.distributed import Client  # doctest: +SKIP
>>> result = cdpr.dask.sweep(Client(), "sweep.toml", folder="s3://bucket/sweep")  # doctest: +SKIP

A worker prepares the plan once. Points go out in chunks that take about as long as their hand-out is worth, by the time that the first ones
took. A worker that dies loses its chunk, which another one computes; points at which workers die again and again are asked for one by one, with
nothing beside them, so that the one at fault is reported alone, and the rest finishes. There is no engine of our own: any scheduler may call :func:`cdpr.sweep.row`.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

from ._arrays import Path, Progress
from ._ask import observer
from ._documents import Sweep
from ._errors import Error
from .sweep import Merged, Plan, merge, plan, row

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["FailedPoints", "rows", "sweep"]

CHUNK_SECONDS = 2.0
"""Time that a chunk of points shall take: long beside a hand-out, short beside a sweep."""

LARGEST_CHUNK = 256
"""Points of a chunk at most, so that a dead worker loses little."""


class FailedPoints(Error):
    """Points that no worker could compute; all others are done, and kept in the folder if there is one."""

    failed: dict[int, str]
    """Reason by point."""
    rows: dict[int, bytes]
    """Rows of the other points."""

    def __init__(self, failed: dict[int, str], rows: dict[int, bytes]) -> None:
        points = ", ".join(f"{point} ({reason})" for point, reason in sorted(failed.items()))
        message = f"{len(failed)} of {len(failed) + len(rows)} points cannot be computed: {points}"
        super().__init__("sweep::failed-points", message, "`cdpr.sweep.row(plan.data, point)` shows each alone")
        self.failed, self.rows = failed, rows


def sweep(
    client: Client,
    sweep: Sweep | Plan | Path,
    *,
    folder: Path | None = None,
    progress: Progress = None,
    compute: Callable[[bytes, int], bytes] = row,
) -> Merged:
    """Returns the result of a sweep whose rows the workers of a cluster compute.

    ``folder``: a folder, or an address that ``fsspec`` knows (``s3://…``), where plan and rows are kept: a sweep that was interrupted goes on
    there. Raises :class:`FailedPoints` where points cannot be computed, after all others are done.
    """
    own = sweep if isinstance(sweep, Plan) else plan(sweep)
    return merge(own, rows(client, own, folder=folder, progress=progress, compute=compute))


def rows(
    client: Client,
    plan: Plan,
    *,
    points: Iterable[int] | None = None,
    folder: Path | None = None,
    progress: Progress = None,
    compute: Callable[[bytes, int], bytes] = row,
) -> dict[int, bytes]:
    """Returns the rows of a plan, or of some of its points, by point; arguments as of :func:`sweep`."""
    wanted = list(range(len(plan)) if points is None else points)
    store = _Store(folder, plan) if folder is not None else None
    found = {} if store is None else {point: own for point, own in store.kept().items() if point in set(wanted)}
    hand_out = _HandOut(client, plan, compute)
    observe, close = observer(progress)
    try:
        for point, own in hand_out.computed([point for point in wanted if point not in found]):
            found[point] = own
            if store is not None:
                store.keep(point, own)
            if observe is not None:
                observe("sweeping", len(found), len(wanted))
    except BaseException:
        hand_out.cancel()
        raise
    finally:
        close()
    if hand_out.failed:
        raise FailedPoints(hand_out.failed, found)
    return found


def _computed(
    compute: Callable[[bytes, int], bytes], data: bytes, points: Sequence[int]
) -> tuple[list[tuple[int, bytes | None, str]], float]:
    """Runs on a worker. Returns point, row and reason of a failure for each point, and the seconds that all took."""
    begun = time.perf_counter()
    out: list[tuple[int, bytes | None, str]] = []
    for point in points:
        try:
            out.append((point, compute(data, point), ""))
        except Exception as error:
            out.append((point, None, f"{type(error).__name__}: {error}"))
    return out, time.perf_counter() - begun


class _HandOut:
    """Points on their way to workers and back."""

    def __init__(self, client: Any, plan: Plan, compute: Callable[[bytes, int], bytes]) -> None:
        self.client, self.compute = client, compute
        # goes with every chunk: what is scattered is lost with the workers that hold it
        self.data = plan.data
        self.on_way: dict[Any, list[int]] = {}
        self.failed: dict[int, str] = {}

    def computed(self, points: list[int]) -> Iterable[tuple[int, bytes]]:
        """Yields points with their rows as they come."""
        from distributed import as_completed
        from distributed.scheduler import KilledWorker

        threads = max(1, sum(self.client.nthreads().values()))
        waiting, size = list(points), 1
        # points that were at work where a worker died: each is asked for again with nothing beside it
        suspects: list[int] = []
        coming: Any = as_completed  # untyped
        coming = coming([], raise_errors=False)
        while waiting or suspects or self.on_way:
            is_alone = not waiting and not self.on_way
            if is_alone:
                coming.add(self._submit([suspects.pop(0)]))
            # two chunks for each thread: one at work, one at hand
            while waiting and len(self.on_way) < 2 * threads:
                chunk, waiting = waiting[:size], waiting[size:]
                coming.add(self._submit(chunk))
            future = next(coming)
            chunk = self.on_way.pop(future)
            if future.status == "finished":
                answers, seconds = future.result()
                size = _next_size(seconds / len(chunk), len(waiting), threads)
                for point, own, reason in answers:
                    if own is None:
                        self.failed[point] = reason
                    else:
                        yield point, own
                continue
            error = future.exception() if future.status == "error" else None
            if is_alone:
                is_killed = error is None or isinstance(error, KilledWorker)
                self.failed[chunk[0]] = "workers died at it" if is_killed else f"{type(error).__name__}: {error}"
            else:
                suspects += chunk

    def _submit(self, chunk: list[int]) -> Any:
        future = self.client.submit(_computed, self.compute, self.data, chunk, pure=False, retries=0)
        self.on_way[future] = chunk
        return future

    def cancel(self) -> None:
        """Takes back what is on its way."""
        self.client.cancel(list(self.on_way))


def _next_size(seconds: float, waiting: int, threads: int) -> int:
    """Returns the points of the next chunk, from the seconds that a point takes: fewer towards the end, so that no worker waits for another."""
    worth = int(CHUNK_SECONDS / max(seconds, 1e-9))
    return max(1, min(worth, LARGEST_CHUNK, waiting // (2 * threads)))


class _Store:
    """Plan and rows in a folder, or in an object store, named as ``cdpr sweep`` names them."""

    def __init__(self, folder: Path, plan: Plan) -> None:
        import fsspec

        self.plan = plan
        self.files, self.root = fsspec.core.url_to_fs(os.fspath(folder))
        self.files.makedirs(f"{self.root}/rows", exist_ok=True)
        there = f"{self.root}/plan.json"
        if not self.files.exists(there):
            self._write(there, plan.data)
        elif Plan(self.files.cat_file(there)) != plan:
            raise Error("sweep::plan-changed", f"{folder} holds another plan", "give another folder, or remove this one")

    def kept(self) -> dict[int, bytes]:
        """Returns the rows that are there."""
        names = {self.plan.row_name(point): point for point in range(len(self.plan))}
        there = [os.path.basename(str(path)) for path in self.files.ls(f"{self.root}/rows", detail=False)]
        return {names[name]: self.files.cat_file(f"{self.root}/rows/{name}") for name in there if name in names}

    def keep(self, point: int, row: bytes) -> None:
        """Writes a row."""
        self._write(f"{self.root}/rows/{self.plan.row_name(point)}", row)

    def _write(self, path: str, content: bytes) -> None:
        # moved to its place when whole; object stores write whole objects anyway
        if "file" in self.files.protocol or self.files.protocol == "file":
            beside = f"{path}.{os.getpid()}"
            self.files.pipe_file(beside, content)
            self.files.mv(beside, path)
        else:
            self.files.pipe_file(path, content)
