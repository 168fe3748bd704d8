# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays a recording of Sherd in Blender: the mesh of each frame is read from the .h5 file when it is shown.

As an add-on: Edit > Preferences > Add-ons > Install, sherd_recording.zip; then File > Import > Sherd recording (.h5).
From a shell: blender --python play_recording.py -- RUN.h5

The object's custom property `sherd_slow` is the factor by which the run plays slower than reality, at first such that
it lasts 4 to 10 s; between recorded frames the mesh is interpolated. Metres are metres and z is up. The mesh has the
attributes `fragment` and `strain` (1/m, the largest in absolute value of the face's edges) on its faces and
`velocity` (m/s) and `original` (the vertex that it is a copy of, or itself) on its vertices; where the recording has
them, also the UV map `texture`, the colours `colour` of corners, and a material for each of its materials. Materials
and slots are made once: the user's changes of them stay, and a frame sets only the slot of each face. Obstacles and
free bodies are children of the object and move as they did; a square stands for a plane. Needs h5py; on Debian
Blender uses the system's Python, and python3-h5py suffices."""

import math
import os
import sys

import bpy
import h5py
import numpy as np
from bpy.app.handlers import persistent
from bpy_extras.io_utils import ImportHelper
from mathutils import Matrix

from .looks import add_materials, set_look
from .playback import NEAR, default_slowdown, frame_names, points_at, poses_at, position_at, run_times, state_at

bl_info = {
    "name": "Sherd recording",
    "author": "The Sherd authors",
    "version": (1, 5, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > Sherd recording (.h5)",
    "description": "Plays recordings of breaking plates and shells",
    "category": "Import-Export",
}

PATH, SLOW, SHOWN = "sherd_recording", "sherd_slow", "sherd_frame"  # properties of an object that plays a recording
OBSTACLE = "sherd_obstacle"  # the number of an obstacle, a property of its object


def absolute(path):
    return bpy.path.abspath(path)


def slowdown(target, frames, names):
    first, last = run_times(frames, names)
    return target.get(SLOW) or default_slowdown(last - first)


def pictures_a_second(scene):
    return scene.render.fps / scene.render.fps_base


def set_attribute(mesh, name, kind, domain, values):
    attribute = mesh.attributes.get(name) or mesh.attributes.new(name, kind, domain)
    attribute.data.foreach_set("vector" if kind == "FLOAT_VECTOR" else "value", np.ravel(values))


def fill(mesh, faces, positions):
    """Replaces vertices and faces of the mesh, in the given order; materials and shading stay."""
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


def fill_sheets(mesh, state):
    fill(mesh, state["faces"], state["position"])
    set_attribute(mesh, "fragment", "INT", "FACE", state["fragment"])
    set_attribute(mesh, "strain", "FLOAT", "FACE", state["strain"])
    set_attribute(mesh, "velocity", "FLOAT_VECTOR", "POINT", state["velocity"])
    set_attribute(mesh, "original", "INT", "POINT", state["original"])
    set_look(mesh, state["look"])


def show(target, scene):
    """Shows the recording at the scene's time; before its first frame and after its last one, that frame."""
    with h5py.File(absolute(target[PATH]), "r") as file:
        frames, names = file["frames"], frame_names(file)
        played = (scene.frame_current + scene.frame_subframe) / pictures_a_second(scene)
        time = run_times(frames, names)[0] + played / slowdown(target, frames, names)
        position = position_at(frames, names, time)
        if target.get(SHOWN) != position or len(target.data.polygons) == 0:
            fill_sheets(target.data, state_at(frames, names, position))
            place_obstacles(target, file, names, position)
            target[SHOWN] = position


def place_obstacles(target, file, names, position):
    """Moves the objects of obstacles and bodies, but those that the user has deleted."""
    if "obstacles" not in file:
        return
    middles = [file[f"obstacles/{i}/position"][:].mean(axis=0) for i in range(len(file["obstacles/names"]))]
    poses = poses_at(file["frames"], names, position, middles)
    deforms = file["obstacles/deforms"][:] if "deforms" in file["obstacles"] else np.zeros(len(poses))
    for solid in (child for child in target.children if OBSTACLE in child):
        solid.matrix_basis = Matrix([*poses[solid[OBSTACLE]], [0, 0, 0, 1]])
        if deforms[solid[OBSTACLE]]:
            points = points_at(file["frames"], names, position, solid[OBSTACLE])
            solid.data.vertices.foreach_set("co", np.ravel(points))
            solid.data.update()


@persistent
def play(scene, _depsgraph=None):
    for target in scene.objects:
        if target.type == "MESH" and PATH in target:
            try:
                show(target, scene)
            except (OSError, KeyError, ValueError) as error:  # a run in progress locks its file for moments
                print(f"sherd: {target.name}: {error}", file=sys.stderr)


def add_obstacles(target, file, context):
    """Adds an object for each obstacle and free body, as a child of `target`, which plays the recording."""
    for number, name in enumerate(file["obstacles/names"].asstr()[:] if "obstacles" in file else []):
        solid = bpy.data.objects.new(f"obstacle_{name}", bpy.data.meshes.new(name))
        fill(solid.data, *(file[f"obstacles/{number}/{part}"][:] for part in ("face", "position")))
        solid[OBSTACLE], solid.parent = number, target
        context.scene.collection.objects.link(solid)


def load(path, context, slow=0):
    """Adds an object that plays the recording `slow` times slower than reality (0: default_slowdown()); returns it.
    Raises ValueError if the recording has no frame."""
    name = os.path.splitext(os.path.basename(path))[0]
    with h5py.File(absolute(path), "r") as file:
        names = frame_names(file)
        if not names:
            raise ValueError(f"{path}: the recording has no frame yet")
        first, last = run_times(file["frames"], names)
        target = bpy.data.objects.new(name, bpy.data.meshes.new(name))
        target[PATH], target[SLOW] = path, slow or default_slowdown(last - first)
        context.scene.collection.objects.link(target)
        add_materials(target.data, file["rest"])
        add_obstacles(target, file, context)
    pictures = (last - first) * target[SLOW] * pictures_a_second(context.scene)
    context.scene.frame_start, context.scene.frame_end = 0, math.ceil(pictures - NEAR)
    show(target, context.scene)
    return target


class ImportSherdRecording(bpy.types.Operator, ImportHelper):
    """Add an object that plays a recording of sherd"""

    bl_idname = "import_scene.sherd_recording"
    bl_label = "Import Sherd recording"
    filename_ext = ".h5"
    filter_glob: bpy.props.StringProperty(default="*.h5", options={"HIDDEN"})
    slow: bpy.props.FloatProperty(
        name="Slower", default=0, min=0, description="How many times slower than reality; 0: so that it lasts 4 to 10 s"
    )

    def execute(self, context):
        try:
            load(self.filepath, context, self.slow)
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
