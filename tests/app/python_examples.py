# SPDX-License-Identifier: GPL-3.0-or-later
"""python_examples.py FOLDER: runs each Python example in FOLDER and checks the numbers that it prints."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(sys.argv.pop(1)).resolve()


def said_by(name, folder=None):
    """Returns the output of an example, which must print results only and no warnings."""
    with tempfile.TemporaryDirectory() as own:
        done = subprocess.run([sys.executable, "-W", "error", FOLDER / f"{name}.py"], cwd=folder or own,
                              capture_output=True, text=True)
    if done.returncode or done.stderr:
        raise AssertionError(f"{name}: {done.stderr}")
    return done.stdout


def numbers_in(text):
    return [float(number) for number in re.findall(r"-?\d+\.?\d*", text)]


class Examples(unittest.TestCase):
    def test_all_are_run_here_and_short(self):
        tests = {name.removeprefix("test_") for name in dir(self) if name.startswith("test_")}
        for example in FOLDER.glob("*.py"):
            self.assertIn(example.stem, tests)
            self.assertIn(len(example.read_text().splitlines()), range(20, 61), example)

    def test_drop_plate(self):
        with tempfile.TemporaryDirectory() as folder:
            said = said_by("drop_plate", folder)
            self.assertTrue(pathlib.Path(folder, "plate.h5").exists())
        self.assertIn("0.010 s: ", said)
        self.assertIn("11 frames", said)
        self.assertGreater(numbers_in(said.splitlines()[-1])[0], 0)  # energy lost to cracks, J

    def test_moving_load(self):
        deflection, _, static = numbers_in(said_by("moving_load"))
        self.assertGreater(deflection, 0.5 * static)
        self.assertLess(deflection, 2 * static)

    def test_fit_young(self):
        _, young, sag, beam = numbers_in(said_by("fit_young"))
        self.assertAlmostEqual(sag, 12.3, places=3)
        self.assertAlmostEqual(young / beam, 1, delta=0.03)

    def test_open_sphere(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(numbers_in(said_by("open_sphere", folder)), [72, 6, 342, 266])
            self.assertEqual(pathlib.Path(folder, "gores.obj").read_text().count("\ng gore_"), 6)

    def test_cup_modes(self):
        rigid, *modes = said_by("cup_modes").splitlines()
        self.assertLess(max(numbers_in(rigid)[1:]), 5)  # Hz
        self.assertEqual([numbers_in(mode)[1] for mode in modes[:4]], [2, 2, 3, 3])
        frequencies = [numbers_in(mode)[0] for mode in modes]
        self.assertEqual(frequencies, sorted(frequencies))
        self.assertAlmostEqual(frequencies[0] / frequencies[1], 1, delta=0.01)  # two modes with the same frequency

    def test_trampoline(self):
        touched, sinks = said_by("trampoline").splitlines()
        strikes, leaves = numbers_in(touched)[1], numbers_in(sinks)[1]
        self.assertAlmostEqual(strikes, (2 * 9.81 * 0.1) ** 0.5, delta=0.05)
        self.assertGreater(leaves, 0.5 * strikes)
        self.assertLess(leaves, strikes)


if __name__ == "__main__":
    unittest.main()
