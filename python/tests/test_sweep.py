"""Sweeps: rows computed anywhere are the bytes of one process; workers that die and points that cannot be computed."""

import concurrent.futures
import hashlib
import json
import logging
import os
import pickle
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import cdpr
from support import STUDIES, command, study

SWEEP = STUDIES / "sweep-planar-tension.toml"


def poison(plan: bytes, point: int) -> bytes:
    """Kills the process at one point, and fails at another."""
    if point == 3:
        os.kill(os.getpid(), signal.SIGKILL)
    if point == 5:
        raise ArithmeticError("five")
    return cdpr.sweep.row(plan, point)


def slow(plan: bytes, point: int) -> bytes:
    """Takes its time, so that a worker can be killed at work."""
    time.sleep(0.2)
    return cdpr.sweep.row(plan, point)


class Rows(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.TemporaryDirectory()
        cls.whole = Path(cls.folder.name) / "whole"
        subprocess.run([command(), "sweep", "all", SWEEP, "--out", cls.whole, "--quiet"], check=True, capture_output=True)
        cls.plan = cdpr.sweep.plan(SWEEP)

    @classmethod
    def tearDownClass(cls) -> None:
        cls.folder.cleanup()

    def files(self, result: cdpr.Result) -> None:
        """Compares the files of a result with those of the command."""
        for name in ("result.json", "result.csv", "result.svg"):
            self.assertEqual(result.attached[f"sweep/{name}"], self.at(name), name)

    def at(self, name: str) -> bytes:
        # the name of the folder is in result.json
        return (self.whole / name).read_bytes().replace(str(self.whole).encode(), b"sweep")

    def test_rows_in_any_order_and_process_merge_to_the_same_bytes(self) -> None:
        self.assertEqual(self.plan.data, (self.whole / "plan.json").read_bytes())
        self.assertEqual(pickle.loads(pickle.dumps(self.plan)), self.plan)
        self.assertEqual(self.plan, cdpr.sweep.Plan.from_folder(self.whole))
        points = list(reversed(range(len(self.plan))))
        with concurrent.futures.ProcessPoolExecutor(2, mp_context=__import__("multiprocessing").get_context("spawn")) as pool:
            rows = list(pool.map(cdpr.sweep.row, [self.plan.data] * len(points), points, chunksize=4))
        for point, row in zip(points, rows):
            self.assertEqual((self.whole / "rows" / self.plan.row_name(point)).read_bytes(), row)
        self.files(cdpr.sweep.merge(self.plan, rows))

    def test_a_sweep_in_threads_goes_on_in_its_folder(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            half = {point: cdpr.sweep.row(self.plan.data, point) for point in range(0, len(self.plan), 2)}
            for point, row in half.items():
                cdpr.sweep.kept(self.plan, folder)
                cdpr.sweep.keep(self.plan, folder, point, row)
            asked: list[int] = []

            def counted(plan: bytes, point: int) -> bytes:
                asked.append(point)
                return cdpr.sweep.row(plan, point)

            self.files(cdpr.sweep.run(SWEEP, folder=folder, workers=2, compute=counted))
            self.assertFalse(set(asked) & set(half))
            self.files(cdpr.sweep.merge(self.plan, folder=folder))

    def test_the_command_computes_points_by_number_and_names_their_rows(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            line = [command(), "sweep", "plan", SWEEP, "--out", folder, "--format", "json"]
            names = json.loads(subprocess.run(line, check=True, capture_output=True).stdout)["row_files"]
            self.assertEqual(names, [self.plan.row_name(point) for point in range(len(self.plan))])
            subprocess.run([command(), "sweep", "run", folder, "--points", "3,7,11"], check=True, capture_output=True)
            self.assertEqual(sorted(os.listdir(Path(folder) / "rows")), sorted(names[point] for point in (3, 7, 11)))
            wrong = subprocess.run([command(), "sweep", "run", folder, "--points", "999"], capture_output=True, check=False)
            self.assertEqual(wrong.returncode, 2)

    def test_a_sweep_of_a_study_made_here(self) -> None:
        keys = {"machine.axial-stiffness": {"from": 1e5, "to": 1e6, "count": 3}, "control.frame-anchor[1].x": [-6.1, -6.0]}
        sweep = cdpr.Sweep.of(study(), keys, bounds=[-2, 2, 3, 7], step=0.5)
        plan = cdpr.sweep.plan(sweep)
        self.assertEqual(plan.points.shape, (6, 2))
        result = cdpr.sweep.run(plan)
        with tempfile.TemporaryDirectory() as folder:
            sweep.save(Path(folder) / "sweep.toml")
            self.assertEqual(cdpr.sweep.plan(Path(folder) / "sweep.toml").points.tolist(), plan.points.tolist())
            study().save(Path(folder) / "study.toml")
            there = cdpr.Sweep.of(cdpr.Study(Path(folder) / "study.toml"), keys, bounds=[-2, 2, 3, 7], step=0.5)
            self.assertEqual(cdpr.sweep.run(there).to_pandas().to_json(), result.to_pandas().to_json())

    def test_wrong_points_and_missing_rows_are_refused(self) -> None:
        for wrong in (-1, len(self.plan)):
            with self.assertRaises(cdpr.Error) as caught:
                cdpr.sweep.row(self.plan.data, wrong)
            self.assertEqual(caught.exception.code, "sweep::no-point")
        with self.assertRaises(cdpr.Error) as caught:
            cdpr.sweep.merge(self.plan, {0: cdpr.sweep.row(self.plan.data, 0)})
        self.assertEqual(caught.exception.code, "sweep::incomplete")
        with self.assertRaises(cdpr.Error):
            cdpr.sweep.Plan(self.plan.data.replace(b"planar", b"plenar"))


class Questions(unittest.TestCase):
    """Questions in parts: merged, they are the question's own answer."""

    def test_questions_in_parts_answer_as_whole(self) -> None:
        drawn = study({"tolerances": {"accuracy_m": 0.01, "robots": 40, "machine": {"frame_anchor_m": 0.001}}})
        rounds = study({"campaign": {"free": "frame-anchor", "rounds": 2, "poses_per_round": 4}})
        questions = [
            (cdpr.benchmark, (), {"robots": ["planar-example", "cablerobot-simulator-helicopter"], "models": ["standard"]}, 2),
            (cdpr.sensitivity, (drawn,), {"seed": 4}, 3),
            (cdpr.campaign, (rounds,), {"repeats": 2}, 2),
        ]
        for question, arguments, options, parts in questions:
            with self.subTest(question.__name__):
                whole = question(*arguments, **options)
                plan = cdpr.sweep.plan_of(question, *arguments, **options)
                self.assertEqual(len(plan), parts)
                self.assertIn(question.__name__, plan.question)
                rows = [cdpr.sweep.row(plan.data, point) for point in reversed(range(parts))]
                merged = cdpr.sweep.merge(pickle.loads(pickle.dumps(plan)), rows)
                self.assertEqual(merged, whole)
                for name, content in whole.attached.items():
                    if not name.endswith(".html"):
                        self.assertEqual(merged.attached[f"sweep/{name}"], content, name)

    def test_questions_without_parts_are_refused(self) -> None:
        with self.assertRaises(cdpr.Error) as caught:
            cdpr.sweep.plan_of(cdpr.check, "planar-example")
        self.assertEqual(caught.exception.code, "sweep::command")


class OnDask(unittest.TestCase):
    """Two processes of Dask: slow to start, so all in one test."""

    def test_dask_gives_the_same_bytes_whatever_dies(self) -> None:
        try:
            from distributed import Client, LocalCluster
        except ImportError:
            self.skipTest("distributed is not there")
        import dask

        # deaths are meant here
        logging.getLogger("distributed").setLevel(logging.CRITICAL)
        plan = cdpr.sweep.plan(SWEEP)
        expected = hashlib.sha256(cdpr.sweep.run(plan).attached["sweep/result.json"]).hexdigest()
        with (
            dask.config.set({"distributed.scheduler.allowed-failures": 0}),
            LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
            Client(cluster) as client,
            tempfile.TemporaryDirectory() as folder,
        ):
            def digest(result: cdpr.Result) -> str:
                return hashlib.sha256(result.attached["sweep/result.json"]).hexdigest()

            self.assertEqual(digest(cdpr.dask.sweep(client, plan)), expected)

            # a point at which workers die, and one that fails: told alone, the rest is done and kept
            with self.assertRaises(cdpr.dask.FailedPoints) as caught:
                cdpr.dask.sweep(client, plan, folder=folder, compute=poison)
            self.assertEqual(set(caught.exception.failed), {3, 5})
            self.assertEqual(len(os.listdir(Path(folder) / "rows")), len(plan) - 2)
            self.assertEqual(digest(cdpr.dask.sweep(client, plan, folder=f"file://{folder}")), expected)

            # a worker killed at work changes nothing and leaves no process behind
            client.wait_for_workers(2)
            killed: list[int] = []

            def kill(name: str, done: int, parts: int) -> None:
                if done == 2 and not killed:
                    killed.extend(client.run(os.getpid).values())
                    os.kill(killed[0], signal.SIGKILL)

            self.assertEqual(digest(cdpr.dask.sweep(client, plan, compute=slow, progress=kill)), expected)
            self.assertTrue(killed)
            processes = subprocess.run(["ps", "-eo", "ppid=,comm="], capture_output=True, text=True, check=True).stdout
            self.assertNotIn(["1", "cdpr"], [line.split() for line in processes.splitlines()])


if __name__ == "__main__":
    unittest.main()
