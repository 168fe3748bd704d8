# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the project's rules that no compiler checks: includes between folders, licence lines, lengths of files, sizes
of folders, beginnings of comments."""
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import counts  # noqa: E402

TOP = pathlib.Path(__file__).resolve().parents[2]
# Top folders from which a top folder may include, besides itself. tests/NAME may include what NAME may, and
# tests/support.
BELOW = {"meshops": [], "core": [], "fracture": ["core", "meshops"], "app": ["fracture", "core", "meshops"]}
# External libraries that a single top folder may include.
KEPT_ON = {"CGAL": "meshops", "openvdb": "meshops", "suitesparse": "core", "cholmod.h": "core", "Spectra": "core",
           "hdf5.h": "app", "toml++": "app", "CLI": "app"}
# Top folders whose subfolders must not include from each other in a circle.
WITHOUT_CIRCLES = ("meshops", "core", "fracture", "app")
# Folders whose files must not include each other in a circle; a header and its source count as one file.
FILES_WITHOUT_CIRCLES = ("app/scene",)
# Folders that must not include from others, not even indirectly.
APART = {"app/scene/toml": ["app/scene/read", "app/scene/assemble"], "app/scene/read": ["app/scene/assemble"],
         "app/recording": ["app/scene", "app/run"], "app/files": ["app/recording", "app/scene"]}
# Calls that print. Only the folders of MAY_PRINT have them: app/messages, whose print.h makes no run fail when a stream
# does, and the examples, which are programs of their own.
PRINTS = re.compile(r"fmt::print\((?!out,)|std::f?puts|std::f?printf|std::cout|std::cerr|fflush\(stderr\)")
MAY_PRINT = ("app/messages", "app/examples")
LICENCE = "SPDX-License-Identifier: GPL-3.0-or-later"
MOST_LINES = 600
MOST_SOURCES = 30


def sources(top):
    """Yields all C++ files, scripts and CMake files of the project, as paths below top."""
    for folder in [*BELOW, "tests", "docs", ".ci", "CMakeLists.txt"]:
        files = [top / folder] if (top / folder).is_file() else sorted((top / folder).rglob("*"))
        for file in files:
            if file.is_file() and (file.suffix in (".h", ".cpp", ".py", ".cmake") or file.name == "CMakeLists.txt"
                                   or file.read_bytes().startswith(b"#!")):
                yield file.relative_to(top)


def may_include(file, included):
    """Returns whether a source may have #include "included"; both are paths below the top folder."""
    tested = file.parts[0] == "tests"
    if tested and (file.parts[1] not in BELOW or included.parts[:2] == ("tests", "support")):
        return included.parts[0] in BELOW or included.parts[0] == "tests"
    floor = file.parts[1 if tested else 0]
    return included.parts[0] in [floor, *BELOW[floor]] or included.parent == file.parent


def violations_of_includes(top, file, lines):
    for number, line in enumerate(lines, 1):
        include = re.match(r'\s*#\s*include\s*(["<])([^">]+)[">]', line)
        if not include:
            continue
        quote, name = include.groups()
        where = f"{file}:{number}: "
        if quote == "<":
            floor = KEPT_ON.get(name.split("/")[0])
            if floor and file.parts[0] not in (floor, "tests"):
                yield where + f"<{name}> belongs in {floor}/ only"
        elif not (top / name).is_file():
            yield where + f'"{name}" is not a file of the project, written from the top folder'
        elif not may_include(file, pathlib.PurePath(name)):
            yield where + f'{file.parent}/ must not include "{name}"'


def violations_of_streams(file, lines):
    if file.is_relative_to("tests") or str(file.parent) in MAY_PRINT:
        return
    for number, line in enumerate(lines, 1):
        if PRINTS.search(line):
            yield f"{file}:{number}: only app/messages/print.h writes to standard streams"


def included_by(top, folder, name_of):
    """Returns the includes between sources below a folder: for each name, the set of other names that it includes.
    name_of: function that returns the name for a file, so that several files can have the same."""
    above = {}
    for file in sources(top):
        if not file.is_relative_to(folder) or file.suffix not in (".h", ".cpp"):
            continue
        names = above.setdefault(name_of(file), set())
        for name in re.findall(r'^\s*#\s*include\s*"([^"]+)"', (top / file).read_text(), re.MULTILINE):
            other = pathlib.PurePath(name)
            if other.is_relative_to(folder) and name_of(other) != name_of(file):
                names.add(name_of(other))
    return above


