#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""blow_table SHERD: prints how fast a free log, 2 cm thick, of steel or of rubber, may hit an edge crosswise before the
run ends because the log passes through, with explicit steps, "auto" and implicit steps."""
import pathlib
import subprocess
import sys
import tempfile

MATERIALS = {"steel": (210e9, 7800), "rubber": (1e6, 1100)}
SPEEDS = (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50)  # m/s
SCENE = """duration = 0.004
[sheet.far_away]
mesh = {{ generate = "rectangle", width = 0.02, height = 0.02, edge_length = 0.02 }}
place = {{ translate = [1, 1, 1] }}
material = {{ preset = "steel" }}
[obstacle.ridge]
box = {{ size = [0.02, 0.2, 0.02] }}
place = {{ rotate = {{ axis = [0, 1, 0], degrees = 45 }}, translate = [0, 0, -0.0141421] }}
young = {young}
[obstacle.log]
box = {{ size = [0.2, 0.02, 0.02] }}
place = {{ rotate = {{ axis = [1, 0, 0], degrees = 45 }}, translate = [0, 0, 0.0143421] }}
young = {young}
density = {density}
velocity = [0, 0, -{speed}]
[solver]
scheme = "{scheme}"
step = 1e-4
"""


def passes(sherd, folder, scheme, material, speed):
    """Returns whether the run ends because the log passes through the ridge."""
    young, density = MATERIALS[material]
    scene = folder / "blow.toml"
    scene.write_text(SCENE.format(young=young, density=density, speed=speed, scheme=scheme))
    done = subprocess.run([sherd, "run", scene, "-o", folder / "blow.h5", "--force"], capture_output=True, text=True,
                          check=False)
    if done.returncode not in (0, 1) or (done.returncode == 1 and "passes through" not in done.stderr):
        sys.exit(done.stderr)
    return done.returncode == 1


def main():
    sherd = pathlib.Path(sys.argv[1]).resolve()
    print("| steps | material | fastest that is held (m/s) | slowest that passes (m/s) |\n| --- " + "| --- " * 3 + "|")
    with tempfile.TemporaryDirectory() as name:
        for scheme in ("explicit", "auto", "implicit-euler"):
            for material in MATERIALS:
                held, passed = "", ""
                for speed in SPEEDS:
                    if passes(sherd, pathlib.Path(name), scheme, material, speed):
                        passed = speed
                        break
                    held = speed
                print(f"| `{scheme}` | {material} | {held} | {passed} |", flush=True)


if __name__ == "__main__":
    main()
