# SPDX-License-Identifier: GPL-3.0-or-later
"""scene_reference.py SHERD SOURCES REFERENCE

Compares docs/scene.md (REFERENCE) with the program: every key that the reader of scenes (SOURCES: app/scene/read)
knows is in one of its tables, every key in the tables is known to the reader, and defaults that are a plain number,
`true`, `false` or an array are those that the program reports when the key has a wrong type. Fails if a key is added to
the reference or the program only."""

import collections
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

# Places in a scene of the keys in the reference's tables, by the heading (or first column) of the table.
PLACES = {
    "The scene": "",
    "`[sheet.NAME]`: what bends and breaks": "sheet.NAME",
    "A pin or a clamp has one of": "sheet.NAME.pin",
    "A pin may leave directions free:": "sheet.NAME.pin",
    "A pin or a clamp may move, the sheet following:": "sheet.NAME.pin",
    "`fracture`: what a sheet withstands": "sheet.NAME.fracture",
    "`map`": "sheet.NAME.fracture.map",
    "`score`": "sheet.NAME.fracture.score",
    "`mesh` from a file": "sheet.NAME.mesh",
    "`mesh` that is generated": "sheet.NAME.mesh",
    "shape": "sheet.NAME.mesh",
    "`material`": "sheet.NAME.material",
    "`thickness`": "sheet.NAME.material.thickness",
    "`axis`": "sheet.NAME.material.axis",
    "`[obstacle.NAME]`: what sheets cannot pass through": "obstacle.NAME",
    "`keys`": "obstacle.NAME.keys",
    "`cache`": "obstacle.NAME.cache",
    "`[contact]`: of sheets and fragments with each other and with themselves": "contact",
    "`[[force.load]]`: what pushes and pulls": "force.load",
    "`[[gauge]]`: what is measured, where": "gauge",
    "`[force.wind]`: the air": "force.wind",
    "`[solver]`": "solver",
    "Statics: load instead of time": "solver",
    "`[[variant]]`: several scenes in one file": "variant",
}
# Places whose keys the reference describes by "as for ..." another place.
SAME = {
    "sheet.NAME.clamp": "sheet.NAME.pin",
    "sheet.NAME.pin.keys": "obstacle.NAME.keys",
    "obstacle.NAME.place": "sheet.NAME.place",
}
NAMES = ("preset", "scene")  # first columns of tables that list names, not keys

SHAPES = ("rectangle", "disc", "cylinder", "sphere", "plate", "bowl", "revolution", "polygon")
MESHES = [f'{{ generate = "{shape}", KEYS }}' for shape in SHAPES] + [
    '{ file = "a.obj", KEYS }', '{ file = "a.obj", remesh = { KEYS } }', '{ given = "a", KEYS }']
AXES = ["{ direction = [0, 0, 1], KEYS }", '{ texture = "a.png", encoding = "hue", KEYS }', "{ field = true, KEYS }"]
MAPS = ['{ texture = "a.png", KEYS }', '{ vdb = "a.vdb", KEYS }', '{ property = "t", KEYS }']
SCORES = ['{ edges = "a", KEYS }', "{ line = [[0, 0, 0], [1, 0, 0]], KEYS }"]
SOLIDS = ["plane", "sphere", "box", "cylinder", "mesh", "vdb"]


def scene():
    """Returns a scene with all kinds of tables; KEYS: places for keys that make the program report problems."""
    keys = "{ time = 0, rotate = { KEYS }, KEYS }"
    pin = f"{{ boundary = true, keys = [{keys}], KEYS }}"
    lines = ["KEYS", "output = { KEYS }", "contact = { KEYS }", "solver = { damping = { KEYS }, KEYS }", "gauge = [{ KEYS }]", "[force]", "KEYS",
             "load = [{ point = [0, 0, 1], boundary = true, KEYS }]", "wind = [{ gust = { KEYS }, KEYS }]"]
    for i, mesh in enumerate(MESHES):
        score, chart, axis = SCORES[i % len(SCORES)], MAPS[i % len(MAPS)], AXES[i % len(AXES)]
        lines += [f"[sheet.s{i}]", "KEYS", f"mesh = {mesh}", "bend = { KEYS }", "place = { rotate = { KEYS }, KEYS }",
                  f"material = {{ axis = {axis}, thickness = {chart}, KEYS }}", f"fracture = {{ map = {chart}, score = {score}, KEYS }}",
                  f"pin = {pin}", f"clamp = {pin}", "symmetry = { KEYS }"]
    for i, solid in enumerate(SOLIDS):
        lines += [f"[obstacle.o{i}]", "KEYS", f"{solid} = {{ KEYS }}", "place = { rotate = { KEYS }, KEYS }"]
        lines += ["cache = { KEYS }"] if solid == "mesh" else []
        lines += ["mass = 1"] if solid in ("sphere", "box") else [f"keys = [{keys}]"]
    return "\n".join(lines)


