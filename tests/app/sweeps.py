#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""sweeps.py SHERD: studies by the real program, which are killed, interrupted, changed and retried.

In all cases a study's table must be that of an undisturbed sweep, and no completed row may run again.
"""
import csv
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

import h5py

SQUARE = "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0.02\nv 0 0.1 0\nf 1 2 3\nf 1 3 4\n"
SCENE = """duration = 0.003
[sheet.plate]
mesh = "square.obj"
place = { translate = [0, 0, 0.001] }
material = { preset = "stoneware" }
fracture = { strain = 0.4 }
[obstacle.floor]
plane = {}
[solver]
step = 1e-3
[output]
every = 0.003
"""
STUDY = """scene = "tiny.toml"
repeats = 2
[parameters]
speed = { set = "sheet.plate.velocity=[0, 0, -{}]", from = 1, to = 5, steps = 5 }
sheet.plate.fracture.strain = [0.4, 2, 20, 200]
"""
SMALL_STUDY = STUDY.replace("to = 5, steps = 5", "to = 5, steps = 2").replace("[0.4, 2, 20, 200]", "[0.4, 20]")
# A study with a single row of many steps, which writes checkpoints.
LONG_STUDY = """scene = "tiny.toml"
set = ["output.checkpoint=0.05", "duration=1"]
keep = "all"
"""
# A study with two short rows and a long one, in this order.
STUDY_WITH_A_LONG_ROW = """scene = "tiny.toml"
[parameters]
duration = [0.002, 0.003, 1]
"""
MEASURE = """import pathlib
def measure(recording):
    print("what it prints is no result")
    (pathlib.Path(__file__).parent / "ready").read_text()
    return {"frames": len(recording.times), "nothing": None}
