"""Judges optima by SciPy: `judge.py CASES.json`; exit code 1 when a figure is beyond its limit.

Least largest errors are found by sequential quadratic programming (SLSQP) with one bound over the squared errors of all samples, the
recorded poses being sought anew by Newton's method for all anchors that are tried; fits within bounds by SciPy's own trust-region method.
"""

import json
import os
import sys

# small matrices: threads would only wait for each other
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy
import scipy
from scipy.optimize import least_squares, minimize

# Relative difference of costs, and of parameters in metres over the size of the largest.
RELATIVE = 1e-6
# Metres to millimetres, the unit of SLSQP's variables and errors.
MILLI = 1e3


def lengths_of(frame, platform, positions, rotations):
    """Straight cables: from frame anchors to platform anchors, for all poses."""
    ends = positions[:, None] + numpy.einsum("sij,cj->sci", rotations, platform)
    away = frame - ends
    return numpy.linalg.norm(away, axis=2), away


def length_errors(case):
    """Errors of lengths (mm) by changes of frame anchors (mm), and their derivatives: functions of the changes."""
    anchors, axes = numpy.array(case["start"]["anchors"]), 3
    positions, rotations = numpy.array(case["positions"]), numpy.array(case["rotations"])
    recorded = numpy.array(case["lengths"])
    cables = len(anchors)

    def errors(changes):
        frame = anchors[:, 0] + changes.reshape(cables, axes) / MILLI
        lengths, away = lengths_of(frame, anchors[:, 1], positions, rotations)
        derivatives = numpy.zeros((len(positions), cables, cables, axes))
        for cable in range(cables):
            derivatives[:, cable, cable] = away[:, cable] / lengths[:, cable, None]
        return MILLI * (lengths - recorded), derivatives.reshape(len(positions), cables, -1)

    return errors, cables * axes


def pose_errors(case):
    """Errors of the planar positions (mm) at which the recorded lengths fit best, by changes of frame anchors in the plane (mm)."""
    anchors = numpy.array(case["start"]["anchors"])[:, 0, :2]
    positions, recorded = numpy.array(case["positions"])[:, :2], numpy.array(case["lengths"])
    cables = len(anchors)

    def best(frame):
        found = positions.copy()
        for _ in range(50):
            away = frame - found[:, None]
            lengths = numpy.linalg.norm(away, axis=2)
            unit, misfit = away / lengths[..., None], lengths - recorded
            gradient = -numpy.einsum("sc,sci->si", misfit, unit)
            # misfit and its bend: Newton's matrix of half the squares
            outer = numpy.einsum("sci,scj->scij", unit, unit)
            weight = 1 - misfit / lengths
            second = numpy.einsum("sc,scij->sij", weight, outer) + numpy.einsum("sc,ij->sij", misfit / lengths, numpy.eye(2))
            step = numpy.linalg.solve(second, -gradient[..., None])[..., 0]
            found += step
            if numpy.abs(step).max() < 1e-14:
                break
        # by the anchors at the best place, where the gradient stays zero
        mixed = -numpy.einsum("sc,scij->scij", weight, outer) - numpy.einsum("sc,ij->scij", misfit / lengths, numpy.eye(2))
        moved = numpy.linalg.solve(second[:, None], -mixed)
        return found, moved.transpose(0, 2, 1, 3).reshape(len(positions), 2, -1)

    def errors(changes):
        found, derivatives = best(anchors + changes.reshape(cables, 2) / MILLI)
        return MILLI * (found - positions), derivatives

    return errors, cables * 2