def told(sherd, keys):
    """Yields (place, message) of the problems that the program reports when the line `keys` is in all tables."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "scene.toml"
        given = re.escape(keys.split(" ")[0])
        text = re.sub(rf"^{given} = .*$", "", scene(), flags=re.MULTILINE)  # a key may be given once only
        file.write_text(text.replace("KEYS", keys), encoding="utf-8")
        output = subprocess.run([sherd, "check", str(file)], capture_output=True, text=True, check=False).stderr
    for line in output.splitlines():
        if match := re.match(r".*scene\.toml:\d+: ([\w.\[\]]*): (.*)", line):
            place = re.sub(r"\[\d+\]", "", match[1])
            yield re.sub(r"^(sheet|obstacle)\.[so]\d+\b", r"\1.NAME", place), match[2]


def known_keys(sherd):
    keys = {"variant.name"}  # read before all others
    for place, what in told(sherd, "zzz = 0"):
        if match := re.match(r"unknown key; .*known here: (.*)", what):
            keys |= {place.removesuffix("zzz") + key for key in match[1].split(", ")}
    return keys


def defaults(sherd, names):
    """Returns the default values that the program reports: {place: TOML}."""
    found = collections.defaultdict(set)
    for name in sorted(names):
        for place, what in told(sherd, f'{name} = "zzz"'):
            if match := re.search(r'not the string "zzz"; left out, it is (.*)', what):
                found[place].add(match[1])
    return found


def asked_names(sources):
    """Returns the names of all keys that the source reads from tables."""
    names = set()
    for file in sorted(sources.glob("*.cpp")):
        text = file.read_text(encoding="utf-8")
        names |= set(re.findall(r"(?:\.|->)(?:number|integer|flag|string|choice|vector|pair|rows|tables?|has)\(\s*\"(\w+)\"", text))
        names |= set(re.findall(r"\b(?:read_direction|length_of|read_value)\(\*?\w+, \"(\w+)\"", text))
    return names


def inline_keys(place, cell):
    """Yields the keys of inline tables in a cell, `{ radius = r, centre = [0, 0, 0] }`."""
    for code in re.findall(r"`(?:\w+ = )?(\{.*?\})(?:`| \(| or)", cell):
        plain = re.sub(r"\.\.\.|(?<=[=\[,] )[a-z]\b|(?<=\[)[a-z]\b", "0", code)
        yield from written_keys(place, tomllib.loads(f"x = {plain}")["x"])


def written_keys(place, table):
    for key, value in table.items():
        yield f"{place}.{key}"
        if isinstance(value, dict):
            yield from written_keys(f"{place}.{key}", value)


def rows(text):
    """Yields (place, cells, names of columns) of each row of the tables of keys."""
    heading, columns, previous = "", None, ""
    for line in text.splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] if line.startswith("|") else None
        if line.startswith("#"):
            heading = line.lstrip("# ")
        if cells is None:
            columns = None
            previous = line or previous
        elif columns is None:
            columns = cells
        elif not set(cells[0]) <= set("- ") and columns[0] not in NAMES:
            name = next((name for name in (previous, columns[0], heading) if name in PLACES), None)
            assert name is not None, f"a table of unknown place: under '{heading}', after '{previous}': {columns}"
            yield PLACES[name], cells, columns


def documented(text):
    """Returns the keys of the reference's tables, and their defaults as written."""
    keys, values = set(), {}
    for place, cells, columns in rows(text):
        prefix = place + "." if place else ""
        if columns[0] == "shape":
            keys |= {prefix + key for key in re.findall(r"`(\w+)`", cells[1]) if key not in ("r", "z")}
            continue
        inline = set(inline_keys(place, cells[0]))
        names = [] if inline else re.findall(r"`([\w.]+)(?: = [^`]*)?`", cells[0])
        assert names or inline, f"a row without a key: {cells}"
        keys |= inline | {prefix + name for name in names}
        for name in names:
            keys |= set(inline_keys(prefix + name, cells[-1]))
            if "default" in columns:
                values[prefix + name] = cells[columns.index("default")]
    return keys, values


def with_tables(keys):
    """Returns the keys and all tables that contain them; places in SAME are replaced by those that describe them."""
    result = set()
    for key in keys:
        for other, place in SAME.items():
            if key.startswith(other + "."):
                key = place + key.removeprefix(other)
        parts = key.split(".")
        result |= {".".join(parts[:n]) for n in range(1, len(parts) + 1)}
    return {key for key in result if not key.endswith("NAME")}


def value_of(text):
    value = tomllib.loads(f"x = {text}")["x"]
    return tuple(map(float, value)) if isinstance(value, list) else value if isinstance(value, bool) else float(value)


def check_defaults(sherd, values):
    plain = {}
    for key, text in values.items():
        match = re.match(r"`?(true|false|\[[^\]`]*\]|-?\d[\d.e-]*)`?(?: .*)?$", text)
        if match:
            plain[key] = match[1]
    assert len(plain) > 25, plain
    found = defaults(sherd, {key.split(".")[-1] for key in plain})
    wrong = [f"{key}: the reference says {text}, the program {found.get(key) or 'nothing'}"
             for key, text in sorted(plain.items()) if {value_of(told) for told in found[key]} != {value_of(text)}]
    assert not wrong, "\n".join(wrong)
    return len(plain)


def main(sherd, sources, reference):
    written, values = documented(pathlib.Path(reference).read_text(encoding="utf-8"))
    known, written = with_tables(known_keys(sherd)), with_tables(written)
    assert not known - written, f"not in {reference}: {sorted(known - written)}"
    assert not written - known, f"in {reference}, but unknown to the program: {sorted(written - known)}"
    missed = asked_names(pathlib.Path(sources)) - {key.split(".")[-1] for key in known}
    assert not missed, f"asked for in {sources}, but by no table of this test's scene: {sorted(missed)}"
    print(f"{len(known)} keys and {check_defaults(sherd, values)} defaults agree")


main(*sys.argv[1:])
