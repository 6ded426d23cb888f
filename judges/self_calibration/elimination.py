"""The least sum of squared length residuals over anchors and offsets, the poses eliminated sample by sample.

Own kinematics of straight cables: length = |a - p - R b| + o. Every step solves the linear problem of all unknowns at once: what the
pose of a sample explains is taken out of its rows by a QR decomposition, the rest of all samples is solved for the parameters (least
norm: nothing of the motions that change no length), and the poses follow. Steps are damped as by Levenberg and Marquardt.
"""

import numpy
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

# Relative size of a singular value that is none: motions of everything as a whole.
NONE = 1e-10
# Relative decrease of the squares that the next step promises where the search ends, and squares of a length that are rounding (m2).
SETTLED = 1e-12
ROUNDING = 1e-26
STEPS = 3000


class Machine:
    """Frame anchors, platform anchors and offsets of all cables, and which of them are free."""

    def __init__(self, frame, platform, offsets, free):
        self.frame, self.platform, self.offsets = (numpy.array(part, dtype=float) for part in (frame, platform, offsets))
        self.free = tuple(free)

    def moved(self, step):
        """The machine a step of the free parameters away, cable by cable in columns."""
        changed, first = {}, 0
        for name, values in (("frame-anchor", self.frame), ("platform-anchor", self.platform), ("length-offset", self.offsets)):
            width = 1 if values.ndim == 1 else 3
            if name in self.free:
                changed[name] = values + step[:, first : first + width].reshape(values.shape)
                first += width
            else:
                changed[name] = values
        return Machine(*changed.values(), self.free)


class Poses:
    """Positions and rotations of all samples."""

    def __init__(self, positions, rotations):
        self.positions, self.rotations = positions, rotations

    def moved(self, steps):
        """Positions shifted, rotations turned from the left."""
        turned = Rotation.from_rotvec(steps[:, 3:]).as_matrix() @ self.rotations
        return Poses(self.positions + steps[:, :3], turned)


def lengths(machine, poses):
    """Lengths of all cables at all poses (m)."""
    ends = poses.positions[:, None] + numpy.einsum("sij,cj->sci", poses.rotations, machine.platform)
    return numpy.linalg.norm(machine.frame - ends, axis=2) + machine.offsets


def linearised(machine, poses, recorded):
    """Residuals, and their derivatives by the poses (sample, cable, 6) and by the free parameters of each cable (sample, cable, k)."""
    arms = numpy.einsum("sij,cj->sci", poses.rotations, machine.platform)
    away = machine.frame - poses.positions[:, None] - arms
    straight = numpy.linalg.norm(away, axis=2)
    unit = away / straight[..., None]
    by_pose = -numpy.concatenate([unit, numpy.cross(arms, unit)], axis=2)
    parts = {
        "frame-anchor": unit,
        "platform-anchor": -numpy.einsum("sij,sci->scj", poses.rotations, unit),
        "length-offset": numpy.ones((*straight.shape, 1)),
    }
    by_parameter = numpy.concatenate([parts[name] for name in parts if name in machine.free], axis=2)
    return straight + machine.offsets - recorded, by_pose, by_parameter


class Reduced:
    """The linear problem without the poses."""

    def __init__(self, machine, poses, recorded):
        self.residuals, by_pose, self.by_parameter = linearised(machine, poses, recorded)
        samples, cables, self.width = self.by_parameter.shape
        q, r = numpy.linalg.qr(by_pose, mode="complete")
        self.explained, self.upper, rest = q[..., :6], r[:, :6], q[..., 6:]
        rows = numpy.einsum("sck,scp->skcp", rest, self.by_parameter)
        matrix = rows.reshape(-1, cables * self.width)
        self.left = numpy.einsum("sck,sc->sk", rest, self.residuals).ravel()
        self.u, self.sizes, self.vt = numpy.linalg.svd(matrix, full_matrices=False)
        self.pull = self.u.T @ self.left
        self.kept = self.sizes > NONE * self.sizes[0]
        self.square = (self.residuals**2).sum()

    def step(self, damping):
        """Steps of parameters and poses, and the squares that they take away if all were linear."""
        along = numpy.where(self.kept, self.sizes / (self.sizes**2 + (damping * self.sizes[0]) ** 2), 0.0) * self.pull
        parameters = -(self.vt.T @ along).reshape(-1, self.width)
        moved = self.residuals + numpy.einsum("scp,cp->sc", self.by_parameter, parameters)
        poses = -numpy.linalg.solve(self.upper, numpy.einsum("sck,sc->sk", self.explained, moved)[..., None])[..., 0]
        ends = moved + numpy.einsum("sck,skl,sl->sc", self.explained, self.upper, poses)
        return parameters, poses, self.square - (ends**2).sum()


def eliminated(machine, poses, recorded):
    """Machine, poses and squares (m2) at the optimum that is reached from here, and whether it settled."""
    here, damping = Reduced(machine, poses, recorded), 0.0
    for _ in range(STEPS):
        if here.step(0.0)[2] <= SETTLED * here.square or here.square <= ROUNDING * recorded.size:
            return machine, poses, here.square, True
        parameters, steps, promised = here.step(damping)
        trial = machine.moved(parameters), poses.moved(steps)
        square = ((lengths(*trial) - recorded) ** 2).sum()
        if here.square - square > 1e-4 * promised:
            machine, poses = trial
            here = Reduced(machine, poses, recorded)
            damping = 0.3 * damping if damping > 1e-8 else 0.0
        elif damping < 1e8:
            damping = max(1e-7, 4.0 * damping)
        else:
            break
    return machine, poses, here.square, here.step(0.0)[2] <= 1e-10 * here.square


def by_all_unknowns(machine, poses, recorded):
    """The same squares by SciPy's own method over all unknowns at once."""
    samples, cables = recorded.shape
    width = linearised(machine, poses, recorded)[2].shape[2]

    def at(values):
        return machine.moved(values[: cables * width].reshape(cables, width)), poses.moved(values[cables * width :].reshape(samples, 6))

    def errors(values):
        return (lengths(*at(values)) - recorded).ravel()

    start = numpy.zeros(cables * width + 6 * samples)
    return 2 * least_squares(errors, start, jac="3-point", method="trf", x_scale="jac", xtol=1e-14, ftol=1e-14, gtol=1e-14).cost