def least_largest(errors, count):
    """The least largest norm of all samples (mm), from zero changes."""
    last = {}

    def at(changes):
        if last.get("changes") is None or not numpy.array_equal(last["changes"], changes):
            last["changes"], (last["errors"], last["derivatives"]) = changes.copy(), errors(changes)
        return last["errors"], last["derivatives"]

    def room(variables):
        return variables[-1] - (at(variables[:-1])[0] ** 2).sum(axis=1)

    def by_room(variables):
        values, derivatives = at(variables[:-1])
        slopes = -2 * numpy.einsum("sk,skp->sp", values, derivatives)
        return numpy.hstack([slopes, numpy.ones((len(slopes), 1))])

    variables = numpy.zeros(count + 1)
    variables[-1] = (errors(variables[:-1])[0] ** 2).sum(axis=1).max()
    slope = numpy.zeros(count + 1)
    slope[-1] = 1
    # once more from where it stopped: the quasi-Newton matrix begins anew
    for _ in range(6):
        found = minimize(
            lambda v: v[-1],
            variables,
            jac=lambda v: slope,
            method="SLSQP",
            constraints={"type": "ineq", "fun": room, "jac": by_room},
            options={"ftol": 1e-16, "maxiter": 2000},
        )
        before, variables = variables[-1], found.x
        variables[-1] = (errors(variables[:-1])[0] ** 2).sum(axis=1).max()
        if before - variables[-1] < 1e-9 * before:
            break
    return numpy.sqrt(variables[-1])


def pulley_fit(case):
    """Frame anchors and pulley radii from 0 on (m), and the squares of the length errors, cable by cable."""
    anchors, radii = numpy.array(case["start"]["anchors"]), case["start"]["radii"]
    found, cost = [], 0.0
    for cable, (anchor, radius) in enumerate(zip(anchors, radii)):
        one = least_squares(
            lambda values, cable=cable: errors_of(case, values, cable),
            [*anchor[0], radius],
            jac="3-point",
            bounds=([-numpy.inf] * 3 + [0.0], numpy.inf),
            method="trf",
            xtol=1e-15,
            ftol=1e-15,
            gtol=1e-13,
            max_nfev=2000,
        )
        found.append(one.x)
        cost += 2 * one.cost
    return numpy.array(found), cost


def errors_of(case, values, cable):
    """Length errors of one cable (mm): its pulley swivels about the vertical through its entry, and the cable leaves it on a tangent."""
    positions, rotations = numpy.array(case["positions"]), numpy.array(case["rotations"])
    ends = positions + rotations @ numpy.array(case["start"]["anchors"])[cable, 1]
    away, radius = ends - values[:3], values[3]
    beside, along = numpy.hypot(away[:, 0], away[:, 1]) - radius, away[:, 2]
    straight = numpy.sqrt(beside**2 + along**2 - radius**2)
    wrap = numpy.arctan2(beside, along) + numpy.arctan2(radius, straight)
    return MILLI * (radius * wrap + straight - numpy.array(case["lengths"])[:, cable])


def figures(case):
    """Names and figures to judge."""
    if case["name"] == "radii within bounds":
        theirs, cost = pulley_fit(case)
        ours = numpy.array([[*anchor[0], radius] for anchor, radius in zip(case["found"]["anchors"], case["found"]["radii"])])
        at_bound = int((ours[:, 3] == 0).sum())
        of_ours = sum((errors_of(case, values, cable) ** 2).sum() for cable, values in enumerate(ours))
        yield f"cost, {at_bound} radii at the bound", abs(of_ours - cost) / cost
        yield "parameters", numpy.abs(ours - theirs).max() / numpy.abs(theirs).max()
        # a bound that no radius reaches would judge nothing
        yield "no radius at the bound", 0.0 if at_bound > 0 else 1.0
        return
    errors, count = pose_errors(case) if case["name"] == "largest pose" else length_errors(case)
    theirs, ours = least_largest(errors, count), MILLI * case["largest"]
    yield "least largest error", abs(ours - theirs) / theirs


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        cases = json.load(file)["cases"]
    print(f"SciPy {scipy.__version__}, {len(cases)} optima")
    failed, judged = 0, 0
    for case in cases:
        for name, figure in figures(case):
            is_good = bool(figure <= RELATIVE)
            judged += 1
            failed += not is_good
            print(f"{'ok ' if is_good else 'BAD'}  {case['name'] + ': ' + name:<52} {figure:8.1e}     (limit {RELATIVE:.1e})")
    print(f"judged: {judged - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
