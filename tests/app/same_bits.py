#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""same_bits.py SHERD [--seconds S] [--table] [SCENE ...]

Runs the beginning of each scene that is installed with the program, in each of its variants, several times, and
compares the recordings, dataset by dataset and bit by bit; only `wall_seconds` may differ:

    again        the same command on a terminal, with a progress line; allocated memory is not zero but filled with
                 bytes that make numbers senseless (MALLOC_PERTURB_)
    two, four    with two threads and with four, instead of one
    once         with the first and the last frame only: all steps and the last frame are compared
    killed       killed by SIGKILL on its way, and resumed with two threads

The beginning is the part that one thread computes in S seconds of processor time (5), or the whole scene. SCENE: the
beginning of a name (plate_drop, paper/figure_3). SHERD_SHORT in the environment: every sixth scene, for one second.
--table: prints a Markdown table. Exit code 1: recordings differ."""

import argparse
import os
import pathlib
import pty
import signal
import subprocess
import sys
import tempfile
import threading
import time
import tomllib

import h5py

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import recording_content  # noqa: E402

WAYS = ("again", "two", "four", "once", "killed")


def cases(beginnings):
    """Yields (name, scene, variant) of the scenes with these beginnings of names; variant: "" if there is none."""
    for scene in sorted((ROOT / "scenes").rglob("*.toml")):
        name = str(scene.relative_to(ROOT / "scenes").with_suffix(""))
        if scene.parent.name == "studies":  # studies are not scenes, but run some of them
            continue
        if beginnings and not any(name.startswith(beginning) for beginning in beginnings):
            continue
        variants = [variant["name"] for variant in tomllib.loads(scene.read_text()).get("variant", [])]
        for variant in variants or [""]:
            yield f"{name} {variant}".strip(), scene, variant


def processor_seconds(process):
    """Returns the processor time (s) of a running process, 0 if it has ended."""
    try:
        fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Case:
    """The beginning of a scene, and its runs that are compared."""

    def __init__(self, sherd, scene, variant, folder):
        self.command = [sherd, "run", str(scene), "--set", "output.checkpoint=0.3"]
        self.command += ["--variant", variant] if variant else []
        self.folder = folder
        self.recording = folder / "first.h5"

    def start(self, name, *options, **rest):
        return subprocess.Popen([*self.command, "-o", self.folder / f"{name}.h5", *options], stdout=subprocess.DEVNULL,
                                stderr=rest.pop("stderr", subprocess.PIPE), **rest)

    def end(self, process, *codes):
        words = (process.communicate()[1] or b"").decode()
        if process.returncode not in codes:
            sys.exit(f"{' '.join(map(str, process.args))} ended with {process.returncode}:\n{words}")

    def begin(self, seconds):
        """Finds the end of the beginning, and makes the recording with which the others are compared."""
        process = self.start("found", "--threads", "1")
        while process.poll() is None and processor_seconds(process) < seconds:
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        self.end(process, 0, 130)
        with h5py.File(self.folder / "found.h5") as found:
            times = found["steps/time"][()]
            self.until = ["--until", repr(float(times[-1]))] if len(times) and found.attrs["end"] != "finished" else []
        self.end(self.start("first", "--threads", "1", *self.until), 0)

    def again(self):
        """Runs the same command on a terminal, with memory that is not zero."""
        terminal, end = pty.openpty()
        reader = threading.Thread(target=drained, args=[terminal])
        reader.start()
        process = self.start("again", "--threads", "1", *self.until, stderr=end,
                             env=dict(os.environ, MALLOC_PERTURB_="171", TERM="xterm"))
        os.close(end)
        self.end(process, 0)
        reader.join()
        os.close(terminal)
        return recording_content.differences(self.recording, self.folder / "again.h5")

    def threads(self, name, number):
        self.end(self.start(name, "--threads", str(number), *self.until), 0)
        return recording_content.differences(self.recording, self.folder / f"{name}.h5")

    def two(self):
        return self.threads("two", 2)

    def four(self):
        return self.threads("four", 4)

    def once(self):
        """Runs with two frames. Compares steps and the content of the last frame only, since frame numbers differ."""
        self.end(self.start("once", "--threads", "1", "--set", "output.every=1e9", *self.until), 0)
        one, same = (at_the_end(self.folder / f"{name}.h5") for name in ("first", "once"))
        return [path for path in sorted({*one, *same}) if one.get(path) != same.get(path)]

    def killed(self):
        process = self.start("killed", "--threads", "1", *self.until)
        checkpoint = self.folder / "killed.h5.checkpoint-2"
        while process.poll() is None and not checkpoint.exists():
            time.sleep(0.01)
        process.kill()
        self.end(process, 0, -signal.SIGKILL)
        if process.returncode:
            self.end(self.start("killed", "--threads", "2", "--resume", *self.until), 0)
        return recording_content.differences(self.recording, self.folder / "killed.h5")

    def size(self):
        """Returns the numbers of steps and of edges that broke."""
        with h5py.File(self.recording) as recording:
            return len(recording["steps/time"]), len(recording["events/failure/time"])


def at_the_end(recording):
    """Returns the content of a recording's steps, last frame and that frame's rest mesh, which frames may share."""
    with h5py.File(recording) as file:
        last = file["frames"][sorted(file["frames"])[-1]]
        parts = {"steps": file["steps"], "last": last} | ({"rest": last["rest"]} if "rest" in last else {})
        return {name + path.removeprefix(group.name): what for name, group in parts.items()
                for path, what in recording_content.content(group).items()
                if name != "last" or not path.startswith(f"{last.name}/rest")}


def drained(terminal):
    """Reads what is written to a terminal until its other end is closed."""
    try:
        while os.read(terminal, 4096):
            pass
    except OSError:
        pass


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sherd")
    parser.add_argument("--seconds", type=float, default=5)
    parser.add_argument("--table", action="store_true")
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    options = parser.parse_intermixed_args()
    chosen = list(cases(options.scenes))
    assert chosen, "no scene has such a name"
    if "SHERD_SHORT" in os.environ:
        chosen, options.seconds = chosen[::6], min(options.seconds, 1)
    if options.table:
        print(f"| scene | steps | edges broken | {' | '.join(WAYS)} |\n" + "| --- " * (3 + len(WAYS)) + "|")
    failed = False
    for name, scene, variant in chosen:
        with tempfile.TemporaryDirectory() as folder:
            case = Case(options.sherd, scene, variant, pathlib.Path(folder))
            case.begin(options.seconds)
            results = {way: getattr(case, way)() for way in WAYS}
            words = [f"differs: {', '.join(result[:4])}" if result else "same" for result in results.values()]
            failed = failed or any(results.values())
            steps, edges = case.size()
        if options.table:
            print(f"| `{name}` | {steps} | {edges} | {' | '.join(words)} |", flush=True)
        else:
            print(f"{name}: {steps} steps, {edges} edges broken; "
                  + "; ".join(f"{way} {word}" for way, word in zip(results, words)), flush=True)
    sys.exit(1 if failed else 0)


main()
