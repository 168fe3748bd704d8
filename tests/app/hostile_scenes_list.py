# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenes of hostile_scenes.py: `SCENES`, each with its description and the required result."""
import dataclasses
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import rough_meshes  # noqa: E402

ALL = ("implicit", "explicit", "auto")


@dataclasses.dataclass
class Refusal:
    """Required exit code and parts of the message of a scene that does not run to its end. A scene that fails in a step
    (code 1) may also run to its end, because whether a step fails depends on rounding."""
    code: int
    words: tuple


OVERWHELMED = Refusal(1, ("the springs of explicit contact are too weak",))
UNSTABLE = Refusal(1, ("explicit",))
UNSOLVED = Refusal(1, ("cannot be solved",))
NEITHER = Refusal(1, ("explicit", "and implicit steps from there cannot be solved, either"))


@dataclasses.dataclass
class Scene:
    name: str
    what: str
    text: str
    files: dict = dataclasses.field(default_factory=dict)
    schemes: tuple = ("implicit",)
    errors: dict = dataclasses.field(default_factory=dict)  # Refusal by scheme; "": all schemes
    within: float = 10  # m, largest coordinate of vertices
    # Largest energy residual over the largest energy. Larger where steps are long or sheets light: forces that are left
    # within the solver's tolerance do work along a step.
    unexplained: float = 1e-6
    gained: float = 0  # largest energy gained by a scheme, over the largest energy
    fragments: tuple = ()  # least and largest number at the end
    holds: object = None  # function of (file, frames): returns a description of what is wrong, or None
    long: bool = False

    def error(self, scheme):
        return self.errors.get(scheme, self.errors.get(""))


SCENES = []


def add(name, what, text, refused=(), fails=None, explicit=None, auto=None, **more):
    """Adds a scene. refused: parts of the message that refuses it before the first step; fails: Refusal in a step, with
    all schemes; explicit, auto: Refusal with that scheme."""
    if refused:
        more["errors"] = {"": Refusal(2, tuple(refused))}
    if fails:
        more["errors"] = {"": fails}
    for scheme, end in (("explicit", explicit), ("auto", auto)):
        if end:
            more["errors"] = more.get("errors", {}) | {scheme: end}
    SCENES.append(Scene(name, what, text, **more))


