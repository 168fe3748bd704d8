#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the studies of scenes/studies in their quick form: finds studies whose scene, measure or Python file has become
incompatible with the program.

    studies.py build/release/app/sherd
"""
import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]
STUDIES = TOP / "scenes/studies"
PROGRAM = os.path.abspath(sys.argv.pop(1))
MODULE = pathlib.Path(PROGRAM).parent / "python"
TEXTS = {path.stem: path.read_text(encoding="utf-8") for path in STUDIES.glob("*.toml")}
NAMES = sorted(name for name, text in TEXTS.items() if "\n[parameters]" in text)
# A build with sanitizers has no Python module, which some studies need.
RUNNABLE = [name for name in NAMES if (MODULE / "sherd").exists() or "\npython = " not in TEXTS[name]]


class Studies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.room = tempfile.TemporaryDirectory()
        cls.environment = os.environ | {"PYTHONPATH": str(MODULE), "PATH": "/usr/bin:" + os.environ["PATH"]}

    @classmethod
    def tearDownClass(cls):
        cls.room.cleanup()

    def run_program(self, *command):
        done = subprocess.run(command, cwd=self.room.name, env=self.environment, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, f"{command}: {done.stderr}")
        return done.stdout

    def table(self, name):
        self.run_program(PROGRAM, "sweep", str(STUDIES / f"{name}.toml"), "--quick", "-o", name)
        with open(pathlib.Path(self.room.name, name, "study.csv"), encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_each_has_numbers_in_all_columns(self):
        self.assertEqual(len(NAMES), 6)
        for name in RUNNABLE:
            with self.subTest(name):
                rows = self.table(name)
                self.assertGreaterEqual(len(rows), 2)
                for column in rows[0]:
                    if column not in ("message", "recording"):
                        self.assertTrue(any(row[column] for row in rows), column)

    def test_the_page_draws_what_the_tables_have(self):
        page = (TOP / "docs/studies.md").read_text(encoding="utf-8")
        plots = [line.split() for line in page.splitlines() if line.strip().startswith("sherd plot ")]
        self.assertEqual(len(plots), 6)
        for _, _, table, *rest in plots:
            name = pathlib.Path(table).parent.name
            if name not in RUNNABLE:
                continue
            if not pathlib.Path(self.room.name, table).exists():
                self.table(name)
            self.run_program(PROGRAM, "plot", table, *rest)

    def test_a_python_file_that_measures_nothing_is_refused_before_a_run(self):
        if not (MODULE / "sherd").exists():
            self.skipTest("a build without the module for Python")
        study = pathlib.Path(self.room.name, "nothing.toml")
        study.write_text('scene = "plate_drop"\npython = "nothing.py"\n', encoding="utf-8")
        for text, reason in (("", "nothing.py: it has no function measure(recording)"),
                             ("import nowhere\n", "nothing.py: ModuleNotFoundError: No module named 'nowhere'")):
            pathlib.Path(self.room.name, "nothing.py").write_text(text, encoding="utf-8")
            done = subprocess.run([PROGRAM, "sweep", study], cwd=self.room.name, env=self.environment,
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 2)
            self.assertIn(reason, done.stderr)
            self.assertFalse(any(pathlib.Path(self.room.name, "nothing", "runs").glob("*")))

    def fitted(self, script, header, rows, *names):
        table = pathlib.Path(self.room.name, "made.csv")
        table.write_text("\n".join([header] + [",".join(map(str, row)) for row in rows]) + "\n", encoding="utf-8")
        return self.run_program("/usr/bin/python3", str(STUDIES / script), str(table), *names)

    def test_the_height_and_the_power_of_tables_that_are_made_are_found(self):
        # Symmetric about the height h at which half of the rows break: as many break at h / f as do not at f h.
        rows = [(h, int(i < share), 0) for h, share in ((0.125, 1), (0.25, 5), (1, 15), (2, 19)) for i in range(20)]
        self.assertIn("half of 80 break from 0.500 m", self.fitted("half_height.py", "height,broken,exit", rows))
        rows = [(x, 3 * x**0.5, 0) for x in (1, 4, 9, 16)] + [(25, 0, 0), (36, "", 0), (49, 1, 1)]
        self.assertIn("y ~ x^0.50, with a deviation of 0.00, of 4 rows",
                      self.fitted("power.py", "x,y,exit", rows, "x", "y"))


if __name__ == "__main__":
    unittest.main()
