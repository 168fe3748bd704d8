# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the pages under docs/ and the READMEs: links, paths, lengths, and the lists of modules, scenes and presets."""
import json
import os
import pathlib
import re
import tempfile
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]
LICENCE = "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->"
FOLDERS = ("app", "core", "docs", "fracture", "meshops", "scenes", "tests", ".ci")
MOST_LINES = 60  # lines of a folder's README
MOST_COLUMNS = 120  # columns of a page, outside tables and code
SOURCES = (".h", ".cpp")
# Extensions that a path in backticks may leave out.
LEFT_OUT = ("", ".h", ".cpp", ".py", ".toml", "_test.cpp")
# Extensions of files of the project, and folders of an installation or a build that have such files, too.
KNOWN = (".h", ".cpp", ".py", ".md", ".toml")
ELSEWHERE = ("share", "lib", "build")
# Folders whose READMEs list their files of these extensions.
LISTED = {"app": SOURCES, "core": SOURCES, "fracture": SOURCES, "meshops": SOURCES, "scenes": (".toml", ".obj", ".py")}


def pages(top):
    """Returns all .md files of the project, as paths below top."""
    files = [*top.glob("*.md"), *(file for folder in FOLDERS for file in (top / folder).rglob("*.md"))]
    return sorted(file.relative_to(top) for file in files)


def text_of(file):
    return file.read_text(encoding="utf-8")


def prose(text):
    """Returns the lines with their numbers, without those of fenced code."""
    lines, code = [], False
    for number, line in enumerate(text.splitlines(), 1):
        fence = line.lstrip().startswith("```")
        code ^= fence
        if not code and not fence:
            lines.append((number, line))
    return lines


def blocks(text):
    """Yields (number of the first line, text) of each run of lines of prose without a blank one, in which code in
    backticks may be broken between lines."""
    block, first = [], 0
    for number, line in [*prose(text), (0, "")]:
        if block and (not line.strip() or number != first + len(block)):
            yield first, "\n".join(block)
            block = []
        if line.strip():
            first = first if block else number
            block.append(line)


def codes(text):
    """Yields (number of line, code) of all code in backticks."""
    for first, block in blocks(text):
        for match in re.finditer(r"`([^`]+)`", block):
            yield first + block.count("\n", 0, match.start()), match[1]


def headings(text):
    return [(len(match[1]), match[2]) for _, line in prose(text) if (match := re.match(r"(#+) (.*)", line))]


def anchors(text):
    """Returns the anchors that GitHub gives to the headings: a repeated one has -1, -2 and so on behind it."""
    found, counts = set(), {}
    for _, heading in headings(text):
        shown = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
        anchor = re.sub(r"[^\w\- ]", "", shown).replace(" ", "-")
        again = counts[anchor] = counts.get(anchor, -1) + 1
        found.add(f"{anchor}-{again}" if again else anchor)
    return found


def links(text):
    """Yields (number of line, target) of each link and image that is no address of the web."""
    for first, block in blocks(text):
        plain = re.sub(r"`[^`]*`", lambda code: re.sub(r"[^\n]", " ", code[0]), block)
        for match in re.finditer(r"\]\(\s*([^)\s]+)[^)]*\)", plain):
            if not re.match(r"[a-z][a-z+.-]*:", match[1]):
                yield first + block.count("\n", 0, match.start()), match[1]


def broken_links(top, page):
    """Yields a line for each relative link or anchor of a page that leads nowhere."""
    text = text_of(top / page)
    for number, target in links(text):
        path, _, anchor = target.partition("#")
        file = pathlib.Path(os.path.normpath(top / page.parent / path)) if path else top / page
        if not file.exists() or not file.is_relative_to(top):
            yield f"{page}:{number}: {target} is not there"
        elif anchor and (file.suffix != ".md" or anchor not in anchors(text_of(file))):
            yield f"{page}:{number}: {target} has no such heading"


