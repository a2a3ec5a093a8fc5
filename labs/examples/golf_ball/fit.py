#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fits the model's ball to five hand-timed rolls of a real golf ball, and prints how well it fits.

  fit.py [rolls.csv]

Each line of the table has the times, s, at which a ball passed 0, 0.5, 1.0 and 1.5 m. The model is
that of docs/model.md for a ball that rolls without friction in its speed:
  x(t) = v t - a t^2 / 2,   a = rolling_resistance 9.81 / 1.4
Least squares in x. First each roll has a deceleration a of its own, then all five share one.
"""
import csv
import math
import os
import sys

PLACES = (0.0, 0.5, 1.0, 1.5)  # m


def solve(matrix, right):
    """Gaussian elimination with the largest pivot."""
    n = len(right)
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(n):
            if k != i:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    return [rows[i][n] / rows[i][i] for i in range(n)]


def least_squares(columns, right):
    return solve([[sum(x * y for x, y in zip(a, b)) for b in columns] for a in columns],
                 [sum(x * y for x, y in zip(a, right)) for a in columns])


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "rolls.csv")
    with open(path, encoding="utf-8") as file:
        rolls = [[float(v) for k, v in row.items() if k != "roll"] for row in csv.DictReader(file)]
    places = []  # the unknowns: x and v at the start of each roll, and one a
    total = 4 * len(rolls)
    unknowns = [[0.0] * total for _ in range(2 * len(rolls) + 1)]
    print("roll   v, m/s   a, m/s^2   misfit, mm (at 0, 0.5, 1, 1.5 m)")
    own_square = 0.0
    for r, times in enumerate(rolls):
        t = [value - times[0] for value in times]
        own = [[1.0] * 4, t, [-0.5 * x * x for x in t]]
        fit = least_squares(own, PLACES)
        misfit = [sum(c[i] * f for c, f in zip(own, fit)) - PLACES[i] for i in range(4)]
        own_square += sum(m * m for m in misfit)
        print(f"{r + 1:4d} {fit[1]:8.2f} {fit[2]:10.2f}   " + " ".join(f"{1e3 * m:6.1f}" for m in misfit))
        for i in range(4):
            unknowns[2 * r][4 * r + i] = 1.0
            unknowns[2 * r + 1][4 * r + i] = t[i]
            unknowns[-1][4 * r + i] = -0.5 * t[i] * t[i]
            places.append(PLACES[i])
    fit = least_squares(unknowns, places)
    misfit = [sum(c[i] * f for c, f in zip(unknowns, fit)) - places[i] for i in range(total)]
    square = sum(m * m for m in misfit)
    freedom = total - len(unknowns)
    sigma = math.sqrt(square / freedom)
    unit = [0.0] * len(unknowns)
    unit[-1] = 1.0
    normal = [[sum(x * y for x, y in zip(a, b)) for b in unknowns] for a in unknowns]
    half = 2.262 * sigma * math.sqrt(solve(normal, unit)[-1])  # Student's t, 9 degrees of freedom
    a = fit[-1]
    print(f"all five: a = {a:.3f} m/s^2, 95 %: {a - half:.3f} to {a + half:.3f}; "
          f"rolling_resistance {a * 1.4 / 9.81:.4f}")
    print(f"misfit, root mean square: {1e3 * math.sqrt(own_square / total):.1f} mm with a deceleration "
          f"for each roll, {1e3 * math.sqrt(square / total):.1f} mm with one")


if __name__ == "__main__":
    main()
