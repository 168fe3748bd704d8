# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the direction of a crack that started at a notch, without the notch itself."""
import collections

import numpy

NOTCH_END, NOTCH_HEIGHT, NEAR = 0.02, 0.05, 1e-4  # m


def crack(recording):
    """Returns the ends at rest of the edges that have failed: [N, 2, 2] m, each once, without the notch and the
    boundary."""
    frame = recording.frame(len(recording) - 1)
    faces, rest = frame.rest_faces, frame.rest_positions[:, :2]
    sides = collections.Counter(tuple(sorted((face[i], face[(i + 1) % 3]))) for face in faces for i in range(3))
    edges = frame.originals[frame.edges][frame.edge_states > 0]
    ends = rest[[edge for edge in {tuple(sorted(edge)) for edge in edges} if sides[edge] == 2]]
    beyond = ends[:, :, 0].max(axis=1) > NOTCH_END + NEAR
    beside = abs(ends[:, :, 1] - NOTCH_HEIGHT).max(axis=1) > NEAR
    return ends[beyond | beside]


def measure(recording):
    """Returns crack_angle: degrees to the notch, 0 to 180, mean of doubled angles weighted by length; alike: 0 to 1, 1
    if the whole crack has this direction. Returns nothing if there is no crack."""
    way = numpy.diff(crack(recording), axis=1)[:, 0]
    if len(way) == 0:
        return {}
    way = way[:, 0] + 1j * way[:, 1]
    mean = (way**2 / abs(way)).sum() / abs(way).sum()
    return {"crack_angle": numpy.degrees(numpy.angle(mean)) / 2 % 180, "alike": abs(mean)}
