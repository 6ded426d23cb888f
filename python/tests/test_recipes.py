"""Recipes of the book's page about many machines, run with the real programs where they are: with CDPR_ALL=1."""

from __future__ import annotations

import hashlib
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import cdpr
from one_node import one_node
from support import STUDIES, command
from test_book import BOOK

SWEEP = "studies/sweep-planar-tension.toml"
PAGE = BOOK / "scale-out.md"
BLOCK = re.compile(r"^```(sh|python,recipe)\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def recipes(heading: str) -> list[str]:
    """Returns the blocks below a heading of the page."""
    section = PAGE.read_text(encoding="utf-8").split(f"\n## {heading}\n", 1)[1].split("\n## ", 1)[0]
    return [found[2] for found in BLOCK.finditer(section)]


@unittest.skipUnless(os.environ.get("CDPR_ALL"), "recipes start other programs: with CDPR_ALL=1")
class Recipes(unittest.TestCase):
    expected: str

    @classmethod
    def setUpClass(cls) -> None:
        with tempfile.TemporaryDirectory() as folder:
            words = [command(), "sweep", "all", STUDIES / Path(SWEEP).name, "--out", "tension", "--quiet"]
            subprocess.run(words, cwd=folder, check=True, capture_output=True)
            cls.expected = cls.digest(Path(folder))

    @staticmethod
    def digest(folder: Path) -> str:
        """Returns the hash of a result."""
        return hashlib.sha256((folder / "tension" / "result.json").read_bytes()).hexdigest()

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory(prefix="cdpr-recipe-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        shutil.copytree(STUDIES, self.folder / "studies")
        programs = self.folder / "programs"
        programs.mkdir()
        (programs / "cdpr").symlink_to(Path(command()).resolve())
        package = str(Path(cdpr.__file__).resolve().parents[1])
        self.surroundings = {
            **os.environ,
            "PATH": f"{programs}{os.pathsep}{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
            "PYTHONPATH": os.pathsep.join([package, os.environ.get("PYTHONPATH", "")]),
            "HOME": str(self.folder),
        }

    def sh(self, script: str, **more: str) -> str:
        """Runs lines of a shell in the folder, and returns what they print."""
        return self.started(["sh", "-e", "-c", script], **more)

    def started(self, words: list[str], **more: str) -> str:
        run = subprocess.run(
            words, cwd=self.folder, env={**self.surroundings, **more}, capture_output=True, text=True, timeout=300, check=False
        )
        self.assertEqual(run.returncode, 0, f"{words}\n{run.stdout}{run.stderr}")
        return run.stdout

    def planned(self) -> None:
        """Plans as the page says, before its recipes."""
        found = BLOCK.search(PAGE.read_text(encoding="utf-8"))
        assert found
        self.sh(found[2])

    def needs(self, program: str) -> None:
        if shutil.which(program, path=self.surroundings["PATH"]) is None:
            self.skipTest(f"{program} is not there")

    def needs_module(self, name: str) -> None:
        if importlib.util.find_spec(name) is None:
            self.skipTest(f"{name} is not there")

    def test_gnu_parallel(self) -> None:
        self.needs("parallel")
        self.planned()
        (script,) = recipes("GNU parallel")
        self.sh(script)
        self.assertEqual(self.digest(self.folder), self.expected)

    def test_slurm(self) -> None:
        with tempfile.TemporaryDirectory(prefix="cdpr-slurm-") as folder, one_node(Path(folder)) as settings:
            if settings is None:
                self.skipTest("no Slurm can start here: Debian's slurm-wlm and munge, as root")
            self.planned()
            (script,) = recipes("Slurm")
            self.sh(script, SLURM_CONF=settings)
        self.assertEqual(self.digest(self.folder), self.expected)

    def test_the_script_of_slurm_without_it(self) -> None:
        self.planned()
        script = recipes("Slurm")[0].split("<<'END'\n", 1)[1].split("END\n", 1)[0]
        count = re.search(r"--array=1-(\d+)", script)
        assert count
        for task in range(1, int(count[1]) + 1):
            self.sh(script, SLURM_ARRAY_TASK_ID=str(task), SLURM_ARRAY_TASK_COUNT=count[1])
        self.sh("cdpr sweep merge tension")
        self.assertEqual(self.digest(self.folder), self.expected)

    def test_questions_in_parts(self) -> None:
        (script,) = recipes("Questions in parts")
        whole = "cdpr benchmark --robots planar-example,cogiro"
        self.assertIn(whole.removeprefix("cdpr "), script)
        self.assertTrue(self.sh(script).endswith(self.sh(whole)))

    def test_snakemake(self) -> None:
        self.needs("snakemake")
        (text,) = recipes("Snakemake")
        (self.folder / "Snakefile").write_text(text)
        self.started(["snakemake", "--cores", "2", "--quiet", "all"])
        self.assertEqual(self.digest(self.folder), self.expected)

    def test_joblib(self) -> None:
        self.needs_module("joblib")
        (text,) = recipes("joblib")
        self.python(text)

    def test_dask(self) -> None:
        self.needs_module("distributed")
        self.python(recipes("Dask")[0])

    def test_the_job_of_dask_jobqueue(self) -> None:
        self.needs_module("dask_jobqueue")
        # no batch system is asked: the job is made, not submitted
        (line,) = [line for line in recipes("Dask")[1].splitlines() if line.startswith("cluster = ")]
        text = f"from dask_jobqueue import SLURMCluster\n{line}\nprint(cluster.job_script())\ncluster.close()\n"
        self.started([sys.executable, "-c", text])

    def python(self, text: str) -> None:
        """Runs a recipe of Python whose `result` is that of the sweep."""
        lines = [*text.splitlines(), "if __name__ == '__main__':", "    result.save('.')"]
        (self.folder / "recipe.py").write_text("\n".join(lines) + "\n")
        self.started([sys.executable, "recipe.py"])
        # the folder is called `sweep` in memory
        found = (self.folder / "sweep" / "result.json").read_bytes().replace(b'"sweep/', b'"tension/').replace(b'"sweep"', b'"tension"')
        self.assertEqual(hashlib.sha256(found).hexdigest(), self.expected)


if __name__ == "__main__":
    unittest.main()
