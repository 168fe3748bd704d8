# SPDX-License-Identifier: GPL-3.0-or-later
"""check_gltf.py SHERD FOLDER FILE.glb...

Validates .glb files with the Khronos glTF validator: these, and those of a textured plate that breaks, which are made
in FOLDER. No error and no warning is allowed. Exit code 77 if the validator (npm: gltf-validator) is not there."""

import json
import os
import shutil
import struct
import subprocess
import sys
import zlib

VALIDATE = """
const paths = [process.cwd(), ...(process.env.NODE_PATH || '').split(':'), process.argv[1]];
let validator;
try { validator = require(require.resolve('gltf-validator', { paths })); } catch { process.exit(77); }
validator.validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[2])))
    .then((report) => console.log(JSON.stringify(report.issues)));
"""

SCENE = """duration = 0.002
[sheet.plate]
mesh = "plate.obj"
material = { preset = "glass", thickness = 0.002 }
fracture = { strength = 1e6 }
place = { rotate = { axis = [1, 0, 0], degrees = 25 }, translate = [0, 0, 0.05] }
velocity = [0, 0, -6]
[obstacle.floor]
plane = { point = [0, 0, 0] }
[output]
every = 5e-4
"""


def png(width, height, colour):
    rows = b"".join(b"\0" + bytes(colour) * width for _ in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def plate(cells):
    """A square of 0.2 m, half of it of another material than the other."""
    lines = ["mtllib plate.mtl"]
    for i in range(cells + 1):
        for j in range(cells + 1):
            lines += [f"v {0.2 * i / cells - 0.1} {0.2 * j / cells - 0.1} 0", f"vt {i / cells} {j / cells}"]
    for i in range(cells):
        if 2 * i in (0, cells):
            lines.append("usemtl " + ("glaze" if i == 0 else "clay"))
        for j in range(cells):
            a = i * (cells + 1) + j + 1
            corners = (a, a + cells + 1, a + cells + 2, a + 1)
            lines.append("f " + " ".join(f"{k}/{k}" for k in corners))
    return "\n".join(lines) + "\n"


def make_textured(sherd, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    with open(os.path.join(folder, "plate.obj"), "w") as file:
        file.write(plate(10))
    with open(os.path.join(folder, "plate.mtl"), "w") as file:
        file.write("newmtl glaze\nmap_Kd glaze.png\nnewmtl clay\nKd 0.7 0.4 0.2\nd 0.5\nKe 0.1 0 0\n")
    with open(os.path.join(folder, "glaze.png"), "wb") as file:
        file.write(png(4, 4, (20, 60, 180)))
    with open(os.path.join(folder, "scene.toml"), "w") as file:
        file.write(SCENE)
    subprocess.run([sherd, "run", "scene.toml", "-o", "run.h5"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    for name, *options in [("rigid",), ("morph", "--animate", "morph"), ("solid", "--solid")]:
        file = os.path.join(folder, name + ".glb")
        subprocess.run([sherd, "export", "run.h5", "--to", "glb", "-o", file, *options],
                       cwd=folder, check=True, stdout=subprocess.DEVNULL)
        yield file


def issues(file):
    npm = subprocess.run(["npm", "root", "-g"], capture_output=True, text=True) if shutil.which("npm") else None
    modules = npm.stdout.strip() if npm else ""
    result = subprocess.run(["node", "-e", VALIDATE, os.path.dirname(modules), file], capture_output=True, text=True)
    if result.returncode == 77:
        print("SKIPPED: gltf-validator is not installed and NOTHING has been validated; "
              "npm install -g gltf-validator installs it")
        sys.exit(77)
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def main():
    sherd, folder, *files = sys.argv[1:]
    for file in [*files, *make_textured(sherd, os.path.abspath(folder))]:
        found = issues(file)
        serious = [message for message in found["messages"] if message["severity"] < 2]
        assert not serious, f"{file}: {serious}"
        print(f"{os.path.basename(file)}: {found['numErrors']} errors, {found['numWarnings']} warnings")


main()
