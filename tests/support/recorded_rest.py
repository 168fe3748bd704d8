# SPDX-License-Identifier: GPL-3.0-or-later
"""What a recording tells of things that have come to rest."""

import h5py
import numpy


def at_the_end(recording):
    """Positions in the last frame, m; how far they are at most from those in the middle one, m; what share of the
    largest energy is unexplained at most; fragments; steps."""
    with h5py.File(recording) as file:
        steps, names = file["steps"], sorted(file["frames"])
        middle, end = (file["frames"][name]["vertex/position"][()] for name in (names[len(names) // 2], names[-1]))
        total = sum(steps[kind][()] for kind in ("kinetic", "bending", "membrane", "contact"))
        unexplained = numpy.abs(steps["unexplained"][()]).max() / total.max()
        return end, numpy.linalg.norm(end - middle, axis=1).max(), unexplained, int(steps["fragments"][-1]), len(total)
