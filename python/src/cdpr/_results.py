"""Results of questions: the classes of `_answers`, with the robots, tables and pages that come with an answer."""

from __future__ import annotations

import csv
import io
import struct
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _answers
from ._answers import Capability as Capability, Chain as Chain, Dynamics as Dynamics, Evaluation as Evaluation, Explanation as Explanation, ForwardKinematics as ForwardKinematics, FrequencyResponse as FrequencyResponse, Friction as Friction, InitialTensions as InitialTensions, InverseKinematics as InverseKinematics, ModelEffects as ModelEffects, NoHangingPose as NoHangingPose, PlatformLoad as PlatformLoad, RobotCheck as RobotCheck, Stiffness as Stiffness, Study as Study, SweepProgress as SweepProgress, Tensions as Tensions, TestBench as TestBench
from ._arrays import Array
from ._documents import Scenario
from ._documents import Study as StudyFile
from ._errors import Error
from ._model import Model
from ._result import Result
from ._robot import Robot
from ._samples import Samples

if TYPE_CHECKING:
    from ._ask import Call


class _Calibrated(Result):
    """A result with a calibrated robot."""

    __slots__ = ()

    @property
    def calibrated(self) -> Robot:
        """The robot with the identified numbers; its file says in ``[calibration] status`` how far they are to be trusted."""
        return Robot.from_toml(self.attached["calibrated.toml"], "calibrated.toml")


class Candidate(_answers.Candidate):
    """A candidate of a choice, with its calibrated robot."""

    __slots__ = ()

    @property
    def calibrated(self) -> Robot:
        """The robot with the numbers that this candidate identified. Raises :class:`cdpr.Error` if it could not be identified."""
        if "calibrated.toml" not in self.attached:
            raise Error("data::not-identified", f"`{self.name}` could not be identified: {self.failure}")
        return Robot.from_toml(self.attached["calibrated.toml"], "calibrated.toml")

    def to_model(self) -> Model:
        """Returns the calibrated control model."""
        return Model(self.calibrated, self.model)


class Selection(_answers.Selection):
    """Candidates with their errors on data held out, and the choice among them."""

    __slots__ = ()
    _TABLE = "candidates"

    @property
    def candidates(self) -> tuple[Candidate, ...]:
        """The candidates, from simple to complex."""
        places = {name.split("/")[-1].split("-")[0]: name for name in self.attached if "/calibrated/" in f"/{name}"}
        out = []
        for number, own in enumerate(self._data["candidates"]):
            file = places.get(f"{number + 1:02}")
            out.append(Candidate._of(own, {"calibrated.toml": self.attached[file]} if file else {}))
        return tuple(out)

    @property
    def recommended(self) -> Candidate | None:  # type: ignore[override]
        """The recommended candidate; ``None`` if none is, :attr:`reason` says why."""
        return self._candidate(self._data["recommended"])

    @property
    def best(self) -> Candidate | None:  # type: ignore[override]
        """The candidate with the least error; ``None`` if none could be judged."""
        return self._candidate(self._data["best"])

    def _candidate(self, name: str | None) -> Candidate | None:
        return next((own for own in self.candidates if own.name == name), None)


class Identification(_answers.Identification, _Calibrated):
    """An identification: parameters with their uncertainty, and errors."""

    __slots__ = ()
    _TABLE = "parameters"

    def to_model(self) -> Model:
        """Returns the calibrated model."""
        return Model(self.calibrated, self.model)


class SelfCalibration(_answers.SelfCalibration, _Calibrated):
    """A calibration without measured poses."""

    __slots__ = ()
    _TABLE = "parameters"

    @property
    def pose_table(self) -> Samples:
        """Poses of the samples, row by row as the data, in the frame of the calibrated anchors."""
        return Samples("poses.csv", self.attached["poses.csv"], None, {})


class Plan(_answers.Plan):
    """Planned poses, and what measurements there will tell."""

    __slots__ = ()
    _TABLE = "curve"

    @property
    def pose_rows(self) -> Array:
        """The planned poses in the components of the motion pattern (N, n) (m, rad), in the order of the path."""
        return np.array(self._data["pose_components"])


class Simulation(_answers.Simulation):
    """Virtual measurements of a study's machine."""

    __slots__ = ()

    @property
    def table(self) -> Samples:
        """The measurements, with the accuracies of the study's sensors."""
        return Samples("samples.csv", self.attached["samples.csv"], self.attached.get("samples.meta.toml"), {})


class PlacedPulleys(_answers.PlacedPulleys):
    """A robot with pulleys placed at its anchors."""

    __slots__ = ()

    @property
    def placed(self) -> Robot:
        """The robot with the pulleys."""
        return Robot.from_toml(self.attached["robot.toml"], "robot.toml")


class NewFolder(_answers.NewFolder):
    """A robot to start from, with a study and a scenario; every line of their files is explained."""

    __slots__ = ()

    def _beside(self) -> dict[str, Robot | str | bytes]:
        return {name.split("/", 1)[1]: content for name, content in self.attached.items()}

    @property
    def example(self) -> Robot:
        """The robot: ``example.to_toml()`` is its file, to be changed."""
        return Robot.from_toml(self.attached["new/robot.toml"], "robot.toml")

    @property
    def study(self) -> StudyFile:
        """The study of the robot."""
        return StudyFile.from_toml(self.attached["new/study.toml"], self._beside())

    @property
    def scenario(self) -> Scenario:
        """The scenario of the robot."""
        return Scenario.from_toml(self.attached["new/scenario.toml"], self._beside())


class Compensation(_answers.Compensation):
    """A map of corrections over the workspace: pass it as ``compensation``."""

    __slots__ = ()

    def _put(self, call: Call) -> str:
        return call.file("map.toml", self.attached["map.toml"])


