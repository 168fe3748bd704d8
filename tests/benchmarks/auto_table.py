#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""auto_table [--short] [--seeds N] [--threads N] SHERD [OLD_SHERD]: processor time of scenes that break by toughness,
two with `scheme = "auto"` and one with `"explicit"`, for N seeds (3), by one program or by two in turns. Prints for each
scene the mean over seeds of seconds (and of the old program over the new one), of the milliseconds in explicit steps,
of the substeps times parts in each of these, and the least and the largest number of pieces over 1 % of the area.
--short: the first millisecond of one seed."""
import argparse
import pathlib
import resource
import statistics

import h5py

from recorded_run import cracks, recorded_run

AUTO = "solver.scheme=auto"
SCENES = {
    "plate_drop": (AUTO, "sheet.plate.fracture={preset=true}"),
    "bowl_drop": (AUTO, "sheet.bowl.fracture={preset=true}"),
    "window_ball": (),
}


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measured(program, scene, settings, threads):
    begin = processor_seconds()
    with recorded_run(program, f"{scene}.toml", settings, "--threads", str(threads)) as recording:
        seconds = processor_seconds() - begin
        with h5py.File(recording) as file:
            steps = file["steps"]
            is_explicit = steps["is_explicit"][:] == 1
            explicit = 1e3 * steps["step_size"][:][is_explicit].sum()
            parts = steps["newton_iterations"][:][is_explicit].sum()
        shares = cracks(recording)[1]
    return {"seconds": seconds, "explicit": explicit, "parts": parts / explicit if explicit else 0,
            "pieces": int((shares > 0.01).sum())}


def row(options, scene):
    settings = [*SCENES[scene], *(["duration=1e-3"] if options.short else [])]
    programs = {"new": options.sherd, **({"old": options.old} if options.old else {})}
    runs = {name: [] for name in programs}
    for seed in range(1, 1 + (1 if options.short else options.seeds)):
        for name, program in programs.items():
            runs[name].append(measured(program, scene, [*settings, f"seed={seed}"], options.threads))

    def mean(of, key):
        return statistics.mean(run[key] for run in runs[of])

    pieces = {name: [run["pieces"] for run in of] for name, of in runs.items()}
    spread = {name: f"{min(of)} to {max(of)}" for name, of in pieces.items()}
    cells = [scene, f"{mean('new', 'seconds'):.1f}", f"{mean('new', 'explicit'):.1f}", f"{mean('new', 'parts'):.0f}",
             spread["new"]]
    if options.old:
        cells += [f"{mean('old', 'seconds') / mean('new', 'seconds'):.2f}", spread["old"]]
    return cells


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("sherd", type=lambda name: str(pathlib.Path(name).resolve()))
    parser.add_argument("old", type=lambda name: str(pathlib.Path(name).resolve()), nargs="?")
    options = parser.parse_args()
    names = ["scene", "seconds", "ms in explicit steps", "parts of substeps a ms", "pieces over 1 %"]
    if options.old:
        names += ["old seconds over new", "old pieces"]
    print("| " + " | ".join(names) + " |\n" + "| --- " * len(names) + "|")
    for scene in SCENES:
        print("| " + " | ".join(row(options, scene)) + " |", flush=True)


if __name__ == "__main__":
    main()
