#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the tables of docs/theory/fracture.md one after another.

    tests/benchmarks/fracture_tables.py build/release/app/sherd [--quick]

With --quick makes the cheapest rows of each. Prints before each table the command that makes this table alone. If a
table fails, the others are still made, and the exit code is 1. Needs h5py, numpy and scipy.
"""
import argparse
import pathlib
import shlex
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
# Heading, command of the table, and command of its cheapest rows.
TABLES = (
    ("Experiments beside theory", "SHERD-bench fracture", "SHERD-bench fracture --quick"),
    ("Window", "window_table.py SHERD 5", "window_table.py SHERD 1 5"),
    ("Struck plate", "star_table.py SHERD 3", "star_table.py SHERD 1 12"),
    ("Tempered glass: energy of a freed end", "freed_end.py", "freed_end.py"),
    ("Tempered glass: pieces", "tempered_table.py SHERD 3", "tempered_table.py SHERD 1 60"),
    ("Steps and meshes", "breaking_table.py SHERD 2", "breaking_table.py SHERD 1"),
    ("Steps and meshes, coupled hinges", "breaking_table.py SHERD 1 coupled", None),
    ("Torn flap", "flap_table.py SHERD 2 0.0028 0.002 0.0014", "flap_table.py SHERD 1 0.0028"),
    ("Blunt tool", "tool_table.py SHERD 2 0.0028 0.002", "tool_table.py SHERD 1 0.0028 --tool 0.016"),
    ("Blunt tool, fine mesh", "tool_table.py SHERD 1 0.0014 --tool 0.016", None),
    ("Fragments by mass", "fragment_table.py SHERD 3", "fragment_table.py SHERD 1 glass_tube"),
)


def command(words, sherd):
    """Returns the words of a command with paths in place of names."""
    script, *others = (sherd if word == "SHERD" else word for word in words.split())
    return [str(HERE / script), *others] if script.endswith(".py") else [script, *others]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sherd")
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    failed = []
    for heading, whole, quick in TABLES:
        words = quick if options.quick else whole
        if not words:
            continue
        made_by = command(words, options.sherd)
        print(f"## {heading}\n\n`{shlex.join(made_by)}`\n", flush=True)
        interpreter = [sys.executable] if made_by[0].endswith(".py") else []
        code = subprocess.run([*interpreter, *made_by], check=False).returncode
        if code:
            failed.append(heading)
            print(f"Failed with exit code {code}.")
        print(flush=True)
    if failed:
        print(f"Not made: {', '.join(failed)}.")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
