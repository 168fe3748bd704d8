# SPDX-License-Identifier: GPL-3.0-or-later
from __future__ import annotations

from typing import NamedTuple

import numpy
from numpy.typing import ArrayLike

from . import _sherd


class Cut(NamedTuple):
    """An opened mesh, of arrays of its own."""

    positions: numpy.ndarray
    """[W, 3] of its vertices: those of the uncut mesh, and behind them their copies"""
    faces: numpy.ndarray
    """[F, 3] in their order"""
    originals: numpy.ndarray
    """[W] the vertex of the uncut mesh that each is, or is a copy of"""
    fragments: numpy.ndarray
    """[F] the piece of each face, numbered in the order of their first faces"""


def cut(positions: ArrayLike, faces: ArrayLike, edges: ArrayLike) -> Cut:
    """Opens edges of a mesh: no physics.

    positions  [V, 3]
    faces      [F, 3] vertices, counterclockwise seen from where the normals point to: a manifold, with border or not
    edges      [n, 2] vertices of each edge, inside the mesh

    A vertex is copied so that corners share it only if they are connected around it without crossing an edge of these,
    or the border: an edge that ends inside the mesh at both ends stays closed. Raises Error, naming the vertex, face or
    edge, when the mesh is none, or an edge is none, is on the border, or is given twice.
    """
    return Cut(**_sherd.cut(positions, faces, edges))
