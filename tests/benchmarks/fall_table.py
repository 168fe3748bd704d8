#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""fall_table [--short] SHERD [FILE | NAME]...: drops rough meshes (tests/support/rough_meshes.py, or files), 0.2 m long
and 1 mm thick, as they are and remeshed to 12 mm, onto an inclined floor, where they break. Makes 50 steps for meshes
of at most 5,000 faces, 3 for others and with --short. Seconds are processor time. Exit code 1: a mesh was refused,
surfaces that had been apart intersect, or energy was created."""
import pathlib
import resource
import subprocess
import sys
import tempfile

import h5py
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import rough_meshes  # noqa: E402

MOST_FACES, STEPS, FEW_STEPS, STEP = 5000, 50, 3, 1e-4
BOUND = 1e-6  # largest energy residual over the largest energy
UP = (0.19, -0.38, 0.905)  # the floor's normal: no mesh lies flat on it


def scene(mesh, remesh, steps):
    more = f", remesh = {remesh}" if remesh else ""
    return (f'duration = {steps * STEP}\n[sheet.a]\nmesh = {{ file = "{mesh}", size = 0.2{more} }}\n'
            f'material = {{ preset = "porcelain", thickness = 0.001 }}\nfracture = {{ strain = 0.2 }}\n'
            f'velocity = {[-4 * u for u in UP]}\n[solver]\nstep = {STEP}\n[output]\nevery = {STEP}\n'
            f'[obstacle.floor]\nplane = {{ point = BOTTOM, normal = {list(UP)} }}\n')


def lowest(sherd, folder, text):
    """Returns the lowest vertex of the sheet, in the direction UP, and the number of its faces."""
    file = folder / "lowest.toml"
    file.write_text(text.replace("BOTTOM", "[0, 0, -9]"))
    out = folder / "lowest.obj"
    done = subprocess.run([sherd, "mesh", str(file), "-o", str(out), "--force"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    rows = [line.split() for line in out.read_text().splitlines() if line.startswith(("v ", "f "))]
    vertices = numpy.array([[float(x) for x in row[1:4]] for row in rows if row[0] == "v"])
    return vertices[numpy.argmin(vertices @ UP)], sum(row[0] == "f" for row in rows)


def balance(recording):
    """Returns the largest energy residual of all steps over the largest energy, and the number of fragments."""
    with h5py.File(recording) as file:
        steps = file["steps"]
        names = [name for name in ("kinetic", "bending", "membrane") if name in steps]
        energy = sum(numpy.abs(steps[name][:]) for name in names)
        return numpy.abs(steps["unexplained"][:]).max() / energy.max(), int(steps["fragments"][-1])


def fall(sherd, counter, name, mesh, remesh, short):
    with tempfile.TemporaryDirectory() as name_of_folder:
        folder = pathlib.Path(name_of_folder)
        try:
            bottom, faces = lowest(sherd, folder, scene(mesh, remesh, FEW_STEPS))
        except RuntimeError as error:
            print(f"{name}: {error}", file=sys.stderr)
            return False
        steps = FEW_STEPS if short or faces > MOST_FACES else STEPS
        run, out = folder / "run.toml", folder / "run.h5"
        run.write_text(scene(mesh, remesh, steps).replace("BOTTOM", str((bottom - 0.0007 * numpy.array(UP)).tolist())))
        begin = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        done = subprocess.run([sherd, "run", str(run), "-o", str(out)], capture_output=True, text=True, check=False)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begin
        if done.returncode != 0:
            print(f"{name}: {done.stderr}", file=sys.stderr)
            return False
        unexplained, fragments = balance(out)
        counted = subprocess.run([counter, str(out)], capture_output=True, text=True, check=True).stdout.split("|")
        passing, through = int(counted[5]), int(counted[6])
        is_sound = unexplained < BOUND and passing == 0 and through == 0
        print(f"| {name} | {f'{1000 * remesh:g} mm' if remesh else 'as it is'} | {faces} | {steps} | {fragments} | "
              f"{unexplained:.1e} | {passing} | {through} | {seconds:.1f} |", flush=True)
        return is_sound


def main():
    arguments = sys.argv[1:]
    short = "--short" in arguments
    arguments = [argument for argument in arguments if argument != "--short"]
    sherd, chosen = str(pathlib.Path(arguments[0]).resolve()), arguments[1:]
    build = pathlib.Path(sherd).parent.parent
    counter = str(build / "tests" / "benchmarks" / "frame_intersections")
    files = [pathlib.Path(name).resolve() for name in chosen if pathlib.Path(name).is_file()]
    names = [name for name in chosen if not pathlib.Path(name).is_file()]
    with tempfile.TemporaryDirectory() as folder:
        meshes = rough_meshes.write(folder, names) if names or not chosen else {}
        meshes |= {file.stem: file for file in files}
        print("| mesh | remeshed | faces | steps | fragments | unexplained | through each other | through the floor | seconds "
              "|")
        print("| --- " * 9 + "|")
        sound = [fall(sherd, counter, name, mesh, remesh, short)
                 for name, mesh in meshes.items() for remesh in (None, 0.012)]
    sys.exit(0 if all(sound) else 1)


if __name__ == "__main__":
    main()
