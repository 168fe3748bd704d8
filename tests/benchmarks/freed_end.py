#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the energy that a half-infinite strip loses when its end is freed from the stress of a tempered sheet.

    tests/benchmarks/freed_end.py

Prints the energy over S^2 t^2 (1 - nu^2) / Y for two Poisson's ratios on three meshes, of bilinear finite elements in
plane strain over half the thickness. Needs numpy and scipy.
"""
import numpy
import scipy.sparse
import scipy.sparse.linalg

GAUSS = numpy.array((-1, 1)) / numpy.sqrt(3)
LENGTH = 6  # length of the strip over half its thickness: far beyond the effect of the end


def element(width, height, elasticity):
    """Returns the stiffness of a rectangle, [8, 8], with Y = 1."""
    stiffness = numpy.zeros((8, 8))
    for p in GAUSS:
        for q in GAUSS:
            along = numpy.array((-(1 - q), 1 - q, 1 + q, -(1 + q))) / (2 * width)
            across = numpy.array((-(1 - p), -(1 + p), 1 + p, 1 - p)) / (2 * height)
            strain = numpy.zeros((3, 8))
            strain[0, 0::2] = strain[2, 1::2] = along
            strain[1, 1::2] = strain[2, 0::2] = across
            stiffness += strain.T @ elasticity @ strain * width * height / 4
    return stiffness


def freed(poisson, layers):
    """Returns the energy over S^2 t^2 (1 - nu^2) / Y."""
    factor = 1 / ((1 + poisson) * (1 - 2 * poisson))
    elasticity = factor * numpy.array(((1 - poisson, poisson, 0), (poisson, 1 - poisson, 0),
                                       (0, 0, (1 - 2 * poisson) / 2)))
    height, places = 1 / layers, [0.0]
    while places[-1] < LENGTH:
        places.append(places[-1] + min(height * 1.03 ** len(places), 0.2))
    node = numpy.arange(len(places) * (layers + 1)).reshape(len(places), layers + 1)
    matrix = scipy.sparse.lil_matrix((2 * node.size, 2 * node.size))
    for i, width in enumerate(numpy.diff(places)):
        stiffness = element(width, height, elasticity)
        for j in range(layers):
            corners = numpy.array((node[i, j], node[i + 1, j], node[i + 1, j + 1], node[i, j + 1]))
            rows = (2 * corners[:, None] + (0, 1)).ravel()
            matrix[numpy.ix_(rows, rows)] += stiffness
    force = numpy.zeros(2 * node.size)
    for j in range(layers):
        for q in GAUSS:
            z = (j + (1 + q) / 2) * height
            traction = (1 - 3 * z**2) / 2 * height / 2
            force[2 * node[0, j]] += traction * (1 - q) / 2
            force[2 * node[0, j + 1]] += traction * (1 + q) / 2
    held = numpy.concatenate((2 * node[:, 0] + 1, 2 * node[-1]))  # the middle plane, and the far end along the strip
    free = numpy.setdiff1d(numpy.arange(2 * node.size), held)
    moved = scipy.sparse.linalg.spsolve(matrix.tocsr()[free][:, free].tocsc(), force[free])
    # The energy is half of the work on both halves of the thickness, each of which is force @ moved; t = 2.
    return force[free] @ moved / (1 - poisson**2) / 4


def main():
    for layers in (12, 24, 48):
        print(f"{layers} layers:", ", ".join(f"{freed(nu, layers):.4f} (nu = {nu})" for nu in (0.2, 0.35)), flush=True)


if __name__ == "__main__":
    main()
