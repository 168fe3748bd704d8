#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""blow_race SHERD [--blows N] [--first SEED] [--jobs N] [--seed SEED [--keep DIR]]: random blows (blow_scenes.py), each
run by the real program and judged by the recording (blow_judge.py): nothing may pass through a sheet. A blow is held, or
ends with the error, at most 5 % of those below 0.1 sheet sizes a step. A crossing that the judge sees between two frames
counts where a side is known, or the same blow at an eighth of the step shows one, too. --seed judges one blow again, and
--keep leaves its scene and recordings in a folder. Exit code 1: a blow passed, or the program crashed."""
import os
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import argparse  # noqa: E402
import collections  # noqa: E402
import dataclasses  # noqa: E402
import multiprocessing  # noqa: E402
import pathlib  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import tempfile  # noqa: E402
import time  # noqa: E402

import h5py  # noqa: E402
import numpy  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import blow_judge  # noqa: E402
import blow_scenes  # noqa: E402
from limits import limit  # noqa: E402

MEMORY = 4 << 30  # bytes
PATIENCE = 60  # s of processor time
FINER = 8  # times shorter steps, where a crossing is to be confirmed
OFTEN = 0.05  # of slow blows, which may end with the error
SLOW = 0.1  # sheet sizes a step
PROPER = ["cannot be solved", "passes through"]  # errors by which a blow may end


@dataclasses.dataclass
class Result:
    seed: int
    kind: str
    scheme: str
    pace: float
    outcome: str  # held, error, passed, crashed, refused, endless, other
    words: str
    seconds: float


def run(sherd, folder, blow, finer=1):
    """Runs a blow. Returns exit code (None: no end), words of the error, and its recording."""
    (folder / "s.toml").write_text(blow.text)
    for name, content in blow.files.items():
        (folder / name).write_text(content)
    recording = folder / ("r.h5" if finer == 1 else "finer.h5")
    step = blow.step / finer
    finer_words = ["--set", f"solver.step={step:.12g}", "--set", f"output.every={step:.12g}"] if finer > 1 else []
    done = subprocess.run([sherd, "run", folder / "s.toml", "-o", recording, "--force", "--threads", "1", *finer_words],
                          capture_output=True, text=True, check=False, preexec_fn=lambda: limit(MEMORY, PATIENCE * finer))
    errors = [line for line in done.stderr.splitlines() if line.startswith("sherd: error: ")]
    code = None if done.returncode in (-9, -24) else done.returncode
    return code, (errors or [done.stderr[-300:]])[0].removeprefix("sherd: error: "), recording


class Judged:
    """What a recording shows: crossings by frame, and what is on the other side."""

    def __init__(self, blow, recording):
        self.crossings, self.beyond = [], []
        with h5py.File(recording) as file:
            frames = [file["frames"][name] for name in sorted(file["frames"])]
            self.names = [name.decode() for name in file["obstacles/names"][:]] if "obstacles" in file else []
            self.sheets = [name.decode() for name in file["rest/sheet_names"][:]]
            self.faces, self.sheet = frames[0]["face/vertices"][:], frames[0]["face/sheet"][:]
            self.positions = [frame["vertex/position"][:] for frame in frames]
            self.times = [frame.attrs["time"] for frame in frames]
            self.poses = [frame["obstacle/pose"][:].reshape(-1, 3, 4) if self.names else None for frame in frames]
        self.blow = blow
        self.judge()

    def body(self, name, solid, k):
        corner, faces = solid
        middle = corner.mean(axis=0)
        corner = middle + blow_judge.SHRUNK * (corner - middle)
        if name in self.blow.turns:
            motion = blow_judge.KeyedMotion(corner, self.blow.turns[name], self.times[k], self.times[k + 1])
        else:
            first, begin, end = [self.poses[i][self.names.index(name)] for i in (0, k, k + 1)]
            turned = [pose[:, :3] @ first[:, :3].T for pose in (begin, end)]
            poses = [(matrix, pose[:, 3] - matrix @ first[:, 3]) for matrix, pose in zip(turned, (begin, end))]
            motion = blow_judge.BodyMotion(corner, *poses)
        return blow_judge.Surface(name, motion, faces, blow_judge.edges_of(faces), False)

    def surfaces(self, k):
        """What moves between the frames k and k + 1."""
        found = []
        for i, name in enumerate(self.sheets):
            used, faces = numpy.unique(self.faces[self.sheet == i], return_inverse=True)
            faces = faces.reshape(-1, 3)
            motion = blow_judge.SheetMotion(self.positions[k][used], self.positions[k + 1][used])
            found.append(blow_judge.Surface(name, motion, faces, blow_judge.edges_of(faces), True))
        return found + [self.body(name, solid, k) for name, solid in self.blow.solids.items()]

    def judge(self):
        sides = None
        for k in range(len(self.positions) - 1):
            moving = self.surfaces(k)
            for i, one in enumerate(moving):
                for other in moving[i:]:
                    if (one is other and not one.is_sheet) or not (one.is_sheet or other.is_sheet):
                        continue
                    turn = max(numpy.linalg.norm(s.motion.turn) for s in (one, other))
                    parts = int(numpy.ceil(turn / blow_judge.TURN)) or 1
                    self.crossings += [(k, c) for c in blow_judge.crossings_of(one, other, parts)]
            if self.blow.struck:
                sides = self.look_at_sides(sides, moving)
                beyond = sides.step([self.striker(moving).motion.at(s) for s in numpy.linspace(0, 1, 9)[1:]],
                                    self.target(moving).motion.at(1))
                if beyond.any():
                    self.beyond.append(f"frame {k + 1}: {beyond.sum()} of {len(beyond)} points are on the other side")

    def target(self, moving):
        return next(s for s in moving if s.name == self.blow.struck)

    def striker(self, moving):
        return next(s for s in moving if s.name != self.blow.struck)

    def look_at_sides(self, sides, moving):
        target = self.target(moving)
        return sides or blow_judge.Sides(self.blow.border, target.motion.at(0), target.faces, self.striker(moving).motion.at(0))

    def words(self):
        """What was seen, or nothing."""
        found = self.beyond[:1]
        if self.crossings:
            count = collections.Counter((k, c.of, c.through) for k, c in self.crossings)
            found += [f"frame {k}: {n} crossings of {of} and {through}" for (k, of, through), n in list(count.items())[:2]]
        return "; ".join(found)


def judged(sherd, seed, folder):
    blow = blow_scenes.blow(seed)
    begun = time.monotonic()
    code, words, recording = run(sherd, folder, blow)
    seconds = time.monotonic() - begun

    def result(outcome, words):
        return Result(seed, blow.kind, blow.scheme, blow.pace, outcome, words, seconds)
    if code is None:
        return result("endless", f"more than {PATIENCE} s of processor time")
    if code < 0:
        return result("crashed", f"signal {-code}: {words}")
    if code == 2:
        return result("refused", words)
    if code == 1 and not any(part in words for part in PROPER):
        return result("other", words)
    seen = Judged(blow, recording)
    if seen.beyond:
        return result("passed", seen.words())
    if seen.crossings:
        finer_code, _, finer = run(sherd, folder, blow, FINER)
        confirmed = Judged(blow, finer).words() if finer_code in (0, 1) else f"exit code {finer_code}"
        if confirmed:
            return result("passed", f"{seen.words()}; at an eighth of the step {confirmed}")
        if code == 0:
            return result("doubtful", seen.words())
    return result("error", words) if code == 1 else result("held", "")


def one(task):
    sherd, seed, keep = task
    if keep:
        folder = pathlib.Path(keep)
        folder.mkdir(parents=True, exist_ok=True)
        return judged(sherd, seed, folder)
    with tempfile.TemporaryDirectory() as folder:
        return judged(sherd, seed, pathlib.Path(folder))


OUTCOMES = ["held", "error", "doubtful", "passed", "crashed", "endless", "refused", "other"]
FAULTS = ["passed", "crashed", "endless", "refused", "other"]


def table(results, by, title):
    rows = collections.defaultdict(collections.Counter)
    for result in results:
        rows[by(result)][result.outcome] += 1
    print(f"\n{title:36}" + "".join(f"{outcome:>10}" for outcome in OUTCOMES))
    for name in sorted(rows):
        print(f"{name:36}" + "".join(f"{rows[name][outcome] or '':>10}" for outcome in OUTCOMES))


def speed(result):
    for limit_ in (0.03, 0.1, 0.3, 1, 3):
        if result.pace < limit_:
            return f"below {limit_:4g} sizes a step"
    return "from     3 sizes a step"


def verdict(results):
    """Prints what became of all; returns whether that is as it must be."""
    for by, title in ((lambda r: r.kind.split(" on ")[-1], "target"), (lambda r: r.kind.split(" on ")[0], "striker"),
                      (lambda r: r.scheme, "scheme"), (speed, "speed"), (lambda r: "all", "")):
        table(results, by, title)
    slow = [r for r in results if r.pace < SLOW]
    errors = sum(r.outcome == "error" for r in slow)
    print(f"\n{errors} of {len(slow)} below {SLOW} sizes a step end with the error")
    for result in results:
        if result.outcome in FAULTS:
            print(f"seed {result.seed}, {result.kind}, {result.scheme}, {result.pace:.3g} sizes a step: "
                  f"{result.outcome}: {result.words}")
    bad = any(r.outcome in FAULTS for r in results)
    if bad:
        print("again, and with what is left in a folder: blow_race.py SHERD --seed SEED --keep DIR")
    return not bad and errors <= max(1, OFTEN * len(slow))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sherd")
    parser.add_argument("--blows", type=int, default=60)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--seed", type=int)
    parser.add_argument("--keep")
    options = parser.parse_args()
    seeds = [options.seed] if options.seed is not None else range(options.first, options.first + options.blows)
    tasks = [(options.sherd, seed, options.keep and (options.keep if options.seed is not None else f"{options.keep}/{seed}"))
             for seed in seeds]
    results = []
    with multiprocessing.Pool(options.jobs) as pool:
        for result in pool.imap(one, tasks):
            results.append(result)
            print(f"{result.seed}: {result.kind}, {result.scheme}, {result.pace:.3g} sizes a step: {result.outcome}, "
                  f"{result.seconds:.1f} s {result.words}", file=sys.stderr, flush=True)
    sys.exit(0 if verdict(results) else 1)


if __name__ == "__main__":
    main()
