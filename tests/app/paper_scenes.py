#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs all variants of the paper's scenes, measures what the paper states about them, and checks the statements.

    tests/app/paper_scenes.py build/release/app/sherd [--short] [--keep FOLDER] [--draw FOLDER] [FIGURE...]

FIGURE is the beginning of a scene's name: figure_3. --short: coarse meshes and short runs, for the tests; with
SHERD_SHORT in the environment (tests/long --short) only the first scene. --keep FOLDER: makes recordings there, and
uses existing ones. --draw FOLDER: makes the README's pictures. Prints a table. Exit code 1: a statement does not hold.
"""
import argparse
import concurrent.futures
import itertools
import os
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

SCENES = pathlib.Path(__file__).parents[2] / "scenes" / "paper"


class Run:
    """A recording, with access to its frames by number."""

    def __init__(self, path):
        self.file = h5py.File(path)
        self.names = sorted(self.file["frames"])

    def frame(self, number):
        return self.file["frames"][self.names[number]]

    def positions(self, number):
        return self.frame(number)["vertex/position"][()]


def hinges(run):
    """Returns the hinges of the first sheet: [H, 4] vertices of the first frame, the ends of the edge first."""
    first = run.frame(0)
    faces = first["face/vertices"][()][first["face/sheet"][()] == 0]
    sides = {}
    for a, b, c in faces:
        for i, j, k in ((a, b, c), (b, c, a), (c, a, b)):
            sides.setdefault((min(i, j), max(i, j)), []).append((i, j, k))
    return np.array([(*two[0], two[1][2]) for two in sides.values() if len(two) == 2])


def folds(run, up):
    """Measures the folds of a flat sheet in the second half of the frames. Returns the sum of squared hinge angles,
    mean of these frames, and the means of cos 2a, sin 2a and cos 4a weighted by the squared angles; a: angle of an edge
    at rest, from x to the axis `up`."""
    stencils = hinges(run)
    rest = run.positions(0)
    along = rest[stencils[:, 1]] - rest[stencils[:, 0]]
    angle = np.arctan2(along[:, up], along[:, 0])
    weight = np.zeros(len(stencils))
    for number in range(len(run.names) // 2, len(run.names)):
        p, q, r, s = np.moveaxis(run.positions(number)[stencils], 1, 0)
        one, other = np.cross(q - p, r - p), np.cross(s - p, q - p)
        weight += np.arctan2(np.linalg.norm(np.cross(one, other), axis=1), (one * other).sum(axis=1)) ** 2
    mean = [(weight * wave).sum() / weight.sum() for wave in (np.cos(2 * angle), np.sin(2 * angle), np.cos(4 * angle))]
    return weight.sum() / (len(run.names) - len(run.names) // 2), *mean


def falls(run):
    """Returns the lowest mean height, m, and the highest one after it."""
    heights = np.array([run.positions(number)[:, 2].mean() for number in range(len(run.names))])
    lowest = heights.argmin()
    return heights[lowest], heights[lowest:].max()


def cracks(run):
    """Returns the length of cracks at rest, m, the means of cos 2a and sin 2a weighted by length (a: angle to x from
    above), and the numbers of pieces with more than 1 % of the faces and with one face."""
    first, last = run.frame(0), run.frame(-1)
    rest = run.positions(0)
    open_at_first = {tuple(sorted(edge)) for edge, state in zip(first["edge/vertices"][()], first["edge/state"][()])
                     if state == 2}
    original = last["vertex/original"][()]
    opened = {tuple(sorted(original[edge])) for edge, state in zip(last["edge/vertices"][()], last["edge/state"][()])
              if state == 2} - open_at_first
    ends = np.array(sorted(opened))
    along = rest[ends[:, 1]] - rest[ends[:, 0]]
    length, angle = np.linalg.norm(along, axis=1), np.arctan2(along[:, 1], along[:, 0])
    faces = np.bincount(last["face/fragment"][()])
    return (length.sum(), (length * np.cos(2 * angle)).sum() / length.sum(),
            (length * np.sin(2 * angle)).sum() / length.sum(), (faces > 0.01 * faces.sum()).sum(), (faces == 1).sum())


def stretch(run):
    """Returns the largest length of an edge over its rest length in any frame, and the mean in the last frame."""
    edges = run.frame(0)["edge/vertices"][()]
    lengths = np.array([np.linalg.norm(np.diff(run.positions(number)[edges], axis=1)[:, 0], axis=1)
                        for number in range(len(run.names))])
    return (lengths / lengths[0]).max(), (lengths[-1] / lengths[0]).mean()


def figure_3(measured):
    bounce = {name: values[1] for name, values in measured.items()}
    lowest = {name: values[0] for name, values in measured.items()}
    yield "horizontal bounces highest", max(bounce, key=bounce.get) == "horizontal"
    yield "vertical flattens most", min(lowest, key=lowest.get) == "vertical"


def figure_4(measured):
    high, low = measured["high_shear"], measured["low_shear"]
    yield "high shear aligns folds with the axes", high[3] > low[3] + 0.1
    yield "low shear fits closer, in more folds", low[0] > 2 * high[0]


def figure_5(measured):
    yield "folds turn to the vertical axis", measured["vertical"][1] < measured["isotropic"][1] - 0.1
    yield "folds turn to the horizontal axis", measured["horizontal"][1] > measured["isotropic"][1]
    if "diagonal" in measured:
        yield "folds turn to the diagonal axis", measured["diagonal"][2] > measured["isotropic"][2]


def figure_6(measured):
    for name, wave, sign in (("vertical", 1, -1), ("horizontal", 1, 1), ("diagonal", 2, 1)):
        yield f"cracks follow the {name} axis", sign * (measured[name][wave] - measured["isotropic"][wave]) > 0.25
    yield "cracks follow the weaker direction", measured["isotropic"][1] - measured["strength"][1] > 0.25


def section_8_cylinder(measured):
    largest = [values[0] for _, values in sorted(measured.items(), key=lambda item: -int(item[0]))]
    yield "softer stretches more", all(a < b for a, b in itertools.pairwise(largest))
    yield "none runs away", all(abs(values[1] - 1) < 0.1 for values in measured.values())


def section_8_flag(measured):
    yield "a flag stretched threefold is well-behaved", 2.5 < measured["6"][0] < 4


# By scene: measure and names of its columns, statements to check, and settings of the short version.
FIGURES = {
    "figure_3_cylinders": (falls, ("lowest (m)", "bounce (m)"), figure_3,
                           ["sheet.cylinder.mesh.edge_length=0.018", "solver.step=2e-3", "duration=0.3"]),
    "figure_4_poncho": (lambda run: folds(run, 1), ("bend²", "cos 2a", "sin 2a", "cos 4a"), figure_4,
                        ["sheet.poncho.mesh.edge_length=0.045", "solver.step=5e-3", "duration=0.4"]),
    "figure_5_flags": (lambda run: folds(run, 2), ("bend²", "cos 2a", "sin 2a", "cos 4a"), figure_5,
                       ["sheet.flag.mesh.edge_length=0.05", "solver.step=4e-3", "duration=1"]),
    "figure_6_plates": (cracks, ("cracks (m)", "cos 2a", "sin 2a", "pieces", "of one face"), figure_6,
                        ["sheet.plate.mesh.edge_length=0.012", "duration=0.008", "contact.sheets=false"]),
    "figure_7_bowls": (cracks, ("cracks (m)", "cos 2a", "sin 2a", "pieces", "of one face"), figure_6,
                       ["duration=0.006", "contact.sheets=false"]),
    "section_8_cylinder": (stretch, ("largest stretch", "last mean"), section_8_cylinder, None),
    "section_8_flag": (stretch, ("largest stretch", "last mean"), section_8_flag, None),
}
# Frame and camera of a scene's pictures.
VIEWS = {
    "figure_3_cylinders": ("27", "30,15"),
    "figure_4_poncho": ("-1", "25,20,1.05"),
    "figure_5_flags": ("60", "30,20,1"),
    "figure_6_plates": ("20", "0,60,1.1"),
    "figure_7_bowls": ("15", "0,50"),
    "section_8_cylinder": ("8", "30,15"),
    "section_8_flag": ("-1", "30,20"),
}
# Variants that short runs leave out, because no statement needs them or the mesh is too coarse.
LEFT_OUT = {
    "figure_3_cylinders": {"isotropic"},
    "figure_4_poncho": {"young_20", "young_35", "young_50"},
    "figure_5_flags": {"diagonal"},
    "figure_6_plates": {"paper_rule"},
    "figure_7_bowls": {"paper_rule"},
}


def variants(scene):
    return [line.split('"')[1] for line in (SCENES / f"{scene}.toml").read_text().splitlines() if line.startswith("name = ")]


def record(program, scene, variant, settings, folder):
    """Returns the recording of a variant; runs the scene if there is none yet."""
    recording = folder / f"{scene}-{variant}.h5"
    if not recording.exists():
        arguments = [word for setting in settings for word in ("--set", setting)]
        subprocess.run([program, "run", SCENES / f"{scene}.toml", "--variant", variant, "-o", recording, *arguments],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return Run(recording)


def draw(program, scene, variant, recordings, folder):
    frame, camera = VIEWS[scene]
    subprocess.run([program, "render", recordings / f"{scene}-{variant}.h5", "-o", folder / f"{scene}-{variant}.png",
                    "--frames", frame, "--camera", camera, "--size", "320x200", "--samples", "64", "--force"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def check_figure(program, scene, short, folder):
    """Prints the table of a scene; returns the number of statements that do not hold."""
    measure, columns, statements, settings = FIGURES[scene]
    chosen = [name for name in variants(scene) if not (short and name in LEFT_OUT.get(scene, ()))]
    with concurrent.futures.ThreadPoolExecutor(2) as two:
        runs = list(two.map(lambda name: record(program, scene, name, settings if short else [], folder), chosen))
    measured = {name: measure(run) for name, run in zip(chosen, runs)}
    print(f"| {scene} | {' | '.join(columns)} |\n|{' --- |' * (len(columns) + 1)}")
    for name, values in measured.items():
        print(f"| {name} | {' | '.join(f'{value:.3g}' for value in values)} |")
    print()
    failed = 0
    for statement, holds in statements(measured):
        print(f"{'holds' if holds else 'DOES NOT HOLD'}: {statement}")
        failed += not holds
    print(flush=True)
    return failed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("figures", nargs="*", metavar="FIGURE")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--draw", type=pathlib.Path)
    options = parser.parse_intermixed_args()
    chosen = [scene for scene in FIGURES if not options.figures or scene.startswith(tuple(options.figures))]
    if options.short:
        chosen = [scene for scene in chosen if FIGURES[scene][3] is not None]
        if "SHERD_SHORT" in os.environ:
            chosen = chosen[:1]
    with tempfile.TemporaryDirectory() as folder:
        folder = options.keep or pathlib.Path(folder)
        folder.mkdir(exist_ok=True)
        program = options.program.resolve()
        failed = sum(check_figure(program, scene, options.short, folder) for scene in chosen)
        for scene in chosen if options.draw else []:
            for variant in variants(scene):
                draw(program, scene, variant, folder, options.draw)
    return 1 if failed or not chosen else 0


if __name__ == "__main__":
    sys.exit(main())
