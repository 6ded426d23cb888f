"""Judges what a box allows: `judge.py COMMAND ROBOTS`; exit code 1 when a figure is beyond its limit.

`COMMAND capability` answers for three robots: a suspended camera, the eight cables of a simulator and a planar robot, in a turned orientation
where the platform turns. Dense grids over their boxes are searched here: half-spaces of the wrenches that tensions give, by normals to all sets of
columns of the structure matrix (singular value decompositions), and at some poses linear programmes of SciPy, which know of no half-spaces. `ROBOTS` is the folder of
the robot files that come with the command.
"""

import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import tomllib

# small matrices: threads would only wait for each other
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy
import scipy
from scipy.optimize import linprog

# Relative difference of a value at a pose: ours, by half-spaces and by a linear programme.
RELATIVE = 1e-6
# Largest gap that is asked for.
GAP = 0.01
# Poses at which linear programmes are solved.
PROGRAMMES = 12


class Robot:
    """Straight cables of a robot file; wrenches are rows of its motion pattern."""

    def __init__(self, file, angles, place):
        pattern = file["motion_pattern"]
        self.planar, self.turns = pattern in ("2T", "1R2T"), pattern in ("1R2T", "3R3T")
        self.size = 2 if self.planar else 3
        defaults = file.get("cable_defaults", {})
        cables = [defaults | cable for cable in file["cable"]]
        zero = [0.0] * self.size
        self.frame = numpy.array([cable["frame_anchor_m"] for cable in cables])
        platform = numpy.array([cable.get("platform_anchor_m", zero) for cable in cables])
        self.bounds = numpy.array([[cable["tension_min_N"], cable["tension_max_N"]] for cable in cables])
        self.speeds = [
            min(cable["speed_max_m_s"], cable["motor_speed_max_rad_per_s"] / cable["gear_ratio"] * cable["drum_radius_m"])
            for cable in cables
        ]
        self.rotation = turn(angles, self.planar)
        self.arms = platform @ self.rotation.T
        body, gravity = file["platform"], numpy.array(file["gravity_m_s2"])
        self.mass = body["mass_kg"]
        self.center = self.rotation @ numpy.array(body.get("center_of_mass_m", zero))
        external = file.get("external_wrench", {})
        force, moment = numpy.array(external.get("force_N", zero)), external.get("moment_Nm", 0.0 if self.planar else zero)
        self.load = self.rows(force, numpy.zeros(self.size))
        if self.turns:
            self.load[self.size :] += moment
        if not external.get("includes_gravity", False):
            self.load = self.load + self.rows(self.mass * gravity, self.center)
        corners = itertools.product(*[(-place, place)] * self.size) if place else [zero]
        self.weights = [self.rows(gravity, self.rotation @ numpy.array(corner)) for corner in corners]

    def rows(self, force, arm):
        """Wrench of a force with an arm."""
        if not self.turns:
            return force.copy()
        moment = [arm[0] * force[1] - arm[1] * force[0]] if self.planar else numpy.cross(arm, force)
        return numpy.concatenate([force, moment])

    def accelerated(self, direction):
        """What the cables have to give besides for an acceleration of 1 m/s2."""
        return self.rows(-self.mass * direction, self.center)

    def matrix(self, position):
        """Structure matrix by rows of the pattern."""
        away = self.frame - position - self.arms
        units = away / numpy.linalg.norm(away, axis=1)[:, None]
        return numpy.array([self.rows(unit, arm) for unit, arm in zip(units, self.arms)]).T

    def half_spaces(self, position):
        """Unit normals and offsets of the wrenches that tensions balance."""
        matrix = self.matrix(position)
        rows, cables = matrix.shape
        sets = numpy.array(list(itertools.combinations(range(cables), rows - 1)))
        normals = numpy.linalg.svd(matrix.T[sets], full_matrices=True)[2][:, -1]
        normals = numpy.concatenate([normals, -normals])
        pulls = -normals @ matrix
        return normals, numpy.where(pulls > 0, pulls * self.bounds[:, 1], pulls * self.bounds[:, 0]).sum(axis=1)

    def by_half_spaces(self, position):
        """Payload, acceleration in any direction and along each axis; `None` where the load is not held."""
        normals, offsets = self.half_spaces(position)
        room = offsets - normals @ self.load
        if room.min() < -1e-9 * numpy.abs(offsets).max():
            return None
        along = numpy.array([normals @ self.accelerated(axis) for axis in numpy.eye(self.size)])
        asked = [numpy.max([normals @ weight for weight in self.weights], axis=0), numpy.linalg.norm(along, axis=0), *numpy.abs(along)]

        def least(asked):
            limits = asked > 1e-9 * numpy.abs(asked).max()
            return (room[limits] / asked[limits]).min() if limits.any() else numpy.inf

        return [least(one) for one in asked]

    def largest(self, position, added):
        """Largest factor of a wrench that tensions balance besides the load, by a linear programme; `None` if not even the load."""
        system = numpy.column_stack([self.matrix(position), added])
        cost = numpy.zeros(system.shape[1])
        cost[-1] = -1.0
        found = linprog(cost, A_eq=system, b_eq=-self.load, bounds=[*self.bounds, (0, None)], method="highs")
        return found.x[-1] if found.status == 0 else None

    def by_programmes(self, position):
        """Payload and accelerations along each axis."""
        payload = min(self.largest(position, weight) for weight in self.weights) if self.weights[0].any() else numpy.inf
        axes = [
            min(self.largest(position, self.accelerated(sense * axis)) for sense in (1, -1)) for axis in numpy.eye(self.size)
        ]
        return [payload, *axes]


