"""Notebooks: their cells run from top to bottom, in a folder of their own with the data beside them."""

from __future__ import annotations

import contextlib
import importlib.util
import io
import json
import os
import shutil
import sys
import tempfile
import types
import unittest
import warnings
from pathlib import Path
from typing import Any

NOTEBOOKS = Path(__file__).resolve().parents[1] / "notebooks"
EXTRAS = {
    "own-robot-and-workspace": "matplotlib",
    "plant-with-your-own-controller": "matplotlib",
    "sweep-and-tolerance-on-dask": "distributed",
}
"""Packages without which a notebook leaves out a part of itself."""
IN_CI = os.environ.get("CI") == "true"


def code_cells(notebook: Path) -> list[tuple[str, str]]:
    """Returns name and text of the code cells."""
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return [(cell["id"], "".join(cell["source"])) for cell in cells if cell["cell_type"] == "code"]


def run(cells: list[tuple[str, str]], folder: Path) -> dict[str, Any]:
    """Runs code cells in one namespace and a folder, and returns the namespace; what they print is swallowed."""
    # a module of that name: what cells define is pickled by value, since nobody can import it
    module = types.ModuleType("cells")
    before = os.getcwd()
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings():
            warnings.simplefilter("ignore", ResourceWarning)
            for name, text in cells:
                try:
                    exec(compile(text, name, "exec"), module.__dict__)
                except Exception as error:
                    raise AssertionError(f"{name}: {type(error).__name__}: {error}\n{text}") from error
    finally:
        os.chdir(before)
    return module.__dict__


class Notebooks(unittest.TestCase):
    def setUp(self) -> None:
        os.environ.setdefault("MPLBACKEND", "Agg")

    def test_notebooks_hold_no_outputs_and_no_commands_of_a_shell(self) -> None:
        notebooks = sorted(NOTEBOOKS.glob("*.ipynb"))
        self.assertEqual(len(notebooks), 5)
        for notebook in notebooks:
            content = json.loads(notebook.read_text(encoding="utf-8"))
            self.assertEqual(content["nbformat"], 4)
            names = [cell["id"] for cell in content["cells"]]
            self.assertEqual(len(set(names)), len(names))
            for cell in content["cells"]:
                if cell["cell_type"] == "code":
                    self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), notebook.name)
                    self.assertFalse([line for line in cell["source"] if line.startswith(("!", "%"))], notebook.name)

    def test_own_robot_and_workspace(self) -> None:
        seen = self.all_cells("own-robot-and-workspace")
        self.assertGreater(seen["space"].size, 400.0)

    def test_calibrate_real_data(self) -> None:
        seen = self.all_cells("calibrate-real-data")
        self.assertLess(seen["fits"]["b"].train.position_error.mean, 0.003)
        self.assertEqual([finding.kind for finding in seen["first"].findings], ["step"])

    def test_is_the_simple_model_enough(self) -> None:
        seen = self.all_cells("is-the-simple-model-enough")
        self.assertLess(seen["better"].mean, 0.1 * seen["errors"].position_error.mean)

    def test_sweep_and_tolerance_on_dask(self) -> None:
        seen = self.all_cells("sweep-and-tolerance-on-dask")
        self.assertEqual(seen["again"].to_json(), seen["result"].to_json())
        self.assertEqual(seen["answers"][0], seen["alone"])

    def test_plant_with_your_own_controller(self) -> None:
        seen = self.all_cells("plant-with-your-own-controller")
        found = seen["found"][seen["found"].index.str.startswith("frame")]
        self.assertLess((found["change"] - found["true"]).abs().max(), 0.005)

    def all_cells(self, name: str) -> dict[str, Any]:
        """Runs a notebook in a temporary folder, into which the notebooks' folder is copied."""
        extra = EXTRAS.get(name)
        if extra is not None and importlib.util.find_spec(extra) is None:
            if IN_CI:
                self.fail(f"CI must run all of {name}: {extra} is not there")
            print(f"{name} runs without {extra}, which is not there", file=sys.stderr)
        if importlib.util.find_spec("pandas") is None and not IN_CI:
            self.skipTest("pandas is not there")
        with tempfile.TemporaryDirectory(prefix="cdpr-notebook-") as folder:
            place = Path(folder) / "notebooks"
            shutil.copytree(NOTEBOOKS, place)
            return run(code_cells(place / f"{name}.ipynb"), place)


if __name__ == "__main__":
    unittest.main()
