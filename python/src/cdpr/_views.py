"""Questions that are asked in other words than the command's."""

from __future__ import annotations

from typing import Any

from . import _results as results
from ._arrays import Path, Progress
from ._ask import ask
from ._errors import Error
from ._model import Model
from ._robot import Robot
from ._samples import Samples


def self_calibrate(
    robot: Robot | Model | Path,
    data: Samples | Path,
    *,
    free: str,
    progress: Progress = None,
    threads: int | None = None,
    **options: Any,
) -> results.SelfCalibration:
    """Returns the calibration of data without measured poses: poses are found together with the parameters.

    ``free``: parameters to identify, e.g. ``"frame-anchor"``. ``options``: further arguments of :func:`cdpr.identify`, of which ``gauge``,
    ``known`` and ``starts`` are about this.
    """
    words: dict[str, Any] = {name.replace("_", "-"): value for name, value in options.items()}
    outputs = {"out": "calibrated.toml", "out-poses": "poses.csv", "report": "report.html"}
    answer = ask(
        (results.SelfCalibration, results.Identification),
        "identify",
        [robot, data],
        {"free": free, **words},
        outputs=outputs,
        repeating=("known",),
        progress=progress,
        threads=threads,
    )
    if isinstance(answer, results.SelfCalibration):
        return answer
    raise Error("data::has-poses", "these samples have measured poses", "`cdpr.identify` uses them")


def explain(code: str) -> str:
    """Returns the page about an error's code or a finding, e.g. ``"finding::scale"``: what happened, causes, how to mend it."""
    answer = ask(results.Explanation, "explain", [code], {})
    return str(answer.to_dict()["explanation"])


def new(template: str) -> results.NewFolder:
    """Returns a robot to start from, with a study and a scenario: ``suspended-camera``, ``wall-plotter``, ``planar-frame`` or ``box``.

    ``save(folder)`` writes its files, each of which explains its lines.
    """
    return ask(results.NewFolder, "new", [template], {}, outputs={"out": "new"})
