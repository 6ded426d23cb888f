"""Judges pulley lengths and elastic equilibria by MuJoCo: `judge.py CASES.json`; exit code 1 when a figure is above its limit."""

import json
import sys

import mujoco
import numpy

from scene import LEAD_IN, cross_section, scene

# Allowed deviations.
LENGTH_M = 1e-12
POSITION_M = 1e-9
ANGLE_RAD = 1e-9
TENSION_N = 1e-6
# Speed at which the dynamics count as settled (m/s, rad/s).
SETTLED = 1e-13


class Scene:
    """A compiled scene and the places of platform, swivels and tendons in its state."""

    def __init__(self, cables, **options):
        self.model = mujoco.MjModel.from_xml_string(scene(cables, **options))
        self.data = mujoco.MjData(self.model)
        self.cables = cables
        joint = self.model.joint("platform")
        self.platform = (joint.qposadr[0], joint.dofadr[0], self.model.body("platform").id)
        self.pulleys = [index for index, cable in enumerate(cables) if cable["radius"] is not None]
        self.swivels = [self.model.joint(f"swivel{index}").qposadr[0] for index in self.pulleys]
        self.swivel_speeds = [self.model.joint(f"swivel{index}").dofadr[0] for index in self.pulleys]
        self.anchors = [self.model.site(f"anchor{index}").id for index in self.pulleys]
        self.entries = numpy.array([cables[index]["frame_anchor"] for index in self.pulleys])
        self.axes = numpy.array([cross_section(cables[index]) for index in self.pulleys])

    def place(self, pose, swivel_angles):
        start = self.platform[0]
        self.data.qpos[start : start + 3] = pose["position"]
        self.data.qpos[start + 3 : start + 7] = pose["quaternion"]
        self.data.qpos[self.swivels] = [swivel_angles[index] for index in self.pulleys]
        self.data.qvel[:] = 0

    def follow(self):
        """Turns the swivels to where the anchors are."""
        if self.pulleys:
            mujoco.mj_kinematics(self.model, self.data)
            away = self.data.site_xpos[self.anchors] - self.entries
            x, y = (numpy.einsum("ij,ij->i", self.axes[:, k], away) for k in (0, 1))
            self.data.qpos[self.swivels] = numpy.arctan2(y, x)
            self.data.qvel[self.swivel_speeds] = 0

    def lengths(self, wrap_angles=None):
        """Cable lengths from D on, or from the point; MuJoCo needs to know which cables wrap by about half a turn or more."""
        lengths = self.data.ten_length[: len(self.cables)].copy()
        for order, index in enumerate(self.pulleys):
            lengths[index] -= LEAD_IN
            if wrap_angles is not None and wrap_angles[index] > 3.0:
                late = self.data.ten_length[len(self.cables) + order] - LEAD_IN
                lengths[index] = late + 0.5 * numpy.pi * self.cables[index]["radius"]
        return lengths

    def apply(self, wrench):
        """A constant wrench about the platform's origin, world axes."""
        _, _, body = self.platform
        self.data.qfrc_applied[:] = 0
        point = self.data.xpos[body].copy()
        mujoco.mj_applyFT(
            self.model, self.data, wrench[:3], wrench[3:], point, body, self.data.qfrc_applied
        )

    def missing(self, wrench):
        """Generalised forces that are left at rest, springs and load against gravity: 0 in equilibrium."""
        mujoco.mj_forward(self.model, self.data)
        self.apply(wrench)
        return self.data.qfrc_spring + self.data.qfrc_applied - self.data.qfrc_bias

    def tensions(self, rest_lengths):
        stretch = self.lengths() - rest_lengths
        stiffness = numpy.array([cable["stiffness"] for cable in self.cables]) / rest_lengths
        return numpy.maximum(stiffness * stretch, 0.0)

    def moved(self, step):
        """The state displaced by a step of the generalised velocities."""
        mujoco.mj_integratePos(self.model, self.data.qpos, step, 1.0)


def pose_error(data, start, pose):
    """Distance (m) and angle (rad) from a pose."""
    distance = numpy.linalg.norm(data.qpos[start : start + 3] - pose["position"])
    turn = numpy.zeros(3)
    mujoco.mju_subQuat(turn, data.qpos[start + 3 : start + 7].copy(), numpy.array(pose["quaternion"]))
    return distance, numpy.linalg.norm(turn)


def judge_lengths(robot):
    judged = Scene(robot["cables"])
    errors, wrap_angles = [], []
    for case in robot["poses"]:
        judged.place(case["pose"], case["swivel_angles"])
        mujoco.mj_kinematics(judged.model, judged.data)
        mujoco.mj_comPos(judged.model, judged.data)
        mujoco.mj_tendon(judged.model, judged.data)
        errors.extend(numpy.abs(judged.lengths(case["wrap_angles"]) - case["lengths"]))
        wrap_angles.extend(case["wrap_angles"])
    turn = numpy.degrees(numpy.max(wrap_angles))
    remark = f"{len(errors)} lengths at {len(robot['poses'])} poses, wrap angles up to {turn:.0f}°"
    return [(f"length, {robot['name']}", numpy.max(errors), LENGTH_M, "m", remark)]


