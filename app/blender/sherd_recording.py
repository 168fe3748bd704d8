# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays a recording of Sherd in Blender: the mesh of each frame is read from the .h5 as it is needed.

As an add-on: Edit > Preferences > Add-ons > Install, this file; then File > Import > Sherd recording (.h5).
From a shell: blender --python sherd_recording.py -- RUN.h5

Frame n of Blender's timeline is frame n of the recording, metres are metres and z is up. The object's mesh has the
attributes `fragment` and `strain` (1/m, the largest in absolute value of the face's edges) on its faces and
`velocity` (m/s) and `original` (the vertex of the unbroken mesh) on its vertices. Needs h5py; on Debian Blender uses
the system's Python, and python3-h5py suffices."""

import os
import sys

import bpy
import h5py
import numpy as np
from bpy.app.handlers import persistent
from bpy_extras.io_utils import ImportHelper

bl_info = {
    "name": "Sherd recording",
    "author": "The Sherd authors",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > Sherd recording (.h5)",
    "description": "Plays recordings of breaking plates and shells",
    "category": "Import-Export",
}

PATH, SHOWN = "sherd_recording", "sherd_frame"  # custom properties of an object that plays a recording


def absolute(path):
    return bpy.path.abspath(path)


def frame_names(file):
    if file.attrs.get("format") != "sherd recording":
        raise ValueError(f"{file.filename} is not a recording of sherd")
    return sorted(file["frames"])


def face_strain(frame):
    """Largest absolute strain of each face's edges."""
    faces, edges = frame["face/vertices"][:].astype(np.int64), frame["edge/vertices"][:].astype(np.int64)
    count = frame["vertex/position"].shape[0]

    def keys(ends):
        return ends.min(axis=1) * count + ends.max(axis=1)

    order = np.argsort(keys(edges))
    known, strain = keys(edges)[order], np.abs(frame["edge/strain"][:])[order]
    sides = [strain[np.searchsorted(known, keys(faces[:, side]))] for side in ([0, 1], [1, 2], [2, 0])]
    return np.maximum.reduce(sides)


def set_attribute(mesh, name, kind, domain, values):
    attribute = mesh.attributes.get(name) or mesh.attributes.new(name, kind, domain)
    attribute.data.foreach_set("vector" if kind == "FLOAT_VECTOR" else "value", np.ravel(values))


def fill(mesh, frame):
    """Gives the mesh the frame's vertices and faces, in their order; materials and shading stay."""
    faces, positions = frame["face/vertices"][:], frame["vertex/position"][:]
    smooth = len(mesh.polygons) > 0 and mesh.polygons[0].use_smooth
    mesh.clear_geometry()
    mesh.vertices.add(len(positions))
    mesh.vertices.foreach_set("co", positions.ravel())
    mesh.loops.add(faces.size)
    mesh.loops.foreach_set("vertex_index", faces.ravel())
    mesh.polygons.add(len(faces))
    mesh.polygons.foreach_set("loop_start", np.arange(0, faces.size, 3))
    mesh.polygons.foreach_set("loop_total", np.full(len(faces), 3))
    mesh.polygons.foreach_set("use_smooth", np.full(len(faces), smooth))
    mesh.update(calc_edges=True)
    set_attribute(mesh, "fragment", "INT", "FACE", frame["face/fragment"][:])
    set_attribute(mesh, "strain", "FLOAT", "FACE", face_strain(frame))
    set_attribute(mesh, "velocity", "FLOAT_VECTOR", "POINT", frame["vertex/velocity"][:])
    set_attribute(mesh, "original", "INT", "POINT", frame["vertex/original"][:])


def show(target, number):
    """Shows the recording's frame of that number, the nearest there is."""
    with h5py.File(absolute(target[PATH]), "r") as file:
        names = frame_names(file)
        number = min(max(number, 0), len(names) - 1)
        if target.get(SHOWN) != number or len(target.data.polygons) == 0:
            fill(target.data, file["frames"][names[number]])
            target[SHOWN] = number


@persistent
def play(scene, _depsgraph=None):
    for target in scene.objects:
        if target.type == "MESH" and PATH in target:
            try:
                show(target, scene.frame_current)
            except (OSError, KeyError, ValueError) as error:  # a run that is going on locks its file for moments
                print(f"sherd: {target.name}: {error}", file=sys.stderr)


def load(path, context):
    """Adds an object that plays the recording; returns it."""
    with h5py.File(absolute(path), "r") as file:
        count = len(frame_names(file))
    if count == 0:
        raise ValueError(f"{path}: the recording has no frame yet")
    name = os.path.splitext(os.path.basename(path))[0]
    target = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    target[PATH] = path
    context.scene.collection.objects.link(target)
    context.scene.frame_start, context.scene.frame_end = 0, count - 1
    show(target, context.scene.frame_current)
    return target


class ImportSherdRecording(bpy.types.Operator, ImportHelper):
    """Add an object that plays a recording of sherd"""

    bl_idname = "import_scene.sherd_recording"
    bl_label = "Import Sherd recording"
    filename_ext = ".h5"
    filter_glob: bpy.props.StringProperty(default="*.h5", options={"HIDDEN"})

    def execute(self, context):
        try:
            load(self.filepath, context)
        except (OSError, KeyError, ValueError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


def menu_entry(self, _context):
    self.layout.operator(ImportSherdRecording.bl_idname, text="Sherd recording (.h5)")


def register():
    bpy.utils.register_class(ImportSherdRecording)
    bpy.types.TOPBAR_MT_file_import.append(menu_entry)
    bpy.app.handlers.frame_change_pre.append(play)


def unregister():
    bpy.app.handlers.frame_change_pre.remove(play)
    bpy.types.TOPBAR_MT_file_import.remove(menu_entry)
    bpy.utils.unregister_class(ImportSherdRecording)


def main():
    register()
    if "--" in sys.argv:
        for path in sys.argv[sys.argv.index("--") + 1 :]:
            load(os.path.abspath(path), bpy.context)


if __name__ == "__main__":
    main()
