"""Every question: what Python answers is the JSON of the command, and its attributes are its keys."""

from __future__ import annotations

import math
import shlex
import tempfile
import unittest
from pathlib import Path
from typing import Any, Callable

import cdpr
from support import STUDIES, asked, demo, study, training

POSES = "0.5,4"


def without_times(answer: Any) -> Any:
    """Returns an answer without what differs from run to run."""
    if isinstance(answer, dict):
        return {key: without_times(value) for key, value in answer.items() if key != "timing"}
    return [without_times(value) for value in answer] if isinstance(answer, list) else answer


def poseless() -> cdpr.Samples:
    """Returns the lengths of the demo without their poses."""
    table = training().to_pandas()
    return cdpr.Samples.from_pandas(
        table[[name for name in table.columns if name.startswith("cable_length")]], sigmas=cdpr.Sigmas(length=2e-3)
    )


def scenario() -> cdpr.Scenario:
    """Returns a short motion of a robot with sensors."""
    robot = cdpr.Robot("cablerobot-simulator-helicopter-elastostatic-calibrated")
    body = "center_of_mass_m = [0.0, 0.0, 0.1]\ninertia_about_center_of_mass_kg_m2 = [[117.0, 0.0, 0.0], [0.0, 121.0, 0.0], [0.0, 0.0, 62.5]]\n"
    robot = cdpr.Robot.from_toml(robot.to_toml().replace("[platform]\n", "[platform]\n" + body, 1))
    return cdpr.Scenario.of(
        cdpr.Model(robot, "elastic"), pose=[0, 0, 1.5, 0, 0, 0], duration=0.05, displacement=[0.01, 0, 0, 0, 0, 0]
    )


def bench_record() -> Path:
    """Returns a record of a cable on a test bench."""
    folder = Path(tempfile.mkdtemp(prefix="cdpr-bench-"))
    # two cycles, with a branch a tenth lower on the way back
    strokes = [(up if side else 40 - up, side) for side in (1, 0, 1, 0) for up in range(41)]
    rows = [f"{1e-4 * way},{20.0 * way * (1.0 if loads else 0.9 + 0.0025 * way)}" for way, loads in strokes]
    (folder / "record.csv").write_text("elongation_m,tension_N\n" + "\n".join(rows) + "\n")
    return folder / "record.csv"


def response_record() -> Path:
    """Returns a record of a lag of 20 ms under a sum of sines."""
    folder = Path(tempfile.mkdtemp(prefix="cdpr-response-"))
    frequencies = [0.5 * k for k in range(1, 51)]
    rows = []
    for row in range(4000):
        time = 0.005 * row
        turned = [(2 * math.pi * f, 2 * math.pi * f * time + 0.7 * k * k) for k, f in enumerate(frequencies)]
        told = sum(math.cos(angle) for _, angle in turned)
        # of a lag at each frequency: smaller by its gain and later by its phase
        said = sum(math.cos(angle - math.atan(0.02 * w)) / math.hypot(1, 0.02 * w) for w, angle in turned)
        rows.append(f"{time:.3f},{told},{5 * said + 1000 + 0.1 * (row * 7919 % 101 - 50)}")
    (folder / "record.csv").write_text("t_s,motor_torque_Nm,tension_N\n" + "\n".join(rows) + "\n")
    return folder / "record.csv"


def winch_record() -> Path:
    """Returns plateaus of a winch that lifts and lowers two loads."""
    folder = Path(tempfile.mkdtemp(prefix="cdpr-winch-"))
    rows = [
        f"{way * speed},{load + way * (0.04 + 0.05 * load + 8e-4 * speed) + 1e-4 * (speed % 3)},{load}"
        for load in (0.2, 1.0)
        for speed in (3.0, 7.0, 14.0, 25.0)
        for way in (1, -1)
    ]
    (folder / "winch.csv").write_text("motor_speed_rad_per_s,motor_torque_Nm,load_Nm\n" + "\n".join(rows) + "\n")
    return folder / "winch.csv"


PLANAR = "planar-example"
HANGING = "suspended-camera"

