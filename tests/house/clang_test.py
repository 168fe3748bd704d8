# SPDX-License-Identifier: GPL-3.0-or-later
"""clang_test.py BUILD: clang++ finds nothing to warn of in any source of the build folder BUILD, and each
source has the includes it needs (the build itself precompiles headers, which would hide a missing one)."""
import concurrent.futures
import json
import pathlib
import shlex
import subprocess
import sys

CHECK = ["clang++", "-fsyntax-only", "-Werror"]


def command_of(entry):
    """The compile command of an entry, for clang++ and without precompiled header and output."""
    words = shlex.split(entry["command"])[1:]
    for option in ("-include", "-o"):
        if option in words:
            at = words.index(option)
            del words[at:at + 2]
    return CHECK + [word for word in words if word not in ("-c", "-Werror", "-Winvalid-pch")]


def check(entry):
    return subprocess.run(command_of(entry), cwd=entry["directory"], capture_output=True, text=True)


build = pathlib.Path(sys.argv[1])
entries = [entry for entry in json.loads((build / "compile_commands.json").read_text())
           if "cmake_pch" not in entry["file"]]
with concurrent.futures.ThreadPoolExecutor(2) as two:
    results = list(two.map(check, entries))
for result in results:
    sys.stdout.write(result.stdout + result.stderr)
print(f"{len(results)} sources, {sum(result.returncode != 0 for result in results)} with warnings or errors")
sys.exit(not results or any(result.returncode for result in results))
