"""Answers of the command as classes. `CDPR` in the environment is the path of the command."""

import copy
import json
import os
import pickle
import subprocess
import tempfile
import unittest
from pathlib import Path

from cdpr import _answers, _result

STUDY = """
[control]
robot = "planar-example"
model = "elastic"
[machine]
robot = "planar-example"
[initial]
pose = [0, 5.2]
offset = "none"
[poses.grid]
min = [-1, 4]
max = [1, 6]
count = [4, 4]
[noise]
position_m = 0.001
length_m = 0.0005
"""

SELECT = "select planar-example data.csv --candidates standard --out result"
COMMANDS = [
    "robots",
    "robots cogiro",
    "new",
    "check planar-example",
    "ik planar-example --pose 0,5",
    "ik planar-example --pose 0,5 --hanging",
    "fk planar-example --lengths 6.6,5.7,7.2,6.2",
    "tension planar-example --pose 0,5.2",
    "tension planar-example --pose 0,5.2 --wrench 0,-60000",
    "stiffness planar-example --model elastic --pose 0,5.2",
    "workspace planar-example --step 1",
    "capability planar-example --box=-1,1,3,5",
    "model planar-example --pose 0,5.2",
    "simulate study.toml --out data.csv",
    "plan planar-example --free length-offset --count 3 --candidates data.csv --out planned.csv",
    "identify planar-example data.csv --free length-offset",
    "evaluate planar-example data.csv",
    SELECT,
    "accuracy study.toml",
    "study study.toml --out studied",
    "check nowhere.toml",
]


def parts(value):
    """Yields all results in a value."""
    if isinstance(value, _result.Result):
        yield value
        for name, _, _ in value._KEYS:
            yield from parts(getattr(value, name))
    elif isinstance(value, tuple):
        for one in value:
            yield from parts(one)


@unittest.skipUnless("CDPR" in os.environ, "CDPR is the path of the command")
class Answers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.answers = {}
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "study.toml").write_text(STUDY)
            for words in COMMANDS:
                command = [os.environ["CDPR"], *words.split(), "--format", "json"]
                run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
                data = json.loads(run.stdout)
                name = "error" if data["status"] == "error" else words.split()[0]
                cls.answers[words] = (run.stdout, _result.Result._class_for(_answers.ANSWERS[name], data)._of(data))

    def each(self):
        for words, (text, answer) in self.answers.items():
            with self.subTest(words):
                yield text, answer

    def test_every_key_is_an_attribute(self):
        for _, answer in self.each():
            for part in parts(answer):
                known = {key for _, key, _ in part._KEYS}
                self.assertLessEqual(part._data.keys(), known, type(part).__name__)
                for name, key, _ in part._KEYS:
                    value, raw = getattr(part, name), part._data.get(key)
                    if not isinstance(raw, (dict, list)):
                        self.assertEqual(value, raw)

    def test_the_forms_of_an_answer_are_told_apart(self):
        names = {words: type(answer).__name__ for words, (_, answer) in self.answers.items()}
        self.assertEqual(names["robots"], "RobotList")
        self.assertEqual(names["robots cogiro"], "RobotFile")
        self.assertEqual(names["check nowhere.toml"], "Failure")
        self.assertEqual(names[SELECT], "Selection")

    def test_the_object_is_that_of_the_command(self):
        for text, answer in self.each():
            self.assertEqual(answer.to_dict(), json.loads(text))
            self.assertEqual(json.loads(answer.to_json()), json.loads(text))
            answer.to_dict().clear()
            self.assertEqual(answer.to_dict(), json.loads(text))

    def test_a_line_shows_a_result(self):
        for _, answer in self.each():
            for part in parts(answer):
                self.assertLess(len(repr(part)), 320)
                self.assertNotIn("\n", repr(part))
            self.assertIn(f"(status='{answer.status}'", repr(answer))

    def test_copies_are_equal_and_others_are_not(self):
        answers = [answer for _, answer in self.answers.values()]
        for _, answer in self.each():
            for other in [pickle.loads(pickle.dumps(answer)), copy.copy(answer), copy.deepcopy(answer)]:
                self.assertEqual(other, answer)
                self.assertEqual(hash(other), hash(answer))
            self.assertEqual(sum(other == answer for other in answers), 1)

    def test_nothing_can_be_changed(self):
        for _, answer in self.each():
            for name in ["status", "_data", "new"]:
                with self.assertRaises(AttributeError):
                    setattr(answer, name, 1)
                with self.assertRaises(AttributeError):
                    delattr(answer, name)
            with self.assertRaises(TypeError):
                type(answer)()

    def test_keys_of_other_versions_stay(self):
        _, answer = next(iter(self.answers.values()))
        newer = type(answer)._of({**answer.to_dict(), "colour": "red"})
        self.assertEqual(newer.to_dict()["colour"], "red")
        self.assertNotEqual(newer, answer)
        older = type(answer)._of({})
        with self.assertRaisesRegex(AttributeError, "status"):
            older.status

    def test_rows_become_a_table(self):
        _, answer = self.answers[SELECT]
        try:
            table = _result.frame_of(answer.candidates)
        except ImportError as error:
            self.skipTest(str(error))
        self.assertEqual(list(table["name"]), [candidate.name for candidate in answer.candidates])
        self.assertIn("validation.position_error_m.mean", table.columns)


if __name__ == "__main__":
    unittest.main()
