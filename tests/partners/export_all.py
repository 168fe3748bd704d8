# SPDX-License-Identifier: GPL-3.0-or-later
"""export_all.py SHERD RUN.h5 FOLDER

Exports a recording into FOLDER (made anew) in every format, for check_blender.py, check_pvd.py and check_vdb.py."""

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
    ("mdd", "cache.mdd", "--slow", "250", "--force"),  # with the same cache.obj
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
