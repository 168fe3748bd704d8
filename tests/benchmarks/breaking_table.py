#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks plate_drop's plate with three steps and three mesh sizes, staged and by the paper's rule, and prints a table.

    tests/benchmarks/breaking_table.py build/release/app/sherd [FINENESS [BENDING]]

FINENESS 1, 2 or 4 (default) is the finest mesh, as a divisor of the scene's edge length. 4 takes hours. BENDING is
solver.bending (default cubic, with which a run takes less than half the time).
"""
import json
import pathlib
import subprocess
import sys
import tempfile

SCENE = pathlib.Path(__file__).parents[2] / "scenes" / "plate_drop.toml"
EDGE_LENGTH = 0.007  # m, the scene's own
DURATION = 0.005  # s, the first impact
STEPS = (1e-4, 5e-5, 2.5e-5)
RULES = {
    "staged": ["solver.rule=staged", "sheet.plate.fracture.measure=surface"],
    "paper": ["solver.rule=paper", "sheet.plate.fracture.measure=bending"],
}


def break_plate(program, folder, bending, rule, fineness, step):
    recording = folder / "run.h5"
    settings = [
        "contact.sheets=false",  # several times faster, and sufficient to see which edges break
        f"solver.bending={bending}",
        f"duration={DURATION}",
        f"output.every={DURATION}",
        f"solver.step={step}",
        f"sheet.plate.mesh.edge_length={EDGE_LENGTH / fineness}",
    ]
    arguments = [word for setting in settings + RULES[rule] for word in ("--set", setting)]
    subprocess.run(
        [program, "run", SCENE, "-o", recording, "--force", *arguments],
        check=True,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    info = subprocess.run([program, "info", recording, "--json"], check=True, stdout=subprocess.PIPE)
    return json.loads(info.stdout)


def row(rule, fineness, step, info):
    areas = [fragment["area"] for fragment in info["fragments"]]
    whole = sum(areas)
    single = sum(fragment["faces"] == 1 for fragment in info["fragments"])
    return (
        f"| {rule} | {info['faces']:,} | {step:g} | {sum(area > 0.01 * whole for area in areas)} | "
        f"{max(areas) / whole:.2f} | {len(areas)} | {single} | {info['crack_events'] * EDGE_LENGTH / fineness:.2f} |"
    )


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    finest = int(sys.argv[2]) if len(sys.argv) > 2 else 4
    bending = sys.argv[3] if len(sys.argv) > 3 else "cubic"
    print("| rule | faces | step (s) | pieces over 1 % | largest | pieces | of one face | cracks (m, about) |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for rule in RULES:
            for fineness in (1, 2, 4):
                if fineness > finest:
                    continue
                for step in STEPS:
                    info = break_plate(program, pathlib.Path(folder), bending, rule, fineness, step)
                    print(row(rule, fineness, step, info), flush=True)


if __name__ == "__main__":
    main()
