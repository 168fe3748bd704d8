# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the program, whose recordings the tables of this folder evaluate."""
import collections
import contextlib
import pathlib
import subprocess
import tempfile

import h5py
import numpy

SCENES = pathlib.Path(__file__).parents[2] / "scenes"


@contextlib.contextmanager
def recorded_run(program, scene, settings, *options):
    """Runs a scene (its path below scenes/) with `settings`, each NAME=VALUE. Yields the recording, which is deleted at
    the end of the block. Raises subprocess.CalledProcessError if the run fails."""
    with tempfile.TemporaryDirectory() as folder:
        recording = pathlib.Path(folder) / "run.h5"
        words = [word for setting in settings for word in ("--set", setting)]
        subprocess.run([program, "run", SCENES / scene, "-o", recording, *words, *options], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        yield recording


def cracks(recording):
    """Returns the ends at rest of the edges that have failed: [N, 2, 2] m, each once, without the boundary; the
    fragments' shares of the area; and the energy lost to cracks (J)."""
    with h5py.File(recording) as file:
        frame = file["frames"][sorted(file["frames"])[-1]]
        original, faces = frame["vertex/original"][:], frame["rest/faces"][:]
        rest, area = frame["rest/position"][:, :2], frame["rest/area"][:]
        edges, states = original[frame["edge/vertices"][:]], frame["edge/state"][:]
        shares = numpy.bincount(frame["face/fragment"][:], weights=area) / area.sum()
        lost = file["steps/lost_to_cracks"][-1]
    sides = collections.Counter(tuple(sorted((face[i], face[(i + 1) % 3]))) for face in faces for i in range(3))
    failed = {tuple(sorted(edge)) for edge, state in zip(edges, states) if state}
    return numpy.array([rest[list(edge)] for edge in sorted(failed) if sides[edge] == 2]), shares, lost
