#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""blow_resume SHERD [--blows N] [--first SEED] [--jobs N] [--seed SEED [--keep DIR]]: random sheets that crack under
the impact of bodies, most with the scheme "auto", many in steps that are halved. Each runs once as a whole, and once in
two parts: stopped at a time or killed, and resumed with another number of threads. Neither run may crash, and both
recordings must be bitwise equal. Exit code 1: a run crashed, or recordings differ."""
import os
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import argparse  # noqa: E402
import collections  # noqa: E402
import multiprocessing  # noqa: E402
import pathlib  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import tempfile  # noqa: E402

import h5py  # noqa: E402
import numpy  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent), str(HERE.parents[1] / "support")]
import recording_content  # noqa: E402
from blow_parts import Chance, placed, striker_shape, vector  # noqa: E402
from limits import limit  # noqa: E402

MEMORY = 4 << 30  # bytes
PATIENCE = 120  # s of processor time
FRAGILE = ["glass", "stoneware", "porcelain", "eggshell", "pmma", "plaster"]


def sheet(chance, size):
    """Returns scene text of a sheet that cracks."""
    edge = size * chance.uniform(0.08, 0.16)
    shape = chance.choice(["rectangle", "disc", "bowl", "sphere"])
    extent = f"width = {size:.6g}, height = {size:.6g}" if shape == "rectangle" else f"radius = {size / 2:.6g}"
    mesh = f'{{ generate = "{shape}", {extent}, edge_length = {edge * (1.5 if shape == "sphere" else 1):.6g} }}'
    middle = [-size / 2, -size / 2, 0] if "rectangle" in mesh else [0, 0, -size / 2] if "sphere" in mesh else [0, 0, 0]
    fracture = chance.choice(["preset = true", "preset = true", f"strain = {chance.between(0.1, 2):.4g}",
                              f"strength = {chance.between(1e6, 5e7):.4g}, weibull = 8"])
    thickness = size * chance.between(0.005, 0.05)
    lines = ["[sheet.struck]", f"mesh = {mesh}", f"place = {{ translate = {vector(middle)} }}",
             f"fracture = {{ {fracture} }}",
             f'material = {{ preset = "{chance.choice(FRAGILE)}", thickness = {thickness:.6g} }}']
    if chance.random() < 0.2 and "sphere" not in mesh:
        lines.append("pin = { boundary = true }")
    return lines


def body(chance, number, size, speed, height):
    """Returns scene text of a free body that flies down from this height, its files, and the height of the next (m)."""
    kind = chance.choice(["sphere", "sphere", "box", "rod", "mesh"])
    large = size * chance.between(0.08, 0.3)
    shape = striker_shape(chance, large, kind)
    reach = numpy.linalg.norm(shape.solid[0], axis=1).max()
    at = [chance.uniform(-0.2, 0.2) * size, chance.uniform(-0.2, 0.2) * size, height + reach]
    lines = [f"[obstacle.body{number}]", shape.words.replace("striker.", f"body{number}."),
             placed(chance.direction(), chance.uniform(0, 180), at), f"density = {chance.between(500, 12000):.4g}",
             f"velocity = {vector([0, 0, -speed])}", f"friction = {chance.uniform(0, 0.6):.3g}"]
    files = {name.replace("striker.", f"body{number}."): text for name, text in shape.files.items()}
    return lines, files, height + 2.1 * reach


def solver(chance, steps):
    """Returns scene text of the solver, and the length of a step (s)."""
    scheme = chance.choice(["auto"] * 6 + ["implicit-euler", "bdf2", "explicit", "explicit"])
    step = chance.between(2e-6, 1e-5) if scheme == "explicit" else chance.between(2e-5, 2e-4)
    lines = ["[solver]", f'scheme = "{scheme}"', f"step = {step:.6g}"]
    if scheme != "explicit" and chance.random() < 0.5:
        lines.append(f"max_iterations = {chance.randint(1, 4)}")
    if chance.random() < 0.4:
        lines.append(f"damping = {{ stiffness = {chance.between(1e-9, 2e-8):.4g} }}")
    return lines + ["[output]", f"every = {step * 2:.6g}", "checkpoint = 0.02"], step


def scene(seed):
    """Returns the text of a scene, its files, its duration (s), and the random generator."""
    chance = Chance(seed)
    size, steps = chance.between(0.03, 0.3), chance.randint(10, 24)
    end, step = solver(chance, steps)
    speed = min(chance.between(8, 100), 0.3 * size / step)
    lines, files = [f"duration = {step * steps:.6g}", f"seed = {seed}"] + sheet(chance, size), {}
    if chance.random() < 0.5:
        deep = size * chance.uniform(0.03, 0.3) + (size if "sphere" in lines[3] else 0)
        lines += ["[obstacle.floor]", f"plane = {{ point = [0, 0, {-deep:.6g}] }}", "friction = 0.3"]
    height = size * (0.12 if "bowl" in lines[3] else 0.03) + min(speed * step * steps * chance.uniform(0, 0.3), size)
    for number in range(chance.choice([1, 1, 1, 2, 3])):
        words, more, height = body(chance, number, size, speed, height)
        lines, files = lines + words, files | more
    return "\n".join(lines + end) + "\n", files, step * steps, chance


class Runs:
    """Runs of one scene in a folder."""

    def __init__(self, sherd, folder, seed):
        text, files, self.duration, self.chance = scene(seed)
        self.sherd, self.folder, self.seed = sherd, folder, seed
        self.threads = 1
        (folder / "s.toml").write_text(text)
        for name, content in files.items():
            (folder / name).write_text(content)

    def command(self, recording, *words):
        return [self.sherd, "run", self.folder / "s.toml", "-o", self.folder / recording, "--threads",
                str(self.threads), *words]

    def call(self, recording, *words):
        """Runs the program; returns its exit code and the lines of errors."""
        done = subprocess.run(self.command(recording, *words), capture_output=True, text=True, check=False,
                              preexec_fn=lambda: limit(MEMORY, PATIENCE))
        return done.returncode, [line for line in done.stderr.splitlines() if "error" in line]

    def stop(self, recording):
        """Runs a part of the scene, until a time or a kill. Returns the exit code, 0 for a killed run."""
        self.threads = self.chance.choice([1, 2])
        if self.chance.random() < 0.6:
            until = self.duration * self.chance.uniform(0.05, 0.95)
            return self.call(recording, "--force", "--until", f"{until:.6g}")[0]
        run = subprocess.Popen(self.command(recording, "--force"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            return run.wait(self.chance.uniform(0.05, 0.8))
        except subprocess.TimeoutExpired:
            run.kill()
            run.wait()
            return 0

    def judged(self):
        """Returns descriptions of failures, and the features of the whole run (see content())."""
        code, words = self.call("whole.h5", "--force")
        if code not in (0, 1) or (code == 1 and not words):
            return [f"ended with {code}: {words}"], []
        had = self.content()
        stopped = self.stop("parts.h5")
        if stopped not in (0, 1):
            return [f"a part ended with {stopped}"], had
        self.threads = 1
        again, words = self.call("parts.h5", "--resume")
        if again != code:
            return [f"ended with {code}, resumed with {again}: {words}"], had
        different = recording_content.differences(self.folder / "whole.h5", self.folder / "parts.h5")
        return [f"differs at {', '.join(different[:4])}"] if different else [], had + (["error"] if code else [])

    def content(self):
        with h5py.File(self.folder / "whole.h5") as file:
            steps = file["steps"]
            explicit = numpy.ptp(steps["is_explicit"][:]) if len(steps["time"]) else 0
            had = {"cracks": len(file["events/failure/time"]), "pieces": (steps["fragments"][-1:] > 1).any(),
                   "halving": (steps["halvings"][:] > 0).any(), "both schemes": explicit}
        return [name for name, there in had.items() if there]


def one(task):
    sherd, seed, keep = task
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(keep or scratch)
        folder.mkdir(parents=True, exist_ok=True)
        return seed, *Runs(sherd, folder, seed).judged()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sherd")
    for name, number in (("--blows", 20), ("--first", 1), ("--jobs", 1), ("--seed", None)):
        parser.add_argument(name, type=int, default=number)
    parser.add_argument("--keep")
    options = parser.parse_args()
    if "SHERD_SHORT" in os.environ:
        options.blows = min(options.blows, 40)
    seeds = [options.seed] if options.seed is not None else range(options.first, options.first + options.blows)
    tasks = [(options.sherd, seed, options.keep and f"{options.keep}/{seed}") for seed in seeds]
    count, bad = collections.Counter(), 0
    with multiprocessing.Pool(options.jobs) as pool:
        for seed, wrong, had in pool.imap(one, tasks):
            count.update(had)
            bad += bool(wrong)
            print(f"{seed}: {', '.join(had) or 'nothing broke'}; {'; '.join(wrong) or 'same bits'}", flush=True)
    print(f"{len(tasks)} runs, of them with " + ", ".join(f"{name} {number}" for name, number in sorted(count.items()))
          + f"; {bad} wrong")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