def turn(angles, planar):
    """R = Rx Ry Rz, or the turn in a plane."""
    if planar:
        cos, sin = numpy.cos(angles[0]), numpy.sin(angles[0])
        return numpy.array([[cos, -sin], [sin, cos]])
    return scipy.spatial.transform.Rotation.from_euler("XYZ", angles).as_matrix()


def written(source, target, platform, top=""):
    """A robot file with further keys: mass and speeds that the source does not state."""
    text = source.read_text(encoding="utf-8")
    drive = "speed_max_m_s = 3.0\nmotor_speed_max_rad_per_s = 300.0\ngear_ratio = 12.0\ndrum_radius_m = 0.1\n"
    for key in [line.split(" = ")[0] for line in drive.splitlines()]:
        text = "\n".join(line for line in text.splitlines() if not line.startswith(f"{key} "))
    text = text.replace("[platform]\n", f"[platform]\n{platform}") if platform else text
    for old, new in [pair.split(" -> ") for pair in top.splitlines()]:
        assert old in text, old
        text = text.replace(old, new)
    # the second cable is driven more slowly
    parts = text.split("[[cable]]\n")
    text = parts[0] + "".join(
        "[[cable]]\n" + (drive.replace("300.0", "240.0") if k == 1 else drive) + part for k, part in enumerate(parts[1:])
    )
    target.write_text(text, encoding="utf-8")
    return tomllib.loads(text)


def asked(command, path, box, angles, place, gap=GAP):
    """The answer of the command."""
    words = [command, "capability", path, f"--box={','.join(map(str, box))}", "--payload-place", str(place), "--gap", str(gap), "--format", "json"]
    if angles:
        words += [f"--rotation={','.join(map(str, angles))}"]
    run = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        raise SystemExit(run.stderr)
    return run.returncode, json.loads(run.stdout)


def values(answer):
    """Values in the order of the dense search, with their details."""
    details = [answer["payload"], answer["acceleration"]["ball"], *answer["acceleration"]["per_axis"]]
    numbers = [answer["payload_kg"], answer["acceleration_m_s2"]["ball"], *answer["acceleration_m_s2"]["per_axis"]]
    return list(zip(numbers, details))


class Table:
    def __init__(self):
        self.passed = self.failed = 0

    def judge(self, words, is_right, numbers):
        self.passed, self.failed = self.passed + bool(is_right), self.failed + (not is_right)
        print(f"{'ok  ' if is_right else 'FAIL'} {words:<52} {numbers}")


