#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""mutated_files.py SHERD [--files N] [--seed N] [--keep FOLDER]

Gives N damaged files to the real program: recordings, checkpoints and OpenVDB grids. A command that reads one must end
within 20 CPU seconds and 4 GB, with exit code 0 or 2 (`run --resume` also with 1), never by a signal; its messages must
be Sherd's own. A file that violates this is kept in FOLDER, and the command is printed. Damage depends on the seed
only. SHERD_SHORT in the environment: at most 100 files.
"""
import argparse
import os
import pathlib
import random
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

from limits import limit

PLATE = """
[sheet.plate]
mesh = { generate = "disc", radius = 0.05, edge_length = 0.03 }
place = { translate = [0, 0, 0.003] }
velocity = [0, 0, -5]
fracture = { strain = 0.05%s }
[solver]
step = 2e-4
"""
SCENES = {
    "run.toml": "duration = 0.001" + PLATE % "" + """
[output]
every = 5e-4
checkpoint = 1e-9  # after each step: a run that ends before the first keeps none
fields = ["stress"]
[obstacle.floor]
plane = {}
[obstacle.ball]
sphere = { radius = 0.02, centre = [0.2, 0, 0.02] }
""",
    "obstacle.toml": "duration = 0.001" + PLATE % "" + '[obstacle.body]\nvdb = { file = "a.vdb", scale = 0.5 }\n',
    "map.toml": "duration = 0.001" + PLATE % ', map = { vdb = "a.vdb", range = [1, 2] }',
}
MATERIAL = 'material = { preset = "stoneware" }\n'
READERS = [["info", "run.h5"], ["info", "--json", "run.h5"], ["export", "run.h5", "--to", "glb", "--frames", "all"],
           ["render", "run.h5", "-o", "p", "--frames", "-1", "--size", "32x32", "--samples", "1"], ["plot", "run.h5"],
           ["view", "run.h5"], ["export", "run.h5", "--to", "obj", "--fragments"], ["run", "run.toml", "--resume"]]
SECONDS, MEMORY = 20, 4 << 30
# Markers with which HDF5 and OpenVDB begin parts of a file's structure.
LANDMARKS = re.compile(rb"TREE|HEAP|SNOD|GCOL|\x89HDF|OHDR|Tree_float|file_bbox|Affine|Scale")
WORDS = [b"\0" * 8, b"\xff" * 8, b"\xff" * 4, struct.pack("<q", 1 << 40), struct.pack("<i", 1 << 30),
         struct.pack("<q", -1), struct.pack("<d", float("nan")), struct.pack("<f", 1e38), b"\x01", b"\x7f"]
# Text of the standard library's exceptions, which no message of Sherd contains.
FOREIGN = re.compile(r"std::|bad_alloc|basic_string|vector::|Assertion|terminate called")


def place(content, chance):
    """Returns a random offset: often near the file's structure, otherwise at a byte that is not zero."""
    marks = [match.start() for match in LANDMARKS.finditer(content)]
    if marks and chance.random() < 0.4:
        return min(chance.choice(marks) + chance.randrange(96), len(content) - 1)
    for _ in range(40):
        at = chance.randrange(len(content))
        if content[at]:
            break
    return at


def mutated(content, chance):
    content = bytearray(content)
    for _ in range(chance.choice((1, 1, 2, 4, 16))):
        at, size = place(bytes(content), chance), chance.randrange(1, 17)
        kind = chance.randrange(8)
        if kind < 3:
            content[at] ^= 1 << chance.randrange(8)
        elif kind == 3:
            content[at] = chance.randrange(256)
        elif kind < 6:
            word = chance.choice(WORDS)
            content[at:at + len(word)] = word
        elif kind == 6:
            other = place(bytes(content), chance)
            content[at:at + size] = content[other:other + size]
        elif chance.random() < 0.2:
            del content[max(1, at):]
        else:
            del content[at:at + size]
    return bytes(content)