def alternatives(path):
    """Returns the paths that a path with braces, as a/b.{h,cpp}, stands for."""
    match = re.match(r"([^{}]*)\{([^{}]*)\}(.*)", path)
    if match is None:
        return [path]
    return [match[1] + one + rest for one in match[2].split(",") for rest in alternatives(match[3])]


def missing_paths(top, page):
    """Yields a line for each path in backticks that is not there, if it begins with a folder of the project, or has a
    known extension and is then relative to the top or to the page's folder. NAME and wildcards stand for any name."""
    for number, code in codes(text_of(top / page)):
        written = code.split()[0]  # a command may be followed by its arguments
        first = written.split("/")[0]
        if "/" not in written or "NAME" in written or "*" in written:
            continue
        for path in alternatives(written):
            known = first not in ELSEWHERE and pathlib.PurePath(path).suffix in KNOWN
            places = [top] if first in FOLDERS else [top, top / page.parent] if known else []
            if places and not any((place / (path.rstrip("/") + extension)).exists()
                                  for place in places for extension in LEFT_OUT):
                yield f"{page}:{number}: {path} is not there"


def faults_of_form(top, page):
    """Yields a line for each fault of a page's form."""
    text = text_of(top / page)
    if not text.startswith(LICENCE + "\n"):
        yield f"{page}:1: does not begin with {LICENCE}"
    if sum(level == 1 for level, _ in headings(text)) != 1:
        yield f"{page}: has not one heading #"
    if page.name == "README.md" and len(page.parts) > 1 and len(text.splitlines()) > MOST_LINES:
        yield f"{page}: has {len(text.splitlines())} lines; what is past {MOST_LINES} belongs in docs/"
    for number, line in enumerate(text.splitlines(), 1):
        if re.match(r"(<{7}|>{7}) ", line):
            yield f"{page}:{number}: is the mark of a merge conflict"
    if page.parts[0] == "docs" or page.name == "README.md":
        for number, line in prose(text):
            if len(line) > MOST_COLUMNS and not line.lstrip().startswith("|") and not line.startswith("    "):
                yield f"{page}:{number}: has {len(line)} columns; past {MOST_COLUMNS} it should be two lines"


def unreachable(top):
    """Returns a line for each page under docs/ to which no links lead from docs/index.md."""
    reached, waiting = set(), [pathlib.PurePath("docs/index.md")]
    while waiting:
        page = waiting.pop()
        if page in reached or page.suffix != ".md" or page.parts[0] != "docs" or not (top / page).is_file():
            continue
        reached.add(page)
        for _, target in links(text_of(top / page)):
            path = os.path.normpath(page.parent / target.partition("#")[0])
            waiting.append(pathlib.PurePath(path))
    return [f"{page}: no links lead to it from docs/index.md" for page in pages(top)
            if page.parts[0] == "docs" and page not in reached]


def listed(text):
    """Returns all that first columns of tables have in backticks."""
    return [name for _, line in prose(text) if line.startswith("|")
            for name in re.findall(r"`([^`]+)`", line.split("|")[1])]


def module_of(path, extensions):
    """Returns the name by which a README lists a file: without the extension of a source."""
    return str(path.with_suffix("") if extensions == SOURCES and path.suffix in SOURCES else path)


def files_below(folder, extensions):
    """Returns all files in a folder and its subfolders with these extensions, as paths below the folder."""
    return [file.relative_to(folder) for file in folder.rglob("*") if file.suffix in extensions]