def room_of(file):
    return f"{file.parent}/"


def stem_of(file):
    return str(file.with_suffix(""))


def reached_from(above):
    """Returns for each name all names that it includes, directly or indirectly."""
    reached = {}
    for name in above:
        reached[name], waiting = set(), [name]
        while waiting:
            for other in above.get(waiting.pop(), set()) - reached[name]:
                reached[name].add(other)
                waiting.append(other)
    return reached


def circles(above):
    """Returns a line for each two names that include from each other, directly or indirectly."""
    reached = reached_from(above)
    return [f"{one} and {other} include from each other, by way of others perhaps"
            for one in sorted(above) for other in sorted(reached[one])
            if one < other and one in reached.get(other, set())]


def not_apart(top):
    """Returns a line for each folder that includes, directly or indirectly, from a folder forbidden by APART."""
    reached = reached_from(included_by(top, "app", room_of))
    return [f"{room}/ must not include from {other}, by way of others neither"
            for room, apart in APART.items() for other in sorted(reached.get(f"{room}/", set()))
            if any(pathlib.PurePath(other).is_relative_to(forbidden) for forbidden in apart)]


def types_of_one_name(top):
    """Returns a line for each type that two headers define under the same name: the linker would use one for both."""
    defined, found = {}, []
    for file in sources(top):
        if file.suffix != ".h":
            continue
        text = (top / file).read_text()
        inside = re.search(r"^namespace ([\w:]+) {", text, re.MULTILINE)
        for name in re.findall(r"^(?:struct|class) (\w+(?:::\w+)*)[^;{]*{", text, re.MULTILINE):
            other = defined.setdefault((inside and inside.group(1), name), file)
            if other != file:
                found.append(f"{file}: {name} is a type of {other}, too")
    return found


def large_folders(by_folder):
    return [f"{folder}/ has {len(found.lengths)} sources; past {MOST_SOURCES} it should have rooms"
            for folder, found in by_folder.items() if len(found.lengths) > MOST_SOURCES]


def unclear_comments(by_folder):
    """Returns a line for each comment whose first words lack a noun."""
    return [f"{comment}: should begin with the noun that it is about"
            for found in by_folder.values() for comment in found.pronouns]


def violations(top):
    """Returns a line for each violation of a rule below the folder `top`."""
    found = []
    for file in sources(top):
        lines = (top / file).read_text().splitlines()
        if not any(LICENCE in line for line in lines[:2]):
            found.append(f"{file}:1: lacks the line {LICENCE}")
        if len(lines) > MOST_LINES:
            found.append(f"{file}: has {len(lines)} lines; past {MOST_LINES} it should be two files")
        if file.suffix in (".h", ".cpp") and file.parent.parts[:2] != ("tests", "house"):
            found.extend(violations_of_includes(top, file, lines))
            found.extend(violations_of_streams(file, lines))
    for floor in WITHOUT_CIRCLES:
        found.extend(circles(included_by(top, floor, room_of)))
    for folder in FILES_WITHOUT_CIRCLES:
        found.extend(circles(included_by(top, folder, stem_of)))
    by_folder = counts.counts_by_folder(top)
    return (found + types_of_one_name(top) + not_apart(top) + large_folders(by_folder) + unclear_comments(by_folder))


