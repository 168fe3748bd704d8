# SPDX-License-Identifier: GPL-3.0-or-later
"""readme_commands.py SHERD: runs the commands of the README's section "The first ten minutes" one after the other.

The plate is coarser and falls for a shorter time: its scene lies in the working folder, where it takes precedence over
the installed one."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SHERD = pathlib.Path(sys.argv.pop(1)).resolve()
TOP = pathlib.Path(__file__).resolve().parents[2]
SHORTER = [(r"^duration = .*", "duration = 0.002"), (r"edge_length = [0-9.e-]+", "edge_length = 0.012")]


def commands():
    """Returns the commands of the section, without the alias."""
    section = (TOP / "README.md").read_text().split("\n## The first ten minutes\n")[1].split("\n## ")[0]
    return [line[4:] for line in re.findall(r"^    .*", section, re.MULTILINE) if not line.startswith("    alias ")]


class FirstTenMinutes(unittest.TestCase):
    def test_every_command_does_what_it_says(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "bin").mkdir()
            (folder / "bin/sherd").symlink_to(SHERD)
            text = (TOP / "scenes/plate_drop.toml").read_text()
            for old, new in SHORTER:
                text, count = re.subn(old, new, text, flags=re.MULTILINE)
                self.assertGreater(count, 0, old)
            (folder / "plate_drop.toml").write_text(text)
            environment = {**os.environ, "PATH": f"{folder}/bin:/usr/bin:/bin"}
            lines = commands()
            self.assertGreater(len(lines), 15)
            for line in ["sherd run plate_drop", *lines]:
                done = subprocess.run(["bash", "-c", line], cwd=folder, env=environment, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, f"{line}\n{done.stderr}")
                self.assertNotIn("warning", done.stderr, line)
            for made in ("plate_drop.svg", "plate_drop.html", "plate_drop.glb", "pictures", "hard.h5", "modes.h5",
                         "opened.obj"):
                self.assertTrue((folder / made).exists(), made)


if __name__ == "__main__":
    unittest.main()
