# SPDX-License-Identifier: GPL-3.0-or-later
"""Reference positions between the frames of a recording whose pieces move rigidly."""
import numpy as np


def affine(rest, places):
    """Returns the affine map from places at rest, in the plane z = 0, to other places, by least squares."""
    return np.linalg.lstsq(np.column_stack([rest[:, :2], np.ones(len(rest))]), places, rcond=None)[0]


def piece_of_vertices(frame):
    owner = np.empty(len(frame["vertex/position"]), int)
    for corner in range(3):
        owner[frame["face/vertices"][:, corner]] = frame["face/fragment"][:]
    return owner


def at_rest(frame):
    return frame["rest/position"][:][frame["vertex/original"][:]]


def between(file, number, share):
    """Returns the positions of the vertices of frame `number` + 1 at a share of the way from frame `number`."""
    names = sorted(file["frames"])
    earlier, later = (file["frames"][name] for name in names[number : number + 2])
    parent = dict(zip(file["events/fragment/fragment"][:], file["events/fragment/parent"][:]))
    owners, rest, start = piece_of_vertices(earlier), at_rest(later), np.empty_like(later["vertex/position"][:])
    for piece in set(owner := piece_of_vertices(later)):
        before = piece if piece in owners else parent[piece]
        motion = affine(at_rest(earlier)[owners == before], earlier["vertex/position"][:][owners == before])
        start[owner == piece] = np.column_stack([rest[:, :2], np.ones(len(rest))])[owner == piece] @ motion
    return (1 - share) * start + share * later["vertex/position"][:]
