"""Records of lengths at poses that nobody measures: machine, poses, lengths, and the robot file that a calibration begins with."""

import dataclasses
import pathlib
import re
import tomllib

import numpy
from scipy.spatial.transform import Rotation

from elimination import Machine, Poses, lengths

ROBOTS = pathlib.Path(__file__).parents[2] / "crates/cdpr-model/robots"
CABLES = 8
# Standard deviations (m): lengths; the file's frame and platform anchors about the machine's, and offsets of its lengths.
NOISE = 0.5e-3
FRAME_OFF, PLATFORM_OFF, OFFSET = 15e-3, 3e-3, 20e-3
ANGLES = (5, 10, 15, 20, 25, 35)
# What is free, and the numbers of samples.
FREE = {
    "frame-anchor": (41, 101, 301),
    "frame-anchor,length-offset": (41, 101, 301),
    "frame-anchor,platform-anchor": (41,),
}
# Lengths and files: exact lengths and the machine's own anchors, exact lengths and a file that is off, noisy lengths and such a file.
KINDS = ("exact", "off", "noisy")


@dataclasses.dataclass(frozen=True)
class Site:
    """A robot, its home, and the box and the largest turn of its records."""

    file: str
    box: tuple
    home: tuple | None = None


# The simulator's box of its published records; two suspended robots, one of them from two homes.
SITES = {
    "simulator": Site("cablerobot-simulator-helicopter-kinematic-calibrated", ((-1.5, -1.5, 1.25), (1.5, 1.5, 2.0))),
    "suspended-low": Site("", ((-1.5, -0.8, 0.6), (1.5, 0.8, 2.4)), (0.9, 0.9, 0.2)),
    "suspended": Site("", ((-1.5, -0.8, 0.6), (1.5, 0.8, 2.4)), (0.0, 0.0, 1.5)),
    "cogiro": Site("cogiro", ((-3.0, -2.0, 1.0), (3.0, 2.0, 3.0))),
}


@dataclasses.dataclass(frozen=True)
class Record:
    """A record and what is free; its name tells all of it."""

    site: str
    angle: int
    free: str
    samples: int
    kind: str
    seed: int

    def __str__(self):
        return "/".join(str(part) for part in dataclasses.astuple(self))

    @classmethod
    def of(cls, name):
        site, angle, free, samples, kind, seed = name.split("/")
        return cls(site, int(angle), free, int(samples), kind, int(seed))

    def is_noisy(self):
        return self.kind == "noisy"

    def generator(self):
        """Random numbers of this record alone."""
        return numpy.random.default_rng([self.seed, *str(self).encode()])


def grid(seed):
    """All records of a seed."""
    for angle in ANGLES:
        for free, counts in FREE.items():
            for samples in counts:
                yield from (Record("simulator", angle, free, samples, kind, seed) for kind in KINDS)
    yield from (Record(site, 14, "length-offset", 40, "noisy", seed) for site in SITES if site != "simulator")


def pairs_at_corners():
    """Text of a suspended robot whose cables begin in pairs at the corners of a frame and end at those of a box."""
    frame = [(x, y, 3.5) for y in (-2.0, 2.0) for x in (-3.5, 3.5) for _ in range(2)]
    platform = [(1, -1, -1), (-1, 1, 1), (-1, -1, 1), (1, 1, -1), (-1, -1, -1), (1, 1, 1), (1, -1, 1), (-1, 1, -1)]
    text = 'layout_version = 1\nname = "pairs"\nmotion_pattern = "3R3T"\ncable_count = 8\n[home_pose]\nposition_m = [0.0, 0.0, 0.0]\n'
    text += "rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\n"
    for number, (start, end) in enumerate(zip(frame, numpy.multiply(platform, (0.6, 0.3, 0.2)).tolist()), 1):
        text += f'[[cable]]\nname = "{number}"\nframe_anchor_m = {list(start)}\nplatform_anchor_m = {end}\n'
    return text


def with_rows(text, key, rows):
    """A robot file with other rows of a key, one of each cable."""
    rows = iter(rows.tolist())
    return re.sub(rf"^{key} = \[.*?\]", lambda _: f"{key} = {next(rows)}", text, flags=re.M)


def made(record):
    """Machine (the parts that the record calls free are), true poses, recorded lengths, and the text of the robot file."""
    site, random = SITES[record.site], record.generator()
    text = (ROBOTS / f"{site.file}.toml").read_text(encoding="utf-8") if site.file else pairs_at_corners()
    if site.home:
        text = re.sub(r"^position_m = \[.*?\]", f"position_m = {list(site.home)}", text, count=1, flags=re.M)
    cables = tomllib.loads(text)["cable"]
    frame, platform = (numpy.array([cable[f"{part}_anchor_m"] for cable in cables]) for part in ("frame", "platform"))
    free = record.free.split(",")
    is_off = record.kind != "exact"
    offsets = OFFSET * random.standard_normal(CABLES) if is_off and "length-offset" in free else numpy.zeros(CABLES)
    machine = Machine(frame, platform, offsets, free)
    turns = numpy.radians(random.uniform(-record.angle, record.angle, (record.samples, 3)))
    positions = random.uniform(*site.box, (record.samples, 3))
    poses = Poses(positions, Rotation.from_euler("XYZ", turns).as_matrix())
    recorded = lengths(machine, poses)
    if record.is_noisy():
        recorded += NOISE * random.standard_normal(recorded.shape)
    if is_off and "frame-anchor" in free:
        text = with_rows(text, "frame_anchor_m", frame + FRAME_OFF * random.standard_normal(frame.shape))
    if is_off and "platform-anchor" in free:
        text = with_rows(text, "platform_anchor_m", platform + PLATFORM_OFF * random.standard_normal(platform.shape))
    return machine, poses, recorded, text


def written(recorded):
    """The record as a measurement file, to the last bit."""
    head = ",".join(f"cable_length_m_{cable}" for cable in range(1, recorded.shape[1] + 1))
    return "\n".join([head, *(",".join(map(repr, row)) for row in recorded.tolist())]) + "\n"
