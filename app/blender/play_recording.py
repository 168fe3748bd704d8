# SPDX-License-Identifier: GPL-3.0-or-later
"""blender --python play_recording.py -- RUN.h5...

Plays recordings of Sherd with the add-on beside it, which need not be installed for that."""

import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import sherd_recording  # noqa: E402



def remove_startup_cube():
    """Blender starts with a cube of 2 m, in which most recordings would be hidden; it goes unless a file was opened."""
    cube = bpy.data.objects.get("Cube")
    if not bpy.data.filepath and cube and cube.type == "MESH" and len(cube.data.vertices) == 8:
        bpy.data.objects.remove(cube)


sherd_recording.register()
remove_startup_cube()
for path in sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []:
    sherd_recording.load(os.path.abspath(path), bpy.context)
