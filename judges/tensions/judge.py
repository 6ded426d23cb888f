"""Judges exact tensions by DAQP and SciPy's linprog: `judge.py [--untimed] CASES.json`; exit code 1 when a figure is beyond its
limit. Untimed, ratios of times are shown and not judged: our times are then those of a build for tests.

Verdicts, optima, and how many times as long the others take: DAQP by its own clock, linprog as a user calls it. Both sides count
the least of some rounds of each problem, as other work on the machine adds to single ones; the median over problems is judged.
"""

import ctypes
import json
import sys
import time

import daqp
import numpy
import scipy
from scipy.optimize import linprog

# Allowed deviation of a tension (N), and least ratios of time.
TENSION_N = 1e-6
DAQP_RATIO = 2.5
LINPROG_RATIO = 1500.0
# linprog takes milliseconds each
LINEAR_PROGRAMMES = 100
LINEAR_ROUNDS = 3
ROUNDS = 20
EQUALITY = 5


class Daqp:
    """min ½ ‖f − f_m‖² such that Aᵀ f = −w and the limits; tensions in kN, so that its tolerances mean something."""

    def __init__(self, limits, cables, rows):
        self.lower, self.upper = (numpy.full(cables, limit / 1e3) for limit in limits)
        self.hessian = numpy.eye(cables)
        self.linear = -0.5 * (self.lower + self.upper)
        self.sense = numpy.array([0] * cables + [EQUALITY] * rows, dtype=ctypes.c_int)

    def solve(self, matrix, wrench):
        """Tensions (N) or None, and nanoseconds by its own clock."""
        right = -wrench / 1e3
        bounds = (numpy.concatenate([self.upper, right]), numpy.concatenate([self.lower, right]))
        tensions, _, status, info = daqp.solve(self.hessian, self.linear, matrix, *bounds, self.sense)
        return (tensions * 1e3 if status > 0 else None), (info["setup_time"] + info["solve_time"]) * 1e9


def linear_programme(matrix, wrench, limits):
    """Whether linprog finds tensions, and nanoseconds of CPU time."""
    bounds = [(limits[0] / 1e3, limits[1] / 1e3)] * matrix.shape[1]
    start = time.process_time()
    found = linprog(numpy.zeros(matrix.shape[1]), A_eq=matrix, b_eq=-wrench / 1e3, bounds=bounds, method="highs-ds")
    return found.status == 0, (time.process_time() - start) * 1e9


def judge(cases, limits):
    """Rows of name, figure, limit, unit, and whether more is better."""
    wrong, apart, ratios, linear_ratios = 0, 0.0, [], []
    solver = Daqp(limits, len(cases[0]["matrix"][0]), len(cases[0]["wrench"]))
    for index, case in enumerate(cases):
        matrix, wrench = numpy.array(case["matrix"]), numpy.array(case["wrench"])
        answers = [solver.solve(matrix, wrench) for _ in range(ROUNDS)]
        theirs = answers[0][0]
        ratios.append(min(answer[1] for answer in answers) / case["nanoseconds"])
        wrong += (theirs is None) != (case["tensions"] is None)
        if theirs is not None and case["tensions"] is not None:
            apart = max(apart, numpy.abs(theirs - case["tensions"]).max())
        if index < LINEAR_PROGRAMMES:
            answers = [linear_programme(matrix, wrench, limits) for _ in range(LINEAR_ROUNDS)]
            wrong += answers[0][0] == (case["tensions"] is None)
            linear_ratios.append(min(answer[1] for answer in answers) / case["nanoseconds"])
    return [
        ("other verdicts", wrong, 0, "", False),
        ("largest difference of a tension", apart, TENSION_N, "N", False),
        ("DAQP takes, times as long", numpy.median(ratios), DAQP_RATIO, "", True),
        ("linprog takes, times as long", numpy.median(linear_ratios), LINPROG_RATIO, "", True),
    ]


def main():
    *options, path = sys.argv[1:]
    with open(path, encoding="utf-8") as file:
        problems = json.load(file)
    rows = judge(problems["cases"], problems["limits"])
    print(f"DAQP, SciPy {scipy.__version__}, {len(problems['cases'])} programmes")
    failed, judged = 0, 0
    for name, figure, limit, unit, is_least in rows:
        if is_least and "--untimed" in options:
            print(f"  –  {name:<52} {figure:8.1e} {unit:<3} (not judged)")
            continue
        is_good = figure >= limit if is_least else figure <= limit
        judged += 1
        failed += not is_good
        word = "at least" if is_least else "limit"
        print(f"{'ok ' if is_good else 'BAD'}  {name:<52} {figure:8.1e} {unit:<3} ({word} {limit:.1e})")
    print(f"judged: {judged - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
