# SPDX-License-Identifier: GPL-3.0-or-later
"""snippets_test.py SHERD BENCH BUILD: holds all snippets of the pages against the programs SHERD and BENCH and the rest
of the build folder BUILD: scenes are read, Python is run, C++ is compiled, and commands have the options that programs,
scripts and presets have.

A fenced block says its language; an indented one has commands. Code in backticks counts, too, if it is a command or a
line of a scene; words in capitals there, and those in brackets, stand for others."""
import collections
import functools
import pathlib
import re
import sys
import unittest

from code_snippets import CppSnippets, PythonSnippets
from command_snippets import CommandSnippets
from docs_test import TOP, codes, pages, text_of
from scene_snippets import SceneSnippets

SHERD, BENCH, BUILD = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
SCENES, PYTHON = SceneSnippets(SHERD), PythonSnippets(SHERD)
COMMANDS = CommandSnippets(SHERD, BENCH, BUILD, SCENES, PYTHON.faults)
# Checks of blocks by their language; indented ones have none.
INDENTED = "an indented block"
CHECKS = {"toml": SCENES.faults_of_block, "python": PYTHON.faults, "cpp": CppSnippets(BUILD).faults,
          "sh": COMMANDS.faults, "scene-keys": COMMANDS.faults, INDENTED: COMMANDS.faults}
UNCHECKED = ("text", "bibtex")  # output, formulas, listings
Snippet = collections.namedtuple("Snippet", "line language text")  # line: number of the first one; text: without margin


def margin(line):
    return len(line) - len(line.lstrip(" "))


def without_margin(lines, columns):
    return "\n".join(line[columns:].rstrip() for line in lines).rstrip("\n")


def blocks(text):
    """Yields the fenced and indented blocks of a page. A line after an empty one belongs to an indented block if it is
    four columns right of the text of the list item that it stands in."""
    lines, items, at = text.splitlines(), [], 0
    while at < len(lines):
        line, after_gap = lines[at], at == 0 or not lines[at - 1].strip()
        first, columns = at, margin(line)
        at += 1
        if not line.strip():
            continue
        if fence := re.match(r" *(`{3,}) *(.*)", line):
            while at < len(lines) and lines[at].strip() != fence[1]:
                at += 1
            yield Snippet(first + 2, fence[2].strip(), without_margin(lines[first + 1:at], columns))
            at += 1
            continue
        item = re.match(r" *([-*+]|\d+[.)]) +", line)
        while items and columns < items[-1] and (after_gap or item):
            items.pop()
        least = (items[-1] if items else 0) + 4
        if after_gap and columns >= least:
            while at < len(lines) and (not lines[at].strip() or margin(lines[at]) >= least):
                at += 1
            yield Snippet(first + 1, INDENTED, without_margin(lines[first:at], least))
        elif item:
            items.append(item.end())


def mention(page, code):
    """Returns a check of code in backticks, if it is a command or a line of a scene. The list of changes names those that
    are no more, and "sherd recording" is the name of a format."""
    if page.name == "CHANGELOG.md" or code == "sherd recording":
        return None
    if re.match(r"(sherd|sherd-bench|cmake|ctest|build/\S+|(app|docs|tests)/\S+) ", code):
        return functools.partial(COMMANDS.faults, code, is_mention=True)
    return functools.partial(SCENES.faults_of_line, code) if re.match(r"[\w.]+ = ", code) else None


def checks(page, text):
    """Yields (line, language, check) of all snippets that are checked, of commands of each line by itself. A check returns
    what is wrong."""
    for line, language, snippet in blocks(text):
        if CHECKS.get(language) == COMMANDS.faults:
            for number, command in enumerate(snippet.splitlines(), line):
                yield number, language, functools.partial(COMMANDS.faults, command)
        elif language in CHECKS:
            yield line, language, functools.partial(CHECKS[language], snippet)
        elif language not in UNCHECKED:
            known = ", ".join(name for name in (*CHECKS, *UNCHECKED) if name != INDENTED)
            yield line, language, functools.partial(list, [f"say what it is: '{language}' is none of {known}"])
    for line, code in codes(text):
        if check := mention(page, " ".join(code.split())):
            yield line, "mentions", check


def violations(page, text, counts):
    """Yields a line for each fault of a page's snippets; adds to counts how many of each language are checked."""
    for line, language, check in checks(page, text):
        counts[language] += 1
        yield from (f"{page}:{line}: {fault}" for fault in check())


