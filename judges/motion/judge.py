"""Judges motions by MuJoCo: `judge.py [--untimed] CASES.json`; exit code 1 when a figure is above its limit."""

import json
import pathlib
import sys
import time

import mujoco
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "mujoco"))
from judge import pose_error
from scene import numbers, scene

# Allowed deviations over the whole motion.
POSITION_M = 1e-6
ANGLE_RAD = 1e-6
# Time of our step as a share of MuJoCo's.
SHARE = 0.31
# Steps of MuJoCo's Runge-Kutta rule (s); the last one is compared.
STEPS = (1e-3, 2e-4, 5e-5)


def motion_scene(case, step):
    """MJCF text: a free platform on springs from fixed points."""
    xx, xy, xz, _, yy, yz, _, _, zz = case["inertia"]
    frame = "".join(
        f'<site name="start{index}" pos="{numbers(cable["frame_anchor"])}"/>' for index, cable in enumerate(case["cables"])
    )
    anchors = "".join(
        f'<site name="anchor{index}" pos="{numbers(cable["platform_anchor"])}"/>' for index, cable in enumerate(case["cables"])
    )
    # no force up to the unstrained length: a cable that is slack
    tendons = "".join(
        f'<spatial name="cable{index}" springlength="0 {length!r}" stiffness="{cable["stiffness"]!r}">'
        f'<site site="start{index}"/><site site="anchor{index}"/></spatial>'
        for index, (cable, length) in enumerate(zip(case["cables"], case["lengths"]))
    )
    return f"""
<mujoco>
  <option gravity="{numbers(case['gravity'])}" timestep="{step!r}" integrator="RK4"><flag contact="disable"/></option>
  <worldbody>{frame}
    <body name="platform"><freejoint name="platform"/>
      <inertial pos="{numbers(case['center_of_mass'])}" mass="{case['mass']!r}" fullinertia="{numbers([xx, yy, zz, xy, xz, yz])}"/>
      {anchors}
    </body>
  </worldbody>
  <tendon>{tendons}</tendon>
</mujoco>"""


def path(case, step):
    """Poses at the samples."""
    model = mujoco.MjModel.from_xml_string(motion_scene(case, step))
    data = mujoco.MjData(model)
    data.qpos[:3], data.qpos[3:] = case["start"]["position"], case["start"]["quaternion"]
    count, every = round(case["duration"] / case["sample"]), round(case["sample"] / step)
    poses = []
    for sample in range(count):
        if case["cut"] is not None and abs(sample * case["sample"] - case["cut_time"]) < 1e-9:
            model.tendon_stiffness[case["cut"]] = 0.0
        mujoco.mj_step(model, data, every)
        poses.append(data.qpos.copy())
    return poses


class Place:
    """A pose in the place of MuJoCo's data."""

    def __init__(self, qpos):
        self.qpos = qpos


def apart(poses, others):
    """Largest distance (m) and angle (rad) of MuJoCo's poses from ours."""
    errors = [pose_error(Place(pose), 0, other) for pose, other in zip(poses, others, strict=True)]
    return numpy.max(errors, axis=0)


def judge_motion(case):
    theirs = [path(case, step) for step in STEPS]
    ours = case["motions"]
    exact = theirs[-1]
    falls = " ".join(f"{motion['step'] * 1e3:g} ms {apart(exact, motion['poses'])[0]:.0e}" for motion in ours)
    as_pose = [{"position": pose[:3], "quaternion": pose[3:]} for pose in exact]
    other = " ".join(f"{step * 1e3:g} ms {apart(poses, as_pose)[0]:.0e}" for step, poses in zip(STEPS[:-1], theirs))
    distance, angle = apart(exact, ours[-1]["poses"])
    remark = f"{case['slack_cables']} cables go slack; by our step: {falls}; by theirs: {other}"
    return [
        (f"position, {case['name']}", distance, POSITION_M, "m", remark),
        (f"orientation, {case['name']}", angle, ANGLE_RAD, "rad", ""),
    ]


def judge_time(case):
    """MuJoCo's step with its cheapest integrator and the same cables over pulleys, in C, against ours."""
    text = scene(case["cables"], case["lengths"], case["mass"], case["center_of_mass"], case["gravity"])
    text = text.replace('integrator="implicit"', 'integrator="Euler"')
    # the second tendons, which judge long arcs, are none of the machine's
    text = "".join(part for part in text.split("\n"))
    while '<spatial name="late_' in text:
        start = text.index('<spatial name="late_')
        end = text.index("</spatial>", start) + len("</spatial>")
        text = text[:start] + text[end:]
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    best = float("inf")
    for _ in range(40):
        mujoco.mj_resetData(model, data)
        place(model, data, case)
        before = time.perf_counter()
        mujoco.mj_step(model, data, 500)
        best = min(best, (time.perf_counter() - before) / 500 * 1e9)
    share = case["step_ns"] / best
    remark = f"eight cables over pulleys, ours {case['step_ns']:.0f} ns a step, MuJoCo's semi-implicit Euler {best:.0f} ns"
    return [("time of a step, share of MuJoCo's", share, SHARE, "", remark)]


def place(model, data, case):
    start = model.joint("platform").qposadr[0]
    data.qpos[start : start + 3] = case["start"]["position"]
    data.qpos[start + 3 : start + 7] = case["start"]["quaternion"]
    for index, angle in enumerate(case["swivel_angles"]):
        data.qpos[model.joint(f"swivel{index}").qposadr[0]] = angle


def main():
    with open(sys.argv[-1], encoding="utf-8") as file:
        cases = json.load(file)
    rows = [row for case in cases["motions"] for row in judge_motion(case)]
    if "--untimed" not in sys.argv:
        rows += judge_time(cases["timed"])
    print(f"MuJoCo {mujoco.__version__}, motions of 3 s")
    failed = 0
    for name, worst, limit, unit, remark in rows:
        is_good = worst <= limit  # NaN fails here
        failed += not is_good
        verdict = "ok " if is_good else "BAD"
        print(f"{verdict}  {name:<46} {worst:8.1e} {unit:<3} (limit {limit:.0e})  {remark}")
    print(f"judged: {len(rows) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