def faults_of_list(top, page):
    """Yields a line for each fault of the list in a folder's README: each file of the folder is in it once, and so is
    each subfolder with such files, as `name/`, or else each of its files. Nothing else is in it."""
    folder, extensions = top / page.parent, LISTED.get(page.parts[0])
    if extensions is None or page.name != "README.md" or len(page.parts) == 1:
        return
    modules = {module_of(file, extensions): file for file in files_below(folder, extensions)}
    if not modules:
        return
    names = [module_of(pathlib.PurePath(name), extensions) if not name.endswith("/") else name
             for name in listed(text_of(top / page))]
    for name in sorted(set(names)):
        if names.count(name) > 1:
            yield f"{page}: lists {name} {names.count(name)} times"
        there = (folder / name).is_dir() if name.endswith("/") else (folder / name).exists() \
            or any((folder / (name + extension)).exists() for extension in extensions)
        if not there:
            yield f"{page}: lists {name}, which is not there"
    for name, file in sorted(modules.items()):
        rooms = [f"{room}/" for room in file.parents if room != pathlib.PurePath(".")]
        if name not in names and not any(room in names for room in rooms):
            yield f"{page}: does not list {name}"


def unsaid_includes(top, page):
    """Yields a line for each room of core from which a room with a README of its own includes, although the README's
    paragraph "May include" does not name it."""
    if page.parts[0] != "core" or len(page.parts) != 3 or page.name != "README.md":
        return
    said = re.search(r"^\*\*May include\*\*(.*?)\n\n", text_of(top / page), re.MULTILINE | re.DOTALL)
    rooms = set()
    for file in files_below(top / page.parent, SOURCES):
        included = re.findall(r'^\s*#\s*include\s*"core/(\w+)/', text_of(top / page.parent / file), re.MULTILINE)
        rooms |= set(included) - {page.parts[1]}
    for room in sorted(rooms):
        if said is None or f"`{room}/`" not in said[1]:
            yield f"{page}: does not say that the room may include {room}/"


def first_column(text, heading):
    """Returns what the table below a heading, whose first column is named "preset", has in it."""
    found, columns, within = set(), None, False
    for _, line in prose(text):
        if line.startswith("#"):
            within = line.lstrip("# ") == heading
        cells = [cell.strip(" `") for cell in line.split("|")[1:-1]] if line.startswith("|") else None
        if cells is None:
            columns = None
        elif columns is None:
            columns = cells
        elif within and columns[0] == "preset" and not set(cells[0]) <= set("- "):
            found.add(cells[0])
    return found


def faults_of_presets(top):
    """Returns a line for each table of presets in docs/scene.md that has others than the program, and one if README.md
    names other presets of the build than there are."""
    source, page = text_of(top / "app/scene/read/sheet/material_presets.cpp"), text_of(top / "docs/scene.md")
    presets = re.findall(r'^ +\{"(\w+)", (.*)\},$', source, re.MULTILINE)
    brittle = {name for name, rest in presets if "brittle(" in rest or "broken_" in rest}
    found = []
    tables = {"The material's axis": {name for name, _ in presets}, "Materials that break": brittle}
    for heading, expected in tables.items():
        written = first_column(page, heading)
        if written != expected:
            found.append(f"docs/scene.md: presets under '{heading}' that only one of page and program has: "
                         f"{sorted(written ^ expected)}")
    said = re.search(r"The presets of the build are ([^.]*)\.", text_of(top / "README.md"))
    build = {preset["name"] for preset in json.loads(text_of(top / "CMakePresets.json"))["configurePresets"]}
    if said is None or set(re.findall(r"`(\w+)`", said[1])) != build:
        found.append(f"README.md: the presets of the build are {sorted(build)}")
    return found


def violations(top):
    """Returns a line for each violation of a rule below the folder `top`."""
    found = unreachable(top)
    for page in pages(top):
        for rule in (broken_links, missing_paths, faults_of_form, faults_of_list, unsaid_includes):
            found.extend(rule(top, page))
    return found + faults_of_presets(top)


