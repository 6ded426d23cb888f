"""Judges calibrations without measured poses: `judge.py COMMAND --ten | --seeds FIRST COUNT [--only PART] | --record NAME [--keep FOLDER]`.

Records are made here, by own kinematics and seeds. `COMMAND identify` calibrates each as users do, and its optimum is judged by the one to which an elimination in SciPy leads
from the truth: equal, or told as not to be trusted. Exit code 1 when a wrong optimum is trusted, or less than 99 % are equal.
"""

import os

# small matrices: threads would only wait for each other
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import collections
import concurrent.futures
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile
import time
import tomllib

import numpy
import scipy
from scipy.spatial.transform import Rotation

from elimination import Machine, Poses, by_all_unknowns, eliminated, lengths
from records import NOISE, Record, grid, made, written

# Relative difference of squares of noisy lengths, and difference for exact ones (m2).
RELATIVE, ABSOLUTE = 1e-6, 1e-12
# Least share of records with the right optimum.
SHARE = 0.99
TRUSTED = ("converged", "converged-with-caution")
RIGHT = ("equal", "lower", "doubted")
VERDICTS = (*RIGHT, "told", "WRONG")
MEANING = {
    "equal": "the same optimum, trusted",
    "lower": "a better optimum, trusted",
    "doubted": "the same or a better optimum, not trusted",
    "told": "another optimum, told as not trusted",
    "WRONG": "another optimum, trusted; or no answer",
}
# One record of every angle, of all that is free, of all numbers of samples, exact and noisy.
TEN = (
    "simulator/20/frame-anchor/301/exact/1",
    "simulator/35/frame-anchor/101/exact/2",
    "simulator/5/frame-anchor,length-offset/41/off/3",
    "simulator/25/frame-anchor,platform-anchor/41/off/4",
    "simulator/15/frame-anchor/41/noisy/5",
    "simulator/10/frame-anchor,length-offset/101/noisy/6",
    "simulator/35/frame-anchor,length-offset/301/noisy/7",
    "simulator/20/frame-anchor,platform-anchor/41/noisy/8",
    "suspended-low/14/length-offset/40/noisy/9",
    "cogiro/14/length-offset/40/noisy/10",
)
# The record on which the elimination itself is judged, and its limit.
ALL_UNKNOWNS, OWN = "cogiro/14/length-offset/40/noisy/10", 1e-10


@dataclasses.dataclass
class Judged:
    """A record, the verdict, and the words of a line."""

    record: Record
    verdict: str
    words: str
    seconds: float


