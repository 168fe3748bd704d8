#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the height from which half of the dropped objects break, from the table of `sherd sweep drop_height.toml`.

    scenes/studies/half_height.py drop_height/study.csv

Fits the probability of breaking as a logistic function of the logarithm of the height by maximum likelihood. The
interval contains 95 % of the fits to 2,000 bootstrap samples of the table's rows. Needs numpy.
"""
import csv
import sys

import numpy


def half(height, broken):
    """Returns the height from which half break, m, by Newton's method; NaN if a height separates those that break from
    those that do not."""
    features = numpy.column_stack([numpy.ones(len(height)), numpy.log(height)])
    weights = numpy.zeros(2)
    for _ in range(30):
        probability = 1 / (1 + numpy.exp(-(features @ weights)))
        spread = probability * (1 - probability)
        hessian = features.T @ (features * spread[:, None])
        if numpy.linalg.cond(hessian) > 1e12:
            return numpy.nan
        weights += numpy.linalg.solve(hessian, features.T @ (broken - probability))
    return numpy.exp(-weights[0] / weights[1])


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["exit"] == "0"]
    height, broken = (numpy.array([float(row[name]) for row in rows]) for name in ("height", "broken"))
    middle = half(height, broken)
    if numpy.isnan(middle):
        sys.exit("half_height.py: one height parts those that break from those that do not: take more of them between")
    draw = numpy.random.default_rng(1)
    fits = []
    for _ in range(2000):
        some = draw.integers(len(rows), size=len(rows))
        fits.append(half(height[some], broken[some]))
    low, high = numpy.nanpercentile(fits, [2.5, 97.5])
    print(f"half of {len(rows)} break from {middle:.3f} m, {low:.3f} to {high:.3f} m in 95 of 100")


if __name__ == "__main__":
    main()
