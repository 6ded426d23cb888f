"""What tests share: the command, its folder of studies, and a record of measurements."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import tempfile
from functools import lru_cache
from pathlib import Path
from typing import Any

import cdpr

ROOT = Path(__file__).resolve().parents[2]
STUDIES = ROOT / "studies"


def command() -> str:
    """Returns the path of the command: of CDPR in the environment, or the one of this environment."""
    found = os.environ.get("CDPR") or shutil.which("cdpr")
    assert found, "neither CDPR nor the command `cdpr` is there"
    return found


def asked(line: list[str], folder: Path | str) -> tuple[int, dict[str, Any]]:
    """Returns exit code and JSON of a command line that runs in a folder."""
    run = subprocess.run([command(), *line, "--format=json", "--quiet"], cwd=folder, capture_output=True, check=False)
    return run.returncode, json.loads(run.stdout)


@lru_cache(maxsize=1)
def demo() -> Path:
    """Returns the folder of ``cdpr demo``, which is kept as long as the process."""
    folder = Path(tempfile.mkdtemp(prefix="cdpr-demo-"))
    subprocess.run([command(), "demo", "--out", folder, "--quiet"], check=True, capture_output=True)
    return folder


def training() -> cdpr.Samples:
    """Returns the measurements of the demo."""
    return cdpr.Samples.from_csv(demo() / "training.csv")


def study(tables: dict[str, Any] | None = None) -> cdpr.Study:
    """Returns a small study of a planar robot, whose cables stretch on the machine."""
    robot = cdpr.Robot("planar-example")
    return cdpr.Study.of(
        cdpr.Model(robot, "standard"),
        cdpr.Model(robot, "elastic"),
        initial_pose=[0.0, 5.2, 0.0][: robot.dof],
        limits=(100.0, 10000.0),
        grid=([-1.0, 4.0, 0.0][: robot.dof], [1.0, 6.0, 0.0][: robot.dof], [3, 3, 1][: robot.dof]),
        noise=cdpr.Sigmas(position=0.001, length=0.0005),
        tables=tables,
    )
