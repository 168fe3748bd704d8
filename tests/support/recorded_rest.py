# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures of recordings in which everything comes to rest."""

import h5py
import numpy


def at_the_end(recording):
    """Returns the positions in the last frame, m; their largest distance from those in the middle frame, m; the largest
    energy residual over the largest energy; and the numbers of fragments and steps."""
    with h5py.File(recording) as file:
        steps, names = file["steps"], sorted(file["frames"])
        middle, end = (file["frames"][name]["vertex/position"][()] for name in (names[len(names) // 2], names[-1]))
        total = sum(steps[kind][()] for kind in ("kinetic", "bending", "membrane", "contact"))
        unexplained = numpy.abs(steps["unexplained"][()]).max() / total.max()
        return end, numpy.linalg.norm(end - middle, axis=1).max(), unexplained, int(steps["fragments"][-1]), len(total)
