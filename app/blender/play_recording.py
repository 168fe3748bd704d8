# SPDX-License-Identifier: GPL-3.0-or-later
"""blender --python play_recording.py -- RUN.h5...

Plays recordings of Sherd with the add-on in the folder of this script, which need not be installed. An add-on that is
installed and enabled, perhaps an older version, is disabled until Blender ends."""

import os
import sys

import bpy


def leave_installed():
    """Removes the installed add-on from Blender's menus and handlers, and from Python's modules."""
    installed = sys.modules.get("sherd_recording")
    if installed is None:
        return
    installed.unregister()
    for name in [name for name in sys.modules if name.split(".")[0] == "sherd_recording"]:
        del sys.modules[name]


def remove_startup_cube():
    """Removes Blender's initial cube of 2 m, in which most recordings would be hidden, unless a file was opened."""
    cube = bpy.data.objects.get("Cube")
    if not bpy.data.filepath and cube and cube.type == "MESH" and len(cube.data.vertices) == 8:
        mesh = cube.data
        bpy.data.objects.remove(cube)
        bpy.data.meshes.remove(mesh)


leave_installed()
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import sherd_recording  # noqa: E402

sherd_recording.register()
remove_startup_cube()
for path in sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []:
    try:
        sherd_recording.load(os.path.abspath(path), bpy.context)
    except (OSError, KeyError, ValueError) as error:
        sys.exit(f"sherd: {path}: {error}")
