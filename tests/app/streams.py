# SPDX-License-Identifier: GPL-3.0-or-later
"""streams.py SHERD: tests of standard streams that are full, closed, disconnected or pipes, and of numbers and dashes
in arguments."""
import os
import pathlib
import pty
import signal
import subprocess
import sys
import tempfile
import unittest

SHERD = pathlib.Path(sys.argv.pop(1)).resolve()
SCENE = """duration = 0.01
[sheet.square]
mesh = "square.obj"
material = { preset = "paper" }
[solver]
step = 1e-3
"""
SQUARE = "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nv 0 0.1 0\nf 1 2 3\nf 1 3 4\n"
VARIANTS = '[[variant]]\nname = "one"\n[[variant]]\nname = "two"\n'
STUDY = 'scene = "s.toml"\n[parameters]\nuntil = { set = "duration={}", values = [0.01, 0.02] }\n'


class Streams(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, text in (("s.toml", SCENE), ("square.obj", SQUARE), ("two.toml", SCENE + VARIANTS),
                           ("study.toml", STUDY)):
            (self.folder / name).write_text(text)

    def sherd(self, *arguments, **options):
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        return subprocess.run([SHERD, *arguments], cwd=self.folder, text=True, timeout=300, **options)

    def end_of(self, recording):
        return self.sherd("info", recording).stdout.splitlines()[1].split()[1].rstrip(",")

    def test_what_stderr_does_not_take_is_dropped(self):
        with open("/dev/full", "w") as full:
            for arguments, code in ((["run", "s.toml", "-o", "r.h5"], 0), (["run", "two.toml", "-o", "v"], 0),
                                    (["run", "s.toml", "-o", "r.h5", "--resume"], 0),
                                    (["export", "r.h5", "--to", "obj", "-o", "x.obj"], 0), (["run", "none.toml"], 2),
                                    (["sweep", "study.toml", "-o", "study", "--jobs", "1"], 0),
                                    (["render", "r.h5", "-o", "x.png", "--size", "16x16"], 0), ([], 2)):
                self.assertEqual(self.sherd(*arguments, stderr=full).returncode, code, arguments)
        for recording in ("r.h5", "v/two-one.h5", "v/two-two.h5"):
            self.assertEqual(self.end_of(recording), "complete")

    def test_a_full_stdout_is_said_when_the_work_is_done(self):
        with open("/dev/full", "w") as full:
            for arguments in (["run", "s.toml", "-o", "r.h5"], ["run", "two.toml", "-o", "v"], ["check", "s.toml"],
                              ["info", "r.h5"], ["info", "r.h5", "--json"], ["scenes"], ["modes", "s.toml"],
                              ["export", "r.h5", "--to", "obj", "-o", "x.obj"], ["view", "r.h5", "-o", "x.html"],
                              ["plot", "r.h5", "-o", "x.svg"], ["mesh", "s.toml", "-o", "x.ply"],
                              ["completion", "bash"], ["manual"], ["--help"], ["run", "--help"], ["--version"]):
                done = self.sherd(*arguments, stdout=full)
                self.assertEqual((done.returncode, done.stderr.splitlines()[-1]),
                                 (1, "sherd: error: cannot write to standard output"), arguments)
        for recording in ("r.h5", "v/two-one.h5", "v/two-two.h5"):
            self.assertEqual(self.end_of(recording), "complete")

    def test_a_file_does_not_get_the_number_of_a_closed_stream(self):
        done = self.sherd("run", "s.toml", "-o", "r.h5", preexec_fn=lambda: (os.close(0), os.close(1), os.close(2)))
        self.assertEqual(done.returncode, 1)
        self.assertEqual(self.end_of("r.h5"), "complete")

    def test_a_reader_that_has_gone_ends_no_run(self):
        for stream, code in (("stderr", 0), ("stdout", -signal.SIGPIPE)):
            ends = os.pipe()
            os.close(ends[0])
            self.assertEqual(self.sherd("run", "s.toml", "-o", f"{stream}.h5", **{stream: ends[1]}).returncode, code)
            os.close(ends[1])
            self.assertEqual(self.end_of(f"{stream}.h5"), "complete")

    def test_a_terminal_that_has_gone_ends_no_run(self):
        try:
            ends = pty.openpty()
        except OSError:
            self.skipTest("this machine makes no pseudo terminals: is /dev/pts mounted?")
        run = subprocess.Popen([SHERD, "run", "s.toml", "-o", "r.h5", "--set", "duration=0.3"], cwd=self.folder,
                               stdin=ends[1], stdout=subprocess.DEVNULL, stderr=ends[1])
        os.close(ends[1])
        os.read(ends[0], 1)  # waits until the program has written
        os.close(ends[0])
        self.assertEqual(run.wait(timeout=300), 0)
        self.assertEqual(self.end_of("r.h5"), "complete")

    def test_scenes_come_through_pipes(self):
        for command in (["check", "--no-try"], ["run", "-o", "r.h5"]):
            done = self.sherd(*command, "/dev/stdin", input=SCENE)
            self.assertEqual(done.returncode, 0, done.stderr)
        wrong = self.sherd("check", "/dev/stdin", input=SCENE.replace("paper", "papier"))
        self.assertIn("pipe:4: sheet.square.material.preset", wrong.stderr)
        several = self.sherd("run", "/dev/stdin", "-o", "v", input=SCENE + VARIANTS)
        self.assertEqual(several.returncode, 2)
        self.assertIn("give a file, or --variant NAME", several.stderr)

    def test_numbers_are_asked_for_in_words(self):
        self.assertEqual(self.sherd("run", "s.toml", "-o", "r.h5").returncode, 0)
        for command, option, wanted in (
                ("run s.toml", "--threads", "a whole number from 1 on"), ("run s.toml", "--jobs", "a whole number from 1 on"),
                ("run s.toml", "--until", "a number above 0"), ("info r.h5 --measures", "--over", "a number, 0 or more"),
                ("info r.h5 --measures", "--radii", "a number above 0"), ("view r.h5", "--megabytes", "a number from 1 to 400"),
                ("modes s.toml", "--count", "a whole number from 1 to 1000"), ("sweep study.toml", "--jobs", "a whole number from 1 on")):
            for value in ("nan", "inf", "-1", "1x") + (("0",) if "0 or more" not in wanted else ()):
                done = self.sherd(*command.split(), f"{option}={value}")
                self.assertEqual(done.returncode, 2, (command, option, value))
                self.assertIn(f"{option}: give {wanted}, not '{value}'", done.stderr)

    def test_numbers_that_commands_look_at_themselves(self):
        self.assertEqual(self.sherd("run", "s.toml", "-o", "r.h5").returncode, 0)
        for command in ("export r.h5 --to pc2 --slow", "export r.h5 --to pc2 --rate", "export r.h5 --to stl --solid --thickness",
                        "export r.h5 --to vdb --voxel", "render r.h5 -o f.png --samples", "view r.h5 --slow"):
            for value in ("nan", "inf", "-1", "0"):
                done = self.sherd(*command.split(), value, "--force")
                self.assertEqual((done.returncode, done.stderr.count(command.split()[-1])), (2, 1), (command, value, done.stderr))

    def test_two_dashes_end_the_options(self):
        (self.folder / "-s.toml").write_text(SCENE)
        (self.folder / "-study.toml").write_text(STUDY.replace("s.toml", "-s.toml"))
        (self.folder / "-two.toml").write_text(SCENE + VARIANTS)
        for arguments in (["check", "--no-try", "--", "-s.toml"], ["run", "-o", "r.h5", "--", "-s.toml"],
                          ["run", "-o", "v", "--", "-two.toml"], ["sweep", "-o", "rows", "--", "-study.toml"],
                          ["mesh", "-o", "x.ply", "--", "-s.toml"]):
            done = self.sherd(*arguments)
            self.assertEqual(done.returncode, 0, (arguments, done.stderr))


if __name__ == "__main__":
    unittest.main()
