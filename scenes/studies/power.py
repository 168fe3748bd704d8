#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the exponent of the power law between two columns of a study's table, by least squares of their logarithms,
and its standard deviation.

    scenes/studies/power.py star_cracks/study.csv speed radial_cracks

Rows in which either column is not positive are left out. Needs numpy.
"""
import csv
import sys

import numpy


def main():
    table, *names = sys.argv[1:]
    with open(table, encoding="utf-8") as file:
        cells = [[row[name] for name in names] for row in csv.DictReader(file) if row["exit"] == "0"]
    values = numpy.array([[float(cell) for cell in row] for row in cells if all(row)])
    x, y = numpy.log(values[(values > 0).all(axis=1)]).T
    (power, _), covariance = numpy.polyfit(x, y, 1, cov=True)
    print(f"{names[1]} ~ {names[0]}^{power:.2f}, with a deviation of {covariance[0, 0] ** 0.5:.2f}, of {len(x)} rows")


if __name__ == "__main__":
    main()
