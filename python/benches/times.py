"""Times of the package beside those of Rust alone, of numba and of numpy, told and not judged: ratios of one run.

Started with the path of the example `row_times`, and with the folder `studies` for a sweep on Dask. One thread: set RAYON_NUM_THREADS=1.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import cdpr

ROBOT = "cablerobot-simulator-helicopter-elastostatic-calibrated"


def best(work: Callable[[], Any], patience: float = 0.6) -> float:
    """Returns the seconds of the fastest of many rounds."""
    begun, found = time.perf_counter(), float("inf")
    while time.perf_counter() - begun < patience:
        start = time.perf_counter()
        work()
        found = min(found, time.perf_counter() - start)
    return found


def rows(count: int) -> np.ndarray:
    """Returns poses as the example has them."""
    t = np.arange(count, dtype=float)
    position = [np.sin(t), np.cos(1.3 * t), 2.0 + np.sin(0.7 * t)]
    angles = [0.1 * np.sin(0.9 * t), 0.1 * np.cos(t), 0.1 * np.sin(0.4 * t)]
    return cdpr.Robot(ROBOT).quaternions(np.ascontiguousarray(np.transpose([*position, *angles])))


def numba_lengths(robot: cdpr.Robot) -> Callable[[np.ndarray, np.ndarray], None] | None:
    """Returns the lengths in numba, one thread; ``None`` without numba."""
    try:
        from numba import njit
    except ImportError:
        return None
    frame, platform = robot.frame_anchors.copy(), robot.platform_anchors.copy()

    @njit(fastmath=True)
    def lengths(poses: np.ndarray, out: np.ndarray) -> None:
        for k in range(poses.shape[0]):
            x, y, z, w = poses[k, 3], poses[k, 4], poses[k, 5], poses[k, 6]
            r00, r01, r02 = 1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)
            r10, r11, r12 = 2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)
            r20, r21, r22 = 2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)
            for i in range(frame.shape[0]):
                b0, b1, b2 = platform[i, 0], platform[i, 1], platform[i, 2]
                d0 = frame[i, 0] - poses[k, 0] - (r00 * b0 + r01 * b1 + r02 * b2)
                d1 = frame[i, 1] - poses[k, 1] - (r10 * b0 + r11 * b1 + r12 * b2)
                d2 = frame[i, 2] - poses[k, 2] - (r20 * b0 + r21 * b1 + r22 * b2)
                out[k, i] = np.sqrt(d0 * d0 + d1 * d1 + d2 * d2)

    return lengths


def main() -> None:
    """Prints a line for each question."""
    program = sys.argv[1]
    rust: dict[str, float] = {}

    def ask_rust() -> None:
        answer = json.loads(subprocess.run([program], check=True, capture_output=True).stdout)
        for name, value in answer.items():
            rust[name] = min(value, rust.get(name, float("inf")))

    ask_rust()
    robot = cdpr.Robot(ROBOT)
    rigid, elastic = cdpr.Model(robot), cdpr.Model(robot, "elastic")
    python: dict[str, float] = {}
    other: dict[str, float] = {}
    compiled = numba_lengths(robot)
    for count in (4096, 100_000):
        poses, out = rows(count), np.empty((count, 8))
        python[f"lengths_{count}"] = 1e9 * best(lambda: rigid.inverse(poses, out=out)) / count
        if compiled is not None:
            theirs = np.empty((count, 8))
            compiled(poses, theirs)
            np.testing.assert_allclose(theirs, out, rtol=0, atol=1e-13)
            other[f"lengths_{count}"] = 1e9 * best(lambda: compiled(poses, theirs)) / count
    poses = rows(4096)
    python["tensions_4096"] = 1e9 * best(lambda: elastic.tensions(poses)) / 4096
    lengths = elastic.inverse(poses, [4000.0] * 8)
    python["forward_4096"] = 1e9 * best(lambda: elastic.forward(lengths, poses)) / 4096
    ask_rust()
    for name, own in python.items():
        words = f"{name}: {own:.1f} ns a pose, Rust alone {rust[name]:.1f} (ratio {own / rust[name]:.2f})"
        if name in other:
            words += f", numba {other[name]:.1f} (ratio {own / other[name]:.2f})"
        print(words)

    pose, single = poses[0].copy(), np.empty(8)

    def thousand() -> None:
        for _ in range(1000):
            rigid.inverse(pose, out=single)

    print(f"single call: {1e3 * best(thousand):.2f} µs")
    print(f"100 000 plant steps with a controller in Python: {steps():.2f} s")
    if len(sys.argv) > 2:
        sweep(Path(sys.argv[2]))


def steps() -> float:
    """Returns the seconds of 100 000 steps of a plant, a damping controller of numpy between them."""
    text = cdpr.Robot(ROBOT).to_toml()
    body = (
        "center_of_mass_m = [0.0, 0.0, 0.1]\n"
        "inertia_about_center_of_mass_kg_m2 = [[117.0, 0.0, 0.0], [0.0, 121.0, 0.0], [0.0, 0.0, 62.5]]\n"
    )
    robot = cdpr.Robot.from_toml(text.replace("[platform]\n", "[platform]\n" + body, 1))
    plant = cdpr.Plant(cdpr.Model(robot, "elastic"))
    home = [0.0, 0.0, 1.5, 0.0, 0.0, 0.0]
    state = plant.at_rest(home, plant.model.tensions(home, "closed-form").tensions)
    seen = state.observe(np.empty(21))
    level, rates = seen[13:].copy(), np.empty(8)
    begun = time.perf_counter()
    for _ in range(100_000):
        state.observe(seen)
        np.subtract(seen[13:], level, out=rates)
        np.multiply(rates, 1e-6, out=rates)
        plant.step(state, rates, 0.001, "speeds")
    return time.perf_counter() - begun


def sweep(studies: Path) -> None:
    """Prints what a sweep of a minute and more takes on one and on two workers of Dask."""
    from distributed import Client, LocalCluster

    text = (studies / "sweep-planar-tension.toml").read_text().replace("step_m = 0.05", "step_m = 0.008")
    plan = cdpr.sweep.plan(cdpr.Sweep.from_toml(text, {file.name: file.read_text() for file in studies.glob("*.toml")}))
    taken = []
    for workers in (1, 2):
        with (
            LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
            Client(cluster) as client,
        ):
            client.run(cdpr.sweep.plan, studies / "sweep-planar-tension.toml")
            begun = time.perf_counter()
            cdpr.dask.rows(client, plan)
            taken.append(time.perf_counter() - begun)
    print(f"sweep of {len(plan)} points: {taken[0]:.1f} s on one worker, {taken[1]:.1f} s on two (ratio {taken[1] / taken[0]:.2f})")


if __name__ == "__main__":
    main()
