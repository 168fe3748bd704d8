# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the player for Blender without Blender: its data for Blender must be those of the recording, and between frames
the pieces must move in straight lines. The pieces of the recording move rigidly and are flat at rest.

usage: check_player.py BLENDER RECORDING.h5, BLENDER: app/blender"""
import importlib
import sys
import types

import h5py
import numpy as np

from rigid_pieces import between


class Elements:
    """Replaces Blender's collections: vertices, corners or faces of a mesh, or the values of an attribute."""

    def __init__(self):
        self.count, self.values = 0, {}

    def __len__(self):
        return self.count

    def __getitem__(self, _):
        return types.SimpleNamespace(use_smooth=False)

    def add(self, count):
        self.count += count

    def foreach_set(self, name, values):
        self.values[name] = np.array(values)


class Mesh:
    def __init__(self):
        self.kept = {}
        self.attributes = types.SimpleNamespace(get=self.kept.get, new=self.new_attribute)
        self.clear_geometry()

    def clear_geometry(self):
        self.vertices, self.loops, self.polygons = Elements(), Elements(), Elements()

    def new_attribute(self, name, kind, domain):
        self.kept[name] = types.SimpleNamespace(data=Elements(), kind=kind, domain=domain)
        return self.kept[name]

    def update(self, calc_edges):
        assert calc_edges


class Object(dict):
    type = "MESH"

    def __init__(self, name, data):
        super().__init__()
        self.name, self.data, self.children = name, data, []


def player(folder):
    """Imports the add-on from `folder`, with replacements for the parts of Blender that it uses."""
    bpy = types.ModuleType("bpy")
    bpy.path = types.SimpleNamespace(abspath=lambda path: path)
    bpy.types = types.SimpleNamespace(Operator=type("Operator", (), {}))
    bpy.props = types.SimpleNamespace(StringProperty=lambda **_: "", FloatProperty=lambda **_: 0.0)
    bpy.data = types.SimpleNamespace(objects=types.SimpleNamespace(new=Object),
                                     meshes=types.SimpleNamespace(new=lambda _name: Mesh()))
    sys.modules.update({"bpy": bpy, "bpy.app": types.ModuleType("bpy.app"),
                        "bpy.app.handlers": types.ModuleType("bpy.app.handlers"),
                        "bpy_extras": types.ModuleType("bpy_extras"),
                        "bpy_extras.io_utils": types.ModuleType("bpy_extras.io_utils"),
                        "mathutils": types.ModuleType("mathutils")})
    sys.modules["mathutils"].Matrix = np.array
    sys.modules["bpy.app.handlers"].persistent = lambda function: function
    sys.modules["bpy_extras.io_utils"].ImportHelper = type("ImportHelper", (), {})
    sys.path.insert(0, folder)
    return importlib.import_module("sherd_recording")


def scene():
    return types.SimpleNamespace(
        render=types.SimpleNamespace(fps=24, fps_base=1.0), frame_current=0, frame_subframe=0.0,
        collection=types.SimpleNamespace(objects=types.SimpleNamespace(link=lambda _: None)))


def values(target, name):
    return target.data.kept[name].data.values["value"]


def check(target, frame, places, fragments):
    mesh = target.data
    assert np.allclose(mesh.vertices.values["co"].reshape(-1, 3), places, rtol=0, atol=1e-12)
    assert len(mesh.vertices) == len(places) and len(mesh.polygons) == len(frame["face/vertices"])
    assert np.array_equal(mesh.loops.values["vertex_index"].reshape(-1, 3), frame["face/vertices"][:])
    assert np.array_equal(values(target, "fragment"), fragments), (values(target, "fragment"), fragments)
    assert np.array_equal(values(target, "original"), frame["vertex/original"][:])
    assert len(values(target, "strain")) == len(fragments)


def main(folder, recording):
    module, shown = player(folder), scene()
    target = module.load(recording, types.SimpleNamespace(scene=shown), slow=1)
    with h5py.File(recording) as file:
        frames = [file["frames"][name] for name in sorted(file["frames"])]
        times = [frame.attrs["time"] for frame in frames]
        born = 0
        for number, frame in enumerate(frames):
            shown.frame_subframe = (times[number] - times[0]) * 24
            module.show(target, shown)
            check(target, frame, frame["vertex/position"][:], frame["face/fragment"][:])
            if number + 1 == len(frames):
                break
            later = frames[number + 1]
            born += len(later["face/vertices"]) - len(frame["face/vertices"])
            shown.frame_subframe = (0.75 * times[number] + 0.25 * times[number + 1] - times[0]) * 24
            module.show(target, shown)
            # Until the later frame, faces of pieces that the earlier frame does not have belong to piece 0.
            known = np.isin(later["face/fragment"][:], frame["face/fragment"][:])
            fragments = np.where(known, later["face/fragment"][:], 0)
            check(target, later, between(file, number, 0.25), fragments)
    assert born > 0, "no face was born in this recording"
    print(f"the player shows {len(frames)} frames and what is between, with {born} faces born")


if __name__ == "__main__":
    main(*sys.argv[1:])
