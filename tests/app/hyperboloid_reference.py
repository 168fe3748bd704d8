#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the reference energies of app/bench/shell/hyperboloid_cases.cpp.

A shell of revolution r^2 = 1 + z^2, |z| <= 1, with free ends (E = 2.85e4, nu = 0.3, thickness t) under the pressure
1e4 t^3 cos(2 angle) along its outward normal: Koiter's linear shell, second harmonic around, Legendre polynomials
along the axis (Ritz's method). Run by hand:

    tests/app/hyperboloid_reference.py
"""
import numpy as np
from numpy.polynomial import legendre

YOUNG, POISSON, PRESSURE, AROUND = 2.85e4, 0.3, 1e4, 2


def strains(degree, points):
    """Returns membrane strains (11, 22, 2*12), changes of curvature and displacement along the normal, each [points,
    unknowns], and weights of the points. Unknowns are u (along the meridian, cos), v (around, sin), w (outward,
    cos)."""
    z, weight = legendre.leggauss(points)
    r = np.sqrt(1 + z * z)
    slope, bend = z / r, 1 / r**3
    stretch = np.sqrt(1 + slope**2)  # arc length over z
    sine, cosine = slope / stretch, 1 / stretch  # the meridian's angle to the axis
    turn = bend / (1 + slope**2) / stretch  # rotation of the meridian's tangent to the outward normal per arc length
    column = lambda values: values[:, None]
    value = legendre.legvander(z, degree)
    along_axis = np.array([legendre.legval(z, legendre.legder(unit)) for unit in np.eye(degree + 1)]).T
    second_along_axis = np.array([legendre.legval(z, legendre.legder(unit, 2)) for unit in np.eye(degree + 1)]).T
    first = along_axis / column(stretch)
    stretch_slope = slope * bend / stretch
    second = (second_along_axis / column(stretch) - along_axis * column(stretch_slope / stretch**2)) / column(stretch)
    # d(turn)/ds: turn = r^-3 (1 + slope^2)^-1.5, with r' = slope and slope' = bend along z.
    turn_slope = (-3 * slope / r**4 * stretch**-3 - 3 * slope * bend / r**3 * stretch**-5) / stretch
    none = 0 * value
    row = lambda u, v, w: np.hstack([u, v, w])
    s, c, k, r = column(sine), column(cosine), column(turn), column(r)
    n = AROUND
    e11 = row(first, none, -k * value)
    e22 = row(s / r * value, n / r * value, c / r * value)
    e12 = row(-n / r * value, first - s / r * value, none)
    # The normal turns by b1 along the meridian and b2 around it.
    b1 = row(-k * value, none, -first)
    b2 = row(none, c / r * value, n / r * value)
    b1_along = row(-k * first - column(turn_slope) * value, none, -second)
    # d(c/r)/ds = -(turn + c/r) s/r, since c' = -turn s; d(1/r)/ds = -s/r^2
    b2_along = row(none, c / r * first - (k * s / r + c * s / r**2) * value, n / r * first - n * s / r**2 * value)
    k11 = b1_along - k * e11
    k22 = s / r * b1 + n / r * b2 + c / r * e22
    k12 = -n / r * b1 + b2_along - s / r * b2 + c / r * row(none, first, none) - k * row(-n / r * value,
                                                                                       -s / r * value, none)
    return (e11, e22, e12), (k11, k22, k12), row(none, none, value), weight * stretch * r[:, 0] * np.pi


def energy(thickness, degree=60, points=160):
    membrane, bending, normal, weight = strains(degree, points)
    plane = YOUNG / (1 - POISSON**2) * np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, (1 - POISSON) / 2]])
    # Both parts stacked as a least squares problem, so that round-off does not swamp the bending of a thin shell.
    root = np.linalg.cholesky(plane).T
    rows = [np.sqrt(factor) * np.sqrt(weight)[:, None] * sum(root[i, j] * part[j] for j in range(3))
            for factor, part in ((thickness, membrane), (thickness**3 / 12, bending)) for i in range(3)]
    force = PRESSURE * thickness**3 * (normal * weight[:, None]).sum(axis=0)
    _, singular, right = np.linalg.svd(np.vstack(rows), full_matrices=False)
    return 0.5 * np.sum((right @ force / singular) ** 2)


for t in (1, 0.1, 0.01, 0.001):
    print(f"t = {t}: energy / t^3 = {energy(t) / t**3:.4f} ({energy(t, 40, 120) / t**3:.4f} with fewer polynomials)")
