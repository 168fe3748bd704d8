#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""blow_race SHERD [--blows N] [--first SEED] [--jobs N] [--seed SEED [--keep DIR]]: random impacts (blow_scenes.py),
each run by the real program and checked by its recording (blow_recording.py): nothing may pass through a sheet. A run
either holds or ends with the proper error; at most 5 % of the runs with less than 0.1 sheet sizes a step may end with
it. Where the sides of a sheet are not known, a crossing between two frames counts only if the same impact in steps of
an eighth has a crossing, too, or an effect that this run lacks, and if one of the steps between the frames has a
crossing (blow_steps.py, with the Python module). --seed repeats one impact, and --keep leaves scenes and recordings in
a folder. Exit code 1: something passed through, the program crashed, or too many runs did not end as they should."""
import os
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import argparse  # noqa: E402
import collections  # noqa: E402
import dataclasses  # noqa: E402
import math  # noqa: E402
import multiprocessing  # noqa: E402
import pathlib  # noqa: E402
import resource  # noqa: E402
import signal  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import tempfile  # noqa: E402

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import blow_recording  # noqa: E402
import blow_scenes  # noqa: E402
from limits import limit  # noqa: E402

MEMORY = 4 << 30  # bytes
PATIENCE = 20  # s of processor time
FINER = 8  # divisor of the step where a crossing is to be confirmed
OFTEN = 0.05  # largest share of gentle impacts that may end with the error
GENTLE = 0.1  # sheet sizes a step, below which an impact is gentle
SELDOM = 0.02  # largest share of all impacts that may be stopped before they end
# Parts of the error messages with which a run may end
PROPER = ["cannot be solved", "passes through", "pass through each other", "have become unstable",
          "would need substeps"]


@dataclasses.dataclass
class Result:
    seed: int
    kind: str
    scheme: str
    pace: float
    outcome: str  # element of OUTCOMES
    words: str
    seconds: float


@dataclasses.dataclass
class Done:
    code: int | None  # exit code; None: stopped at a limit
    words: str  # error message
    recording: pathlib.Path
    seconds: float  # processor time


def run(sherd, folder, blow, finer=1):
    """Runs an impact in steps that are `finer` times shorter."""
    (folder / "s.toml").write_text(blow.text)
    for name, content in blow.files.items():
        (folder / name).write_text(content)
    recording = folder / ("r.h5" if finer == 1 else "finer.h5")
    shorter = [f"--set={key}={blow.step / finer:.12g}" for key in ("solver.step", "output.every")] if finer > 1 else []
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([sherd, "run", folder / "s.toml", "-o", recording, "--force", "--threads", "1", *shorter],
                          capture_output=True, text=True, check=False, preexec_fn=lambda: limit(MEMORY, PATIENCE))
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    errors = [line for line in done.stderr.splitlines() if line.startswith("sherd: error: ")]
    return Done(None if -done.returncode in (signal.SIGKILL, signal.SIGXCPU) else done.returncode,
                (errors or [done.stderr[-300:]])[0].removeprefix("sherd: error: "), recording, seconds)


def judged(sherd, seed, folder):
    blow = blow_scenes.blow(seed)
    done = run(sherd, folder, blow)

    def result(outcome, words=""):
        return Result(seed, blow.kind, blow.scheme, blow.pace, outcome, words, done.seconds)
    if done.code not in (None, 0, 1):
        return result("refused" if done.code == 2 else "crashed", f"exit code {done.code}: {done.words}")
    if done.code == 1 and not any(part in done.words for part in PROPER):
        return result("other", done.words)
    seen = blow_recording.Seen(blow, done.recording)
    if seen.passed:
        return result("passed", seen.words())
    if done.code != 0:
        return result(*(("error", done.words) if done.code == 1 else ("slow", f"no end in {PATIENCE} s")))
    return result(*confirmed(sherd, folder, blow, seen)) if seen.crossed else result("held")


def confirmed(sherd, folder, blow, seen):
    """Returns outcome and explanation of an impact with crossings between frames, by a run in steps of an eighth."""
    finer = run(sherd, folder, blow, FINER)
    if finer.code not in (0, 1):
        return "held", f"{seen.words()}; no end at an eighth of the step"
    there = blow_recording.Seen(blow, finer.recording)
    if there.passed or (seen.deep and there.deep):
        return by_each_step(sherd, folder, blow, seen, f"at an eighth of the step {there.words()}")
    if finer.code == 0 and seen.shows_less_than(there):
        return by_each_step(sherd, folder, blow, seen, f"changes of velocity are {seen.shoved} m/s, at an eighth of "
                                                       f"the step {there.shoved}")
    return "held", f"{seen.words()}; not so at an eighth of the step"


def by_each_step(sherd, folder, blow, seen, why):
    """Returns outcome and explanation of an impact whose crossing shorter steps confirm. It is held if none of the
    steps that the program made has a crossing; these are repeated from Python, and must end bitwise as the recording
    does."""
    recording, words = folder / "steps.h5", f"{seen.words()}; {why}"
    here = pathlib.Path(__file__).resolve().parent
    module = pathlib.Path(sherd).resolve().parent / "python"  # beside the program, in the build folder
    done = subprocess.run([sys.executable, here / "blow_steps.py", folder / "s.toml", recording], capture_output=True,
                          text=True, check=False, env=os.environ | {"PYTHONPATH": str(module)},
                          preexec_fn=lambda: limit(MEMORY, PATIENCE))
    if done.returncode != 0:
        return "passed", f"{words}; its steps could not be looked at: {done.stderr[-300:]}"
    each = blow_recording.Seen(blow, recording)
    if each.passed or each.crossed:
        return "passed", f"{words}; of its {len(each.times) - 1} steps {each.words()}"
    if each.positions[-1].tobytes() != seen.positions[-1].tobytes():
        return "passed", f"{words}; its steps from Python end elsewhere"
    return "held", f"{words}; none of its {len(each.times) - 1} steps has a crossing"


def one(task):
    sherd, seed, keep = task
    if keep:
        folder = pathlib.Path(keep)
        folder.mkdir(parents=True, exist_ok=True)
        return judged(sherd, seed, folder)
    with tempfile.TemporaryDirectory() as folder:
        return judged(sherd, seed, pathlib.Path(folder))


OUTCOMES = ["held", "error", "slow", "passed", "crashed", "refused", "other"]
FAULTS = ["passed", "crashed", "refused", "other"]


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
    """Prints tables of the outcomes; returns whether all requirements are met."""
    for by, title in ((lambda r: r.kind.split(" on ")[-1], "target"), (lambda r: r.kind.split(" on ")[0], "striker"),
                      (lambda r: r.scheme, "scheme"), (speed, "speed"), (lambda r: "all", "")):
        table(results, by, title)
    gentle = [r for r in results if r.pace < GENTLE]
    errors, slow = sum(r.outcome == "error" for r in gentle), sum(r.outcome == "slow" for r in results)
    print(f"\n{errors} of {len(gentle)} below {GENTLE} sizes a step end with the error; {slow} of {len(results)} have "
          f"no end in {PATIENCE} s; {sum(r.seconds for r in results) / len(results):.2f} s a blow")
    for result in results:
        if result.outcome in FAULTS:
            print(f"seed {result.seed}, {result.kind}, {result.scheme}, {result.pace:.3g} sizes a step: "
                  f"{result.outcome}: {result.words}")
    bad = any(r.outcome in FAULTS for r in results)
    if bad:
        print("again, and with what is left in a folder: blow_race.py SHERD --seed SEED --keep DIR")
    return not bad and errors <= math.ceil(OFTEN * len(gentle)) and slow <= math.ceil(SELDOM * len(results))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sherd")
    parser.add_argument("--blows", type=int, default=60)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--seed", type=int)
    parser.add_argument("--keep")
    options = parser.parse_args()
    if "SHERD_SHORT" in os.environ:
        options.blows = min(options.blows, 200)
    seeds = [options.seed] if options.seed is not None else range(options.first, options.first + options.blows)
    tasks = [(options.sherd, seed, options.keep and f"{options.keep}/{seed}") for seed in seeds]
    results = []
    with multiprocessing.Pool(options.jobs) as pool:
        for result in pool.imap(one, tasks):
            results.append(result)
            print(f"{result.seed}: {result.kind}, {result.scheme}, {result.pace:.3g} sizes a step: {result.outcome}, "
                  f"{result.seconds:.1f} s {result.words}", file=sys.stderr, flush=True)
    sys.exit(0 if verdict(results) else 1)


if __name__ == "__main__":
    main()
