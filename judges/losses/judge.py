"""Judges robust calibrations by SciPy's least_squares: `judge.py CASES.json`; exit code 1 when a figure is beyond its limit.

SciPy's own `huber` and `cauchy`, of the sum of a sample's squared residuals instead of single ones, at our scale and from the same
start, by its trust-region method with an analytic Jacobian.
"""

import json
import sys

import numpy
import scipy
from scipy.optimize import least_squares
from scipy.optimize._lsq.least_squares import IMPLEMENTED_LOSSES

# Relative difference of parameters and of the loss at the optimum.
RELATIVE = 1e-6


def grouped(name, rows):
    """SciPy's loss of the summed squares of every `rows` residuals in succession."""

    def loss(squares):
        sums = squares.reshape(-1, rows).sum(axis=1)
        of_group = numpy.empty((3, sums.size))
        IMPLEMENTED_LOSSES[name](sums, of_group, False)
        rho = numpy.repeat(of_group, rows, axis=1)
        # a group's loss is counted once; without second derivatives the steps are those of reweighting, the gradient is exact
        rho[0] /= rows
        rho[2] = 0
        return rho

    return loss


def solve(case):
    """Anchors and loss at SciPy's optimum."""
    positions, rotations = numpy.array(case["positions"]), numpy.array(case["rotations"])
    lengths = numpy.array(case["lengths"])
    samples, cables = lengths.shape

    def vectors(anchors):
        frame, platform = anchors.reshape(cables, 2, 3).transpose(1, 0, 2)
        return frame - positions[:, None] - numpy.einsum("sij,cj->sci", rotations, platform)

    def residuals(anchors):
        return ((numpy.linalg.norm(vectors(anchors), axis=2) - lengths) / case["sigma_m"]).ravel()

    def jacobian(anchors):
        direction = vectors(anchors)
        direction /= numpy.linalg.norm(direction, axis=2, keepdims=True) * case["sigma_m"]
        matrix = numpy.zeros((samples, cables, cables, 6))
        for cable in range(cables):
            matrix[:, cable, cable, :3] = direction[:, cable]
            matrix[:, cable, cable, 3:] = -numpy.einsum("si,sij->sj", direction[:, cable], rotations)
        return matrix.reshape(samples * cables, cables * 6)

    start = numpy.array(case["start"]).ravel()
    found = least_squares(
        residuals,
        start,
        jac=jacobian,
        loss=grouped(case["loss"], cables),
        f_scale=case["threshold"],
        x_scale="jac",
        xtol=1e-15,
        ftol=1e-15,
        gtol=1e-12,
        max_nfev=500,
    )
    return found.x, 2 * found.cost


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        cases = json.load(file)["cases"]
    print(f"SciPy {scipy.__version__}, {len(cases)} robust calibrations of 48 anchors")
    failed, judged = 0, 0
    for case in cases:
        anchors, cost = solve(case)
        ours = numpy.array(case["found"]).ravel()
        words = f"{case['loss']}, {'stated' if case['stated'] else 'unknown'} accuracy"
        for name, figure in [
            ("anchors", numpy.abs(ours - anchors).max() / numpy.abs(anchors).max()),
            ("loss", abs(case["cost"] - cost) / cost),
        ]:
            is_good = figure <= RELATIVE
            judged += 1
            failed += not is_good
            print(f"{'ok ' if is_good else 'BAD'}  {words + ': ' + name:<52} {figure:8.1e}     (limit {RELATIVE:.1e})")
    print(f"judged: {judged - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
