# SPDX-License-Identifier: GPL-3.0-or-later
"""scene_reference.py SHERD PAGE

Compares the reference of the keys of scenes (`sherd scenes --keys`) with the reader of scenes: both must have the same
keys, and defaults that are a plain number, `true`, `false` or an array must be those that the reader reports when the
key has a wrong type. Each table of the reference must be shown by one command in PAGE, docs/scene.md."""

import collections
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

REFUSED = {"sheet.NAME.clamp.free"}  # keys that are read to say where they belong

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
    lines = ["KEYS", "variant = [{ KEYS }]", "output = { KEYS }", "contact = { KEYS }", "solver = { damping = { KEYS }, KEYS }", "gauge = [{ KEYS }]", "[force]", "KEYS",
             "load = [{ point = [0, 0, 1], boundary = true, KEYS }]", "wind = [{ gust = { KEYS }, KEYS }]"]
    for i, mesh in enumerate(MESHES):
        score, chart, axis = SCORES[i % len(SCORES)], MAPS[i % len(MAPS)], AXES[i % len(AXES)]
        lines += [f"[sheet.s{i}]", "KEYS", f"mesh = {mesh}", "bend = { KEYS }", "place = { rotate = { KEYS }, KEYS }",
                  f"material = {{ axis = {axis}, thickness = {chart}, KEYS }}",
                  f"fracture = {{ map = {chart}, score = {score}, crack = {score}, KEYS }}",
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
    keys = set()
    for place, what in told(sherd, "zzz = 0"):
        if match := re.match(r"unknown key; .*known here: (.*)", what):
            keys |= {place.removesuffix("zzz") + key for key in match[1].split(", ")}
    return keys - {f"variant.{key}" for key in keys if "." not in key}  # a variant may have all keys of the scene


def defaults(sherd, names):
    """Returns the default values that the program reports: {place: TOML}."""
    found = collections.defaultdict(set)
    for name in sorted(names):
        for place, what in told(sherd, f'{name} = "zzz"'):
            if match := re.search(r'not the string "zzz"; left out, it is (.*)', what):
                found[place].add(match[1])
    return found


def tables(sherd, *table):
    """Returns the tables of Markdown that the program prints."""
    command = [sherd, "scenes", "--keys", *table, "--markdown"]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return [f"{one.strip()}\n" for one in re.split(r"\n\n(?=[^|])", text)]


def documented(texts):
    """Returns the default of each key of the tables, as written."""
    values = {}
    for text in texts:
        heading, *rows = [line for line in text.splitlines() if line]
        match = re.match(r"`\[(.*?)\]`", heading)
        prefix = f"{match[1]}." if match else ""
        for row in rows[2:]:
            name, value, default, meaning = [cell.strip() for cell in re.split(r"(?<!\\)\|", row)[1:-1]]
            assert value and meaning, f"a key without a value or a meaning: {prefix}{row}"
            values[prefix + name.strip("`")] = default
    return values


def value_of(text):
    value = tomllib.loads(f"x = {text}")["x"]
    return tuple(map(float, value)) if isinstance(value, list) else value if isinstance(value, bool) else float(value)


def check_defaults(sherd, values):
    plain = {}
    for key, text in values.items():
        match = re.match(r"`?(true|false|\[[-+\d.,e ]*\]|-?\d[\d.e-]*)`?(?: .*)?$", text)
        if match:
            plain[key] = match[1]
    found = defaults(sherd, {key.split(".")[-1] for key in plain})
    compared = [key for key in sorted(plain) if found[key]]
    wrong = [f"{key}: the reference says {plain[key]}, the program {found[key]}"
             for key in compared if {value_of(told) for told in found[key]} != {value_of(plain[key])}]
    assert not wrong, "\n".join(wrong)
    assert len(compared) > 50, compared
    return len(compared)


def check_page(sherd, page, reference):
    """Compares the commands of a page with the reference. Tables that differ only in their place must be shown once."""
    shown = [table for place in re.findall(r"^```scene-keys\nsherd scenes --keys (\S+)\n```$", page, re.MULTILINE)
             for table in tables(sherd, place)]
    twice = [table for table, count in collections.Counter(shown).items() if count > 1]
    assert not twice, f"shown by two commands: {twice}"
    rows = {table.split("\n", 1)[1] for table in shown}
    missing = [table for table in reference if table.split("\n", 1)[1] not in rows]
    assert not missing, "shown by no command:\n" + "\n".join(missing)


def main(sherd, page):
    reference = tables(sherd)
    values = documented(reference)
    known, written = known_keys(sherd) - REFUSED, set(values)
    assert not known - written, f"not in the reference: {sorted(known - written)}"
    assert not written - known, f"in the reference, but unknown to the reader: {sorted(written - known)}"
    check_page(sherd, pathlib.Path(page).read_text(encoding="utf-8"), reference)
    print(f"{len(known)} keys and {check_defaults(sherd, values)} defaults agree")


main(*sys.argv[1:])
