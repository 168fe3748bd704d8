# SPDX-License-Identifier: GPL-3.0-or-later
"""resume_kills.py SHERD [--kills N] [--seed N] [SCENE ...]

Runs scenes without interruption, and again with SIGKILLs at random times, each followed by `sherd run --resume`: while
the run makes steps, records, writes a checkpoint, or restores one. Then compares the two recordings, dataset by dataset
and bit by bit; only `wall_seconds` may differ. If a run ends before all kills have been made, another run of the scene
follows. Each scene is killed N times (2). SCENE: names of the scenes here, by default all."""

import argparse
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

import h5py

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import recording_content  # noqa: E402


def falling_plate(duration, every, solver, material=""):
    """Returns the scene of a plate that falls onto the floor, followed by a ball, with the given solver."""
    return f"""
duration = {duration}
seed = 6
[sheet.plate]
mesh = {{ generate = "plate", radius = 0.11, edge_length = 0.013 }}
place = {{ translate = [0, 0, 0.042], rotate = {{ axis = [1, 0, 0], degrees = 20 }} }}
velocity = [0, 0, -4]
material = {{ preset = "stoneware"{material} }}
fracture = {{ strain = 0.2 }}
[obstacle.floor]
plane = {{}}
friction = 0.3
[obstacle.ball]
sphere = {{ radius = 0.015, centre = [0.03, 0.02, 0.07] }}
density = 7850
velocity = [0, 0, -6]
[solver]
{solver}
[output]
every = {every}
checkpoint = 0.1
"""


SCENES = {
    # Implicit steps, strength: bodies, wind with gusts, fixed and moving obstacles, a moving pin.
    "implicit": """
duration = 0.012
seed = 4
[sheet.plate]
mesh = { generate = "plate", radius = 0.11, edge_length = 0.013 }
place = { translate = [0, 0, 0.062], rotate = { axis = [1, 0, 0], degrees = 20 } }
velocity = [0, 0, -4]
material = { preset = "stoneware" }
fracture = { strain = 0.3, weibull = 8 }
[sheet.flag]
mesh = { generate = "rectangle", width = 0.2, height = 0.1, edge_length = 0.025 }
place = { translate = [0.2, 0, 0.02] }
material = { preset = "cotton" }
pin = { box = [[0.19, -1, -1], [0.21, 1, 1]], keys = [{ time = 0 }, { time = 0.01, translate = [0, 0, 0.01] }] }
[obstacle.floor]
plane = {}
friction = 0.3
[obstacle.block]
box = { size = [0.04, 0.3, 0.02], centre = [0, 0, 0.01] }
keys = [{ time = 0 }, { time = 0.01, translate = [0.003, 0, 0] }]
[obstacle.ball]
sphere = { radius = 0.015, centre = [0.03, 0.02, 0.09] }
density = 7850
velocity = [0, 0, -6]
[obstacle.die]
box = { size = [0.02, 0.02, 0.02], centre = [0.3, 0.05, 0.06] }
density = 500
velocity = [0, 0, -4]
[force.wind]
velocity = [10, 3, 0]
gust = { amplitude = 3, time = 0.01, length = 0.1 }
[[gauge]]
name = "rim"
at = [0, 0.09, 0.1133]
[contact]
friction = 0.2
[output]
every = 1e-3
checkpoint = 0.1
""",
    # Implicit and explicit steps in alternation, with the state that passes from one scheme to the other.
    "auto": falling_plate(0.003, 2e-4, 'scheme = "auto"\ndamping = { stiffness = 2e-8, mass = 1 }'),
    # BDF2, which needs the previous step's state, and yielding, which changes rest angles.
    "bdf2": falling_plate(0.004, 5e-4, 'scheme = "bdf2"', ", yield = 1e6"),
    # Newton's method.
    "newton": falling_plate(0.004, 5e-4, 'scheme = "implicit-euler"\nmethod = "newton"'),
    # Bodies that rest on edges of each other and of an obstacle, and two bodies that overlap at the start.
    "edges": """
duration = 0.015
seed = 6
[sheet.plate]
mesh = { generate = "plate", radius = 0.11, edge_length = 0.013 }
place = { translate = [0.5, 0, -0.04], rotate = { axis = [1, 0, 0], degrees = 20 } }
velocity = [0, 0, -4]
material = { preset = "stoneware" }
fracture = { strain = 0.2 }
[obstacle.floor]
plane = { point = [0, 0, -0.1] }
[obstacle.beam]
box = { size = [0.03, 0.3, 0.03] }
place = { rotate = { axis = [0, 1, 0], degrees = 45 } }
friction = 0.5
[obstacle.low]
box = { size = [0.12, 0.03, 0.02] }
place = { translate = [0.01, 0, 0.03123] }
density = 2000
friction = 0.5
[obstacle.top]
box = { size = [0.02, 0.1, 0.02] }
velocity = [0, 0, -0.2]
place = { translate = [0.003, 0.004, 0.05534], rotate = { axis = [0, 1, 0], degrees = 40 } }
density = 2000
friction = 0.5
[obstacle.one]
box = { size = [0.1, 0.02, 0.02], centre = [0, 1, 0.3] }
density = 2000
[obstacle.other]
box = { size = [0.02, 0.1, 0.02], centre = [0, 1, 0.3199] }
density = 2000
velocity = [0, 0, 0.01]
[output]
every = 1e-3
checkpoint = 0.1
""",
    # Statics: a flap that tears a film, load step by load step.
    "static": """
[sheet.film]
mesh = { generate = "polygon", edge_length = 0.004, outline = [[-0.03, 0], [0.03, 0], [0.03, 0.1], [-0.03, 0.1]] }
material = { density = 900, thickness = 0.0002, young = 3e9, poisson = 0.3 }
fracture = { strength = 5e8, toughness = 3.5e6, crack = [{ line = [[-0.012, 0, 0], [-0.012, 0.03, 0]] }, \
             { line = [[0.012, 0, 0], [0.012, 0.03, 0]] }] }
pin = [
    { box = [[-1, -1, -1], [-0.0299, 1, 1]] }, { box = [[0.0299, -1, -1], [1, 1, 1]] },
    { box = [[-0.0298, 0.0999, -1], [0.0298, 1, 1]] },
    { box = [[-0.0115, -1, -1], [0.0115, 1e-5, 1]], motion = "linear", keys = [
        { time = 0 }, { time = 0.1, translate = [0, 0.005, 0.015] }, { time = 0.2, translate = [0, 0.018, 0.027] },
        { time = 0.3, translate = [0, 0.035, 0.03] }, { time = 2, translate = [0, 0.205, 0.03] }] },
]
[force]
gravity = [0, 0, 0]
[contact]
sheets = false
[solver]
scheme = "static"
step = 0.02
load = 0.6
[output]
checkpoint = 0.1
""",
    # Explicit steps, toughness: cracks that split faces and branch, edges with cohesive forces, a clamp, a body.
    "explicit": """
duration = 2.5e-4
seed = 5
[sheet.pane]
mesh = { generate = "rectangle", width = 0.2, height = 0.2, edge_length = 0.012 }
place = { translate = [-0.1, -0.1, 0] }
clamp = { boundary = true }
material = { preset = "glass" }
fracture = { strength = 6e7, toughness = 7.5e5 }
[obstacle.ball]
sphere = { radius = 0.02, centre = [0.013, 0.008, 0.0225] }
density = 7850
young = 2.1e11
friction = 0.2
velocity = [0, 0, -12]
[force.wind]
velocity = [0, 0, 30]
[solver]
scheme = "explicit"
step = 1e-6
damping = { stiffness = 2e-8, mass = 1 }
[output]
every = 2e-5
fields = true
checkpoint = 0.1
""",
}


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("sherd")
    parser.add_argument("scenes", nargs="*", choices=[[], *SCENES], default=[])
    parser.add_argument("--kills", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    return parser.parse_intermixed_args()


def give_up(command, code, words):
    sys.exit(f"{' '.join(map(str, command))} ended with {code}:\n{words}")


def finish(command):
    """Runs a command to its end; exits if it fails."""
    run = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False, text=True)
    if run.returncode != 0:
        give_up(command, run.returncode, run.stderr)