class Docs(unittest.TestCase):
    maxDiff = None

    def test_these_pages_keep_the_rules(self):
        self.assertGreater(len(pages(TOP)), 30)
        self.assertEqual(violations(TOP), [])

    def found_in(self, files):
        """Returns the violations in a project that keeps all rules, but for these files: {path: text}. A page's text
        gets the licence and a heading."""
        right = {
            "README.md": "[pages](docs/index.md)\n\nThe presets of the build are `release` and `asan`.",
            "docs/index.md": "[scenes](scene.md)",
            "docs/scene.md": "### The material's axis\n\n| preset |\n| --- |\n| `glass` |\n| `steel` |\n\n"
                             "#### Materials that break\n\n| preset |\n| --- |\n| `glass` |",
            "app/scene/read/sheet/material_presets.cpp": '    {"glass", {2500}, brittle(6e7)},\n'
                                                   '    {"steel", metal(7850)},\n',
            "app/scene/read/sheet/material_presets.h": "",
            "app/README.md": "| room |\n| --- |\n| `scene/` |",
            "CMakePresets.json": '{"configurePresets": [{"name": "release"}, {"name": "asan"}]}',
        }
        with tempfile.TemporaryDirectory() as folder:
            top = pathlib.Path(folder)
            for name, text in {**right, **files}.items():
                file = top / name
                file.parent.mkdir(parents=True, exist_ok=True)
                page = name.endswith(".md") and not text.startswith("<!--")
                file.write_text(f"{LICENCE}\n# A page\n\n{text}\n" if page else text, encoding="utf-8")
            return violations(top)

    def assert_found(self, files, *parts):
        """Checks that there is one violation for each of the parts, which it contains, in this order."""
        found = self.found_in(files)
        self.assertEqual(len(found), len(parts), found)
        for line, part in zip(found, parts):
            self.assertIn(part, line)

    def index(self, text):
        return {"docs/index.md": f"[scenes](scene.md)\n\n{text}"}

    def test_a_project_that_keeps_the_rules_is_clean(self):
        self.assert_found({})

    def test_links_that_lead_nowhere_are_found(self):
        self.assert_found(self.index("[a](../README.md) [b](https://example.org/c.md) `[c](d)`\n\n```\n[e](f.md)\n```"))
        self.assert_found(self.index("[a\nb](c.md)"), "docs/index.md:7: c.md is not there")
        self.assert_found(self.index("![a](b.png)"), "b.png is not there")
        self.assert_found(self.index("[a](../../b.md)"), "../../b.md is not there")

    def test_anchors_that_lead_nowhere_are_found(self):
        page = "[a](#one-times-two) [b](#one-times-two-1) [c](scene.md#the-materials-axis)\n\n" \
               "## `One` *times* (two)!\n\n## One [times](scene.md) two"
        self.assert_found(self.index(page))
        self.assert_found(self.index("[a](#one)\n\n```\n# one\n```"), "#one has no such heading")
        self.assert_found(self.index("[a](scene.md#one)"), "scene.md#one has no such heading")

    def test_paths_that_are_not_there_are_found(self):
        self.assert_found(self.index("`app/scene/read/sheet/material_presets` `app/scene/` `app/scene/read/*.cpp`\n"
                                     "`app/scene/read/NAME.h` `build/app/a.h` `a/b.sh` `frames/000000` `../README.md`\n"
                                     "`app/scene/read/sheet/material_presets.{h,cpp}`"))
        self.assert_found(self.index("`app/a.h`"), "docs/index.md:6: app/a.h is not there")
        self.assert_found(self.index("`run`, `and\nmore` `core/a` is"), "docs/index.md:7: core/a is not there")
        self.assert_found(self.index("`app/scene/read/sheet/material_presets.{h,py}`"), "material_presets.py is not there")
        self.assert_found(self.index("`app/a.py --all`"), "app/a.py is not there")
        self.assert_found(self.index("`read/material_presets.h`"), "read/material_presets.h is not there")
        self.assert_found({"app/README.md": "| room |\n| --- |\n| `scene/` |\n\n`scene/read/sheet/material_presets.h`"})

    def test_pages_without_licence_or_heading_are_found(self):
        self.assert_found({"CHANGELOG.md": f"{LICENCE}\n"}, "has not one heading #")
        self.assert_found({"CHANGELOG.md": f"{LICENCE}\n# a\n\n# b\n"}, "has not one heading #")
        self.assert_found({"CHANGELOG.md": "<!-- a -->\n# a\n"}, "does not begin with")

    def test_long_readmes_are_found(self):
        lines = MOST_LINES - 3
        self.assert_found({"tests/README.md": "a\n" * (lines - 1) + "a"})
        self.assert_found({"tests/README.md": "a\n" * lines + "a"}, f"has {MOST_LINES + 1} lines")
        self.assert_found({"docs/a.md": "a\n" * 100, **self.index("[a](a.md)")})

    def test_long_lines_are_found(self):
        self.assert_found(self.index("a" * MOST_COLUMNS + "\n\n| " + "a" * MOST_COLUMNS))
        self.assert_found(self.index("a" * (MOST_COLUMNS + 1)), f"has {MOST_COLUMNS + 1} columns")

    def test_conflicts_of_a_merge_are_found(self):
        self.assert_found(self.index("<" * 7 + " HEAD"), "docs/index.md:6: is the mark of a merge conflict")
        self.assert_found(self.index(">" * 7 + " other"), "is the mark of a merge conflict")
        self.assert_found(self.index("a <" + "<" * 6 + " b"))

    def test_pages_to_which_nothing_leads_are_found(self):
        self.assert_found({"docs/theory/a.md": ""}, "docs/theory/a.md: no links lead to it")
        self.assert_found({"docs/theory/a.md": "[b](b.md)", "docs/theory/b.md": "", **self.index("[a](theory/a.md)")})

    def test_modules_that_no_list_has_are_found(self):
        self.assert_found({"core/README.md": "| `a`, `b.h` | `c` |\n| `d/` |\n| `e/f` |", "core/a.h": "",
                           "core/a.cpp": "", "core/b.h": "", "core/d/g.h": "", "core/e/f.h": ""})
        self.assert_found({"core/README.md": "| `a` |", "core/a.h": "", "core/b.h": ""}, "does not list b")
        self.assert_found({"core/README.md": "| `a` |", "core/a.h": "", "core/d/g.h": ""}, "does not list d/g")
        self.assert_found({"core/README.md": "| `a` |\n| `e/f` |", "core/a.h": "", "core/e/f.h": "", "core/e/g.h": ""},
                          "does not list e/g")
        self.assert_found({"scenes/README.md": "| `a.toml` |", "scenes/a.toml": "", "scenes/b.toml": ""},
                          "does not list b.toml")

    def test_modules_that_a_list_has_twice_or_that_are_not_there_are_found(self):
        self.assert_found({"core/README.md": "| `a` |\n| `a.h` |", "core/a.h": ""}, "lists a 2 times")
        self.assert_found({"core/README.md": "| `a`, `b` |", "core/a.h": ""}, "lists b, which is not there")
        self.assert_found({"core/README.md": "| `a` |\n| `b/` |", "core/a.h": ""}, "lists b/, which is not there")

    def test_includes_that_a_room_does_not_tell_are_found(self):
        house = {"core/README.md": "| `a/` |\n| `b/` |", "core/a/c.h": "", "core/b/d.h": '#include "core/a/c.h"'}
        self.assert_found({**house, "core/b/README.md": "**May include**: `a/`.\n\n| `d` |"})
        self.assert_found({**house, "core/b/README.md": "**May include**: nothing.\n\n| `d` |"}, "may include a/")
        self.assert_found({**house, "core/b/README.md": "| `d` |"}, "may include a/")

    def test_presets_that_differ_are_found(self):
        source = "app/scene/read/sheet/material_presets.cpp"
        self.assert_found({source: '    {"glass", {2500}, brittle(6e7)},\n'}, "['steel']")
        self.assert_found({source: '    {"glass", {2500}},\n    {"steel", metal(7850)},\n'}, "['glass']")
        self.assert_found({"CMakePresets.json": '{"configurePresets": [{"name": "debug"}]}'}, "README.md: the presets")


if __name__ == "__main__":
    unittest.main()
