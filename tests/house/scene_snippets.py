# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds TOML of pages against the program and its schema: whole scenes, parts of them, single lines, and studies."""
import functools
import json
import pathlib
import re
import subprocess
import tempfile
import tomllib

import jsonschema

# Completes sheets of which a page shows a part.
SHEET = {"mesh": {"generate": "disc", "radius": 0.1, "edge_length": 0.02}, "material": {"preset": "glass"},
         "pin": {"boundary": True}}
SHAPES = {"plane", "sphere", "box", "mesh", "vdb"}  # shapes of obstacles
MESHES = {"file", "given", "generate"}


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def errors_of(command, folder):
    """Returns what a command says if it fails, else an empty list."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    return [done.stderr.strip() or f"exit code {done.returncode}"] if done.returncode else []


def is_whole(scene):
    return "sheet" in scene and ("duration" in scene or scene.get("solver", {}).get("scheme") == "static")


def completed(part):
    """Returns a scene that is valid if the part of a scene is: sheets get a mesh, a material and supports, obstacles a
    shape."""
    is_static = part.get("solver", {}).get("scheme") == "static"
    scene = {**({} if is_static else {"duration": 0.01}), "sheet": {"plate": {}}, **part}
    scene["sheet"] = {name: {**SHEET, **sheet} for name, sheet in scene["sheet"].items()}
    for sheet in scene["sheet"].values():
        sheet["material"] = SHEET["material"] | sheet["material"]
        if isinstance(sheet["mesh"], dict) and not MESHES & set(sheet["mesh"]):
            sheet["mesh"] = SHEET["mesh"] | sheet["mesh"]
    for obstacle in scene.get("obstacle", {}).values():
        if not SHAPES & set(obstacle):
            obstacle["plane"] = {"point": [0, 0, -1]}
    return scene


def coarsened(scene):
    """Returns a scene with at most some thousand faces a sheet, so that it is read in no time."""
    for sheet in scene["sheet"].values():
        mesh = sheet.get("mesh")
        if isinstance(mesh, dict) and "edge_length" in mesh:
            sizes = [value for value in mesh.values() if isinstance(value, (int, float))]
            mesh["edge_length"] = max(mesh["edge_length"], max(sizes) / 30)
    return scene


def toml(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(key)} = {toml(inner)}" for key, inner in value.items()) + " }"
    return "[" + ", ".join(map(toml, value)) + "]" if isinstance(value, list) else json.dumps(value)


def dotted(table, place=""):
    """Yields a line of TOML for each value in a table and in those within. An inline table would replace what it
    stands for, if it is a variant's."""
    for key, value in table.items():
        if isinstance(value, dict) and value:
            yield from dotted(value, f"{place}{json.dumps(key)}.")
        else:
            yield f"{place}{json.dumps(key)} = {toml(value)}\n"


def written(scene):
    """Returns a scene as TOML."""
    parts = [{key: value for key, value in scene.items() if key != "variant"}, *scene.get("variant", [])]
    return "[[variant]]\n".join("".join(dotted(part)) for part in parts)


def strings(value):
    """Yields all strings in a value of TOML."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, (dict, list)):
        for inner in value.values() if isinstance(value, dict) else value:
            yield from strings(inner)


class SceneSnippets:
    """Scenes and studies as the program `sherd` reads them. Faults are texts."""

    def __init__(self, sherd):
        self.sherd = sherd

    @functools.cached_property
    def validator(self):
        return jsonschema.Draft202012Validator(json.loads(output_of(self.sherd, "scenes", "--schema")))

    @functools.cached_property
    def shipped(self):
        """All scenes and studies that come with the program, by the names that commands take."""
        listed = json.loads(output_of(self.sherd, "scenes", "--json"))
        folder = pathlib.Path(listed[0]["file"]).parent
        names = {str(file.relative_to(folder).with_suffix("")) for file in folder.rglob("*.toml")}
        return names | {file.stem for file in (folder / "studies").glob("*.toml")}

    def schema_faults(self, scene):
        return [f"{'.'.join(map(str, error.absolute_path))}: {error.message}"
                for error in self.validator.iter_errors(scene)]

    def faults_of_scene(self, scene):
        """Returns what is wrong with a scene: by the program, or by the schema if it names files."""
        if any(re.search(r"\.\w{2,4}$", text) for text in strings(scene)):
            return self.schema_faults(scene)
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "scene.toml").write_text(written(coarsened(scene)), encoding="utf-8")
            return errors_of([self.sherd, "check", "--no-try", "scene.toml"], folder)

    def faults_of_study(self, text):
        """Returns what is wrong with a study: what keeps `sherd sweep --status` from counting its rows."""
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "study.toml").write_text(text, encoding="utf-8")
            return errors_of([self.sherd, "sweep", "study.toml", "--status"], folder)

    def faults_of_block(self, text):
        """Returns what is wrong with a study, a scene, or a part of one, whose first lines may stand in a sheet."""
        try:
            scene = tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            return [str(error)]
        if "parameters" in scene:
            return self.faults_of_study(text)
        if is_whole(scene):
            return self.faults_of_scene(scene)
        in_sheet = completed({"sheet": {"plate": scene}})
        return self.faults_of_scene(completed(scene) if self.schema_faults(in_sheet) else in_sheet)

    @functools.cached_property
    def tables(self):
        """The keys of each table of scenes, with the schemas of their values."""
        found, waiting = [], [self.validator.schema]
        while waiting:
            value = waiting.pop()
            if isinstance(value, dict):
                found += [value["properties"]] if isinstance(value.get("properties"), dict) else []
                waiting += value.values()
            elif isinstance(value, list):
                waiting += value
        return found

    def faults_of_line(self, text):
        """Returns what is wrong with a line of a scene or of a study, which may stand in any table."""
        try:
            keys = tomllib.loads(text)
        except tomllib.TOMLDecodeError:
            return []  # a formula, or words in capitals that stand for numbers
        if any(all(key in table and self.validator.evolve(schema=table[key]).is_valid(value)
                   for key, value in keys.items()) for table in self.tables):
            return []
        studies = (f'scene = "plate_drop"\nparameters.{line}' for line in
                   (f"seed = [1]\n{text}", f"seed = {{ from = 1, to = 9, steps = 2, {text} }}"))
        if any(not self.faults_of_study(study) for study in studies):
            return []
        return [f"{text} may stand in no table of a scene or of a study"]

    def faults_of_setting(self, setting):
        """Returns what is wrong with the KEY=VALUE of --set, whose words may lack quotation marks."""
        key, equals, value = setting.partition("=")
        if not equals:
            return [f"--set {setting} has no value"]
        try:
            part = tomllib.loads(f"{key} = {value}")
        except tomllib.TOMLDecodeError:
            part = tomllib.loads(f"{key} = {json.dumps(value)}")
        return [f"--set {setting}: {fault}" for fault in self.schema_faults(completed(part))]