def obj(vertices, faces):
    return ("".join(f"v {x:.17g} {y:.17g} {z:.17g}\n" for x, y, z in vertices)
            + "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces))


def sheet(mesh='{ generate = "disc", radius = 0.1, edge_length = 0.03 }', material='preset = "stoneware"', at=(0, 0, 0.004),
          velocity=(0, 0, -3), fracture="strain = 0.3", name="plate", more=""):
    broken = f"fracture = {{ {fracture} }}\n" if fracture else ""
    return (f"[sheet.{name}]\nmesh = {mesh}\nmaterial = {{ {material} }}\nplace = {{ translate = {list(at)} }}\n"
            f"velocity = {list(velocity)}\n{broken}{more}\n")


FLOOR = "[obstacle.floor]\nplane = {}\n"


def scene(*parts, duration=2e-3, solver="", head=""):
    # Steps have their default lengths: 1e-4 s, and 2e-6 s for explicit ones.
    return f"duration = {duration}\n{head}\n" + "".join(parts) + (f"[solver]\n{solver}\n" if solver else "")


def steel(**more):
    return ", ".join(f"{key} = {value}" for key, value in
                     ({"density": 7850, "thickness": 0.002, "young": 2e11} | more).items())


def still(limit):
    """Returns a check that all velocities at the end are at most `limit` (m/s)."""
    def check(_, frames):
        fastest = abs(frames[-1]["vertex/velocity"][:]).max()
        return None if fastest <= limit else f"still moves with {fastest:.3g} m/s at the end"
    return check


def grid(columns, rows, width, height, at=(0, 0, 0)):
    vertices, quads = rough_meshes.plate(width, height, columns, rows, at)
    return vertices, [(a, b, c) for a, b, c, d in quads] + [(a, c, d) for a, b, c, d in quads]


def ply(vertices, faces, strength):
    """Returns a .ply file whose vertices all have this strength."""
    return ("ply\nformat ascii 1.0\n" + f"element vertex {len(vertices)}\n"
            + "".join(f"property float {name}\n" for name in ("x", "y", "z", "strength"))
            + f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
            + "".join(f"{x:.9g} {y:.9g} {z:.9g} {strength}\n" for x, y, z in vertices)
            + "".join(f"{len(face)} {' '.join(map(str, face))}\n" for face in faces))


TRIANGLE = obj([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
TWO = obj([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)], [(0, 1, 2), (1, 3, 2)])
FILE = '{ file = "mesh.obj" }'
THICK = 'preset = "stoneware", thickness = 0.01'

# Steps, stiffness and size.
add("step_of_1_s", "a plate falls onto a floor and would break, in steps of 1 s",
    scene(sheet(), FLOOR, duration=3, solver="step = 1"), within=100, unexplained=1e-2)
add("step_of_1_s_auto", "the same, which becomes a million explicit steps", scene(sheet(), FLOOR, duration=3, solver="step = 1"),
    schemes=("auto",), within=100, long=True)
add("step_of_1_s_fast", "the same at 100 m/s", scene(sheet(velocity=(0, 0, -100)), FLOOR, duration=3, solver="step = 1"),
    within=1000, unexplained=1e-4)
add("young_1e-6", "Young's modulus of 1e-6 Pa", scene(sheet(material=steel(young=1e-6), fracture=""), FLOOR), schemes=ALL)
add("young_1e15", "Young's modulus of 1e15 Pa", scene(sheet(material=steel(young=1e15)), FLOOR), schemes=("implicit", "auto"))
add("young_1e15_explicit", "the same for 20 µs", scene(sheet(material=steel(young=1e15)), FLOOR, duration=2e-5),
    schemes=("explicit",))
add("thickness_1e-9", "a foil of 1 nm", scene(sheet(material=steel(thickness=1e-9), at=(0, 0, 1e-3), fracture=""), FLOOR),
    schemes=("explicit", "implicit", "auto"), unexplained=100, explicit=UNSTABLE)
add("thickness_of_1_m", "a plate five times as thick as wide", scene(sheet(material=steel(thickness=1), at=(0, 0, 0.51)), FLOOR),
    schemes=ALL)
add("density_of_2.4", "density in g/cm³: stoneware as light as air", scene(sheet(material=steel(density=2.4)), FLOOR), schemes=ALL, unexplained=0.2)
add("density_1e-9", "a sheet that weighs nothing", scene(sheet(material=steel(density=1e-9)), FLOOR), schemes=("implicit",), unexplained=100, fails=UNSOLVED)
add("density_1e12", "a sheet of a neutron star's stuff", scene(sheet(material=steel(density=1e12)), FLOOR), schemes=ALL)
add("young_of_70", "Young's modulus in GPa: 70 Pa", scene(sheet(material=steel(young=70)), FLOOR), schemes=ALL)
add("millimetres", "a mesh in millimetres, as metres", scene(sheet(FILE, at=(0, 0, 1)), FLOOR),
    files={"mesh.obj": obj(*grid(8, 8, 200, 200))}, schemes=ALL,
    within=300)
add("mesh_of_1_um", "a mesh of 1 µm", scene(sheet(FILE, steel(thickness=1e-8), at=(0, 0, 1e-7)), FLOOR),
    files={"mesh.obj": obj(*grid(4, 4, 1e-6, 1e-6))})
add("mesh_of_1000_km", "a mesh of 1,000 km", scene(sheet(FILE, steel(thickness=1e4), at=(0, 0, 6e3)), FLOOR),
    files={"mesh.obj": obj(*grid(4, 4, 1e6, 1e6))}, schemes=ALL, within=2e6)
add("far_away", "a plate 100,000 km from the origin", scene(sheet(at=(1e8, 0, 0.004)), FLOOR), within=1.1e8, schemes=ALL)

# Meshes.
add("needles", "triangles of 1 : 2,000", scene(sheet(FILE, steel(thickness=1e-4)), FLOOR),
    files={"mesh.obj": obj(*grid(400, 2, 0.1, 0.1 * 5))}, schemes=("implicit",))
add("needle", "one triangle with an angle of 1e-9", scene(sheet(FILE, steel(thickness=1e-4)), FLOOR),
    files={"mesh.obj": obj([(0, 0, 0), (1, 0, 0), (0.5, 1e-9, 0)], [(0, 1, 2)])}, schemes=ALL, fails=UNSOLVED, explicit=UNSTABLE, auto=NEITHER, unexplained=1e-3)
for name, mesh in (("one_triangle", TRIANGLE), ("two_triangles", TWO)):
    what = name.replace("_", " ")
    add(f"{name}_in_the_air", f"{what} of 1 m, 1 cm thick, at rest in the air",
        scene(sheet(FILE, THICK, at=(0, 0, 1), velocity=(0, 0, 0)), duration=0.01), files={"mesh.obj": mesh}, schemes=ALL)
    add(f"{name}_at_rest", f"{what} at rest without gravity",
        scene(sheet(FILE, THICK, velocity=(0, 0, 0)), head="force.gravity = [0, 0, 0]"), files={"mesh.obj": mesh}, schemes=ALL,
        holds=still(1e-9))
    add(f"{name}_falls", f"{what} on a floor", scene(sheet(FILE, THICK), FLOOR, duration=0.01), files={"mesh.obj": mesh},
        schemes=ALL)
    add(f"{name}_of_1_mm", f"{what} of 1 m, 1 mm thick, thrown onto a floor",
        scene(sheet(FILE, 'preset = "stoneware", thickness = 0.001', velocity=(0, 0, -30)), FLOOR, duration=0.01),
        files={"mesh.obj": mesh}, schemes=ALL)
add("folded", "a rest shape folded flat onto itself",
    scene(sheet(FILE, steel(), fracture="strain = 0.5"), FLOOR),
    files={"mesh.obj": obj(*rough_meshes.grid(10, 4, lambda u, v: (0.1 * abs(2 * u - 1), 0.1 * v, 0)))}, schemes=ALL)
add("isolated_triangle", "a triangle 10 km from the plate that it belongs to", scene(sheet(FILE), FLOOR),
    files={"mesh.obj": obj(*rough_meshes.together(grid(4, 4, 0.1, 0.1), ([(1e4, 0, 0), (1e4 + 0.05, 0, 0), (1e4, 0.05, 0)],
                                                                           [(0, 1, 2)])))}, schemes=ALL, within=1.1e4)
add("coincident_vertices", "two plates that are not joined where they meet", scene(sheet(FILE), FLOOR),
    files={"mesh.obj": obj(*rough_meshes.together(grid(4, 4, 0.1, 0.1), grid(4, 4, 0.1, 0.1, (0.1, 0, 0))))}, schemes=ALL)
add("empty_mesh", "a mesh file without a face", scene(sheet(FILE), FLOOR), refused=["mesh.obj"], files={"mesh.obj": "v 0 0 0\n"})
add("empty_file", "an empty mesh file", scene(sheet(FILE), FLOOR), refused=["mesh.obj"], files={"mesh.obj": ""})
add("mesh_with_nan", "a vertex that is not a number", scene(sheet(FILE), FLOOR), refused=["mesh.obj", "NaN"],
    files={"mesh.obj": TRIANGLE.replace("v 1 0 0", "v nan 0 0")})
add("mesh_with_1e300", "a vertex at 1e300 m", scene(sheet(FILE), FLOOR), refused=["mesh.obj"],
    files={"mesh.obj": TRIANGLE.replace("v 1 0 0", "v 1e300 0 0")})
add("mesh_of_1e150", "a triangle of 1e150 m", scene(sheet(FILE), FLOOR), refused=["1e+150 m large", "scale"],
    files={"mesh.obj": TRIANGLE.replace(" 1", " 1e150").replace("f 1e150", "f 1")})
add("mesh_of_1e-150", "a triangle of 1e-150 m", scene(sheet(FILE), FLOOR), refused=["mesh.obj"],
    files={"mesh.obj": TRIANGLE.replace(" 1", " 1e-150").replace("f 1e-150", "f 1")})
add("edges_of_1_nm", "a generated plate with edges of 1 nm",
    scene(sheet('{ generate = "disc", radius = 0.1, edge_length = 1e-9 }'), FLOOR), refused=["edge_length"])
add("edges_of_1_m", "a generated plate of 0.2 m with edges of 1 m",
    scene(sheet('{ generate = "disc", radius = 0.1, edge_length = 1 }'), FLOOR), refused=["edge_length"])
add("remesh_to_1_nm", "remeshed to 1 nm", scene(sheet('{ file = "mesh.obj", remesh = 1e-9 }'), FLOOR), refused=["remesh"],
    files={"mesh.obj": obj(*grid(4, 4, 0.1, 0.1))})
add("remesh_to_1_km", "remeshed to 1 km", scene(sheet('{ file = "mesh.obj", remesh = 1e3 }'), FLOOR),
    files={"mesh.obj": obj(*grid(4, 4, 0.1, 0.1))})
add("scale_1e-30", "a mesh times 1e-30", scene(sheet('{ file = "mesh.obj", scale = 1e-30 }'), FLOOR), refused=["scale"],
    files={"mesh.obj": obj(*grid(4, 4, 0.1, 0.1))})

# Thresholds.
add("strain_of_0", "a threshold of zero", scene(sheet(fracture="strain = 0"), FLOOR), refused=["fracture.strain", "positive"])
add("strain_of_1e-12", "a threshold of next to nothing: single triangles",
    scene(sheet(fracture="strain = 1e-12", at=(0, 0, 0.002)), FLOOR), schemes=ALL, fragments=(20, 83))
add("strength_times_0", "a strength times zero: single triangles",
    scene(sheet('"mesh.ply"', fracture='strength = 1e7, map = { property = "strength" }', at=(0, 0, 0.002)), FLOOR),
    files={"mesh.ply": ply(*grid(4, 4, 0.1, 0.1), 0)}, fragments=(32, 32), schemes=ALL)
for word, name in (("0", "0"), ("inf", "infinity"), ("nan", "nan"), ("-1e7", "minus")):
    add(f"strength_of_{name}", f"a strength of {word}", scene(sheet(fracture=f"strength = {word}"), FLOOR),
        refused=["fracture.strength", "positive"])
add("toughness_of_0", "a toughness of zero", scene(sheet(fracture="strength = 1e7, toughness = 0"), FLOOR),
    refused=["fracture.toughness"])
add("toughness_of_1e-3", "a toughness of 1e-3", scene(sheet(fracture="strength = 1e7, toughness = 1e-3"), FLOOR, duration=5e-4),
    schemes=ALL)
add("toughness_of_1e12", "a toughness of 1e12", scene(sheet(fracture="strength = 1e6, toughness = 1e12"), FLOOR, duration=5e-4),
    schemes=ALL)
add("weibull_of_0.1", "a Weibull modulus of 0.1", scene(sheet(fracture="strength = 1e7, weibull = 0.1"), FLOOR), schemes=ALL)
add("weibull_of_1e-3", "a Weibull modulus of 1e-3", scene(sheet(fracture="strength = 1e7, weibull = 1e-3"), FLOOR))
add("weibull_of_1e6", "a Weibull modulus of 1e6", scene(sheet(fracture="strength = 1e7, weibull = 1e6"), FLOOR))
add("speed_limit_1e-9", "cracks that may not run", scene(sheet(fracture="strength = 1e7, toughness = 1e6, speed_limit = 1e-9"), FLOOR),
    schemes=ALL)
add("speed_limit_1e9", "cracks faster than light", scene(sheet(fracture="strength = 1e7, toughness = 1e6, speed_limit = 1e9"), FLOOR,
                                                   duration=3e-4), schemes=ALL)
add("tempered", "a tempered plate", scene(sheet(material='preset = "glass", tempered = 1e8', fracture="preset = true"), FLOOR),
    schemes=ALL)
add("tempered_1e12", "a plate tempered by 1e12 Pa",
    scene(sheet(material='preset = "glass", tempered = 1e12', fracture="preset = true"), FLOOR, duration=5e-4), schemes=ALL)
add("poisson_-0.99", "a Poisson ratio of -0.99", scene(sheet(material=steel(poisson=-0.99)), FLOOR), schemes=ALL)
add("poisson_0.499", "a Poisson ratio of 0.499", scene(sheet(material=steel(poisson=0.499)), FLOOR), schemes=ALL)
add("orthotropic", "a thousand million times as stiff along as across", scene(sheet(material=steel(young="[2e11, 2e2]")), FLOOR),
    schemes=ALL)

# Motion and forces.
add("no_gravity", "a plate at rest without gravity", scene(sheet(velocity=(0, 0, 0)), FLOOR, head="force.gravity = [0, 0, 0]"),
    schemes=ALL, holds=still(1e-9))
add("gravity_up", "gravity upwards", scene(sheet(velocity=(0, 0, 0)), FLOOR, head="force.gravity = [0, 0, 9.81]"), schemes=ALL)
add("gravity_1e9", "gravity of a neutron star", scene(sheet(velocity=(0, 0, 0)), FLOOR, head="force.gravity = [0, 0, -1e9]"),
    schemes=ALL, within=1e5)
add("gravity_1e300", "gravity of 1e300 m/s²", scene(sheet(velocity=(0, 0, 0)), FLOOR, head="force.gravity = [0, 0, -1e300]"),
    refused=["gravity"])
add("minus_zero", "every zero with a minus", scene(sheet(at=(-0.0, -0.0, 0.004), velocity=(-0.0, -0.0, -0.0)), FLOOR,
                                                   head="force.gravity = [-0.0, -0.0, -9.81]"), schemes=ALL)
add("speed_of_1_km_s", "a plate at 1 km/s onto a floor", scene(sheet(velocity=(0, 0, -1e3)), FLOOR), schemes=ALL)
add("speed_of_1000_km_s", "a plate at 1,000 km/s onto a floor", scene(sheet(velocity=(0, 0, -1e6)), FLOOR), schemes=ALL,
    within=1e4, explicit=OVERWHELMED, auto=NEITHER)
add("plates_at_1_km_s", "two plates that meet at 1 km/s",
    scene(sheet(), sheet(name="other", at=(0.01, 0, -0.02), velocity=(0, 0, 1e3))), schemes=ALL)
add("spin_of_1e6", "a plate that spins 160,000 times a second", scene(sheet(more="spin = [0, 0, 1e6]"), FLOOR), schemes=ALL,
    within=1e4, explicit=OVERWHELMED, auto=NEITHER)
add("wind_of_1e5", "wind of 100 km/s", scene(sheet(velocity=(0, 0, 0)), head="force.wind = { velocity = [0, 0, 1e5] }"),
    schemes=ALL, within=1e3)
add("pressure_1e15", "a pressure of 1e15 Pa on the floor",
    scene(sheet(), FLOOR, "[[force.load]]\npressure = -1e15\n"), schemes=ALL, within=1e12, fails=UNSOLVED, explicit=UNSTABLE, auto=NEITHER)
add("point_1e12", "1e12 N on the middle of a pinned plate",
    scene(sheet(more="pin = { boundary = true }"), "[[force.load]]\npoint = [0, 0, -1e12]\n"
          "box = [[-0.02, -0.02, -1], [0.02, 0.02, 1]]\n"), schemes=("explicit",), within=1e12, explicit=UNSTABLE)
add("moment_1e9", "a moment of 1e9 N on the rim", scene(sheet(velocity=(0, 0, 0)), "[[force.load]]\nmoment = 1e9\nboundary = true\n"),
    schemes=ALL, within=1e9, fails=UNSOLVED, explicit=UNSTABLE, auto=NEITHER)
add("mass_damping_1e9", "a mass damping of 1e9 1/s", scene(sheet(), FLOOR, solver="damping.mass = 1e9"), schemes=ALL, explicit=UNSTABLE,
    unexplained=1e-9)
add("stiffness_damping_1e9", "a stiffness damping of 1e9 s", scene(sheet(), FLOOR, solver="damping.stiffness = 1e9"),
    schemes=("implicit",), unexplained=1e6)
add("long_steps", "11 days in 10 steps of free fall onto a floor",
    scene(sheet(fracture=""), FLOOR, duration=1e6, solver="step = 1e5"), within=1e3, fails=UNSOLVED)
add("long_fall", "11 days in 10 steps without a floor", scene(sheet(), duration=1e6, solver="step = 1e5"), within=1e13, fails=UNSOLVED)
add("seed_of_0", "the smallest seed", scene(sheet(fracture="strength = 3e7, weibull = 5"), FLOOR, head="seed = 0"))
add("seed_of_2^32-1", "the largest seed", scene(sheet(fracture="strength = 3e7, weibull = 5"), FLOOR, head="seed = 4294967295"))
add("seed_of_2^32", "a seed too many", scene(sheet(), FLOOR, head="seed = 4294967296"), refused=["seed", "4294967295"])
add("tolerance_1e-15", "a tolerance below all round-off", scene(sheet(), FLOOR, solver="tolerance = 1e-15"))
add("tolerance_1e3", "a tolerance of a thousand edges", scene(sheet(), FLOOR, solver="tolerance = 1e3"), unexplained=1e-2)
add("one_iteration", "one iteration a step", scene(sheet(), FLOOR, solver="max_iterations = 1"))
add("one_stage", "one stage of breaking a step", scene(sheet(velocity=(0, 0, -30)), FLOOR, solver="max_stages = 1"))

# Supports.
add("pinned_everywhere", "every vertex is pinned", scene(sheet(more="pin = { box = [[-1, -1, -1], [1, 1, 1]] }"), FLOOR),
    schemes=ALL, holds=still(0))
add("clamped_everywhere", "every vertex is clamped", scene(sheet(more="clamp = { box = [[-1, -1, -1], [1, 1, 1]] }"), FLOOR),
    schemes=ALL, holds=still(0))
add("pin_of_nothing", "a pin beside the sheet", scene(sheet(more="pin = { box = [[8, 8, 8], [9, 9, 9]] }"), FLOOR),
    refused=["pin"])
SIDES = ("[[-1, -1, -1], [-0.07, 1, 1]]", "[[0.07, -1, -1], [1, 1, 1]]")


def pulled(kind, keys, fracture="strain = 0.3"):
    return sheet(velocity=(0, 0, 0), fracture=fracture,
                 more=f"{kind} = [{{ box = {SIDES[0]} }}, {{ box = {SIDES[1]}, keys = {keys} }}]")


PULL = "[{ time = 0 }, { time = 0.002, translate = [2, 0, 0] }]"
add("clamps_pull_apart", "clamps that pull a plate of 0.2 m to 2 m", scene(pulled("clamp", PULL)), schemes=ALL)
add("clamps_pull_glue", "the same, of what never breaks", scene(pulled("clamp", PULL, "")), schemes=ALL)
JUMP = "[{ time = 0.001 }, { time = 0.001000001, translate = [0, 0, 1] }]"
add("pins_jump", "pins that jump by 1 m in 1 ns", scene(pulled("pin", JUMP)), schemes=ALL, explicit=OVERWHELMED, auto=NEITHER)
add("pins_jump_glue", "the same, of what never breaks", scene(pulled("pin", JUMP, "")), schemes=ALL, explicit=OVERWHELMED)
add("clamps_press", "clamps that press a plate through itself",
    scene(pulled("clamp", "[{ time = 0 }, { time = 0.002, translate = [-0.4, 0, 0] }]", "")), schemes=ALL, fails=UNSOLVED, explicit=OVERWHELMED, auto=NEITHER)

# Obstacles.
BALL = "[obstacle.ball]\nsphere = {{ radius = 0.03, centre = [0, 0, {}] }}\n"
THROUGH = "keys = [{ time = 0 }, { time = 0.002, translate = [0, 0, -1] }]\n"
add("ball_through_a_plate", "a ball that moves through a loose plate", scene(sheet(velocity=(0, 0, 0)), BALL.format(0.05), THROUGH),
    schemes=ALL, explicit=OVERWHELMED, auto=NEITHER, gained=0.02)
add("ball_through_a_clamped_plate", "a ball that moves through a clamped plate",
    scene(sheet(velocity=(0, 0, 0), more="clamp = { boundary = true }"), BALL.format(0.05), THROUGH), schemes=ALL, explicit=OVERWHELMED, auto=NEITHER, gained=0.02)
add("ball_through_glue", "the same, of what never breaks",
    scene(sheet(velocity=(0, 0, 0), fracture="", more="clamp = { boundary = true }"), BALL.format(0.05), THROUGH), schemes=("explicit",), explicit=OVERWHELMED)
add("ball_through_pins", "a ball that moves through a plate that is pinned everywhere",
    scene(sheet(velocity=(0, 0, 0), more="pin = { box = [[-1, -1, -1], [1, 1, 1]] }"), BALL.format(0.05), THROUGH), schemes=ALL, explicit=OVERWHELMED, fails=UNSOLVED, auto=NEITHER)
add("ball_in_a_plate", "a ball that starts in the middle of a plate", scene(sheet(), BALL.format(0.004)), schemes=ALL)
add("plate_in_a_floor", "a plate that starts 10 cm in the floor", scene(sheet(at=(0, 0, -0.1)), FLOOR), schemes=ALL)
add("ball_of_0", "a ball without size", scene(sheet(), "[obstacle.ball]\nsphere = { radius = 0 }\n"), refused=["radius", "positive"])
add("box_of_0", "a box without height", scene(sheet(), "[obstacle.box]\nbox = { size = [1, 1, 0] }\n"), refused=["size"])
add("ball_of_1_nm", "a ball of 1 nm", scene(sheet(), "[obstacle.ball]\nsphere = { radius = 1e-9 }\n"), schemes=ALL)
add("ball_of_1000_km", "a ball of 1,000 km", scene(sheet(), "[obstacle.ball]\nsphere = { radius = 1e6, centre = [0, 0, -1e6] }\n"),
    schemes=ALL, unexplained=1e-2)
add("floor_of_1e-6", "a floor of 1e-6 Pa", scene(sheet(), FLOOR, "young = 1e-6\n"), schemes=ALL)
add("floor_of_1e15", "a floor of 1e15 Pa", scene(sheet(), FLOOR, "young = 1e15\n"), schemes=ALL)
add("friction_1e6", "a coefficient of friction of 1e6", scene(sheet(velocity=(3, 0, -3)), FLOOR, "friction = 1e6\n"), schemes=ALL)
add("slope_without_friction", "a slope without friction",
    scene(sheet(at=(0, 0, 0.15)), "[obstacle.slope]\nplane = { normal = [1, 0, 1] }\n", duration=0.04), within=10, unexplained=1e-4)
add("sheet_friction_1e6", "friction of 1e6 between two plates",
    scene(sheet(velocity=(3, 0, -3), at=(0, 0, 0.02)), sheet(name="other", velocity=(0, 0, 0)), FLOOR, "[contact]\nfriction = 1e6\n"),
    schemes=ALL)
add("closing_floors", "two floors that close on a plate",
    scene(sheet(velocity=(0, 0, 0)), FLOOR, "[obstacle.lid]\nplane = { point = [0, 0, 0.05], normal = [0, 0, -1] }\n"
          "keys = [{ time = 0 }, { time = 0.002, translate = [0, 0, -0.06] }]\n"), schemes=ALL)
add("no_room", "two floors with no room between them",
    scene(sheet(velocity=(0, 0, 0)), FLOOR, "[obstacle.lid]\nplane = { point = [0, 0, -0.05], normal = [0, 0, -1] }\n"),
    schemes=ALL)
add("two_in_one_place", "two plates in the same place", scene(sheet(), sheet(name="other"), FLOOR), schemes=ALL)
add("two_in_one_place_error", "the same with contact.start = \"error\"",
    scene(sheet(), sheet(name="other"), FLOOR, "[contact]\nstart = \"error\"\n"), refused=["cross or touch"])
add("heavy_body", "a ball of 1e9 kg that falls on a plate",
    scene(sheet(velocity=(0, 0, 0)), FLOOR, BALL.format(0.05), "mass = 1e9\nvelocity = [0, 0, -3]\n", duration=0.01), schemes=ALL)
add("light_body", "a ball of 1e-12 kg that falls on a plate",
    scene(sheet(velocity=(0, 0, 0)), FLOOR, BALL.format(0.05), "mass = 1e-12\nvelocity = [0, 0, -3]\n", duration=0.01),
    schemes=("implicit", "auto"))
add("fast_body", "a ball of 0.1 kg at 10 km/s at a plate",
    scene(sheet(velocity=(0, 0, 0)), BALL.format(0.05), "mass = 0.1\nvelocity = [0, 0, -1e4]\n"), schemes=("explicit",),
    within=1e3, explicit=OVERWHELMED)

# A closed sphere, and statics.
add("burst", "a closed sphere under pressure until it bursts",
    scene(sheet('{ generate = "sphere", radius = 0.1, edge_length = 0.03 }', steel(thickness=0.001), velocity=(0, 0, 0),
                fracture="strength = 3e8"), "[[force.load]]\npressure = 2e7\nramp = 0.002\n", duration=2.5e-3), schemes=ALL,
    fragments=(2, 10000), long=True)
add("implode", "a closed sphere that is pressed flat",
    scene(sheet('{ generate = "sphere", radius = 0.1, edge_length = 0.03 }', steel(thickness=0.0005), velocity=(0, 0, 0),
                fracture=""), "[[force.load]]\npressure = -2e7\nramp = 0.002\n", duration=2.5e-3), schemes=ALL)
add("foil_in_the_wind", "a foil of 1 µm in wind of 100 km/s",
    scene(sheet(material=steel(thickness=1e-6), velocity=(0, 0, 0)), head="force.wind = { velocity = [0, 0, 1e5] }"), schemes=ALL,
    within=1e4, explicit=UNSTABLE)
add("too_far_away", "a plate a million million kilometres from the origin", scene(sheet(at=(1e15, 0, 0.004)), FLOOR),
    refused=["place", "m from the origin"])
add("thickness_1e-200", "a thickness of 1e-200 m", scene(sheet(material=steel(thickness=1e-200)), FLOOR),
    refused=["thickness", "1e-30"])
STATIC = 'scheme = "static"'
add("statics_loose", "statics of a plate that nothing holds", scene(sheet(velocity=(0, 0, 0))).replace("duration = 0.002", "")
    + "[solver]\n" + STATIC + "\n", refused=["nothing holds it"])
add("statics_1e12", "statics with a load of 1e12 Pa",
    scene(sheet(velocity=(0, 0, 0), fracture="", more="clamp = { boundary = true }"),
          "[[force.load]]\narea = [0, 0, -1e12]\n").replace("duration = 0.002", "") + "[solver]\n" + STATIC + "\n",
    within=1e6)
