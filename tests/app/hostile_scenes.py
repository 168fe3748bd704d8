#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""hostile_scenes [--short | --long] [--table] SHERD [NAME]...: runs scenes that a hurried or malicious user might write
(hostile_scenes_list.py) with the real program, with each scheme that they name. A run must end with finite numbers,
balanced energy and vertices within bounds; a refused scene needs a message that tells what is wrong, and `sherd check`
must refuse it, too. --short takes the first scheme of each scene, with SHERD_SHORT of every other one; --long adds the long
scenes, or with SHERD_SHORT takes the other schemes of every fourth scene; --table prints the results as a table. Exit code 1: a scene did not end
as required."""
import argparse
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

import h5py
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import hostile_scenes_list  # noqa: E402
from limits import limit  # noqa: E402

PATIENCE = 120  # s of processor time, after which a run counts as hanging
MEMORY = 4 << 30  # bytes of address space of a run
UNEXPLAINED = 1e-6  # energy residual over the largest energy
# Largest energy gained by a scheme, over the largest energy. Explicit contact springs begin and end within a substep,
# whose length times their frequency is at most 0.53; their error is up to a quarter of the square of that product.
GAINED = {"implicit": 1e-6, "explicit": 0.07, "auto": 0.07}
LOSSES = ["lost_to_friction", "lost_to_damping", "lost_to_cracks", "lost_to_remeshing", "lost_to_yield",
          "lost_to_scheme"]
CREEP = 1e-3  # m/s
WORK = ["work_of_loads", "work_of_wind", "work_of_supports", "work_of_obstacles"]
STORED = ["kinetic", "bending", "membrane", "contact"]


def call(sherd, *words):
    done = subprocess.run([sherd, *map(str, words)], capture_output=True, text=True, check=False,
                          preexec_fn=lambda: limit(MEMORY, PATIENCE))
    return done.returncode, done.stdout, done.stderr


def not_finite(file):
    """Returns the names of datasets that contain a NaN or an infinity."""
    bad = []

    def look(name, item):
        if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" and not numpy.isfinite(item[()]).all():
            bad.append(name)
    file.visititems(look)
    return bad


def largest_energy(steps, start):
    """Returns the largest of the stored, kinetic and exchanged energies (J), at least that of the speed CREEP."""
    mass, speed = start["vertex/mass"][:], start["vertex/speed"][:]
    energy = [0.5 * (mass * speed ** 2).sum(), mass.sum() * CREEP ** 2, numpy.ptp(steps["gravity"][:])]
    energy += [numpy.abs(steps[name][:]).max() for name in STORED + WORK]
    return max(energy)


def faults(file, scene, scheme, code):
    """Returns descriptions of what is wrong with a recording. code: exit code of the run."""
    found = [f"{name} is not finite" for name in not_finite(file)]
    frames = [file["frames"][name] for name in sorted(file["frames"])]
    farthest = max(numpy.abs(frame["vertex/position"][:]).max() for frame in frames)
    if not farthest <= scene.within:
        found.append(f"a vertex got {farthest:.3g} m away, more than {scene.within:g}")
    steps = file["steps"]
    if len(steps["time"]) == 0:
        return found + (["not a step was made"] if code == 0 else [])
    largest = largest_energy(steps, frames[0])
    unexplained = numpy.abs(steps["unexplained"][:]).max() / largest
    if not unexplained <= scene.unexplained:
        found.append(f"{unexplained:.2g} of the largest energy is unexplained")
    gained = -sum(steps[name][:] for name in LOSSES).min() / largest
    if not gained <= max(scene.gained, GAINED[scheme]):
        found.append(f"{gained:.2g} of the largest energy came from nowhere")
    fragments = int(steps["fragments"][-1])
    if code == 0 and scene.fragments and not scene.fragments[0] <= fragments <= scene.fragments[1]:
        found.append(f"{fragments} fragments instead of {scene.fragments}")
    if code == 0 and scene.holds:
        found += [words for words in [scene.holds(file, frames)] if words]
    return found


def outcome(file):
    frames, steps = file["frames"], file["steps"]
    last = frames[sorted(frames)[-1]]
    fastest = numpy.linalg.norm(last["vertex/velocity"][:], axis=1).max()
    count = int(steps["fragments"][-1]) if len(steps["fragments"]) else 0
    return f"{count} {'piece' if count == 1 else 'pieces'}, {fastest:.2g} m/s at the end"


def words_of(errors):
    errors = re.sub(r"/\S*/(?=mesh\.)", "", errors)
    lines = [line.removeprefix("sherd: error: ") for line in errors.splitlines() if line.startswith("sherd: error: ")]
    return lines[0].split("scene.toml")[-1].lstrip(":0123456789 ") if lines else errors.strip()[-200:]


def run(sherd, folder, scene, scheme):
    """Runs a scene with a scheme. Returns descriptions of failures, a summary of the result, and the exit code."""
    text = folder / "scene.toml"
    text.write_text(scene.text)
    for name, content in scene.files.items():
        (folder / name).write_text(content)
    chosen = [] if scheme == "implicit" else ["--set", f"solver.scheme={scheme}"]
    recording = folder / "run.h5"
    recording.unlink(missing_ok=True)
    code, _, errors = call(sherd, "run", text, "-o", recording, "--force", *chosen)
    wanted = scene.error(scheme)
    found = []
    if code < 0:
        return [f"ended by signal {-code}: {errors[-300:]}"], "", code
    allowed = ({0, 1} if wanted.code == 1 else {wanted.code}) if wanted else {0}
    if code not in allowed:
        found.append(f"exit code {code}, none of {allowed}: {errors[-1500:]}")
    if wanted and code != 0:
        found += [f"the message lacks '{words}': {errors[-1500:]}" for words in wanted.words if words not in errors]
    if code == 2:
        checked, _, said = call(sherd, "check", text, *chosen)
        if checked != 2 or words_of(said) != words_of(errors):
            found.append(f"check ends with {checked}: {said[-500:]}")
        if recording.exists():
            found.append("it left a recording")
    if code in (0, 1) and recording.exists():
        with h5py.File(recording) as file:
            wrong = faults(file, scene, scheme, code)
            return found + wrong, outcome(file) if code == 0 else words_of(errors), code
    return found, words_of(errors), code


def told(sherd, scene, schemes):
    """Runs a scene with these schemes and prints a line for each. Returns [(scheme, faults, summary, exit code)]."""
    results = []
    for scheme in schemes:
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        with tempfile.TemporaryDirectory() as folder:
            found, words, code = run(sherd, pathlib.Path(folder), scene, scheme)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        print(f"{scene.name}, {scheme}: {code}, {seconds:.1f} s, {words}", file=sys.stderr, flush=True)
        for fault in found:
            print(f"    {scene.name}, {scheme}: {fault}", file=sys.stderr, flush=True)
        results.append((scheme, found, words, code))
    return results


def row(scene, results):
    exits = " ".join(f"{code}" for _, _, _, code in results)
    words = results[0][2].replace("|", "/")
    return f"| `{scene.name}` | {scene.what} | {', '.join(scheme for scheme, *_ in results)} | {exits} | {words} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for option in ("--short", "--long", "--table"):
        parser.add_argument(option, action="store_true")
    parser.add_argument("sherd")
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_intermixed_args()
    sherd = str(pathlib.Path(arguments.sherd).resolve())
    brief = arguments.long and os.environ.get("SHERD_SHORT")
    scenes = [scene for scene in hostile_scenes_list.SCENES
              if (scene.name in arguments.names if arguments.names else (arguments.long and not brief) or not scene.long)]
    if brief:
        scenes = [scene for scene in scenes if len(scene.schemes) > 1][::4]
    elif arguments.short and os.environ.get("SHERD_SHORT") and not arguments.names:
        scenes = scenes[::2]
    if arguments.table:
        print("| scene | what it is | steps | exit | what happens with the first of them |\n" + "| --- " * 5 + "|")
    failures = 0
    for scene in scenes:
        schemes = scene.schemes[:1] if arguments.short else scene.schemes[1:] if brief else scene.schemes
        results = told(sherd, scene, schemes)
        failures += sum(bool(found) for _, found, _, _ in results)
        if arguments.table:
            print(row(scene, results), flush=True)
    print(f"{len(scenes)} scenes, {failures} runs with faults", file=sys.stderr)
    sys.exit(1 if failures or not scenes else 0)


if __name__ == "__main__":
    main()
