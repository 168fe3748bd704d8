# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids of strikers, for blow_scenes.py: vertices [V, 3] and triangles [F, 3] about the origin, and their files."""
import math

import numpy


def closed_box(size):
    """Returns vertices and triangles of a box about the origin."""
    corner = numpy.array([[x, y, z] for x in (-.5, .5) for y in (-.5, .5) for z in (-.5, .5)]) * size
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corner, numpy.array([t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))])


def octahedron(radius):
    corner = numpy.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1.]]) * radius
    return corner, numpy.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])


def ball(radius):
    """Returns a polyhedron inscribed in a sphere: an octahedron whose triangles are divided twice."""
    corner, faces = octahedron(1.)
    for _ in range(2):
        corner, middles, divided = list(corner), {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(corner)
                point = corner[a] + corner[b]
                corner.append(point / numpy.linalg.norm(point))
            return middles[key]
        for a, b, c in faces:
            d, e, f = middle(a, b), middle(b, c), middle(c, a)
            divided += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
        faces = divided
    return numpy.array(corner) * radius, numpy.array(faces)


def prism(radius, length, sides):
    """Returns a prism along the z axis, about the origin."""
    angle = 2 * math.pi * numpy.arange(sides) / sides
    ring = numpy.stack([radius * numpy.cos(angle), radius * numpy.sin(angle)], axis=1)
    corner = numpy.vstack([numpy.column_stack([ring, numpy.full(sides, z)]) for z in (-length / 2, length / 2)]
                          + [[[0, 0, -length / 2], [0, 0, length / 2]]])
    faces = []
    for i in range(sides):
        j = (i + 1) % sides
        faces += [(i, j, sides + j), (i, sides + j, sides + i)]
        faces += [(2 * sides, j, i), (2 * sides + 1, sides + i, sides + j)]
    return corner, numpy.array(faces)


def turned(axis, degrees):
    """Returns the matrix of a rotation."""
    axis = numpy.asarray(axis, float)
    axis = axis / numpy.linalg.norm(axis)
    angle = math.radians(degrees)
    cross = numpy.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return numpy.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def as_obj(corner, faces):
    lines = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in corner]
    return "\n".join(lines + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]) + "\n"


def as_stl(corner, faces):
    lines = ["solid striker"]
    for face in faces:
        lines += ["facet normal 0 0 0", "outer loop"] + [f"vertex {x:.9g} {y:.9g} {z:.9g}" for x, y, z in corner[face]]
        lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid striker"]) + "\n"
