"""Judges dry friction in motion by an integration from event to event: `judge.py COMMAND ROBOT.toml`; exit code 1 when a figure is above its limit.

The equations are those of the book (Machines in time), written anew about the platform origin with velocities and a quaternion. SciPy's DOP853 moves
them between events, which it finds to rounding: a cable goes slack or taut, a drum comes to rest or begins to turn. A drum that stands has speed
exactly 0.
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import numpy
from scipy.integrate import solve_ivp

# Allowed deviations over the whole motion at steps of 1 ms, and of a run with error control.
POSITION_M = 1e-7
TENSION_N = 1e-2
# By how much the error falls when the step is halved, unless it is as small as the reference is exact.
FALL = 8.0
EXACT_M = 2e-11
# Largest step of the reference (s): a drum does not stick and slide within it unseen.
LARGEST = 1e-3

# What a margin may be below 0 (rad/s, N·m, N): what has just switched begins at 0, to rounding, and would switch back at once.
SLACK = 1e-10

LET_GO = """
[machine]
robot = "{robot}"
model = "elastic"
winches = "drums"
[start]
pose = [0, 0, 1.5, 0, 0, 0]
tensions_N = [3678, 2169, 4250, 1708, 3985, 2394, 4715, 1684]
displacement = [0.02, 0, 0, 0, 0.02, 0]
[control]
kind = "torques"
[time]
duration_s = 2.0
record_s = 0.01
"""

WRENCH_STEP = """
[machine]
robot = "{robot}"
model = "pulley+elastic"
winches = "drums"
[start]
pose = [0, 0, 1.5, 0, 0, 0]
tensions_N = [3678, 2169, 4250, 1708, 3985, 2394, 4715, 1684]
[control]
kind = "torques"
[[event]]
time_s = 0.5
kind = "wrench"
wrench = [1500, -300, 200, 50, 80, -40]
[time]
duration_s = 1.5
record_s = 0.01
"""

PULLEY_KEYS = {
    "drum_inertia_kg_m2": 0.5,
    "drum_coulomb_friction_Nm": 10.0,
    "drum_static_friction_Nm": 16.0,
    "drum_viscous_friction_Nm_s_per_rad": 5.0,
    "drum_stribeck_speed_rad_per_s": 0.05,
    "pulley_friction": 0.01,
    "pulley_inertia_kg_m2": 0.2,
}


def matrix(quaternion):
    """Rotation matrix of a quaternion x, y, z, w."""
    x, y, z, w = quaternion / numpy.linalg.norm(quaternion)
    return numpy.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])


def cross(v):
    """[v]×."""
    return numpy.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


class Machine:
    """A machine on drums, of a robot file."""

    def __init__(self, robot, with_pulleys):
        cables = [robot.get("cable_defaults", {}) | cable for cable in robot["cable"]]
        row = lambda key, default=0.0: numpy.array([float(cable.get(key, default)) for cable in cables])
        self.frame = numpy.array([cable["frame_anchor_m"] for cable in cables])
        self.anchors = numpy.array([cable["platform_anchor_m"] for cable in cables])
        self.stiffness, self.damping_time = row("axial_stiffness_EA_N"), row("cable_damping_time_s")
        self.radius, self.viscous = row("drum_radius_m"), row("drum_viscous_friction_Nm_s_per_rad")
        self.sliding = row("drum_coulomb_friction_Nm")
        self.standing = numpy.where(row("drum_static_friction_Nm") > 0, row("drum_static_friction_Nm"), self.sliding)
        self.stribeck = row("drum_stribeck_speed_rad_per_s", 1.0)
        self.inertia, self.friction = row("drum_inertia_kg_m2"), numpy.zeros(len(cables))
        self.pulleys = with_pulleys
        if with_pulleys:
            self.pulley = row("pulley_radius_m")
            self.axis = numpy.array([cable["pulley_swivel_axis"] for cable in cables])
            self.inertia = self.inertia + row("pulley_inertia_kg_m2") * (self.radius / self.pulley) ** 2
            self.friction = row("pulley_friction")
        platform = robot["platform"]
        self.mass, self.center = platform["mass_kg"], numpy.array(platform["center_of_mass_m"])
        self.body_inertia = numpy.array(platform["inertia_about_center_of_mass_kg_m2"])
        self.gravity = numpy.array(robot["gravity_m_s2"])
        self.wrench = numpy.zeros(6)

    def paths(self, position, rotation):
        """Lengths, unit vectors from the platform anchors into the cables, arms, wrap angles."""
        arms = self.anchors @ rotation.T
        reach = position + arms - self.frame
        if not self.pulleys:
            length = numpy.linalg.norm(reach, axis=1)
            return length, -reach / length[:, None], arms, numpy.zeros(len(length))
        along = numpy.sum(reach * self.axis, axis=1)
        across = reach - along[:, None] * self.axis
        distance = numpy.linalg.norm(across, axis=1)
        outward = across / distance[:, None]
        free = numpy.sqrt((distance - self.pulley) ** 2 + along**2 - self.pulley**2)
        wrap = numpy.angle((free + 1j * self.pulley) * (along + 1j * (distance - self.pulley))) % (2 * numpy.pi)
        contact = (
            self.frame
            + (self.pulley * (1 - numpy.cos(wrap)))[:, None] * outward
            + (self.pulley * numpy.sin(wrap))[:, None] * self.axis
        )
        return free + self.pulley * wrap, (contact - position - arms) / free[:, None], arms, wrap

    def start(self, position, quaternion, lengths):
        """Numbers of a machine at rest: pose, twist, turns of the drums from the lengths on, speeds of the drums."""
        self.lengths = lengths
        return numpy.concatenate([position, quaternion, numpy.zeros(6 + 2 * len(lengths))])

    def laws(self, numbers):
        """Structure, and tension of law and damper together before clipping."""
        count = len(self.lengths)
        rotation = matrix(numbers[3:7])
        length, direction, arms, wrap = self.paths(numbers[:3], rotation)
        columns = numpy.hstack([direction, numpy.cross(arms, direction)])
        unstrained = self.lengths + self.radius * numbers[13 : 13 + count]
        tension = self.stiffness * (1 - unstrained / length)
        slope = self.stiffness * unstrained / length**2
        rate = -columns @ numbers[7:13] - self.radius * numbers[13 + count :]
        return rotation, columns, wrap, tension + self.damping_time * slope * rate

    def rates(self, numbers, mode, taut):
        """Derivatives of the numbers. Mode of a drum: 0 stands, 1 pays out, −1 reels in; taut cables pull by their law."""
        count = len(self.lengths)
        rotation, columns, wrap, unclipped = self.laws(numbers)
        tension = numpy.where(taut, unclipped, 0.0)
        velocity, omega, speed = numbers[7:10], numbers[10:13], numbers[13 + count :]
        arm = rotation @ self.center
        turned = rotation @ self.body_inertia @ rotation.T
        weight = self.mass * self.gravity
        wrench = columns.T @ tension + self.wrench + numpy.concatenate([weight, numpy.cross(arm, weight)])
        swing = self.mass * numpy.cross(omega, numpy.cross(omega, arm))
        rest = wrench - numpy.concatenate([swing, numpy.cross(omega, turned @ omega) + numpy.cross(arm, swing)])
        mass = numpy.zeros((6, 6))
        mass[:3, :3] = self.mass * numpy.eye(3)
        mass[:3, 3:] = -self.mass * cross(arm)
        mass[3:, :3] = self.mass * cross(arm)
        mass[3:, 3:] = turned - self.mass * cross(arm) @ cross(arm)
        x, y, z, w = numbers[3:7]
        a, b, c = omega
        turn = 0.5 * numpy.array([
            a * w + b * z - c * y,
            b * w + c * x - a * z,
            c * w + a * y - b * x,
            -(a * x + b * y + c * z),
        ])
        dry = self.sliding + (self.standing - self.sliding) * numpy.exp(-((speed / self.stribeck) ** 2))
        pull = self.radius * tension * numpy.exp(-self.friction * wrap * mode)
        driven = pull - self.torque - mode * dry - self.viscous * speed
        return numpy.concatenate([
            velocity, turn, numpy.linalg.solve(mass, rest), numpy.where(mode == 0, 0.0, speed),
            numpy.where(mode == 0, 0.0, driven / self.inertia),
        ])

    def ends(self, unclipped, wrap):
        """Torques that are missing for each drum to pay out and to reel in."""
        pull, hold = self.radius * numpy.maximum(unclipped, 0.0), numpy.exp(self.friction * wrap)
        return self.standing - pull / hold + self.torque, pull * hold - self.torque + self.standing

    def margins(self, numbers, mode, taut):
        """What is left until each drum switches, and until each cable goes slack or taut."""
        _, _, wrap, unclipped = self.laws(numbers)
        out, back = self.ends(unclipped, wrap)
        drums = numpy.where(mode == 0, numpy.minimum(out, back), mode * numbers[13 + len(self.lengths) :])
        return numpy.concatenate([drums, numpy.where(taut, unclipped, -unclipped)]) + SLACK

    def settled(self, numbers, mode, drums):
        """Numbers and modes after the margins of these drums are used up; their speeds become 0."""
        numbers, mode, count = numbers.copy(), mode.copy(), len(self.lengths)
        for drum in drums:
            numbers[13 + count + drum] = 0.0
        _, _, wrap, unclipped = self.laws(numbers)
        out, back = self.ends(unclipped, wrap)
        for drum in drums:
            if mode[drum] == 0:
                mode[drum] = 1 if out[drum] < back[drum] else -1
            else:
                mode[drum] = 1 if out[drum] < 0 else -1 if back[drum] < 0 else 0
        return numbers, mode


def passed(machine, numbers, mode, times, switches):
    """States at ascending times, the first of which is the present, and the last modes; notes the times of switches."""
    states, now, count = [numbers], times[0], len(machine.lengths)
    taut = machine.laws(numbers)[3] > 0
    for until in times[1:]:
        while now < until:
            cache = {}

            def margin(y, k):
                key = y.tobytes()
                if key not in cache:
                    cache.clear()
                    cache[key] = machine.margins(y, mode, taut)
                return cache[key][k]

            # one event each: what has just switched begins at 0, and may hide nothing else
            events = [lambda t, y, k=k: margin(y, k) for k in range(2 * count)]
            for event in events:
                event.terminal, event.direction = True, -1
            found = solve_ivp(
                lambda t, y: machine.rates(y, mode, taut), (now, until), numbers, "DOP853", rtol=1e-12, atol=1e-13,
                max_step=LARGEST, events=events,
            )
            assert found.success, found.message
            now, numbers = found.t[-1], found.y[:, -1]
            if found.status == 1:
                used = [k for k in range(2 * count) if len(found.t_events[k])]
                taut[[k - count for k in used if k >= count]] ^= True
                drums = [k for k in used if k < count]
                switches.extend([now] * len(drums))
                numbers, mode = machine.settled(numbers, mode, drums)
        states.append(numbers)
    return states, mode


def integrated(machine, start, breaks, every, duration):
    """States every so often, and the times of switches; the wrench changes at the breaks."""
    every_drum = range(len(machine.lengths))
    # as if all came to rest at the start
    numbers, mode = machine.settled(start, numpy.ones(len(machine.lengths), dtype=int), every_drum)
    states, switches, now = [numbers], [], 0.0
    for time, wrench in [*breaks, (duration, None)]:
        times = numpy.arange(round(now / every), round(time / every) + 1) * every
        found, mode = passed(machine, states[-1], mode, times, switches)
        states.extend(found[1:])
        now = time
        if wrench is not None:
            machine.wrench = numpy.array(wrench, dtype=float)
    return states, switches


def run(command, folder, scenario, more):
    """Rows of the log of a run."""
    path = folder / "scenario.toml"
    path.write_text(scenario + more)
    words = [command, "run", path, "--out", folder / "run", "--format", "json"]
    answer = subprocess.run(words, capture_output=True, text=True, check=False)
    assert answer.returncode in (0, 1), answer.stderr + answer.stdout
    assert json.loads(answer.stdout)["status"] == "completed", answer.stdout
    with open(folder / "run" / "log.csv") as file:
        return list(csv.DictReader(file))


def compared(machine, states, rows):
    """Largest gaps of position (m) and tension (N)."""
    count, gap = len(machine.lengths), [0.0, 0.0]
    for state, row in zip(states, rows, strict=True):
        position = numpy.array([float(row[f"{axis}_m"]) for axis in "xyz"])
        tensions = numpy.array([float(row[f"tension_N_{k + 1}"]) for k in range(count)])
        expected = numpy.maximum(machine.laws(state)[3], 0.0)
        gap = [max(gap[0], abs(position - state[:3]).max()), max(gap[1], abs(tensions - expected).max())]
    return gap


def judged(name, command, folder, scenario, machine, breaks, duration):
    """Verdicts of one scenario; what cannot be had from the command is taken from its first row: start and lengths."""
    rows = run(command, folder, scenario, "step_s = 0.001\n")
    first = {key: float(value) for key, value in rows[0].items()}
    count = len(machine.frame)
    lengths = numpy.array([first[f"cable_length_m_{k + 1}"] for k in range(count)])
    start = machine.start(
        numpy.array([first[f"{axis}_m"] for axis in "xyz"]), numpy.array([first[f"q{axis}"] for axis in "xyzw"]), lengths
    )
    rest = machine.start(numpy.array([0, 0, 1.5]), numpy.array([0, 0, 0, 1.0]), lengths)
    machine.torque = numpy.zeros(count)
    machine.torque = machine.radius * machine.laws(rest)[3]
    states, switches = integrated(machine, start, breaks, 0.01, duration)
    gaps = {"1 ms": compared(machine, states, rows)}
    gaps["0.5 ms"] = compared(machine, states, run(command, folder, scenario, "step_s = 0.0005\n"))
    controlled = 'integrator = "error-controlled"\ntolerance = 1e-11\n'
    gaps["error control"] = compared(machine, states, run(command, folder, scenario, controlled))
    (coarse, tension), (fine, _) = gaps["1 ms"], gaps["0.5 ms"]
    verdicts = [
        coarse <= POSITION_M and tension <= TENSION_N,
        fine <= max(coarse / FALL, EXACT_M),
        gaps["error control"][0] <= POSITION_M / 10 and gaps["error control"][1] <= TENSION_N / 10,
    ]
    print(f"{name}: {len(switches)} switches in {duration} s")
    for label, (position, force) in gaps.items():
        print(f"  {label:>13}: {position:.1e} m, {force:.1e} N beside the integration from event to event")
    print(f"  halved: the error falls to 1/{coarse / fine:.0f}; {'ok' if all(verdicts) else 'ABOVE THE LIMIT'}")
    return verdicts


def with_keys(text, keys):
    """A robot file with other numbers for all its cables."""
    lines = [line for line in text.splitlines() if line.split(" = ")[0] not in keys]
    added = "\n".join(f"{key} = {value}" for key, value in keys.items())
    return "\n".join(lines).replace("[[cable]]\n", f"[[cable]]\n{added}\n") + "\n"


def main(command, robot):
    verdicts = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        machine = Machine(tomllib.loads(robot.read_text()), False)
        scenario = LET_GO.format(robot=robot.as_posix())
        verdicts += judged("let go, Coulomb", command, folder, scenario, machine, [], 2.0)
        placed, turning = folder / "placed.toml", folder / "turning.toml"
        words = [command, "place-pulleys", robot, "--radius", "0.161", "--axis", "0,0,1", "--out", placed, "--quiet"]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        turning.write_text(with_keys(placed.read_text(), PULLEY_KEYS))
        machine = Machine(tomllib.loads(turning.read_text()), True)
        scenario = WRENCH_STEP.format(robot=turning.as_posix())
        breaks = [(0.5, [1500, -300, 200, 50, 80, -40])]
        verdicts += judged("wrench step, Stribeck and pulleys", command, folder, scenario, machine, breaks, 1.5)
    failed = verdicts.count(False)
    print(f"judged: {len(verdicts) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2]).resolve()))
