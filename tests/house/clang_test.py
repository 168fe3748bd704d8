# SPDX-License-Identifier: GPL-3.0-or-later
"""clang_test.py BUILD: clang++ finds nothing to warn of in any source of the build folder BUILD."""
import concurrent.futures
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

MESH = pathlib.Path(__file__).resolve().parents[2] / "meshops" / "mesh.h"


def clang(entry, *more):
    """Runs clang++ on an entry's compile command, less its source, its output and g++'s precompiled header."""
    words = [word for word in shlex.split(entry["command"])[1:-2] if word != "-Winvalid-pch"]
    for option in ("-include", "-o"):
        if option in words:
            at = words.index(option)
            del words[at:at + 2]
    return subprocess.run(["clang++", *words, "-Werror", *more], cwd=entry["directory"], capture_output=True, text=True)


def precompile(entry, folder):
    """Precompiles the mesh type, which takes longer to read than all else, with the flags of the entry."""
    clang(entry, "-x", "c++-header", str(MESH), "-o", f"{folder}/{rounding(entry)}.pch").check_returncode()


def rounding(entry):
    return "-frounding-math" in entry["command"]


def check(entry, folder):
    mesh = ["-include-pch", f"{folder}/{rounding(entry)}.pch"] if "-include" in entry["command"] else []
    return clang(entry, "-fsyntax-only", *mesh, entry["file"])


build = pathlib.Path(sys.argv[1])
entries = [entry for entry in json.loads((build / "compile_commands.json").read_text())
           if "cmake_pch" not in entry["file"]]
with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as two:
    one_of_each = {rounding(entry): entry for entry in entries if "-include" in entry["command"]}
    list(two.map(lambda entry: precompile(entry, folder), one_of_each.values()))
    results = list(two.map(lambda entry: check(entry, folder), entries))
for result in results:
    sys.stdout.write(result.stdout + result.stderr)
print(f"{len(results)} sources, {sum(result.returncode != 0 for result in results)} with warnings or errors")
sys.exit(not results or any(result.returncode for result in results))