class Program:
    def __init__(self, sherd, folder):
        self.sherd, self.folder = sherd, folder

    def run(self, *arguments):
        """Runs a command. Returns its exit code (negative: a signal; None: timeout) and its messages."""
        environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
        try:
            done = subprocess.run([self.sherd, *arguments], cwd=self.folder, capture_output=True, env=environment,
                                  timeout=10 * SECONDS, preexec_fn=lambda: limit(MEMORY, SECONDS))
        except subprocess.TimeoutExpired:
            return None, ""
        return done.returncode, done.stderr.decode(errors="replace")


def prepare(program):
    """Makes the undamaged files; returns their contents by name."""
    for name, text in SCENES.items():
        (program.folder / name).write_text(text.replace("velocity", MATERIAL + "velocity"))
    grid = ["export", "run.h5", "--to", "vdb", "--frames", "0", "--sheets-only", "--voxel", "0.002", "-o", "a.vdb"]
    for command in (["run", "run.toml"], grid, ["check", "obstacle.toml"], ["check", "map.toml"]):
        code, words = program.run(*command)
        if code != 0:
            sys.exit(f"{' '.join(command)} of files that are whole: exit code {code}\n{words}")
    return {path.name: path.read_bytes() for path in program.folder.iterdir()}


def case(number, files):
    """Returns the file to damage in this case, and the command that reads it."""
    if number % 2 == 0:
        return "a.vdb", ["check", "obstacle.toml" if number % 4 else "map.toml"]
    command = READERS[number // 2 % len(READERS)]
    name = "run.h5"
    if "--resume" in command and number % 3:
        name = next(file for file in files if "checkpoint" in file)
    return name, command


def fault(command, code, words):
    """Returns a description of what is wrong with the end of a command, or None."""
    if code in (None, -signal.SIGXCPU):
        return f"takes more than {SECONDS} s"
    if code < 0:
        return f"ended by signal {-code}"
    if code not in ((0, 1, 2) if "--resume" in command else (0, 2)):
        return f"exit code {code}: {words.strip()[-300:]}"
    if FOREIGN.search(words):
        return f"says {words.strip()[-300:]}"
    return "says nothing" if code and not words.strip() else None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sherd", type=pathlib.Path)
    parser.add_argument("--files", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    wanted = parser.parse_args()
    if "SHERD_SHORT" in os.environ:
        wanted.files = min(wanted.files, 100)
    chance, faults, ends, slowest = random.Random(wanted.seed), 0, {}, 0.0
    with tempfile.TemporaryDirectory(prefix="sherd-test-") as name:
        program = Program(wanted.sherd.resolve(), pathlib.Path(name))
        files = prepare(program)
        for number in range(wanted.files):
            for path in program.folder.iterdir():
                if path.name not in files:
                    shutil.rmtree(path) if path.is_dir() else path.unlink()
            for path, content in files.items():
                (program.folder / path).write_bytes(content)
            damaged, command = case(number, files)
            content = mutated(files[damaged], chance)
            (program.folder / damaged).write_bytes(content)
            begin = time.monotonic()
            code, words = program.run(*command)
            slowest = max(slowest, time.monotonic() - begin)
            kind = damaged.split(".")[1]
            ends[kind, code] = ends.get((kind, code), 0) + 1
            found = fault(command, code, words)
            if not found:
                continue
            faults += 1
            print(f"{number}: sherd {' '.join(command)}, {damaged}: {found}", flush=True)
            if wanted.keep:
                wanted.keep.mkdir(parents=True, exist_ok=True)
                (wanted.keep / f"{number}-{damaged}").write_bytes(content)
    counts = ", ".join(f"{count} {kind} with {code}" for (kind, code), count in sorted(ends.items(), key=str))
    print(f"{wanted.files} files, {faults} faults; {counts}; the slowest took {slowest:.1f} s")
    refused = sum(count for (_, code), count in ends.items() if code)
    if refused < wanted.files // 10:
        sys.exit("the mutations do no harm: the test tests nothing")
    sys.exit(faults > 0)


if __name__ == "__main__":
    main()
