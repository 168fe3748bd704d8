# SPDX-License-Identifier: GPL-3.0-or-later
"""python_recording.py SHERD: tests that sherd.record() writes the program's recordings, and sherd.Recording."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

import sherd

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
SCENE = pathlib.Path(__file__).resolve().parents[2] / "scenes/plate_drop.toml"
DURATION = 0.004  # s, after which the plate is in pieces


def contents(file):
    """Returns all datasets and attributes of a recording except for the wall time."""
    found = {}

    def visit(name, item):
        found.update({f"{name}@{key}": value for key, value in item.attrs.items() if key != "wall_seconds"})
        if isinstance(item, h5py.Dataset):
            found[name] = (item.dtype, item.shape, item[()].tobytes() if item.dtype.kind != "O" else list(item[()]))

    with h5py.File(file) as opened:
        visit("", opened)
        opened.visititems(visit)
        for name, frame in opened["frames"].items():  # visititems() does not follow links to rest meshes
            found[f"{name}/rest"] = frame["rest/position"][()].tobytes()
    return found


class Recordings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.theirs = pathlib.Path(cls.folder.name) / "theirs.h5"
        cls.ours = pathlib.Path(cls.folder.name) / "ours.h5"
        subprocess.run([PROGRAM, "run", SCENE, "-o", cls.theirs, "--set", f"duration={DURATION}",
                        "--set", "output.every=0.001"], check=True, capture_output=True)
        simulation = sherd.Simulation(sherd.Scene(SCENE, set={"duration": DURATION, "output.every": 0.001}))
        with sherd.record(simulation, cls.ours):
            simulation.run()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def file(self, name):
        return pathlib.Path(self.folder.name) / name

    def test_measures_are_those_of_the_program(self):
        told = subprocess.run([PROGRAM, "info", self.theirs, "--measures", "--over", "1e-3", "--json"], check=True,
                              capture_output=True, text=True).stdout
        measures = sherd.Recording(self.ours).measures(over=1e-3)
        self.assertEqual(measures, json.loads(told))
        self.assertGreater(len(measures["fragments"]), 1)
        about = sherd.Recording(self.ours).measures(about=(0.1, 0.1, 0.02), radii=[0.05])["about"]
        self.assertEqual((about["point"], [circle["radius"] for circle in about["circles"]]), ([0.1, 0.1, 0.02], [0.05]))
        self.assertEqual(len(sherd.Recording(self.ours).measures(about="floor")["about"]["point"]), 3)

    def test_a_recording_has_no_distance_from_itself(self):
        told = subprocess.run([PROGRAM, "info", self.theirs, "--distance", self.ours, "--json"], check=True,
                              capture_output=True, text=True).stdout
        distance = sherd.Recording(self.theirs).distance(sherd.Recording(self.ours))
        self.assertEqual(distance, json.loads(told))
        self.assertAlmostEqual(distance["rand"], 1)
        self.assertGreater(len(distance["matches"]), 1)

    def test_both_record_the_same(self):
        theirs, ours = contents(self.theirs), contents(self.ours)
        self.assertEqual(theirs.keys(), ours.keys())
        for name in theirs:
            self.assertEqual(theirs[name], ours[name], name)
        self.assertTrue(self.ours.with_suffix(".xdmf").exists())

    def test_what_is_read_is_what_is_there(self):
        recording = sherd.Recording(self.ours)
        with h5py.File(self.ours) as file:
            self.assertEqual(len(recording), len(file["frames"]))
            numpy.testing.assert_array_equal(recording.times, [f.attrs["time"] for f in file["frames"].values()])
            last = file["frames"][f"{len(recording) - 1:06}"]
            for number in (-1, len(recording) - 1):
                numpy.testing.assert_array_equal(recording.frame(number).positions, last["vertex/position"])
            numpy.testing.assert_array_equal(recording.frame(-1).face_fragments, last["face/fragment"])
            for name, column in recording.steps.items():
                numpy.testing.assert_array_equal(column, file["steps"][name])
            for name, column in recording.events["failure"].items():
                numpy.testing.assert_array_equal(column, file["events/failure"][name])
            numpy.testing.assert_array_equal(recording.reactions["obstacle.floor"]["force"],
                                             file["steps/reaction/obstacle.floor/force"])
            self.assertEqual(recording.poses(0)["floor"].shape, (4, 4))
            self.assertEqual(recording.scene_text.encode(), file["scene"][()])
        self.assertEqual((recording.end, recording.sheets), ("complete", ["plate"]))
        self.assertGreater(recording.frame(-1).face_fragments.max(), 0)
        for number in (len(recording), -len(recording) - 1):
            with self.assertRaises(IndexError):
                recording.frame(number)

    def test_ancestry_carries_values_over(self):
        recording = sherd.Recording(self.ours)
        first, last = recording.frame(0), recording.frame(-1)
        faces, vertices, weights = recording.ancestry(0, -1)
        self.assertEqual(faces.shape, (len(last.faces),))
        carried = (weights[:, :, None] * first.positions[vertices]).sum(1)
        numpy.testing.assert_allclose(carried, first.positions[last.originals], atol=1e-12)

    def test_a_recording_ends_as_the_block_does(self):
        for raised, end in ((None, "interrupted"), (ValueError, "interrupted"),
                            (sherd.Error("no way on"), "failed: no way on")):
            simulation = sherd.Simulation(sherd.Scene(SCENE, set={"duration": DURATION}))
            try:
                with sherd.record(simulation, self.file("part.h5"), force=True):
                    simulation.run(until=3e-4)
                    if raised:
                        raise raised
            except (ValueError, sherd.Error) as error:
                self.assertIsInstance(error, type(raised) if isinstance(raised, Exception) else raised)
            recording = sherd.Recording(self.file("part.h5"))
            self.assertEqual(recording.end, end)
            if raised is None:
                self.assertEqual(recording.times[-1], simulation.time)

    def test_what_cannot_be_recorded_is_said(self):
        simulation = sherd.Simulation(sherd.Scene(SCENE, set={"duration": DURATION}))
        with self.assertRaisesRegex(sherd.Error, "exists; name another file, or pass force=True to replace it"):
            with sherd.record(simulation, self.ours):
                self.fail("it is there")
        with sherd.record(simulation, self.file("once.h5")):
            with self.assertRaisesRegex(sherd.Error, "is being recorded"):
                with sherd.record(simulation, self.file("twice.h5")):
                    self.fail("it is being recorded")
            simulation.step()
        with self.assertRaisesRegex(sherd.Error, "before the first"):
            with sherd.record(simulation, self.file("late.h5")):
                self.fail("it has begun")
        with self.assertRaisesRegex(sherd.Error, "missing.h5"):
            sherd.Recording(self.file("missing.h5"))


if __name__ == "__main__":
    unittest.main()
