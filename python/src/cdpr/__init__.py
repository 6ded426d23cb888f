"""Models, calibration and model selection for cable-driven parallel robots.

Robots and models compute on arrays (:class:`Robot`, :class:`Model`); questions of the command are functions (:func:`select`,
:func:`identify`, :func:`accuracy`, :func:`workspace`, …) whose results are the command's JSON with attributes; machines in time are stepped
(:class:`Plant`) or run (:func:`run`) with controllers of one's own. SI units and radians everywhere; docstrings say which. A caller's
mistake raises :class:`Error`; a mathematical outcome is a status.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import sweep
from ._arrays import poses_of, rotations_of
from ._documents import Scenario, Study, Sweep
from ._errors import Error, Place, ReadError
from ._model import Difference, Forward, Model, State, Status, Tensions, TensionStatus, difference
from ._plant import Controller, Measured, Motion, Plant, PlantState, Setpoint
from ._questions import *
from ._questions import __all__ as _asked
from ._result import Result
from ._robot import Parameter, Robot, robots
from ._samples import Samples, Sigmas
from ._views import explain, self_calibrate

if TYPE_CHECKING:
    from . import dask, gym

__all__ = [
    "Controller",
    "Difference",
    "Error",
    "Forward",
    "Measured",
    "Model",
    "Motion",
    "Parameter",
    "Place",
    "Plant",
    "PlantState",
    "ReadError",
    "Result",
    "Robot",
    "Samples",
    "Scenario",
    "Setpoint",
    "Sigmas",
    "State",
    "Status",
    "Study",
    "Sweep",
    "TensionStatus",
    "Tensions",
    "difference",
    "explain",
    "poses_of",
    "robots",
    "rotations_of",
    "self_calibrate",
    "sweep",
    *_asked,
]


def __getattr__(name: str) -> Any:
    """Returns the modules of extras, which are imported when they are asked for."""
    if name in ("dask", "gym"):
        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
