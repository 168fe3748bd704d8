# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs Python of pages, and compiles C++ of them."""
import ast
import builtins
import functools
import json
import pathlib
import re
import shlex
import subprocess
import symtable
import sys
import tempfile

from docs_test import TOP, text_of
from scene_snippets import errors_of

# Python that gives names which snippets use and do not define, and these names.
PYTHON_NAMES = {
    "import numpy": {"numpy"},
    "import h5py": {"h5py"},
    "positions, faces = [[0, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0], [0, 0.1, 0]], [[0, 1, 2], [0, 2, 3]]":
        {"positions", "faces"},
    "def blast(positions, time):\n    return 0 * positions": {"blast"},
    "import h5py\nframe = h5py.File('run.h5')['frames/000001']": {"frame"},
    "import sherd\nscene = sherd.Scene('run.toml')\nsimulation = sherd.Simulation(scene)\n"
    "state, numbers = simulation.snapshot(), [0]": {"scene", "simulation", "state", "numbers"},
    "def my_forces(positions):\n    return 0 * positions": {"my_forces"},
    "def my_places():\n    return simulation.positions[held]": {"my_places"},
}
# A scene that is over in no time, with all in its recording that snippets read.
RUN = """
duration = 2e-3
[sheet.plate]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.03 }
place = { translate = [0, 0, 0.004] }
velocity = [0, 0, -5]
pin = { box = [[-0.2, -0.2, -1], [-0.05, 0.2, 1]] }
material = { preset = "glass" }
fracture = { preset = true }
[obstacle.floor]
plane = {}
[[gauge]]
name = "tip"
at = [0.1, 0, 0.004]
[output]
every = 1e-3
fields = ["stress"]
"""
# Parameters that declare names that snippets of C++ use and do not declare.
CPP_NAMES = {
    "bending": "const sherd::CoupledBending& bending",
    "edges": "const std::vector<sherd::Edge>& edges",
    "face": "sherd::Index face",
    "foreign": "const std::vector<char>& foreign",
    "halfedge": "sherd::Halfedge halfedge",
    "loads_less_inertia": "const sherd::Positions& loads_less_inertia",
    "mesh": "const sherd::Mesh& mesh",
    "shell": "const sherd::Shell& shell",
    "vertex": "sherd::Index vertex",
    "x": "const sherd::Positions& x",
}
INCLUDE = re.compile(r"^#include .*$", re.MULTILINE)


def free_names(text):
    """Returns names that Python uses and does not define."""
    top = symtable.symtable(text, "snippet", "exec")

    def used(table):
        return {symbol.get_name() for symbol in table.get_symbols() if symbol.is_global() or table is top}.union(
            *map(used, table.get_children()))

    defined = {symbol.get_name() for symbol in top.get_symbols() if symbol.is_assigned() or symbol.is_imported()}
    return used(top) - defined - set(dir(builtins))


class PythonSnippets:
    """Runs snippets in a folder with the recordings run.h5, plate_drop.h5 and modes.h5 of the program `sherd`. Faults are
    texts."""

    def __init__(self, sherd):
        self.sherd = sherd

    @functools.cached_property
    def folder(self):
        self.keeper = tempfile.TemporaryDirectory()
        folder = pathlib.Path(self.keeper.name)
        for name in ("run", "plate_drop"):
            (folder / f"{name}.toml").write_text(RUN, encoding="utf-8")
            subprocess.run([self.sherd, "run", f"{name}.toml"], cwd=folder, check=True, capture_output=True)
        subprocess.run([self.sherd, "modes", "run.toml", "-n", "2", "-o", "modes.h5"], cwd=folder, check=True,
                       capture_output=True)
        return folder

    def faults(self, text):
        """Returns how Python ends that does not end well. The function of a study's file is called, too."""
        try:
            ast.parse(text)
        except SyntaxError as error:
            return [f"line {error.lineno}: {error.msg}"]
        free = free_names(text)
        frame = [given for given, names in PYTHON_NAMES.items() if names & free]
        call = "import sherd\nmeasure(sherd.Recording('run.h5'))" if "def measure(" in text else ""
        script = self.folder / "snippet.py"
        script.write_text("\n".join([*frame, text, call]), encoding="utf-8")
        return [fault.splitlines()[-1] for fault in errors_of([sys.executable, "-W", "error", script], self.folder)]


def headers_of(text):
    """Returns the headers of the libraries that declare what the text has of sherd."""
    found = set()
    for name in set(re.findall(r"sherd::(\w+)", text)):
        declared = re.compile(rf"^(class|struct|using) {name}\b[^;]*(=|\{{|$)|^[\w:<>,& ]+ {name}\(", re.MULTILINE)
        found |= {str(file.relative_to(TOP)) for floor in ("core", "fracture", "meshops")
                  for file in (TOP / floor).rglob("*.h") if declared.search(text_of(file))}
    return sorted(found)


class CppSnippets:
    """Compiles snippets as the sources of fracture are compiled in a build folder. Faults are texts."""

    def __init__(self, build):
        self.build = build

    @functools.cached_property
    def command(self):
        entries = json.loads(text_of(self.build / "compile_commands.json"))
        command = next(entry["command"] for entry in entries if "/fracture/" in entry["file"]
                       and "/tests/" not in entry["file"] and "cmake_pch" not in entry["file"])
        words = shlex.split(command)
        unused = ["-Wno-unused", "-Wno-unused-parameter"]  # a snippet ends before what it names is used
        return [*words[:words.index("-o")], "-fsyntax-only", *unused, "-x", "c++", "-"]

    def faults(self, text):
        """Returns errors in statements, which are compiled as those of a function whose parameters are the CPP_NAMES
        that they use. They need not include what they name."""
        parameters = [declared for name, declared in CPP_NAMES.items() if re.search(rf"(?<![\w.]){name}\b", text)]
        includes = INCLUDE.findall(text) or [f'#include "{header}"' for header in
                                             headers_of(text + " ".join(parameters))]
        source = "\n".join([*includes, f"void frame({', '.join(parameters)}) {{ {{", '#line 1 "snippet"',
                            INCLUDE.sub("", text), "} }"])
        done = subprocess.run(self.command, input=source, cwd=self.build, capture_output=True, text=True)
        return re.findall(r"^.*error: .*$", done.stderr, re.MULTILINE)[:3] if done.returncode else []