CALLS: dict[str, Callable[[], Any]] = {
    "check": lambda: cdpr.check(PLANAR),
    "place_pulleys": lambda: cdpr.place_pulleys("cablerobot-simulator-helicopter", axes=["0,0,1"], radius=0.05),
    "ik": lambda: cdpr.ik(PLANAR, pose=[0.5, 4]),
    "fk": lambda: cdpr.fk(PLANAR, lengths=[6.6, 5.7, 7.2, 6.2]),
    "tension": lambda: cdpr.tension(PLANAR, pose=POSES, min=100.0, max=9000.0),
    "load": lambda: cdpr.load(PLANAR, pose=[0.5, 4], tensions=[1000, 900, 800, 1000]),
    "stiffness": lambda: cdpr.stiffness(cdpr.Model(PLANAR, "elastic"), pose=[0.5, 4]),
    "dynamics": lambda: cdpr.dynamics(_moving(), pose=[0, 0, 1.5, 0, 0, 0], acceleration=[0, 0, 1, 0, 0, 0]),
    "modes": lambda: cdpr.modes(_moving(), pose=[0, 0, 1.5, 0, 0, 0]),
    "model": lambda: cdpr.model(PLANAR, pose=[0.5, 4]),
    "workspace": lambda: cdpr.workspace(PLANAR, step=0.5, mesh=True),
    "capability": lambda: cdpr.capability(PLANAR, box=[-0.5, 0.5, 4.5, 5.5]),
    "reachable": lambda: cdpr.reachable(study(), step=0.8),
    "advise": lambda: cdpr.advise(PLANAR, task=[-0.5, 0.5, 4.5, 5.5], accuracy=0.01, count=20),
    "accuracy": lambda: cdpr.accuracy(study()),
    "study": lambda: cdpr.study(study()),
    "sensitivity": lambda: cdpr.sensitivity(study({"tolerances": {"accuracy_m": 0.01, "machine": {"frame_anchor_m": 0.001}}}), robots=20),
    "initial_tension": lambda: cdpr.initial_tension(study()),
    "benchmark": lambda: cdpr.benchmark(robots=[PLANAR], models=["standard"]),
    "chain": lambda: cdpr.chain(STUDIES / "planar-low-grid.toml"),
    "demo": lambda: cdpr.demo(candidates="standard;standard:length-offset"),
    "plan": lambda: cdpr.plan(PLANAR, free="frame-anchor", count=6, study=study()),
    "simulate": lambda: cdpr.simulate(study(), seed=3),
    "identify": lambda: cdpr.identify(demo() / "robot.toml", training(), free="length-offset"),
    "select": lambda: cdpr.select(
        demo() / "robot.toml", training(), candidates="standard;standard:length-offset", split="kfold:3", seed=2
    ),
    "evaluate": lambda: cdpr.evaluate(demo() / "robot.toml", training(), model="elastic"),
    "compensate": lambda: cdpr.compensate(demo() / "robot.toml", training()),
    "campaign": lambda: cdpr.campaign(study({"campaign": {"free": "frame-anchor", "rounds": 2, "poses_per_round": 6}})),
    "test_bench": lambda: cdpr.test_bench(bench_record(), length=2.0),
    "frequency_response": lambda: cdpr.frequency_response(response_record()),
    "friction": lambda: cdpr.friction([winch_record()]),
    "run": lambda: cdpr.run(scenario()),
}


def _moving() -> cdpr.Model:
    return cdpr.Model(cdpr.Robot.from_toml(scenario()._files["machine.toml"]), "elastic")


class Layer(unittest.TestCase):
    """The whole layer: each question once."""

    def test_every_question_is_asked_here(self) -> None:
        from cdpr._questions import __all__ as questions

        self.assertEqual(set(CALLS), set(questions))

    def test_answers_are_the_json_of_the_command(self) -> None:
        for name, call in CALLS.items():
            with self.subTest(name):
                self.compare(call())
        self.compare(cdpr.self_calibrate(demo() / "robot.toml", poseless(), free="length-offset"))

    def compare(self, result: cdpr.Result) -> None:
        """Runs the command line of a result in a folder with its files, and compares."""
        with tempfile.TemporaryDirectory() as folder:
            for path, content in result._given.items():
                file = Path(folder) / path
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(content)
            exit_code, expected = asked(shlex.split(result.command_line)[1:], folder)
            self.assertLess(exit_code, 2, expected)
            self.assertEqual(without_times(result.to_dict()), without_times(expected))
            for path, content in result.attached.items():
                if path.endswith((".toml", ".csv", ".stl")):
                    self.assertEqual((Path(folder) / path).read_bytes(), content, path)
        keys = {key for _, key, _ in result._KEYS}
        self.assertLessEqual(set(result.to_dict()), keys)
        for attribute, _, is_always in result._KEYS:
            self.assertTrue(hasattr(result, attribute) or not is_always, attribute)
        self.assertLess(len(repr(result)), 400)
        self.assertIn("<", result._repr_html_())


