"""Models, calibration and model selection for cable-driven parallel robots.

Robots and models compute on arrays (:class:`Robot`, :class:`Model`); questions of the command are functions (:func:`select`,
:func:`identify`, :func:`accuracy`, :func:`workspace`, …) whose results are the command's JSON with attributes; machines in time are stepped
(:class:`Plant`) or run (:func:`run`) with controllers of one's own. SI units and radians everywhere; docstrings say which. A caller's
mistake raises :class:`Error`; a mathematical outcome is a status.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from . import dask, gym, sweep
    from ._arrays import poses_of, rotations_of
    from ._documents import Scenario, Study, Sweep
    from ._errors import Error, Place, ReadError
    from ._model import Difference, Forward, Margins, Model, State, Status, Tensions, TensionStatus, difference
    from ._plant import Controller, Measured, Motion, Plant, PlantState, Setpoint
    from ._questions import *
    from ._result import Result, frame_of
    from ._results import (
        Accuracy,
        Advice,
        Benchmark,
        CalibrationCosts,
        Campaign,
        Candidate,
        Chain,
        Compensation,
        Evaluation,
        Identification,
        InitialTensions,
        Mesh,
        Modes,
        PlacedPulleys,
        Plan,
        Reachable,
        RobotCheck,
        Run,
        Selection,
        SelfCalibration,
        Sensitivity,
        Simulation,
        SweepResult,
        Workspace,
    )
    from ._robot import Parameter, Robot, robots
    from ._samples import Samples, Sigmas
    from ._views import explain, new, self_calibrate

# modules are imported when a name of theirs is asked for: `import cdpr` and the command start without numpy
_MODULES = {
    "_arrays": ("poses_of", "rotations_of"),
    "_documents": ("Scenario", "Study", "Sweep"),
    "_errors": ("Error", "Place", "ReadError"),
    "_model": ("Difference", "Forward", "Margins", "Model", "State", "Status", "Tensions", "TensionStatus", "difference"),
    "_plant": ("Controller", "Measured", "Motion", "Plant", "PlantState", "Setpoint"),
    "_questions": (
        "accuracy",
        "advise",
        "benchmark",
        "campaign",
        "capability",
        "chain",
        "check",
        "compensate",
        "demo",
        "dynamics",
        "evaluate",
        "fk",
        "frequency_response",
        "friction",
        "identify",
        "ik",
        "initial_tension",
        "load",
        "model",
        "modes",
        "place_pulleys",
        "plan",
        "reachable",
        "run",
        "select",
        "sensitivity",
        "simulate",
        "stiffness",
        "study",
        "tension",
        "test_bench",
        "workspace",
    ),
    "_result": ("Result", "frame_of"),
    "_results": (
        "Accuracy",
        "Advice",
        "Benchmark",
        "CalibrationCosts",
        "Campaign",
        "Candidate",
        "Chain",
        "Compensation",
        "Evaluation",
        "Identification",
        "InitialTensions",
        "Mesh",
        "Modes",
        "PlacedPulleys",
        "Plan",
        "Reachable",
        "RobotCheck",
        "Run",
        "Selection",
        "SelfCalibration",
        "Sensitivity",
        "Simulation",
        "SweepResult",
        "Workspace",
    ),
    "_robot": ("Parameter", "Robot", "robots"),
    "_samples": ("Samples", "Sigmas"),
    "_views": ("explain", "new", "self_calibrate"),
}
_EXTRAS = ("dask", "gym", "sweep")
_PLACES = {name: module for module, names in _MODULES.items() for name in names}

__all__ = [*_PLACES, "sweep"]  # noqa: PLE0604


def __getattr__(name: str) -> Any:
    if name in _EXTRAS:
        return import_module(f"{__name__}.{name}")
    if name not in _PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_PLACES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return [*globals(), *_PLACES, *_EXTRAS]
