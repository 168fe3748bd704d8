# SPDX-License-Identifier: GPL-3.0-or-later
"""clang_test.py BUILD: clang++ finds nothing to warn of in any source of the build folder BUILD."""
import concurrent.futures
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

# What most sources include and what takes clang longest to read, precompiled once. g++ checks who includes what.
HEADERS = ["<CLI/CLI.hpp>", "<Eigen/Eigenvalues>", "<Eigen/SparseCholesky>", "<fmt/ranges.h>", "<gtest/gtest.h>",
           "<nlohmann/json.hpp>", "<openvdb/openvdb.h>", "<rapidcheck/gtest.h>", "<toml++/toml.h>",
           "<unsupported/Eigen/AutoDiff>", "<filesystem>", "<fstream>", "<map>", "<numbers>", "<random>", "<span>",
           '"meshops/mesh.h"']


def clang(entry, *more):
    """Runs clang++ on an entry's compile command, less its source, its output and g++'s precompiled header."""
    words = [word for word in shlex.split(entry["command"])[1:-2] if word != "-Winvalid-pch"]
    for option in ("-include", "-o"):
        if option in words:
            at = words.index(option)
            del words[at:at + 2]
    return subprocess.run(["clang++", *words, "-Werror", *more], cwd=entry["directory"], capture_output=True, text=True)


def precompile(entries, folder):
    """Precompiles HEADERS, templates and all, with the flags of a test of app, which uses every library."""
    header = pathlib.Path(folder) / "headers.h"
    header.write_text("".join(f"#include {name}\n" for name in HEADERS))
    entry = next(entry for entry in entries if "app_tests" in entry["command"])
    done = clang(entry, "-fpch-instantiate-templates", "-x", "c++-header", str(header), "-o", f"{header}.pch")
    sys.stdout.write(done.stdout + done.stderr)
    done.check_returncode()
    return f"{header}.pch"


build = pathlib.Path(sys.argv[1])
entries = [entry for entry in json.loads((build / "compile_commands.json").read_text())
           if "cmake_pch" not in entry["file"]]
with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as two:
    headers = precompile(entries, folder)
    results = list(two.map(lambda entry: clang(entry, "-fsyntax-only", "-include-pch", headers, entry["file"]), entries))
for result in results:
    sys.stdout.write(result.stdout + result.stderr)
print(f"{len(results)} sources, {sum(result.returncode != 0 for result in results)} with warnings or errors")
sys.exit(not results or any(result.returncode for result in results))
