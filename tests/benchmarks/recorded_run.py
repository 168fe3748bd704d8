# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the program whose recordings the tables here are made of."""
import contextlib
import pathlib
import subprocess
import tempfile

SCENES = pathlib.Path(__file__).parents[2] / "scenes"


@contextlib.contextmanager
def recorded_run(program, scene, settings, *options):
    """The recording of a run of a scene (its path below scenes/) with `settings`, each NAME=VALUE, as long as the block
    lasts. Raises subprocess.CalledProcessError when the run fails."""
    with tempfile.TemporaryDirectory() as folder:
        recording = pathlib.Path(folder) / "run.h5"
        words = [word for setting in settings for word in ("--set", setting)]
        subprocess.run([program, "run", SCENES / scene, "-o", recording, *words, *options], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        yield recording
