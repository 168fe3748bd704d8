# SPDX-License-Identifier: GPL-3.0-or-later
"""long_rest.py SHERD [--steps N]

A plate breaks on a floor between walls, and its fragments lie there until N steps (100,000) have been made: in the end
nothing may move, no energy may be created, and memory must not grow. Prints a table by tenths of the run, with the
processor time of a step, which should not grow either. SHERD_SHORT in the environment: 5,000 steps."""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import recorded_rest  # noqa: E402

SIZE = 0.16  # m
SCENE = f"""
seed = 3
[sheet.plate]
mesh = {{ generate = "plate", radius = {SIZE / 2}, edge_length = 0.016 }}
place = {{ translate = [0, 0, 0.03], rotate = {{ axis = [1, 0, 0], degrees = 15 }} }}
velocity = [0, 0, -4]
material = {{ preset = "stoneware" }}
fracture = {{ strain = 0.02 }}
[obstacle.floor]
plane = {{}}
friction = 0.3
[obstacle.east]
plane = {{ point = [0.1, 0, 0], normal = [-1, 0, 0] }}
[obstacle.west]
plane = {{ point = [-0.1, 0, 0], normal = [1, 0, 0] }}
[obstacle.north]
plane = {{ point = [0, 0.1, 0], normal = [0, -1, 0] }}
[obstacle.south]
plane = {{ point = [0, -0.1, 0], normal = [0, 1, 0] }}
[contact]
friction = 0.3
[solver]
step = 1e-3
"""
MEMORY = 4 << 20    # bytes, largest growth in the second half of a run: fluctuation of the heap's pages
STILL = 1e-6 * SIZE  # m, largest displacement from the middle of the run to its end
ENERGY = 1e-6       # largest energy residual over the largest energy


def used(process):
    """Returns resident memory (bytes) and processor time (s) of a running process."""
    folder = pathlib.Path("/proc") / str(process.pid)
    ticks = folder.joinpath("stat").read_text().rpartition(")")[2].split()[11:13]
    pages = int(folder.joinpath("statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE"), sum(map(int, ticks)) / os.sysconf("SC_CLK_TCK")


def run(sherd, scene, recording):
    """Runs the scene. Returns (step, memory, processor time) at each tenth of the run but the last, at which the
    process may have ended."""
    process = subprocess.Popen([sherd, "run", scene, "-o", recording], stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    tenths, words = [], []
    for line in process.stderr:
        words.append(line)
        if (found := re.match(r" *(\d+)0% +step (\d+)", line)) and int(found[1]) < 10:
            tenths.append((int(found[2]), *used(process)))
    if process.wait() != 0:
        sys.exit(f"the run ended with {process.returncode}:\n{''.join(words)}")
    return tenths


def show(tenths):
    print("| steps | memory (MB) | processor time of a step (ms) |\n| --- | --- | --- |")
    for (before, _, earlier), (step, memory, time) in zip([(0, 0, 0.0), *tenths], tenths):
        print(f"| {step:,} | {memory / 1e6:.1f} | {1e3 * (time - earlier) / (step - before):.2f} |")


def problems(recording, tenths):
    """Returns descriptions of what is wrong with a run."""
    _, moved, nowhere, fragments, _ = recorded_rest.at_the_end(recording)
    grown = tenths[-1][1] - tenths[len(tenths) // 2][1]
    print(f"{fragments} fragments; from the middle to the end they move by {moved:.1e} m at most, memory grows by "
          f"{grown / 1e6:.1f} MB; {nowhere:.1e} of the largest energy is unexplained")
    return [words for wrong, words in ((fragments < 10, "too few fragments for a proof"),
                                       (moved > STILL, "what rests moves"), (grown > MEMORY, "memory grows"),
                                       (nowhere > ENERGY, "energy comes from nowhere")) if wrong]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sherd")
    parser.add_argument("--steps", type=int, default=100_000)
    options = parser.parse_args()
    steps = min(options.steps, 5_000) if "SHERD_SHORT" in os.environ else options.steps
    with tempfile.TemporaryDirectory() as folder:
        scene, recording = pathlib.Path(folder) / "shards.toml", pathlib.Path(folder) / "shards.h5"
        scene.write_text(f"duration = {steps * 1e-3!r}\n{SCENE}[output]\nevery = {steps * 1e-5!r}\n")
        tenths = run(options.sherd, scene, recording)
        show(tenths)
        wrong = problems(recording, tenths)
    sys.exit("; ".join(wrong) or 0)


main()