class Snippets(unittest.TestCase):
    maxDiff = None

    def test_all_snippets_of_all_pages_are_right(self):
        counts, found = collections.Counter(), []
        for page in pages(TOP):
            found += violations(page, text_of(TOP / page), counts)
        self.assertEqual(found, [])
        self.assertEqual({*CHECKS, "mentions"} - set(counts), {"sh"}, "languages of which there is nothing to check")

    def assert_found(self, text, *parts):
        """Checks that there is one violation for each of the parts, which it contains, in this order."""
        found = list(violations(pathlib.PurePath("docs/a.md"), text, collections.Counter()))
        self.assertEqual(len(found), len(parts), found)
        for line, part in zip(found, parts):
            self.assertIn(part, line)

    def assert_wrong(self, command, *parts):
        self.assert_found(f"    {command}", *parts)

    def test_blocks_that_do_not_say_what_they_are_are_found(self):
        self.assert_found("```text\nrun it\n```\n\n`run it`")
        self.assert_found("a\n\n```\na\n```", "docs/a.md:4: say what it is: ''")
        self.assert_found("```yaml\na: b\n```", "say what it is: 'yaml' is none of toml, python, cpp, sh")
        self.assert_found("a\n\n    it = an output", "docs/a.md:3: it is no program that is known")

    def test_blocks_in_lists_are_found_and_their_paragraphs_are_none(self):
        self.assert_found("- a\n\n  b\n\n    c\n\n- d\n    e")
        self.assert_found("- a\n\n      run it", "docs/a.md:3: run is no program")
        self.assert_found("1. a\n\n   ```\n   b\n   ```\n\n       run it", "docs/a.md:4: say", "docs/a.md:7: run is")
        self.assert_found("- a\n\nb\n\n    run it", "docs/a.md:5: run is")
        self.assert_found("a\n    run it")

    def test_commands_that_are_right_are_left_alone(self):
        self.assert_found("""
    sherd run plate_drop -o a.h5 --set solver.step=1e-4 --set solver.scheme=explicit --resume  # and more
    sherd sweep studies/drop_height --quick && sherd plot drop_height/study.csv --log xy | awk 1 >a
    sherd render a.h5 --frames -1 --size=80x60; build/release/app/sherd info a.h5
    sherd run scenes/paper/figure_6_plates.toml --variant vertical
    cmake --preset edit && cmake --build build/edit --target sherd
    tests/run -L house -R house.docs

`sherd run`, `sherd scenes --keys [TABLE]`, `sherd run SCENE.toml --set KEY=VALUE`, `sherd plot a.h5 [-o FILE.svg]`""")

    def test_commands_that_programs_do_not_have_are_found(self):
        self.assert_wrong("sherd brake plate_drop", "sherd has no command brake")
        self.assert_wrong("sherd run plate_drop --forse", "sherd run has no option --forse")
        self.assert_wrong("sherd scenes --settable plate_drop", "has no option --settable", "takes 0 words")
        self.assert_wrong("sherd export a.h5 --to onj", "--to onj: is none of obj, ply")
        self.assert_wrong("sherd run plate_drop --threads", "--threads needs a value")
        self.assert_wrong("sherd run plate_dorp", "plate_dorp: no scene")
        self.assert_wrong("sherd run scenes/plate_dorp.toml", "scenes/plate_dorp.toml: is not there")
        self.assert_wrong("sherd run", "sherd run takes 1 words, not 0")
        self.assert_wrong("sherd info a.h5 b.h5", "sherd info takes 1 words, not 2")
        self.assert_wrong("sherd scenes --keys solvr", "solvr")
        self.assert_wrong("sherd run plate_drop --set solver.stepp=1", "'stepp' was unexpected")
        self.assert_wrong("sherd run plate_drop --set solver.step=long", "solver.step: 'long'")
        self.assert_wrong("sherd-bench shels", "name shels: is none of")
        self.assert_wrong("shred run plate_drop", "shred is no program")
        self.assert_found("a `sherd\nrun --forse`", "docs/a.md:1: sherd run has no option --forse")

    def test_what_the_build_and_scripts_do_not_have_is_found(self):
        self.assert_wrong("cmake --preset relase", "--preset relase is none")
        self.assert_wrong("cmake --build build/release --target shred", "--target shred is none")
        self.assert_wrong("cmake --build build/relase", "build/relase is the folder of no preset")
        self.assert_wrong("ctest --preset fuzz", "--preset fuzz is none")
        self.assert_wrong("ctest --test-dir build/relase", "build/relase is the folder of no preset")
        self.assert_wrong("tests/run -R NoTestHasThisName", "chooses no test")
        self.assert_wrong("tests/runs", "tests/runs is not there")
        self.assert_wrong("docs/index.md", "docs/index.md is no program")
        self.assert_wrong("tests/tidy --to", "tests/tidy has no option --to")
        self.assert_wrong("printf 'a", "No closing quotation")

    def test_scenes_that_are_wrong_are_found(self):
        whole = "duration = 1\n[sheet.a]\nmaterial = { preset = 'glass' }\n"
        mesh = "mesh = { generate = 'disc', radius = 0.1, edge_length = 1e-5 }\n"
        self.assert_found(f"```toml\n{whole}{mesh}```")
        self.assert_found(f"```toml\n{whole}```", "sheet.a.mesh")
        self.assert_found(f"```toml\n{whole}mesh = 'a.obj'\nvelocty = 1\n```", "'velocty' was unexpected")
        self.assert_found("```toml\n[solver]\nscheme = 'static'\n```\n```toml\nvelocity = [0, 0, 1]\n```")
        self.assert_found("```toml\n[solver]\nscheme = 'statics'\n```", "statics")
        self.assert_found("```toml\n[solver\n```", "Expected")
        self.assert_found("`scheme = 'static'` `fracture.strain = 2` `log = true` `young = [E1, E2]`")
        self.assert_found("a\n`shceme = 'static'`", "docs/a.md:2: shceme = 'static' may stand in no table")
        self.assert_found("```toml\nscene = 'plate_drop'\n[parameters]\nseed = [1]\n```")
        self.assert_found("```toml\nscene = 'plate_drop'\n[parameters]\nsed = [1]\n```", "sed")

    def test_python_that_is_wrong_is_found(self):
        self.assert_found("```python\nimport sherd\nprint(numpy.zeros(3))\n```")
        self.assert_found("```python\nimport sherd\nsherd.brake()\n```", "no attribute 'brake'")
        self.assert_found("```python\nprint(nobody)\n```", "name 'nobody' is not defined")
        self.assert_found("```python\nif:\n```", "line 1: invalid syntax")
        self.assert_found("```python\ndef measure(recording):\n    return recording.nothing\n```", "'nothing'")

    def test_cpp_that_is_wrong_is_found(self):
        self.assert_found("```cpp\nsherd::CrackMesh cracks(mesh);\ncracks.brake(edges);\n```", "‘brake’")


if __name__ == "__main__":
    del sys.argv[1:4]
    unittest.main()
