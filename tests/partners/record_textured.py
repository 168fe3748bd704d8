# SPDX-License-Identifier: GPL-3.0-or-later
"""record_textured.py SHERD FOLDER

Makes a recording, run.h5, in FOLDER, which is emptied before: two plates that break, one with texture coordinates and
three materials, of which one has a picture and one refers to a missing one, and one with colours of vertices."""

import os
import shutil
import struct
import subprocess
import sys
import zlib

SCENE = """duration = 0.002
[sheet.plate]
mesh = "plate.obj"
material = { preset = "glass", thickness = 0.002 }
fracture = { strength = 1e6 }
place = { rotate = { axis = [1, 0, 0], degrees = 25 }, translate = [0, 0, 0.05] }
velocity = [0, 0, -6]
[sheet.painted]
mesh = "painted.ply"
material = { preset = "glass", thickness = 0.002 }
fracture = { strength = 1e6 }
place = { rotate = { axis = [1, 0, 0], degrees = 25 }, translate = [0.25, 0, 0.05] }
velocity = [0, 0, -6]
[obstacle.floor]
plane = { point = [0, 0, 0] }
[output]
every = 5e-4
"""

MATERIALS = """newmtl glaze
map_Kd glaze.png
newmtl clay
Kd 0.7 0.4 0.2
Ns 225
d 0.5
Ke 0.1 0 0
newmtl lost
Kd 0.1 0.6 0.1
map_Kd lost.png
"""

CELLS = 10
FIRST_ROWS = {0: "glaze", 5: "clay", 8: "lost"}  # materials by their first row of squares, in the order of x
UPPER, LOWER = (20, 60, 180), (200, 150, 20)  # halves of the picture


def png(rows):
    """Returns a PNG file. rows: colours (red, green, blue), from the top."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + b"".join(map(bytes, row)) for row in rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def points():
    """Returns the grid points of a unit square, (u, v), which the plates scale to 0.2 m about the origin."""
    return [(i / CELLS, j / CELLS) for i in range(CELLS + 1) for j in range(CELLS + 1)]


def squares():
    """Yields the points of each square, counterclockwise."""
    for i in range(CELLS):
        for j in range(CELLS):
            a = i * (CELLS + 1) + j
            yield a, a + CELLS + 1, a + CELLS + 2, a + 1


def plate():
    lines = ["mtllib plate.mtl"]
    for u, v in points():
        lines += [f"v {0.2 * u - 0.1} {0.2 * v - 0.1} 0", f"vt {u} {v}"]
    for number, corners in enumerate(squares()):
        if number % CELLS == 0 and number // CELLS in FIRST_ROWS:
            lines.append(f"usemtl {FIRST_ROWS[number // CELLS]}")
        lines.append("f " + " ".join(f"{k + 1}/{k + 1}" for k in corners))
    return "\n".join(lines) + "\n"


def painted():
    """Returns the .ply file of a square whose red increases with x and green with y."""
    head = ["ply", "format ascii 1.0", f"element vertex {len(points())}"]
    head += [f"property {kind}" for kind in ("float x", "float y", "float z", "uchar red", "uchar green", "uchar blue")]
    head += [f"element face {CELLS * CELLS}", "property list uchar int vertex_indices", "end_header"]
    rows = [f"{0.2 * u - 0.1} {0.2 * v - 0.1} 0 {round(255 * u)} {round(255 * v)} 90" for u, v in points()]
    return "\n".join(head + rows + ["4 " + " ".join(map(str, corners)) for corners in squares()]) + "\n"


def main(sherd, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    texts = {"plate.obj": plate(), "plate.mtl": MATERIALS, "painted.ply": painted(), "scene.toml": SCENE}
    for name, text in texts.items():
        with open(os.path.join(folder, name), "w") as file:
            file.write(text)
    with open(os.path.join(folder, "glaze.png"), "wb") as file:
        file.write(png([[UPPER] * 64] * 32 + [[LOWER] * 64] * 32))
    subprocess.run([sherd, "run", "scene.toml", "-o", "run.h5"], cwd=folder, check=True, stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    main(*sys.argv[1:])
