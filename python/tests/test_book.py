"""Lines of Python in the book and on the pages at the root run as they stand."""

from __future__ import annotations

import contextlib
import importlib.util
import io
import os
import re
import shutil
import subprocess
import tempfile
import types
import unittest
from functools import lru_cache
from pathlib import Path

from support import ROOT, STUDIES, command, demo
from test_answers import winch_record

BOOK = ROOT / "docs" / "book" / "src"
FENCE = re.compile(r"^```python\n(.*?)^```$", re.DOTALL | re.MULTILINE)
"""Blocks that run; those of `python,recipe` need programs of their own, see test_recipes.py."""


def blocks(page: Path) -> list[tuple[int, str]]:
    """Returns the blocks of Python on a page with the numbers of their first lines."""
    text = page.read_text(encoding="utf-8")
    return [(text.count("\n", 0, found.start(1)) + 1, found[1]) for found in FENCE.finditer(text)]


@lru_cache(maxsize=1)
def files() -> Path:
    """Returns a folder with what the pages use: the studies, a robot and its measurements."""
    folder = Path(tempfile.mkdtemp(prefix="cdpr-book-"))
    shutil.copytree(STUDIES, folder / "studies")
    shutil.copy(demo() / "robot.toml", folder / "robot.toml")
    for name in ("samples", "measurements"):
        shutil.copy(demo() / "training.csv", folder / f"{name}.csv")
        shutil.copy(demo() / "training.meta.toml", folder / f"{name}.meta.toml")
    shutil.copy(winch_record(), folder)
    subprocess.run([command(), "new", "suspended-camera", "--out", folder / "my-robot"], check=True, capture_output=True)
    return folder


def run(page: Path, folder: Path) -> None:
    """Runs the blocks of a page in one namespace and a folder; what they print is swallowed."""
    module = types.ModuleType("page")
    before = os.getcwd()
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            for line, text in blocks(page):
                try:
                    exec(compile("\n" * (line - 1) + text, str(page), "exec"), module.__dict__)
                except Exception as error:
                    at = error.__traceback__.tb_next.tb_lineno if error.__traceback__ and error.__traceback__.tb_next else line
                    raise AssertionError(f"{page.name}:{at}: {type(error).__name__}: {error}") from error
    finally:
        os.chdir(before)


class Pages(unittest.TestCase):
    def setUp(self) -> None:
        if importlib.util.find_spec("pandas") is None:
            if os.environ.get("CI") == "true":
                self.fail("CI must run the book's lines: pandas is not there")
            self.skipTest("pandas is not there")

    def test_pages_of_the_book(self) -> None:
        pages = [page for page in sorted(BOOK.glob("*.md")) if blocks(page)]
        self.assertGreaterEqual(len(pages), 9)
        for page in pages:
            with self.subTest(page.name):
                self.page(page)

    def test_pages_at_the_root(self) -> None:
        same = [[text for _, text in blocks(ROOT / name)] for name in ("README.md", "python/README.md")]
        self.assertTrue(same[0])
        self.assertEqual(*same)
        self.page(ROOT / "README.md")

    def page(self, page: Path) -> None:
        with tempfile.TemporaryDirectory(prefix="cdpr-page-") as folder:
            place = Path(folder) / "here"
            shutil.copytree(files(), place)
            run(page, place)


if __name__ == "__main__":
    unittest.main()
