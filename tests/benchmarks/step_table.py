#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drops unbreakable sheets with several lengths of the step, and prints quantiles of the hinges' peak stresses.

    tests/benchmarks/step_table.py build/release/app/sherd [edge|flat|plate ...]

edge: a glass disc that lands on its edge; flat: the same disc, tilted by 10 degrees; plate: a plate like plate_drop's.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

DISC = """
duration = 0.0005
[sheet.disc]
mesh = {{ generate = "disc", radius = 0.1, edge_length = 0.01 }}
place = {{ rotate = {{ axis = [1, 0, 0], degrees = {degrees} }}, translate = [0, 0, {height}] }}
velocity = [0, 0, -3]
material = {{ preset = "glass" }}
[obstacle.floor]
plane = {{}}
[contact]
sheets = false
"""
PLATE = """
duration = 0.005
seed = 7
[sheet.plate]
mesh = { generate = "plate", radius = 0.13, edge_length = 0.007 }
place = { translate = [0, 0, 0.05], rotate = { axis = [0, 1, 0], degrees = 30 } }
velocity = [0, 0, -4]
material = { preset = "stoneware" }
[obstacle.floor]
plane = {}
young = 1e9
friction = 0.3
[contact]
sheets = false
"""
SCENES = {
    "edge": DISC.format(degrees=90, height=0.1021),
    "flat": DISC.format(degrees=10, height=0.0195),
    "plate": PLATE,
}
STEPS = (1e-4, 5e-5, 2e-5, 1e-5, 5e-6, 2e-6)  # s; the last for the discs only


def peaks(program, folder, scene, step):
    file = folder / "scene.toml"
    file.write_text(SCENES[scene])
    settings = ["--set", f"solver.step={step}", "--set", "output.every=0.001", "--set", "solver.bending=cubic"]
    command = [program, "run", file, "-o", folder / "run.h5", "--force", *settings]
    table = subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    row = re.search(r"stress, Pa((?: +[0-9.e+-]+)+)$", table, re.MULTILINE)
    return [float(value) / 1e6 for value in row[1].split()]


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    print("| scene | step (s) | 50 % | 90 % | 99 % | 99.9 % | largest (MPa) |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for scene in sys.argv[2:] or SCENES:
            for step in STEPS[:-1] if scene == "plate" else STEPS:
                row = " | ".join(f"{value:.3g}" for value in peaks(program, pathlib.Path(folder), scene, step))
                print(f"| {scene} | {step:g} | {row} |", flush=True)


if __name__ == "__main__":
    main()
