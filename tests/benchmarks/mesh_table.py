#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""mesh_table SHERD [FILE | NAME]...: prints the results of `sherd check` for rough meshes, 0.2 m long, as they are and
remeshed, with three thicknesses; seconds are processor time, with the first thickness. FILE is a mesh file, NAME a mesh
of tests/support/rough_meshes.py; without either, all meshes of that file."""
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import rough_meshes  # noqa: E402

THICKNESSES = [0.0002, 0.001, 0.005]
REMESHES = [None, 0.012, 0.006]


def scene(mesh, remesh, thickness):
    more = f", remesh = {remesh}" if remesh else ""
    return (f'duration = 1e-3\n[sheet.a]\nmesh = {{ file = "{mesh}", size = 0.2{more} }}\n'
            f'material = {{ preset = "porcelain", thickness = {thickness} }}\nfracture = {{ strain = 0.2 }}\n')


def number(pattern, text, fallback="0"):
    found = re.search(pattern, text)
    return found.group(1) if found else fallback


def row(sherd, name, mesh, remesh):
    """Prints a row of the table; returns the number of thicknesses that are refused."""
    refused, text, seconds = 0, "", 0
    with tempfile.TemporaryDirectory() as folder:
        for thickness in THICKNESSES:
            file = pathlib.Path(folder) / "scene.toml"
            file.write_text(scene(mesh, remesh, thickness))
            begin = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            done = subprocess.run([sherd, "check", "--no-try", str(file)], capture_output=True, text=True, check=False)
            if thickness == THICKNESSES[0]:
                text = done.stdout + done.stderr
                seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begin
            if done.returncode != 0:
                refused += 1
                print(f"{name} {remesh} {thickness}: {done.stderr}", file=sys.stderr)
    edges = re.search(r"edges \S+ m on average, (\S+) to (\S+) m; smallest angle (\S+)", text)
    shortest, longest, angle = edges.groups() if edges else ("nan", "nan", "?")
    distance = number(r"at most (\S+) m from", text, "")
    cells = [name, f"{1000 * remesh:g} mm" if remesh else "as it is", number(r"remeshed from ([0-9]+) faces", text, ""),
             number(r"faces ([0-9]+)", text, "?"), f"{1000 * float(shortest):.2g} to {1000 * float(longest):.2g}", angle,
             "0" if distance and float(distance) < 1e-12 else distance, number(r"([0-9]+) pairs of faces cross or touch", text),
             f"{seconds:.1f}", f"{refused} of {len(THICKNESSES)}"]
    print(f"| {' | '.join(cells)} |", flush=True)
    return refused


def main():
    sherd, chosen = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2:]
    files = [pathlib.Path(name).resolve() for name in chosen if pathlib.Path(name).is_file()]
    names = [name for name in chosen if not pathlib.Path(name).is_file()]
    with tempfile.TemporaryDirectory() as folder:
        if not chosen:
            names = [make.__name__ for make in rough_meshes.MESHES]
        meshes = rough_meshes.write(folder, names) if names else {}
        meshes |= {file.stem: file for file in files}
        print("| mesh | remeshed | faces before | faces | edges (mm) | smallest angle | distance (m) | pairs that cross | seconds "
              "| refused |")
        print("| --- " * 10 + "|")
        refused = sum(row(sherd, name, mesh, remesh) for name, mesh in meshes.items() for remesh in REMESHES)
    print(f"refused: {refused} of {len(meshes) * len(REMESHES) * len(THICKNESSES)}")


if __name__ == "__main__":
    main()
