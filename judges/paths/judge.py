"""Judges paths of a lasso by scikit-learn: `judge.py CASES.json`; exit code 1 when a figure is beyond its limit.

At every penalty the length residuals are linearised at our values, and scikit-learn's coordinate descent finds the least value of that
linear problem: ours is right where it has nothing to change. Parameters without penalty are eliminated by an orthogonal projection.
"""

import json
import sys
import warnings

import numpy
import sklearn
from sklearn.exceptions import ConvergenceWarning
from sklearn.linear_model import Lasso

# Difference of a parameter, relative to the largest change of the path: the descent's own tolerance, times the condition of the anchors.
RELATIVE = 1e-6


def linearised(case, cable, values):
    """Residuals and Jacobian of one cable by (a, b) in standard deviations."""
    positions, rotations = numpy.array(case["positions"]), numpy.array(case["rotations"])
    lengths = numpy.array(case["lengths"])[:, cable]
    along = values[:3] - positions - rotations @ values[3:]
    norm = numpy.linalg.norm(along, axis=1, keepdims=True)
    direction = along / norm
    jacobian = numpy.hstack([direction, -numpy.einsum("si,sij->sj", direction, rotations)])
    return (norm[:, 0] - lengths) / case["sigma_m"], jacobian / case["sigma_m"]


def solve(case, cable, point):
    """Least value of ½‖r + J (p − p̂)‖² + λ Σ |p − c| near our values p̂."""
    own = slice(6 * cable, 6 * cable + 6)
    values, centre = numpy.array(point["values"])[own], numpy.array(case["centre"])[own]
    is_penalised = numpy.array(case["is_penalised"])[own]
    residuals, jacobian = linearised(case, cable, values)
    # in changes u = p − c: r + J (c − p̂) + J u
    target = -(residuals + jacobian @ (centre - values))
    changes = numpy.zeros(6)
    smooth = jacobian[:, ~is_penalised]
    basis = numpy.linalg.qr(smooth)[0]
    project = lambda matrix: matrix - basis @ (basis.T @ matrix)
    matrix, right = project(jacobian[:, is_penalised]), project(target)
    if point["lambda"] > 0:
        rows = len(right)
        lasso = Lasso(alpha=point["lambda"] / rows, fit_intercept=False, tol=1e-15, max_iter=200_000)
        changes[is_penalised] = lasso.fit(numpy.asfortranarray(matrix), right).coef_
    else:
        changes[is_penalised] = numpy.linalg.lstsq(matrix, right, rcond=None)[0]
    rest = target - jacobian[:, is_penalised] @ changes[is_penalised]
    changes[~is_penalised] = numpy.linalg.lstsq(smooth, rest, rcond=None)[0] if smooth.size else 0
    return changes, values - centre


def main():
    # the duality gap that is asked for is rounding at some penalties
    warnings.simplefilter("ignore", ConvergenceWarning)
    with open(sys.argv[1], encoding="utf-8") as file:
        cases = json.load(file)["cases"]
    print(f"scikit-learn {sklearn.__version__}, {len(cases)} paths of 48 anchors")
    failed, judged = 0, 0
    for case in cases:
        for point in case["points"]:
            pairs = [solve(case, cable, point) for cable in range(8)]
            theirs, ours = (numpy.concatenate([pair[k] for pair in pairs]) for k in range(2))
            figure = numpy.abs(theirs - ours).max() / max(numpy.abs(ours).max(), 1e-3)
            count = int(numpy.count_nonzero(ours))
            is_good = figure <= RELATIVE
            judged += 1
            failed += not is_good
            words = f"{case['name']}, λ = {point['lambda']:.3e} 1/m: {count} of 48"
            print(f"{'ok ' if is_good else 'BAD'}  {words:<72} {figure:8.1e}     (limit {RELATIVE:.1e})")
    print(f"judged: {judged - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