class House(unittest.TestCase):
    maxDiff = None

    def test_this_house_keeps_its_rules(self):
        self.assertGreater(len(list(sources(TOP))), 50)
        self.assertEqual(violations(TOP), [])

    def found_in(self, **files):
        """Returns the violations in a project of these files; __ in a name stands for /."""
        with tempfile.TemporaryDirectory() as folder:
            top = pathlib.Path(folder)
            for name, text in {"core__a": "", "meshops__a": "", "fracture__a": "", "app__a": "", **files}.items():
                file = top / (name.replace("__", "/") + ".h")
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(f"// {LICENCE}\n{text}\n")
            return violations(top)

    def test_every_way_upstairs_or_across_is_found(self):
        allowed = {"core": "core", "meshops": "meshops", "fracture": "core meshops fracture",
                   "app": "core meshops fracture app"}
        for prefix in ("", "tests__"):
            for floor in allowed:
                for other in allowed:
                    found = self.found_in(**{f"{prefix}{floor}__b": f'#include "{other}/a.h"'})
                    self.assertEqual(len(found), 0 if other in allowed[floor].split() else 1, found)

    def test_circles_between_rooms_are_found(self):
        house = {"core__one__a": "", "core__two__a": '#include "core/one/a.h"', "core__three__a": '#include "core/two/a.h"'}
        self.assertEqual(self.found_in(**house), [])
        self.assertEqual(len(self.found_in(**house, core__one__b='#include "core/two/a.h"')), 1)
        self.assertEqual(len(self.found_in(**house, core__one__b='#include "core/three/a.h"')), 3)

    def test_circles_between_files_of_a_scene_are_found(self):
        house = {"app__scene__a": "", "app__scene__b": '#include "app/scene/a.h"'}
        self.assertEqual(self.found_in(**house), [])
        self.assertEqual(len(self.found_in(**{**house, "app__scene__a": '#include "app/scene/b.h"'})), 1)
        self.assertEqual(self.found_in(app__a='#include "app/b.h"', app__b='#include "app/a.h"'), [])

    def test_reading_never_reaches_building(self):
        house = {"app__scene__assemble__a": "", "app__scene__read__a": "", "app__recording__a": ""}
        self.assertEqual(self.found_in(**house), [])
        house["app__scene__read__a"] = '#include "app/scene/assemble/a.h"'
        self.assertEqual(len(self.found_in(**house)), 1)
        house["app__recording__a"] = '#include "app/scene/read/a.h"'
        self.assertEqual(len(self.found_in(**house)), 3)

    def test_libraries_are_kept_on_their_floor(self):
        self.assertEqual(self.found_in(meshops__b="#include <CGAL/Surface_mesh.h>"), [])
        self.assertEqual(len(self.found_in(core__b="#include <CGAL/Surface_mesh.h>")), 1)
        self.assertEqual(len(self.found_in(fracture__b="# include <openvdb/openvdb.h>")), 1)

    def test_includes_are_written_from_the_top_folder(self):
        self.assertEqual(len(self.found_in(core__b='#include "a.h"')), 1)

    def test_prints_that_may_throw_are_found(self):
        self.assertEqual(self.found_in(app__messages__print='std::fputs("", stderr);'), [])
        self.assertEqual(len(self.found_in(app__run='fmt::print(stderr, "");')), 1)
        self.assertEqual(len(self.found_in(app__run='std::cout << "";')), 1)

    def test_types_of_one_name_are_found(self):
        one = "namespace sherd {\nclass A {\n};\n}"
        self.assertEqual(self.found_in(core__b=one, meshops__b="namespace sherd {\nclass A;\n}"), [])
        self.assertEqual(self.found_in(core__b=one, meshops__b="namespace sherd::test {\nstruct A {\n};\n}"), [])
        self.assertEqual(len(self.found_in(core__b=one, meshops__b="namespace sherd {\nstruct A : B {\n};\n}")), 1)

    def test_large_folders_are_found(self):
        house = {f"core__b{number}": "" for number in range(MOST_SOURCES - 1)}
        self.assertEqual(self.found_in(**house), [])
        self.assertEqual(len(self.found_in(**house, core__c="")), 1)

    def test_comments_without_a_noun_are_found(self):
        self.assertEqual(self.found_in(core__b="int a;  // number of cracks\n/// Returns it.\n"), [])
        for comment in ("// of cracks", "///< what is broken", "/// Those of the sheet.", "/** the same for faces */"):
            self.assertEqual(len(self.found_in(core__b=f"int a;  {comment}")), 1, comment)
            self.assertEqual(len(self.found_in(core__b=comment)), 1, f"below the licence: {comment}")

    def test_long_and_unlicensed_files_are_found(self):
        self.assertEqual(len(self.found_in(core__b="\n" * MOST_LINES)), 1)
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "core").mkdir()
            (pathlib.Path(folder) / "core/a.cpp").write_text("int a;\n")
            self.assertEqual(len(violations(pathlib.Path(folder))), 1)


if __name__ == "__main__":
    unittest.main()