@dataclass(frozen=True, eq=False)
class Mesh:
    """A surface of triangles."""

    vertices: Array
    """Corners (V, 3) in world coordinates (m)."""
    triangles: npt.NDArray[np.int64]
    """Indices of the corners of each triangle (T, 3), counter-clockwise from outside."""

    @classmethod
    def of_stl(cls, content: bytes) -> Mesh:
        """Returns the surface of a binary STL file."""
        (count,) = struct.unpack_from("<I", content, 80)
        kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        corners = np.frombuffer(content, kind, count, 84)["corners"].reshape(-1, 3).astype(float)
        vertices, places = np.unique(corners, axis=0, return_inverse=True)
        return cls(vertices, places.reshape(-1, 3).astype(np.int64))

    def __repr__(self) -> str:
        return f"<cdpr.Mesh: {len(self.vertices)} corners, {len(self.triangles)} triangles>"


class Workspace(_answers.Workspace):
    """A workspace: its size with a bound of the error, and its surface."""

    __slots__ = ()

    @property
    def size(self) -> float:
        """Area (m²) of a planar robot's workspace, volume (m³) of another's."""
        data = self._data
        return float(data["area_m2"] if "area_m2" in data else data["volume_m3"])

    @property
    def boundary(self) -> Mesh:
        """Surface of the workspace; only with ``mesh=True``."""
        return _mesh(self.attached, "mesh.stl", "mesh")


class Reachable(_answers.Reachable):
    """Workspace that a control model reaches on a machine."""

    __slots__ = ()

    @property
    def boundary(self) -> Mesh:
        """Surface of the commanded poses that are reached; only with ``mesh=True``."""
        return _mesh(self.attached, "mesh.stl", "mesh")

    @property
    def emerging_boundary(self) -> Mesh:
        """Surface of the poses that emerge; only with ``emerging_mesh=True``."""
        return _mesh(self.attached, "emerging.stl", "emerging_mesh")


def _mesh(written: Any, name: str, argument: str) -> Mesh:
    if name not in written:
        raise Error("mesh::not-made", "the surface was not made", f"ask with `{argument}=True`")
    return Mesh.of_stl(written[name])


class Run(_answers.Run):
    """A machine in time."""

    __slots__ = ()

    @property
    def table(self) -> dict[str, Array]:
        """Columns of the log by name, with their units: ``t_s``, ``x_m``, … ``tension_N_1``, …"""
        return _columns(self.attached["result/log.csv"])

    @property
    def sensor_tables(self) -> dict[str, dict[str, Array]]:
        """Columns of the sensors' files by file, e.g. ``measurements.csv``; NaN in empty cells."""
        names = ("measurements.csv", "imu.csv", "tracker.csv")
        return {name: _columns(self.attached[f"result/{name}"]) for name in names if f"result/{name}" in self.attached}

    def to_samples(self, *, merge: bool = False, static: bool = False) -> Samples:
        """Returns the measurements of the machine's sensors, for :func:`cdpr.identify` and others.

        ``merge``: with the poses of the tracker, which has a clock of its own, interpolated at the times of the other sensors. ``static``:
        averages poses that are held. Both as in :meth:`cdpr.Samples.from_csv`.
        """
        if "result/measurements.csv" not in self.attached:
            raise Error("run::no-sensors", "the machine has no sensors", "give the scenario a table `[sensors]`")
        sidecar = self.attached.get("result/measurements.meta.toml")
        options: dict[str, Any] = {}
        if merge:
            if "result/tracker.csv" not in self.attached:
                raise Error("run::no-sensors", "the machine has no tracker", "give the scenario a table `[sensors.tracker]`")
            beside = self.attached.get("result/tracker.meta.toml")
            options["merge"] = Samples("tracker.csv", self.attached["result/tracker.csv"], beside, {})
        if static:
            options["static"] = True
        return Samples("measurements.csv", self.attached["result/measurements.csv"], sidecar, options)

    def to_pandas(self) -> Any:
        """Returns the log as a table."""
        import pandas

        return pandas.DataFrame(self.table)


def _columns(content: bytes) -> dict[str, Array]:
    text = content.decode()
    names = next(csv.reader([text.split("\n", 1)[0]]))
    rows = np.genfromtxt(io.StringIO(text), delimiter=",", skip_header=1, ndmin=2)
    return dict(zip(names, rows.T, strict=True))


class Accuracy(_answers.Accuracy):
    """Errors of a control model on a machine over commanded poses."""

    __slots__ = ()


class Benchmark(_answers.Benchmark):
    """Robots and models under the same rules."""

    __slots__ = ()
    _TABLE = "rows"


class Advice(_answers.Advice):
    """Control models rated for a task."""

    __slots__ = ()
    _TABLE = "candidates"


class Sensitivity(_answers.Sensitivity):
    """Errors that deviating numbers cause."""

    __slots__ = ()
    _TABLE = "parameters"


class Campaign(_answers.Campaign):
    """Rounds of planned measurements."""

    __slots__ = ()
    _TABLE = "rounds"


class SweepResult(_answers.SweepResult):
    """Reachable workspaces over parameters."""

    __slots__ = ()
    _TABLE = "rows"


class CalibrationCosts(_answers.CalibrationCosts):
    """What accuracy costs."""

    __slots__ = ()
    _TABLE = "rows"


class Modes(_answers.Modes):
    """Natural frequencies."""

    __slots__ = ()
    _TABLE = "modes"


def of_command(command: str) -> type[Result] | tuple[type[Result], ...]:
    """Returns the class of a command's result, or its classes."""
    classes = tuple(globals().get(cls.__name__, cls) for cls in _answers.ANSWERS[command])
    return classes[0] if len(classes) == 1 else classes