def judge(table, name, robot, answer, box, counts):
    """Compares an answer with the dense search."""
    sides = [numpy.linspace(box[2 * k], box[2 * k + 1], count) for k, count in enumerate(counts)]
    grid = numpy.array(list(itertools.product(*sides)))
    started = time.perf_counter()
    found = [robot.by_half_spaces(position) for position in grid]
    seconds = time.perf_counter() - started
    table.judge(f"{name}: the own load is held on the whole grid", all(found), f"{len(grid)} poses, {seconds:.1f} s")
    dense = numpy.array(found)
    chosen = numpy.random.default_rng(3).choice(len(grid), PROGRAMMES, replace=False)
    programmes = numpy.array([robot.by_programmes(grid[k]) for k in chosen])
    own = dense[chosen][:, [0, *range(2, dense.shape[1])]]
    finite = numpy.isfinite(own)
    off = numpy.abs(programmes[finite] / own[finite] - 1).max()
    table.judge(f"{name}: half-spaces and linear programmes agree here", off < RELATIVE, f"{off:.1e}")
    titles = ["payload", "acceleration", *[f"acceleration along {axis}" for axis in "xyz"]]
    for index, (value, detail) in enumerate(values(answer)):
        words = f"{name}: {titles[index]}"
        if value is None:
            table.judge(f"{words}, none", not numpy.isfinite(dense[:, index]).any(), detail["reason"][:60])
            continue
        least, bound = dense[:, index].min(), next(detail[key] for key in detail if key.startswith("at_least"))
        holds = bound <= least * (1 + RELATIVE) and value <= least * (1 + GAP)
        table.judge(f"{words}: bound ≤ dense, value ≤ dense · 1.01", holds, f"bound {bound:.6g}, value {value:.6g}, dense {least:.6g}")
        table.judge(f"{words}: gap", value - bound <= GAP * value * (1 + RELATIVE), f"{1 - bound / value:.2e}")
        here = numpy.array(detail["at_pose"]["position_m"])
        again = robot.by_half_spaces(here)[index]
        if index != 1:
            again = robot.by_programmes(here)[max(index - 1, 0)]
        table.judge(f"{words}: at its pose", abs(again / value - 1) < RELATIVE, f"{again / value - 1:.1e}")
        limit = detail["limited_by"]
        table.judge(f"{words}: limit names cables", limit["cable"] in limit["at_tension_max"] + limit["at_tension_min"], limit["limit"])
    speed = answer["speed_m_s"]
    table.judge(f"{name}: speed", abs(speed / min(robot.speeds) - 1) < RELATIVE, f"{speed:.6g}, {answer['speed']['limited_by']['limit']}")


def main():
    command, robots = sys.argv[1], pathlib.Path(sys.argv[2])
    table = Table()
    print(f"SciPy {scipy.__version__}, numpy {numpy.__version__}")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        subprocess.run([command, "new", "suspended-camera", "--out", str(folder / "camera")], check=True, capture_output=True)
        mass = "mass_kg = 180.0\ncenter_of_mass_m = [0.05, -0.1, 0.2]\n"
        cases = [
            ("suspended camera", folder / "camera/robot.toml", "", "", [-3, 3, -2, 2, 1, 4], [], 0.0, (17, 13, 13)),
            ("simulator", robots / "cablerobot-simulator-helicopter.toml", mass, "", [-1, 1, -1, 1, 1, 2], [0.1, 0.05, 0.0], 0.3, (11, 11, 7)),
            ("planar", robots / "kntu-planar.toml", "", "gravity_m_s2 = [0.0, 0.0] -> gravity_m_s2 = [0.0, -9.81]\nmass_kg = 5.0 -> mass_kg = 1.0", [-0.3, 0.3, -0.3, 0.3], [0.05], 0.02, (41, 41)),
        ]
        for name, source, platform, top, box, angles, place, counts in cases:
            path = folder / f"{name.replace(' ', '-')}.toml"
            file = written(source, path, platform, top)
            robot = Robot(file, angles or [0.0, 0.0, 0.0], place)
            code, answer = asked(command, path, box, angles, place)
            table.judge(f"{name}: status", (code, answer["status"]) == (0, "found"), f"{answer['status']}, {answer['poses']} poses")
            judge(table, name, robot, answer, box, counts)
        # far out the load is not held, and the linear programme says the same of the pose that is told
        path = folder / "suspended-camera.toml"
        code, answer = asked(command, path, [-30, 3, -2, 2, 1, 4], [], 0.0)
        robot = Robot(tomllib.loads(path.read_text(encoding="utf-8")), [0.0, 0.0, 0.0], 0.0)
        here = numpy.array(answer["not_held"]["at_pose"]["position_m"])
        none = robot.largest(here, numpy.zeros(robot.size)) is None
        table.judge("suspended camera, too wide a box: not held", code == 1 and none, answer["not_held"]["limited_by"]["limit"])
    print(f"judged: {table.passed} passed, {table.failed} failed")
    sys.exit(table.failed > 0)


if __name__ == "__main__":
    main()
