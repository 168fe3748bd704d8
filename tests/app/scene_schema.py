# SPDX-License-Identifier: GPL-3.0-or-later
"""scene_schema.py SHERD SCENES

Compares the JSON Schema of scenes (`sherd scenes --schema`) with the program: all scenes that come with the program
(SCENES) must be valid, and both must refuse scenes with a wrong form. If this failed, an editor of TOML would complete
keys that do not exist, or underline keys and values that are right."""

import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import jsonschema

GOOD = """
duration = 0.1
seed = 3
[sheet.plate]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.02 }
place = { translate = [0, 0, 0.2], rotate = { axis = [1, 0, 0], degrees = 70 } }
velocity = [0, 0, -2]
material = { preset = "stoneware", thickness = 0.004 }
fracture = { strength = 4e7, weibull = 10 }
[sheet.plate.pin]
boundary = true
[obstacle.floor]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
friction = 0.3
[contact]
friction = 0.1
[force]
gravity = [0, 0, -9.81]
load = [{ pressure = 10, ramp = 0.01 }]
wind = { velocity = [1, 0, 0], gust = { amplitude = 1, time = 0.5, length = 1 } }
[[gauge]]
name = "rim"
at = [0.1, 0, 0.2]
record = ["displacement", "stress"]
[solver]
scheme = "bdf2"
step = 1e-4
damping.mass = 0.1
[output]
every = 0.01
fields = ["stress"]
[[variant]]
name = "spun"
sheet.plate.spin = [0, 0, 1]
[[variant]]
name = "lengthened"
[variant.sheet.plate.mesh]
edge_length = 0.03
"""

FLOOR = """[obstacle.floor]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
friction = 0.3
"""

# Scenes that are right.
RIGHT = [GOOD, "obstacle = {}\n" + GOOD.replace(FLOOR, "")]

# Replacements (old, new) that make the form of GOOD wrong.
WRONG = [
    ("duration = 0.1", ""),
    ("duration = 0.1", "duration = 0"),
    ("duration = 0.1", "duration = -1"),
    ("duration = 0.1", 'duration = "1 s"'),
    ("duration = 0.1", "duration = 0.1\nduratio = 1"),
    ("seed = 3", "seed = -1"),
    ("seed = 3", "seed = 1.5"),
    ("seed = 3", "seed = 4294967296"),
    ('generate = "disc"', 'generate = "disk"'),
    ('generate = "disc"', 'generate = "rectangle"'),
    ("radius = 0.1, ", ""),
    ("radius = 0.1", "radius = 0"),
    ("radius = 0.1", "radius = [0.1]"),
    ("edge_length = 0.02", "edge_lenght = 0.02"),
    ("translate = [0, 0, 0.2]", "translate = [0, 0.2]"),
    ("translate = [0, 0, 0.2]", "translate = 0.2"),
    ("axis = [1, 0, 0], ", ""),
    ("velocity = [0, 0, -2]", "velocity = -2"),
    ("velocity = [0, 0, -2]", "velocity = [0, 0, -2, 0]"),
    ("thickness = 0.004", "thickness = -0.004"),
    ("thickness = 0.004", 'thickness = { texture = "a.png", vdb = "a.vdb", range = [1, 2] }'),
    ("thickness = 0.004", "young = [1e9, 2e9, 3e9]"),
    ("thickness = 0.004", 'calibration = "half"'),
    ("thickness = 0.004", "poisson = 0.2, young01 = 1e9"),
    ("weibull = 10", "weibull = 0"),
    ("weibull = 10", "crack_tip = 1.5"),
    ("weibull = 10", "toughness = 1e6, fracture_energy = 10"),
    ("weibull = 10", 'score = { line = [[0, 0, 0]], factor = 0.5 }'),
    ("weibull = 10", 'score = { line = [[0, 0, 0], [1, 0, 0]] }'),
    ("boundary = true", 'boundary = "yes"'),
    ("boundary = true", "box = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]"),
    ("boundary = true", 'boundary = true\nfree = ["w"]'),
    ("boundary = true", "boundary = true\nkeys = [{ translate = [0, 0, 1] }]"),
    ("plane = { point", "plane = { pont"),
    ("plane = {", "sphere = { radius = 1 }\nplane = {"),
    ("friction = 0.3", "friction = -0.3"),
    ("friction = 0.3", "young = 0"),
    ("friction = 0.1", "sheets = 1"),
    ("friction = 0.1", 'start = "ignore"'),
    ("gravity = [0, 0, -9.81]", "gravity = -9.81"),
    ("pressure = 10", "pressure = [10]"),
    ("amplitude = 1, ", ""),
    ('name = "rim"', ""),
    ('name = "rim"', 'name = "the rim"'),
    ('"stress"]\n[solver]', '"strain"]\n[solver]'),
    ('"stress"]\n[solver]', '"displacement"]\n[solver]'),
    ('scheme = "bdf2"', 'scheme = "midpoint"'),
    ('scheme = "bdf2"', 'adaptive = true'),
    ('scheme = "bdf2"', 'max_iterations = 0'),
    ("step = 1e-4", "step = 0"),
    ("damping.mass = 0.1", "damping = 0.1"),
    ('fields = ["stress"]', 'fields = ["strain"]'),
    ('fields = ["stress"]', 'fields = ["stress", "stress"]'),
    ('preset = "stoneware"', 'preset = "stonewear"'),
    ("radius = 0.1, ", "radius = 0.1, structured = true, "),
    ('name = "spun"', ""),
    ('name = "spun"', 'nme = "spun"'),
    ('name = "spun"', 'name = "spun fast"'),
    ('name = "spun"', 'name = "-spun"'),
    ('name = "spun"', 'name = "spun"\nsolver.adaptive = true'),
    ('name = "spun"', 'name = "spun"\nvariant.name = "more"'),
    ("edge_length = 0.03", "edge_lenght = 0.03"),
]


def main(sherd, scenes):
    schema = json.loads(subprocess.run([sherd, "scenes", "--schema"], capture_output=True, check=True).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)

    def faults(text):
        return [error.message for error in validator.iter_errors(tomllib.loads(text))]

    shipped = [file for file in sorted(pathlib.Path(scenes).rglob("*.toml")) if "studies" not in file.parts]
    assert len(shipped) > 20, shipped
    for file in shipped:
        assert not faults(file.read_text(encoding="utf-8")), (file, faults(file.read_text(encoding="utf-8")))
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "scene.toml"

        def check(text):
            file.write_text(text, encoding="utf-8")
            return subprocess.run([sherd, "check", str(file)], capture_output=True, text=True, check=False)

        for text in RIGHT:
            assert not faults(text) and check(text).returncode == 0, (faults(text), check(text).stderr)
        for old, new in WRONG:
            assert old in GOOD, old
            text = GOOD.replace(old, new, 1)
            assert faults(text), f"valid by the schema: {new or 'without ' + old}"
            assert check(text).returncode == 2, f"accepted by the program: {new or 'without ' + old}"
    print(f"{len(shipped)} scenes are valid, {len(WRONG)} are told by both")


main(*sys.argv[1:])