"""
TIMES = ("wall_seconds", "cpu_seconds")


class Sweeps(unittest.TestCase):
    sherd = ""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="sherd-test-")
        self.folder = pathlib.Path(self.temporary.name)
        (self.folder / "square.obj").write_text(SQUARE)
        (self.folder / "tiny.toml").write_text(SCENE)
        self.write(SMALL_STUDY)

    def tearDown(self):
        self.temporary.cleanup()

    def write(self, study):
        (self.folder / "study.toml").write_text(study)

    def start(self, *arguments, into="study"):
        return subprocess.Popen([self.sherd, "sweep", "study.toml", "-o", into, *arguments], cwd=self.folder,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def sweep(self, *arguments, into="study", expected=0):
        process = self.start(*arguments, into=into)
        process.out, process.err = process.communicate()
        self.assertEqual(process.returncode, expected, process.err)
        return process

    def table(self, into="study"):
        """Returns the rows without their times."""
        with open(self.folder / into / "study.csv", newline="") as file:
            return [{key: value for key, value in row.items() if key not in TIMES} for row in csv.DictReader(file)]

    def results(self, into="study"):
        """Returns the complete lines of all journals."""
        return [line for file in sorted((self.folder / into / "rows").glob("*.jsonl"))
                for line in file.read_text().splitlines(keepends=True) if line.endswith("\n")]

    def wait_for_results(self, process, count):
        while process.poll() is None and len(self.results()) < count:
            time.sleep(0.01)
        self.assertIsNone(process.poll(), "it was over before anything could happen to it")

    def wait_for_checkpoint(self, process):
        """Waits until a run has written its second checkpoint."""
        checkpoints = lambda: list((self.folder / "study" / "runs").glob("*.checkpoint-2"))
        while process.poll() is None and not checkpoints():
            time.sleep(0.01)
        self.assertIsNone(process.poll())

    def only_child(self, process):
        child, = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        return int(child)

    def kill_after(self, process, count):
        """Kills a sweep once `count` results are there; returns whether it was still running."""
        while process.poll() is None and len(self.results()) < count:
            time.sleep(0.01)
        process.kill()
        process.communicate()
        return process.returncode == -signal.SIGKILL

    def test_forty_rows_make_one_table_however_often_they_are_killed(self):
        self.write(STUDY)
        self.sweep("--jobs", "2", into="whole")
        whole = self.table("whole")
        self.assertEqual(len(whole), 40)
        self.assertEqual({row["exit"] for row in whole}, {"0"})
        self.assertEqual([row["row"] for row in whole], [str(i) for i in range(40)])
        killed = [self.kill_after(self.start("--jobs", "3"), enough) for enough in (5, 15, 25)]
        self.assertIn(True, killed, "all were over before they could be killed")
        rest = self.sweep("--jobs", "1")
        self.assertIn("of 40 rows are done already", rest.err)
        self.assertEqual(self.table(), whole)
        self.assertEqual(len(self.results()), 40, "a row that was done has been run again")
        self.assertEqual(list((self.folder / "study" / "runs").iterdir()), [], "no recording is to be kept")
        before = self.results()
        self.sweep()
        self.assertEqual(self.results(), before)
        with h5py.File(self.folder / "study" / "study.h5") as tables:
            self.assertEqual(list(tables["measures/fragments"]), [float(row["fragments"]) for row in whole])
            self.assertEqual(tables["measures/peak_force"].attrs["unit"], "N")
            self.assertEqual(tables["run/command"][3].decode(), whole[3]["command"])

    def test_the_command_of_a_row_repeats_it(self):
        self.write(SMALL_STUDY + 'sheet.plate.material.preset = ["glass"]\n[quick]\nrepeats = 1\nkeep = "all"\n'
                   'parameters.speed = { set = "sheet.plate.velocity=[0, 0, -{}]", values = [2] }\n'
                   'parameters.sheet.plate.fracture.strain = [20]\n')
        self.sweep("--quick")
        row, = self.table()
        command = row["command"].replace("sherd", self.sherd, 1) + " -o again.h5 --force"
        subprocess.run(command, cwd=self.folder, shell=True, check=True, capture_output=True)
        with h5py.File(self.folder / "study" / row["recording"]) as kept, h5py.File(self.folder / "again.h5") as again:
            last = sorted(kept["frames"])[-1]
            self.assertTrue((kept["frames"][last]["vertex/position"][()] ==
                             again["frames"][last]["vertex/position"][()]).all())

    def test_ctrl_c_ends_it_and_says_how_to_go_on(self):
        self.write(STUDY_WITH_A_LONG_ROW)
        process = self.start("--jobs", "1")
        self.wait_for_results(process, 2)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate()
        self.assertEqual(process.returncode, 130, err)
        self.assertIn("the same command continues", err)
        self.assertIn("0 failed", out, "what an interruption ends has not failed")
        self.assertEqual(len(self.table()), 3)
        self.sweep()
        self.assertEqual([row["exit"] for row in self.table()], ["0"] * 3)
        self.assertEqual(len(self.results()), 3)

    def test_a_killed_run_goes_on_from_its_checkpoint(self):
        self.write(LONG_STUDY)
        self.sweep(into="whole")
        process = self.start()
        self.wait_for_checkpoint(process)
        process.kill()
        process.communicate()
        recording, = (self.folder / "study" / "runs").glob("*.h5")
        file = recording.stat().st_ino
        self.sweep()
        self.assertEqual(recording.stat().st_ino, file, "the recording was begun anew")
        self.assertEqual(self.table(), self.table("whole"))

    def test_a_run_that_was_killed_alone_has_failed_until_it_is_tried_again(self):
        self.write(LONG_STUDY)
        process = self.start()
        self.wait_for_checkpoint(process)
        os.kill(self.only_child(process), signal.SIGKILL)
        out, err = process.communicate()
        self.assertEqual(process.returncode, 1, err)
        self.assertIn("row 0 failed (137): ended by signal 9", err)
        self.assertIn("--retry", err)
        again = self.sweep(expected=1)
        self.assertIn("1 row failed before; --retry", again.err)
        self.sweep("--retry")
        self.assertEqual([row["exit"] for row in self.table()], ["0"])

    def test_a_job_whose_processes_are_all_terminated_has_not_failed(self):
        self.write(LONG_STUDY)
        process = self.start()
        self.wait_for_checkpoint(process)
        child = self.only_child(process)
        os.kill(child, signal.SIGTERM)
        while pathlib.Path(f"/proc/{child}").exists():  # until the sweep has reaped it
            time.sleep(0.001)
        process.terminate()
        out, err = process.communicate()
        self.assertEqual(process.returncode, 143, err)
        self.assertIn("0 failed", out)
        self.sweep()
        self.assertEqual([row["exit"] for row in self.table()], ["0"])

    def test_a_changed_study_keeps_the_rows_that_it_still_has(self):
        self.sweep()
        before = self.table()
        self.write(SMALL_STUDY.replace("[0.4, 20]", "[20, 300]"))
        changed = self.sweep()
        self.assertIn("4 of 8 rows are done already", changed.err)
        self.assertIn("the study has changed: 4 results", changed.err)
        self.assertEqual(len(self.results()), 12)
        of = lambda rows: [row["fragments"] for row in rows if row["sheet.plate.fracture.strain"] == "20"]
        self.assertEqual(of(self.table()), of(before))

    def test_a_folder_has_one_sweep(self):
        self.write(LONG_STUDY)
        process = self.start()
        self.wait_for_checkpoint(process)
        second = self.sweep(expected=2)
        self.assertIn("study.csv", second.err)
        process.terminate()
        process.communicate()
        self.assertEqual(process.returncode, 143)

    def test_rows_can_be_shared_out_and_collected(self):
        self.sweep(into="whole")
        for rows in ("4-7", "0-3"):
            self.sweep("--rows", rows)
        self.assertFalse((self.folder / "study" / "study.csv").exists())
        self.sweep("--collect")
        self.assertEqual(self.table(), self.table("whole"))

    def test_a_bad_study_is_refused_before_anything_runs(self):
        self.write(SMALL_STUDY.replace("[0.4, 20]", "[0.4, -2]"))
        refused = self.sweep(expected=2)
        self.assertIn("sheet.plate.fracture.strain", refused.err)
        self.assertFalse((self.folder / "study").exists())

    def test_a_python_file_measures_too_and_what_it_raises_can_be_tried_again(self):
        if not list((pathlib.Path(self.sherd).parent / "python").glob("sherd/*.so")):
            self.skipTest("built without the module for Python")
        self.enterContext(unittest.mock.patch.dict(os.environ, PATH="/usr/bin:" + os.environ["PATH"]))
        (self.folder / "measure.py").write_text(MEASURE)
        self.write('scene = "tiny.toml"\nrepeats = 2\npython = "measure.py"\nmeasures = ["fragments"]\n')
        failed = self.sweep(expected=1)
        self.assertIn("row 1 failed (1): measure.py: FileNotFoundError", failed.err)
        self.assertEqual([row["exit"] for row in self.table()], ["1", "1"])
        (self.folder / "ready").touch()
        self.sweep("--retry")
        self.assertEqual([(row["exit"], row["frames"]) for row in self.table()], [("0", "2")] * 2)
        self.assertNotIn("nothing", self.table()[0])

    def test_columns_are_drawn(self):
        self.sweep()
        plot = subprocess.run([self.sherd, "plot", "study/study.csv", "--x", "speed", "--y", "peak_force", "--by",
                               "strain", "--log", "xy", "-o", "plot.svg"], cwd=self.folder, capture_output=True,
                              text=True)
        self.assertEqual(plot.returncode, 0, plot.stderr)
        picture = (self.folder / "plot.svg").read_text()
        self.assertEqual(picture.count("<circle"), 4 + 4, "dots for rows, one for those at the same place, and means")
        self.assertIn("peak_force (", picture)
        wrong = subprocess.run([self.sherd, "plot", "study/study.csv", "--x", "sped", "--y", "peak_force", "-o",
                                "b.svg"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("did you mean 'speed'?", wrong.stderr)


if __name__ == "__main__":
    Sweeps.sherd = os.path.abspath(sys.argv.pop(1))
    unittest.main()
