# SPDX-License-Identifier: GPL-3.0-or-later
"""blender --python play_recording.py -- RUN.h5...

Plays recordings of Sherd with the add-on beside it, which need not be installed for that."""

import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import sherd_recording  # noqa: E402

sherd_recording.register()
for path in sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []:
    sherd_recording.load(os.path.abspath(path), bpy.context)
