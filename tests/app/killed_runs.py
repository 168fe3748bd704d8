#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""killed_runs.py SHERD [--kills N]: recordings of runs that are killed at random times, and of runs on full disks.

Every frame that the index beside a recording lists must be readable afterwards, by sherd and by h5py. SHERD_SHORT in
the environment: at most 20 kills. Random numbers have a fixed seed; the timing of the machine is not reproducible.
"""
import argparse
import json
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py

SCENE = """duration = 1000
[sheet.plate]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.02 }
material = { preset = "stoneware" }
place = { translate = [0, 0, 0.1] }
[solver]
step = 1e-3
[output]
every = 1e-3
"""


def read_whole(file):
    """Reads all datasets of a recording with h5py, and returns the number of frames."""
    with h5py.File(file, "r") as recording:
        recording.visititems(lambda _, item: item[()] if isinstance(item, h5py.Dataset) else None)
        return len(recording["frames"])


def is_changing(error):
    """Returns whether a recording could not be opened because it is being written: it was locked, or grew after HDF5
    had read its size and before HDF5 locked it."""
    return isinstance(error, BlockingIOError) or "truncated file" in str(error)


def indexed_frames(folder):
    """Returns the number of frames in the index."""
    index = folder / "scene.xdmf"
    return index.read_text().count('<Grid Name="surface ') if index.exists() else 0


def in_child(sherd, folder, limit=None):
    def prepare():
        if limit:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
    return subprocess.Popen([sherd, "run", "scene.toml", "--force"], cwd=folder, preexec_fn=prepare,
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def wait_until(is_so, run):
    """Waits for a condition while the run continues. ctest's time limit of the whole test ends a wait that hangs."""
    while not is_so():
        assert run.poll() is None, "the run has ended"
        time.sleep(0.002)


class Runs(unittest.TestCase):
    sherd, kills = "", 8

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="sherd-test-")
        self.folder = pathlib.Path(self.temporary.name)
        (self.folder / "scene.toml").write_text(SCENE)
        self.file = self.folder / "scene.h5"

    def tearDown(self):
        self.temporary.cleanup()

    def frames_by_sherd(self):
        """Returns the number of frames and the messages of `sherd info`, which repairs the recording first."""
        done = subprocess.run([self.sherd, "info", "--json", "scene.h5"], cwd=self.folder, capture_output=True,
                              text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["frames"], done.stderr

    def expect_whole(self):
        frames, words = self.frames_by_sherd()
        self.assertGreaterEqual(frames, indexed_frames(self.folder))
        self.assertEqual(read_whole(self.file), frames)
        self.assertFalse((self.folder / "scene.h5.journal").exists())
        return frames, words

    def test_every_recording_reads_whole_after_a_kill(self):
        moments, unread, mended, most = random.Random(19), 0, 0, 0
        for _ in range(self.kills):
            (self.folder / "scene.xdmf").unlink(missing_ok=True)
            run = in_child(self.sherd, self.folder)
            least = moments.randrange(8)
            wait_until(lambda: indexed_frames(self.folder) > least, run)
            time.sleep(moments.uniform(0, 0.03))  # a random time within the next frames
            run.send_signal(signal.SIGKILL)
            run.communicate()
            try:
                read_whole(self.file)
            except (OSError, KeyError, RuntimeError):
                unread += 1
            frames, words = self.expect_whole()
            mended += words != ""
            most = max(most, frames)
        print(f"{self.kills} killed, up to {most} frames; {mended} mended, {unread} of these not read by h5py before")
        self.assertGreater(most, 3, "the test would prove nothing")
        self.assertLessEqual(unread, mended)

    def test_who_reads_meanwhile_delays_nobody_and_reads_whole_frames(self):
        run = in_child(self.sherd, self.folder)
        wait_until(lambda: indexed_frames(self.folder) > 0, run)
        counts, failed = [], 0
        with h5py.File(self.file, "r") as kept:
            first = len(kept["frames"])
            wait_until(lambda: indexed_frames(self.folder) > first + 3, run)  # hangs if the run waits for a reader
            self.assertEqual(len(kept["frames"]), first)
        while len(counts) < 20 or counts[-1] == counts[0]:
            try:
                counts.append(read_whole(self.file))
            except OSError as error:
                if not is_changing(error):
                    raise
                failed += 1
        run.send_signal(signal.SIGINT)
        run.communicate()
        self.assertEqual(run.returncode, 130)
        self.assertEqual(counts, sorted(counts))
        self.assertGreater(len(counts), failed)
        self.assertGreater(counts[-1], counts[0])
        self.expect_whole()

    def expect_full(self, run):
        words = run.communicate()[1]
        self.assertEqual(run.returncode, 1, words)
        self.assertIn("no room for", words)
        self.assertIn("stay readable", words)
        self.assertGreater(self.expect_whole()[0], 0)

    def test_a_file_size_limit_is_an_error_and_takes_nothing(self):
        for limit in (300_000, 333_333, 500_001):
            self.expect_full(in_child(self.sherd, self.folder, limit))

    def test_a_full_disk_is_an_error_and_takes_nothing(self):
        # In a chroot whose root is not a mount point even root cannot have mounts of its own.
        if subprocess.run(["unshare", "-m", "true"], capture_output=True).returncode != 0:
            self.skipTest("a small disk needs mounts of its own")
        me = [sys.executable, __file__, self.sherd, "--disk", str(self.folder)]
        done = subprocess.run(["unshare", "-m", *me], capture_output=True, text=True)
        if done.returncode == 77:
            self.skipTest("a small disk needs the right to mount one")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class SmallDisk(Runs):
    """Runs on small disks, in a mount namespace of its own."""
    folder = None

    def setUp(self):
        self.file = self.folder / "scene.h5"

    def tearDown(self):
        pass

    def runTest(self):
        for size in ("500k", "800k", "1200k"):
            subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "none", self.folder], check=True)
            (self.folder / "scene.toml").write_text(SCENE)
            self.expect_full(in_child(self.sherd, self.folder))
            subprocess.run(["umount", self.folder], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sherd")
    parser.add_argument("--kills", type=int, default=8)
    parser.add_argument("--disk", type=pathlib.Path, help="for itself: mount small disks here")
    options = parser.parse_args()
    Runs.sherd = os.path.abspath(options.sherd)
    Runs.kills = min(options.kills, 20) if "SHERD_SHORT" in os.environ else options.kills
    if options.disk:
        tried = subprocess.run(["mount", "-t", "tmpfs", "none", options.disk], capture_output=True)
        if tried.returncode != 0:
            return 77
        subprocess.run(["umount", options.disk], check=True)
        SmallDisk.folder = options.disk
        suite = unittest.TestSuite([SmallDisk()])
    else:
        suite = unittest.defaultTestLoader.loadTestsFromTestCase(Runs)
    return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
