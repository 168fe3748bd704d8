# SPDX-License-Identifier: GPL-3.0-or-later
from __future__ import annotations

from typing import NamedTuple

import numpy
from numpy.typing import ArrayLike

from . import _sherd


class Cut(NamedTuple):
    """A mesh that cut() has opened; its arrays are copies."""

    positions: numpy.ndarray
    """[W, 3] the vertices of the uncut mesh, followed by their copies"""
    faces: numpy.ndarray
    """[F, 3] vertices of each face, in the order of the uncut mesh"""
    originals: numpy.ndarray
    """[W] the vertex of the uncut mesh: the vertex itself, or the one of which it is a copy"""
    fragments: numpy.ndarray
    """[F] the fragment of each face, numbered from 0 in the order of the fragments' first faces"""


def cut(positions: ArrayLike, faces: ArrayLike, edges: ArrayLike) -> Cut:
    """Returns a mesh that is opened along edges, as a Cut. Involves no mechanics.

    positions  [V, 3] m, or another unit of length
    faces      [F, 3] vertices of each face, counterclockwise as seen from the side to which the normals point; a
               manifold, with or without boundary
    edges      [n, 2] vertices of each edge, interior edges of the mesh

    Splits a vertex so that two corners keep a common copy only if a path around the vertex connects them that crosses
    neither a given edge nor the boundary: a single edge with both ends inside the mesh stays closed. Raises Error if
    the mesh is not a manifold, if an edge does not exist, is on the boundary or is given twice, or if an array has
    another shape or numbers that are not finite; the message names the vertex, face or edge.
    """
    return Cut(**_sherd.cut(positions, faces, edges))