def newton(judged, wrench):
    """Newton's method on MuJoCo's forces, their derivatives by central differences; leaves the state in equilibrium."""
    count, step = judged.model.nv, 1e-6
    for _ in range(60):
        missing = judged.missing(wrench).copy()
        if numpy.abs(missing).max() < 1e-9:
            break
        state = judged.data.qpos.copy()
        jacobian = numpy.zeros((count, count))
        for column in range(count):
            sides = []
            for sign in (1.0, -1.0):
                judged.data.qpos[:] = state
                judged.moved(sign * step * numpy.eye(count)[column])
                sides.append(judged.missing(wrench).copy())
            jacobian[:, column] = (sides[0] - sides[1]) / (2 * step)
        change = -numpy.linalg.solve(jacobian, missing)
        # far from equilibrium a whole step may lead away from it
        for _ in range(8):
            judged.data.qpos[:] = state
            judged.moved(change)
            if numpy.abs(judged.missing(wrench)).max() < numpy.abs(missing).max() or numpy.abs(change).max() < 1e-9:
                break
            change *= 0.5
        if numpy.abs(change).max() < 1e-14:
            break
    judged.missing(wrench)


def settle(judged, wrench):
    """Lets the dynamics run until they rest, for a minute of their time at most.

    MuJoCo's cylinder has no groove: its cable slides sideways along it, so that a swivel which points at its anchor is in
    equilibrium (as the balance above shows) but need not be a stable one. Here the swivels follow their anchors.
    """
    for step in range(round(60.0 / judged.model.opt.timestep)):
        judged.follow()
        mujoco.mj_step1(judged.model, judged.data)
        judged.apply(wrench)
        mujoco.mj_step2(judged.model, judged.data)
        if step % 100 == 99 and numpy.abs(judged.data.qvel).max() < SETTLED:
            break
    judged.follow()
    judged.missing(wrench)


def judge_equilibrium(case, errors):
    cables, wrench = case["cables"], numpy.array(case["wrench"])
    rest = numpy.array(case["controlled_lengths"])
    options = {"mass": case["mass"], "center_of_mass": case["center_of_mass"], "gravity": case["gravity"]}
    stiffness = max(cable["stiffness"] / length for cable, length in zip(cables, rest))
    damping = 1.5 * (stiffness * case["mass"]) ** 0.5
    judged = Scene(cables, rest_lengths=case["controlled_lengths"], damping=float(damping), **options)
    start, velocity, _ = judged.platform

    def record(name, quantity, unit, values):
        errors.setdefault((name, quantity, unit), []).append(numpy.abs(values).max())

    judged.place(case["pose"], case["swivel_angles"])
    record("balance", "forces left", "N", judged.missing(wrench))
    record("balance", "tension", "N", judged.tensions(rest) - case["tensions"])

    if "commanded" in case:  # what emerges is sought from the command, as the machine does
        judged.place(case["commanded"], case["swivel_angles"])
        newton(judged, wrench)
        distance, angle = pose_error(judged.data, start, case["pose"])
        record("commanded", "position", "m", distance)
        record("commanded", "orientation", "rad", angle)
        record("commanded", "tension", "N", judged.tensions(rest) - case["tensions"])
        return
    generator = numpy.random.default_rng(1)
    for name, solve in (("newton", lambda: newton(judged, wrench)), ("settled", lambda: settle(judged, wrench))):
        judged.place(case["pose"], case["swivel_angles"])
        step = numpy.zeros(judged.model.nv)
        step[velocity : velocity + 3] = generator.uniform(-5e-3, 5e-3, 3)
        step[velocity + 3 : velocity + 6] = generator.uniform(-5e-3, 5e-3, 3)
        judged.moved(step)
        solve()
        distance, angle = pose_error(judged.data, start, case["pose"])
        record(name, "position", "m", distance)
        record(name, "orientation", "rad", angle)
        record(name, "tension", "N", judged.tensions(rest) - case["tensions"])


def judge_equilibria(cases):
    rows, by_robot = [], {}
    for case in cases:
        judge_equilibrium(case, by_robot.setdefault(case["name"], {}))
    limits = {"m": POSITION_M, "rad": ANGLE_RAD, "N": TENSION_N}
    words = {"commanded": "Newton from the commanded pose", "balance": "at our pose, swivels free", "newton": "Newton on MuJoCo's forces", "settled": "MuJoCo's dynamics settled"}
    for robot, errors in by_robot.items():
        for (name, quantity, unit), values in errors.items():
            remark = f"{words[name]}, {len(values)} equilibria"
            rows.append((f"{quantity}, {robot}", numpy.max(values), limits[unit], unit, remark))
    return rows


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        cases = json.load(file)
    rows = [row for robot in cases["pulley_lengths"] for row in judge_lengths(robot)]
    rows += judge_equilibria(cases["equilibria"])
    print(f"MuJoCo {mujoco.__version__}")
    failed = 0
    for name, worst, limit, unit, remark in rows:
        is_good = worst <= limit  # numpy's max keeps NaN, which fails here
        failed += not is_good
        verdict = "ok " if is_good else "BAD"
        print(f"{verdict}  {name:<52} {worst:8.1e} {unit:<3} (limit {limit:.0e})  {remark}")
    print(f"judged: {len(rows) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
