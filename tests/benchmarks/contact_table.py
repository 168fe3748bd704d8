#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs scenes to their ends and prints a table of the intersections in their frames.

    tests/benchmarks/contact_table.py build/release/app/sherd [SCENE...]

Without SCENE runs all of scenes/. Takes minutes. Exit code 1: there are intersections other than those of crack faces.
"""
import pathlib
import subprocess
import sys
import tempfile

SCENES = pathlib.Path(__file__).parents[2] / "scenes"


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    counter = program.parents[1] / "tests" / "benchmarks" / "frame_intersections"
    scenes = [pathlib.Path(name) for name in sys.argv[2:]] or sorted(SCENES.glob("*.toml"))
    print("| scene | faces | steps | frames | through faces | through obstacle | crack faces | by (µm) "
          "| in obstacle (µm) |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    passing = 0
    for scene in scenes:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([program, "run", scene, "-o", pathlib.Path(folder) / f"{scene.stem}.h5"], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            for recording in sorted(pathlib.Path(folder).glob("*.h5")):  # one for each variant
                row = subprocess.run([counter, recording], check=True, stdout=subprocess.PIPE, text=True).stdout
                print(row, end="", flush=True)
                passing += int(row.split("|")[5]) + int(row.split("|")[6])
    return 1 if passing else 0


if __name__ == "__main__":
    sys.exit(main())
