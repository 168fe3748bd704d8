# SPDX-License-Identifier: GPL-3.0-or-later
from __future__ import annotations

import os
import textwrap
from collections.abc import Mapping
from typing import Any

from . import _sherd
from ._toml import lines_of, value_of


def _without_arrays(scene: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Returns the scene with a name in place of each mesh of arrays, and these meshes by name."""
    sheets, meshes = {}, {}
    if not isinstance(scene.get("sheet"), Mapping):
        return dict(scene), meshes
    for name, sheet in scene["sheet"].items():
        mesh = sheet.get("mesh") if isinstance(sheet, Mapping) else None
        if isinstance(mesh, Mapping) and "positions" in mesh and "faces" in mesh:
            rest = {key: value for key, value in mesh.items() if key not in ("positions", "faces")}
            meshes[name] = (mesh["positions"], mesh["faces"])
            sheet = {**sheet, "mesh": {"given": name, **rest}}
        sheets[name] = sheet
    return {**scene, "sheet": sheets}, meshes


class Scene(_sherd.Scene):
    """Scene(source, set={}, variant=""): a scene that has been read and checked.

    source   the file of a scene, or its name: "plate_drop" is plate_drop.toml in the working directory or, if there is
             none, the scene that is installed with the program, beside this Python. Or a dict with the keys of a TOML
             file, in which a sheet's mesh may be arrays: "mesh": {"positions": [V, 3] m, "faces": [F, 3]}, with
             "remesh" for other triangles. Without "remesh" vertices and faces keep their order; those of several sheets
             follow one another. Files in a dict are relative to the working directory.
    set      settings: values by dotted names of keys, {"solver.step": 1e-5}, which replace those of the source
    variant  name of a variant of the scene

    Raises Error with a line for each mistake; for a dict the messages name the scene "<dict>" and lines of `text`.
    Raises TypeError if a value has no equivalent in TOML. The tables of a scene, their keys, and what each may be:

    """

    def __init__(self, source: str | os.PathLike[str] | Mapping[str, Any], set: Mapping[str, Any] | None = None,
                 variant: str = "") -> None:
        overrides = [f"{key}={value_of(value)}" for key, value in (set or {}).items()]
        if isinstance(source, Mapping):
            scene, meshes = _without_arrays(source)
            super().__init__("\n".join(lines_of(scene)) + "\n", "<dict>", overrides, variant, meshes)
        else:
            super().__init__(os.fspath(source), overrides, variant)


Scene.__doc__ = (Scene.__doc__ or "").rstrip() + "\n\n" + textwrap.indent(_sherd.scene_keys(), "    ")