class KilledRun:
    """A run that is killed and resumed repeatedly."""

    def __init__(self, sherd, scene, recording, chance):
        self.command = [sherd, "run", scene, "-o", recording]
        self.recording, self.chance = recording, chance
        self.startup = 0.3  # s, guess of the time until a resumed run makes steps
        self.kills = 0

    def killed(self):
        """Resumes the run and kills it after a random time. Returns whether it ended before."""
        threads = str(self.chance.choice([1, 2, 4]))
        run = subprocess.Popen([*self.command, "--resume", "--threads", threads], stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE)
        if self.chance.random() < 0.25:
            ended = self.wait_for_checkpoint(run)
        else:
            ended = self.wait(run, self.chance.uniform(0, 2.5 * self.startup))
        if not ended:
            run.send_signal(signal.SIGKILL)
            self.kills += 1
        words = run.communicate()[1].decode()
        if run.returncode not in (0, -signal.SIGKILL):
            give_up(self.command, run.returncode, words)
        return run.returncode == 0

    @staticmethod
    def wait(run, seconds):
        try:
            run.wait(seconds)
            return True
        except subprocess.TimeoutExpired:
            return False

    def wait_for_checkpoint(self, run):
        """Waits until a checkpoint is being written, and randomly 2 ms longer. Returns whether the run has ended."""
        until = time.monotonic() + 20 * self.startup
        while time.monotonic() < until:
            if any(self.recording.parent.glob(f"{self.recording.name}.checkpoint-?.part")):
                return self.wait(run, self.chance.choice([0, 0.002]))
            if self.wait(run, 0.0005):
                return True
        return False


def main():
    options = arguments()
    if "SHERD_SHORT" in os.environ:
        options.kills = min(options.kills, 5)
    chance = random.Random(options.seed)
    names = options.scenes or list(SCENES)
    failed = False
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            failed = not check(options.sherd, name, options.kills, chance, pathlib.Path(folder)) or failed
    sys.exit(1 if failed else 0)


def check(sherd, name, kills, chance, folder):
    scene, whole = folder / f"{name}.toml", folder / "whole.h5"
    scene.write_text(SCENES[name])
    begun = time.monotonic()
    finish([sherd, "run", scene, "-o", whole])
    duration = time.monotonic() - begun
    with h5py.File(whole) as recording:
        failures = len(recording["events/failure/time"])
    assert failures > 10, f"{name} breaks too little for a proof: {failures} edges"
    spent = rounds = 0
    same = True
    while spent < kills:
        victim = KilledRun(sherd, scene, folder / f"killed-{rounds}.h5", chance)
        while spent + victim.kills < kills and not victim.killed():
            pass
        finish([*victim.command, "--resume"])
        spent += victim.kills
        rounds += 1
        different = recording_content.differences(whole, victim.recording)
        same = same and not different
        print(f"{name}: {duration:.1f} s, {failures} edges broke; {victim.kills} kills, "
              f"{len(different)} differences{': ' if different else ''}{', '.join(different[:5])}", flush=True)
    return same


main()
