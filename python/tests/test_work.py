"""Long work: progress, its end by the caller or by Ctrl-C, threads."""

import os
import signal
import threading
import time
import unittest

import numpy as np

import cdpr
from support import demo, training

CANDIDATES = "standard;standard:length-offset;standard:frame-anchor;elastic:frame-anchor,compliance"


class Work(unittest.TestCase):
    def test_progress_is_told_on_the_thread_that_asks(self) -> None:
        seen: list[tuple[str, int, int | None]] = []

        def note(name: str, done: int, parts: int | None) -> None:
            self.assertIs(threading.current_thread(), threading.main_thread())
            seen.append((name, done, parts))

        cdpr.select(demo() / "robot.toml", training(), candidates=CANDIDATES, progress=note)
        self.assertEqual(seen[-1][1], seen[-1][2])

    def test_an_exception_of_progress_ends_the_work(self) -> None:
        def enough(name: str, done: int, parts: int | None) -> None:
            raise StopIteration("enough")

        with self.assertRaisesRegex(StopIteration, "enough"):
            cdpr.select(demo() / "robot.toml", training(), progress=enough)

    def test_ctrl_c_ends_long_work_soon(self) -> None:
        # shells start what runs in the background with Ctrl-C ignored
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))
        begun = time.monotonic()
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            # takes minutes
            cdpr.workspace("cablerobot-simulator-helicopter", step=0.01, page=False)
        self.assertLess(time.monotonic() - begun, 5.0)

    def test_results_do_not_depend_on_threads(self) -> None:
        def ask(threads: int) -> dict[str, object]:
            answer = cdpr.select(demo() / "robot.toml", training(), candidates=CANDIDATES, threads=threads).to_dict()
            return {key: value for key, value in answer.items() if key != "timing"}

        self.assertEqual(ask(1), ask(2))

    def test_other_threads_run_meanwhile(self) -> None:
        model = cdpr.Model("cablerobot-simulator-helicopter-elastostatic-calibrated", "elastic")
        rows = np.tile(model.robot.home, (20000, 1))
        turns = [0]
        done = threading.Event()

        def count() -> None:
            while not done.is_set():
                turns[0] += 1

        counter = threading.Thread(target=count)
        counter.start()
        before = turns[0]
        model.forward(model.inverse(rows, [3000.0] * 8), rows)
        done.set()
        counter.join()
        self.assertGreater(turns[0], before + 100)


if __name__ == "__main__":
    unittest.main()