def identified(command, record, folder):
    """Exit code, answer and talk of the command; its files are in the folder."""
    _, _, recorded, text = made(record)
    robot, data = folder / "robot.toml", folder / "lengths.csv"
    robot.write_text(text, encoding="utf-8")
    data.write_text(written(recorded), encoding="utf-8")
    words = [command, "identify", robot, data, "--free", record.free, "--format", "json"]
    # the accuracy is stated with every second record that has one
    if record.is_noisy() and record.seed % 2 == 0:
        words += ["--sigma", f"length_m={NOISE}"]
    words += ["--threads", "1"]
    done = subprocess.run(words, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
    (folder / "command.txt").write_text(" ".join(map(str, words)) + "\n", encoding="utf-8")
    (folder / "answer.json").write_text(done.stdout, encoding="utf-8")
    return done.returncode, json.loads(done.stdout) if done.stdout.startswith("{") else None, done.stderr


def squares_of(answer, text, recorded):
    """Squares (m2) at the anchors, offsets and poses that an answer tells, by our own kinematics; what it does not tell stays as in the robot file."""
    told = {estimate["name"]: estimate["value"] for estimate in answer["parameters"]}
    platform, offsets = [], []
    for number, cable in enumerate(tomllib.loads(text)["cable"], 1):
        offsets.append(told.get(f"length-offset[{number}]", 0.0))
        axes = zip("xyz", cable["platform_anchor_m"])
        platform.append([told.get(f"platform-anchor[{number}].{axis}", value) for axis, value in axes])
    positions = numpy.array([pose["position_m"] for pose in answer["poses"]])
    rotations = Rotation.from_quat([pose["quaternion_xyzw"] for pose in answer["poses"]]).as_matrix()
    machine = Machine(answer["frame_anchors_m"], platform, offsets, ())
    return ((lengths(machine, Poses(positions, rotations)) - recorded) ** 2).sum()


def is_same(one, other, is_noisy):
    return abs(one - other) <= max(ABSOLUTE, RELATIVE * other if is_noisy else 0.0)


def judged(command, name, keep):
    """The verdict on one record."""
    record = Record.of(name)
    machine, poses, recorded, text = made(record)
    _, _, least, is_settled = eliminated(machine, poses, recorded)
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(keep or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        start = time.monotonic()
        code, answer, talk = identified(command, record, folder)
        seconds = time.monotonic() - start
    if answer is None or "cost_m2" not in answer:
        return Judged(record, "WRONG", f"exit code {code}: {talk.strip()[:300]}", seconds)
    found, status = answer["cost_m2"], answer["status"]
    is_trusted = status in TRUSTED and answer.get("trusted", True)
    words = f"{1e6 * found:.6g} mm2, right {1e6 * least:.6g}; {status}, exit code {code}"
    if not is_settled:
        return Judged(record, "WRONG", f"{words}; the judge itself did not settle", seconds)
    if (code == 0) != is_trusted:
        return Judged(record, "WRONG", f"{words}; the exit code does not follow trust", seconds)
    own = squares_of(answer, text, recorded)
    if not is_same(own, found, record.is_noisy()):
        return Judged(record, "WRONG", f"{words}; at the anchors and poses told it is {1e6 * own:.6g}", seconds)
    is_equal = is_same(found, least, record.is_noisy())
    if is_equal or found < least:
        return Judged(record, ("equal" if is_equal else "lower") if is_trusted else "doubted", words, seconds)
    return Judged(record, "WRONG" if is_trusted else "told", words, seconds)


def all_judged(command, names, keep):
    """Verdicts in the order of the names, as many at once as there are processors."""
    if len(names) == 1:
        yield judged(command, names[0], keep)
        return
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        yield from pool.map(lambda name: judged(command, name, None), names)


def doubts_about_the_judge():
    """The relative difference between the elimination and SciPy's method over all unknowns at once."""
    machine, poses, recorded, _ = made(Record.of(ALL_UNKNOWNS))
    least = eliminated(machine, poses, recorded)[2]
    return abs(by_all_unknowns(machine, poses, recorded) - least) / least


def table(found):
    """Counts of verdicts by what is free, and by how far the platform turns."""
    groups = (
        lambda record: f"{record.site}, {record.free}, {record.samples} samples, {record.kind}",
        lambda record: f"{record.site}, turned by up to {record.angle} deg",
    )
    for group in groups:
        rows = collections.defaultdict(collections.Counter)
        for one in found:
            rows[group(one.record)][one.verdict] += 1
        yield f"{'':<70}" + "".join(f"{verdict:>9}" for verdict in VERDICTS)
        for name, counts in rows.items():
            yield f"{name:<70}" + "".join(f"{counts[verdict] or '.':>9}" for verdict in VERDICTS)


def line(is_good, words):
    """A line of the verdicts."""
    print(f"{'ok ' if is_good else 'BAD'}  {words}", flush=True)


def names_of(wishes):
    """The records that are asked for."""
    if wishes.seeds is None:
        return list(TEN) if wishes.ten else [wishes.record]
    first, count = wishes.seeds
    names = (str(record) for seed in range(first, first + count) for record in grid(seed))
    return [name for name in names if wishes.only in name]


def asked():
    """Words of the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("command", help="the command `cdpr` that is judged")
    chosen = parser.add_mutually_exclusive_group(required=True)
    chosen.add_argument("--ten", action="store_true", help="the ten records of the tests")
    chosen.add_argument("--seeds", nargs=2, type=int, metavar=("FIRST", "COUNT"), help="the whole grid of these seeds")
    chosen.add_argument("--record", help="one record")
    parser.add_argument("--only", default="", help="of the grid, records whose names hold this")
    parser.add_argument("--keep", help="folder for the files of one record")
    return parser.parse_args()


def main():
    wishes = asked()
    command, names = pathlib.Path(wishes.command).resolve(), names_of(wishes)
    print(f"SciPy {scipy.__version__}, {len(names)} records without poses")
    start, found = time.monotonic(), []
    for one in all_judged(command, names, wishes.keep):
        found.append(one)
        if wishes.seeds is None or one.verdict == "WRONG":
            line(one.verdict != "WRONG", f"{one.verdict:<8}{str(one.record):<56} {one.words}  ({one.seconds:.2f} s)")
    if wishes.seeds:
        print("\n".join(table(found)))
    counts = collections.Counter(one.verdict for one in found)
    for verdict in VERDICTS:
        print(f"{verdict:<8}{counts[verdict]:>6}  {100 * counts[verdict] / len(found):6.2f} %  {MEANING[verdict]}")
    print(f"{time.monotonic() - start:.0f} s; one again: --record NAME --keep FOLDER")
    own = doubts_about_the_judge()
    share = sum(counts[verdict] for verdict in RIGHT) / len(found)
    line(own < OWN, f"elimination against all unknowns at once: {own:.1e} (limit {OWN:.0e})")
    line(share >= SHARE, f"{100 * share:.2f} % have the right optimum (at least {100 * SHARE:.0f} %)")
    failed = counts["WRONG"] + (own >= OWN) + (share < SHARE)
    print(f"judged: {len(found) + 2 - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
