#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""earlier_recording.py SHERD: files that an earlier program wrote are still read, or refused with a reason.

recorded_785befc has a scene with its mesh, its recording and its first checkpoint by the program of commit 785befc, and
what `sherd info --json` of that program printed. Exit code 1: users of recordings from then would lose something.
"""
import gzip
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py

DATA = pathlib.Path(__file__).parent / "recorded_785befc"
FORMATS = ("obj", "ply", "stl", "pvd", "glb", "vdb", "fragments")


class EarlierRecording(unittest.TestCase):
    sherd = ""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="sherd-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        for file in DATA.iterdir():
            content = file.read_bytes()
            if file.suffix == ".gz":
                content = gzip.decompress(content)
            (self.folder / file.name.removesuffix(".gz")).write_bytes(content)

    def run_sherd(self, *arguments, expected=0):
        done = subprocess.run([self.sherd, *arguments], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, expected, done.stderr)
        return done

    def expect_contains(self, now, then, path):
        """Expects that all values of then are those of now; there may be others now."""
        if isinstance(then, dict):
            for key, value in then.items():
                self.assertIn(key, now, path)
                self.expect_contains(now[key], value, f"{path}.{key}")
        elif isinstance(then, list):
            self.assertEqual(len(now), len(then), path)
            for number, value in enumerate(then):
                self.expect_contains(now[number], value, f"{path}[{number}]")
        elif isinstance(then, float):  # sums round otherwise on other processors
            self.assertAlmostEqual(now, then, delta=1e-9 * abs(then) + 1e-12, msg=path)
        else:
            self.assertEqual(now, then, path)

    def test_all_its_numbers_are_read(self):
        now = json.loads(self.run_sherd("info", "plate.h5", "--json").stdout)
        self.expect_contains(now, json.loads((DATA / "plate.json").read_text()), "info")

    def test_its_frames_are_exported_drawn_and_played(self):
        for form in FORMATS:
            self.run_sherd("export", "plate.h5", "--to", form, "-o", f"exported.{form}")
        self.run_sherd("view", "plate.h5", "-o", "plate.html")
        self.run_sherd("plot", "plate.h5", "-o", "plate.svg")
        self.run_sherd("render", "plate.h5", "-o", "pictures", "--frames", "-1", "--size", "80x60")

    def test_its_scene_is_a_scene(self):
        with h5py.File(self.folder / "plate.h5") as recording:
            text = recording["scene"][()].decode()
        (self.folder / "again.toml").write_text(text)
        self.assertEqual(text, (DATA / "plate.toml").read_text())
        self.run_sherd("check", "again.toml")

    def test_its_run_is_not_resumed_by_another_program(self):
        before = (self.folder / "plate.h5").read_bytes()
        refused = self.run_sherd("run", "plate.toml", "--resume", expected=2)
        self.assertIn("the program was sherd 0.1.0", refused.stderr)
        self.assertEqual((self.folder / "plate.h5").read_bytes(), before)


if __name__ == "__main__":
    EarlierRecording.sherd = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
