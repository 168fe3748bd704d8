# SPDX-License-Identifier: GPL-3.0-or-later
"""export_all.py SHERD RUN.h5 FOLDER

Exports a recording into FOLDER, which is emptied before, in every format, for the checks of other programs."""

import os
import shutil
import subprocess
import sys

EXPORTS = [
    ("obj", "run.obj"),
    ("ply", "run.ply"),
    ("stl", "run.stl"),
    ("pvd", "run.pvd"),
    ("pc2", "cache.pc2", "--slow", "250"),
    ("mdd", "cache.mdd", "--slow", "250", "--force"),  # overwrites cache.obj with the same content
    ("glb", "rigid.glb", "--slow", "250"),
    ("glb", "morph.glb", "--slow", "250", "--animate", "morph"),
    ("glb", "solid.glb", "--solid"),
    ("vdb", "volume.vdb", "--frames", "all"),
]


def main():
    sherd, recording, folder = sys.argv[1:]
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for kind, name, *options in EXPORTS:
        command = [sherd, "export", recording, "--to", kind, "-o", os.path.join(folder, name), *options]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


main()
