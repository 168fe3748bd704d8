#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the frozen scenes with two programs and tells whether the second program reproduces the results of the first.

    tests/frozen/compare.py OLD_SHERD NEW_SHERD [SCENE...] [--steps N] [--keep FOLDER]

SCENE is the beginning of a name (plate_drop, figure_6). --steps: only the first N steps of each. For each scene and
variant all datasets are compared bit by bit; new datasets, which the old program does not write, are listed and
ignored. Where bits differ, a run that breaks nothing must agree to 1e-9 of each quantity's size; if a run breaks
something, the number of fragments, the length of the cracks and the energies at the end must lie within the range of
the old program's results with five seeds, and with those of three kernels of OpenBLAS that the processor has. Exit
code 1: a run does not agree.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

import h5py
import numpy as np

HERE = pathlib.Path(__file__).parent
TOLERANCE = 1e-9  # largest difference over the size of the quantity
KERNELS = ("Prescott", "Haswell", "SkylakeX")
SEEDS = range(101, 106)


class Case:
    """A frozen scene in one of its variants, which run() runs."""

    def __init__(self, scene, variant, steps):
        self.scene = scene
        self.variant = variant
        self.name = f"{scene.stem}{'-' + variant if variant else ''}"
        with open(scene, "rb") as file:
            content = tomllib.load(file)
        self.duration = content["duration"]
        if steps:
            self.duration = min(self.duration, steps * content["solver"]["step"])

    def run(self, program, recording, kernel=None, seed=None):
        command = [program, "run", self.scene, "-o", recording, "--force", "--set", f"duration={self.duration!r}"]
        if self.variant:
            command += ["--variant", self.variant]
        if seed is not None:
            command += ["--set", f"seed={seed}"]
        environment = dict(os.environ, **({"OPENBLAS_CORETYPE": kernel} if kernel else {}))
        done = subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        words = done.stderr.strip().splitlines()[-1:] or [f"exit code {done.returncode}"]
        return recording if done.returncode == 0 else f"{program} fails: {words[0]}"


def cases(beginnings, steps):
    """Yields the frozen scenes with these beginnings of names, in each of their variants."""
    for scene in sorted(HERE.glob("*.toml")):
        if beginnings and not any(scene.stem.startswith(beginning) for beginning in beginnings):
            continue
        with open(scene, "rb") as file:
            variants = [variant["name"] for variant in tomllib.load(file).get("variant", [])]
        for variant in variants or [""]:
            yield Case(scene, variant, steps)


def datasets(recording):
    """Returns all datasets of a recording by name."""
    found = {}
    with h5py.File(recording) as file:
        file.visititems(lambda name, item: found.update({name: np.asarray(item[()])}) if isinstance(item, h5py.Dataset) else None)
    return found


def new_datasets(one, other):
    """Lists the datasets that only the second recording has, with frames and new groups summed up, as text."""
    old_groups = {name.rpartition("/")[0] for name in one}
    new = {name if group in old_groups else f"{group}/*"
           for name in other.keys() - one.keys() for group in [name.rpartition("/")[0]]}
    new = {re.sub(r"^frames/\d+/", "frames/*/", name) for name in new}
    return f"; new datasets: {', '.join(sorted(new))}" if new else ""


def same_bits(one, other):
    return one.keys() == other.keys() and all(
        one[name].dtype == other[name].dtype and np.array_equal(one[name], other[name], equal_nan=one[name].dtype.kind == "f")
        for name in one)


def largest_difference(one, other):
    """Returns the largest difference over the quantity's largest magnitude in the run, and the name of the dataset."""
    sizes, worst = {}, (0.0, "")
    for name, values in one.items():
        if values.dtype.kind == "f" and values.size:
            quantity = name.split("/", 2)[-1] if name.startswith("frames/") else name
            sizes[quantity] = max(sizes.get(quantity, 0), np.nanmax(np.abs(values)))
    energies = [f"steps/{kind}" for kind in ("kinetic", "bending", "membrane", "gravity", "contact")]
    scale = max((sizes[name] for name in energies if name in sizes), default=0)
    sizes.update({name: scale for name in energies})  # a common scale, because a single energy may be all round-off
    for name, values in one.items():
        if values.dtype.kind != "f" or not values.size:
            continue
        if name not in other or other[name].shape != values.shape:
            return np.inf, name
        quantity = name.split("/", 2)[-1] if name.startswith("frames/") else name
        difference = np.nanmax(np.abs(values - other[name])) / (sizes[quantity] or 1)
        worst = max(worst, (difference, name))
    return worst


def statistics(recording):
    """Returns fragments, length of cracks (m) and energies (J) at the end, which are compared for runs that break."""
    with h5py.File(recording) as file:
        steps, events = file["steps"], file["events/failure"]
        last = file["frames"][sorted(file["frames"])[-1]]
        rest = (last if "rest" in last else file)["rest/position"][()]
        ends = last["vertex/original"][()][events["vertices"][()]]
        length = np.linalg.norm(rest[ends[:, 0]] - rest[ends[:, 1]], axis=1).sum()
        energies = {kind: float(steps[kind][-1]) for kind in ("kinetic", "bending", "membrane", "contact")}
        return {"fragments": int(steps["fragments"][-1]), "crack length": float(length)} | energies


def outside(case, old, new, folder, pool):
    """Returns the statistics of `new` outside the range of the old program's, as text; empty if there are none."""
    runs = {pool.submit(case.run, old, folder / f"{case.name}-{kernel}-{seed}.h5", kernel, seed)
            for kernel in KERNELS for seed in SEEDS}
    runs |= {pool.submit(case.run, old, folder / f"{case.name}-{kernel}.h5", kernel) for kernel in KERNELS}
    # The processor may lack a kernel, with which all runs then fail.
    spread = [statistics(run.result()) for run in runs if not isinstance(run.result(), str)]
    found = []
    for name, value in statistics(new).items():
        values = [one[name] for one in spread]
        if not min(values) <= value <= max(values):
            found.append(f"{name} {value:.6g}, not {min(values):.6g} to {max(values):.6g}")
    return "; ".join(found)


def compare(case, old_program, new_program, folder, pool):
    """Returns the result of the comparison as text, and whether the runs agree."""
    runs = [pool.submit(case.run, program, folder / f"{case.name}-{age}.h5")
            for program, age in ((old_program, "old"), (new_program, "new"))]
    old, new = (run.result() for run in runs)
    for failure in (old, new):
        if isinstance(failure, str):
            return failure, False
    one, other = datasets(old), datasets(new)
    more = new_datasets(one, other)
    other = {name: values for name, values in other.items() if name in one}
    if same_bits(one, other):
        return f"same bits{more}", True
    difference, where = largest_difference(one, other)
    if not len(one["events/failure/edge"]) and not len(other["events/failure/edge"]):
        return f"differs by {difference:.2g} of its size ({where}){more}", difference <= TOLERANCE
    wrong = outside(case, old_program, new, folder, pool)
    return (wrong or f"other bits; fragments, cracks and energies within the spread ({where})") + more, not wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=pathlib.Path)
    parser.add_argument("new", type=pathlib.Path)
    parser.add_argument("scene", nargs="*")
    parser.add_argument("--steps", type=int)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_intermixed_args()
    good = True
    with tempfile.TemporaryDirectory() as temporary, concurrent.futures.ThreadPoolExecutor(2) as pool:
        folder = options.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for case in cases(options.scene, options.steps):
            verdict, fine = compare(case, options.old.resolve(), options.new.resolve(), folder, pool)
            good &= fine
            print(f"{'ok  ' if fine else 'FAIL'} {case.name}: {verdict}", flush=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
