"""The meta-model as one writes it with SciPy: `python metamodel.py`, from this folder; needs NumPy and SciPy.

A kinematic control model on a machine of elastic cables (q_off set once, Aᵀ f + w = 0, f_i = k_F (l_i - q_i)/l_i or slack), pose
by pose with scipy.optimize.root from the commanded pose. Rows as those of `cargo bench -p cdpr --bench metamodel` and `--bench tolerance`;
where a row counts fewer poses than theirs, `seconds` are scaled up to the same number.
"""

import json
import pathlib
import time
import tomllib

import numpy as np
from scipy.optimize import root
from scipy.spatial.transform import Rotation

ROBOTS = pathlib.Path(__file__).parents[2] / "robots"


def read(name):
    robot = tomllib.loads((ROBOTS / f"{name}.toml").read_text())
    cables = robot["cable"]
    return robot, np.array([c["frame_anchor_m"] for c in cables]), np.array([c["platform_anchor_m"] for c in cables])


def row(problem, seconds, count, value):
    print(json.dumps({"lib": "SciPy", "problem": problem, "seconds": round(seconds, 4), "count": count, "value": float(value)}))


def planar_map():
    anchors = np.array([[-6, 8], [5, 8], [-5, 0], [5, 0.5]], float)
    stiffness, load = 2e5, np.array([0, -1962.0])
    start = np.array([0, 5.2])

    def directions(x):
        ways = anchors - x
        lengths = np.linalg.norm(ways, axis=1)
        return ways / lengths[:, None], lengths

    u, lengths = directions(start)
    middle = np.full(4, 4500.0)
    initial = middle - np.linalg.pinv(u.T) @ (load + u.T @ middle)
    offsets = -lengths * initial / stiffness

    def emerging(x):
        controlled = directions(x)[1] + offsets

        def balance(at):
            u, lengths = directions(at)
            return u.T @ np.maximum(stiffness * (lengths - controlled) / lengths, 0.0) + load

        return root(balance, x, tol=1e-10).x

    xs, ys = np.linspace(-4, 4, 100), np.linspace(0.5, 6, 100)
    begin = time.perf_counter()
    errors = [np.linalg.norm(emerging(np.array([x, y])) - [x, y]) for y in ys for x in xs]
    row("planar accuracy map 100 x 100, exact", time.perf_counter() - begin, len(errors), 1e3 * np.mean(errors))


class Twin:
    """The CableRobot Simulator: a nominal kinematic controller on the elastic machine of eq. 6.27-6.30."""

    def __init__(self):
        _, self.control_frame, self.control_platform = read("cablerobot-simulator-helicopter")
        machine, self.frame, self.platform = read("cablerobot-simulator-helicopter-elastostatic-calibrated")
        cables = machine["cable"]
        self.stiffness = np.array([c["axial_stiffness_EA_N"] for c in cables])
        self.limits = np.array([[c["tension_min_N"], c["tension_max_N"]] for c in cables])
        self.offset = np.array([c.get("length_offset_m", 0.0) for c in cables])
        self.scale = np.array([c.get("length_scale", 1.0) for c in cables])
        wrench = machine["external_wrench"]  # it includes gravity and is constant
        self.force, self.moment = np.array(wrench["force_N"]), np.array(wrench["moment_Nm"])

    def balance(self, at, controlled, frame, platform, stiffness):
        rotation = Rotation.from_rotvec(at[3:]).as_matrix()
        levers = platform @ rotation.T
        ways = frame - at[:3] - levers
        lengths = np.linalg.norm(ways, axis=1)
        u = ways / lengths[:, None]
        f = np.maximum(stiffness * (lengths - controlled) / lengths, 0.0)
        return np.concatenate([u.T @ f + self.force, np.cross(levers, u).T @ f + self.moment]), f

    def emerging(self, x, frame=None, platform=None, stiffness=None):
        frame = self.frame if frame is None else frame
        platform = self.platform if platform is None else platform
        stiffness = self.stiffness if stiffness is None else stiffness
        sent = np.linalg.norm(self.control_frame - x - self.control_platform, axis=1)
        controlled = (sent - self.offset) / self.scale
        start = np.concatenate([x, np.zeros(3)])
        found = root(lambda at: self.balance(at, controlled, frame, platform, stiffness)[0], start, tol=1e-10)
        return found.x, self.balance(found.x, controlled, frame, platform, stiffness)[1], found.success


def twin_hull(twin, rays=12, all_rays=642):
    """Rays with 48 probes each and bisection to a millionth of the box, as ours."""
    low, high = twin.frame.min(axis=0), twin.frame.max(axis=0)
    low, high = low - 0.25 * (high - low), high + 0.25 * (high - low)
    center = np.array([0, 0, 1.5])
    generator = np.random.default_rng(1)

    def reached(x):
        _, f, success = twin.emerging(x)
        return success and np.all(f >= twin.limits[:, 0]) and np.all(f <= twin.limits[:, 1])

    begin, count, radii = time.perf_counter(), 0, []
    for _ in range(rays):
        direction = generator.normal(size=3)
        direction /= np.linalg.norm(direction)
        length = np.min(np.where(direction > 0, high - center, low - center) / direction)
        probes = [reached(center + length * (k + 1) / 48 * direction) for k in range(48)]
        left = probes.index(False) if False in probes else 48
        inside, outside = length * left / 48, length * (left + 1) / 48
        count += 48
        while left < 48 and outside - inside > 1e-6 * np.max(high - low):
            middle = 0.5 * (inside + outside)
            inside, outside = (middle, outside) if reached(center + middle * direction) else (inside, middle)
            count += 1
        radii.append(inside)
    seconds = (time.perf_counter() - begin) * all_rays / rays
    row("reachable hull of the twin, 642 rays", seconds, count, np.mean(np.array(radii) ** 3) * 4 / 3 * np.pi)


def monte_carlo(twin, robots=6, all_robots=10_000):
    """Frame and platform anchors deviate by 1 mm, stiffnesses by 3 %, at the 75 poses of section 6.1."""
    grid = [np.array([x, y, z]) for x in np.linspace(-1.5, 1.5, 5) for y in np.linspace(-1.5, 1.5, 5) for z in np.linspace(1.25, 2, 3)]
    generator = np.random.default_rng(1)
    begin, errors = time.perf_counter(), []
    for _ in range(robots):
        frame = twin.frame + 1e-3 * generator.normal(size=twin.frame.shape)
        platform = twin.platform + 1e-3 * generator.normal(size=twin.platform.shape)
        stiffness = twin.stiffness * (1 + 0.03 * generator.normal(size=8))
        errors += [np.linalg.norm(twin.emerging(x, frame, platform, stiffness)[0][:3] - x) for x in grid]
    seconds = (time.perf_counter() - begin) * all_robots / robots
    row("Monte-Carlo tolerance study, 10 000 robots at 75 poses", seconds, len(errors), 1e3 * np.mean(errors))


if __name__ == "__main__":
    planar_map()
    twin = Twin()
    monte_carlo(twin)
    twin_hull(twin)
