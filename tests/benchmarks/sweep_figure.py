#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""sweep_figure.py SHERD [--rows 10000] [--jobs 2]: measures the overhead of a sweep, by rows that take almost no time.

Each row is three steps of two triangles. The sweep is killed when half of the rows are done, and resumed. TMPDIR
selects the disk.
"""
import argparse
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "app"))
sys.dont_write_bytecode = True
from sweeps import SCENE, SQUARE  # noqa: E402

STUDY = """scene = "tiny.toml"
repeats = 10
[parameters]
speed = {{ set = "sheet.plate.velocity=[0, 0, -{{}}]", from = 1, to = 5, steps = {speeds} }}
sheet.plate.fracture.strain = {{ from = 0.4, to = 40, steps = 20, log = true }}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sherd", type=os.path.abspath)
    parser.add_argument("--rows", type=int, default=10000)
    parser.add_argument("--jobs", default="2")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="sherd-sweep-") as name:
        folder = pathlib.Path(name)
        (folder / "square.obj").write_text(SQUARE)
        (folder / "tiny.toml").write_text(SCENE)
        (folder / "study.toml").write_text(STUDY.format(speeds=options.rows // 200))
        journal = folder / "study" / "rows" / f"{0:07}-{options.rows - 1:07}.jsonl"
        command = [options.sherd, "sweep", "study.toml", "--jobs", options.jobs]
        begin = time.monotonic()
        first = subprocess.Popen(command, cwd=folder, stderr=subprocess.DEVNULL)
        while first.poll() is None and (not journal.exists() or
                                        journal.read_bytes().count(b"\n") < options.rows // 2):
            time.sleep(1)
        first.kill()
        first.wait()
        subprocess.run(command, cwd=folder, check=True)
        wall = time.monotonic() - begin
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        processor = usage.ru_utime + usage.ru_stime
        lines = journal.read_bytes().count(b"\n")
        print(f"{lines} results of {options.rows} rows in {wall:.0f} s: {options.rows / wall:.1f} rows/s, "
              f"{1e3 * processor / options.rows:.0f} ms of processor time each")


if __name__ == "__main__":
    main()