class Results(unittest.TestCase):
    def test_a_choice_gives_its_robot_its_page_and_its_table(self) -> None:
        choice = CALLS["select"]()
        best = choice.best
        self.assertEqual(best.name, choice.to_dict()["best"])
        self.assertEqual(best.to_model().robot, best.calibrated)
        self.assertEqual(list(choice.to_pandas()["name"]), [own.name for own in choice.candidates])
        self.assertIn("validation.position_error_m.mean", choice.to_pandas().columns)
        self.assertNotIn(b"http://", choice.html.encode().replace(b"http://www.w3.org", b""))
        self.assertTrue(choice._repr_html_().startswith("<iframe srcdoc="))
        with tempfile.TemporaryDirectory() as folder:
            choice.save(folder)
            self.assertTrue((Path(folder) / "result" / "report.html").is_file())

    def test_surfaces_are_arrays(self) -> None:
        surface = cdpr.workspace("cablerobot-simulator-helicopter", step=1.0, mesh=True).boundary
        self.assertIn("<title>", cdpr.workspace("planar-example", step=1.0).html)
        self.assertEqual((surface.vertices.shape[1], surface.triangles.shape[1]), (3, 3))
        self.assertLess(surface.triangles.max(), len(surface.vertices))

    def test_templates_are_robots_to_start_from(self) -> None:
        for name in ("suspended-camera", "wall-plotter", "planar-frame", "box"):
            made = cdpr.new(name)
            self.assertEqual(cdpr.check(made.example).status, "checked", name)
            self.assertEqual(cdpr.accuracy(made.study).robot, made.example.name)
        self.assertEqual(cdpr.run(cdpr.new("box").scenario).status, "completed")

    def test_measurements_of_a_machine_identify_it(self) -> None:
        made = cdpr.simulate(study(), seed=1).table
        found = cdpr.identify(cdpr.Model("planar-example", "elastic"), made, free="length-offset")
        self.assertEqual(found.status, found.to_dict()["status"])
        self.assertIsInstance(found.calibrated, cdpr.Robot)

    def test_a_map_is_an_argument(self) -> None:
        correction = CALLS["compensate"]()
        rated = cdpr.evaluate(demo() / "robot.toml", training(), compensation=correction)
        self.assertTrue(rated.compensation)


class Mistakes(unittest.TestCase):
    def test_a_file_at_fault_is_named_with_its_line(self) -> None:
        robot = "layout_version = 1\nname = \"x\"\nmotion_patern = \"2T\"\n"
        with self.assertRaises(cdpr.ReadError) as caught:
            cdpr.Robot.from_toml(robot, "mine.toml")
        error = caught.exception
        self.assertEqual((error.place.file, error.place.line), ("mine.toml", 3))
        self.assertTrue(str(error).startswith("mine.toml:3:"))
        self.assertIsInstance(error, ValueError)
        text = training().to_csv().replace("0.9", "zero", 1)
        samples = cdpr.Samples("mine.csv", text.encode(), None, {})
        with self.assertRaises(cdpr.ReadError) as caught:
            cdpr.identify(demo() / "robot.toml", samples, free="length-offset")
        self.assertEqual(caught.exception.place.file, "mine.csv")
        self.assertEqual(caught.exception.code, "csv::not-a-number")

    def test_options_are_called_as_arguments(self) -> None:
        with self.assertRaises(cdpr.Error) as caught:
            cdpr.identify(demo() / "robot.toml", training(), free="no-such-parameter")
        self.assertIn("free=", str(caught.exception))
        self.assertNotIn("--free", str(caught.exception))
        self.assertIn("Causes:", cdpr.explain(caught.exception.code))

    def test_what_was_meant_is_asked(self) -> None:
        for call, words in (
            (lambda: cdpr.Robot("cogir"), "did you mean `cogiro`?"),
            (lambda: cdpr.Robot(PLANAR)["frame-anchor[1].X"], "did you mean `frame-anchor[1]."),
            (lambda: cdpr.ik(PLANAR, pose=[0.5, 4]).lengths, "did you mean `cable_lengths`?"),
            (lambda: cdpr.workspace(PLANAR, bounds=[-1, 1]), "`bounds=`: expected"),
            (lambda: cdpr.stiffness(PLANAR, pose=[0.5, 4], model="standard"), 'use `model="elastic"`'),
            (lambda: cdpr.Samples.from_csv("nowhere.csv"), "nowhere.csv: cannot be read"),
            (lambda: cdpr.Robot("nowhere.toml"), "nowhere.toml: cannot be read"),
        ):
            with self.subTest(words), self.assertRaises((cdpr.Error, KeyError, AttributeError)) as caught:
                call()
            self.assertIn(words, str(caught.exception))

    def test_a_no_is_an_answer(self) -> None:
        answer = cdpr.tension("planar-example", pose=[20.0, 20.0])
        self.assertEqual((answer.status, answer.tensions), ("infeasible", None))
        self.assertTrue(answer.reason)


if __name__ == "__main__":
    unittest.main()
